//! Newton's steps in a bracket that closes in whatever they do.

use super::FindError;
use crate::kernels::sqrt;
use crate::{Real, Scalar};

/// An interval that is searched, and how closely.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach<T> {
    pub(crate) from: T,
    pub(crate) to: T,
    /// Half a unit in the last place of the larger end, at least a quarter: closer than this the
    /// next number is the same.
    pub(crate) tolerance: T,
}

/// A place, and a function's value and slope there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct At<T> {
    pub(crate) x: T,
    pub(crate) value: T,
    pub(crate) slope: T,
}

/// A trial, and whether the search may end with it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial<T> {
    pub(super) at: At<T>,
    pub(super) is_enough: bool,
}

/// Where the search has ended.
#[derive(Clone, Copy, Debug)]
pub(super) enum Found<T> {
    /// At a trial.
    Trial(At<T>),
    /// At the end of a last step, where nothing was evaluated.
    Step(T),
}

impl<T: Copy> Found<T> {
    pub(super) fn x(self) -> T {
        match self {
            Self::Trial(at) => at.x,
            Self::Step(x) => x,
        }
    }
}

/// Evaluations beyond those of bisection: what Newton's steps may take where they are no better.
pub(super) const SPARE: u32 = 6;

/// The most evaluations in any bracket: its width is at most 4/ε of the tolerance, and twice the
/// tolerance is where bisection ends.
pub(super) const fn most<T: Real>() -> u32 {
    // 1/ε is a power of two, and 1023 the exponent of one.
    let digits = 1023 - (T::EPSILON.to_bits() >> 52) as u32;
    digits + 1 + SPARE
}

impl<T: Real> Approach<T> {
    /// If the ends are finite, in rising order, and so is their distance.
    pub(crate) fn new(ends: [T; 2]) -> Option<Self> {
        let [from, to] = ends.map(constant);
        let width = to - from;
        let larger = greater(magnitude(from), magnitude(to));
        let tolerance = larger * number(0.5 * <T as Real>::EPSILON);
        (width.is_finite() && width.gt(number(0.0))).then_some(Self { from, to, tolerance })
    }

    /// The number of evaluations that bisection takes and as many to spare, and the tolerance
    /// times two to this power.
    fn budget(self, width: T) -> (u32, T) {
        // The exponents tell all but one or two of them.
        let exponent = |x: T| ((x.value().to_bits() >> 52) & 0x7ff) as u32;
        let known = exponent(width).saturating_sub(exponent(self.tolerance) + 2);
        let mut halvings = known.min(most::<T>() - SPARE);
        let mut reach = self.tolerance * number((1_u64 << halvings) as f64);
        while halvings < most::<T>() - SPARE && width.gt(reach + reach) {
            reach = reach + reach;
            halvings += 1;
        }
        (halvings + SPARE, reach * number(64.0))
    }

    /// Where the function comes through zero, from below at the first end to above at the second.
    /// No more than `most` trials.
    pub(super) fn close_in(
        self,
        [mut a, mut b]: [At<T>; 2],
        start: T,
        slopes: Slopes,
        most: u32,
        mut trial: impl FnMut(T) -> Result<Trial<T>, FindError>,
    ) -> Result<Found<T>, FindError> {
        let width = b.x - a.x;
        // Slopes so steep that the root would be next to any value are no guide.
        let believed = (b.value - a.value) / (width * number(sqrt(<T as Real>::EPSILON)));
        let (budget, mut reach) = self.budget(width);
        let mut steps = Steps { tolerance: self.tolerance, width, slopes, last: None };
        let mut x = start;
        for _ in 0..budget.min(most) {
            let wanted = x;
            x = projected(x, [a.x, b.x], reach);
            reach = reach * number(0.5);
            if x.value() != wanted.value() {
                steps.last = None;
            }
            let Trial { at, is_enough } = trial(x)?;
            if is_enough || at.value.value() == 0.0 {
                return Ok(Found::Trial(at));
            }
            if at.value.gt(number(0.0)) {
                b = at;
            } else {
                a = at;
            }
            if (self.tolerance + self.tolerance).ge(b.x - a.x) {
                break;
            }
            let guides =
                |step: &T| believed.ge(at.slope) && (x + *step).ge(a.x) && b.x.ge(x + *step);
            x = match newton_step(at).filter(guides) {
                Some(step) if steps.is_last(step, at.slope) => return Ok(Found::Step(x + step)),
                Some(step) => {
                    steps.last = Some((step, at.slope));
                    x + step
                }
                None => {
                    steps.last = None;
                    middle([a.x, b.x])
                }
            };
        }
        let nearer = if magnitude(b.value).gt(magnitude(a.value)) { a } else { b };
        Ok(Found::Trial(nearer))
    }
}

/// Newton's step where the slope is one that rises.
pub(super) fn newton_step<T: Real>(at: At<T>) -> Option<T> {
    (at.slope.gt(number(0.0)) && at.slope.is_finite()).then(|| -at.value / at.slope)
}

/// Where the slopes of a search come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slopes {
    /// The function gives them.
    Exact,
    /// From two values.
    Secant,
}

/// Newton's steps on their way to a root.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps<T> {
    pub(super) tolerance: T,
    /// The width of the interval that they stay in.
    pub(super) width: T,
    pub(super) slopes: Slopes,
    /// The step before, and the slope that it went by.
    pub(super) last: Option<(T, T)>,
}

impl<T: Real> Steps<T> {
    /// True if this step leads to within the tolerance of the root, as far as the last two steps show.
    pub(super) fn is_last(&self, step: T, slope: T) -> bool {
        let step = magnitude(step);
        if self.tolerance.ge(step) {
            return true;
        }
        let Some((last, slope_before)) = self.last else { return false };
        let last = magnitude(last);
        if step.ge(last * number(0.7)) {
            // Steps this short that do not become shorter are the function's rounding; those
            // towards a double root are halved.
            return (self.width * number(TWO_TO_MINUS_22)).ge(last);
        }
        // Where the slope has become so much steeper, the function is none that steps converge on: next
        // to a toggle, say, where it ends with a vertical slope.
        let is_exact = self.slopes == Slopes::Exact;
        if is_exact && magnitude(slope).gt(magnitude(slope_before) * number(STEEPER)) {
            return false;
        }
        // Each of Newton's steps is the square of the one before, times a constant; a secant's is
        // the product of the two before.
        let ratio = step / last;
        let next = match self.slopes {
            // The constant, half the curvature over the slope, also follows from both slopes: far
            // from the root a step may be shorter than it promises.
            Slopes::Exact => {
                let bend = magnitude((slope - slope_before) / (slope + slope));
                greater(ratio * ratio, bend * ratio) * step
            }
            Slopes::Secant => ratio * step,
        };
        (self.tolerance * number(0.5)).ge(next)
    }
}

/// A step after which the slope is more than this many times as steep has led to where the function is
/// another one: the square of what it grows by in the last step to a root at an even curvature.
const STEEPER: f64 = 4.0;

/// 2⁻²², above the relative rounding of a value and below any step that Newton's method is to make
/// from where it has not converged.
const TWO_TO_MINUS_22: f64 = 1.0 / 4_194_304.0;

/// The trial moved to where a bracket that is halved with every evaluation from now on ends in
/// time.
fn projected<T: Real>(x: T, [a, b]: [T; 2], reach: T) -> T {
    let half = (b - a) * number(0.5);
    let middle = a + half;
    let aside = greater(reach - half, number(0.0));
    let [low, high] = [greater(middle - aside, a), less(middle + aside, b)];
    // Also where the trial is not a number.
    if x.ge(low) && high.ge(x) {
        x
    } else if low.gt(x) {
        low
    } else if x.gt(high) {
        high
    } else {
        middle
    }
}

pub(super) fn middle<T: Real>([a, b]: [T; 2]) -> T {
    a + (b - a) * number(0.5)
}

/// A number without derivatives.
pub(crate) fn number<T: Scalar>(value: f64) -> T {
    T::num(value)
}

/// The number without its derivatives.
pub(crate) fn constant<T: Real>(x: T) -> T {
    number(x.value())
}

pub(crate) fn magnitude<T: Real>(x: T) -> T {
    if x.ge(number(0.0)) { x } else { -x }
}

pub(crate) fn greater<T: Real>(a: T, b: T) -> T {
    if a.gt(b) { a } else { b }
}

pub(crate) fn less<T: Real>(a: T, b: T) -> T {
    if b.gt(a) { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As many as a loop from none on finds.
    #[test]
    fn a_budget_is_what_halvings_take() {
        fn check<T: Real>(from: T, to: T, share: T) {
            let approach = Approach::new([from, to]).expect("in order");
            let width = (approach.to - approach.from) * share;
            let (mut halvings, mut reach) = (0, approach.tolerance);
            while halvings < most::<T>() - SPARE && width.gt(reach + reach) {
                (reach, halvings) = (reach + reach, halvings + 1);
            }
            let (found, wide) = approach.budget(width);
            let expected = (halvings + SPARE, (reach * number(64.0)).value());
            assert_eq!((found, wide.value()), expected, "{from:?} {to:?} {share:?}");
        }
        let ends = [(0.0, 3.1), (-1.0, 1.0), (1.0, 1.0000001), (0.0, 5e-324), (-1e300, 1e300)];
        for (from, to) in ends {
            for k in 0..80 {
                check(from, to, 1.0);
                check(from, to, (-f64::from(k)).exp2() * 1.3);
            }
        }
        for (from, to) in [(0.0, 3.1), (-1.0, 1.0), (1.0, 1.000001), (0.0, 1e-45), (-1e38, 1e38)] {
            for k in 0..40 {
                check::<f32>(from, to, (-k as f32).exp2() * 1.3);
            }
        }
    }
}
