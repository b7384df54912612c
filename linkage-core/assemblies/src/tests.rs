//! The numbers by which closures are computed, and lists of triads by ways that share nothing.

mod numbers;
mod triads;

use std::ops::{Add, Mul, Neg, Sub};

/// Numbers from zero to one by a linear congruence.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Complex {
    x: f64,
    y: f64,
}

impl Complex {
    fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    fn turned(angle: f64) -> Self {
        Self::new(angle.cos(), angle.sin())
    }

    fn length(self) -> f64 {
        self.x.hypot(self.y)
    }

    fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    fn times(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    fn conjugate(self) -> Self {
        Self::new(self.x, -self.y)
    }

    fn over(self, other: Self) -> Self {
        (self * other.conjugate()).times(1.0 / other.length().powi(2))
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        self.times(-1.0)
    }
}
