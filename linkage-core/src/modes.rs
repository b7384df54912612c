//! The assembly modes a declaration chooses between, and a parameter may carry.
//!
//! Only the two choices and their signs live here; what a sign means to a group is said where the
//! group's equations are.

use crate::Scalar;

/// On which side the inner joint of an `rrr` group lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// Left of the line from the first outer joint to the second, looking along it.
    Left,
    /// Right of that line.
    Right,
}

/// Which way along a sliding direction a group is assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Sense {
    /// Further along the positive direction.
    Ahead,
    /// Further along the negative direction.
    Behind,
}

impl Side {
    /// The other side.
    #[must_use]
    pub const fn flipped(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// +1 for left, −1 for right: the sign of the turn from the line to the inner joint,
    /// counter-clockwise positive.
    #[inline]
    #[must_use]
    pub fn sign<T: Scalar>(self) -> T {
        match self {
            Self::Left => T::lit(1.0, 1.0),
            Self::Right => T::lit(-1.0, -1.0),
        }
    }
}

impl Sense {
    /// The other sense.
    #[must_use]
    pub const fn flipped(self) -> Self {
        match self {
            Self::Ahead => Self::Behind,
            Self::Behind => Self::Ahead,
        }
    }

    /// +1 for ahead, −1 for behind.
    #[inline]
    #[must_use]
    pub fn sign<T: Scalar>(self) -> T {
        match self {
            Self::Ahead => T::lit(1.0, 1.0),
            Self::Behind => T::lit(-1.0, -1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mode_and_its_opposite_have_opposite_signs() {
        assert_eq!(Side::Left.sign::<f64>(), 1.0);
        assert_eq!(Side::Left.flipped().sign::<f32>(), -1.0);
        assert_eq!(Side::Right.flipped(), Side::Left);
        assert_eq!(Sense::Ahead.sign::<f64>(), 1.0);
        assert_eq!(Sense::Ahead.flipped().sign::<f32>(), -1.0);
        assert_eq!(Sense::Behind.flipped(), Sense::Ahead);
    }
}
