//! Operations that the target does in one instruction but the language reaches only through the standard
//! library: square root and fused multiplication and addition.
//!
//! With the standard library linked (features `std` and `ad`) both are compiler intrinsics, which
//! optimisation understands and vectorises. Without it, `libm`'s square root is one `sqrtsd` on
//! x86-64 and one `fsqrt` on 64-bit ARM, as inline assembly that does not vectorise, and integer
//! code elsewhere; its fused operation is right everywhere and fast nowhere but on 64-bit ARM.

#[cfg(any(feature = "std", feature = "ad", test))]
mod intrinsic {
    #[inline]
    pub(crate) fn sqrt(x: f64) -> f64 {
        x.sqrt()
    }

    #[inline]
    pub(crate) fn sqrtf(x: f32) -> f32 {
        x.sqrt()
    }

    #[inline]
    pub(crate) fn fma(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline]
    pub(crate) fn fmaf(a: f32, b: f32, c: f32) -> f32 {
        a.mul_add(b, c)
    }

    /// True if the compilation's own target has the fused operation as an instruction.
    pub(crate) const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
}

#[cfg(any(feature = "std", feature = "ad", test))]
pub(crate) use intrinsic::{FUSED, fma, fmaf, sqrt, sqrtf};

#[cfg(not(any(feature = "std", feature = "ad", test)))]
pub(crate) use libm::{fma, fmaf, sqrt, sqrtf};

#[cfg(not(any(feature = "std", feature = "ad", test)))]
pub(crate) const FUSED: bool = cfg!(target_arch = "aarch64");
