//! `solve_…`: the formulas read without a branch. They go on regardless, and a mask says in the
//! end whether the result may be used.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{function_name, generated};
use super::token_list::Tokens;
use super::{docs, formulas, results};
use crate::interface::EntryId;
use crate::interface::entries::Entry;
use crate::lower::routine::{Adapted, Asked, Compute, Limits};

/// The name of the core of an entry point.
pub(super) fn core_name(entry: &Entry) -> Ident {
    function_name(&format!("core_{}_", entry.name))
}

/// `solve_…`, and the core that it shares with everything else.
pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let (entry, scalar) = (cx.entry(id), &cx.names.scalar);
    let number = quote!(#scalar);
    let arguments = Arguments::new(cx, entry.given);
    let (declared, received) = (arguments.declared(&number), arguments.received(&number));
    let (converted, answer) = (arguments.converted(&number), answer(cx, id));
    let body = match cx.compute(id) {
        Compute::Via { entry: other, given: Adapted::CosineAndSine } => {
            by_cosine(cx, &arguments, cx.entry(*other))
        }
        Compute::Via { entry: other, given: Adapted::UnitRate } => {
            at_unit_rate(cx, &arguments, cx.entry(*other))
        }
        Compute::Own { routine, stage, asked } => {
            compared(cx, entry, formulas::Call { routine: *routine, stage: *stage }, asked)
        }
    };
    let (docs, result) = (docs::fast_path(cx, id), results::ty(cx, entry.result, &number));
    let name = function_name(&format!("solve_{}", entry.name));
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
pub(super) fn answer(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    let (arguments, core) = (Arguments::new(cx, entry.given), core_name(entry));
    let (names, [result, ok]) = (arguments.names(), ["result_", "ok_"].map(generated));
    if !entry.takes_cosine() {
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

/// The formulas under the marks, and the test that every result is finite.
fn compared(cx: &Context<'_>, entry: &Entry, call: formulas::Call, asked: &Asked) -> TokenStream {
    let [marks, result] = ["marks_", "result_"].map(generated);
    let (formulas, start) = (call.under(cx, &marks), cx.paths.item("Marks"));
    let finite = is_finite(cx, entry, asked, &quote!(#result)).map(|finite| quote!(& #finite));
    quote! {
        let mut #marks = #start::new();
        let #result = #formulas;
        (#result, #marks.all() #finite)
    }
}

/// The core of the other entry point, given the angle's cosine and sine.
fn by_cosine(cx: &Context<'_>, arguments: &Arguments<'_>, other: &Entry) -> TokenStream {
    let [sin, cos, result, ok] = ["sin_", "cos_", "result_", "ok_"].map(generated);
    let (sin_cos, is_near, core) =
        (cx.scalar("sin_cos_near"), cx.scalar("is_near"), core_name(other));
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    quote! {
        let (#sin, #cos) = #sin_cos(#angle);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)*);
        (#result, #is_near(#angle) & #ok)
    }
}

/// The core of the velocities, given a rate of one.
fn at_unit_rate(cx: &Context<'_>, arguments: &Arguments<'_>, other: &Entry) -> TokenStream {
    let [result, ok] = ["result_", "ok_"].map(generated);
    let (names, one, core) = (arguments.names(), cx.literal(1.0, 1.0), core_name(other));
    let rows = results::components(cx, other.result, &quote!(#result));
    quote! {
        let (#result, #ok) = self.#core(#(#names,)* #one);
        ([#([#rows]),*], #ok)
    }
}

/// |value| ≤ bound.
fn within(cx: &Context<'_>, value: &Tokens, [wide, narrow]: [f64; 2]) -> TokenStream {
    let is_within = cx.scalar("is_within");
    let bound = cx.literal(wide.min(f64::MAX), (narrow as f32).min(f32::MAX));
    quote!(#is_within(#value, #bound))
}

/// Whether the result is finite, as a term of a mask; nothing where it cannot be otherwise.
fn is_finite(
    cx: &Context<'_>,
    entry: &Entry,
    asked: &Asked,
    result: &TokenStream,
) -> Option<TokenStream> {
    let components = results::components(cx, entry.result, result);
    let witnesses: Vec<_> = asked.witnesses.iter().map(|&at| components[at].clone()).collect();
    if witnesses.is_empty() {
        return None;
    }
    // Of their sum, because what is not finite stays so.
    let (is_finite, sum) = (cx.scalar("is_finite"), sum(&witnesses));
    let results = quote!(#is_finite(#sum));
    let Some(Limits { wide, narrow, inputs }) = &asked.limits else { return Some(results) };
    let (plain, mask, scalar) = (cx.scalar("plain"), cx.paths.item("Mask"), &cx.names.scalar);
    let arguments = Arguments::new(cx, entry.given);
    let inputs = inputs.iter().filter_map(|&(node, bound)| Some((arguments.read(node)?, bound)));
    let inputs = inputs.map(|(value, bound)| within(cx, &value, bound));
    let terms = inputs.chain([quote! {
        (if #plain(#wide, #narrow) { <#scalar::Mask as #mask>::ALL } else { #results })
    }]);
    Some(quote!(#(#terms)&*))
}

/// The sum as a balanced tree: it is short in time, and shallow for the compiler.
fn sum(values: &[TokenStream]) -> TokenStream {
    match values {
        [] => TokenStream::new(),
        [only] => only.clone(),
        _ => {
            let (left, right) = values.split_at(values.len().div_ceil(2));
            let (left, right) = (term(left), term(right));
            quote!(#left + #right)
        }
    }
}

fn term(values: &[TokenStream]) -> TokenStream {
    let sum = sum(values);
    if values.len() > 1 { quote!((#sum)) } else { sum }
}
