//! The room's tests: node by node, and whole programs against what `f32` and `f64` compute of them.

pub(crate) mod beside_hands;
pub(crate) mod computed;
pub(crate) mod functions;
pub(crate) mod machines;
pub(crate) mod nodes;
pub(crate) mod small_formats;
pub(crate) mod whole;

pub(crate) use linkage_compiler::prove::*;
