//! `f32` and `f64` under one name, with the standard library's functions.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`.
pub(crate) trait Number:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The name of the width in the tables.
    const NAME: &'static str;
    /// The distance from 1 to the next number.
    const EPSILON: f64;
    /// The step below which one more step of Newton would change nothing.
    const SETTLED: Self;

    fn of(value: f64) -> Self;
    fn widen(self) -> f64;
    fn sqrt(self) -> Self;
    fn sin_cos(self) -> (Self, Self);
    fn atan2(self, x: Self) -> Self;
    /// Sine and cosine by the polynomials of `sine`, or by the standard library far out.
    fn sin_cos_by_hand(self) -> (Self, Self);
    /// self·b + c, fused where the target has the instruction.
    fn fused(self, b: Self, c: Self) -> Self;
}

macro_rules! number {
    ($t:ident, $kernel:path, $settled:literal) => {
        impl Number for $t {
            const NAME: &'static str = stringify!($t);
            const EPSILON: f64 = $t::EPSILON as f64;
            const SETTLED: Self = $settled;

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $t
            }
            #[inline(always)]
            fn widen(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                self.atan2(x)
            }
            #[inline(always)]
            fn sin_cos_by_hand(self) -> (Self, Self) {
                $kernel(self)
            }
            #[inline(always)]
            fn fused(self, b: Self, c: Self) -> Self {
                if cfg!(target_feature = "fma") { self.mul_add(b, c) } else { self * b + c }
            }
        }
    };
}

// Newton's error is squared by each step: after a step of ∛ε or so the next changes nothing.
number!(f64, crate::sine::sin_cos_f64, 1e-8);
number!(f32, crate::sine::sin_cos_f32, 5e-4);
