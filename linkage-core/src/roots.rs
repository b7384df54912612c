//! Finds the root of an equation between two ends: the search behind [`find`](crate::find), whose
//! documentation has the method.

mod approach;
pub(crate) mod bound;
mod bracket;
mod cubic;
mod equation;
mod lowest;
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
#[cfg(all(test, feature = "page"))]
pub(crate) use survey::{judged, surveyed};

use crate::Real;
use crate::crossing::SEVERAL_DEAD_POINTS;
pub use crate::crossing::{Crossing, Trend};
use crate::shown::Digits;

/// A root that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Root<T = f64> {
    /// Where f is zero, with the derivatives that f's numbers carry.
    pub at: T,
    /// The number of evaluations of f.
    pub evaluations: u32,
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
        /// The missing distance there, in the unit of f.
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
/// interval is divided into up to 48 pieces for that. A function that turns back and forth within a piece
/// may lose a root; where the pieces do not tell, the error is [`FindError::SeveralDeadPoints`].
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
    /// The rounding error of f up to which an end counts as the root.
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
    pub fn find(&self, mut f: impl FnMut(T) -> [T; 2]) -> Result<Root<T>, FindError> {
        let [from, to] = self.between;
        let Some(approach) = Approach::new([from, to]) else {
            return Err(FindError::Interval { from: from.value(), to: to.value() });
        };
        let mut f = Equation::new(&mut f, self.trend);
        let at = match self
            .near
            .and_then(|seed| f.newton(seed, approach, approach.to - approach.from, None))
        {
            Some(at) => at,
            None => self.bracketed(&mut f, approach, false, &|_| self.slack)?,
        };
        f.differentiated(at)
    }
}
