//! The equation that is solved, its evaluations counted, its sign such that it rises at the root.

use super::approach::{
    Approach, At, Found, Slopes, Steps, Trial, constant, magnitude, middle, newton_step, number,
};
use super::lowest::{dead_point_most, lowest};
use super::{FindError, Root, Trend, start};
use crate::Real;

/// Newton's steps from a seed.
const SEEDED: u32 = 3;

/// f, its sign turned where it is to fall. What searches is compiled once for all functions of a type of numbers.
pub(super) struct Equation<'f, T> {
    f: &'f mut dyn FnMut(T) -> [T; 2],
    sign: T,
    evaluations: u32,
}

/// The root between two places at which f, of a value below zero and one above, is known.
pub(crate) fn crossing<T: Real>(
    [a, b]: [At<T>; 2],
    f: &mut dyn FnMut(T) -> [T; 2],
) -> Result<T, FindError> {
    let Some(approach) = Approach::new([a.x, b.x]) else { return Ok(a.x) };
    let trend = if b.value.gt(a.value) { Trend::Rising } else { Trend::Falling };
    let mut f = Equation::new(f, trend);
    let turned = |at: At<T>| At { value: f.sign * at.value, slope: f.sign * at.slope, ..at };
    let ends = [a, b].map(turned);
    let at = f.root(ends, approach)?;
    f.differentiated(at).map(|root| root.at)
}

/// A known root with the derivatives that f's numbers carry.
pub(crate) fn differentiated<T: Real>(
    at: T,
    f: &mut dyn FnMut(T) -> [T; 2],
) -> Result<T, FindError> {
    Equation::new(f, Trend::Rising).differentiated(at).map(|root| root.at)
}

impl<'f, T: Real> Equation<'f, T> {
    pub(super) fn new(f: &'f mut dyn FnMut(T) -> [T; 2], trend: Trend) -> Self {
        Self { f, sign: trend.sign(), evaluations: 0 }
    }

    pub(super) fn evaluations(&self) -> u32 {
        self.evaluations
    }

    /// f at a trial, without the derivatives that its numbers carry.
    pub(super) fn at(&mut self, x: T) -> Result<At<T>, FindError> {
        self.evaluations += 1;
        let [value, slope] = (self.f)(x).map(constant);
        if value.is_finite() {
            Ok(At { x, value: self.sign * value, slope: self.sign * slope })
        } else {
            Err(FindError::NotFinite { at: x.value() })
        }
    }

    /// The root that Newton's method converges to from a seed, if it does at once, inside and by no step
    /// longer than this. `last` is the step that led to the seed, and f's slope where it began, if they are
    /// known.
    pub(super) fn newton(
        &mut self,
        seed: T,
        approach: Approach<T>,
        longest: T,
        last: Option<(T, T)>,
    ) -> Option<T> {
        let Approach { from, to, tolerance } = approach;
        let last = last.map(|(step, slope)| (step, self.sign * slope));
        let mut steps = Steps { tolerance, width: to - from, slopes: Slopes::Exact, last };
        let mut x = constant(seed);
        for _ in 0..SEEDED {
            if !(x.ge(from) && to.ge(x)) {
                return None;
            }
            let at = self.at(x).ok()?;
            let step = newton_step(at).filter(|&step| longest.ge(magnitude(step)))?;
            x = x + step;
            if steps.is_last(step, at.slope) {
                return (x.ge(from) && to.ge(x)).then_some(x);
            }
            steps.last = Some((step, at.slope));
        }
        None
    }

    /// The root in a bracket.
    pub(super) fn root(&mut self, ends: [At<T>; 2], approach: Approach<T>) -> Result<T, FindError> {
        let start = start::cubic(ends);
        let trial = |x| Ok(Trial { at: self.at(x)?, is_enough: false });
        approach.close_in(ends, start, Slopes::Exact, u32::MAX, trial).map(Found::x)
    }

    /// The root between two places of which f is above zero at the first and below it at the second, by
    /// at most so many evaluations; one place for both is the root itself.
    pub(super) fn falling_root(&mut self, ends: [At<T>; 2], most: u32) -> Result<T, FindError> {
        let turned = |at: At<T>| At { value: -at.value, slope: -at.slope, ..at };
        let [a, b] = ends.map(turned);
        let Some(approach) = Approach::new([a.x, b.x]) else { return Ok(a.x) };
        let trial = |x| Ok(Trial { at: turned(self.at(x)?), is_enough: false });
        approach.close_in([a, b], start::cubic([a, b]), Slopes::Exact, most, trial).map(Found::x)
    }

    /// One of the ends, 0 or 1, at which f has the wrong sign and a slope against the trend, moved
    /// towards the dead point that it lies beyond until the sign is right; the dead point if it is
    /// wrong there too, or the end itself where no dead point shows. Takes from `most` what it
    /// evaluates.
    pub(super) fn moved_in(
        &mut self,
        ends: [At<T>; 2],
        end: usize,
        most: &mut u32,
    ) -> Result<At<T>, FindError> {
        let before = self.evaluations;
        let moved = self.lowest_from(ends, end, dead_point_most::<T>().min(*most));
        *most = most.saturating_sub(self.evaluations - before);
        moved
    }

    fn lowest_from(&mut self, ends: [At<T>; 2], end: usize, most: u32) -> Result<At<T>, FindError> {
        let zero = number::<T>(0.0);
        let [stays, moves] = if end == 0 { [ends[1], ends[0]] } else { ends };
        let inner =
            if stays.slope.gt(zero) { stays } else { self.at(middle([ends[0].x, ends[1].x]))? };
        if !inner.slope.gt(zero) {
            return Ok(moves);
        }
        // The upper end comes down to a highest point: the lowest of −f.
        let turn =
            |at: At<T>| if end == 0 { at } else { At { value: -at.value, slope: -at.slope, ..at } };
        let between = if end == 0 { [moves, inner] } else { [inner, moves] };
        lowest(between.map(turn), zero, most.saturating_sub(2), &mut |x| self.at(x).map(turn))
            .map(turn)
    }

    /// The root, with the derivatives that f's numbers carry: in their arithmetic each of Newton's
    /// steps makes the derivatives of one more order right. For ranges, all roots.
    pub(super) fn differentiated(mut self, at: T) -> Result<Root<T>, FindError> {
        let mut x = at;
        for _ in 0..T::ORDER {
            self.evaluations += 1;
            let [value, slope] = (self.f)(x);
            if value.is_constant() && x.is_constant() {
                break;
            }
            // The value is as right as it can be.
            let step = value / slope;
            x = x - (step - constant(step));
        }
        let x = x.with_all_roots(&mut self.f);
        if x.is_finite() {
            Ok(Root { at: x, evaluations: self.evaluations })
        } else {
            Err(FindError::Singular { at: at.value() })
        }
    }
}
