//! Discs of the complex plane: what is known of a number behind roundings.
//!
//! Each operation returns a disc that holds the exact results of all numbers of its operands' discs.

use core::f64::consts::SQRT_2;

use libm::{hypot, sqrt};

/// All numbers as near to x + i y as the radius.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// The centre's real part.
    pub x: f64,
    /// The centre's imaginary part.
    pub y: f64,
    /// The radius.
    pub radius: f64,
}

const EPSILON: f64 = f64::EPSILON;

/// A radius with room for a dozen roundings of its own sum, and for underflow.
fn outward(radius: f64) -> f64 {
    radius * (1.0 + 8.0 * EPSILON) + f64::MIN_POSITIVE
}

impl Disc {
    /// A number without error.
    #[must_use]
    pub fn exact(x: f64, y: f64) -> Self {
        Self { x, y, radius: 0.0 }
    }

    /// No less than the length of the center, and no more than 1.09 times that: the octagon about a circle.
    fn most(self) -> f64 {
        let (x, y) = (self.x.abs(), self.y.abs());
        (x.max(y) + (SQRT_2 - 1.0) * x.min(y)) * (1.0 + 4.0 * EPSILON)
    }

    /// No more than the length of the center.
    fn least(self) -> f64 {
        hypot(self.x, self.y) * (1.0 - 4.0 * EPSILON)
    }

    /// The conjugates.
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self { y: -self.y, ..self }
    }

    /// The sums. Each part of a sum is off by half a unit in its last place.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let sum = Self { x: self.x + other.x, y: self.y + other.y, radius: 0.0 };
        Self { radius: outward(self.radius + other.radius + EPSILON * sum.most()), ..sum }
    }

    /// The differences.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        self.plus(Self { x: -other.x, y: -other.y, ..other })
    }

    /// The products. Each part of a product is off by three half units of |x||u| + |y||v|, no more than three of the lengths' product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let (a, b) = (self.most(), other.most());
        let x = self.x * other.x - self.y * other.y;
        let y = self.x * other.y + self.y * other.x;
        let radius = 3.0 * EPSILON * a * b + a * other.radius + b * self.radius;
        Self { x, y, radius: outward(radius + self.radius * other.radius) }
    }

    /// The inverses. The radius is infinite for a disc that holds zero. |1/z − 1/c| = |z − c|/(|z| |c|).
    #[must_use]
    pub fn inverse(self) -> Self {
        let least = self.least();
        if least <= self.radius || self.radius.is_nan() {
            return Self { x: 0.0, y: 0.0, radius: f64::INFINITY };
        }
        // In this order no square of the length overflows.
        let (x, y) = (self.x / least / least, -self.y / least / least);
        let radius = self.radius / (least * (least - self.radius)) + 16.0 * EPSILON / least;
        Self { x, y, radius: outward(radius) }
    }

    /// A root: of each number of the disc one of both roots is in the result.
    ///
    /// With c = r², and s the nearer root to r of a number z: |s − r| |s + r| = |z − c|, and |s + r| is no less than |s − r| and |r|.
    #[must_use]
    pub fn root(self) -> Self {
        let far = hypot(self.x, self.y);
        let larger = sqrt((far + self.x.abs()) / 2.0);
        let smaller = if larger > 0.0 { self.y.abs() / larger / 2.0 } else { 0.0 };
        let (x, y) = if self.x >= 0.0 { (larger, smaller) } else { (smaller, larger) };
        let root = Self { x, y: if self.y < 0.0 { -y } else { y }, radius: 0.0 };
        let near = if root.least() > 0.0 { self.radius / root.least() } else { f64::INFINITY };
        let radius = near.min(sqrt(self.radius)) + 8.0 * EPSILON * root.most();
        Self { radius: outward(radius), ..root }
    }

    /// The opposites.
    #[must_use]
    pub fn negative(self) -> Self {
        Self { x: -self.x, y: -self.y, ..self }
    }
}
