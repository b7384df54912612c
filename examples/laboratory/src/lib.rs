//! The mechanisms that are measured, for programs and benches alike.

pub mod generated;
