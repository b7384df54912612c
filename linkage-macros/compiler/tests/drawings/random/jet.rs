//! Numbers with two rates in time.

use std::ops::{Add, Mul, Sub};

/// A value with its first and its acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet(pub [f64; 3]);

pub(super) type Vector = [Jet; 2];

impl Jet {
    pub(super) fn still(value: f64) -> Self {
        Self([value, 0.0, 0.0])
    }

    pub(super) fn cos_sin(self) -> [Self; 2] {
        let Self([angle, rate, second]) = self;
        let (sin, cos) = angle.sin_cos();
        [
            Self([cos, -sin * rate, -sin * second - cos * rate * rate]),
            Self([sin, cos * rate, cos * second - sin * rate * rate]),
        ]
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i] - other.0[i]))
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (Self([a, da, dda]), Self([b, db, ddb])) = (self, other);
        Self([a * b, da * b + a * db, dda * b + 2.0 * da * db + a * ddb])
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, by: f64) -> Self {
        Self(self.0.map(|part| part * by))
    }
}

pub(super) fn minus([a, b]: Vector, [c, d]: Vector) -> Vector {
    [a - c, b - d]
}

pub(super) fn plus([a, b]: Vector, [c, d]: Vector) -> Vector {
    [a + c, b + d]
}

pub(super) fn dot([a, b]: Vector, [c, d]: Vector) -> Jet {
    a * c + b * d
}

/// The vector turned by the angle whose cosine and sine are given.
pub(super) fn turned([cos, sin]: Vector, [x, y]: Vector) -> Vector {
    [x * cos - y * sin, x * sin + y * cos]
}
