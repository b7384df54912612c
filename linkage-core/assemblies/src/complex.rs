//! Complex numbers.

use core::ops::{Add, Mul, Sub};

use libm::{cos, hypot, sin};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex {
    pub x: f64,
    pub y: f64,
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let x = self.x * other.x - self.y * other.y;
        Self { x, y: self.x * other.y + self.y * other.x }
    }
}

impl Complex {
    pub(crate) fn turned(angle: f64) -> Self {
        Self { x: cos(angle), y: sin(angle) }
    }

    pub(crate) fn conjugate(self) -> Self {
        Self { y: -self.y, ..self }
    }

    pub(crate) fn square(self) -> f64 {
        self.x * self.x + self.y * self.y
    }

    pub(crate) fn length(self) -> f64 {
        hypot(self.x, self.y)
    }
}
