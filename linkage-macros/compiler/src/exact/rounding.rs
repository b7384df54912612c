//! Correct rounding of rationals and fixed-point numbers to binary floats, ties to even.

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

use super::rational::Rational;

/// A binary floating-point format, whose numbers are a subset of f64's.
#[derive(Clone, Copy)]
pub struct Format {
    /// The bits of a normal number's significand.
    precision: i64,
    /// The exponent of the least positive number.
    least: i64,
    /// All finite numbers are below two to this exponent.
    above: i64,
}

pub const WIDE: Format = Format { precision: 53, least: -1074, above: 1024 };
pub(super) const NARROW: Format = Format { precision: NARROW_BITS, least: -149, above: 128 };

const NARROW_BITS: i64 = 24;

impl Format {
    /// The number of the format next to the rational.
    pub(super) fn round(self, value: &Rational) -> f64 {
        if let Rational::Small(numerator, 1) = value
            && numerator.unsigned_abs() < 1 << self.precision
        {
            return *numerator as f64;
        }
        if let Some(quotient) = self.quotient(value) {
            return quotient;
        }
        let (numerator, denominator) = (value.numerator(), value.denominator());
        // The quotient of the shifted numbers has at least `precision + 2` bits.
        let excess = numerator.bits() as i64 - denominator.bits() as i64;
        let shift = self.precision + 3 - excess;
        let (over, under) = (shift.max(0) as u64, (-shift).max(0) as u64);
        let (quotient, remainder) =
            (numerator.magnitude() << over).div_rem(&(denominator.magnitude() << under));
        let size = self.round_magnitude(&quotient, !remainder.is_zero(), -shift);
        if numerator.sign() == Sign::Minus { -size } else { size }
    }

    /// Divides two integers that the format represents exactly, far from the ends of its range. The
    /// division rounds once.
    fn quotient(self, value: &Rational) -> Option<f64> {
        let &Rational::Small(numerator, denominator) = value else { return None };
        let is_held = |integer: i64| integer.unsigned_abs() < 1 << self.precision;
        if !(is_held(numerator) && is_held(denominator)) {
            return None;
        }
        Some(match self.precision {
            NARROW_BITS => f64::from(numerator as f32 / denominator as f32),
            _ => numerator as f64 / denominator as f64,
        })
    }

    /// The number of the format next to `value`·2^−bits.
    pub fn round_fixed(self, value: &BigInt, bits: u32) -> f64 {
        let size = self.round_magnitude(value.magnitude(), false, -i64::from(bits));
        if value.sign() == Sign::Minus { -size } else { size }
    }

    /// Rounds `significand`·2^exponent, where `more` says that the true number lies strictly
    /// between this and the next significand.
    fn round_magnitude(self, significand: &BigUint, more: bool, exponent: i64) -> f64 {
        let length = significand.bits() as i64;
        // Half of the least number is still rounded rightly one bit further down.
        let ulp = (exponent + length - self.precision).max(self.least);
        let dropped = ulp - exponent;
        let (mut kept, tail) = if dropped <= 0 {
            assert!(!more, "the significand has bits to spare");
            ((significand << dropped.unsigned_abs()).to_u64().unwrap_or(0), Tail::Nothing)
        } else if dropped > length {
            let tail = if more || length > 0 { Tail::BelowHalf } else { Tail::Nothing };
            (0, tail)
        } else {
            let kept = (significand >> dropped as u64).to_u64().unwrap_or(0);
            (kept, Tail::of(significand, dropped as u64, more))
        };
        if tail == Tail::AboveHalf || (tail == Tail::Half && kept % 2 == 1) {
            kept += 1;
        }
        let width = i64::from(u64::BITS - kept.leading_zeros());
        if kept > 0 && ulp + width > self.above {
            return f64::INFINITY;
        }
        // Exact: a number of the format, from two numbers of f64.
        kept as f64 * power_of_two(ulp)
    }
}

/// The part cut off, compared with half a unit in the last place kept.
#[derive(PartialEq)]
enum Tail {
    Nothing,
    BelowHalf,
    Half,
    AboveHalf,
}

impl Tail {
    fn of(significand: &BigUint, dropped: u64, more: bool) -> Self {
        let lower_bits = significand.trailing_zeros().unwrap_or(0) < dropped - 1;
        match (significand.bit(dropped - 1), lower_bits || more) {
            (true, true) => Self::AboveHalf,
            (true, false) => Self::Half,
            (false, true) => Self::BelowHalf,
            (false, false) => Self::Nothing,
        }
    }
}

/// 2^exponent for an exponent of f64's numbers.
fn power_of_two(exponent: i64) -> f64 {
    match exponent {
        ..=-1075 => 0.0,
        -1074..=-1023 => f64::from_bits(1 << (exponent + 1074)),
        -1022..=1023 => f64::from_bits(((exponent + 1023) as u64) << 52),
        _ => f64::INFINITY,
    }
}
