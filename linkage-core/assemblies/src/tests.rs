//! The numbers by which closures are computed, and lists of triads by ways that share nothing.

mod numbers;
mod triads;

use std::ops::Neg;

use crate::complex::Complex;

/// Numbers from zero to one by a linear congruence.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Beside the operations of the list's own numbers.
impl Complex {
    fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    fn times(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    fn over(self, other: Self) -> Self {
        (self * other.conjugate()).times(1.0 / other.length().powi(2))
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        self.times(-1.0)
    }
}
