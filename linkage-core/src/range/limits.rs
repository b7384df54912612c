//! The stretches of an input over which a mechanism can be assembled.
//!
//! Group by group in solving order: each group's clearance, which generated code gives with its
//! rate, is walked over the stretches that the groups before it leave. Next to the limit of a
//! group before it a clearance goes with the square root of the input, so a stretch is walked in
//! a number u of which the input is a cubic with a double root at each such end: in u everything
//! is smooth.
//!
//! Clearances do not show a negative length, nor the square root of a negative number in a dimension:
//! the solver itself reports these at the end (`confirm`).

use super::chart::Chart;
use super::confirm::confirm;
use super::panels::Panels;
use super::walk::{Event, Walk};
use super::{End, RangeError, Stop, Stretch, Stretches};
use crate::kernels::sqrt;
use crate::roots::{Approach, At, constant, magnitude, number};
use crate::solver::Solver;
use crate::{Real, SolveError};

/// The stretches of the input between two ends over which the mechanism can be assembled in its
/// modes, in rising order; none where it cannot be assembled at all.
///
/// Every pose within a stretch is assembled, the one at a [`Stop::Limit`] included. A stretch also
/// ends at a change point, where the next one begins: in the modes given the machine goes on, but
/// its motion does not. At the end of the input's interval that is on a limit itself the stop is
/// that limit.
///
/// ```
/// use linkage_core::mechanism;
/// use linkage_core::range::{Stop, limits};
///
/// mechanism! {
///     struct FourBar {
///         input theta: angle;
///         param coupler = 3m;
///         ground A(0, 0), D(4m, 0);
///         crank AB(A) -> B        { length: 2m, angle: theta }
///         rrr   BC(B), DC(D) -> C { lengths: (coupler, 2.5m), mode: left }
///     }
/// }
///
/// use core::f64::consts::PI;
/// let stretches = limits(&FourBar::new(), [-PI, PI])?;
/// // Coupler and rocker stretch out where the crank points away from the rocker's pivot.
/// assert_eq!(stretches.len(), 1);
/// assert_eq!(stretches[0].to.stop, Stop::Limit { group: "BC, DC" });
/// let cos = (2.0 * 2.0 + 4.0 * 4.0 - 5.5 * 5.5) / (2.0 * 2.0 * 4.0);
/// assert!((stretches[0].to.at - f64::acos(cos)).abs() < 1e-15);
/// // A longer coupler lets the crank turn fully.
/// assert!(limits(&FourBar { coupler: 3.9 }, [-PI, PI])?.is_whole());
/// # Ok::<(), linkage_core::range::RangeError>(())
/// ```
///
/// A group of guides alone (`prp`, `rpp`) is never out of reach; where its guides become parallel
/// it has no pose at that one input, which is not looked for.
///
/// # Errors
/// See [`RangeError`]; the solver's error where a parameter is not finite or a length is not
/// above zero at any input.
pub fn limits<T: Real, M: Solver<Scalar = T, Input = T>>(
    solver: &M,
    between: [T; 2],
) -> Result<Stretches<T>, RangeError> {
    let [from, to] = between;
    if Approach::new(between).is_none() {
        return Err(RangeError::Interval { from: from.value(), to: to.value() });
    }
    let edge = |at| End { at: constant(at), stop: Stop::Edge };
    let mut stretches = Stretches::new();
    stretches.push(edge(from), edge(to))?;
    for group in 0..M::TITLES.groups.len() {
        let mut rest = Stretches::new();
        for stretch in &stretches {
            of_group(solver, group, stretch, &mut rest)?;
        }
        stretches = rest;
    }
    let mut confirmed = Stretches::new();
    for stretch in &stretches {
        confirm(solver, stretch, &mut confirmed)?;
    }
    if confirmed.is_empty() {
        // Out of reach everywhere is an answer; a parameter that is at fault is not.
        let middle = constant(from + (to - from) * number(0.5));
        let refusal = solver.position(middle).err();
        if let Some(error @ (SolveError::Invalid { .. } | SolveError::NotFinite { .. })) = refusal {
            return Err(error.into());
        }
    }
    Ok(confirmed)
}

/// Adds the parts of a stretch in which a group can be assembled to `rest`.
fn of_group<T: Real, M: Solver<Scalar = T, Input = T>>(
    solver: &M,
    group: usize,
    stretch: &Stretch<T>,
    rest: &mut Stretches<T>,
) -> Result<(), RangeError> {
    let title = M::TITLES.groups.get(group).map_or("", |of| of.0);
    let limit = |at| End { at, stop: Stop::Limit { group: title } };
    let (chart, ends) = (Chart::of(stretch), Chart::ends(stretch));
    let nan = number::<T>(f64::NAN);
    let clearance = |u: T| {
        let (q, rate) = chart.at(u);
        let clearances = solver.clearances(q, rate);
        clearances.as_ref().get(group).map_or([nan; 3], |of| [of.value, of.rate, of.scale])
    };
    let [.., scale] = clearance(number(0.5));
    let scale = constant(scale);
    let f = |u| {
        let [value, rate, _] = clearance(u);
        // An equation with several dead points may have a root where its ends show none.
        let is_contradicted = M::SEARCHES
            && number::<T>(-64.0 * <T as Real>::EPSILON).gt(value / scale)
            && solver.position(constant(chart.at(u).0)).is_ok();
        if is_contradicted { [nan; 2] } else { [value / scale, rate / scale] }
    };
    let mut walk = Walk { f, zero: number(64.0 * <T as Real>::EPSILON), ends };
    let (Ok(first), Ok(last)) = (walk.at(ends[0]), walk.at(ends[1])) else {
        // The solver itself gives the reason for the NaN (`confirm`).
        return rest.push(stretch.from, stretch.to);
    };
    let kept = *rest;
    let mut open = walk.is_positive(first).then_some(edge_at_limit(stretch.from, first, title));
    let mut pushed = Ok(());
    let panels = Panels::over(stretch.width().value());
    let walked = walk.events(panels, |event| {
        let [close, reopen] = match event {
            Event::Falls(u) => [Some(limit(chart.at(u).0)), None],
            Event::Rises(u) => [None, Some(limit(chart.at(u).0))],
            Event::Touches(u) => {
                let end = End { at: chart.at(u).0, stop: Stop::ChangePoint { group: title } };
                [Some(end); 2]
            }
        };
        if let (Some(from), Some(to)) = (open, close) {
            pushed = pushed.and(rest.push(from, to));
        }
        open = reopen;
    });
    if walked.is_err() {
        *rest = kept;
        return rest.push(stretch.from, stretch.to);
    }
    if let Some(from) = open {
        let to = edge_at_limit(stretch.to, last, title);
        pushed = pushed.and(rest.push(from, to));
    }
    pushed
}

/// The end of the interval, or the limit that it lies on.
fn edge_at_limit<T: Real>(end: End<T>, at: At<T>, group: &'static str) -> End<T> {
    let zero = number::<T>(64.0 * <T as Real>::EPSILON);
    if !end.is_edge() || magnitude(at.value).gt(zero) {
        return end;
    }
    // Where the value is zero to rounding, so is the slope at a change point.
    let flat = number::<T>(sqrt(64.0 * <T as Real>::EPSILON));
    let is_flat = flat.ge(magnitude(at.slope));
    let stop = if is_flat { Stop::ChangePoint { group } } else { Stop::Limit { group } };
    End { stop, ..end }
}
