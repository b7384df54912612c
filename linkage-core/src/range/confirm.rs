//! Confirmation, by the solver, of a stretch that its clearances allow.
//!
//! The stretch is sampled, and where there is no pose, its end is moved to the last input at which
//! there is one: by rounding at a limit, and elsewhere to where a dimension is none any more.

use super::chart::Chart;
use super::panels::Panels;
use super::{End, RangeError, Stop, Stretch, Stretches};
use crate::roots::{constant, number};
use crate::solver::Solver;
use crate::{Real, SolveError};

/// Halvings between an input with a pose and one without: until they are neighbours, but next to
/// zero.
const HALVINGS: u32 = 64;

/// Adds what the solver leaves of a stretch.
pub(super) fn confirm<T: Real, M: Solver<Scalar = T, Input = T>>(
    solver: &M,
    stretch: &Stretch<T>,
    to: &mut Stretches<T>,
) -> Result<(), RangeError> {
    let chart = Chart::of(stretch);
    let mut last = Sample::of(solver, stretch.from);
    let mut open = last.refusal.is_none().then_some(stretch.from);
    // Beside the beginning the middle and the end of each panel.
    let panels = Panels::over(stretch.width().value());
    for part in panels.ends().flat_map(|[end, long]| [end - 0.5 * long, end]) {
        let here = if part < 1.0 {
            let (at, _) = chart.at(number(part));
            Sample::of(solver, End { at, stop: Stop::Edge })
        } else {
            Sample::of(solver, stretch.to)
        };
        match (last.refusal, here.refusal) {
            (None, Some(_)) => {
                if let Some(from) = open.take() {
                    to.push(from, boundary(solver, last, here))?;
                }
            }
            (Some(_), None) => open = Some(boundary(solver, here, last)),
            _ => {}
        }
        last = here;
    }
    open.map_or(Ok(()), |from| to.push(from, stretch.to))
}

/// An input that was tried.
#[derive(Clone, Copy)]
struct Sample<T> {
    end: End<T>,
    /// Why there is no pose.
    refusal: Option<SolveError>,
}

impl<T: Real> Sample<T> {
    /// At a change point a pose may be undetermined although the machine can be assembled.
    fn of<M: Solver<Scalar = T, Input = T>>(solver: &M, end: End<T>) -> Self {
        let is_asked = !matches!(end.stop, Stop::ChangePoint { .. });
        let refusal = is_asked.then(|| solver.position(constant(end.at)).err()).flatten();
        Self { end, refusal }
    }
}

/// The last input with a pose on the way from one that has one to one that has none.
fn boundary<T: Real, M: Solver<Scalar = T, Input = T>>(
    solver: &M,
    with: Sample<T>,
    without: Sample<T>,
) -> End<T> {
    let (mut inside, mut outside) = (constant(with.end.at), constant(without.end.at));
    let mut refusal = without.refusal;
    for _ in 0..HALVINGS {
        let middle = inside + (outside - inside) * number(0.5);
        match solver.position(middle).err() {
            None => inside = middle,
            Some(error) => (outside, refusal) = (middle, Some(error)),
        }
    }
    let group = refusal.map_or("", SolveError::culprit);
    // The same limit, a rounding away: it moves with the dimensions as it did.
    // Byte by byte: comparing strings at once is a call to the C library.
    let is_same =
        matches!(without.end.stop, Stop::Limit { group: of } if of.bytes().eq(group.bytes()));
    let derivatives = without.end.at - constant(without.end.at);
    let at = if is_same { inside + derivatives } else { inside };
    End { at, stop: Stop::Limit { group } }
}
