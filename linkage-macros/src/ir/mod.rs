//! The expression graph between the equations and the generated code.

pub(crate) mod cost;
pub(crate) mod graph;
pub(crate) mod liveness;
pub(crate) mod program;
