//! The graph into Rust: one struct for the mechanism, records for what goes in and comes out, and
//! for every entry point a straight line, a careful path and the function that chooses.
//!
//! Nothing is computed or decided here about the mechanism: what runs is the graph, node by node.
//! Paths into the run-time crate are made in `paths`, names in `names`, and nowhere else.

mod arguments;
mod blocks;
mod body;
mod c_export;
mod cost;
mod derivatives;
mod docs;
mod dominance;
mod entry;
mod explanations;
mod finite;
mod formulas;
mod locals;
mod mentions;
mod modes;
mod names;
mod paths;
mod pieces;
mod results;
mod rows;
mod solver;
mod straight;
pub(crate) mod stubs;
mod sweeps;
mod turning;
mod units;

#[cfg(test)]
pub(crate) mod tests;

use std::collections::HashMap;

use proc_macro2::{Literal, TokenStream, TokenTree};
use quote::quote;

use self::arguments::Arguments;
use self::finite::Bounds;
use self::locals::Locals;
use self::names::Names;
use self::paths::Paths;
use self::pieces::Pieces;
use crate::ir::cost::Operations;
use crate::ir::program::{Entry, EntryKind, Program};
use crate::model::mechanism::{Mechanism, Param, ParamKind};

/// Everything that the declaration of a mechanism expands to.
pub(crate) fn generate(mechanism: &Mechanism, program: &Program) -> TokenStream {
    let cx = Context::new(mechanism, program);
    let (solver, records) = (solver::definition(&cx), results::definitions(&cx));
    let implementations = implementations(&cx);
    quote! { #solver #records #implementations }
}

/// All that is done with the structs, in an unnamed constant: what it imports meets no name of the
/// user's, and its paths are short.
fn implementations(cx: &Context<'_>) -> TokenStream {
    let (import, program) = (cx.paths.import(), cx.program);
    let arguments = cx.paths.import_arguments(arguments::all_names(cx));
    let (solver, records) = (solver::implementation(cx), results::implementations(cx));
    let straight = program.entries.iter().map(|entry| straight::function(cx, entry));
    let checked = program.entries.iter().map(|entry| entry::function(cx, entry));
    let careful = program.entries.iter().map(|entry| explanations::function(cx, entry));
    let formulas = formulas::functions(cx);
    let sweeps = program.entries.iter().map(|entry| sweeps::items(cx, entry));
    let (derivatives, modes) = (derivatives::items(cx), modes::items(cx));
    let (c_export, mentions) = (c_export::items(cx), mentions::items(cx));
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    let (any, real) = (cx.paths.item("Scalar"), cx.paths.item("Real"));
    quote! {
        #[allow(clippy::approx_constant, reason = "a dimension may be near a constant by chance")]
        const _: () = {
            #import
            #arguments
            #solver
            #records
            impl<#scalar: #any> #name<#scalar> { #(#straight)* #formulas }
            impl<#scalar: #real> #name<#scalar> { #(#checked)* #(#careful)* }
            #(#sweeps)*
            #derivatives
            #modes
            #c_export
            #mentions
        };
    }
}

/// What every part of the generated code is made from.
struct Context<'a> {
    mechanism: &'a Mechanism,
    program: &'a Program,
    paths: Paths,
    names: Names,
    locals: Locals,
    costs: HashMap<EntryKind, Operations>,
    /// By the entry point that leads a function of formulas.
    bounds: HashMap<EntryKind, Bounds>,
}

impl<'a> Context<'a> {
    fn new(mechanism: &'a Mechanism, program: &'a Program) -> Self {
        let (paths, names) = (Paths::new(mechanism), Names::new(mechanism));
        let (locals, bounds) = (Locals::new(mechanism, program), HashMap::new());
        let costs = HashMap::new();
        let mut cx = Self { mechanism, program, paths, names, locals, costs, bounds };
        cx.costs = cost::all(&cx);
        cx.bounds = finite::all(&cx);
        cx
    }
}

impl Context<'_> {
    fn entry(&self, kind: EntryKind) -> Option<&Entry> {
        self.program.entries.iter().find(|entry| entry.kind == kind)
    }

    /// The entry point that does the same with the only input's cosine and sine given. Where it
    /// exists the value itself is needed nowhere else, so the code is written once, for it.
    fn on_the_circle(&self, entry: &Entry) -> Option<&Entry> {
        match entry.kind {
            EntryKind::Position => self.entry(EntryKind::PositionAt),
            EntryKind::Velocity => self.entry(EntryKind::VelocityAt),
            EntryKind::Motion => self.entry(EntryKind::MotionAt),
            _ => None,
        }
    }

    /// Whether the entry point computes for itself, and not by way of another.
    fn has_formulas(&self, entry: &Entry) -> bool {
        self.on_the_circle(entry).is_none() && !self.is_velocity_at_unit_rate(entry)
    }

    /// Whether the entry point is that of the coefficients of the only input.
    fn is_velocity_at_unit_rate(&self, entry: &Entry) -> bool {
        entry.kind == EntryKind::Coefficients
            && self.mechanism.inputs.len() == 1
            && self.entry(EntryKind::Velocity).is_some()
    }

    fn arguments(&self, kind: EntryKind) -> Arguments<'_> {
        Arguments::new(self, kind)
    }

    /// The number of rows of `OUTPUTS`.
    fn rows(&self) -> Literal {
        let shapes = self.mechanism.outputs.iter().map(|output| output.kind.shape());
        Literal::usize_unsuffixed(shapes.map(|shape| shape.rates()).sum())
    }

    /// The number of inputs.
    fn columns(&self) -> Literal {
        Literal::usize_unsuffixed(self.mechanism.inputs.len())
    }

    fn numeric_params(&self) -> Vec<&Param> {
        let numeric = |param: &&Param| matches!(param.kind, ParamKind::Number { .. });
        self.mechanism.params.iter().filter(numeric).collect()
    }

    /// A function of the type parameter, which nothing but its bound can provide.
    fn scalar(&self, function: &str) -> Pieces {
        Pieces::path(self.names.scalar.clone(), names::function_name(function))
    }

    /// A constant as the type parameter's number, rounded to each width.
    fn literal(&self, wide: f64, narrow: f32) -> Pieces {
        let (lit, wide, narrow) = (self.scalar("lit"), literal(wide), literal(narrow));
        quote!(#lit(#wide, #narrow)).into()
    }
}

/// The shortest literal that means the number; an infinity, which none means, as a quotient.
fn literal(value: impl std::fmt::Debug) -> Pieces {
    let digits = format!("{value:?}");
    let magnitude = digits.trim_start_matches('-');
    let pieces = match magnitude.parse::<Literal>() {
        Ok(literal) => Pieces::from(TokenStream::from(TokenTree::from(literal))),
        Err(_) => quote!((1.0 / 0.0)).into(),
    };
    if digits.starts_with('-') { pieces.negated() } else { pieces }
}
