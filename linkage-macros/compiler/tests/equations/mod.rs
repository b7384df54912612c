//! The formulas against an independent route: velocity and acceleration of every driver and group
//! against differences of the position in a hundred digits, and positions against the joints'
//! own conditions.

pub(crate) mod by_input;
pub(crate) mod clearances;
pub(crate) mod declarations;
pub(crate) mod driven_load;
pub(crate) mod dynamics;
pub(crate) mod forces;
pub(crate) mod friction;
pub(crate) mod friction_forward;
pub(crate) mod functions;
pub(crate) mod joints;
pub(crate) mod laws;
pub(crate) mod left_out;
pub(crate) mod newton_euler;
pub(crate) mod parallelograms;
pub(crate) mod rates;
pub(crate) mod slip_rounding;
pub(crate) mod straight_proofs;

pub(crate) use linkage_compiler::equations::*;
