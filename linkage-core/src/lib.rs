//! Static solvers for planar mechanisms: what the code that `mechanism!` generates runs on, and
//! what it returns.
//!
//! # Numbers
//! A solver is generic over its number, a [`Scalar`]:
//! - `f64` and `f32`, each in its own precision throughout;
//! - [`Lanes`] of them, for several poses at once;
//! - the dual numbers of `num-dual` (feature `ad`), for derivatives of any output with respect to
//!   any input or parameter: `Dual`, `Dual2`, `Dual3`, `HyperDual`, `HyperHyperDual`, the vector
//!   variants of fixed size, and dual numbers of dual numbers.
//!
//! Those that are single numbers, all but the lanes, are [`Real`]: they can decide, and their
//! solvers return a `Result`.
//!
//! # Results and errors
//! Positions, velocities and accelerations are plain `Copy` records ([`Point`], [`Direction`],
//! [`AngularVelocity`], …) in SI units and radians, counter-clockwise positive. Why there is no
//! result is a [`SolveError`], which names the group of links it happened to.
//!
//! # Features
//! - `macros` (default): the `mechanism!` macro.
//! - `ad` (default): dual numbers, `jacobian` and `sensitivity`. Needs the standard library.
//! - `std`: takes square roots and fused operations from the standard library, which the
//!   optimiser understands better than the assembly that stands in for them without it.
//!
//! Without `ad` and `std` the crate needs no standard library. It never allocates, and no solver
//! panics.
//!
//! # Precision and targets
//! On a target with fused multiplication and addition (`-C target-feature=+fma`, any 64-bit ARM)
//! and with the standard library linked, single numbers use it. Elsewhere they never do, so that
//! results are the same bits on every such target, a microcontroller and the machine it is
//! developed on included.
#![no_std]
#![deny(unsafe_code)]

extern crate self as linkage_core;

#[cfg(any(feature = "std", feature = "ad", test))]
extern crate std;

mod careful;
mod cost;
#[cfg(feature = "ad")]
mod derivatives;
#[cfg(feature = "ad")]
mod dual;
mod error;
mod kernels;
mod lanes;
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
pub use lanes::{LaneMask, Lanes};
pub use modes::{Sense, Side};
pub use results::{
    AngularAcceleration, AngularVelocity, Direction, Point, Slide, SlidingAcceleration,
    SlidingDirection, SlidingVelocity,
};
pub use scalar::{Mask, Real, Scalar};

#[cfg(feature = "macros")]
pub use linkage_macros::mechanism;
