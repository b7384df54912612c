//! All ways to assemble a group of pins that one unknown solves, proved.
//!
//! `linkage-core` lists them at run time and `linkage-compiler` at the drawing, by the same code. Nothing is allocated, and nothing panics.
//!
//! | part | |
//! |---|---|
//! | [`PinnedGroup`] | the pins and bodies of a group with one unknown |
//! | [`closure`], [`product`] | its equation over any numbers: of one mode, and of all at once |
//! | [`Disc`] | numbers with their roundings |
//! | [`Nodes`], [`zeros`] | the zeros of a polynomial around the circle |
//! | [`Placed`], [`List`] | a group with the numbers of its places, and its assemblies |
//!
//! An assembly is a zero of the closure's product over all modes. Where dyads do not assemble the product is that of a closure and its
//! conjugate, whose zeros are double: a zero at which it changes its sign is an assembly.
//!
//! The product is a trigonometric polynomial of the unknown, whose degree n depends on the kind of group alone. 2n + 1 values over a part of
//! the circle are all of it there, and each is enclosed, with all roundings.

#![no_std]
#![deny(unsafe_code)]

#[cfg(test)]
extern crate std;

mod chebyshev;
mod circle;
mod closure;
mod complex;
mod disc;
mod listed;
mod pinned;
mod placed;
#[cfg(test)]
mod tests;

pub use chebyshev::{Nodes, Polynomial, ZerosFound};
pub use circle::{Budget, CircleOrigin, OnCircle, Searched, zeros};
pub use closure::{Algebra, Twin, closure, product};
pub use disc::Disc;
pub use listed::{Assembly, List, Nearest, Outcome};
pub use pinned::{
    BODIES, BodyPin, ClosureDegree, DYADS, HungBar, MOST_PLACES, PinnedDyad, PinnedGroup, STANDING,
    TURNED,
};
pub use placed::Placed;

/// The greatest degree n of a closure's product over all modes.
pub const MOST_DEGREE: usize = 30;
