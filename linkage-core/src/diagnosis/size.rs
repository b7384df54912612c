//! Conditions on the size of one number: finite, positive, large enough to be divided by.

use crate::{Real, SolveError};

/// Whether an input, or a parameter, is finite.
///
/// # Errors
/// `NotFinite` with its name.
#[cold]
pub(crate) fn finite_input<T: Real>(value: T, name: &'static str) -> Result<(), SolveError> {
    if value.is_finite() { Ok(()) } else { Err(SolveError::NotFinite { name }) }
}

/// Whether a result is finite, `given` being what it was made from.
///
/// # Errors
/// `Singular` where only a derivative that it carries is not finite. Else `NotFinite`: with the
/// name of the largest of the given numbers whose fourth power leaves the number's range, as a
/// rate that is squared on the way does, or with the result's own name where there is none.
#[cold]
pub(crate) fn finite_result<T: Real>(
    value: T,
    name: &'static str,
    given: &[(T, &'static str)],
) -> Result<(), SolveError> {
    if value.is_finite() {
        return Ok(());
    }
    if value.value().is_finite() {
        return Err(SolveError::Singular { group: name });
    }
    let mut blamed = (0.0, name);
    for &(number, name) in given {
        let square = number * number;
        let size = number.value().max(-number.value());
        if !(square * square).value().is_finite() && size > blamed.0 {
            blamed = (size, name);
        }
    }
    Err(SolveError::NotFinite { name: blamed.1 })
}

/// The value, provided that it is not zero.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` where it is not a number.
#[cold]
pub(crate) fn nonzero<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    let real = value.value();
    if real.is_nan() {
        Err(SolveError::NotFinite { name: group })
    } else if real == 0.0 {
        Err(SolveError::Singular { group })
    } else {
        Ok(value)
    }
}

/// The value, a length, provided that it is greater than zero.
///
/// # Errors
/// `Invalid` with its name where it is not, `NotFinite` with its name where it is not a number.
#[cold]
pub(crate) fn positive<T: Real>(
    value: T,
    group: &'static str,
    name: &'static str,
) -> Result<T, SolveError> {
    valid(value, group, name, |size| size > 0.0)
}

/// The value, a mass or an inertia, provided that it is not negative.
///
/// # Errors
/// `Invalid` with its name where it is, `NotFinite` with its name where it is not a number.
#[cold]
pub(crate) fn not_negative<T: Real>(
    value: T,
    group: &'static str,
    name: &'static str,
) -> Result<T, SolveError> {
    valid(value, group, name, |size| size >= 0.0)
}

fn valid<T: Real>(
    value: T,
    group: &'static str,
    name: &'static str,
    is_valid: impl Fn(f64) -> bool,
) -> Result<T, SolveError> {
    match value.value() {
        nan if nan.is_nan() => Err(SolveError::NotFinite { name }),
        size if is_valid(size) => Ok(value),
        _ => Err(SolveError::Invalid { group, name }),
    }
}

/// The value, a squared length that something is divided by, provided that it is in the range in
/// which a square carries full precision.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` with the group's name where it is below
/// [`Scalar::smallest_square`](crate::Scalar::smallest_square), infinite or not a number.
#[cold]
pub(crate) fn square<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    let real = value.value();
    if real == 0.0 {
        Err(SolveError::Singular { group })
    } else if real.is_finite() && real >= T::smallest_square().value() {
        Ok(value)
    } else {
        Err(SolveError::NotFinite { name: group })
    }
}
