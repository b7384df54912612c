//! Operations on enclosures that only the oracle of the tests needs.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

use super::{Enclosure, ceil_shift, ceil_sqrt};
use crate::exact::elementary;
use crate::exact::rounding::WIDE;
use crate::exact::word;
use crate::function::Function;

impl Enclosure {
    /// The exact value of a float; `None` unless finite.
    pub(crate) fn float(value: f64, bits: u32) -> Option<Self> {
        word(value).map(|word| Self::rational(&word, bits))
    }

    /// Upper bound less lower bound.
    pub(crate) fn width(&self) -> f64 {
        WIDE.round_fixed(&(&self.upper - &self.lower), self.bits)
    }

    /// The number of f64 next to the middle.
    pub(crate) fn to_f64(&self) -> f64 {
        WIDE.round_fixed(&(&self.lower + &self.upper), self.bits + 1)
    }

    /// The middle with so many decimals, the last one cut off.
    pub(crate) fn to_decimal(&self, decimals: u32) -> String {
        let middle = &self.lower + &self.upper;
        let scaled = (middle.abs() * BigInt::from(10).pow(decimals)) >> (self.bits + 1);
        let (whole, fraction) = scaled.div_rem(&BigInt::from(10).pow(decimals));
        let sign = if middle.is_negative() { "-" } else { "" };
        if decimals == 0 {
            return format!("{sign}{whole}");
        }
        let places = decimals as usize;
        format!("{sign}{whole}.{:0>places$}", fraction.to_string())
    }

    /// The length of the vector (self, other).
    pub(crate) fn hypot(&self, other: &Self) -> Self {
        self.aligned(other, |a, b| {
            let ((a_least, a_greatest), (b_least, b_greatest)) = (a.magnitudes(), b.magnitudes());
            let lower = (&a_least * &a_least + &b_least * &b_least).sqrt();
            let upper = ceil_sqrt(&(&a_greatest * &a_greatest + &b_greatest * &b_greatest));
            Self::new(lower, upper, a.bits)
        })
    }

    /// The function of these numbers, unless some of them have none.
    pub(crate) fn of(function: Function, operands: &[&Self]) -> Option<Self> {
        match (function, operands) {
            (Function::Sqrt, [a]) => a.sqrt(),
            (Function::Tan, [a]) => a.tan(),
            (Function::Acos, [a]) => a.acos(),
            (Function::Atan2, [y, x]) => y.atan2(x),
            (Function::Hypot, [x, y]) => Some(x.hypot(y)),
            (Function::Pow, [x, y]) => y.mul(&x.logarithm()?).exponential(),
            (_, [a]) => a.apply(function),
            other => unreachable!("{other:?}"),
        }
    }

    pub(crate) fn sin(&self) -> Self {
        self.sin_cos().0
    }

    pub(crate) fn cos(&self) -> Self {
        self.sin_cos().1
    }

    /// The tangent, unless the enclosure of the cosine holds zero.
    pub(crate) fn tan(&self) -> Option<Self> {
        let (sin, cos) = self.sin_cos();
        sin.div(&cos)
    }

    /// The arc cosine in [0, π]; see [`Self::asin`].
    pub(crate) fn acos(&self) -> Option<Self> {
        Some(Self::pi(self.bits).halved().sub(&self.asin()?))
    }

    /// The angle of the vector (x, self) in (−π, π], unless the enclosure of the vector holds
    /// zero. Where it lies across the negative x axis, all angles are enclosed.
    pub(crate) fn atan2(&self, x: &Self) -> Option<Self> {
        let bits = self.bits.max(x.bits);
        let (y, x) = (self.with_bits(bits), x.with_bits(bits));
        let ((middle_y, radius_y), (middle_x, radius_x)) = (y.middle(), x.middle());
        if x.lower.is_negative() && y.lower.is_negative() && !y.upper.is_negative() {
            let pi = Self::pi(bits);
            return x.upper.is_negative().then(|| Self::new(-&pi.upper, pi.upper, bits));
        }
        let distance = (&middle_y * &middle_y + &middle_x * &middle_x).sqrt();
        let spread = radius_y + radius_x;
        // Within a disc of radius ρ at distance r ≥ 2ρ the angle is known to asin(ρ/r) ≤ 2ρ/r.
        if distance.is_zero() || distance < &spread * 2 {
            return y.atan2_of_wide(&x);
        }
        let error = (spread << (bits + 1)).div_ceil(&distance);
        Some(elementary::angle(&middle_y, &middle_x, bits).widened(&error))
    }

    /// The hull of the corners' angles, for a box that is large against its distance.
    fn atan2_of_wide(&self, x: &Self) -> Option<Self> {
        let holds_zero = |side: &Self| !side.lower.is_positive() && !side.upper.is_negative();
        if holds_zero(self) && holds_zero(x) {
            return None;
        }
        let mut angles = Vec::new();
        for corner_y in [&self.lower, &self.upper] {
            for corner_x in [&x.lower, &x.upper] {
                angles.push(elementary::angle(corner_y, corner_x, self.bits));
            }
        }
        angles.into_iter().reduce(|hull, angle| {
            Self::new(hull.lower.min(angle.lower), hull.upper.max(angle.upper), self.bits)
        })
    }

    pub(crate) fn halved(&self) -> Self {
        Self::new(&self.lower >> 1, ceil_shift(&self.upper, 1), self.bits)
    }

    /// The bounds of the absolute value.
    fn magnitudes(&self) -> (BigInt, BigInt) {
        let (lower, upper) = (self.lower.abs(), self.upper.abs());
        let least = match self.sign() {
            Some(_) => lower.clone().min(upper.clone()),
            None => BigInt::zero(),
        };
        (least, lower.max(upper))
    }
}
