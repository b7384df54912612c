//! The closed forms as the best hand known writes them: what the generated solvers are measured against. Dimensions are
//! `f64`; bars and blocks on bars are in either width, what slides otherwise in `f64`.
//!
//! - [`crank_dyad`]: the four-bar, a crank on the ground and two bars to a point of the ground;
//! - [`dyad`]: two bars between any two joints, of which the second may be a point of the ground;
//! - [`swinging_block`]: crank, rpr and rpp;
//! - [`rails`]: bars to blocks on rails of the ground, and yokes;
//! - [`guides`]: blocks on bars and on guides of links;
//! - [`cylinder`]: a bar that a cylinder drives.
//!
//! Longer chains are composed of these mechanically: a bar's points are the joints of the next dyad.
//! All is inlined into a caller whose dimensions are constants, and what it does not read is never
//! computed. Nothing is asked but whether the bars reach each other.

#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "what is no number is refused as well")]

pub mod cylinder;
pub mod dyads;
pub mod guides;
pub mod plane;
pub mod rails;
pub mod sine;

mod sliding;

pub use dyads::{CrankDyad, Dyad, Joint, crank_dyad, dyad};
pub use plane::{Bar, Moving, Vector};
pub use sine::cos_sin;
pub use sliding::swinging_block;

use crate::number::Number;

/// a·b + c, fused where the target has the instruction.
#[inline(always)]
pub(crate) fn fused<F: Number>(a: F, b: F, c: F) -> F {
    F::fused(a, b, c)
}
