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

use super::line::{Line, Reading};
use super::stretch::{Finding, Lowest, judge};
use super::{Modes, Thresholds, param, title};
use crate::SolveError;

/// The most stretches in one passage. A turn of a four-bar takes some twenty, each change point
/// that a chain of groups passes a few hundred; what takes more is given up.
const STRETCHES: usize = 4096;

/// A straight way between two inputs.
#[derive(Clone, Copy)]
pub(super) struct Passage<M: Modes> {
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

/// How a group fares on a part of the way.
enum Course {
    /// Clear of its limit at the end.
    Clear,
    /// At its limit in the end; up to this place it is clear.
    Fading(f64),
    /// Through a change point, the first.
    Changing(Change),
}

impl<M: Modes> Passage<M> {
    /// `solver` with the modes at the beginning.
    pub(super) fn new(solver: M, from: M::Input, to: M::Input) -> Self {
        Self { solver, line: Line::new(from, to) }
    }

    /// Whether every group stays so far from its limits that neither modes change nor rounding
    /// shows: one look at all of the way at once.
    pub(super) fn is_clear(&self) -> bool {
        let near = Thresholds::of::<M::Scalar>().near;
        let ranges = self.line.ranges(&self.solver, [0.0, 1.0]);
        (0..M::GROUPS.len()).all(|group| ranges.of(group).is_above(near))
    }

    /// Whether the groups are clear of their limits at the end.
    pub(super) fn ends_clear(&self, solver: &M) -> bool {
        !(0..M::GROUPS.len()).any(|group| self.ends_fading(solver, group))
    }

    fn ends_fading(&self, solver: &M, group: usize) -> bool {
        let clear = Thresholds::of::<M::Scalar>().clear;
        !self.line.reading(solver, 1.0, group).is_above(clear)
    }

    /// Whether no mode changes on the way.
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
    /// `OutOfReach` or `Singular` where the motion ends before, or where nobody can say whether it
    /// does; `Singular` where it passes a change point of a group whose mode is not a parameter of
    /// its own; `NotFinite` where the clearance of a group is no number.
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
        for group in 0..M::GROUPS.len() {
            // What groups behind this one do is to be asked only before its limit.
            match self.course(solver, group, [here, to], budget)? {
                Course::Clear => {}
                Course::Fading(at) => to = at,
                Course::Changing(change) => {
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
    ) -> Result<Course, SolveError> {
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
            match judge([(here, a), (end, b)], &ranges, thresholds, read) {
                Finding::Quiet if end == to && b.is_below(thresholds.clear) => {
                    return Ok(Course::Fading(self.last_clear(solver, group, [here, end])));
                }
                Finding::Quiet => {
                    (length, here, a) = (2.0 * (end - here), end, b);
                }
                Finding::Divide => length = 0.5 * (end - here),
                Finding::Lost => return Err(unknown()),
                Finding::Ended(at) => return Err(self.dead_end(solver, at, group)),
                Finding::Touching(lowest) => {
                    return Ok(Course::Changing(change(group, lowest, thresholds)));
                }
            }
        }
        Ok(Course::Clear)
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
        for group in 0..M::GROUPS.len() {
            let ends = [(&before, parts[0]), (&*solver, parts[1])];
            let ends = ends.map(|(solver, part)| (part, self.line.reading(solver, part, group)));
            let changes = match cubic_lowest(ends) {
                _ if group == first.group => true,
                // What comes after the end is not yet to be decided, unless the end is part of it.
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

/// A touching place as a change point. To its sides the clearance is four times what counts as
/// clear: ½ S″ t² = 4 clear.
fn change(group: usize, lowest: Lowest, thresholds: Thresholds) -> Change {
    let Lowest { at, reading } = lowest;
    let high = 8.0 * thresholds.clear * reading.scale;
    Change { group, at, aside: crate::kernels::sqrt(high / reading.second_rate) }
}

/// Where the cubic through two readings is lowest between them, and its value there in units of
/// its scale, if it falls at the first and rises at the second.
///
/// Between places `aside` from a change point it is off by S⁗ aside⁴/24 at most, with S⁗ a few
/// times the scale: 1e-12 in `f64`, 1e-5 in `f32`, far below what is told apart.
fn cubic_lowest([(from, a), (to, b)]: [(f64, Reading); 2]) -> Option<(f64, f64)> {
    if !(a.rate < 0.0 && b.rate >= 0.0) {
        return None;
    }
    let length = to - from;
    let (u, v) = (length * a.rate, length * b.rate);
    // S = a + u x + p x² + q x³ with x from 0 to 1.
    let rise = b.value - a.value;
    let (p, q) = (3.0 * rise - 2.0 * u - v, u + v - 2.0 * rise);
    // The root of u + 2 p x + 3 q x² at which it rises, u being negative; without a difference.
    let root = crate::kernels::sqrt((p * p - 3.0 * q * u).max(0.0));
    let x = if p >= 0.0 { -u / (p + root) } else { (root - p) / (3.0 * q) };
    let value = a.value + x * (u + x * (p + x * q));
    Some((from + x * length, value / a.scale))
}
