//! Sums, differences and squares carried to twice the working width.
//!
//! A double word is a number as a sum of an exact constant, a rounded number, and what rounding
//! took from that. The rounding error of a sum or a square is itself a number of the working width
//! (O. Møller, Quasi double-precision in floating point addition; T. J. Dekker, A floating-point
//! technique for extending the available precision), and the low word of a constant is known.
//! What is left out is of the second order: a difference of double words that cancels keeps an
//! error of a few ε² of what cancels in it, where the working width alone would keep ε.

use std::ops::{Add, Neg, Sub};

use crate::equations::symbol::{Sym, Vector};

/// constant + high + low.
#[derive(Clone, Copy)]
pub(super) struct DoubleWord<'s> {
    /// Known exactly, its low word with it; constants are added up before anything is rounded.
    constant: Sym<'s>,
    /// Not a constant, except that it is zero where the number is one.
    high: Sym<'s>,
    low: Sym<'s>,
}

impl<'s> DoubleWord<'s> {
    /// A number of the working width, or a constant with all its digits.
    pub(super) fn of(value: Sym<'s>) -> Self {
        let zero = value.builder().zero();
        if value.is_constant() {
            Self { constant: value, high: zero, low: zero }
        } else {
            Self { constant: zero, high: value, low: zero }
        }
    }

    /// A sum or a difference with the rounding errors of its additions put back.
    pub(super) fn of_sum(value: Sym<'s>) -> Self {
        match value.terms() {
            Some([a, b]) => Self::of_sum(a) + Self::of_sum(b),
            None => Self::of(value),
        }
    }

    /// A coordinate. Where it is the difference of coordinates that are given, as inputs or as
    /// dimensions, its rounding is put back; where they were themselves rounded, as a crank's pin
    /// is, one rounding more of the same size is left as it is.
    pub(super) fn of_coordinate(value: Sym<'s>) -> Self {
        if value.is_sum_of_given() { Self::of_sum(value) } else { Self::of(value) }
    }

    /// x² + y² of a vector.
    pub(super) fn square_of(vector: Vector<'s>, word: fn(Sym<'s>) -> Self) -> Self {
        word(vector.x).squared() + word(vector.y).squared()
    }

    pub(super) fn squared(self) -> Self {
        let (high, low) = self.words();
        let square = Self::of(high.squared());
        if high.is_constant() {
            return square;
        }
        Self { low: high.mul_err(high) + (high * low).twice(), ..square }
    }

    /// The number rounded, and what that took from it.
    fn words(self) -> (Sym<'s>, Sym<'s>) {
        let Self { constant, high, low } = self;
        let error = constant.add_err(high) + (constant.low() + low);
        (constant + high, error)
    }

    /// self − other as one number, its error relative to itself.
    pub(super) fn difference(self, other: Self) -> Sym<'s> {
        let constant = self.constant - other.constant;
        // The difference of two numbers that nearly cancel has no error (Sterbenz), and of others
        // one relative to itself; only of three terms can two leave an error larger than the sum.
        let Self { constant, high, low } = if constant.is_zero() {
            Self { constant, high: self.high - other.high, low: self.low - other.low }
        } else {
            self - other
        };
        if high.is_constant() {
            return constant + high;
        }
        (constant + high) + (constant.low() + low)
    }
}

impl Add for DoubleWord<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = self.high + other.high;
        let low = self.high.add_err(other.high) + (self.low + other.low);
        Self { constant: self.constant + other.constant, high, low }
    }
}

impl Neg for DoubleWord<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { constant: -self.constant, high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleWord<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
