//! Functions of one number that a library computes: all that numbers ask of them.
//!
//! `f32` and `f64` take the value, dual numbers the derivatives, and ranges of numbers a bound of the curvature
//! beside. The functions are those of `libm`, within a unit in the last place or two. They branch, so that lanes
//! call them one by one: a sweep that needs one of them is no faster for its vectors there.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A function whose only argument is a number, and which any [`Scalar`](crate::Scalar) applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LibraryFunction {
    /// eˣ; infinite above 709.78 (`f32`: 88.72).
    Exp,
    /// The natural logarithm; −∞ at zero, and not a number below.
    Ln,
    /// The hyperbolic tangent.
    Tanh,
}

impl LibraryFunction {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Exp, Self::Ln, Self::Tanh];

    /// The value in double precision.
    #[must_use]
    pub fn wide(self, x: f64) -> f64 {
        match self {
            Self::Exp => libm::exp(x),
            Self::Ln => libm::log(x),
            Self::Tanh => libm::tanh(x),
        }
    }

    /// The value in single precision.
    #[must_use]
    pub fn narrow(self, x: f32) -> f32 {
        match self {
            Self::Exp => libm::expf(x),
            Self::Ln => libm::logf(x),
            Self::Tanh => libm::tanhf(x),
        }
    }

    /// The value and the first three derivatives, from the argument and the value; `literal` makes a number.
    pub(crate) fn derivatives<T>(self, x: T, value: T, literal: impl Fn(f32) -> T) -> [T; 4]
    where
        T: Copy
            + Sub<Output = T>
            + Add<Output = T>
            + Mul<Output = T>
            + Div<Output = T>
            + Neg<Output = T>,
    {
        let (one, two) = (literal(1.0), literal(2.0));
        match self {
            Self::Exp => [value; 4],
            Self::Ln => {
                let slope = one / x;
                [value, slope, -(slope * slope), two * slope * slope * slope]
            }
            // t' = 1 − t² by factors.
            Self::Tanh => {
                let slope = (one - value) * (one + value);
                let third = slope * (literal(6.0) * value * value - two);
                [value, slope, -(two * value * slope), third]
            }
        }
    }

    /// A bound of the second derivative's magnitude between a number at which the function has a value and a larger
    /// one, given the value at the larger.
    pub(crate) fn curvature<T>(self, from: T, value: T, literal: impl Fn(f32) -> T) -> T
    where
        T: Copy + Mul<Output = T> + Div<Output = T>,
    {
        match self {
            Self::Exp => value,
            Self::Ln => literal(1.0) / (from * from),
            // 4/(3√3) where tanh² x is a third.
            Self::Tanh => literal(0.77),
        }
    }
}
