//! Tokens and spans into a tree; nothing is resolved here.

pub(crate) mod tree;
