//! The choice between a·b + c with one rounding and with two.
//!
//! A property of the type, not of the build: inside a function compiled for another instruction
//! set than the rest, `cfg!` still answers for the rest.

use core::fmt::Debug;

use super::native;

/// The choice between a fused and a plain a·b + c: one of [`Fused`] and [`Plain`].
pub trait Fusion: Copy + Debug + PartialEq + Send + Sync + sealed::SealedFusion + 'static {
    /// True if a·b + c rounds once.
    const FUSED: bool;
}

/// a·b + c rounds once. For code compiled for a target that has the instruction; elsewhere every
/// such operation is a library call, five to ten times slower, with the same result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fused {}

/// a·b + c rounds twice, which is what every target does fast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plain {}

impl Fusion for Fused {
    const FUSED: bool = true;
}

impl Fusion for Plain {
    const FUSED: bool = false;
}

/// The choice for single numbers: fused where the compilation's own target has the instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Native {}

impl Fusion for Native {
    const FUSED: bool = native::FUSED;
}

mod sealed {
    pub trait SealedFusion {}
    impl SealedFusion for super::Fused {}
    impl SealedFusion for super::Plain {}
    impl SealedFusion for super::Native {}
}
