//! What holds close around a change point: where it lies, results interpolated over it, and where
//! a motion that begins there comes from.

use super::line::Line;
use super::passage::Passage;
use super::{Linear, Thresholds, linear};
use crate::kernels::sqrt;
use crate::solver::Solver;
use crate::{Scalar, SolveError};

/// A change point close to a pose, along a direction, in parts of it.
#[derive(Clone, Copy, Debug)]
struct Nearby {
    at: f64,
    /// Where the solver's own rounding is as small as an interpolation's error, from there.
    width: f64,
}

/// The change point next to the beginning of a line, if rounding shows there: of the first group
/// that has one.
fn nearby<M: Solver>(line: &Line<M>, solver: &M) -> Option<Nearby> {
    (0..M::TITLES.groups.len()).find_map(|group| nearby_of(line, solver, group))
}

/// The lowest place of a group's clearance by Newton's method from the beginning of the line, which
/// is close to it if there is one: within `near` the clearance is a parabola but for a few percent.
fn nearby_of<M: Solver>(line: &Line<M>, solver: &M, group: usize) -> Option<Nearby> {
    let Thresholds { zero, near, .. } = Thresholds::of::<M::Scalar>();
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
            let lowest = here.value - above;
            let is_change = lowest.abs() <= zero * here.scale;
            return (is_change && at.abs() < width).then_some(Nearby { at, width });
        }
        here = line.reading(solver, at, group);
    }
    None
}

/// Where the nodes of an interpolation stand on both sides of a change point, in units of its
/// width.
const NODES: [f64; 8] = [-2.5, 2.5, -2.0, 2.0, -1.5, 1.5, -1.0, 1.0];

/// The result at the end of the passage, if that is so close to a change point that rounding would
/// show: from those on both sides, each with the modes that hold there. None where the motion does
/// not go on so far on both sides.
///
/// # Errors
/// `NotFinite` where numbers of the results are finite, and combinations are not.
pub(super) fn interpolated<M: Solver, R: Linear<M::Scalar>>(
    passage: &Passage<M>,
    solver: &M,
    q: M::Input,
    direction: M::Input,
    solve: &impl Fn(&M, M::Input) -> Result<R, SolveError>,
) -> Result<Option<R>, SolveError> {
    let line = Line::along(q, direction);
    let Some(nearby) = nearby(&line, solver) else { return Ok(None) };
    let at = |part: f64| {
        let q = line.input(part);
        solve(&passage.to(q).follow()?, q)
    };
    let not_finite = SolveError::NotFinite { name: "the inputs" };
    for width in [1.0, 0.5, 0.25].map(|share| share * nearby.width) {
        let value = |node: f64| at(nearby.at + node * width);
        match linear::interpolate(NODES, value, -nearby.at / width) {
            Ok(Some(result)) if result.all(Scalar::is_finite) => return Ok(Some(result)),
            Ok(_) => return Err(not_finite),
            Err(error @ SolveError::NotFinite { .. }) => return Err(error),
            Err(_) => {}
        }
    }
    Ok(None)
}

/// Inputs from which the motion comes to `q`, if that is the first pose: `q` itself, unless a
/// change point is near; else inputs on the same side of it along the rates, or ahead where `q` lies
/// on it, so far away that rounding does not show. None where the rates lead nowhere.
pub(super) fn beginning<M: Solver>(solver: &M, q: M::Input, rate: M::Input) -> Option<M::Input> {
    let line = Line::along(q, rate);
    let here = Passage::new(*solver, q, q);
    let is_clear = here.ends_clear(solver);
    let itself = is_clear.then_some(q);
    let Some(Nearby { at, width }) = nearby(&line, solver) else { return itself };
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
