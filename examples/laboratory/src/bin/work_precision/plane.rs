//! Vectors, and points with their velocity and acceleration, as a hand writes them.

use std::ops::{Add, Mul, Neg, Sub};

use crate::number::Number;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector<F> {
    pub(crate) x: F,
    pub(crate) y: F,
}

impl<F: Number> Vector<F> {
    #[inline(always)]
    pub(crate) fn of(x: f64, y: f64) -> Self {
        Self { x: F::of(x), y: F::of(y) }
    }
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> F {
        self.x * other.x + self.y * other.y
    }
    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> F {
        self.x * other.y - self.y * other.x
    }
    /// Turned by 90°, counter-clockwise.
    #[inline(always)]
    pub(crate) fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
}

impl<F: Number> Add for Vector<F> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<F: Number> Sub for Vector<F> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<F: Number> Neg for Vector<F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<F: Number> Mul<F> for Vector<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: F) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

/// A point that moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving<F> {
    pub(crate) position: Vector<F>,
    pub(crate) velocity: Vector<F>,
    pub(crate) acceleration: Vector<F>,
}

/// A link's unit vector, angular velocity and angular acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link<F> {
    pub(crate) u: Vector<F>,
    pub(crate) omega: F,
    pub(crate) alpha: F,
}

impl<F: Number> Link<F> {
    /// The point at (x, y) in the link's axes, whose origin is `origin`.
    #[inline(always)]
    pub(crate) fn carry(self, origin: Moving<F>, x: f64, y: f64) -> Moving<F> {
        let r = self.u * F::of(x) + self.u.normal() * F::of(y);
        let from_origin = self.swing(r);
        Moving {
            position: origin.position + r,
            velocity: origin.velocity + from_origin.velocity,
            acceleration: origin.acceleration + from_origin.acceleration,
        }
    }

    /// The same for a link that turns about a point of the ground.
    #[inline(always)]
    pub(crate) fn carry_about(self, pivot: (f64, f64), x: f64, y: f64) -> Moving<F> {
        let moving = self.swing(self.u * F::of(x) + self.u.normal() * F::of(y));
        Moving { position: Vector::of(pivot.0, pivot.1) + moving.position, ..moving }
    }

    /// The end of a bar of this length that turns about a point of the ground.
    #[inline(always)]
    pub(crate) fn end_about(self, pivot: (f64, f64), length: f64) -> Moving<F> {
        let moving = self.swing_by(length);
        Moving { position: Vector::of(pivot.0, pivot.1) + moving.position, ..moving }
    }

    #[inline(always)]
    fn swing_by(self, length: f64) -> Moving<F> {
        self.swing(self.u * F::of(length))
    }

    /// The motion of the vector r, fixed in the link.
    #[inline(always)]
    fn swing(self, r: Vector<F>) -> Moving<F> {
        Moving {
            position: r,
            velocity: r.normal() * self.omega,
            acceleration: r.normal() * self.alpha - r * (self.omega * self.omega),
        }
    }
}

/// The pin of a crank that turns about the origin, from its direction.
#[inline(always)]
pub(crate) fn crank<F: Number>((sin, cos): (F, F), omega: F, alpha: F, length: f64) -> Moving<F> {
    Link { u: Vector { x: cos, y: sin }, omega, alpha }.swing_by(length)
}
