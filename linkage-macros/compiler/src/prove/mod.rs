//! Bounds on the rounding errors of a program that hold for every input of a range.
//!
//! # What is proved
//! A computed node is v = f(operands) + e, where |e| is at most the node's own error ([`own_error`]): half a
//! last place of the largest |f|, or what a kernel promises. Scale all errors of one call by t from 0 (the
//! machine in real numbers, at its decimals) to 1 (what is computed). Every v(t) lies in an interval that is
//! evaluated with each node widened by its e, so by the mean value theorem
//!
//! computed − exact = Σ A e, each A a value of the node's adjoint over the same intervals.
//!
//! That leaves no second order out, and supposes no error to be small. It holds wherever every condition of the
//! fast path holds, on targets that round to nearest and keep subnormal numbers, with fused operations and
//! without.
//!
//! # How
//! | module | |
//! |---|---|
//! | `outward` | intervals of `f64`, rounded outwards |
//! | `function_ranges` | the same of functions, and their slopes |
//! | `width` | last places of a width, and what kernels promise |
//! | `sloped` | values with slopes, met from the corners of a box |
//! | `premises` | what inputs, parameters and loads are |
//! | `goal` | what is proved, and which of its results cannot be |
//! | `value` | a node's value from those of its operands |
//! | `own_error` | a node's own error |
//! | `adjoint` | what a change of a node does to a result |
//! | `one_box` | the bounds of all results over one box |
//! | `demand` | the comparisons of the fast path |
//! | `boxes` | a range, halved until its bounds are near the best |
//!
//! A value is met with what its slope allows from every corner of its box, so that its interval is exact but for
//! rounding where it is monotone. Bounds at corners are lower limits of the best bound: a box is halved until its
//! own is not far above the largest of these.

pub mod adjoint;
pub mod boxes;
pub(crate) mod demand;
pub mod function_ranges;
pub mod goal;
pub mod one_box;
pub mod outward;
mod own_error;
pub mod premises;
pub mod sloped;
mod value;
pub mod width;
