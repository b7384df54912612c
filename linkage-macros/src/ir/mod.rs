//! The expression graph between the equations and the generated code.

pub(crate) mod graph;
pub(crate) mod program;
