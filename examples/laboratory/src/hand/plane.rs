//! Vectors, points that move, and bars.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Joint, fused};

/// A vector in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Vector {
    /// Along +x.
    pub x: f64,
    /// Along +y.
    pub y: f64,
}

impl Vector {
    /// Turned by 90°, counter-clockwise.
    #[inline(always)]
    #[must_use]
    pub fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    /// The scalar product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        fused(self.x, other.x, self.y * other.y)
    }

    /// self × other, positive where the other is counter-clockwise of it.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
        fused(self.x, other.y, -(self.y * other.x))
    }

    /// factor · self + other
    #[inline(always)]
    #[must_use]
    pub fn scaled_and(self, factor: f64, other: Self) -> Self {
        Self { x: fused(factor, self.x, other.x), y: fused(factor, self.y, other.y) }
    }
}

impl Add for Vector {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Vector {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Vector {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

/// A point that moves.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    /// In m.
    pub position: Vector,
    /// In m/s.
    pub velocity: Vector,
    /// In m/s².
    pub acceleration: Vector,
}

impl Moving {
    /// The end of the vector r of a link that turns about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn about([x, y]: [f64; 2], r: Vector, omega: f64, alpha: f64) -> Self {
        let place = |base: f64, offset: f64| if base == 0.0 { offset } else { base + offset };
        Self {
            position: Vector { x: place(x, r.x), y: place(y, r.y) },
            velocity: r.normal() * omega,
            acceleration: r.normal().scaled_and(alpha, -(r * (omega * omega))),
        }
    }

    /// The end of the vector r of a link that carries this point and turns.
    #[inline(always)]
    #[must_use]
    pub fn carrying(self, r: Vector, omega: f64, alpha: f64) -> Self {
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
pub struct Bar {
    /// From the outer joint to the pin, in m.
    pub r: Vector,
    /// In m.
    pub length: f64,
    /// In rad/s.
    pub omega: f64,
    /// In rad/s².
    pub alpha: f64,
}

impl Bar {
    /// The unit vector along the bar.
    #[inline(always)]
    #[must_use]
    pub fn direction(self) -> Vector {
        self.r * (1.0 / self.length)
    }

    /// From the outer joint to the point at (x, y) of the bar's axes: made of r, no unit vector.
    #[inline(always)]
    fn to(self, [x, y]: [f64; 2]) -> Vector {
        let (along, aside) = (x / self.length, y / self.length);
        Vector {
            x: fused(along, self.r.x, -(aside * self.r.y)),
            y: fused(along, self.r.y, aside * self.r.x),
        }
    }

    /// The bar's point at (x, y), the outer joint being a point that moves.
    #[inline(always)]
    #[must_use]
    pub fn point(self, outer: Moving, at: [f64; 2]) -> Moving {
        outer.carrying(self.to(at), self.omega, self.alpha)
    }

    /// The same about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn point_about(self, pivot: [f64; 2], at: [f64; 2]) -> Moving {
        Moving::about(pivot, self.to(at), self.omega, self.alpha)
    }

    /// The pin at the bar's end, the outer joint being a point that moves.
    #[inline(always)]
    #[must_use]
    pub fn end(self, outer: Moving) -> Moving {
        outer.carrying(self.r, self.omega, self.alpha)
    }

    /// The same about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn end_about(self, pivot: [f64; 2]) -> Moving {
        Moving::about(pivot, self.r, self.omega, self.alpha)
    }

    /// The same where the outer joint is either.
    #[inline(always)]
    #[must_use]
    pub fn end_at(self, outer: Joint) -> Moving {
        match outer {
            Joint::Ground(pivot) => self.end_about(pivot),
            Joint::Link(joint) => self.end(joint),
        }
    }
}
