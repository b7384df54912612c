//! The comparisons of the fast path: where all of them hold, it answers.

use super::outward::OutwardInterval;
use super::width::Precision;
use crate::ir::check::Comparison;
use crate::ir::graph::Id;

/// A comparison of the fast path.
#[derive(Clone, Debug)]
pub enum Demand {
    /// A value against a threshold in double and in single precision, and against the rounding of a spread.
    Compare {
        value: Id,
        comparison: Option<(Comparison, [f64; 2])>,
        above_rounding: Option<Id>,
        /// Whose failure it is: an index into `Program::groups`.
        group: u32,
        /// True if it is the certificate of steps of Newton's method, of which intervals show nothing.
        certifies: bool,
    },
    /// The square of a hypotenuse against the least one in double and in single precision.
    Length { id: Id, least_square: [f64; 2] },
    /// An angle within the kernel's reach.
    Near(Id),
}

/// A box's answer to a demand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It holds for every pose of the box.
    Holds,
    /// No pose of the box has an answer: the value is below zero in all of them.
    Fails,
    /// Neither is shown.
    Open,
}

impl Demand {
    /// The values that it reads.
    pub(crate) fn reads(&self) -> impl Iterator<Item = Id> {
        let (value, spread) = match *self {
            Self::Compare { value, above_rounding, .. } => (value, above_rounding),
            Self::Length { id, .. } => (id, None),
            Self::Near(angle) => (angle, None),
        };
        [value].into_iter().chain(spread)
    }

    /// The group whose unknowns are solved at once, where it certifies that.
    pub(crate) fn certified(&self) -> Option<u32> {
        match *self {
            Self::Compare { group, certifies: true, .. } => Some(group),
            _ => None,
        }
    }

    /// The answer of values over a box, as they are computed.
    pub(crate) fn verdict(
        &self,
        width: Precision,
        values: &dyn Fn(Id) -> OutwardInterval,
    ) -> Verdict {
        let (holds, fails) = match self {
            Self::Compare { value, comparison, above_rounding, .. } => {
                let value = values(*value);
                let threshold =
                    comparison.map(|(comparison, least)| (comparison, width.of_width(least)));
                let is_met = threshold.is_none_or(|(comparison, least)| match comparison {
                    Comparison::Above => value.low > least,
                    Comparison::AtLeast => value.low >= least,
                    Comparison::Away => value.least() > least,
                });
                // The spread's rounding is computed by a product of its own.
                let is_clear = above_rounding.is_none_or(|spread| {
                    let rounding =
                        values(spread).scaled(width.rounding() * (1.0 + width.epsilon()));
                    value.low > rounding.high
                });
                let is_away = matches!(threshold, Some((Comparison::Away, _)));
                (is_met && is_clear, value.high < 0.0 && !is_away)
            }
            Self::Length { id, least_square } => {
                let square = values(*id).square();
                // The sum of the squares is off by less than two last places.
                let share = 1.0 - 4.0 * width.epsilon();
                let is_met = square.low * share > width.of_width(*least_square);
                (is_met && square.high < width.largest() * share, false)
            }
            Self::Near(angle) => (values(*angle).magnitude() <= width.largest_angle(), false),
        };
        match (holds, fails) {
            (true, _) => Verdict::Holds,
            (_, true) => Verdict::Fails,
            _ => Verdict::Open,
        }
    }
}
