//! The measured code and the measurements, for programs and benches alike.

pub mod generated;
pub mod hand;
pub mod near_limits;
pub mod number;
pub mod race;
