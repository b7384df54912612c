//! A number with its first and second rate.
//!
//! Every dimension of a mechanism is a jet; the rates of a constant are the constant zero and
//! leave no trace. The rules below are the chain rule to second order, each written so that the
//! value is an intermediate of its own rates.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::equations::symbol::{Sheet, Sym};

/// Value, rate and second rate.
#[derive(Clone, Copy)]
pub(crate) struct Jet<'s> {
    pub value: Sym<'s>,
    pub rate: Sym<'s>,
    pub accel: Sym<'s>,
}

impl<'s> Jet<'s> {
    pub(crate) fn constant(value: Sym<'s>) -> Self {
        let zero = value.sheet().zero();
        Self { value, rate: zero, accel: zero }
    }

    pub(crate) fn zero(sheet: &'s Sheet<'s>) -> Self {
        Self::constant(sheet.zero())
    }

    pub(crate) fn is_zero(self) -> bool {
        self.value.is_zero() && self.is_fixed()
    }

    /// Whether the rates are known to be zero from their form.
    pub(crate) fn is_fixed(self) -> bool {
        self.rate.is_zero() && self.accel.is_zero()
    }

    pub(crate) fn times(self, factor: Sym<'s>) -> Self {
        Self { value: factor * self.value, rate: factor * self.rate, accel: factor * self.accel }
    }

    pub(crate) fn twice(self) -> Self {
        self.times(self.value.sheet().integer(2))
    }

    /// From s² = a: 2 s ṡ = ȧ and 2 ṡ² + 2 s s̈ = ä.
    pub(crate) fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let rate = self.rate.half() / value;
        let accel = (self.accel.half() - rate.squared()) / value;
        Self { value, rate, accel }
    }

    /// Sine and cosine of the jet.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        let square = self.rate.squared();
        let sine =
            Self { value: sin, rate: cos * self.rate, accel: cos * self.accel - sin * square };
        let cosine = Self {
            value: cos,
            rate: -(sin * self.rate),
            accel: -(sin * self.accel) - cos * square,
        };
        (sine, cosine)
    }

    /// With t' = 1 + t²: ṫ = t' ȧ and ẗ = t' (ä + 2 t ȧ²).
    pub(crate) fn tan(self) -> Self {
        let value = self.value.tan();
        let slope = self.value.sheet().integer(1) + value.squared();
        let rate = slope * self.rate;
        let accel = slope * (self.accel + (value * self.rate.squared()).twice());
        Self { value, rate, accel }
    }

    /// From sin v = a, with c = cos v = √((1 − a)(1 + a)): c v̇ = ȧ and c v̈ = ä + a v̇².
    pub(crate) fn asin(self) -> Self {
        let cosine = self.other_leg();
        let rate = self.rate / cosine;
        let accel = (self.accel + self.value * rate.squared()) / cosine;
        Self { value: self.value.asin(), rate, accel }
    }

    /// From cos v = a, with s = sin v = √((1 − a)(1 + a)): s v̇ = −ȧ and s v̈ = −(ä + a v̇²).
    pub(crate) fn acos(self) -> Self {
        let sine = self.other_leg();
        let rate = -(self.rate / sine);
        let accel = -((self.accel + self.value * rate.squared()) / sine);
        Self { value: self.value.acos(), rate, accel }
    }

    /// √(1 − a²) by factors, exact where a is near ±1.
    fn other_leg(self) -> Sym<'s> {
        let one = self.value.sheet().integer(1);
        ((one - self.value) * (one + self.value)).sqrt()
    }

    /// From tan v = a: (1 + a²) v̇ = ȧ and (1 + a²) v̈ = ä − 2 a ȧ v̇.
    pub(crate) fn atan(self) -> Self {
        let slope = self.value.sheet().integer(1) + self.value.squared();
        let rate = self.rate / slope;
        let accel = (self.accel - (self.value * self.rate * rate).twice()) / slope;
        Self { value: self.value.atan(), rate, accel }
    }

    /// The angle v of (x, y): r² v̇ = x ẏ − y ẋ and r² v̈ = x ÿ − y ẍ − 2 v̇ (x ẋ + y ẏ).
    pub(crate) fn atan2(self, x: Self) -> Self {
        let y = self;
        let square = x.value.squared() + y.value.squared();
        let rate = (x.value * y.rate - y.value * x.rate) / square;
        let moment = x.value * y.accel - y.value * x.accel;
        let radial = x.value * x.rate + y.value * y.rate;
        let accel = (moment - (rate * radial).twice()) / square;
        Self { value: y.value.atan2(x.value), rate, accel }
    }

    /// From h² = x² + y²: h ḣ = x ẋ + y ẏ and h ḧ = x ẍ + y ÿ + ẋ² + ẏ² − ḣ².
    pub(crate) fn hypot(self, y: Self) -> Self {
        let x = self;
        let value = x.value.hypot(y.value);
        let rate = (x.value * x.rate + y.value * y.rate) / value;
        let accel = (x.value * x.accel + y.value * y.accel + x.rate.squared() + y.rate.squared()
            - rate.squared())
            / value;
        Self { value, rate, accel }
    }
}

impl Add for Jet<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
            accel: self.accel + other.accel,
        }
    }
}

impl Sub for Jet<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            rate: self.rate - other.rate,
            accel: self.accel - other.accel,
        }
    }
}

impl Neg for Jet<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate, accel: -self.accel }
    }
}

impl Mul for Jet<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            accel: self.accel * other.value
                + (self.rate * other.rate).twice()
                + self.value * other.accel,
        }
    }
}

impl Div for Jet<'_> {
    type Output = Self;
    /// From q b = a: q̇ = (ȧ − q ḃ)/b and q̈ = (ä − 2 q̇ ḃ − q b̈)/b.
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let rate = (self.rate - value * other.rate) / other.value;
        let accel = (self.accel - (rate * other.rate).twice() - value * other.accel) / other.value;
        Self { value, rate, accel }
    }
}
