//! The range of motion of a machine: the inputs at which it can be assembled, and the extremes of an
//! output.
//!
//! [`limits`] finds the stretches of an input over which a mechanism of one input can be assembled
//! in its modes, with the group that ends each of them. [`extrema`] finds where any output turns
//! back: stroke, limits of a rocker, largest velocity.
//!
//! Both are searches by the solver's exact rates, without a heap, for start-up and for design: a
//! turn of a four-bar takes 33 evaluations of its clearance and at most some 25 more for its
//! limits, and 33 poses that confirm each stretch. An interval of several turns takes as many for each
//! turn.
//!
//! They are no proof. The interval is walked in panels of a sixteenth of it, and of no more than 0.4, a
//! sixteenth of a turn: a change within a panel that its ends and its middle do not show is missed.
//! Behind the first 34 turns (214 rad) the rest is walked in sixteen panels, however long: a function that
//! repeats with every turn has, in the first 34, either no zero or more than the 32 that an answer may have.

mod chart;
mod confirm;
mod extrema;
mod extrema_of;
mod limits;
mod panels;
#[cfg(test)]
mod tests;
mod walk;

use core::fmt;
use core::ops::Deref;

pub use extrema::{Extrema, Extremum, Turn, extrema};
pub use extrema_of::extrema_of;
pub use limits::limits;

use crate::find::no_output;
use crate::{Real, SolveError};

/// Why a stretch of the input ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Stop {
    /// The search was asked to go no further.
    Edge,
    /// A group is at its limit and cannot be assembled beyond.
    Limit {
        /// The links of the group.
        group: &'static str,
    },
    /// A group is at its limit and can be assembled on both sides: there its modes come together,
    /// and a motion goes on in the other one.
    ChangePoint {
        /// The links of the group.
        group: &'static str,
    },
}

/// An end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct End<T = f64> {
    /// The input, with the derivatives that the solver's numbers carry.
    pub at: T,
    /// Why it is the end.
    pub stop: Stop,
}

impl<T> End<T> {
    /// True if the search was asked to go no further, and the machine may.
    #[must_use]
    pub const fn is_edge(&self) -> bool {
        matches!(self.stop, Stop::Edge)
    }
}

/// Inputs at all of which the mechanism can be assembled in its modes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Stretch<T = f64> {
    /// The lower end.
    pub from: End<T>,
    /// The upper end.
    pub to: End<T>,
}

/// Stretches in rising order: a slice without a heap.
#[derive(Clone, Copy)]
pub struct Stretches<T = f64> {
    list: [Stretch<T>; MOST],
    count: usize,
}

/// More stretches than this, or more extremes, are no answer.
const MOST: usize = 32;

/// Why a range was not found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum RangeError {
    /// The ends are not two finite numbers in rising order, or too far apart for their distance
    /// to be a number.
    Interval {
        /// The lower end as given.
        from: f64,
        /// The upper end as given.
        to: f64,
    },
    /// There are more than 32.
    TooMany,
    /// The mechanism has no output of the name that was given to [`extrema_of`].
    NoOutput {
        /// The names of its outputs: [`Mechanism::OUTPUTS`](crate::Mechanism::OUTPUTS).
        outputs: &'static [&'static str],
    },
    /// The solver's error: of [`limits`] where a parameter lets no pose be solved, of [`extrema`]
    /// where one on the way is none.
    Solve(SolveError),
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Interval { from, to } => {
                write!(f, "{from} to {to} is no interval of finite numbers in rising order")
            }
            Self::NoOutput { outputs } => no_output(outputs, f),
            Self::TooMany => write!(f, "more than {MOST} stretches or extremes"),
            Self::Solve(ref error) => error.fmt(f),
        }
    }
}

impl core::error::Error for RangeError {}

impl From<SolveError> for RangeError {
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl Stop {
    /// The group that ends the stretch, if one does.
    #[must_use]
    pub const fn group(self) -> Option<&'static str> {
        match self {
            Self::Edge => None,
            Self::Limit { group } | Self::ChangePoint { group } => Some(group),
        }
    }
}

impl<T: Real> Stretch<T> {
    /// The width of the stretch, in the unit of the input.
    #[must_use]
    pub fn width(&self) -> T {
        self.to.at - self.from.at
    }
}

impl<T: Real> Stretches<T> {
    /// True if the mechanism can be assembled at every input between the given ends.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        matches!(&**self, [only] if only.from.is_edge() && only.to.is_edge())
    }

    fn new() -> Self {
        let end = End { at: T::lit(0.0, 0.0), stop: Stop::Edge };
        Self { list: [Stretch { from: end, to: end }; MOST], count: 0 }
    }

    /// Adds a stretch that is not empty.
    fn push(&mut self, from: End<T>, to: End<T>) -> Result<(), RangeError> {
        if !to.at.gt(from.at) {
            return Ok(());
        }
        let place = self.list.get_mut(self.count).ok_or(RangeError::TooMany)?;
        *place = Stretch { from, to };
        self.count += 1;
        Ok(())
    }
}

impl<T> Deref for Stretches<T> {
    type Target = [Stretch<T>];

    fn deref(&self) -> &[Stretch<T>] {
        self.list.get(..self.count).unwrap_or(&[])
    }
}

/// As the slice that it is.
impl<T: fmt::Debug> fmt::Debug for Stretches<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

impl<'a, T> IntoIterator for &'a Stretches<T> {
    type Item = &'a Stretch<T>;
    type IntoIter = core::slice::Iter<'a, Stretch<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// As the slice that it is.
#[cfg(feature = "serde")]
impl<T: serde::Serialize> serde::Serialize for Stretches<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}
