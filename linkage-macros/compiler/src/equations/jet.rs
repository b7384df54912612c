//! A number with its velocity and acceleration.
//!
//! Every dimension of a mechanism is a jet; the rates of a constant are the constant zero and
//! leave no trace. The rules below are the chain rule to second order, each written so that the
//! value is an intermediate of its own rates.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::equations::symbol::{GraphBuilder, Sym};

/// Value, rate and acceleration.
#[derive(Clone, Copy)]
pub struct Jet<'s> {
    pub value: Sym<'s>,
    pub rate: Sym<'s>,
    pub accel: Sym<'s>,
}

impl<'s> Jet<'s> {
    pub fn constant(value: Sym<'s>) -> Self {
        let zero = value.builder().zero();
        Self { value, rate: zero, accel: zero }
    }

    pub(crate) fn zero(builder: &'s GraphBuilder<'s>) -> Self {
        Self::constant(builder.zero())
    }

    pub(crate) fn is_zero(self) -> bool {
        self.value.is_zero() && self.is_fixed()
    }

    /// True if the form alone shows that both rates are zero.
    pub(crate) fn is_fixed(self) -> bool {
        self.rate.is_zero() && self.accel.is_zero()
    }

    pub fn times(self, factor: Sym<'s>) -> Self {
        Self { value: factor * self.value, rate: factor * self.rate, accel: factor * self.accel }
    }

    pub(crate) fn twice(self) -> Self {
        self.times(self.value.builder().integer(2))
    }

    /// 1/d of a distance d, from half of the rate and of the acceleration of d², e and f: −e/d³ and
    /// (3 e²/d² − f)/d³, by one division.
    pub(crate) fn inverse_distance(distance: Sym<'s>, [e, f]: [Sym<'s>; 2]) -> Self {
        let value = distance.recip();
        let square = value.squared();
        let turn = e * square;
        let three = distance.builder().integer(3);
        Self { value, rate: -(turn * value), accel: (three * turn.squared() - f * square) * value }
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
