//! The conditions of formulas: the comparison behind each and the decision of the slow path.
//!
//! One type a condition, with the operands and the names that it is given. The slow path calls
//! [`Diagnosis::diagnose`] in the order of evaluation and stops at the first error. It looks at the
//! operands a condition came from rather than at the value that was computed from them, and at real parts
//! only, except where a derivative does not exist.

mod circles;
mod guides;
mod search;
mod size;
#[cfg(test)]
mod tests;

pub use circles::*;
pub use guides::*;
pub use search::*;
pub use size::*;

pub use crate::limit::ROUNDINGS;
use crate::limit::{Reach, Width};
use crate::{Mask, Real, Scalar, SolveError};

/// A condition of one value, with what the slow path looks at.
pub trait Diagnosis<T: Scalar>: Sized {
    /// The value under the condition, or its replacement at a limit.
    ///
    /// # Errors
    /// The reason why there is none.
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real;

    /// The fast path's answer behind the condition, all comparisons of which have been made.
    #[inline(always)]
    fn behind(self, met: T::Mask, _value: T) -> T::Mask {
        met.behind_condition()
    }
}

/// 16 √ε: how far below zero, as a share of its spread, what stands under a group's root shows for certain
/// that the group is out of reach. Rounding alone moves it by 16 ε, and so do the four last places that a
/// group may miss; but a pin behind another group's toggle is known to √ε of its bars.
const BEYOND: (f64, f32) = (1.0 / (1_u32 << 22) as f64, 1.0 / (1_u32 << 7) as f32);

/// The answer behind a group that is out of reach for certain where `value` is far below zero as measured by
/// `scale`. A value and operands that are not finite are another refusal, and so may be what is made of them.
#[inline(always)]
fn behind_reach<T: Scalar>(met: T::Mask, value: T, scale: T, operands: &[T]) -> T::Mask {
    met.behind_reach(|| {
        let sum = operands.iter().copied().fold(value, |sum, next| sum + next);
        (T::lit(-BEYOND.0, -BEYOND.1) * scale).gt(value) & sum.is_finite()
    })
}

/// True if the value is above zero even with the largest rounding error.
#[inline(always)]
fn is_certain<T: Real>(value: T, spread: T) -> bool {
    let value = value.value();
    value.is_finite() && value > ROUNDINGS * T::EPSILON * spread.value()
}

/// The value that goes with the answer, or the error.
#[cold]
#[inline(never)]
fn reached<T: Real>(
    value: T,
    operands: &[T],
    reach: Reach,
    group: &'static str,
) -> Result<T, SolveError> {
    let real = value.value();
    match reach {
        Reach::Meets if !real.is_finite() => Err(SolveError::NotFinite { name: group }),
        Reach::Meets if real > 0.0 => Ok(value),
        // Zero, or below it by rounding: on the line of centres, where the square root of the
        // value has no derivative. That the value's own derivative is zero there does not help: a
        // motion that touches the limit has a value like −x² or x², and a root like |x|.
        Reach::Meets | Reach::AtLimit
            if value.is_constant() && operands.iter().all(|operand| operand.is_constant()) =>
        {
            Ok(T::lit(0.0, 0.0))
        }
        Reach::Meets | Reach::AtLimit | Reach::Coincident => Err(SolveError::Singular { group }),
        Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
        Reach::NotFinite => Err(SolveError::NotFinite { name: group }),
    }
}

/// The value with its derivatives, and with the exact real part. The first sum cancels the rounded
/// real part.
fn restored<T: Real>(value: T, exact: f64) -> T {
    let rounded = value.value();
    value + T::lit(-rounded, -rounded as f32) + T::lit(exact, exact as f32)
}

/// The smallest number of full precision.
fn smallest_normal<T: Real>() -> f64 {
    T::smallest_square().value() * T::EPSILON * T::EPSILON
}

fn width<T: Real>() -> Width {
    // smallest_square is MIN_POSITIVE/ε², and the smallest number above zero MIN_POSITIVE·ε.
    Width { epsilon: T::EPSILON, smallest: smallest_normal::<T>() * T::EPSILON }
}
