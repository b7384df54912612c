//! Every pass: what it rewrites, what it leaves alone, and that it changes no meaning.

pub(crate) mod affine;
pub(crate) mod budgets;
pub(crate) mod chain;
pub(crate) mod collect;
pub(crate) mod conditions;
pub(crate) mod dynamics;
pub(crate) mod growth;
pub(crate) mod meaning;
pub(crate) mod rules;

pub(crate) use linkage_compiler::passes::*;
