//! Operations on enclosures that only the oracle needs.

use linkage_compiler::exact::enclosure::{ceil_shift, ceil_sqrt};
use linkage_compiler::exact::rounding::WIDE;
use linkage_compiler::exact::{Enclosure, elementary, word};
use linkage_compiler::function::Function;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

pub(crate) trait Reference: Sized {
    /// The exact value of a float; `None` unless finite.
    fn float(value: f64, bits: u32) -> Option<Self>;
    /// Upper bound less lower bound.
    fn width(&self) -> f64;
    /// The number of f64 next to the middle.
    fn to_f64(&self) -> f64;
    /// The middle with so many decimals, the last one cut off.
    fn to_decimal(&self, decimals: u32) -> String;
    /// The length of the vector (self, other).
    fn hypot(&self, other: &Self) -> Self;
    /// The function of these numbers, unless some of them have none.
    fn of(function: Function, operands: &[&Self]) -> Option<Self>;
    fn sin(&self) -> Self;
    fn cos(&self) -> Self;
    /// The tangent, unless the enclosure of the cosine holds zero.
    fn tan(&self) -> Option<Self>;
    /// The arc cosine in [0, π]; see [`Self::asin`].
    fn acos(&self) -> Option<Self>;
    /// The angle of the vector (x, self) in (−π, π], unless the enclosure of the vector holds
    /// zero. Where it lies across the negative x axis, all angles are enclosed.
    fn atan2(&self, x: &Self) -> Option<Self>;
    fn halved(&self) -> Self;
    /// The number in its middle, as if it were exact.
    fn centre(&self) -> Self;
}

impl Reference for Enclosure {
    fn float(value: f64, bits: u32) -> Option<Self> {
        word(value).map(|word| Self::rational(&word, bits))
    }

    fn width(&self) -> f64 {
        WIDE.round_fixed(&(self.upper() - self.lower()), self.bits())
    }

    fn to_f64(&self) -> f64 {
        WIDE.round_fixed(&(self.lower() + self.upper()), self.bits() + 1)
    }

    fn to_decimal(&self, decimals: u32) -> String {
        let middle = self.lower() + self.upper();
        let scaled = (middle.abs() * BigInt::from(10).pow(decimals)) >> (self.bits() + 1);
        let (whole, fraction) = scaled.div_rem(&BigInt::from(10).pow(decimals));
        let sign = if middle.is_negative() { "-" } else { "" };
        if decimals == 0 {
            return format!("{sign}{whole}");
        }
        let places = decimals as usize;
        format!("{sign}{whole}.{:0>places$}", fraction.to_string())
    }

    fn hypot(&self, other: &Self) -> Self {
        let bits = finer(self, other);
        let [(a_least, a_greatest), (b_least, b_greatest)] =
            [self, other].map(|part| magnitudes(&part.with_bits(bits)));
        let lower = (&a_least * &a_least + &b_least * &b_least).sqrt();
        let upper = ceil_sqrt(&(&a_greatest * &a_greatest + &b_greatest * &b_greatest));
        Self::new(lower, upper, bits)
    }

    fn of(function: Function, operands: &[&Self]) -> Option<Self> {
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

    fn sin(&self) -> Self {
        self.sin_cos().0
    }

    fn cos(&self) -> Self {
        self.sin_cos().1
    }

    fn tan(&self) -> Option<Self> {
        let (sin, cos) = self.sin_cos();
        sin.div(&cos)
    }

    fn acos(&self) -> Option<Self> {
        Some(Self::pi(self.bits()).halved().sub(&self.asin()?))
    }

    fn atan2(&self, x: &Self) -> Option<Self> {
        let bits = finer(self, x);
        let (y, x) = (self.with_bits(bits), x.with_bits(bits));
        let ((middle_y, radius_y), (middle_x, radius_x)) = (y.middle(), x.middle());
        if x.lower().is_negative() && y.lower().is_negative() && !y.upper().is_negative() {
            let pi = Self::pi(bits);
            return x
                .upper()
                .is_negative()
                .then(|| Self::new(-pi.upper(), pi.upper().clone(), bits));
        }
        let distance = (&middle_y * &middle_y + &middle_x * &middle_x).sqrt();
        let spread = radius_y + radius_x;
        // Within a disc of radius ρ at distance r ≥ 2ρ the angle is known to asin(ρ/r) ≤ 2ρ/r.
        if distance.is_zero() || distance < &spread * 2 {
            return angle_of_wide(&y, &x);
        }
        let error = (spread << (bits + 1)).div_ceil(&distance);
        Some(elementary::angle(&middle_y, &middle_x, bits).widened(&error))
    }

    fn halved(&self) -> Self {
        Self::new(self.lower() >> 1, ceil_shift(self.upper(), 1), self.bits())
    }

    fn centre(&self) -> Self {
        let (middle, _) = self.middle();
        Self::new(middle.clone(), middle, self.bits())
    }
}

/// The hull of the corners' angles, for a box that is large against its distance.
fn angle_of_wide(y: &Enclosure, x: &Enclosure) -> Option<Enclosure> {
    let holds_zero = |side: &Enclosure| !side.lower().is_positive() && !side.upper().is_negative();
    if holds_zero(y) && holds_zero(x) {
        return None;
    }
    let mut angles = Vec::new();
    for corner_y in [y.lower(), y.upper()] {
        for corner_x in [x.lower(), x.upper()] {
            angles.push(elementary::angle(corner_y, corner_x, y.bits()));
        }
    }
    angles.into_iter().reduce(|hull, angle| {
        Enclosure::new(
            hull.lower().min(angle.lower()).clone(),
            hull.upper().max(angle.upper()).clone(),
            y.bits(),
        )
    })
}

/// The bounds of the absolute value.
fn magnitudes(of: &Enclosure) -> (BigInt, BigInt) {
    let (lower, upper) = (of.lower().abs(), of.upper().abs());
    let least = match of.sign() {
        Some(_) => lower.clone().min(upper.clone()),
        None => BigInt::zero(),
    };
    (least, lower.max(upper))
}

/// The greater of the numbers of bits.
fn finer(a: &Enclosure, b: &Enclosure) -> u32 {
    a.bits().max(b.bits())
}
