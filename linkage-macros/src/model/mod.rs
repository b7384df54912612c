//! Names into typed ids, dimensions, and one function per rule.

pub(crate) mod mechanism;
