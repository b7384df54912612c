//! Every pass: what it rewrites, what it leaves alone, and that it changes no meaning.

mod affine;
mod budgets;
mod chain;
mod collect;
mod conditions;
mod dynamics;
mod growth;
mod meaning;
mod rules;
