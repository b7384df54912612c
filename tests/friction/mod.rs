//! Friction that follows from reactions, against the full matrix, closed forms and laws that hold of every
//! machine.

#![allow(clippy::excessive_precision, reason = "numbers have the digits of their reference")]

mod cases;
mod derivatives;
mod draws;
mod driven_by_load;
mod forward;
mod laws;
mod matrix;
mod others;
mod sizes;
mod still;
mod table;
