//! Tests of `codegen/c`.

pub(crate) mod c_identifiers;
pub(crate) mod provenance;

pub(crate) use linkage_compiler::codegen::c::*;
