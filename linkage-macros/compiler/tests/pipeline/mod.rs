//! Tests of `pipeline`.

pub(crate) mod assembly_export;
pub(crate) mod several_sets;

pub(crate) use linkage_compiler::pipeline::*;
