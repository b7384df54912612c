//! The root of an equation between two ends: which input puts an output where it is wanted.
//!
//! A solver answers where a mechanism stands at an input. The other question, at which input an
//! output has a wanted value, has no closed form as soon as there is a second group. It is one
//! scalar equation, f(x) = 0, whose slope the velocity solver gives exactly, and [`Search`] solves
//! it in a number of evaluations that is bounded beforehand ([`Search::MOST`]), whatever f does.
//!
//! # The method
//! 1. f and its slope at both ends. Where an end has the wrong sign because it lies beyond a dead
//!    point, it is moved towards that dead point until the sign is right. Where that is not enough, the
//!    interval is divided: into pieces in which a cubic shows that there is no root of the trend, or up
//!    to one that encloses a root.
//! 2. The first trial is the root of the cubic through values and slopes of both ends: at a dead
//!    point f has a double zero of its slope, which the cubic has too.
//! 3. Newton's steps, each projected onto an interval about the middle of the bracket that halves
//!    with every evaluation. This is what bounds their number: Oliveira and Takahashi, "An
//!    enhancement of the bisection method average performance preserving minmax optimality"
//!    (ITP), ACM Trans. Math. Softw. 47 (2021), with Newton's point in place of theirs.
//! 4. The step that will be below the tolerance is foreseen from the last two, and applied without
//!    an evaluation.
//!
//! With a seed ([`Search::near`]) up to three of Newton's steps come first, and if they converge,
//! nothing else does.
//!
//! Nothing here allocates, panics or knows of mechanisms.

mod approach;
pub(crate) mod bound;
mod bracket;
mod cubic;
mod equation;
mod lowest;
mod output;
pub(crate) mod seed;
mod start;
mod survey;
#[cfg(test)]
mod tests;
pub(crate) mod unknown;

use core::fmt;

pub(crate) use approach::Approach;
pub(crate) use approach::{At, constant, greater, less, magnitude, number};
pub(crate) use cubic::Cubic;
use equation::Equation;
pub(crate) use equation::{crossing, differentiated};
pub(crate) use lowest::lowest;
pub use output::OutputError;
pub(crate) use output::no_output;

use crate::shown::Digits;
use crate::{Real, Scalar};

/// The sign of the slope that f has at the wanted root. Like an assembly mode it is a choice
/// between two answers that come together at a dead point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Trend {
    /// f rises through zero.
    Rising,
    /// f falls through zero.
    Falling,
}

impl Trend {
    /// The other trend.
    #[must_use]
    pub const fn flipped(self) -> Self {
        match self {
            Self::Rising => Self::Falling,
            Self::Falling => Self::Rising,
        }
    }

    /// `rising` or `falling`.
    pub(crate) const fn participle(self) -> &'static str {
        match self {
            Self::Rising => "rising",
            Self::Falling => "falling",
        }
    }

    /// `rises` or `falls`.
    pub(crate) const fn verb(self) -> &'static str {
        match self {
            Self::Rising => "rises",
            Self::Falling => "falls",
        }
    }

    /// +1 for rising, −1 for falling.
    #[inline]
    #[must_use]
    pub fn sign<T: Scalar>(self) -> T {
        match self {
            Self::Rising => T::lit(1.0, 1.0),
            Self::Falling => T::lit(-1.0, -1.0),
        }
    }
}

/// A root that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Root<T = f64> {
    /// Where f is zero, with the derivatives that f's numbers carry.
    pub at: T,
    /// How often f was evaluated.
    pub evaluations: u32,
}

/// Where f passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Crossing {
    /// Which way.
    pub trend: Trend,
    /// The root.
    pub at: f64,
}

/// Why no root was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum FindError {
    /// The ends are not two finite numbers in rising order, or too far apart for their distance
    /// to be a number.
    Interval {
        /// The lower end as given.
        from: f64,
        /// The upper end as given.
        to: f64,
    },
    /// f keeps its sign between the ends, or passes zero against the trend alone.
    NoSolution {
        /// The end, or the dead point, at which f comes nearest to a root of the trend; of several dead
        /// points the nearest of those that were met.
        at: f64,
        /// How much is missing there, in the unit of f.
        by: f64,
        /// Where f passes zero against the trend, if it does.
        other: Option<Crossing>,
    },
    /// f has more than one dead point between the ends, and its samples tell neither a root nor that there
    /// is none; or f is not smooth there.
    SeveralDeadPoints,
    /// f is not a finite number here: the mechanism cannot be assembled, say.
    NotFinite {
        /// The trial.
        at: f64,
    },
    /// The root has no derivative: f has no slope there.
    Singular {
        /// The root.
        at: f64,
    },
}

impl fmt::Display for FindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Interval { from, to } => {
                write!(f, "{from} to {to} is no interval of finite numbers in rising order")
            }
            Self::NoSolution { at, by, other: None } => {
                let by = Digits(by);
                write!(f, "no solution between the ends: {by} is missing at {at}")
            }
            Self::NoSolution { other: Some(Crossing { trend, at }), .. } => {
                let (wanted, found) = (trend.flipped().participle(), trend.verb());
                write!(f, "no {wanted} root; it {found} through zero at {}", Digits(at))
            }
            Self::SeveralDeadPoints => f.write_str(SEVERAL_DEAD_POINTS),
            Self::NotFinite { at } => write!(f, "the equation is not a number at {at}"),
            Self::Singular { at } => write!(f, "the solution at {at} has no derivative"),
        }
    }
}

impl core::error::Error for FindError {}

/// The text of the error of this name, for a root and for an unknown.
pub(crate) const SEVERAL_DEAD_POINTS: &str =
    "several dead points between the ends; narrow the interval";

/// Where to look for a root, and for which.
///
/// ```
/// use linkage_core::find::{Search, Trend};
/// use linkage_core::mechanism;
///
/// mechanism! {
///     struct Press {
///         input theta: angle;
///         ground A(0, 0);
///         guide bed through (0, 0) along 0deg;
///         crank AB(A) -> B           { length: 80mm, angle: theta }
///         rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
///         output ram.slide;
///     }
/// }
///
/// // The crank's angle that puts the ram at 260 mm on its way back.
/// let press = Press::new();
/// let root = Search::new([0.0, core::f64::consts::PI], Trend::Falling).find(|theta| {
///     let at = press.motion(theta, 1.0, 0.0).expect("the crank turns fully");
///     [at.position.ram.slide - 0.26, at.velocity.ram.slide]
/// })?;
/// let slide = press.position(root.at).expect("the crank turns fully").ram.slide;
/// assert!((slide - 0.26).abs() < 1e-15);
/// assert!(root.evaluations <= 8);
/// # Ok::<(), linkage_core::find::FindError>(())
/// ```
///
/// f is to be smooth between the ends; a closure says that it is undefined at a trial by a value
/// that is not a number. Where f has several roots of one trend, one of them is found, the same at
/// each call: which one is not promised.
///
/// Dead points between the ends do no harm: a root of the trend is found behind them and between them. The
/// interval is divided into up to 48 pieces for that. What turns back and forth within a piece may be
/// missed; where the pieces do not tell, the error is [`FindError::SeveralDeadPoints`].
///
/// A root is right to ε/2 of the larger end, or as far as f's own rounding lets its sign be known.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Search<T = f64> {
    /// The ends, lower first.
    pub between: [T; 2],
    /// The sign of the slope at the root.
    pub trend: Trend,
    /// Where the root is expected. Three steps of Newton's method are tried from there; their
    /// answer is taken if they converge, inside, to a root of the trend.
    pub near: Option<T>,
    /// How far f may miss zero by its rounding, at an end, for the end to be the root.
    pub slack: T,
}

impl<T: Real> Search<T> {
    /// The most evaluations between any two ends: 61 in `f64`, 32 in `f32`. Twice as many where an
    /// end lies beyond a dead point, as many where there is no root, 3 more with a seed; numbers that
    /// carry derivatives take one more for each order.
    pub const MOST: u32 = 2 + approach::most::<T>();

    /// A search without a seed and without slack.
    #[must_use]
    pub fn new(between: [T; 2], trend: Trend) -> Self {
        Self { between, trend, near: None, slack: T::lit(0.0, 0.0) }
    }

    /// The same with a seed: the root of the last call, or better where it is expected to have
    /// moved since.
    #[must_use]
    pub fn near(self, seed: T) -> Self {
        Self { near: Some(seed), ..self }
    }

    /// The same with slack, in the unit of f.
    #[must_use]
    pub fn slack(self, slack: T) -> Self {
        Self { slack, ..self }
    }

    /// The root of f, which gives its value and its slope.
    ///
    /// # Errors
    /// See [`FindError`].
    pub fn find(&self, f: impl FnMut(T) -> [T; 2]) -> Result<Root<T>, FindError> {
        let [from, to] = self.between;
        let Some(approach) = Approach::new([from, to]) else {
            return Err(FindError::Interval { from: from.value(), to: to.value() });
        };
        let mut f = Equation::new(f, self.trend);
        let at = match self
            .near
            .and_then(|seed| f.newton(seed, approach, approach.to - approach.from))
        {
            Some(at) => at,
            None => self.bracketed(&mut f, approach, |_| self.slack)?,
        };
        f.differentiated(at)
    }
}
