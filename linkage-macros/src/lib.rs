//! The compiler behind `linkage-core`'s `mechanism!`; users depend on `linkage-core`.
//!
//! # The phases
//!
//! ```text
//! source text ─syntax─▶ tree ─model─▶ mechanism ─equations─▶ graph ─passes─▶ smaller graph
//!                                         └─interface─▶ what is offered ─lower─▶ routines ─codegen─▶ Rust
//! ```
//!
//! | room | what it does | what it never does |
//! |---|---|---|
//! | `pipeline` | START HERE: the phases in order | |
//! | `diagnostics` | collects mistakes, stops at the barriers | |
//! | `exact` | real constants without error, rounded once | |
//! | `syntax` | tokens and spans into a tree | resolve a name |
//! | `reach` | what constant dimensions say before anything is solved, exactly | know a mechanism |
//! | `model` | names into ids, dimensions, one function a rule | know how a mechanism is solved |
//! | `interface` | what is offered: entry points, records, units, labels | compute or print |
//! | `ir` | the expression graph, its cost, its text, its interpreter | know a mechanism |
//! | `equations` | the formulas of every driver and group, once | know how code is written |
//! | `passes` | make the graph smaller without changing what it means | know a mechanism |
//! | `lower` | which routine computes what, in which order, and what it asks | print |
//! | `codegen` | routines into functions, structs and docs | decide |
//!
//! Imports point to earlier rooms only, and data flows one way: each phase takes the one before by
//! reference and returns a new value.
//!
//! # A walk through the house
//!
//! `rrr BC(B), DC(D) -> C { lengths: (632mm, l), mode: elbow }` behind a crank at `theta`:
//!
//! | room | the length `632mm` | the input `theta` | the mode `elbow` | a mistake, `632kg` |
//! |---|---|---|---|---|
//! | `syntax` | digits, unit, span | a name | a name | a number like another |
//! | `model` | `Expr::Constant`, 79/125 m, not zero or less | `Expr::Input`, an angle | `Mode::Param` | a message at its token; what follows is a stand-in |
//! | `interface` | | an argument of every entry point, a column | | the same signatures |
//! | `equations` | a jet whose rates are zeros that leave no trace | a jet: value, rate, second rate | the sign of √S in `rrr.rs` | |
//! | `ir` | an interned constant | a leaf an order | a leaf, ±1 | one zero for all results |
//! | `passes` | (l₂ − l₃)² is one constant | its sine and cosine stay | nothing to do | |
//! | `lower` | positive for sure: no check | asked for its size where that proves more than results do | never asked | |
//! | `codegen` | `T::lit(0.632, 0.632)`, rounded once a width | `theta`, `theta_rate` | `Side::sign(self.elbow)` | |
//!
//! The parameter `l` goes where the length goes, but for three rooms: in `equations` it stands under
//! the condition that it is positive, in `lower` it can be anything, so results are asked, and in
//! `codegen` it is `self.l`.

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
mod reach;
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
/// takes a point, a P outer joint takes a guide, and an inner P joint makes no pin. The module
/// `linkage_core::reference` has every statement, what is generated, and machines to copy from.
///
/// Mistakes are reported at the tokens that made them, all of one declaration together.
///
/// The code relies on nothing of the module it stands in, and meets no name of the user's, as long
/// as none in scope ends in an underscore: such names are the generated code's own.
/// `examples/four_bar_expanded.rs` in the repository shows all of it for one mechanism.
#[proc_macro]
pub fn mechanism(source: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let features =
        pipeline::Features { sketch: cfg!(feature = "sketch"), serde: cfg!(feature = "serde") };
    pipeline::compile(source.into(), features).into()
}
