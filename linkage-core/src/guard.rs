//! What a solver's formulas do at a condition and at an angle.
//!
//! Generated formulas are written once and read in two ways: [`Marks`] goes on regardless and says
//! in the end whether the result may be used, without a branch; [`Findings`] looks at every
//! condition's operands and keeps the first that is not met.

use crate::careful;
use crate::{Mask, Real, Scalar, SolveError};

/// See the module's documentation. A condition is two calls: one that marks, which findings pass
/// by, and one that looks, which marks pass by and which returns what is guarded, or what stands
/// for it at a limit.
pub trait Guard<T: Scalar> {
    /// Sine and cosine of an angle.
    fn sin_cos(&mut self, angle: T) -> (T, T);

    /// Marks whether `value` > `least`.
    #[inline(always)]
    fn above(&mut self, _value: T, _least: T) {}

    /// Marks whether `value` ≥ `least`.
    #[inline(always)]
    fn at_least(&mut self, _value: T, _least: T) {}

    /// Marks whether |`value`| > `least`.
    #[inline(always)]
    fn away(&mut self, _value: T, _least: T) {}

    /// Marks whether `value` is above zero whatever rounding did to it, which is up to some
    /// units in the last place of `spread`.
    #[inline(always)]
    fn above_rounding(&mut self, _value: T, _spread: T) {}

    /// See `careful::reach_circles`.
    #[inline(always)]
    fn reach_circles(&mut self, value: T, _operands: [T; 5], _: &'static str) -> T {
        value
    }

    /// See `careful::share_of_centres`.
    #[inline(always)]
    fn share_of_centres(&mut self, value: T, _operands: [T; 6], _: &'static str) -> T {
        value
    }

    /// See `careful::reach_distances`.
    #[inline(always)]
    fn reach_distances(&mut self, value: T, _operands: [T; 4], _: &'static str) -> T {
        value
    }

    /// See `careful::reach_line`.
    #[inline(always)]
    fn reach_line(&mut self, value: T, _: T, _: T, _: &'static str) -> T {
        value
    }

    /// See `careful::reach_offset`.
    #[inline(always)]
    fn reach_offset(&mut self, value: T, _: T, _: T, _: T, _: &'static str) -> T {
        value
    }

    /// See `careful::nonzero`.
    #[inline(always)]
    fn nonzero(&mut self, value: T, _: &'static str) -> T {
        value
    }

    /// See `careful::positive`.
    #[inline(always)]
    fn positive(&mut self, value: T, _: &'static str, _: &'static str) -> T {
        value
    }

    /// See `careful::not_negative`.
    #[inline(always)]
    fn not_negative(&mut self, value: T, _: &'static str, _: &'static str) -> T {
        value
    }

    /// See `careful::square`.
    #[inline(always)]
    fn square(&mut self, value: T, _: &'static str) -> T {
        value
    }

    /// See `careful::square_of_centres`.
    #[inline(always)]
    fn square_of_centres(&mut self, value: T, _: T, _: T, _: T, _: T, _: &'static str) -> T {
        value
    }
}

/// Whether every condition was met. Every value goes on as it is.
///
/// Inlined always, so that lanes stay on the instruction set of the loop they run in.
#[derive(Clone, Copy, Debug)]
pub struct Marks<M>(M);

impl<M: Mask> Marks<M> {
    /// Nothing is wrong so far.
    #[expect(clippy::new_without_default, reason = "nobody but generated code makes one")]
    #[inline(always)]
    pub fn new() -> Self {
        Self(M::ALL)
    }

    /// The answer of all conditions together.
    #[inline(always)]
    pub fn all(self) -> M {
        self.0
    }

    #[inline(always)]
    fn and(&mut self, met: M) {
        self.0 = self.0 & met;
    }
}

impl<T: Scalar> Guard<T> for Marks<T::Mask> {
    #[inline(always)]
    fn sin_cos(&mut self, angle: T) -> (T, T) {
        self.and(angle.is_near());
        angle.sin_cos_near()
    }

    #[inline(always)]
    fn above(&mut self, value: T, least: T) {
        self.and(value.gt(least));
    }

    #[inline(always)]
    fn at_least(&mut self, value: T, least: T) {
        self.and(value.ge(least));
    }

    #[inline(always)]
    fn above_rounding(&mut self, value: T, spread: T) {
        const WIDE: f64 = careful::ROUNDINGS * f64::EPSILON;
        const NARROW: f32 = careful::ROUNDINGS as f32 * f32::EPSILON;
        self.and(value.gt(T::lit(WIDE, NARROW) * spread));
    }

    /// The magnitude, compared: neither a square, which underflows, nor a disjunction, which
    /// masks do not have.
    #[inline(always)]
    fn away(&mut self, value: T, least: T) {
        let magnitude = T::select(value.ge(T::lit(0.0, 0.0)), value, -value);
        self.and(magnitude.gt(least));
    }
}

/// The first condition that was not met. What follows it is computed and means nothing.
#[derive(Clone, Copy, Debug)]
pub struct Findings {
    first: Option<SolveError>,
}

impl Findings {
    /// Nothing is wrong so far.
    #[expect(clippy::new_without_default, reason = "nobody but generated code makes one")]
    pub fn new() -> Self {
        Self { first: None }
    }

    /// What was wrong first.
    ///
    /// # Errors
    /// The condition that was not met.
    pub fn first(self) -> Result<(), SolveError> {
        self.first.map_or(Ok(()), Err)
    }

    /// Looks only where nothing was wrong so far.
    fn keep<T: Copy>(&mut self, value: T, look: impl FnOnce() -> Result<T, SolveError>) -> T {
        if self.first.is_some() {
            return value;
        }
        match look() {
            Ok(value) => value,
            Err(error) => {
                self.first = Some(error);
                value
            }
        }
    }
}

impl<T: Real> Guard<T> for Findings {
    fn sin_cos(&mut self, angle: T) -> (T, T) {
        angle.sin_cos()
    }

    fn reach_circles(&mut self, value: T, operands: [T; 5], group: &'static str) -> T {
        self.keep(value, || careful::reach_circles(value, operands, group))
    }

    fn share_of_centres(&mut self, value: T, operands: [T; 6], _: &'static str) -> T {
        self.keep(value, || Ok(careful::share_of_centres(value, operands)))
    }

    fn reach_distances(&mut self, value: T, operands: [T; 4], group: &'static str) -> T {
        self.keep(value, || careful::reach_distances(value, operands, group))
    }

    fn reach_line(&mut self, value: T, t: T, l: T, group: &'static str) -> T {
        self.keep(value, || careful::reach_line(value, t, l, group))
    }

    fn reach_offset(&mut self, value: T, bx: T, by: T, e: T, group: &'static str) -> T {
        self.keep(value, || careful::reach_offset(value, bx, by, e, group))
    }

    fn nonzero(&mut self, value: T, group: &'static str) -> T {
        self.keep(value, || careful::nonzero(value, group))
    }

    fn positive(&mut self, value: T, group: &'static str, name: &'static str) -> T {
        self.keep(value, || careful::positive(value, group, name))
    }

    fn not_negative(&mut self, value: T, group: &'static str, name: &'static str) -> T {
        self.keep(value, || careful::not_negative(value, group, name))
    }

    fn square(&mut self, value: T, group: &'static str) -> T {
        self.keep(value, || careful::square(value, group))
    }

    fn square_of_centres(
        &mut self,
        value: T,
        dx: T,
        dy: T,
        l1: T,
        l2: T,
        group: &'static str,
    ) -> T {
        self.keep(value, || careful::square_of_centres(value, dx, dy, l1, l2, group))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_finding_is_kept() {
        let mut findings = Findings::new();
        assert_eq!(findings.nonzero(2.0, "a"), 2.0);
        assert_eq!(findings.first(), Ok(()));
        findings.nonzero(0.0, "b");
        findings.positive(-1.0, "c", "length");
        assert_eq!(findings.first(), Err(SolveError::Singular { group: "b" }));
    }

    #[test]
    fn marks_hold_only_where_every_condition_does() {
        let marked = |mark: fn(&mut Marks<bool>)| {
            let mut marks = Marks::new();
            mark(&mut marks);
            marks.away(1.0, 0.0);
            marks.all()
        };
        assert!(marked(|m| m.at_least(0.0, 0.0)));
        assert!(!marked(|m| m.at_least(-1e-300, 0.0)));
        assert!(!marked(|m| m.at_least(1e-320, f64::smallest_square())));
        assert!(!marked(|m| m.above(0.0, 0.0)));
        assert!(marked(|m| m.above(2.0, 1.0)) && !marked(|m| m.above(1.0, 1.0)));
        assert!(marked(|m| m.above_rounding(1e-13, 1.0)));
        assert!(!marked(|m| m.above_rounding(1e-13, 1000.0)));
        assert!(marked(|m| m.away(-1e-300, 0.0)));
        assert!(!marked(|m| m.away(0.0, 0.0)));
        assert!(marked(|m| m.away(-2.0, 1.0)) && !marked(|m| m.away(-1.0, 1.0)));
        assert!(!marked(|m| _ = m.sin_cos(1e9)));
        assert!(!marked(|m| m.above(f64::NAN, 0.0)));
        assert!(!marked(|m| m.at_least(f64::NAN, 0.0)));
        assert!(!marked(|m| m.away(f64::NAN, 0.0)));
    }

    #[test]
    fn marks_do_not_look_and_findings_do_not_mark() {
        let mut marks = Marks::<bool>::new();
        assert_eq!(marks.nonzero(0.0, "a"), 0.0);
        assert!(marks.all());
        let mut findings = Findings::new();
        findings.above(-1.0, 0.0);
        assert_eq!(findings.first(), Ok(()));
    }
}
