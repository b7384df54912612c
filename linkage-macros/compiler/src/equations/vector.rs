//! Vectors in the plane, of symbols.

use std::ops::{Add, Mul, Neg, Sub};

use crate::equations::symbol::Sym;

/// A vector in the plane.
#[derive(Clone, Copy)]
pub(crate) struct Vector<'s> {
    pub x: Sym<'s>,
    pub y: Sym<'s>,
}

impl<'s> Vector<'s> {
    pub(crate) fn dot(self, other: Self) -> Sym<'s> {
        self.x * other.x + self.y * other.y
    }

    /// a × b, positive where b is counter-clockwise of a.
    pub(crate) fn cross(self, other: Self) -> Sym<'s> {
        self.x * other.y - self.y * other.x
    }

    /// The normal 90° counter-clockwise of it, of the same length.
    pub(crate) fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.x.is_zero() && self.y.is_zero()
    }

    /// This direction turned by another: the product of the two as complex numbers.
    pub(crate) fn turned(self, by: Self) -> Self {
        Self { x: self.x * by.x - self.y * by.y, y: self.x * by.y + self.y * by.x }
    }

    /// The mirror image about the x axis: a direction's inverse.
    pub(crate) fn conjugate(self) -> Self {
        Self { x: self.x, y: -self.y }
    }
}

impl Add for Vector<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Vector<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Vector<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<'s> Mul<Vector<'s>> for Sym<'s> {
    type Output = Vector<'s>;
    fn mul(self, vector: Vector<'s>) -> Vector<'s> {
        Vector { x: self * vector.x, y: self * vector.y }
    }
}
