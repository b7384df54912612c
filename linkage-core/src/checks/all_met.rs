//! Conditions as the fast path asks for them: comparisons alone.

use super::Checks;
use crate::diagnosis::{self, Diagnosis};
use crate::friction::{self, Amounts};
use crate::limit::ROUNDINGS;
use crate::roots::FindError;
use crate::roots::seed::Seed;
use crate::{Mask, Real, Scalar};

/// A mask that is true where every condition is met. Values pass unchanged.
///
/// Inlined always, so that lanes stay on the instruction set of the loop they run in.
#[derive(Clone, Copy, Debug)]
pub struct AllMet<M, S = ()>(M, S);

impl<M: Mask> AllMet<M> {
    /// Nothing is wrong so far.
    #[expect(clippy::new_without_default, reason = "nobody but generated code makes one")]
    #[inline(always)]
    pub fn new() -> Self {
        Self(M::ALL, ())
    }
}

impl<'a, T: Scalar> AllMet<T::Mask, &'a mut [Seed<T>]> {
    /// The same in a sweep, whose searches begin by the seeds of their unknowns.
    #[inline(always)]
    pub fn following(seeds: &'a mut [Seed<T>]) -> Self {
        Self(Mask::ALL, seeds)
    }
}

/// The seeds that checks hold for searches: none, or one for each unknown.
pub trait Seeds<T> {
    /// That of an unknown.
    fn of(&mut self, unknown: usize) -> Option<&mut Seed<T>>;
}

impl<T> Seeds<T> for () {
    #[inline(always)]
    fn of(&mut self, _: usize) -> Option<&mut Seed<T>> {
        None
    }
}

impl<T> Seeds<T> for &mut [Seed<T>] {
    #[inline(always)]
    fn of(&mut self, unknown: usize) -> Option<&mut Seed<T>> {
        self.get_mut(unknown)
    }
}

impl<M: Mask, S> AllMet<M, S> {
    /// The answer of all conditions together.
    #[inline(always)]
    pub fn all(self) -> M {
        self.0
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn and(&mut self, met: M) {
        self.0 = self.0.and_condition(met);
    }

    /// Behind a condition that is compared alone.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn behind(&mut self) {
        self.0 = self.0.behind_condition();
    }
}

impl<T: Scalar, S: Seeds<T>> Checks<T> for AllMet<T::Mask, S> {
    #[inline(always)]
    fn seed(&mut self, unknown: usize) -> Option<&mut Seed<T>> {
        self.1.of(unknown)
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(&mut self, found: Result<[T; 2], FindError>, _: &'static str, _: &'static str) -> (T, T)
    where
        T: Real,
    {
        match found {
            Ok([at, size]) => (at, size),
            Err(_) => {
                let zero = T::lit(0.0, 0.0);
                self.and(zero.gt(zero));
                self.behind();
                (zero, zero)
            }
        }
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn closed(&mut self, difference: T, size: T, _: &'static str, _: &'static str)
    where
        T: Real,
    {
        self.and(difference.is_within(diagnosis::open_by(size)));
        self.behind();
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos(&mut self, angle: T) -> (T, T) {
        self.and(angle.is_near());
        self.behind();
        angle.sin_cos_near()
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn hypot(&mut self, x: T, y: T, least: T) -> T {
        let (length, is_near) = x.hypot_near(y, least);
        self.and(is_near);
        self.behind();
        length
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn above(&mut self, value: T, least: T) {
        self.and(value.gt(least));
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at_least(&mut self, value: T, least: T) {
        self.and(value.ge(least));
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn above_rounding(&mut self, value: T, spread: T) {
        const WIDE: f64 = ROUNDINGS * f64::EPSILON;
        const NARROW: f32 = ROUNDINGS as f32 * f32::EPSILON;
        self.and(value.gt(T::lit(WIDE, NARROW) * spread));
    }

    /// The magnitude, compared: neither a square, which underflows, nor a disjunction, which
    /// masks do not have.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn away(&mut self, value: T, least: T) {
        let magnitude = T::select(value.ge(T::lit(0.0, 0.0)), value, -value);
        self.and(magnitude.gt(least));
    }

    #[inline(always)]
    fn guard(&mut self, value: T, diagnosis: impl Diagnosis<T>) -> T {
        self.0 = diagnosis.behind(self.0, value);
        value
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn amounts<const W: usize, const M: usize>(
        &mut self,
        start: [T; M],
        amounts: Amounts<T, W, M>,
    ) -> [T; M] {
        let (found, met) = amounts.system.stepped(start);
        self.0 = self.0.and_condition(met).behind_condition();
        found
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn straight_amounts<const W: usize, const M: usize, const P: usize, const N: usize>(
        &mut self,
        found: [T; M],
        positive: [T; P],
        small: [[T; 2]; N],
        _: [T; M],
        _: Amounts<T, W, M>,
    ) -> [T; M] {
        let mut met = T::Mask::ALL;
        // By reference: an array's own iterator leaves a loop, and the loop over poses around it is none over vectors.
        for &value in &positive {
            met = met & value.gt(T::lit(0.0, 0.0));
        }
        for &[less, more] in &small {
            met = met & friction::rounding(more).gt(less);
        }
        self.0 = self.0.and_condition(met).behind_condition();
        found
    }
}
