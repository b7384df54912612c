//! What the careful path decides where the straight line could not: once per failing guard, in
//! order, with the group to blame.

use crate::{Real, SolveError};

/// `NotFinite` with the input's name unless the input is finite.
#[cold]
pub fn finite_input<T: Real>(value: T, name: &'static str) -> Result<(), SolveError> {
    if value.is_finite() { Ok(()) } else { Err(SolveError::NotFinite { name }) }
}

/// `NotFinite` with the result's name unless the result is finite.
#[cold]
pub fn finite_result<T: Real>(value: T, name: &'static str) -> Result<(), SolveError> {
    if value.is_finite() { Ok(()) } else { Err(SolveError::NotFinite { name }) }
}

/// The value, provided that circles of radii `l1` and `l2` about points (`dx`, `dy`) apart meet.
#[cold]
pub fn reach_circles<T: Real>(
    value: T,
    dx: T,
    dy: T,
    l1: T,
    l2: T,
    group: &'static str,
) -> Result<T, SolveError> {
    let d = dx.hypot(dy).value();
    let (l1, l2) = (l1.value(), l2.value());
    let by = (d - (l1 + l2)).max((l1 - l2).abs() - d);
    at_limit::<T>(value, by, d.max(l1).max(l2), group)
}

/// The value, provided that |`t`| ≤ `l`.
#[cold]
pub fn reach_line<T: Real>(value: T, t: T, l: T, group: &'static str) -> Result<T, SolveError> {
    let (t, l) = (t.value().abs(), l.value());
    at_limit::<T>(value, t - l, t.max(l), group)
}

/// The value, provided that |`e`| ≤ |(`bx`, `by`)|.
#[cold]
pub fn reach_offset<T: Real>(
    value: T,
    bx: T,
    by: T,
    e: T,
    group: &'static str,
) -> Result<T, SolveError> {
    let (l, e) = (bx.hypot(by).value(), e.value().abs());
    at_limit::<T>(value, e - l, e.max(l), group)
}

/// `Singular` where the value is zero.
#[cold]
pub fn nonzero<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    match value.value() {
        0.0 => Err(SolveError::Singular { group }),
        v if v.is_nan() => Err(SolveError::NotFinite { name: group }),
        _ => Ok(value),
    }
}

/// `Invalid` with the length's name where it is zero or negative.
#[cold]
pub fn positive<T: Real>(
    value: T,
    group: &'static str,
    name: &'static str,
) -> Result<T, SolveError> {
    match value.value() {
        v if v.is_nan() => Err(SolveError::NotFinite { name }),
        v if v > 0.0 => Ok(value),
        _ => Err(SolveError::Invalid { group, name }),
    }
}

/// A squared length that something is divided by: `Singular` where it is the square of zero,
/// `NotFinite` where it has left the range in which a square carries full precision.
#[cold]
pub fn square<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    if value.value() == 0.0 {
        Err(SolveError::Singular { group })
    } else if value.value() >= T::smallest_square().value() && value.value().is_finite() {
        Ok(value)
    } else {
        Err(SolveError::NotFinite { name: group })
    }
}

fn at_limit<T: Real>(
    value: T,
    by: f64,
    longest: f64,
    group: &'static str,
) -> Result<T, SolveError> {
    if by > 4.0 * T::EPSILON * longest {
        Err(SolveError::OutOfReach { group, by })
    } else if value.value() > 0.0 {
        Ok(value)
    } else if value.is_constant() {
        Ok(T::lit(0.0, 0.0))
    } else {
        Err(SolveError::Singular { group })
    }
}
