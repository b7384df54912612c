//! Vectors and displacements of the plane as complex numbers: a product turns and stretches.

use std::ops::{Add, Mul, Neg, Sub};

/// The square root; NaN for a negative number.
pub(crate) fn root(square: f64) -> f64 {
    square.sqrt()
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    pub x: f64,
    pub y: f64,
}

impl Complex {
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at an angle from +x.
    pub fn turned(angle: f64) -> Self {
        Self::new(angle.cos(), angle.sin())
    }

    pub fn length(self) -> f64 {
        self.x.hypot(self.y)
    }

    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    pub fn times(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    /// The vector mirrored at the x axis.
    pub fn conjugate(self) -> Self {
        Self::new(self.x, -self.y)
    }

    /// The unit vector of its direction.
    pub fn unit(self) -> Self {
        self.times(1.0 / self.length())
    }

    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// Positive where the other vector points to the left of this one.
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
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
        Self::new(-self.x, -self.y)
    }
}

/// The place of a body seen from the drawing: z ↦ shift + turn z.
#[derive(Clone, Copy, Debug)]
pub struct Displaced {
    pub shift: Complex,
    pub turn: Complex,
}

impl Displaced {
    pub fn of(self, place: Complex) -> Complex {
        self.shift + self.turn * place
    }

    /// The motion with this turning that brings a place of the drawing to another.
    pub(super) fn taking(from: Complex, to: Complex, turn: Complex) -> Self {
        Self { shift: to - turn * from, turn }
    }
}
