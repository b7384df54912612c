//! Exponentials, logarithms and powers: of exact numbers in normal form, and of enclosures with every error
//! counted.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::Exact;
use super::atom::AtomKind;
use super::enclosure::Enclosure;
use crate::function::Function;

/// The largest magnitude of an exponent of e: beyond it no double-precision number is finite, or normal.
const LARGEST: i64 = 700;

impl Exact {
    /// An exponential, a logarithm or a power; `None` outside its domain.
    pub(super) fn grown(&self, function: Function, exponent: &Self) -> Option<Self> {
        match function {
            Function::Exp => self.exponential(),
            Function::Ln => self.logarithm(),
            Function::Tanh => Some(self.hyperbolic_tangent()),
            Function::Pow => self.to_the(exponent),
            _ => unreachable!("a function of another file"),
        }
    }

    /// e to this power; `None` far beyond floating point.
    fn exponential(&self) -> Option<Self> {
        let limit = Self::integer(LARGEST);
        if self.cmp_value(&limit).is_gt() || self.cmp_value(&limit.neg()).is_lt() {
            return None;
        }
        Some(match self.as_atom() {
            _ if self.is_zero() => Self::integer(1),
            Some(AtomKind::Of(Function::Ln, of)) => of.clone(),
            _ => Self::atom(AtomKind::Of(Function::Exp, self.clone())),
        })
    }

    /// The natural logarithm of a number above zero.
    pub(super) fn logarithm(&self) -> Option<Self> {
        if !self.signum().is_gt() {
            return None;
        }
        Some(match self.as_atom() {
            _ if self.cmp_value(&Self::integer(1)).is_eq() => Self::integer(0),
            Some(AtomKind::Of(Function::Exp, of)) => of.clone(),
            _ => Self::atom(AtomKind::Of(Function::Ln, self.clone())),
        })
    }

    pub(super) fn hyperbolic_tangent(&self) -> Self {
        if self.is_zero() {
            return Self::integer(0);
        }
        if self.monic().0.signum().is_lt() {
            return self.neg().hyperbolic_tangent().neg();
        }
        Self::atom(AtomKind::Of(Function::Tanh, self.clone()))
    }

    /// The power of any number by a small integer, of a number above zero by any; `None` elsewhere.
    pub(super) fn to_the(&self, exponent: &Self) -> Option<Self> {
        if let Some(times) = exponent.to_integer() {
            return self.integer_power(times);
        }
        // Halves are roots: the root of a square is rational.
        if let Some(halves) = exponent.add(exponent).to_integer()
            && self.signum().is_gt()
        {
            return self.sqrt()?.integer_power(halves);
        }
        exponent.mul(&self.logarithm()?).exponential()
    }

    fn integer_power(&self, times: i64) -> Option<Self> {
        if times.abs() > Function::LARGEST_POWER || (times < 0 && self.is_zero()) {
            return None;
        }
        Some(self.power(i32::try_from(times).ok()?))
    }
}

impl Enclosure {
    /// The function of an atom of this file; `None` where it has no value.
    pub(super) fn grown(&self, function: Function) -> Option<Self> {
        match function {
            Function::Exp => self.exponential(),
            Function::Ln => self.logarithm(),
            Function::Tanh => Some(self.hyperbolic_tangent()),
            // Normal forms make these of the others.
            _ => None,
        }
    }

    /// e to the power of every number; `None` where an upper bound is far beyond floating point.
    pub fn exponential(&self) -> Option<Self> {
        // A coarse enclosure may reach beyond the limit of its number.
        let above = BigInt::from(2 * LARGEST) << self.bits;
        if self.upper > above {
            return None;
        }
        let below = exponential(&self.lower, self.bits);
        if self.lower == self.upper {
            return Some(below);
        }
        Some(Self::new(below.lower, exponential(&self.upper, self.bits).upper, self.bits))
    }

    /// The logarithm of every number; `None` unless all are above zero.
    pub fn logarithm(&self) -> Option<Self> {
        if !self.lower.is_positive() {
            return None;
        }
        let below = logarithm(&self.lower, self.bits);
        if self.lower == self.upper {
            return Some(below);
        }
        Some(Self::new(below.lower, logarithm(&self.upper, self.bits).upper, self.bits))
    }

    /// The hyperbolic tangent, which grows with its argument and lies in [−1, 1].
    pub fn hyperbolic_tangent(&self) -> Self {
        let below = hyperbolic_tangent(&self.lower, self.bits);
        let above = hyperbolic_tangent(&self.upper, self.bits);
        Self::new(below.lower, above.upper, self.bits)
    }
}

/// An enclosure of e to the power x·2^−bits, a few ulp wide.
///
/// The argument is halved until it is below 2^−8, whose series is short, and the result squared as often by
/// operations on enclosures. Each squaring doubles the relative error, and the result has as many bits before the
/// point as e to the power has: so many bits are added.
fn exponential(x: &BigInt, bits: u32) -> Enclosure {
    // There nothing but the last unit is left.
    if x.is_negative() && (x.magnitude() >> bits) >= bits.into() {
        return Enclosure::new(BigInt::zero(), BigInt::one(), bits);
    }
    let whole = (x >> bits).to_i64().unwrap_or(-2 * LARGEST).max(-2 * LARGEST);
    // e < 2^1.5; the exponent is below 1400.
    let before_point = (3 * whole.unsigned_abs() / 2 + 2) as u32;
    let halvings = (x.magnitude().bits() as u32).saturating_sub(bits) + 8;
    let working = bits + 2 * before_point + halvings + 24;
    let reduced = (x << (working - bits)) >> halvings;
    let mut power = exponential_series(&reduced, working);
    for _ in 0..halvings {
        power = power.mul(&power);
    }
    power.with_bits(bits)
}

/// eˣ for |x| ≤ 2^−8 by its series.
///
/// A term is made of the previous one by a product with x and a division by n, both cut off, so that none is wrong by
/// more than 2 ulp. The first term left out is wrong by less than 2 ulp from zero, and those after it add less than
/// as much again. The argument was cut off by one ulp, which changes the value by less than two.
fn exponential_series(x: &BigInt, working: u32) -> Enclosure {
    let mut term = BigInt::one() << working;
    let (mut sum, mut n) = (BigInt::zero(), 0_u32);
    // A negative term that is cut off ends at −1.
    while term.bits() > 1 {
        sum += &term;
        n += 1;
        term = ((term * x) >> working) / n;
    }
    Enclosure::around(&sum, &BigInt::from(2 * n + 8), working)
}

/// An enclosure of the logarithm of x·2^−bits, x > 0, a few ulp wide: ln x = k ln 2 + 2 artanh v with
/// v = (m − 1)/(m + 1) and x = m 2ᵏ, 1/2 ≤ m < 1.
fn logarithm(x: &BigInt, bits: u32) -> Enclosure {
    let working = bits + 40;
    let twos = x.bits() as i64 - i64::from(bits);
    // m in units of 2^−working, exactly or cut off: by an ulp, of which the logarithm makes two at most.
    let shift = i64::from(working) - x.bits() as i64;
    let mantissa = if shift >= 0 { x << shift as u64 } else { x >> (-shift) as u64 };
    let one = BigInt::one() << working;
    let v = Enclosure::point(&mantissa - &one, working)
        .div(&Enclosure::point(&mantissa + &one, working))
        .expect("the divisor is above one");
    let (middle, radius) = v.middle();
    let (area, error) = inverse_tangent(&middle, working);
    // |v| ≤ 1/3, where the slope is below 9/8.
    let artanh = Enclosure::around(&area, &(error + radius * 2), working);
    let part = artanh.times(&BigInt::from(2)).widened(&BigInt::from(2));
    let two = {
        let (third, error) = inverse_tangent(&((BigInt::one() << working) / 3), working);
        Enclosure::around(&third, &(error + 2), working).times(&BigInt::from(2))
    };
    part.add(&two.times(&BigInt::from(twos))).with_bits(bits)
}

/// artanh v for |v| ≤ 1/3 by its series v + v³/3 + …, and the error in ulp: as for the arc tangent, whose
/// terms have the same magnitudes; the tail is below twice the first power left out.
fn inverse_tangent(v: &BigInt, working: u32) -> (BigInt, BigInt) {
    let square = (v * v) >> working;
    let (mut power, mut odd, mut sum) = (v.abs(), 1_u32, BigInt::zero());
    while !power.is_zero() {
        sum += &power / odd;
        power = (power * &square) >> working;
        odd += 2;
    }
    let error = BigInt::from(2 * odd + 6);
    (if v.is_negative() { -sum } else { sum }, error)
}

/// tanh x = (E − 1)/(E + 1) with E = e^2x, for x·2^−bits.
fn hyperbolic_tangent(x: &BigInt, bits: u32) -> Enclosure {
    let one = Enclosure::integer(1, bits);
    let size = x.abs();
    // 1 − tanh x < 2 e^−2x, which is below the last unit where x is above the bits.
    let value = if (&size >> bits) > BigInt::from(bits) {
        Enclosure::new(&one.lower - 1, one.upper, bits)
    } else {
        let working = bits + 8;
        // e^−2x does not leave the fixed point.
        let power = exponential(&-(size << (working + 1 - bits)), working);
        let one = Enclosure::integer(1, working);
        let quotient = one.sub(&power).div(&one.add(&power)).expect("the divisor is above one");
        quotient.with_bits(bits)
    };
    if x.is_negative() { value.neg() } else { value }
}
