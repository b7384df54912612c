//! The neighbourhood of a change point: where it lies, results interpolated over it, and the side that
//! a motion which begins there comes from.

use super::line::Line;
use super::linear::Estimate;
use super::passage::Passage;
use super::{Linear, Thresholds, Zone, linear};
use crate::kernels::sqrt;
use crate::solver::Solver;
use crate::{Record, Scalar, SolveError};

/// A change point close to a pose, along a direction, in parts of it.
#[derive(Clone, Copy, Debug)]
struct Nearby {
    at: f64,
    /// Where the solver's own rounding is as small as an interpolation's error, from there.
    width: f64,
}

/// The change point next to the beginning of a line, if rounding shows there: of the first group
/// that has one.
fn nearby<M: Solver>(line: &Line<M>, solver: &M, zone: Zone) -> Option<Nearby> {
    (0..M::TITLES.groups.len()).find_map(|group| nearby_of(line, solver, group, zone))
}

/// The lowest place of a group's clearance by Newton's method from the beginning of the line, which
/// is close to it if there is one: within `near` the clearance is a parabola but for a few percent.
fn nearby_of<M: Solver>(line: &Line<M>, solver: &M, group: usize, zone: Zone) -> Option<Nearby> {
    let (zero, near) = (Thresholds::of::<M::Scalar>().zero, zone.near::<M::Scalar>());
    let mut here = line.reading(solver, 0.0, group);
    if !here.is_below(near) {
        return None;
    }
    let mut at = 0.0;
    // A distance whose square was `near` is less than half with every turn, where there is a change
    // point at all, and its square `zero` in the end: 13 halvings of the square in `f64`.
    for _ in 0..16 {
        let off = here.rate / here.second_rate;
        let above = 0.5 * here.rate * off;
        if !(here.second_rate > 0.0 && off.is_finite()) {
            return None;
        }
        at -= off;
        if above <= zero * here.scale {
            let width = sqrt(2.0 * near * here.scale / here.second_rate);
            let is_change = (here.value - above).abs() <= zero * here.scale;
            let parabola = Parabola { at, second_rate: here.second_rate };
            let clearance = |part| line.reading(solver, part, group).value;
            let width = parabola.width(width, zone.reach(), clearance);
            return (is_change && at.abs() < width).then_some(Nearby { at, width });
        }
        here = line.reading(solver, at, group);
    }
    None
}

/// A clearance that is zero at its change point.
#[derive(Clone, Copy, Debug)]
struct Parabola {
    at: f64,
    second_rate: f64,
}

impl Parabola {
    /// The width, or the next of its halves at which the outermost nodes, `reach` widths away, find the
    /// clearance to be this parabola to a twentieth. Where the coordinates are large beside the bars, so
    /// is the scale of the clearance, and what is `near` in its units is anywhere.
    fn width(self, mut width: f64, reach: f64, clearance: impl Fn(f64) -> f64) -> f64 {
        let Self { at, second_rate } = self;
        let is_held = |width: f64| {
            let away = reach * width;
            let height = 0.5 * second_rate * away * away;
            [-away, away].iter().all(|away| (clearance(at + away) - height).abs() <= 0.05 * height)
        };
        // The exponents of numbers have no more steps.
        for _ in 0..f64::MAX_EXP {
            if width == 0.0 || is_held(width) {
                break;
            }
            width *= 0.5;
        }
        width
    }
}

/// The result at the end of the passage, if that is so close to a change point that rounding would
/// show: from those on both sides, each with the modes that hold there. None where the motion does
/// not go on so far on both sides.
///
/// Rounding is less at nodes that are farther from the change point, and a polynomial is closer through
/// nodes that are nearer. So the width is halved where the motion does not go on so far and, in a zone
/// that is refined, as long as that makes any number better.
///
/// # Errors
/// `NotFinite` where numbers of the results are finite, and combinations are not.
pub(super) fn interpolated<M: Solver, R: Record<Number = M::Scalar> + Copy>(
    passage: &Passage<M>,
    solver: &M,
    q: M::Input,
    direction: M::Input,
    zone: Zone,
    solve: &impl Fn(&M, M::Input) -> Result<R, SolveError>,
) -> Result<Option<R>, SolveError> {
    let line = Line::along(q, direction);
    let Some(nearby) = nearby(&line, solver, zone) else { return Ok(None) };
    let nodes = zone.nodes();
    let at = |part: f64| {
        let q = line.input(part);
        solve(&passage.to(q).follow()?, q)
    };
    let not_finite = SolveError::NotFinite { name: "the inputs" };
    let mut best: Option<Estimate<R>> = None;
    for width in [1.0, 0.5, 0.25, 0.125].map(|share| share * nearby.width) {
        let value = |node: f64| at(nearby.at + node * width);
        let found = match linear::interpolate(nodes, value, -nearby.at / width) {
            Ok(Some(found)) if found.result.all(Scalar::is_finite) => found,
            Ok(_) => return Err(not_finite),
            Err(error @ SolveError::NotFinite { .. }) => return Err(error),
            Err(_) => continue,
        };
        let (better, is_better) = best.map_or((found, true), |best| best.better(found));
        best = Some(better);
        if !(is_better && zone.is_refined()) {
            break;
        }
    }
    Ok(best.map(|best| best.result))
}

/// Inputs from which the motion comes to `q`, if that is the first pose: `q` itself, unless a
/// change point is near; else inputs on the same side of it along the rates, or ahead where `q` lies
/// on it, so far away that rounding does not show. None where the rates lead nowhere.
pub(super) fn beginning<M: Solver>(
    solver: &M,
    q: M::Input,
    rate: M::Input,
    zone: Zone,
) -> Option<M::Input> {
    let line = Line::along(q, rate);
    let here = Passage::new(*solver, q, q);
    let is_clear = here.ends_clear(solver);
    let itself = is_clear.then_some(q);
    let Some(Nearby { at, width }) = nearby(&line, solver, zone) else { return itself };
    let side = if is_clear && at > 0.0 { -2.0 } else { 2.0 };
    let other = line.input(at + side * width);
    // Nothing else may happen on the way there.
    let way = Passage::new(*solver, other, q);
    let ends = [way.ends_clear(solver), Passage::new(*solver, q, other).ends_clear(solver)];
    match (is_clear, ends) {
        (true, [true, true]) if way.is_quiet() => Some(other),
        (false, [_, true]) => Some(other),
        _ => itself,
    }
}
