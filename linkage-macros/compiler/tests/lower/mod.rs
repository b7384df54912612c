//! Tests of `lower`.

pub(crate) mod input_limits;
pub(crate) mod locals;
pub(crate) mod nesting;
pub(crate) mod overflow;
pub(crate) mod ranges;
pub(crate) mod schedule;
pub(crate) mod unique_root;
pub(crate) mod witnesses;

pub(crate) use linkage_compiler::lower::*;
