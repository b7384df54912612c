//! The slow path: the same formulas once more, each condition looked at in full. It runs only
//! where the fast path's mask said no.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{function_name, generated, text};
use super::{docs, formulas, results};
use crate::interface::entries::Entry;
use crate::interface::{EntryId, labels};
use crate::lower::routine::{Adapted, Asked, Compute};

/// The name of the function on the slow path of an entry point.
pub(super) fn name(entry: &Entry) -> Ident {
    function_name(&format!("explain_{}_", entry.name))
}

/// What a public function calls; a given cosine and sine are brought onto the circle first, an
/// angle's are there.
pub(super) fn call(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, name) = (Arguments::new(cx, entry.given), name(entry));
    let names = arguments.names();
    if !entry.takes_cosine() {
        return quote!(self.#name(#(#names),*));
    }
    let ((given, rates), [cos, sin]) = (names.split_at(2), ["cos_", "sin_"].map(generated));
    let (found, label) = (cx.paths.item("found_on_circle"), text(&cx.mechanism.inputs[0].name));
    quote! {
        let (#cos, #sin) = #found(#(#given,)* #label)?;
        self.#name(#cos, #sin #(, #rates)*)
    }
}

/// The function that says why the fast path of an entry point gave no answer.
pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let (entry, scalar) = (cx.entry(id), &cx.names.scalar);
    let number = quote!(#scalar);
    let arguments = Arguments::new(cx, entry.given);
    let (name, received) = (name(entry), arguments.received(&number));
    let body = match cx.compute(id) {
        Compute::Via { entry: other, given: Adapted::CosineAndSine } => {
            by_cosine(cx, &arguments, cx.entry(*other))
        }
        Compute::Via { entry: other, given: Adapted::UnitRate } => {
            at_unit_rate(cx, &arguments, cx.entry(*other))
        }
        Compute::Own { routine, stage, asked } => {
            let call = formulas::Call { routine: *routine, stage: *stage };
            diagnosed(cx, entry, &arguments, call, asked)
        }
    };
    let [outcome, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let (docs, result) = (docs::slow_path(entry), results::ty(cx, entry.result, &number));
    quote! {
        #docs
        #[cold]
        #[inline(never)]
        fn #name(&self, #(#received),*) -> #outcome<#result, #error> { #body }
    }
}

/// What is given must be finite, then every condition be met, then what comes out be finite.
fn diagnosed(
    cx: &Context<'_>,
    entry: &Entry,
    arguments: &Arguments<'_>,
    call: formulas::Call,
    asked: &Asked,
) -> TokenStream {
    let [findings, result] = ["findings_", "result_"].map(generated);
    let (inputs, formulas) = (finite_inputs(cx, arguments, asked), call.under(cx, &findings));
    let finite = finite_results(cx, entry, asked, &quote!(#result));
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
fn by_cosine(cx: &Context<'_>, arguments: &Arguments<'_>, other: &Entry) -> TokenStream {
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    let label = text(&cx.mechanism.inputs[0].name);
    let (finite, sin_cos) = (cx.paths.item("finite_input"), cx.scalar("sin_cos"));
    let ([sin, cos], name) = (["sin_", "cos_"].map(generated), name(other));
    quote! {
        #finite(#angle, #label)?;
        let (#sin, #cos) = #sin_cos(#angle);
        self.#name(#cos, #sin #(, #rates)*)
    }
}

/// The velocities, given a rate of one.
fn at_unit_rate(cx: &Context<'_>, arguments: &Arguments<'_>, other: &Entry) -> TokenStream {
    let (names, one, velocity) = (arguments.names(), cx.literal(1.0, 1.0), name(other));
    let (result, ok) = (generated("result_"), cx.paths.item("Ok"));
    let rows = results::components(cx, other.result, &quote!(#result));
    quote! {
        let #result = self.#velocity(#(#names,)* #one)?;
        #ok([#([#rows]),*])
    }
}

/// The inputs and parameters that are read, and the test that each is finite.
fn finite_inputs(cx: &Context<'_>, arguments: &Arguments<'_>, asked: &Asked) -> TokenStream {
    let (given, scalar, string) = (generated("given_"), &cx.names.scalar, cx.paths.item("str"));
    let read = |&node| Some((arguments.read(node)?, arguments.label(node)?));
    let pairs = asked.given.iter().filter_map(read);
    let pairs: Vec<_> = pairs.map(|(value, label)| quote!((#value, #label))).collect();
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
fn finite_results(
    cx: &Context<'_>,
    entry: &Entry,
    asked: &Asked,
    result: &TokenStream,
) -> TokenStream {
    if asked.results.is_empty() {
        return TokenStream::new();
    }
    let values = results::components(cx, entry.result, result);
    let labels = labels::of_result(cx.interface, cx.mechanism, entry.result);
    let pairs = asked.results.iter().map(|&at| {
        let (value, label) = (&values[at], &labels[at]);
        quote!((#value, #label))
    });
    let (function, given) = (cx.paths.item("finite_result"), generated("given_"));
    let (value, label) = (generated("value_"), generated("name_"));
    quote!(for &(#value, #label) in &[#(#pairs),*] { #function(#value, #label, &#given)?; })
}
