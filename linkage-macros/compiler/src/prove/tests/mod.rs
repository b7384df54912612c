//! The room's tests: node by node, and whole programs against what `f32` and `f64` compute of them.

mod beside_hands;
mod computed;
mod functions;
mod machines;
mod nodes;
mod small_formats;
mod whole;
