//! A root by its place and the sign of the slope there.

use crate::Scalar;

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

/// Where f passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Crossing {
    /// Which way.
    pub trend: Trend,
    /// The root.
    pub at: f64,
}

/// The text of the error of this name, for a root and for an unknown.
pub(crate) const SEVERAL_DEAD_POINTS: &str =
    "several dead points between the ends; narrow the interval";
