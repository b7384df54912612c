//! From the ends of an interval to a root, or to the reason why there is none.

use super::approach::{Approach, At, greater, magnitude, number};
use super::equation::Equation;
use super::survey::{Course, survey};
use super::{Crossing, FindError, Search};
use crate::Real;
use crate::kernels::sqrt;

impl<T: Real> Search<T> {
    /// The root from both ends. The distance by which f may miss zero at an end follows from its values
    /// there. Where f `is_steady`, its slope is proved to have one sign between the ends.
    pub(super) fn bracketed(
        &self,
        f: &mut Equation<'_, T>,
        approach: Approach<T>,
        is_steady: bool,
        slack: &dyn Fn([T; 2]) -> T,
    ) -> Result<T, FindError> {
        let zero = number::<T>(0.0);
        let ends = [f.at(approach.from)?, f.at(approach.to)?];
        let [mut a, mut b] = ends;
        let slack = slack([a.value, b.value]);
        let mut most = Self::MOST - 2;
        if a.value.ge(zero) && zero.gt(a.slope) {
            a = f.moved_in([a, b], 0, &mut most)?;
        }
        if zero.ge(b.value) && zero.gt(b.slope) {
            b = f.moved_in([a, b], 1, &mut most)?;
        }
        let steepest = steepest_at_a_dead_point(ends, slack);
        let falls = |end: At<T>| (-end.slope).gt(steepest);
        let misses = |end: At<T>, by: T| by.gt(zero) || by.value() == 0.0 && falls(end);
        let nearer = match (misses(a, a.value), misses(b, -b.value)) {
            (false, false) => {
                let root = [a, b].into_iter().find(|end| end.value.value() == 0.0);
                return root.map_or_else(|| f.root([a, b], approach), |end| Ok(end.x));
            }
            (true, true) if a.value.gt(-b.value) => b,
            (true, _) => a,
            (false, true) => b,
        };
        let is_met = |at: At<T>| slack.ge(magnitude(at.value)) && !falls(at);
        if is_met(nearer) {
            return Ok(nearer.x);
        }
        if is_steady && rises_without_a_root(ends) {
            return Err(without_root(nearer, None));
        }
        match survey(f, [ends[0], a, b, ends[1]], most)? {
            Course::Rises(ends) => f.root(ends, approach),
            Course::Zero(at) => Ok(at.x),
            Course::Unknown => Err(FindError::SeveralDeadPoints),
            Course::Never { nearest, falls } => {
                let is_nearer = |at: &At<T>| magnitude(nearer.value).gt(magnitude(at.value));
                let nearest = nearest.filter(is_nearer).unwrap_or(nearer);
                if is_met(nearest) {
                    return Ok(nearest.x);
                }
                let left = Self::MOST.saturating_sub(f.evaluations());
                let other = match falls {
                    Some(ends) => {
                        let at = f.falling_root(ends, left)?.value();
                        Some(Crossing { trend: self.trend.flipped(), at })
                    }
                    None => None,
                };
                Err(without_root(nearest, other))
            }
        }
    }
}

/// The refusal where f comes nearest to a root here, and passes zero the other way there.
fn without_root<T: Real>(nearest: At<T>, other: Option<Crossing>) -> FindError {
    let by = magnitude(nearest.value).value();
    FindError::NoSolution { at: nearest.x.value(), by, other }
}

/// True if a function whose slope keeps its sign between these ends, but for a dead point next to one of them, rises on
/// one side of zero: a survey would find neither a root nor a dead point that comes nearer to one. Where it is above zero
/// it may fall next to the upper end, where it is below zero next to the lower one.
fn rises_without_a_root<T: Real>([a, b]: [At<T>; 2]) -> bool {
    let zero = number::<T>(0.0);
    let is_above = a.value.gt(zero) && a.slope.ge(zero);
    let is_below = zero.gt(b.value) && b.slope.ge(zero);
    b.value.gt(a.value) && (is_above || is_below)
}

/// The steepest slope of an end that may be a dead point, of which neither the place nor the value is
/// known better than to rounding: a step of Newton's method from there leads further than √ε of the
/// interval. Where it is shorter, f passes zero at the end.
fn steepest_at_a_dead_point<T: Real>([a, b]: [At<T>; 2], slack: T) -> T {
    let size = greater(magnitude(a.value), magnitude(b.value));
    let rounding = greater(slack, size * number(<T as Real>::EPSILON));
    rounding / ((b.x - a.x) * number(sqrt(<T as Real>::EPSILON)))
}
