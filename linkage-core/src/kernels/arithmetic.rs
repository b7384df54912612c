//! The arithmetic of the kernels, which is the same in both widths.

use super::{Fusion, native};
use crate::Real;

/// Arithmetic of `f32` and `f64`. No other type has it.
pub trait Arithmetic: Real {
    /// 2^⌈p/2⌉ + 1 for p bits of precision: multiplying by it splits a number in two halves whose
    /// products are exact.
    #[doc(hidden)]
    const SPLITTER: Self;

    /// The number without its sign.
    #[doc(hidden)]
    #[must_use]
    fn magnitude(self) -> Self;

    /// a·b + c with one rounding, whatever the target.
    #[doc(hidden)]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self;

    /// a·b + c with one rounding or two, as `F` says.
    #[doc(hidden)]
    #[inline]
    fn fused_by<F: Fusion>(a: Self, b: Self, c: Self) -> Self {
        if F::FUSED { Self::multiply_add(a, b, c) } else { a * b + c }
    }
}

impl Arithmetic for f64 {
    const SPLITTER: Self = 134_217_729.0;

    #[inline]
    fn magnitude(self) -> Self {
        self.abs()
    }
    #[inline]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self {
        native::fma(a, b, c)
    }
}

impl Arithmetic for f32 {
    const SPLITTER: Self = 4097.0;

    #[inline]
    fn magnitude(self) -> Self {
        self.abs()
    }
    #[inline]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self {
        native::fmaf(a, b, c)
    }
}
