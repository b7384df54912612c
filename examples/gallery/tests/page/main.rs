//! The pages on which machines are dragged: their numbers against the solvers', and what a browser makes of
//! them.

mod access;
mod before;
mod browser;
#[path = "../../../../linkage-core/src/cases.rs"]
mod cases;
#[path = "../chromium/mod.rs"]
mod chromium;
mod contents;
mod hard;
mod machines;
mod marks;
#[macro_use]
mod numbers;
mod parallelograms;
mod program;
mod right;
mod sets;
mod shown;
