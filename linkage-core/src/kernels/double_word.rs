//! Sine and cosine in double-word arithmetic: the truth the kernels are tested against.
//!
//! Written with other means than the kernels: the reduction by an exact product with π/2 in three
//! words, the functions by Taylor's series at an eighth of the remainder. Good to 2⁻¹⁰⁰ of the
//! result's magnitude or of 2⁻⁵⁰ of the remainder's, whichever is larger, which a test of its own
//! confirms on the table of hard arguments.

use core::ops::{Add, Mul, Neg, Sub};

/// An unevaluated sum of two f64, the second below the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleWord {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl DoubleWord {
    /// The exact sum of two numbers.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// The exact product of two numbers.
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    /// The distance of the number from `value`, in units of the last place of its own high word
    /// rounded to `bits` of precision.
    pub(crate) fn distance_in_ulp(self, value: f64, bits: i32) -> f64 {
        let exponent = if self.high == 0.0 { -1022 } else { exponent(self.high) };
        let ulp = 2.0_f64.powi((exponent - (bits - 1)).max(-1022));
        (((value - self.high) - self.low) / ulp).abs()
    }
}

/// The exponent of the power of two not above |x|, for normal x.
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

impl Add for DoubleWord {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::sum(high.high, high.low + low.high);
        Self::sum(first.high, first.low + low.low)
    }
}

impl Sub for DoubleWord {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for DoubleWord {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Mul for DoubleWord {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

/// π/2 to 160 bits.
const HALF_PI: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33];

/// Sine and cosine of `x`, for |x| ≤ 2²⁰.
pub(crate) fn sin_cos(x: f64) -> (DoubleWord, DoubleWord) {
    let q = (x / HALF_PI[0]).round();
    let products = HALF_PI.map(|part| DoubleWord::product(q, part));
    // The first difference cancels exactly in its high word.
    let r = DoubleWord::sum(x - products[0].high, -products[0].low);
    let r = (r - products[1]) - products[2];
    let (sin, cos) = taylor(r);
    match q.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// By Taylor's series, for |r| ≤ π/4: the terms fall below 2⁻¹¹⁰ at the 27th power.
fn taylor(r: DoubleWord) -> (DoubleWord, DoubleWord) {
    let square = r * r;
    let mut sums = [r, DoubleWord { high: 1.0, low: 0.0 }];
    for (start, sum) in [(1_u32, 0_usize), (0, 1)] {
        let mut term = sums[sum];
        for step in 1..15 {
            let power = start + 2 * step;
            term = -(term * square * inverse(f64::from(power * (power - 1))));
            sums[sum] = sums[sum] + term;
        }
    }
    (sums[0], sums[1])
}

/// 1/n.
fn inverse(n: f64) -> DoubleWord {
    let high = 1.0 / n;
    DoubleWord { high, low: (-high).mul_add(n, 1.0) / n }
}
