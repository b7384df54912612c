//! Vectors, points that move and links, of any number.

use std::ops::{Add, Mul, Neg, Sub};

use crate::prove::computed::Float;

/// A vector in the plane.
#[derive(Clone, Copy)]
pub(super) struct Vector<T> {
    pub x: T,
    pub y: T,
}

impl<T: Float> Vector<T> {
    pub(super) fn of([x, y]: [f64; 2]) -> Self {
        Self { x: T::of(x), y: T::of(y) }
    }

    pub(super) fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
}

impl<T: Float> Add for Vector<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<T: Float> Sub for Vector<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<T: Float> Neg for Vector<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<T: Float> Mul<T> for Vector<T> {
    type Output = Self;
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

/// Position, velocity and acceleration of a point.
#[derive(Clone, Copy)]
pub(super) struct Moving<T> {
    pub position: Vector<T>,
    pub velocity: Vector<T>,
    pub acceleration: Vector<T>,
}

impl<T: Float> Moving<T> {
    /// A point of the ground.
    pub(super) fn still(at: [f64; 2]) -> Self {
        let zero = Vector::of([0.0; 2]);
        Self { position: Vector::of(at), velocity: zero, acceleration: zero }
    }
}

/// A link from its origin: the vector of this length along its x, ω and α.
#[derive(Clone, Copy)]
pub(super) struct Link<T> {
    pub r: Vector<T>,
    pub length: f64,
    pub omega: T,
    pub alpha: T,
}

/// A slide and its rates.
pub(super) type Slide<T> = [T; 3];

/// Two bars to a point of the ground: +1 where their pin is left of the line from the first to the second joint.
#[derive(Clone, Copy)]
pub(super) struct Dyad {
    pub pivot: [f64; 2],
    pub lengths: [f64; 2],
    pub side: f64,
}

/// A line of the ground by a point and a unit vector.
#[derive(Clone, Copy)]
pub(super) struct Rail {
    pub origin: [f64; 2],
    pub direction: [f64; 2],
}

/// A crank at the origin: its length, and its angle with its rates.
#[derive(Clone, Copy)]
pub(super) struct Crank<T> {
    pub length: f64,
    pub input: [T; 3],
}
