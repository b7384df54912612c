//! Exact, static solvers for planar mechanisms, from a drawing of pins and links.
//!
//! [`mechanism!`] takes a machine as it is drawn, or cut by hand into a driver and Assur groups, and generates a solver
//! for its position, velocity, acceleration and forces: straight-line code without heap or panic. Only unknowns, by
//! which groups of class III are solved, friction and a [`Tracker`] iterate. This crate is what the generated code runs
//! on: the numbers, the results, the errors.
//!
//! **[The manual](crate::reference)** begins with a first machine in [Rust](reference::start_in_rust),
//! [C](reference::start_in_c) or [a browser](reference::start_in_a_browser), and has every
//! [statement](reference::statements), [what is
//! generated](reference::start_in_rust#what-a-declaration-generates), [forces and friction](reference::forces), [both
//! directions](reference::both_directions), and [recipes](reference::recipes) to copy. The program `linkage` prints
//! [C99 and FMUs](reference::controllers) of the same declarations, and proves their rounding errors.
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
//!         pin B(0, 50mm), C(200mm, 12mm);
//!         link AB(A, B), ram(C) on bed;
//!         link BC(B, C) { length: rod }
//!         drive AB.angle = theta;
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
//! A solver is generic over its number, a [`Scalar`]:
//! - `f64` and `f32` (`Press::<f32>::default()`), each in its own precision throughout;
//! - [`Lanes`] of them, for several poses at once;
//! - the dual numbers of `num-dual` (feature `ad`), which `lift` converts to, for derivatives of
//!   any output with respect to any input or parameter: `Dual`, `Dual2`, `Dual3`, `HyperDual`,
//!   `HyperHyperDual`, the vector variants of fixed size, and dual numbers of dual numbers.
//!
//! Those that are single numbers, all but the lanes, are [`Real`]: their comparisons are true or false,
//! and their solvers return a `Result`.
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
//! # Derivatives
//!
//! `velocity` and `coefficients` come from each group's own equations and need no feature. With
//! `ad` a solver also has `jacobian`, its outputs by its inputs, and `sensitivity`, its outputs by
//! its parameters; [`differentiate`] takes any rows by any numbers, and [`differentiate_twice`]
//! gives the gradient and the Hessian of one. None of them allocates. Where a derivative does not
//! exist, at the limit of assembly for one, they are [`SolveError::Singular`]; a number that is
//! not finite never comes back as `Ok`. The types are those of [`nalgebra`] and `num_dual`,
//! re-exported so that their versions fit.
//!
//! # Called from C
//!
//! With `export c;` in the declaration every entry point is also a C function, for `double` and for `float`
//! ([control code](reference::controllers#from-c)). No other statement generates unsafe code. This one marks the functions
//! `#[unsafe(no_mangle)]` and follows raw pointers, each of which is tested for null first; that it points to what its
//! type says is C's to keep. A crate that forbids unsafe code cannot export.
//!
//! # Features
//!
//! - `macros` (default): the macro.
//! - `ad` (default): dual numbers, `jacobian` and `sensitivity`; brings `num-dual` and `nalgebra`,
//!   and with them the standard library.
//! - `std` (default): sweeps choose the instruction set while the program runs; square roots and
//!   fused operations come from the standard library, which the optimiser understands better than
//!   the assembly that stands in for them without it.
//! - `nalgebra` (comes with `ad`): points and directions as nalgebra's, and comparisons by `approx`.
//! - `mint`: points as mint's.
//! - `serde`: every record of a mechanism, points, directions, modes and what searches find are written
//!   and read by their fields' names; errors and ranges are written. Without it nothing is generated for
//!   it.
//! - `sketch`: pictures and films of mechanisms; every solver has `sketch` and `film` then. It needs the
//!   standard library and nothing else, and changes nothing of the solvers.
//! - `page`: pages on which mechanisms are dragged; every solver has `page` then, and all of `sketch`.
//!
//! Without `ad`, `std`, `sketch` and `page` the crate is `no_std`, needs `libm` alone and never allocates.
//! No solver panics. `sketch` and `page` allocate.
//!
//! # Precision and targets
//!
//! On a target with fused multiplication and addition (`-C target-feature=+fma`, any 64-bit ARM)
//! and with the standard library linked, single numbers use it. Elsewhere they never do, so that
//! results are the same bits on every such target, a microcontroller and the machine it is
//! developed on included.
//!
//! # Versions
//!
//! Rust 1.89 or later; a later one may be asked for by any minor version. What semantic versioning covers is what a
//! declaration means, the names that it generates, this crate's visible items, and the numbers to the tolerances that
//! the manual states. It does not cover the words of messages, the last bits of a number, the code that a declaration
//! expands to, or hidden items. A new major version of [`nalgebra`] or `num_dual` is one of this crate.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![deny(unsafe_code)]

extern crate self as linkage_core;

#[cfg(any(feature = "std", feature = "nalgebra", test))]
extern crate std;

pub mod assemblies;
mod c_interface;
#[cfg(test)]
mod cases;
mod chain_rule;
mod checks;
mod clearance;
mod conversions;
mod cost;
mod crossing;
#[cfg(feature = "ad")]
mod derivatives;
mod diagnosis;
#[cfg(feature = "ad")]
mod dual;
mod error;
pub mod find;
mod friction;
mod kernels;
mod lanes;
mod library_function;
mod limit;
mod mechanism;
mod mixed;
mod modes;
mod parameters;
mod plane;
mod primitive;
#[doc(hidden)]
pub mod private;
pub mod range;
mod record;
pub mod reference;
mod resolver;
mod results;
mod roots;
mod scalar;
mod shown;
#[cfg(feature = "sketch")]
pub mod sketch;
mod slow_path;
mod solver;
mod sweep;
mod tracker;
mod transfer;
mod unavailable;

pub use cost::{Cost, Operations, SearchCost};
pub use crossing::Trend;
#[cfg(feature = "ad")]
pub use derivatives::{Derivatives, Differentiable, differentiate, differentiate_twice};
pub use error::SolveError;
pub use kernels::{Float, Fused, Fusion, Plain};
pub use lanes::{LaneMask, Lanes};
pub use library_function::LibraryFunction;
pub use mechanism::Mechanism;
pub use mixed::{Given, Mixed};
pub use modes::{Sense, Side};
pub use parameters::Parameters;
pub use record::Record;
pub use results::{
    AngularAcceleration, AngularVelocity, Direction, Force, GuideForce, Point, Shaking, Slide,
    SlidingAcceleration, SlidingDirection, SlidingVelocity,
};
pub use scalar::{Mask, Real, Scalar};
pub use solver::Solver;
pub use sweep::{LengthMismatch, Progress, Series, Status, unwanted};
pub use tracker::Tracker;
pub use transfer::{CarriesOver, Transfer, TransferError};
pub use unavailable::Inputs;

#[cfg(feature = "nalgebra")]
pub use nalgebra;
#[cfg(feature = "ad")]
pub use num_dual;

/// A solver of a machine that is declared as it is drawn, or cut into groups; [the manual](crate::reference) has every
/// statement.
///
#[cfg(feature = "macros")]
pub use linkage_macros::mechanism;

/// The examples of the README are tests.
#[cfg(all(doctest, feature = "macros"))]
#[doc = include_str!("../../README.md")]
struct Readme;
