//! `solve_…`: the formulas read without a branch. They go on regardless, and a mask says in the
//! end whether the result may be used.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::names::{function_name, generated};
use super::{Context, docs, entry, finite, formulas, results};
use crate::ir::program::{Entry, EntryKind};

/// The name of the core of an entry point.
pub(super) fn core_name(entry: &Entry) -> Ident {
    function_name(&format!("core_{}_", entry::method(entry.kind)))
}

/// `solve_…`, and the core that it shares with everything else.
pub(super) fn function(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, scalar) = (cx.arguments(entry.kind), &cx.names.scalar);
    let (declared, received) =
        (arguments.declared(&quote!(#scalar)), arguments.received(&quote!(#scalar)));
    let (converted, answer) = (arguments.converted(&quote!(#scalar)), answer(cx, entry));
    let body = match cx.on_the_circle(entry) {
        Some(at) => by_cosine(cx, entry, at),
        None if cx.is_velocity_at_unit_rate(entry) => by_velocity(cx),
        None => marked(cx, entry),
    };
    let (docs, result) = (docs::straight(cx, entry), entry::result(cx, entry.kind));
    let name = function_name(&format!("solve_{}", entry::method(entry.kind)));
    let core = core_name(entry);
    quote! {
        #docs
        #[inline]
        #[must_use]
        pub fn #name(&self, #(#declared),*) -> (#result, #scalar::Mask) {
            #converted
            #answer
        }

        #[inline(always)]
        fn #core(&self, #(#received),*) -> (#result, #scalar::Mask) {
            #body
        }
    }
}

/// The core's answer to the arguments of an entry point. The amplitude of a given cosine and sine is
/// divided out here, because an angle's have none.
pub(super) fn answer(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, core) = (cx.arguments(entry.kind), core_name(entry));
    let (names, [result, ok]) = (arguments.names(), ["result_", "ok_"].map(generated));
    if !entry::takes_cosine(entry.kind) {
        return quote!(self.#core(#(#names),*));
    }
    let (given, rates) = names.split_at(2);
    let ([cos, sin, near], on_circle) =
        (["cos_", "sin_", "near_"].map(generated), cx.paths.item("on_circle"));
    quote! {
        let (#cos, #sin, #near) = #on_circle(#(#given),*);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)*);
        (#result, #ok & #near)
    }
}

/// The formulas under marks, and the test that every result is finite.
fn marked(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let [marks, result] = ["marks_", "result_"].map(generated);
    let (formulas, start) = (formulas::call(cx, entry, &marks), cx.paths.item("Marks"));
    let finite = finite::test(cx, entry, &quote!(#result)).map(|finite| quote!(& #finite));
    quote! {
        let mut #marks = #start::new();
        let #result = #formulas;
        (#result, #marks.all() #finite)
    }
}

/// The core of `at`, given the angle's cosine and sine.
fn by_cosine(cx: &Context<'_>, entry: &Entry, at: &Entry) -> TokenStream {
    let [sin, cos, result, ok] = ["sin_", "cos_", "result_", "ok_"].map(generated);
    let (sin_cos, is_near) = (cx.scalar("sin_cos_near"), cx.scalar("is_near"));
    let (arguments, core) = (cx.arguments(entry.kind), core_name(at));
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    quote! {
        let (#sin, #cos) = #sin_cos(#angle);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)*);
        (#result, #is_near(#angle) & #ok)
    }
}

/// The only input's coefficients are the velocities at its unit rate.
fn by_velocity(cx: &Context<'_>) -> TokenStream {
    let [result, ok] = ["result_", "ok_"].map(generated);
    let (arguments, one) = (cx.arguments(EntryKind::Coefficients), cx.literal(1.0, 1.0));
    let core = function_name("core_velocity_");
    let names = arguments.names();
    let rows = results::components(cx, results::Order::Velocity, &quote!(#result));
    quote! {
        let (#result, #ok) = self.#core(#(#names,)* #one);
        ([#([#rows]),*], #ok)
    }
}
