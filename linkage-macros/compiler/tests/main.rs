//! Tests of the compiler, room by room. A module has what the room of its name has, and tests it: what stands in
//! `passes/collect.rs` here is about `passes/collect.rs` of the compiler. Beside the rooms, `oracle` computes in a hundred
//! digits, `expansions` compares what every declaration of the workspace expands to, `mistakes` mends what a newcomer writes,
//! `drawings` are machines drawn by hand and by chance, and `fuzz` is everything else that might be written.

mod brackets;
#[path = "../../../linkage-core/src/cases.rs"]
mod cases;
mod chain;
mod codegen;
mod diagnostics;
mod drawings;
mod equations;
mod exact;
mod expansions;
mod function;
mod fuzz;
mod interface;
mod ir;
mod lower;
mod mistakes;
mod model;
mod oracle;
mod passes;
mod pipeline;
mod prove;
mod reach;
mod report;
mod syntax;

pub(crate) use linkage_compiler::*;
