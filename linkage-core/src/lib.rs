//! Static solvers for planar mechanisms.
#![no_std]
#![deny(unsafe_code)]

extern crate self as linkage_core;

#[cfg(any(feature = "std", feature = "ad", test))]
extern crate std;

mod careful;
mod cost;
#[cfg(feature = "ad")]
mod derivatives;
mod error;
mod kernels;
mod limit;
mod modes;
mod primitive;
#[doc(hidden)]
pub mod private;
mod results;
mod scalar;

pub use cost::{Cost, Operations};
pub use error::SolveError;
pub use kernels::{Float, Fused, Fusion, Plain};
pub use modes::{Sense, Side};
pub use results::{
    AngularAcceleration, AngularVelocity, Direction, Point, Slide, SlidingAcceleration,
    SlidingDirection, SlidingVelocity,
};
pub use scalar::{Mask, Real, Scalar};

#[cfg(feature = "macros")]
pub use linkage_macros::mechanism;
