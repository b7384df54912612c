//! The conditions that formulas are under, and the two ways of asking for them.
//!
//! A group's formulas hold under conditions: circles of radii l₁ and l₂ must meet, a divisor must
//! not be zero, a length must be positive, an angle must be small enough for the quick reduction
//! of sines. Generated code contains the formulas once, as a function of a [`Checks`], which it calls
//! at every condition. There are two kinds, and a third for margins alone ([`Behind`]):
//!
//! - [`AllMet`], on the **fast path**, compares one number with a threshold and goes on, whatever
//!   comes of it. There is no branch, so that a loop over poses becomes one over vectors. In the
//!   end it says whether everything was met.
//! - [`FirstError`], on the **slow path**, compares nothing but looks at what a condition came from:
//!   the distance of the centres and the two radii rather than the number under the root. It
//!   replaces the value at a limit, keeps the first failure, and says in the end whose it was.
//!
//! # What they promise each other
//! If the fast path says yes, the result is the slow path's, and every number of it is finite. If it says no, nothing is lost: the slow path runs the same formulas again and
//! finds either the answer, at a limit or beyond the fast path's thresholds, or the reason why there
//! is none. So a threshold may be higher than the condition asks for, never lower.
//!
//! # Where thresholds come from
//! - Zero where only the sign matters: a divisor.
//! - Some ε of what a value was made of (`above_rounding`), where its sign is to be told from rounding:
//!   what stands under a root.
//! - [`Scalar::smallest_square`] for a squared length that something is divided by: below it the
//!   square has lost digits to underflow.
//! - More than that where it pays. The fast path has to know that no result is infinite or no
//!   number. It may ask the results, but these are there late; or the compiler shows, by intervals
//!   (`lower/overflow.rs` of `linkage-compiler`), that inputs below a limit and divisors above a
//!   threshold cannot make anything overflow, and then these are asked, which are there early.

mod all_met;
mod behind;

pub use all_met::AllMet;
pub use behind::Behind;
pub(crate) use behind::has_no_pose;

use crate::diagnosis::{self, Diagnosis};
use crate::friction::Amounts;
use crate::roots::FindError;
use crate::roots::seed::Seed;
use crate::{Real, Scalar, SolveError};

/// A checker of conditions, see the module's documentation. A condition is two calls: a comparison,
/// which [`FirstError`] passes by, and a diagnosis, which [`AllMet`] passes by and which returns the
/// value under the condition, or its replacement at a limit.
pub trait Checks<T: Scalar> {
    /// Sine and cosine of an angle.
    fn sin_cos(&mut self, angle: T) -> (T, T);

    /// The length of (`x`, `y`); by [`Scalar::hypot_near`] where nothing is diagnosed, if its square is at
    /// least `least`.
    #[inline(always)]
    fn hypot(&mut self, x: T, y: T, _least: T) -> T {
        x.hypot(y)
    }

    /// The seed that a sweep holds for the search of an unknown.
    #[inline(always)]
    fn seed(&mut self, _unknown: usize) -> Option<&mut Seed<T>> {
        None
    }

    /// The root of an unknown's equation, of sides in this unit, and the size that its rounding is
    /// measured by. Where none was found, what is returned leads to a refusal in the end.
    fn root(
        &mut self,
        found: Result<[T; 2], FindError>,
        unknown: &'static str,
        unit: &'static str,
    ) -> (T, T)
    where
        T: Real;

    /// Asks whether the difference of an equation's sides is none in the final pose: less than 64 √ε
    /// of what they are made of, which any root is by far and a jump of the difference is not.
    fn closed(&mut self, difference: T, size: T, unknown: &'static str, unit: &'static str)
    where
        T: Real;

    /// Receives each group's discriminant and its scale, where clearances are asked for.
    #[inline(always)]
    fn clearances(&mut self, _groups: &[[T; 2]]) {}

    /// Asks whether `value` > `least`.
    #[inline(always)]
    fn above(&mut self, _value: T, _least: T) {}

    /// Asks whether `value` ≥ `least`.
    #[inline(always)]
    fn at_least(&mut self, _value: T, _least: T) {}

    /// Asks whether |`value`| > `least`.
    #[inline(always)]
    fn away(&mut self, _value: T, _least: T) {}

    /// Asks whether `value` is above zero whatever rounding did to it, which is up to some
    /// units in the last place of `spread`.
    #[inline(always)]
    fn above_rounding(&mut self, _value: T, _spread: T) {}

    /// Checks a condition whose comparisons have been made. Returns the value under it, or its replacement
    /// at a limit.
    #[inline(always)]
    fn guard(&mut self, value: T, _diagnosis: impl Diagnosis<T>) -> T {
        value
    }

    /// Amounts of friction that depend on each other, by steps from these values; the values themselves
    /// where nothing asks for forces.
    #[inline(always)]
    fn amounts<const W: usize, const M: usize>(
        &mut self,
        start: [T; M],
        _amounts: Amounts<T, W, M>,
    ) -> [T; M] {
        start
    }

    /// The same where straight-line code has `found` them. Asks the `positive` numbers to be above zero, and the
    /// first of each `small` pair to be less than what rounding leaves of the second.
    #[inline(always)]
    fn straight_amounts<const W: usize, const M: usize, const P: usize, const N: usize>(
        &mut self,
        found: [T; M],
        _positive: [T; P],
        _small: [[T; 2]; N],
        _start: [T; M],
        _amounts: Amounts<T, W, M>,
    ) -> [T; M] {
        found
    }
}

/// The first condition that was not met. Values computed after it mean nothing.
#[derive(Clone, Copy, Debug)]
pub struct FirstError {
    first: Option<SolveError>,
    /// The error to report if no other condition fails.
    otherwise: Option<SolveError>,
}

impl FirstError {
    /// Nothing is wrong so far.
    #[expect(clippy::new_without_default, reason = "nobody but generated code makes one")]
    pub fn new() -> Self {
        Self { first: None, otherwise: None }
    }

    /// Returns the first error.
    ///
    /// # Errors
    /// The condition that was not met.
    #[inline(always)]
    pub fn first(self) -> Result<(), SolveError> {
        match (self.first, self.otherwise) {
            (Some(error), _) | (None, Some(error)) => Err(error),
            (None, None) => Ok(()),
        }
    }

    /// Diagnoses only where nothing was wrong so far.
    #[inline(always)]
    fn keep<T: Copy>(&mut self, value: T, diagnose: impl FnOnce() -> Result<T, SolveError>) -> T {
        if self.first.is_some() {
            return value;
        }
        match diagnose() {
            Ok(value) => value,
            Err(error) => {
                self.first = Some(error);
                value
            }
        }
    }
}

impl<T: Real> Checks<T> for FirstError {
    /// Where the equation was not a number the formulas go on with that trial, and find the group
    /// that cannot be assembled there.
    fn root(
        &mut self,
        found: Result<[T; 2], FindError>,
        unknown: &'static str,
        unit: &'static str,
    ) -> (T, T) {
        let error = match found {
            Ok([at, size]) => return (at, size),
            Err(error) => error,
        };
        let (refusal, at) = diagnosis::no_root(error, unknown, unit);
        let kept = if at.is_some() { &mut self.otherwise } else { &mut self.first };
        *kept = kept.or(Some(refusal));
        let at = at.unwrap_or(0.0);
        (T::lit(at, at as f32), T::lit(0.0, 0.0))
    }

    fn closed(&mut self, difference: T, size: T, unknown: &'static str, unit: &'static str) {
        if self.otherwise.is_none() {
            self.keep((), || diagnosis::closed(difference, size, unknown, unit));
        }
    }

    fn sin_cos(&mut self, angle: T) -> (T, T) {
        angle.sin_cos()
    }

    fn guard(&mut self, value: T, diagnosis: impl Diagnosis<T>) -> T {
        self.keep(value, || diagnosis.diagnose(value))
    }

    fn amounts<const W: usize, const M: usize>(
        &mut self,
        start: [T; M],
        amounts: Amounts<T, W, M>,
    ) -> [T; M] {
        self.keep(start, || amounts.diagnose(start))
    }

    fn straight_amounts<const W: usize, const M: usize, const P: usize, const N: usize>(
        &mut self,
        _: [T; M],
        _: [T; P],
        _: [[T; 2]; N],
        start: [T; M],
        amounts: Amounts<T, W, M>,
    ) -> [T; M] {
        self.amounts(start, amounts)
    }
}

#[cfg(test)]
mod tests;
