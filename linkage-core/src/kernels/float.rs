//! `f32` and `f64` under one name, for kernels that are the same in both.

use super::arithmetic::Arithmetic;
use super::{Fusion, arc, sin_cos_f32, sin_cos_f64};
use crate::scalar::elementary;

macro_rules! kernels {
    ($($one:ident $of_one:ident)*; $($two:ident $of_two:ident)*) => {
        /// The kernels behind the elementary functions of [`Scalar`](crate::Scalar).
        pub trait Elementary: Arithmetic {
            $(#[doc(hidden)]
            fn $of_one<F: Fusion>(self) -> Self;)*
            $(#[doc(hidden)]
            fn $of_two<F: Fusion>(self, other: Self) -> Self;)*
        }
    };
}

macro_rules! kernels_of_a_width {
    ($t:ident $width:ident: $($one:ident $of_one:ident)*; $($two:ident $of_two:ident)*) => {
        impl Elementary for $t {
            $(#[inline(always)]
            fn $of_one<F: Fusion>(self) -> Self {
                arc::$width::$one::<F>(self)
            })*
            $(#[inline(always)]
            fn $of_two<F: Fusion>(self, other: Self) -> Self {
                arc::$width::$two::<F>(self, other)
            })*
        }
    };
}

elementary!(kernels);
elementary!(kernels_of_a_width f64 wide:);
elementary!(kernels_of_a_width f32 narrow:);

/// `f32` or `f64`.
pub trait Float: Elementary {
    /// The kernel behind [`Scalar::sin_cos`](crate::Scalar::sin_cos) of a near argument.
    #[doc(hidden)]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self);

    /// The kernel behind [`Scalar::sin_cos`](crate::Scalar::sin_cos) of any other argument.
    #[doc(hidden)]
    fn sin_cos_far_kernel<F: Fusion>(self) -> (Self, Self);

    /// The kernel behind [`Scalar::sin_cos_near`](crate::Scalar::sin_cos_near), of a number alone or of a
    /// lane.
    #[doc(hidden)]
    #[inline(always)]
    fn sin_cos_near_kernel<F: Fusion, const ALONE: bool>(self) -> (Self, Self) {
        self.sin_cos_kernel::<F>()
    }
}

impl Float for f64 {
    #[inline]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f64::sin_cos::<F>(self)
    }
    #[inline]
    fn sin_cos_far_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f64::sin_cos_far::<F>(self)
    }
    #[inline]
    fn sin_cos_near_kernel<F: Fusion, const ALONE: bool>(self) -> (Self, Self) {
        sin_cos_f64::sin_cos_near::<F, ALONE>(self)
    }
}

impl Float for f32 {
    #[inline]
    fn sin_cos_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f32::sin_cos::<F>(self)
    }
    #[inline]
    fn sin_cos_far_kernel<F: Fusion>(self) -> (Self, Self) {
        sin_cos_f32::sin_cos_far::<F>(self)
    }
}
