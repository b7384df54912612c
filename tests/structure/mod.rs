//! The structure of both crates: how many files tell of one fact, which modules use which, that a
//! name means one thing, and that no file or function is long. What stands in comments and tests does not count.

mod comments;
mod impls;
mod imports;
mod lengths;
mod names;
mod sources;
mod spread;
