//! Tests of the compiler, room by room.

pub(crate) use linkage_compiler::*;

mod brackets;
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
