//! What a user of a generated solver types and reads.

mod generated;
mod messages;
mod records;
