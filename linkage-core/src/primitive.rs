//! `f32` and `f64` as scalars.

use crate::kernels::arithmetic::Arithmetic;
use crate::kernels::{self, Elementary, Float, Native};
use crate::scalar::{Sealed, elementary, root_of_squares};
use crate::tracker::AffineForm;
use crate::{LibraryFunction, Real, Scalar};

/// The elementary functions of a single number.
macro_rules! by_kernels {
    ($($one:ident $of_one:ident)*; $($two:ident $of_two:ident)*) => {
        $(#[inline]
        fn $one(self) -> Self {
            self.$of_one::<Native>()
        })*
        $(#[inline]
        fn $two(self, other: Self) -> Self {
            self.$of_two::<Native>(other)
        })*
    };
}

impl<T: Float> Sealed for AffineForm<T> {}

/// The scalar implementation for one width: the kernels, and `libm` for what no solver computes
/// unless it was asked for.
macro_rules! scalar {
    ($t:ident, lit: $lit:expr, plain: $plain:expr, sqrt: $sqrt:path, near: $near:path,
     hypot: $hypot:path, library: $width:ident $pow:path) => {
        impl Sealed for $t {}

        impl Scalar for $t {
            type Mask = bool;

            #[inline]
            fn lit(wide: f64, narrow: f32) -> Self {
                $lit(wide, narrow)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                if self.is_near() {
                    self.sin_cos_kernel::<Native>()
                } else {
                    self.sin_cos_far_kernel::<Native>()
                }
            }
            #[inline]
            fn sin_cos_near(self) -> (Self, Self) {
                self.sin_cos_near_kernel::<Native, true>()
            }
            #[inline]
            fn is_near(self) -> bool {
                // Monotonous, and without a mask for the sign.
                self * self <= $near * $near
            }
            elementary!(by_kernels);

            #[inline]
            fn hypot(self, other: Self) -> Self {
                $hypot(self, other)
            }
            #[inline]
            fn apply(self, function: LibraryFunction) -> Self {
                function.$width(self)
            }
            #[inline]
            fn pow(self, exponent: Self) -> Self {
                $pow(self, exponent)
            }
            #[inline]
            fn hypot_near(self, other: Self, least: Self) -> (Self, bool) {
                root_of_squares(self, other, least)
            }
            #[inline]
            fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
                kernels::det::<Self, Native>(a, b, c, d)
            }
            #[inline]
            fn mul_err(a: Self, b: Self) -> Self {
                kernels::mul_err::<Self, Native>(a, b)
            }
            #[inline]
            fn add_err(a: Self, b: Self) -> Self {
                kernels::two_sum(a, b).1
            }
            #[inline]
            fn fused(a: Self, b: Self, c: Self) -> Self {
                Self::fused_by::<Native>(a, b, c)
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
            fn is_within(self, bound: Self) -> bool {
                self.abs() <= bound
            }
            #[inline]
            fn plain(wide: bool, narrow: bool) -> bool {
                $plain(wide, narrow)
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
                // Where a term of the square underflows, its error is at most half the smallest
                // subnormal, MIN_POSITIVE·EPSILON/2. At this size that is below the last place of
                // the square as a double word, EPSILON²·square, so that the compensated forms are
                // as right as the plain ones.
                Self::MIN_POSITIVE / (Self::EPSILON * Self::EPSILON)
            }
        }

        impl Real for $t {
            const EPSILON: f64 = Self::EPSILON as f64;

            #[inline]
            fn value(self) -> f64 {
                self.into()
            }
            #[inline]
            fn is_constant(self) -> bool {
                true
            }

            type Plain = Self;
            type Enclosing = AffineForm<Self>;

            #[inline]
            fn enclosing(self, radius: Self) -> AffineForm<Self> {
                AffineForm::around(self, radius)
            }
        }
    };
}

scalar!(
    f64,
    lit: |wide, _| wide,
    plain: |wide, _| wide,
    sqrt: kernels::sqrt,
    near: kernels::NEAR_F64,
    hypot: libm::hypot,
    library: wide libm::pow
);
scalar!(
    f32,
    lit: |_, narrow| narrow,
    plain: |_, narrow| narrow,
    sqrt: kernels::sqrtf,
    near: kernels::NEAR_F32,
    hypot: libm::hypotf,
    library: narrow libm::powf
);
