//! The compiler behind `linkage-core`'s `mechanism!`, as a library: the tokens of a declaration in,
//! the tokens of its solver and the mistakes out.
//!
//! Whoever declares mechanisms depends on `linkage-core`, whose macro calls [`compile`]. Programs that
//! check or print declarations outside a compiler call it themselves; there every span has a line and
//! a column.
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
//! | `blocks` | finds the declarations in a program | |
//! | `brackets` | which bracket is at fault where a text is no sequence of tokens | |
//! | `diagnostics` | collects mistakes, stops at the barriers | |
//! | `function` | the functions that expressions call, a row each | compute |
//! | `exact` | real constants without error, rounded once | |
//! | `syntax` | tokens and spans into a tree | resolve a name |
//! | `written_places` | where the places of points are written, for editors | |
//! | `reach` | what constant dimensions say before anything is solved, exactly | know a mechanism |
//! | `chain` | a machine as it is drawn, cut into drivers and groups by counting freedoms | know a name, write a message |
//! | `model` | names into ids, dimensions, one function a rule | know how a mechanism is solved |
//! | `interface` | what is offered: entry points, records, units, labels | compute or print |
//! | `ir` | the expression graph, what is solved at run time, costs, text, an interpreter | know a mechanism |
//! | `equations` | the formulas of every driver and group, once | know how code is written |
//! | `passes` | make the graph smaller without changing what it means | know a mechanism |
//! | `prove` | bounds on the rounding errors of a graph, over a range of its inputs | know a mechanism |
//! | `lower` | which routine computes what, in which order, and what it asks | print |
//! | `codegen` | routines into functions, structs and docs, a folder a language: Rust, C with FMI's XML, structured text, JavaScript | decide |
//! | `report` | what is proved of a solver, in numbers; `pipeline` alone asks for it | print |
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
//! | `model` | `Expr::Constant`, 79/125 m, not zero or less | `Expr::Input`, an angle | `Mode::Param` | a message at its token; what follows is a stub |
//! | `interface` | | an argument of every entry point, a column | | the same signatures |
//! | `equations` | a jet whose rates are zeros that leave no trace | a jet: value, rate, acceleration | the sign of √S in `rrr.rs` | |
//! | `ir` | an interned constant | a leaf an order | a leaf, ±1 | one zero for all results |
//! | `passes` | (l₂ − l₃)² is one constant | its sine and cosine stay | nothing to do | |
//! | `lower` | positive for sure: no check | asked for its size where that proves more than results do | never asked | |
//! | `codegen` | `T::lit(0.632, 0.632)`, rounded once a width | `theta`, `theta_rate` | `Side::sign(self.elbow)` | |
//!
//! The parameter `l` goes where the length goes, but for three rooms: in `equations` it stands under
//! the condition that it is positive, in `lower` it can be anything, so results are asked, and in
//! `codegen` it is `self.l`.

// Items that are public for tests link to private ones.
#![allow(rustdoc::private_intra_doc_links)]

#[cfg(feature = "macro")]
extern crate proc_macro;

// The rooms are public for the tests of this crate alone, which are a package of their own.
#[doc(hidden)]
pub mod blocks;
#[doc(hidden)]
pub mod brackets;
#[doc(hidden)]
pub mod chain;
#[doc(hidden)]
pub mod codegen;
#[doc(hidden)]
pub mod diagnostics;
#[doc(hidden)]
pub mod equations;
#[doc(hidden)]
pub mod exact;
#[doc(hidden)]
pub mod function;
#[doc(hidden)]
pub mod interface;
#[doc(hidden)]
pub mod ir;
#[doc(hidden)]
pub mod lower;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod passes;
#[doc(hidden)]
pub mod pipeline;
#[doc(hidden)]
pub mod prove;
#[doc(hidden)]
pub mod reach;
#[doc(hidden)]
pub mod report;
#[doc(hidden)]
pub mod syntax;
#[doc(hidden)]
pub mod written_places;

pub use blocks::{by_set, declarations, machine_and_set, solver_name};
pub use brackets::unbalanced;
pub use codegen::drawn_plan::{PlanMember, PlanParts, PlanSpring, PlanStatement};
pub use codegen::script::page::PageParts;
pub use diagnostics::{Diagnostic, Level};
pub use ir::posing::{Conditions, GuardedValue, SoughtRoot};
pub use model::PlanarQuantity;
pub use pipeline::{
    DrawnPose, File, Options, Output, PlanarBodies, PlanarBody, PlanarGuide, PlanarInput,
    PlanarSpring, PlanarStop, WrittenValue, c, c_transfers, check, compile, drawing, fmu, page,
    planar_bodies, quantity, report, st,
};
pub use report::{
    BoundReport, EntryReport, LimitReport, OperationsReport, RangeReport, Report, ReportOptions,
    ResultReport, TransmissionReport,
};
pub use written_places::{WrittenPlace, places};
