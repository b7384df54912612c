//! Facts that constant dimensions fix before anything is solved: the place of a point, the reach of a
//! group, the range of a crank's turn. All of them are exact.
//!
//! The rules of the model ask here and put the answers into words.

pub(crate) mod apex;
pub(crate) mod line;
pub mod turn;

use crate::exact::Exact;

/// |a|
pub(crate) fn absolute(value: &Exact) -> Exact {
    if value.signum().is_lt() { value.neg() } else { value.clone() }
}

fn squared(value: &Exact) -> Exact {
    value.mul(value)
}
