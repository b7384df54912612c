//! Tests of `codegen/docs`.

pub(crate) mod costs_in_words;
pub(crate) mod doc_comments;

pub(crate) use linkage_compiler::codegen::docs::*;
