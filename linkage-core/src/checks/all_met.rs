//! Conditions as the fast path asks for them: comparisons alone.

use super::Checks;
use crate::diagnosis;
use crate::find::FindError;
use crate::find::seed::Seed;
use crate::{Mask, Real, Scalar};

/// Whether every condition was met. Every value goes on as it is.
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

    #[inline(always)]
    fn and(&mut self, met: M) {
        self.0 = self.0.and_condition(met);
    }

    /// Behind a group that is out of reach for certain where `value` is that far below zero; a value and operands
    /// that are not finite are another refusal, and so may be what is made of them.
    #[inline(always)]
    fn reach<T: Scalar<Mask = M>>(&mut self, value: T, scale: T, operands: &[T]) {
        self.0 = self.0.behind_reach(|| {
            let sum = operands.iter().copied().fold(value, |sum, next| sum + next);
            (T::lit(-BEYOND.0, -BEYOND.1) * scale).gt(value) & sum.is_finite()
        });
    }
}

/// 16 √ε: how far below zero, as a share of its spread, what stands under a group's root shows for certain
/// that the group is out of reach. Rounding alone moves it by 16 ε, and so do the four last places that a
/// group may miss; but a pin behind another group's toggle is known to √ε of its bars.
const BEYOND: (f64, f32) = (1.0 / (1_u32 << 22) as f64, 1.0 / (1_u32 << 7) as f32);

impl<T: Scalar, S: Seeds<T>> Checks<T> for AllMet<T::Mask, S> {
    #[inline(always)]
    fn seed(&mut self, unknown: usize) -> Option<&mut Seed<T>> {
        self.1.of(unknown)
    }

    #[inline(always)]
    fn root(&mut self, found: Result<[T; 2], FindError>, _: &'static str, _: &'static str) -> (T, T)
    where
        T: Real,
    {
        match found {
            Ok([at, size]) => (at, size),
            Err(_) => {
                let zero = T::lit(0.0, 0.0);
                self.and(zero.gt(zero));
                Checks::<T>::diagnosed(self);
                (zero, zero)
            }
        }
    }

    #[inline(always)]
    fn closed(&mut self, difference: T, size: T, _: &'static str, _: &'static str)
    where
        T: Real,
    {
        self.and(difference.is_within(diagnosis::open_by(size)));
        Checks::<T>::diagnosed(self);
    }

    #[inline(always)]
    fn sin_cos(&mut self, angle: T) -> (T, T) {
        self.and(angle.is_near());
        Checks::<T>::diagnosed(self);
        angle.sin_cos_near()
    }

    #[inline(always)]
    fn hypot(&mut self, x: T, y: T, least: T) -> T {
        let (length, is_near) = x.hypot_near(y, least);
        self.and(is_near);
        Checks::<T>::diagnosed(self);
        length
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
        const WIDE: f64 = diagnosis::ROUNDINGS * f64::EPSILON;
        const NARROW: f32 = diagnosis::ROUNDINGS as f32 * f32::EPSILON;
        self.and(value.gt(T::lit(WIDE, NARROW) * spread));
    }

    /// The magnitude, compared: neither a square, which underflows, nor a disjunction, which
    /// masks do not have.
    #[inline(always)]
    fn away(&mut self, value: T, least: T) {
        let magnitude = T::select(value.ge(T::lit(0.0, 0.0)), value, -value);
        self.and(magnitude.gt(least));
    }

    #[inline(always)]
    fn diagnosed(&mut self) {
        self.0 = self.0.behind_condition();
    }

    /// Against (l₁ + l₂)²/4l₁l₂ in squares of the unit: compensated values have no spread.
    #[inline(always)]
    fn reach_circles(&mut self, value: T, operands: [T; 6], _: &'static str) -> T {
        let [dx, dy, l1, l2, unit, _] = operands;
        let (sum, half) = (l1 + l2, T::lit(0.5, 0.5) * unit);
        self.reach(value, (sum * sum) * (half / l1 * (half / l2)), &[dx, dy, l1, l2]);
        value
    }

    #[inline(always)]
    fn reach_distances(&mut self, value: T, operands: [T; 4], _: &'static str) -> T {
        let [l, r1, r2, spread] = operands;
        self.reach(value, spread, &[l, r1, r2]);
        value
    }

    /// (l − t)(l + t), against t².
    #[inline(always)]
    fn reach_line(&mut self, value: T, t: T, l: T, _: &'static str) -> T {
        self.reach(value, t * t, &[t, l]);
        value
    }

    /// bx² + by² − e², against e².
    #[inline(always)]
    fn reach_offset(&mut self, value: T, bx: T, by: T, e: T, _: &'static str) -> T {
        self.reach(value, e * e, &[bx, by, e]);
        value
    }
}
