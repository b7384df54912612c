//! Tests of `ir`.

pub(crate) mod cost;
pub(crate) mod hash;
pub(crate) mod implicit;
pub(crate) mod interpret;
pub(crate) mod text;

pub(crate) use linkage_compiler::ir::*;
