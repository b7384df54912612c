//! The compiler behind `linkage-core`'s `mechanism!`; users depend on `linkage-core`.
//!
//! # The phases
//!
//! ```text
//! source text ─syntax─▶ tree ─model─▶ mechanism ─equations─▶ graph ─passes─▶ smaller graph ─codegen─▶ Rust
//! ```
//!
//! | room | what it does | what it never does |
//! |---|---|---|
//! | `pipeline` | START HERE: the phases in order | |
//! | `diagnostics` | collects mistakes, stops at the barriers | |
//! | `exact` | real constants without error, rounded once | |
//! | `syntax` | tokens and spans into a tree | resolve a name |
//! | `model` | names into ids, dimensions, one function a rule | know a formula |
//! | `equations` | the formulas of every driver and group, once | know how code is written |
//! | `ir` | the expression graph, its cost, its text, its interpreter | know a mechanism |
//! | `passes` | make the graph smaller without changing what it means | know a mechanism |
//! | `codegen` | graph into functions, structs and docs | compute |
//!
//! Data flows one way: each phase takes the one before by reference and returns a new value.

mod codegen;
mod diagnostics;
mod equations;
mod exact;
#[cfg(test)]
mod expansions;
#[cfg(test)]
mod fuzz;
mod interface;
mod ir;
mod lower;
mod model;
#[cfg(test)]
mod oracle;
mod passes;
mod pipeline;
mod syntax;

/// Declares a planar mechanism and generates its solver.
///
/// ```text
/// mechanism! {
///     /// Strip-mill flying shear.
///     pub struct FlyingShear {
///         input theta: angle;
///         ground A(0, 0), D(665.7mm, 0);
///         crank AB(A) -> B        { length: 80mm, angle: theta }
///         rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
///         point blade on BC at (500mm, -60mm);
///     }
/// }
/// ```
///
/// A dyad has two links, two outer joints and one inner joint; its letters name them in order, and
/// so does its statement: `link(outer joint), link(outer joint) -> inner pin`. An R outer joint
/// takes a point, a P outer joint takes a guide, and an inner P joint makes no pin. The README of
/// `linkage-core` lists every statement.
///
/// Mistakes are reported at the tokens that made them, all of one declaration together.
///
/// The code relies on nothing of the module it stands in, and meets no name of the user's, as long
/// as none in scope ends in an underscore: such names are the generated code's own.
/// `examples/four_bar_expanded.rs` in the repository shows all of it for one mechanism.
#[proc_macro]
pub fn mechanism(source: proc_macro::TokenStream) -> proc_macro::TokenStream {
    pipeline::compile(source.into()).into()
}
