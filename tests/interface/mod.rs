//! The generated interface as a user types and reads it.

mod generated;
mod messages;
mod pages;
mod parameters;
mod records;
