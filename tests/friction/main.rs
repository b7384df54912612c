//! Friction that follows from reactions, against the full matrix, closed forms and laws that hold of every
//! machine.

mod cases;
mod forward;
mod laws;
mod table;
