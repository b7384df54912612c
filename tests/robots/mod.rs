//! Planar loops in robots: transmissions both ways, beside an engine that closes loops by constraints, and
//! machines that others' solvers were seen to lose.

mod ankle;
mod bucket;
mod gripper;
mod lost_by_others;
mod mujoco;
