//! The expression graph between the equations and the generated code: its nodes, what is solved at run
//! time, the programs made of them, their cost, their text form, and an interpreter as oracle. No formula of a
//! mechanism and no rewrite rule lives here.

pub mod check;
pub mod construct;
pub mod cost;
pub mod graph;
pub mod hash;
pub mod implicit;
pub mod interpret;
pub mod liveness;
mod node;
pub mod operations;
pub(crate) mod posing;
pub mod program;
