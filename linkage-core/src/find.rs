//! The root of an equation between two ends: which input puts an output where it is wanted.
//!
//! A solver answers where a mechanism stands at an input. The other question, at which input an
//! output has a wanted value, has no closed form as soon as there is a second group. It is one
//! scalar equation, f(x) = 0, whose slope the velocity solver gives exactly, and [`Search`] solves
//! it in a number of evaluations that is bounded beforehand ([`Search::MOST`]), whatever f does.
//!
//! # The method
//! 1. f and its slope at both ends. Where an end has the wrong sign because it lies beyond a dead
//!    point, it is moved towards that dead point until the sign is right. Where that is not enough, the
//!    interval is divided: into pieces in which a cubic shows that there is no root of the trend, or up
//!    to one that encloses a root.
//! 2. The first trial is the root of the cubic through values and slopes of both ends: at a dead
//!    point f has a double zero of its slope, which the cubic has too.
//! 3. Newton's steps, each projected onto an interval about the middle of the bracket that halves
//!    with every evaluation. This is what bounds their number: Oliveira and Takahashi, "An
//!    enhancement of the bisection method average performance preserving minmax optimality"
//!    (ITP), ACM Trans. Math. Softw. 47 (2021), with Newton's point in place of theirs.
//! 4. The step that will be below the tolerance is foreseen from the last two, and applied without
//!    an evaluation.
//!
//! With a seed ([`Search::near`]) up to three of Newton's steps come first, and if they converge,
//! nothing else does.
//!
//! Nothing here allocates, panics or knows of mechanisms.

mod named_output;

pub use crate::roots::*;
pub use named_output::OutputError;
pub(crate) use named_output::no_output;
