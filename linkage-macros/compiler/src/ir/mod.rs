//! The expression graph between the equations and the generated code: its nodes, what is solved at run
//! time, the programs made of them, their cost, their text form, and an interpreter as oracle. No formula of a
//! mechanism and no rewrite rule lives here.

pub(crate) mod check;
pub(crate) mod construct;
pub(crate) mod cost;
pub(crate) mod graph;
pub(crate) mod hash;
pub(crate) mod implicit;
pub(crate) mod interpret;
pub(crate) mod liveness;
mod node;
mod operations;
pub(crate) mod posing;
pub(crate) mod program;

#[cfg(test)]
pub(crate) mod text;
