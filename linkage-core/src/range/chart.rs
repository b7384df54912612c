//! A stretch of the input as it is walked: in a number in which clearances are smooth up to limits.

use super::{End, Stop, Stretch};
use crate::Real;
use crate::kernels::sqrt;
use crate::roots::number;

/// The input over a stretch as a cubic in u from 0 to 1, which begins and ends with a square where
/// the stretch does at a limit.
#[derive(Clone, Copy)]
pub(super) struct Chart<T> {
    from: T,
    width: T,
    is_square: [bool; 2],
}

impl<T: Real> Chart<T> {
    pub(super) fn of(stretch: &Stretch<T>) -> Self {
        let is_square =
            [stretch.from, stretch.to].map(|end| matches!(end.stop, Stop::Limit { .. }));
        Self { from: stretch.from.at, width: stretch.width(), is_square }
    }

    /// The input, and its rate by u.
    pub(super) fn at(self, u: T) -> (T, T) {
        let [one, two, three] = [1.0, 2.0, 3.0].map(number::<T>);
        let (part, rate) = match self.is_square {
            [false, false] => (u, one),
            [true, false] => (u * u, two * u),
            [false, true] => (u * (two - u), two * (one - u)),
            [true, true] => (u * u * (three - two * u), number::<T>(6.0) * u * (one - u)),
        };
        (self.from + self.width * part, self.width * rate)
    }

    /// Where to begin and to stop: next to a limit the groups behind it have no digits. At this
    /// distance they have lost three quarters of them to it.
    pub(super) fn ends(stretch: &Stretch<T>) -> [T; 2] {
        let quarter = sqrt(sqrt(<T as Real>::EPSILON));
        let aside = |end: End<T>| match end.stop {
            Stop::Edge => 0.0,
            // ε^(3/8), whose square is how clear of its limit the group before is.
            Stop::Limit { .. } | Stop::ChangePoint { .. } => quarter * sqrt(quarter),
        };
        [number(aside(stretch.from)), number(1.0 - aside(stretch.to))]
    }
}
