//! Conditions on the size of one number: finite, positive, large enough to be divided by.

use super::Diagnosis;
use crate::{Real, Scalar, SolveError};

/// Checks that an input or a parameter is finite.
///
/// # Errors
/// `NotFinite` with its name.
#[cold]
pub(crate) fn finite_input<T: Real>(value: T, name: &'static str) -> Result<(), SolveError> {
    if value.is_finite() { Ok(()) } else { Err(SolveError::NotFinite { name }) }
}

/// Checks that a result is finite, `given` being the numbers it was computed from.
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

/// The value is not zero. With the group.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` where it is not a number.
#[derive(Clone, Copy, Debug)]
pub struct Nonzero(pub &'static str);

impl<T: Scalar> Diagnosis<T> for Nonzero {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let real = value.value();
        if real.is_nan() {
            Err(SolveError::NotFinite { name: self.0 })
        } else if real == 0.0 {
            Err(SolveError::Singular { group: self.0 })
        } else {
            Ok(value)
        }
    }
}

/// The value, a length, is greater than zero. With the group and the length's name.
///
/// # Errors
/// `Invalid` with its name where it is not, `NotFinite` with its name where it is not a number.
#[derive(Clone, Copy, Debug)]
pub struct Positive(pub &'static str, pub &'static str);

impl<T: Scalar> Diagnosis<T> for Positive {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        valid(value, self.0, self.1, |size| size > 0.0)
    }
}

/// The value, a mass or an inertia, is not negative. With the group and the value's name.
///
/// # Errors
/// `Invalid` with its name where it is, `NotFinite` with its name where it is not a number.
#[derive(Clone, Copy, Debug)]
pub struct NotNegative(pub &'static str, pub &'static str);

impl<T: Scalar> Diagnosis<T> for NotNegative {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        valid(value, self.0, self.1, |size| size >= 0.0)
    }
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

/// The value, a squared length that something is divided by, is in the range in which a square carries full
/// precision. With the group.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` with the group's name where it is below
/// [`Scalar::smallest_square`], infinite or not a number.
#[derive(Clone, Copy, Debug)]
pub struct Square(pub &'static str);

impl<T: Scalar> Diagnosis<T> for Square {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        if is_full_square(value) {
            Ok(value)
        } else if value.value() == 0.0 {
            Err(SolveError::Singular { group: self.0 })
        } else {
            Err(SolveError::NotFinite { name: self.0 })
        }
    }
}

/// True for a square in the range in which squares carry full precision.
#[inline(always)]
pub(super) fn is_full_square<T: Real>(value: T) -> bool {
    let real = value.value();
    real.is_finite() && real >= T::smallest_square().value()
}
