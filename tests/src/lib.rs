//! The parts that tests of whole mechanisms share: declarations, tables of truth, random numbers that are the
//! same in every run, and arithmetic to compare with.
//!
//! A declaration is expanded once, here, and used by as many tests as like it.
#![allow(missing_docs, reason = "the declarations' fields are named in their statements")]

pub mod accuracy;
pub mod conditioning;
pub mod double_double;
pub mod hard_table;
pub mod integration;
pub mod measured;
pub mod mechanisms;
pub mod random;
pub mod rigid_motion;
pub mod tables;
pub mod widths;
