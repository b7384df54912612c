//! Motions are right, and so is all that is derived of them: tables, identities, functions of expressions,
//! automatic differentiation, and the interface that answers.

mod derivatives;
mod functions;
mod interface;
mod motion;
