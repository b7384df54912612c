//! Tests of `codegen/c`.

pub(crate) use linkage_compiler::codegen::c::*;
pub(crate) mod c_identifiers;
pub(crate) mod provenance;
