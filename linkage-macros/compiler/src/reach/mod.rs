//! What constant dimensions say before anything is solved: where a point lies, what reaches, over
//! which angles a crank turns. All of it is exact.
//!
//! The rules of the model ask here and put the answers into words.

pub(crate) mod line;
pub(crate) mod triangle;
pub(crate) mod turn;

use crate::exact::Exact;

/// |a|
pub(crate) fn absolute(value: &Exact) -> Exact {
    if value.signum().is_lt() { value.neg() } else { value.clone() }
}

fn squared(value: &Exact) -> Exact {
    value.mul(value)
}
