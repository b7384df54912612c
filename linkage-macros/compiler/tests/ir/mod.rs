//! Tests of `ir`.

pub(crate) use linkage_compiler::ir::*;
pub(crate) mod cost;
pub(crate) mod hash;
pub(crate) mod implicit;
pub(crate) mod interpret;
pub(crate) mod text;
