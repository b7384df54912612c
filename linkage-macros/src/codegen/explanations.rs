//! The careful path: the same formulas once more, each condition looked at in full. It runs only
//! where the straight line's mask said no.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::body::Body;
use super::names::{function_name, generated, text};
use super::{Context, docs, entry, formulas, results, rows};
use crate::ir::graph::Node;
use crate::ir::liveness::Course;
use crate::ir::program::{Entry, EntryKind};

/// The name of the careful function beside an entry point.
pub(super) fn name(kind: EntryKind) -> Ident {
    function_name(&format!("explain_{}_", entry::method(kind)))
}

/// What a public function calls; a given cosine and sine are brought onto the circle first, an
/// angle's are there.
pub(super) fn call(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, name) = (cx.arguments(entry.kind), name(entry.kind));
    let names = arguments.names();
    if !entry::takes_cosine(entry.kind) {
        return quote!(self.#name(#(#names),*));
    }
    let ((given, rates), [cos, sin]) = (names.split_at(2), ["cos_", "sin_"].map(generated));
    let (found, label) = (cx.paths.item("found_on_circle"), text(&cx.mechanism.inputs[0].name));
    quote! {
        let (#cos, #sin) = #found(#(#given,)* #label)?;
        self.#name(#cos, #sin #(, #rates)*)
    }
}

/// The function that says why the straight line of an entry point gave no answer.
pub(super) fn function(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let scalar = &cx.names.scalar;
    let (name, received) = (name(entry.kind), cx.arguments(entry.kind).received(&quote!(#scalar)));
    let body = match cx.on_the_circle(entry) {
        Some(at) => by_cosine(cx, entry, at),
        None if cx.is_velocity_at_unit_rate(entry) => by_velocity(cx),
        None => found(cx, entry),
    };
    let [outcome, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let (docs, result) = (docs::careful(entry), entry::result(cx, entry.kind));
    quote! {
        #docs
        #[cold]
        #[inline(never)]
        fn #name(&self, #(#received),*) -> #outcome<#result, #error> { #body }
    }
}

/// What is given must be finite, then every condition be met, then what comes out be finite.
fn found(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let [findings, result] = ["findings_", "result_"].map(generated);
    let (inputs, formulas) = (finite_inputs(cx, entry), formulas::call(cx, entry, &findings));
    let finite = finite_results(cx, entry, &quote!(#result));
    let [start, ok] = ["Findings", "Ok"].map(|item| cx.paths.item(item));
    quote! {
        #inputs
        let mut #findings = #start::new();
        let #result = #formulas;
        #findings.first()?;
        #finite
        #ok(#result)
    }
}

/// The angle, once it is known to be finite, by its cosine and sine.
fn by_cosine(cx: &Context<'_>, entry: &Entry, at: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    let label = text(&cx.mechanism.inputs[0].name);
    let (finite, sin_cos) = (cx.paths.item("finite_input"), cx.scalar("sin_cos"));
    let ([sin, cos], name) = (["sin_", "cos_"].map(generated), name(at.kind));
    quote! {
        #finite(#angle, #label)?;
        let (#sin, #cos) = #sin_cos(#angle);
        self.#name(#cos, #sin #(, #rates)*)
    }
}

/// The only input's coefficients are the velocities at its unit rate.
fn by_velocity(cx: &Context<'_>) -> TokenStream {
    let (arguments, one) = (cx.arguments(EntryKind::Coefficients), cx.literal(1.0, 1.0));
    let (names, velocity) = (arguments.names(), name(EntryKind::Velocity));
    let (result, ok) = (generated("result_"), cx.paths.item("Ok"));
    let rows = results::components(cx, results::Order::Velocity, &quote!(#result));
    quote! {
        let #result = self.#velocity(#(#names,)* #one)?;
        #ok([#([#rows]),*])
    }
}

/// The inputs and parameters that are read, and the test that each is finite.
fn finite_inputs(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (given, scalar, string) = (generated("given_"), &cx.names.scalar, cx.paths.item("str"));
    let arguments = cx.arguments(entry.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Careful, bounds: None };
    let read = |leaf| Some((arguments.leaf(leaf)?, arguments.label(leaf)?));
    let read = body.leaves(&entry.sinks).into_iter().filter_map(read);
    let pairs: Vec<_> = read.map(|(value, label)| quote!((#value, #label))).collect();
    let count = Literal::usize_unsuffixed(pairs.len());
    let function = cx.paths.item("finite_input");
    let (value, label) = (generated("value_"), generated("name_"));
    quote! {
        let #given: [(#scalar, &'static #string); #count] = [#(#pairs),*];
        for &(#value, #label) in &#given { #function(#value, #label)?; }
    }
}

/// Asks of every result whether it is finite, in order: in a loop, because an early exit for each
/// of a thousand results takes the compiler seconds.
fn finite_results(cx: &Context<'_>, entry: &Entry, result: &TokenStream) -> TokenStream {
    let mut seen = HashSet::new();
    let known = |id| matches!(cx.program.graph.node(id), Node::Constant(_) | Node::Mode(_));
    let values = results::components_of(cx, entry.kind, result);
    let labels = rows::sink_labels(cx, entry.kind);
    let pairs: Vec<_> = (entry.sinks.iter().zip(values.iter().zip(labels)))
        .filter(|&(&sink, _)| !known(sink) && seen.insert(sink))
        .map(|(_, (value, label))| quote!((#value, #label)))
        .collect();
    if pairs.is_empty() {
        return TokenStream::new();
    }
    let (function, given) = (cx.paths.item("finite_result"), generated("given_"));
    let (value, label) = (generated("value_"), generated("name_"));
    quote!(for &(#value, #label) in &[#(#pairs),*] { #function(#value, #label, &#given)?; })
}
