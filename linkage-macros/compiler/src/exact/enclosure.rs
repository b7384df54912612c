//! Enclosures: intervals that provably hold a real number.
//!
//! Both bounds are integers scaled by 2^bits. Every operation rounds its lower bound down and its
//! upper bound up, so that the result of true operands is enclosed by the result of enclosures.
//! Beside the rounding of constants they serve as the number of many digits against which floating
//! point is tested.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::rational::Rational;

/// An interval [lower, upper]·2^−bits.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Enclosure {
    pub(super) lower: BigInt,
    pub(super) upper: BigInt,
    pub(super) bits: u32,
}

impl Enclosure {
    /// The fewest bits the functions of an angle work with.
    pub(crate) const MIN_BITS: u32 = 64;

    pub fn new(lower: BigInt, upper: BigInt, bits: u32) -> Self {
        assert!(lower <= upper && bits >= Self::MIN_BITS);
        Self { lower, upper, bits }
    }

    /// All numbers within `error` of `middle`, in units of 2^−bits.
    pub(super) fn around(middle: &BigInt, error: &BigInt, bits: u32) -> Self {
        Self::new(middle - error, middle + error, bits)
    }

    /// The number `value`·2^−bits itself.
    pub(super) fn point(value: BigInt, bits: u32) -> Self {
        Self::new(value.clone(), value, bits)
    }

    pub fn integer(value: i64, bits: u32) -> Self {
        Self::point(BigInt::from(value) << bits, bits)
    }

    pub fn rational(value: &Rational, bits: u32) -> Self {
        let (quotient, remainder) = (value.numerator() << bits).div_mod_floor(&value.denominator());
        let upper = if remainder.is_zero() { quotient.clone() } else { &quotient + 1 };
        Self::new(quotient, upper, bits)
    }

    pub fn bits(&self) -> u32 {
        self.bits
    }

    pub fn lower(&self) -> &BigInt {
        &self.lower
    }

    pub fn upper(&self) -> &BigInt {
        &self.upper
    }

    /// The enclosure in other units, rounded outward where they are coarser.
    pub fn with_bits(&self, bits: u32) -> Self {
        if bits >= self.bits {
            let shift = bits - self.bits;
            Self::new(&self.lower << shift, &self.upper << shift, bits)
        } else {
            let shift = self.bits - bits;
            Self::new(&self.lower >> shift, ceil_shift(&self.upper, shift), bits)
        }
    }

    /// The order against zero, where all of the enclosure agrees on it.
    pub fn sign(&self) -> Option<Ordering> {
        let (lower, upper) = (self.lower.cmp(&BigInt::zero()), self.upper.cmp(&BigInt::zero()));
        (lower == upper).then_some(lower)
    }

    pub fn neg(&self) -> Self {
        Self::new(-&self.upper, -&self.lower, self.bits)
    }

    pub fn add(&self, other: &Self) -> Self {
        self.aligned(other, |a, b| Self::new(&a.lower + &b.lower, &a.upper + &b.upper, a.bits))
    }

    pub fn sub(&self, other: &Self) -> Self {
        self.aligned(other, |a, b| Self::new(&a.lower - &b.upper, &a.upper - &b.lower, a.bits))
    }

    pub fn mul(&self, other: &Self) -> Self {
        self.aligned(other, |a, b| {
            let (lower, upper) = if !a.lower.is_negative() && !b.lower.is_negative() {
                (&a.lower * &b.lower, &a.upper * &b.upper)
            } else {
                let mut corners = [
                    &a.lower * &b.lower,
                    &a.lower * &b.upper,
                    &a.upper * &b.lower,
                    &a.upper * &b.upper,
                ];
                corners.sort_unstable();
                let [least, .., greatest] = corners;
                (least, greatest)
            };
            Self::new(lower >> a.bits, ceil_shift(&upper, a.bits), a.bits)
        })
    }

    /// The product with a rational, which is not enclosed first: a large factor does not magnify
    /// the error of a small one.
    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_one() {
            return self.clone();
        }
        let (numerator, denominator) = (factor.numerator(), factor.denominator());
        let (mut lower, mut upper) = (&self.lower * &numerator, &self.upper * &numerator);
        if numerator.is_negative() {
            core::mem::swap(&mut lower, &mut upper);
        }
        Self::new(lower.div_floor(&denominator), upper.div_ceil(&denominator), self.bits)
    }

    /// The product with an integer.
    pub(super) fn times(&self, factor: &BigInt) -> Self {
        let (lower, upper) = (&self.lower * factor, &self.upper * factor);
        let (lower, upper) = if factor.is_negative() { (upper, lower) } else { (lower, upper) };
        Self::new(lower, upper, self.bits)
    }

    /// The quotient, unless the divisor's enclosure holds zero.
    pub fn div(&self, divisor: &Self) -> Option<Self> {
        match divisor.sign()? {
            Ordering::Equal => None,
            Ordering::Less => self.neg().div(&divisor.neg()),
            Ordering::Greater => Some(self.aligned(divisor, |a, b| {
                let below = if a.lower.is_negative() { &b.lower } else { &b.upper };
                let above = if a.upper.is_negative() { &b.upper } else { &b.lower };
                Self::new(
                    (&a.lower << a.bits).div_floor(below),
                    (&a.upper << a.bits).div_ceil(above),
                    a.bits,
                )
            })),
        }
    }

    /// The root of what is not negative in the enclosure, unless all of it is.
    pub fn sqrt(&self) -> Option<Self> {
        if self.upper.is_negative() {
            return None;
        }
        let lower = self.lower.clone().max(BigInt::zero()) << self.bits;
        Some(Self::new(lower.sqrt(), ceil_sqrt(&(&self.upper << self.bits)), self.bits))
    }

    /// A point near the middle, and the distance from it that covers the enclosure.
    pub fn middle(&self) -> (BigInt, BigInt) {
        let middle: BigInt = (&self.lower + &self.upper) >> 1;
        let radius = &self.upper - &middle;
        (middle, radius)
    }

    pub fn widened(&self, by: &BigInt) -> Self {
        Self::new(&self.lower - by, &self.upper + by, self.bits)
    }

    /// The operation on both enclosures in the finer units of the two.
    fn aligned(&self, other: &Self, operation: impl Fn(&Self, &Self) -> Self) -> Self {
        match self.bits.cmp(&other.bits) {
            Ordering::Equal => operation(self, other),
            Ordering::Less => operation(&self.with_bits(other.bits), other),
            Ordering::Greater => operation(self, &other.with_bits(self.bits)),
        }
    }
}

/// value·2^−shift, rounded up; the shift of a negative number rounds down.
pub fn ceil_shift(value: &BigInt, shift: u32) -> BigInt {
    -(-value >> shift)
}

/// The least integer not below the root.
pub fn ceil_sqrt(value: &BigInt) -> BigInt {
    let root = value.sqrt();
    if &root * &root == *value { root } else { root + 1 }
}
