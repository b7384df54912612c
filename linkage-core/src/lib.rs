//! Static solvers for planar mechanisms.
#![no_std]
#![deny(unsafe_code)]

#[cfg(feature = "ad")]
extern crate std;

mod error;
mod scalar;

pub use error::SolveError;
pub use scalar::{Mask, Real, Scalar};

#[cfg(feature = "macros")]
pub use linkage_macros::mechanism;
