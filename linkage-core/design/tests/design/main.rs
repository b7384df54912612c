//! Dimensions and tolerances of machines whose answers are known. One program: each would compile the optimiser, and
//! the solvers by dual numbers, once more.

mod circles;
mod curves;
mod function_generation;
mod mending;
mod near_limit;
mod tolerances;
