//! `f32` and `f64` under one name, for kernels that are the same in both.

use super::arithmetic::Arithmetic;
use super::{Fusion, arc, sin_cos_f32, sin_cos_f64};

/// `f32` or `f64`.
pub trait Float: Arithmetic {
    /// The kernel behind [`Scalar::sin_cos`](crate::Scalar::sin_cos) of a near argument.
    #[doc(hidden)]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self);

    /// The kernel behind [`Scalar::sin_cos_near`](crate::Scalar::sin_cos_near), of a number alone or of a
    /// lane.
    #[doc(hidden)]
    #[inline(always)]
    fn sin_cos_near_kernel<F: Fusion, const ALONE: bool>(self) -> (Self, Self) {
        self.sin_cos_kernel::<F>()
    }

    /// The kernels behind the arc functions of [`Scalar`](crate::Scalar).
    #[doc(hidden)]
    fn asin_kernel<F: Fusion>(self) -> Self;
    #[doc(hidden)]
    fn acos_kernel<F: Fusion>(self) -> Self;
    #[doc(hidden)]
    fn atan_kernel<F: Fusion>(self) -> Self;
    #[doc(hidden)]
    fn atan2_kernel<F: Fusion>(self, x: Self) -> Self;
}

impl Float for f64 {
    #[inline]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f64::sin_cos::<F>(self)
    }
    #[inline]
    fn sin_cos_near_kernel<F: Fusion, const ALONE: bool>(self) -> (Self, Self) {
        sin_cos_f64::sin_cos_near::<F, ALONE>(self)
    }
    #[inline(always)]
    fn asin_kernel<F: Fusion>(self) -> Self {
        arc::asin::<F>(self)
    }
    #[inline(always)]
    fn acos_kernel<F: Fusion>(self) -> Self {
        arc::acos::<F>(self)
    }
    #[inline(always)]
    fn atan_kernel<F: Fusion>(self) -> Self {
        arc::atan::<F>(self)
    }
    #[inline(always)]
    fn atan2_kernel<F: Fusion>(self, x: Self) -> Self {
        arc::atan2::<F>(self, x)
    }
}

impl Float for f32 {
    #[inline]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f32::sin_cos::<F>(self)
    }
    #[inline(always)]
    fn asin_kernel<F: Fusion>(self) -> Self {
        arc::asinf::<F>(self)
    }
    #[inline(always)]
    fn acos_kernel<F: Fusion>(self) -> Self {
        arc::acosf::<F>(self)
    }
    #[inline(always)]
    fn atan_kernel<F: Fusion>(self) -> Self {
        arc::atanf::<F>(self)
    }
    #[inline(always)]
    fn atan2_kernel<F: Fusion>(self, x: Self) -> Self {
        arc::atan2f::<F>(self, x)
    }
}
