//! Tests of `model/drawn/drive_equations`.

pub(crate) mod motions;
