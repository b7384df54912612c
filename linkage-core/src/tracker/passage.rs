//! The way from one pose to another: which change points it passes, and where it ends if the
//! motion does.
//!
//! The way is the straight line between two inputs, its parts counted from 0 to 1. Along it every
//! group's clearance is a smooth function of the part. It is followed in stretches short enough
//! for a cubic to describe it; in a stretch in which it falls and rises again, the lowest point is
//! found. There it touches zero (a change point), stays above (nothing happens) or lies below (the
//! motion ends). Clearances are compared in units of their scale, in `f64`.

use super::{Linear, Modes};
use crate::kernels::sqrt;
use crate::{Real, SolveError};

/// A straight way between two inputs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<M: Modes> {
    /// With the modes at the beginning.
    solver: M,
    from: M::Input,
    to: M::Input,
    step: M::Input,
}

/// A change point next to the end of a passage.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearby {
    /// The part of the passage at which it lies; it may lie behind the end.
    pub(super) at: f64,
    /// Where the solver's own rounding is as small as an interpolation's error, from there.
    pub(super) width: f64,
}

/// Clearance and slope along the passage of one group.
#[derive(Clone, Copy, Debug)]
struct Reading {
    value: f64,
    slope: f64,
}

/// The lowest point of a clearance.
#[derive(Clone, Copy, Debug)]
struct Lowest {
    at: f64,
    value: f64,
    curvature: f64,
}

/// More than anything that is resolved in this many pieces is given up.
const PIECES: usize = 4096;

/// The shortest stretch: a change point takes part in at least 0.1 % of the passage.
const SHORTEST: f64 = 1.0 / 1024.0;

/// A clearance that rounding alone cannot tell from zero: coordinates carry a few dozen ε.
fn zero<M: Modes>() -> f64 {
    64.0 * M::Scalar::EPSILON
}

/// A clearance that rounding cannot take for zero, far enough above it for its slope to be sure.
fn clear<M: Modes>() -> f64 {
    4.0 * sqrt(M::Scalar::EPSILON).max(64.0 * M::Scalar::EPSILON)
}

/// Below this clearance the rounding of a velocity, ε over the clearance, is larger than the error
/// of an interpolation over as wide a range.
fn near<M: Modes>() -> f64 {
    sqrt(sqrt(M::Scalar::EPSILON))
}

/// How far from a change point the clearance is a few times [`clear`].
fn aside<M: Modes>(lowest: Lowest) -> f64 {
    sqrt(8.0 * clear::<M>() / lowest.curvature)
}

impl<M: Modes> Passage<M> {
    pub(super) fn new(solver: M, from: M::Input, to: M::Input) -> Self {
        Self { solver, from, to, step: to.minus(from) }
    }

    /// The inputs at a part of the way, which may lie outside it.
    pub(super) fn input(&self, part: f64) -> M::Input {
        if part == 1.0 { self.to } else { self.from.plus(number::<M>(part), self.step) }
    }

    /// The solver with the modes that the motion has at a part of the way.
    ///
    /// # Errors
    /// `OutOfReach` or `Singular` where the motion ends before; `Singular` where it passes a change
    /// point of a group whose mode is not a parameter of its own.
    pub(super) fn solver_at(&self, part: f64) -> Result<M, SolveError> {
        Self::new(self.solver, self.from, self.input(part)).follow()
    }

    fn follow(&self) -> Result<M, SolveError> {
        let mut solver = self.solver;
        let mut here = 0.0;
        for _ in 0..PIECES {
            let Some((group, lowest)) = self.first_change(&solver, here)? else {
                return Ok(solver);
            };
            let aside = aside::<M>(lowest);
            self.change(&mut solver, group, [lowest.at - aside, lowest.at + aside])?;
            here = lowest.at + aside;
            if here >= 1.0 {
                return Ok(solver);
            }
        }
        Err(SolveError::NotFinite { name: "the inputs" })
    }

    /// The first change point behind `here`: its group and place.
    fn first_change(&self, solver: &M, here: f64) -> Result<Option<(usize, Lowest)>, SolveError> {
        let mut first = None;
        let mut to = 1.0;
        let all = [here, 0.5 * (here + to), to].map(|part| self.clearances(solver, part));
        for group in 0..M::GROUPS.len() {
            let at = |part| reading::<M>(&self.clearances(solver, part), group);
            let shared = all.each_ref().map(|clearances| reading::<M>(clearances, group));
            let three = if to == 1.0 { shared } else { [shared[0], at(0.5 * (here + to)), at(to)] };
            if let Some(lowest) = self.first_touch(solver, group, [here, to], three)? {
                // What groups behind this one do is to be asked only before it.
                to = (lowest.at - aside::<M>(lowest)).max(here);
                first = Some((group, lowest));
            }
        }
        Ok(first)
    }

    /// The first place in a stretch at which a group's clearance touches zero; the readings are
    /// those at its ends and in the middle.
    fn first_touch(
        &self,
        solver: &M,
        group: usize,
        [mut here, to]: [f64; 2],
        [mut a, mut middle, mut b]: [Reading; 3],
    ) -> Result<Option<Lowest>, SolveError> {
        let at = |part| reading::<M>(&self.clearances(solver, part), group);
        for _ in 0..PIECES {
            let mut half = 0.5 * (to - here);
            while half >= SHORTEST && !is_cubic(a, middle, b, half) {
                half *= 0.5;
                (b, middle) = (middle, at(here + half));
            }
            let mut end = if 2.0 * half >= to - here { to } else { here + 2.0 * half };
            // No stretch begins on a change point: it would belong to neither.
            while end < to && b.value < clear::<M>() && end - here > SHORTEST {
                end = here + 0.875 * (end - here);
                b = at(end);
            }
            let lowest = if a.slope < 0.0 && b.slope >= 0.0 {
                self.lowest(solver, group, [(here, a), (end, b)])
            } else {
                Lowest { at: end, value: b.value, curvature: 0.0 }
            };
            if lowest.value < -zero::<M>() {
                return Err(self.dead_end(solver, lowest.at, group));
            }
            let touches = lowest.curvature > 0.0 && lowest.value <= zero::<M>();
            if touches && a.value >= clear::<M>() {
                return Ok(Some(lowest));
            }
            if end >= to {
                return Ok(None);
            }
            (here, a, middle, b) = (end, b, at(0.5 * (end + to)), at(to));
        }
        Ok(None)
    }

    /// The clearances at a part of the way. Where a group at its limit was rounded out of reach,
    /// those behind it have no numbers; then those of a place close by.
    fn clearances(&self, solver: &M, part: f64) -> M::Clearances {
        let at = |part: f64| solver.clearances(self.input(part), self.step);
        let mut found = at(part);
        let mut aside = 1e-7;
        while aside < 1e-2 && has_gap::<M>(&found) {
            found = at(part - aside);
            aside *= 4.0;
        }
        found
    }

    /// Where a clearance that falls at one end of a stretch and rises at the other is lowest: the
    /// zero of its slope, by secants and halvings.
    fn lowest(&self, solver: &M, group: usize, ends: [(f64, Reading); 2]) -> Lowest {
        let [mut a, mut b] = ends;
        let mut found = Lowest { at: a.0, value: f64::NAN, curvature: 0.0 };
        for turn in 0..60 {
            let secant = a.0 - a.1.slope * (b.0 - a.0) / (b.1.slope - a.1.slope);
            let at = if turn % 3 == 2 { 0.5 * (a.0 + b.0) } else { secant };
            let here = reading::<M>(&self.clearances(solver, at), group);
            let curvature = (b.1.slope - a.1.slope) / (b.0 - a.0);
            let above = here.slope * here.slope / (2.0 * curvature);
            found = Lowest { at, value: here.value - above, curvature };
            if above <= 0.01 * zero::<M>() || !above.is_finite() {
                break;
            }
            if here.slope < 0.0 {
                a = (at, here);
            } else {
                b = (at, here);
            }
        }
        found
    }

    /// Why the motion does not go on: what the solver says at the end, or at least there.
    fn dead_end(&self, solver: &M, part: f64, group: usize) -> SolveError {
        let refusal = |part| solver.position(self.input(part)).err();
        refusal(1.0)
            .or_else(|| refusal(part))
            .unwrap_or(SolveError::Singular { group: title::<M>(group) })
    }

    /// Changes the modes of a group and of those behind it that touch zero at the same place,
    /// between two parts of the way.
    fn change(&self, solver: &mut M, group: usize, parts: [f64; 2]) -> Result<(), SolveError> {
        let before = *solver;
        let touches = |after: &M, group: usize| {
            let at = |solver, part| reading::<M>(&self.clearances(solver, part), group);
            touches_between::<M>(at(&before, parts[0]), at(after, parts[1]), parts[1] - parts[0])
        };
        let groups = group..M::GROUPS.len();
        for other in groups.clone() {
            if other != group && !touches(solver, other) {
                continue;
            }
            let Some(param) = param::<M>(other) else {
                return Err(SolveError::Singular { group: title::<M>(other) });
            };
            if !(group..other).any(|earlier| self::param::<M>(earlier) == Some(param)) {
                solver.flip(param);
            }
        }
        // A group that stays as it is keeps its mode: it cannot share the parameter.
        let stays = |g: &usize| *g != group && !touches(solver, *g);
        let changed = |g: &usize| {
            let mut others = groups.clone().filter(|other| !stays(other));
            others.any(|other| param::<M>(other) == param::<M>(*g))
        };
        match (0..M::GROUPS.len()).filter(stays).find(changed) {
            Some(torn) => Err(SolveError::Singular { group: title::<M>(torn) }),
            None => Ok(()),
        }
    }

    /// A change point so close to the end that the solver's rounding shows, and whether the end is
    /// clear of every limit.
    pub(super) fn around_end(&self, solver: &M) -> (Option<Nearby>, bool) {
        let end = self.clearances(solver, 1.0);
        let is_clear = is_clear::<M>(&end);
        let readings = (0..M::GROUPS.len()).map(|group| reading::<M>(&end, group));
        let close = readings.enumerate().filter(|(_, reading)| reading.value < near::<M>());
        let nearby =
            close.filter_map(|(group, reading)| self.nearby(solver, group, reading)).next();
        (nearby, is_clear)
    }

    /// The change point of a group at the end of the way, if that is what it is close to.
    fn nearby(&self, solver: &M, group: usize, end: Reading) -> Option<Nearby> {
        let at = |part| reading::<M>(&self.clearances(solver, part), group);
        let mut width = 2.0 * (end.value / end.slope).abs();
        if !(1e-9..1e9).contains(&width) {
            width = 1e-2;
        }
        // To where the clearance is about `near`, as it grows with the square of the distance.
        for _ in 0..8 {
            let farther = at(1.0 + width).value.max(at(1.0 - width).value);
            let factor = sqrt(near::<M>() / farther.max(0.0));
            width *= if factor.is_finite() { factor.clamp(1e-3, 1e3) } else { 16.0 };
            if (0.5..2.0).contains(&factor) {
                break;
            }
        }
        let [a, b] = [1.0 - 2.0 * width, 1.0 + 2.0 * width].map(|part| (part, at(part)));
        if !(a.1.slope < 0.0 && b.1.slope >= 0.0) {
            return None;
        }
        let lowest = self.lowest(solver, group, [a, b]);
        let width = sqrt(2.0 * near::<M>() / lowest.curvature);
        let is_change = lowest.value.abs() <= zero::<M>();
        (is_change && (1.0 - lowest.at).abs() < width).then_some(Nearby { at: lowest.at, width })
    }
}

/// Inputs clear of every limit from which the motion comes to `q`, if that is the first pose: `q`
/// itself, unless a change point is near; else the nearest ones on the same side of it along the
/// rates, or ahead where `q` lies on it. None where the rates lead nowhere.
pub(super) fn beginning<M: Modes>(solver: &M, q: M::Input, rate: M::Input) -> Option<M::Input> {
    let least = |q: M::Input| {
        let clearances = solver.clearances(q, rate);
        let readings = (0..M::GROUPS.len()).map(|group| reading::<M>(&clearances, group));
        readings.reduce(|least, other| if other.value < least.value { other } else { least })
    };
    let Some(here) = least(q).filter(|here| here.value < near::<M>()) else { return Some(q) };
    let is_clear = |q: &M::Input| least(*q).is_some_and(|at| at.value >= clear::<M>());
    let sign = if here.value >= clear::<M>() && here.slope < 0.0 { -1.0 } else { 1.0 };
    let mut aside = (0..64).scan(sign * 1e-12, |part, _| {
        *part *= 2.0;
        Some(q.plus(number::<M>(*part), rate))
    });
    if here.value < clear::<M>() {
        return aside.find(is_clear);
    }
    let is_far = |q: &M::Input| least(*q).is_some_and(|at| at.value >= near::<M>());
    aside.take_while(is_clear).find(is_far).or(Some(q))
}

/// Whether no group is at its limit or behind one out of reach.
fn is_clear<M: Modes>(clearances: &M::Clearances) -> bool {
    (0..M::GROUPS.len()).all(|group| reading::<M>(clearances, group).value >= clear::<M>())
}

/// Whether groups have no numbers although none before them is out of reach.
fn has_gap<M: Modes>(clearances: &M::Clearances) -> bool {
    let readings = (0..M::GROUPS.len()).map(|group| reading::<M>(clearances, group));
    let mut within = readings.take_while(|at| at.value >= -zero::<M>() || at.value.is_nan());
    within.any(|at| at.value.is_nan() || at.slope.is_nan())
}

/// Whether a cubic through values and slopes at both ends meets the value in the middle, well
/// enough to tell whether it comes to zero between.
fn is_cubic(a: Reading, middle: Reading, b: Reading, half: f64) -> bool {
    let cubic = 0.5 * (a.value + b.value) + 0.25 * half * (a.slope - b.slope);
    let error = (cubic - middle.value).abs();
    let least = a.value.min(middle.value).min(b.value);
    let most = a.value.max(middle.value).max(b.value);
    // What is no number lies behind a group out of reach, which decides.
    error <= (0.25 * least).max(0.01 * most) || error.is_nan()
}

/// Whether a clearance touches zero between two places `apart`, as a parabola.
fn touches_between<M: Modes>(a: Reading, b: Reading, apart: f64) -> bool {
    let curvature = (b.slope - a.slope) / apart;
    let lowest = a.value - a.slope * a.slope / (2.0 * curvature);
    a.slope < 0.0 && b.slope > 0.0 && lowest.abs() <= zero::<M>().max(0.01 * a.value)
}

fn reading<M: Modes>(clearances: &M::Clearances, group: usize) -> Reading {
    match clearances.as_ref().get(group) {
        Some(of) => {
            let scale = of.scale.value();
            Reading { value: of.value.value() / scale, slope: of.rate.value() / scale }
        }
        None => Reading { value: 1.0, slope: 0.0 },
    }
}

fn title<M: Modes>(group: usize) -> &'static str {
    M::GROUPS.get(group).map_or("", |of| of.0)
}

fn param<M: Modes>(group: usize) -> Option<usize> {
    M::GROUPS.get(group).and_then(|of| of.1)
}

fn number<M: Modes>(value: f64) -> M::Scalar {
    crate::Scalar::lit(value, value as f32)
}
