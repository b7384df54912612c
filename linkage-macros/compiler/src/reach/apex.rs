//! A triangle by its three sides.

use super::squared;
use crate::exact::Exact;

/// The place at the distances a and b from the ends (0, 0) and (l, 0) of a side, above it; none where
/// the sides make no triangle: x = (a² − b² + l²)/2l, y = √(a² − x²).
pub(crate) fn apex([a, b]: [&Exact; 2], l: &Exact) -> Option<[Exact; 2]> {
    let sum = squared(a).sub(&squared(b)).add(&squared(l));
    let x = sum.div(&l.mul(&Exact::integer(2)))?;
    let y = squared(a).sub(&squared(&x)).sqrt()?;
    Some([x, y])
}
