//! The structure of both crates: how many files tell of one fact, which modules use which, and that a
//! name means one thing. What stands in comments and tests does not count.

mod comments;
mod imports;
mod names;
mod sources;
mod spread;
