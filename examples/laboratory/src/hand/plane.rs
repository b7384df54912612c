//! Vectors, points that move, and bars.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Joint, fused};
use crate::number::Number;

/// A vector in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Vector<F = f64> {
    /// Along +x.
    pub x: F,
    /// Along +y.
    pub y: F,
}

impl<F: Number> Vector<F> {
    /// Turned by 90°, counter-clockwise.
    #[inline(always)]
    #[must_use]
    pub fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    /// The scalar product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> F {
        fused(self.x, other.x, self.y * other.y)
    }

    /// self × other, positive where the other is counter-clockwise of it.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> F {
        fused(self.x, other.y, -(self.y * other.x))
    }

    /// factor · self + other
    #[inline(always)]
    #[must_use]
    pub fn scaled_and(self, factor: F, other: Self) -> Self {
        Self { x: fused(factor, self.x, other.x), y: fused(factor, self.y, other.y) }
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
pub struct Moving<F = f64> {
    /// In m.
    pub position: Vector<F>,
    /// In m/s.
    pub velocity: Vector<F>,
    /// In m/s².
    pub acceleration: Vector<F>,
}

impl<F: Number> Moving<F> {
    /// The end of the vector r of a link that turns about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn about([x, y]: [f64; 2], r: Vector<F>, omega: F, alpha: F) -> Self {
        let place = |base: f64, offset: F| if base == 0.0 { offset } else { F::of(base) + offset };
        Self {
            position: Vector { x: place(x, r.x), y: place(y, r.y) },
            velocity: r.normal() * omega,
            acceleration: r.normal().scaled_and(alpha, -(r * (omega * omega))),
        }
    }

    /// The end of the vector r of a link that carries this point and turns.
    #[inline(always)]
    #[must_use]
    pub fn carrying(self, r: Vector<F>, omega: F, alpha: F) -> Self {
        let centripetal = r.scaled_and(-(omega * omega), self.acceleration);
        Self {
            position: self.position + r,
            velocity: r.normal().scaled_and(omega, self.velocity),
            acceleration: r.normal().scaled_and(alpha, centripetal),
        }
    }
}

/// A bar from its outer joint to the pin of its dyad.
#[derive(Clone, Copy, Debug)]
pub struct Bar<F = f64> {
    /// From the outer joint to the pin, in m.
    pub r: Vector<F>,
    /// In m.
    pub length: f64,
    /// In rad/s.
    pub omega: F,
    /// In rad/s².
    pub alpha: F,
}

impl<F: Number> Bar<F> {
    /// The unit vector along the bar.
    #[inline(always)]
    #[must_use]
    pub fn direction(self) -> Vector<F> {
        self.r * F::of(1.0 / self.length)
    }

    /// From the outer joint to the point at (x, y) of the bar's axes: made of r, no unit vector.
    #[inline(always)]
    fn to(self, [x, y]: [f64; 2]) -> Vector<F> {
        let (along, aside) = (F::of(x / self.length), F::of(y / self.length));
        Vector {
            x: fused(along, self.r.x, -(aside * self.r.y)),
            y: fused(along, self.r.y, aside * self.r.x),
        }
    }

    /// The bar's point at (x, y), the outer joint being a point that moves.
    #[inline(always)]
    #[must_use]
    pub fn point(self, outer: Moving<F>, at: [f64; 2]) -> Moving<F> {
        outer.carrying(self.to(at), self.omega, self.alpha)
    }

    /// The same about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn point_about(self, pivot: [f64; 2], at: [f64; 2]) -> Moving<F> {
        Moving::about(pivot, self.to(at), self.omega, self.alpha)
    }

    /// The pin at the bar's end, the outer joint being a point that moves.
    #[inline(always)]
    #[must_use]
    pub fn end(self, outer: Moving<F>) -> Moving<F> {
        outer.carrying(self.r, self.omega, self.alpha)
    }

    /// The same about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn end_about(self, pivot: [f64; 2]) -> Moving<F> {
        Moving::about(pivot, self.r, self.omega, self.alpha)
    }

    /// The same where the outer joint is either.
    #[inline(always)]
    #[must_use]
    pub fn end_at(self, outer: Joint<F>) -> Moving<F> {
        match outer {
            Joint::Ground(pivot) => self.end_about(pivot),
            Joint::Link(joint) => self.end(joint),
        }
    }
}
