//! Tests of `codegen/st`.

pub(crate) mod st_names;
