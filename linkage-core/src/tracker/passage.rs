//! The way from one pose to another: which change points it passes, and where it ends if the
//! motion does.
//!
//! The way is the straight line between two inputs, its parts counted from 0 to 1. Along it every
//! group's clearance is a smooth function of the part, and a change point is a place where it is
//! lowest and zero. Group by group in solving order the way is followed in stretches of which
//! [`judge`](super::stretch::judge) can say everything; what it cannot is divided.
//!
//! Next to a group's change point nothing can be said of the groups behind it, which turn on the
//! root of its clearance. So they are followed up to the change point and from it, and over it as
//! cubics.

use super::line::{AllValues, Line, Reading};
use super::stretch::{Finding, Lowest, judge};
use super::{Thresholds, param, title};
use crate::SolveError;
use crate::kernels::sqrt;
use crate::solver::Solver;

/// The most stretches in one passage. Half a turn of a four-bar takes some twenty, and of three
/// groups in a row, each with change points of its own, up to some thousands; what takes more is
/// given up.
const STRETCHES: usize = 16_384;

/// A straight way between two inputs.
#[derive(Clone, Copy)]
pub(super) struct Passage<M: Solver> {
    /// With the modes at the beginning.
    solver: M,
    line: Line<M>,
}

/// A change point on the way, and how far from it the clearance is large enough for the groups
/// behind.
#[derive(Clone, Copy, Debug)]
struct Change {
    group: usize,
    at: f64,
    aside: f64,
}

/// The state of a group on a part of the way.
enum Advance {
    /// Clear of its limit at the end.
    Clear,
    /// At its limit in the end; up to this place it is clear.
    Fading(f64),
    /// Through a change point, the first.
    Changing(Change),
}

impl<M: Solver> Passage<M> {
    /// `solver` with the modes at the beginning.
    pub(super) fn new(solver: M, from: M::Input, to: M::Input) -> Self {
        Self { solver, line: Line::new(from, to) }
    }

    /// True if every group keeps a clearance of at least `near` parts of its scale, so that neither modes
    /// change nor rounding shows. The whole way is enclosed at once.
    pub(super) fn is_clear(&self, near: f64) -> bool {
        let ranges = self.line.values(&self.solver);
        (0..M::TITLES.groups.len()).all(|group| ranges.of(group).is_above(near))
            && (!M::SEARCHES || [0.0, 1.0].iter().all(|&part| self.agrees(part, &ranges)))
    }

    /// True if the root found at a place belongs to the branch whose ranges were proved.
    fn agrees(&self, part: f64, ranges: &AllValues<M>) -> bool {
        let zero = Thresholds::of::<M::Scalar>().zero;
        let readings = self.line.readings(&self.solver, part);
        (0..M::TITLES.groups.len()).all(|group| ranges.of(group).hold(&readings.of(group), zero))
    }

    /// True if the groups are clear of their limits at the end.
    pub(super) fn ends_clear(&self, solver: &M) -> bool {
        !(0..M::TITLES.groups.len()).any(|group| self.ends_fading(solver, group))
    }

    /// The error for an unknown whose equation seems to have no root at the end although one was found:
    /// between other dead points, where the continuation is undetermined.
    pub(super) fn contradicts(&self, solver: &M) -> Option<SolveError> {
        let zero = Thresholds::of::<M::Scalar>().zero;
        let groups = 0..if M::SEARCHES { M::TITLES.groups.len() } else { 0 };
        groups.into_iter().find_map(|group| {
            let is_none = self.line.reading(solver, 1.0, group).is_below(-zero);
            is_none.then_some(SolveError::SeveralDeadPoints { unknown: title::<M>(group) })
        })
    }

    fn ends_fading(&self, solver: &M, group: usize) -> bool {
        let clear = Thresholds::of::<M::Scalar>().clear;
        !self.line.reading(solver, 1.0, group).is_above(clear)
    }

    /// True if no mode changes on the way.
    pub(super) fn is_quiet(&self) -> bool {
        matches!(self.first_change(&self.solver, 0.0, &mut { STRETCHES }), Ok(None))
    }

    /// From the beginning to the end, if these are not the same.
    pub(super) fn direction(&self) -> Option<M::Input> {
        self.line.direction()
    }

    /// The passage with the same beginning to other inputs.
    pub(super) fn to(&self, q: M::Input) -> Self {
        Self { line: self.line.to(q), ..*self }
    }

    /// The solver with the modes that the motion has at the end.
    ///
    /// # Errors
    /// `OutOfReach` or `Singular` where the motion ends before, or where it cannot be decided whether it
    /// does; `Singular` where it passes a change point of a group whose mode is not a parameter of
    /// its own; `NotFinite` where the clearance of a group is not finite.
    pub(super) fn follow(&self) -> Result<M, SolveError> {
        let (mut solver, mut here, mut budget) = (self.solver, 0.0, STRETCHES);
        while let Some(change) = self.first_change(&solver, here, &mut budget)? {
            let end = change.at + change.aside;
            self.cross(&mut solver, change, [here.max(change.at - change.aside), end])?;
            here = end;
            if here >= 1.0 {
                break;
            }
        }
        Ok(solver)
    }

    /// The first change point behind `here`.
    fn first_change(
        &self,
        solver: &M,
        here: f64,
        budget: &mut usize,
    ) -> Result<Option<Change>, SolveError> {
        let (mut first, mut to) = (None, 1.0_f64);
        for group in 0..M::TITLES.groups.len() {
            // Dependent groups are examined only up to this group's limit.
            match self.course(solver, group, [here, to], budget)? {
                Advance::Clear => {}
                Advance::Fading(at) => to = at,
                Advance::Changing(change) => {
                    to = here.max(change.at - change.aside);
                    first = Some(change);
                }
            }
        }
        Ok(first)
    }

    /// Follows one group, those before it being clear.
    fn course(
        &self,
        solver: &M,
        group: usize,
        [mut here, to]: [f64; 2],
        budget: &mut usize,
    ) -> Result<Advance, SolveError> {
        let read = |part| self.line.reading(solver, part, group);
        let unknown = || SolveError::Singular { group: title::<M>(group) };
        let thresholds = Thresholds::of::<M::Scalar>();
        let (mut a, mut length) = (read(here), to - here);
        while here < to {
            *budget = budget.checked_sub(1).ok_or_else(unknown)?;
            let end = if here + length < to { here + length } else { to };
            let b = read(end);
            if !(a.is_finite() && b.is_finite()) {
                return Err(SolveError::NotFinite { name: title::<M>(group) });
            }
            let ranges = self.line.ranges(solver, [here, end]).of(group);
            // The solver found a root of another branch: the ranges prove nothing here.
            let is_other = M::SEARCHES && [a, b].iter().any(|at| !ranges.hold(at, thresholds.zero));
            let judged = match is_other {
                true => Finding::divided(end - here),
                false => judge([(here, a), (end, b)], &ranges, thresholds, read),
            };
            match judged {
                Finding::Quiet if end == to && b.is_below(thresholds.clear) => {
                    return Ok(Advance::Fading(self.last_clear(solver, group, [here, end])));
                }
                Finding::Quiet => {
                    (length, here, a) = (2.0 * (end - here), end, b);
                }
                Finding::Divide => length = 0.5 * (end - here),
                Finding::Lost => return Err(unknown()),
                Finding::Ended(at) => return Err(self.dead_end(solver, at, group)),
                Finding::Touching(lowest) => {
                    return Ok(Advance::Changing(change(group, lowest, thresholds)));
                }
            }
        }
        Ok(Advance::Clear)
    }

    /// The last place where a group that comes to its limit is clear, or close to it: where its
    /// clearance is between one and four times what counts, or the beginning.
    fn last_clear(&self, solver: &M, group: usize, [mut a, mut b]: [f64; 2]) -> f64 {
        let clear = Thresholds::of::<M::Scalar>().clear;
        // As often as a part can be halved.
        for _ in 0..f64::MANTISSA_DIGITS {
            if self.line.reading(solver, a, group).is_below(4.0 * clear) {
                break;
            }
            let middle = 0.5 * (a + b);
            if self.line.reading(solver, middle, group).is_below(clear) {
                b = middle;
            } else {
                a = middle;
            }
        }
        a
    }

    /// Why the motion does not go on: what the solver says at the end, or at least there.
    fn dead_end(&self, solver: &M, part: f64, group: usize) -> SolveError {
        let refusal = |part| solver.position(self.line.input(part)).err();
        refusal(1.0)
            .or_else(|| refusal(part))
            .unwrap_or(SolveError::Singular { group: title::<M>(group) })
    }

    /// Changes the modes of a group and of all that touch zero with it, between two parts of the
    /// way.
    fn cross(&self, solver: &mut M, first: Change, parts: [f64; 2]) -> Result<(), SolveError> {
        let before = *solver;
        let thresholds = Thresholds::of::<M::Scalar>();
        // One bit a parameter is enough: a mechanism's struct has fewer fields than that.
        let mut flipped = 0_u128;
        for group in 0..M::TITLES.groups.len() {
            let ends = [(&before, parts[0]), (&*solver, parts[1])];
            let ends = ends.map(|(solver, part)| (part, self.line.reading(solver, part, group)));
            let changes = match lowest_between(ends) {
                _ if group == first.group => true,
                // A change after the end is left undecided, unless the end is part of it.
                Some((at, lowest)) if at <= 1.0 || self.ends_fading(solver, group) => {
                    if lowest < -thresholds.zero {
                        return Err(self.dead_end(solver, at, group));
                    }
                    lowest <= thresholds.zero
                }
                _ => false,
            };
            let param = param::<M>(group);
            let bit = param.and_then(|param| 1_u128.checked_shl(param as u32)).unwrap_or(0);
            match (changes, flipped & bit != 0) {
                (true, false) => {
                    let shared = (0..group).any(|other| param == self::param::<M>(other));
                    let Some(param) = param.filter(|_| bit != 0 && !shared) else {
                        return Err(SolveError::Singular { group: title::<M>(group) });
                    };
                    solver.flip(param);
                    flipped |= bit;
                }
                // A group that stays as it is keeps its mode: it cannot share the parameter.
                (false, true) => return Err(SolveError::Singular { group: title::<M>(group) }),
                _ => {}
            }
        }
        Ok(())
    }
}

/// A touching place as a change point. To its sides the clearance ½ S″ t² is sixteen times as high
/// as its lowest value is off zero, so that what is misfit no longer shows in the groups behind; and
/// at least `zero`, where their second rates are rounded by ε over the third power of t: far less
/// than what [`lowest_between`] tells apart.
fn change(group: usize, lowest: Lowest, thresholds: Thresholds) -> Change {
    let Lowest { at, reading } = lowest;
    let high = (16.0 * reading.value).abs().max(thresholds.zero * reading.scale);
    Change { group, at, aside: sqrt(2.0 * high / reading.second_rate) }
}

/// Where the polynomial of fifth degree through two readings is lowest between them, and its value
/// there in units of its scale, if it falls at the first and rises at the second.
///
/// It is off by S⁗″ h⁶/46080 at most between places h apart. For a group that turns k times as fast
/// as the one whose change point it is, S⁗″ is about 25 k⁶ of its scale; with h = 0.08 in `f32` and
/// k = 10 that is 1e-4, where 3e-4 is told apart, and in `f64` far less.
fn lowest_between([(from, a), (to, b)]: [(f64, Reading); 2]) -> Option<(f64, f64)> {
    if !(a.rate < 0.0 && b.rate >= 0.0) {
        return None;
    }
    let length = to - from;
    // Per length: S = a + u x + m/2 x² + c₃ x³ + c₄ x⁴ + c₅ x⁵ with x from 0 to 1.
    let [[u, m], [v, n]] = [a, b].map(|end| [length * end.rate, length * length * end.second_rate]);
    let [value, rate, second_rate] = [b.value - a.value - u - 0.5 * m, v - u - m, n - m];
    let c3 = 10.0 * value - 4.0 * rate + 0.5 * second_rate;
    let c4 = -15.0 * value + 7.0 * rate - second_rate;
    let c5 = 6.0 * value - 3.0 * rate + 0.5 * second_rate;
    let slope = |x: f64| u + x * (m + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 * c5))));
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (low + high);
        if slope(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let lowest = a.value + high * (u + high * (0.5 * m + high * (c3 + high * (c4 + high * c5))));
    Some((from + high * length, lowest / a.scale))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The polynomial of these coefficients, lowest power first, at a place.
    fn reading(polynomial: [f64; 6], at: f64) -> Reading {
        let powers = |from: usize, of: fn(f64, f64) -> f64| -> f64 {
            let terms = polynomial.iter().enumerate().skip(from);
            terms.map(|(n, c)| c * of(n as f64, at)).sum()
        };
        Reading {
            value: powers(0, |n, x| x.powf(n)),
            rate: powers(1, |n, x| n * x.powf(n - 1.0)),
            second_rate: powers(2, |n, x| n * (n - 1.0) * x.powf(n - 2.0)),
            scale: 0.25,
        }
    }

    /// Six numbers at two places make a polynomial of fifth degree: of one its lowest place and value
    /// are found as they are.
    #[test]
    fn the_lowest_place_of_a_quintic_is_its_own() {
        for low in [0.0, 3e-3, -3e-3] {
            for place in [0.15, 0.4, 0.5, 0.83] {
                for (bend, skew, rest) in
                    [(0.0, 0.0, 0.0), (0.7, 0.0, 0.0), (0.0, 0.6, 0.0), (0.5, 0.4, 0.3)]
                {
                    // (x − place)² (1 + bend y + skew y² + rest y³) + low, with y = x − place.
                    let around = [low, 0.0, 1.0, bend, skew, rest];
                    let at = |x: f64| {
                        let moved = reading(around, x - place);
                        (x, moved)
                    };
                    for [from, to] in [[0.0, 1.0], [0.1, 0.9], [place - 0.1, place + 0.02]] {
                        let found = lowest_between([at(from), at(to)]).expect("it falls and rises");
                        // The place by halvings of a slope of a few ε; the value is flat there.
                        assert!((found.0 - place).abs() < 1e-12, "{place} {found:?}");
                        assert!((found.1 - low / 0.25).abs() < 1e-13, "{low} {found:?}");
                    }
                    // Before and behind it only falls or only rises.
                    assert_eq!(lowest_between([at(place - 0.1), at(place - 0.01)]), None);
                    assert_eq!(lowest_between([at(place + 0.01), at(place + 0.1)]), None);
                }
            }
        }
    }
}
