//! `f32` and `f64` as scalars.

use crate::{Real, Scalar};

macro_rules! primitive {
    ($t:ident, |$wide:tt, $narrow:tt| $value:expr, $sqrt:ident, $sincos:ident, $tan:ident, $asin:ident, $acos:ident,
     $atan:ident, $atan2:ident, $hypot:ident, $fma:ident) => {
        impl Scalar for $t {
            type Mask = bool;

            #[inline]
            fn lit($wide: f64, $narrow: f32) -> Self {
                $value
            }
            #[inline]
            fn sqrt(self) -> Self {
                libm::$sqrt(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                libm::$sincos(self)
            }
            #[inline]
            fn sin_cos_near(self) -> (Self, Self) {
                libm::$sincos(self)
            }
            #[inline]
            fn is_near(self) -> bool {
                self.abs() <= 1e6
            }
            #[inline]
            fn tan(self) -> Self {
                libm::$tan(self)
            }
            #[inline]
            fn asin(self) -> Self {
                libm::$asin(self)
            }
            #[inline]
            fn acos(self) -> Self {
                libm::$acos(self)
            }
            #[inline]
            fn atan(self) -> Self {
                libm::$atan(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self + 0.0, x)
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                libm::$hypot(self, other)
            }
            #[inline]
            fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
                let cd = c * d;
                libm::$fma(a, b, -cd) - libm::$fma(c, d, -cd)
            }
            #[inline]
            fn mul_err(a: Self, b: Self) -> Self {
                libm::$fma(a, b, -(a * b))
            }
            #[inline]
            fn add_err(a: Self, b: Self) -> Self {
                let s = a + b;
                let b_virtual = s - a;
                (a - (s - b_virtual)) + (b - b_virtual)
            }
            #[inline]
            fn fused(a: Self, b: Self, c: Self) -> Self {
                a * b + c
            }
            #[inline]
            fn ge(self, other: Self) -> bool {
                self >= other
            }
            #[inline]
            fn gt(self, other: Self) -> bool {
                self > other
            }
            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            #[inline]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline]
            fn smallest_square() -> Self {
                $t::MIN_POSITIVE
            }
        }
    };
}

primitive!(f64, |wide, _| wide, sqrt, sincos, tan, asin, acos, atan, atan2, hypot, fma);
primitive!(
    f32,
    |_, narrow| narrow,
    sqrtf,
    sincosf,
    tanf,
    asinf,
    acosf,
    atanf,
    atan2f,
    hypotf,
    fmaf
);

impl Real for f64 {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn is_constant(self) -> bool {
        true
    }
}

impl Real for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;

    #[inline]
    fn value(self) -> f64 {
        f64::from(self)
    }
    #[inline]
    fn is_constant(self) -> bool {
        true
    }
}
