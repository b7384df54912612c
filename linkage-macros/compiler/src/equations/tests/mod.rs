//! The formulas against an independent route: velocity and acceleration of every driver and group
//! against differences of the position in a hundred digits, and positions against the joints'
//! own conditions.

mod by_input;
mod clearances;
pub(crate) mod declarations;
mod driven_load;
mod dynamics;
pub(crate) mod forces;
mod friction;
mod friction_forward;
mod joints;
mod laws;
mod left_out;
mod newton_euler;
pub(crate) mod parallelograms;
mod rates;
mod slip_rounding;
mod straight_proofs;
