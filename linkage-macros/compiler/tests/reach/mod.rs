//! Tests of `reach`.

pub(crate) mod turn;
