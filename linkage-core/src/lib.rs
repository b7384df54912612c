//! Static solvers for planar mechanisms.
//!
//! A mechanism is declared by [`mechanism!`] the way it is built, a driver and then Assur groups of
//! class II, and compiled to straight-line code for position, velocity and acceleration. This
//! crate is what the generated code runs on: the numbers, the results, the errors.
//!
//! # A mechanism
//!
//! ```
//! use linkage_core::{mechanism, SolveError};
//!
//! mechanism! {
//!     /// A slider-crank with an offset.
//!     pub struct Press {
//!         input theta: angle;
//!         /// The connecting rod.
//!         param rod = 210mm;
//!
//!         ground A(0, 0);
//!         guide bed through (0, 12mm) along 0deg;
//!
//!         crank AB(A) -> B          { length: 50mm, angle: theta }
//!         rrp   BC(B), ram(bed) -> C { length: rod, mode: ahead }
//!
//!         output ram.slide, BC.angle;
//!     }
//! }
//!
//! let mut press = Press::new();
//! let p = press.position(0.3)?;
//! assert!((p.ram.slide - 0.257_748).abs() < 1e-6);
//!
//! // The rod no longer reaches the bed.
//! press.rod = 0.001;
//! let error = press.position(0.3).unwrap_err();
//! assert!(matches!(error, SolveError::OutOfReach { group: "BC, ram", .. }));
//! # Ok::<(), SolveError>(())
//! ```
//!
//! # Numbers
//!
//! The generated struct has the scalar as its parameter, `f64` by default. Anything that is a
//! [`Scalar`] runs through the same code: `f32` (`Press::<f32>::default()`), and with the feature
//! `ad` the dual numbers of `num-dual`, which `lift` converts to. A number whose comparisons
//! answer with a plain `bool` is a [`Real`] and can be refused a pose.
//!
//! # Frames and signs
//!
//! Angles run from +x, counter-clockwise, in radians; lengths are in metres. A bar's frame has its
//! origin at its outer joint and its x towards the inner pin; a block's has its origin at its pin
//! and its x along its guide. A pin on a guide through K with direction u and normal n (90°
//! counter-clockwise from u) is K + slide·u + offset·n.
//!
//! # The limit of assembly
//!
//! A pose that is short of assembly by no more than four units in the last place of the longest
//! length of the group (the distance of its outer joints included) is assembled at the limit: a
//! press at its dead centre does not fault by a rounding. Beyond that it is
//! [`SolveError::OutOfReach`]. Velocities at the limit are [`SolveError::Singular`].
//!
//! # Features
//!
//! - `macros` (default): the macro.
//! - `ad` (default): `jacobian` and `sensitivity` by automatic differentiation; brings `num-dual`
//!   and `nalgebra`, and with them the standard library.
//! - `std`: run-time choice of instruction set for sweeps.
//!
//! Without `ad` and `std` the crate is `no_std` and needs `libm` alone.
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
mod limit;
mod modes;
mod primitive;
#[doc(hidden)]
pub mod private;
mod results;
mod scalar;
mod tracker;

pub use cost::{Cost, Operations};
pub use error::SolveError;
pub use kernels::{Float, Fused, Fusion, Plain};
pub use modes::{Sense, Side};
pub use results::{
    AngularAcceleration, AngularVelocity, Direction, Point, Slide, SlidingAcceleration,
    SlidingDirection, SlidingVelocity,
};
pub use scalar::{Mask, Real, Scalar};
pub use tracker::Tracker;

#[cfg(feature = "macros")]
pub use linkage_macros::mechanism;

/// The examples of the README are tests.
#[cfg(all(doctest, feature = "macros"))]
#[doc = include_str!("../../README.md")]
struct Readme;
