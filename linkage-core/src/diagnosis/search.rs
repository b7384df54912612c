//! Diagnosis of the search for an unknown.

use super::Diagnosis;
use crate::error::ENDS_OF_BETWEEN;
use crate::limit::ROUNDINGS;
use crate::roots::FindError;
use crate::{Real, Scalar, SolveError};

/// Why an unknown has no root of its equation in this unit; where the equation is not a number, the
/// trial at which it is none.
#[cold]
pub(crate) fn no_root(
    error: FindError,
    unknown: &'static str,
    unit: &'static str,
) -> (SolveError, Option<f64>) {
    match error {
        FindError::Interval { from, to } => {
            let name = if to > from { ENDS_OF_BETWEEN } else { "width of between" };
            (SolveError::Invalid { group: unknown, name }, None)
        }
        FindError::NoSolution { by, other, .. } => {
            (SolveError::NoSolution { unknown, by, unit, other }, None)
        }
        FindError::SeveralDeadPoints => (SolveError::SeveralDeadPoints { unknown }, None),
        FindError::NotFinite { at } => (SolveError::NotFinite { name: unknown }, Some(at)),
        FindError::Singular { .. } => (SolveError::Singular { group: unknown }, None),
    }
}

/// The permitted difference between the sides of an equation of this size at a root: 64 √ε of the size.
/// A search ends where steps below 2⁻²² of its width no longer become shorter; 64 times that, for `f64`.
pub(crate) fn open_by<T: Scalar>(size: T) -> T {
    // √ε of either width: 2⁻²⁶ and, for 2⁻²³, 2⁻¹¹·⁵.
    T::lit(9.5367431640625e-7, 0.022_097_087) * size
}

/// Checks that an equation is closed in the final pose.
///
/// # Errors
/// `NoSolution` where it is not: its difference jumps from one sign to the other.
#[cold]
pub(crate) fn closed<T: Real>(
    difference: T,
    size: T,
    unknown: &'static str,
    unit: &'static str,
) -> Result<(), SolveError> {
    if !difference.value().is_finite() {
        return Err(SolveError::NotFinite { name: unknown });
    }
    if difference.is_within(open_by(size)) {
        return Ok(());
    }
    Err(SolveError::NoSolution { unknown, by: difference.value().abs(), unit, other: None })
}

/// The value is the slope of an equation by its unknown, and is the wanted way, or the pivot of an input in
/// the mass matrix, and is above zero; and not by rounding alone. Operand the spread; then the name.
///
/// # Errors
/// `Singular` where it is not, at a dead point; `NotFinite` where it is not a number.
#[derive(Clone, Copy, Debug)]
pub struct Moving<T>(pub [T; 1], pub &'static str);

impl<T: Scalar> Diagnosis<T> for Moving<T> {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self([spread], name) = self;
        let real = value.value();
        if real.is_nan() {
            Err(SolveError::NotFinite { name })
        } else if real > ROUNDINGS * T::EPSILON * spread.value() {
            Ok(value)
        } else {
            Err(SolveError::Singular { group: name })
        }
    }
}

/// The start of Newton's method is below the limit of its certificate: the value is by how much. The name is the group's.
///
/// # Errors
/// `NotCertified` where it is not; `NotFinite` where it is not a number.
#[derive(Clone, Copy, Debug)]
pub struct Certified(pub &'static str);

impl<T: Scalar> Diagnosis<T> for Certified {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self(group) = self;
        match value.value() {
            real if real.is_nan() => Err(SolveError::NotFinite { name: group }),
            real if real > 0.0 => Ok(value),
            _ => Err(SolveError::NotCertified { group }),
        }
    }
}
