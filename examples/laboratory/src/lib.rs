//! What is measured, for programs and benches alike.

pub mod generated;
pub mod hand;
pub mod near_limits;
