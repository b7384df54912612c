//! The lowest point of a function between two places where it falls and rises: a dead point.

use super::FindError;
use super::approach::{Approach, At, SPARE, Slopes, Trial, most, number};
use super::cubic::Cubic;
use crate::Real;

/// Evaluations that find the value of a dead point to rounding however the search goes on: its place is
/// known to √ε after half as many halvings as a root takes, and there the value is flat.
pub(super) const fn dead_point_most<T: Real>() -> u32 {
    most::<T>() / 2 + SPARE
}

/// The lowest point between an end where the function falls and one where it rises, or the first
/// place found below `floor`. At most `most` samples, and one more.
///
/// It is the root of the slope, whose own slope is the secant of the last two: with exact second
/// derivatives the search for a set-point beyond a dead point would take 3 % fewer evaluations,
/// each of which would cost more.
pub(crate) fn lowest<T: Real>(
    [a, b]: [At<T>; 2],
    floor: T,
    most: u32,
    sample: &mut dyn FnMut(T) -> Result<At<T>, FindError>,
) -> Result<At<T>, FindError> {
    let Some(approach) = Approach::new([a.x, b.x]) else { return Ok(a) };
    // The slope's own rate at the ends is unknown and not needed.
    let slope_at = |at: At<T>| At { x: at.x, value: at.slope, slope: number(0.0) };
    let start = a.x + (b.x - a.x) * Cubic::through([a, b]).turning_part();
    let mut last = a;
    let trial = |x| {
        let at = sample(x)?;
        let secant = (at.slope - last.slope) / (at.x - last.x);
        last = at;
        let slope = At { x, value: at.slope, slope: secant };
        Ok(Trial { at: slope, is_enough: floor.gt(at.value) })
    };
    let found = approach.close_in([a, b].map(slope_at), start, Slopes::Secant, most, trial)?.x();
    if found.value() == last.x.value() { Ok(last) } else { sample(found) }
}
