//! `solve_…`: the formulas read without a branch. They go on regardless, and a mask says in the
//! end whether the result may be used.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::context::Context;
use super::{formulas, results};
use crate::codegen::arguments::{Arguments, Signatures};
use crate::codegen::docs;
use crate::codegen::docs::doc_comments;
use crate::codegen::identifiers::generated;
use crate::codegen::printer::sum;
use crate::codegen::text::Text;
use crate::interface::EntryId;
use crate::interface::entries::Entry;
use crate::lower::routine::{ArgumentAdapter, Bound, Compute, Finite, FinitenessChecks};

/// The name of the core of an entry point, which has the numbers and records themselves for arguments:
/// the public function, where that has.
pub(super) fn core_name(signatures: &Signatures<'_>, entry: &Entry) -> Ident {
    match has_core(signatures, entry) {
        true => generated(&format!("core_{}_", entry.name())),
        false => public_name(entry),
    }
}

fn public_name(entry: &Entry) -> Ident {
    generated(&format!("solve_{}", entry.name()))
}

/// True if the public function converts its arguments before the core computes.
fn has_core(signatures: &Signatures<'_>, entry: &Entry) -> bool {
    entry.takes_cosine() || signatures.arguments(&entry.given).has_records()
}

/// `solve_…`, and the core that it shares with everything else.
///
/// Inlined always, as everything is that lanes call: what is not would run on the instruction set of
/// the rest of the program, and hand its results over through memory.
pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let (entry, scalar) = (cx.entry(id), &cx.names.scalar);
    let number = quote!(#scalar);
    let arguments = cx.signatures.arguments(&entry.given);
    let (declared, received) =
        (arguments.declared(&cx.paths, &number), arguments.received(&number));
    let (converted, answer) = (arguments.converted(&cx.paths, &number), answer(cx, id));
    let body = match cx.compute(id) {
        Compute::Delegate { entry: other, given: ArgumentAdapter::CosineAndSine } => {
            by_cosine(cx, &arguments, *other)
        }
        Compute::Delegate { entry: other, given: ArgumentAdapter::UnitRate } => {
            at_unit_rate(cx, &arguments, *other)
        }
        Compute::Own { routine, stage, asked } => {
            let (start, call) =
                (cx.paths.item("AllMet"), formulas::Call { routine: *routine, stage: *stage });
            compared(cx, id, call, asked, &quote!(#start::new()))
        }
    };
    let (docs, result) = (
        docs::fast_path(cx.mechanism, cx.lowered, id),
        results::ty(cx.interface, &cx.paths, entry.result, &number),
    );
    let (name, core) = (public_name(entry), core_name(&cx.signatures, entry));
    let square = cx.lowered.takes_square(id).then(|| {
        let square = generated(SQUARE);
        quote!(, #square: #scalar)
    });
    let (shown, core) = match has_core(&cx.signatures, entry) {
        false => (body, None),
        true => (
            quote!(#converted #answer),
            Some(quote! {
                #[inline(always)]
                fn #core(&self, #(#received),* #square) -> (#result, #scalar::Mask) { #body }
            }),
        ),
    };
    quote! {
        #docs
        #[inline(always)]
        #[must_use]
        pub fn #name(&self, #(#declared),*) -> (#result, #scalar::Mask) { #shown }

        #core
    }
}

/// The answer to the arguments of an entry point, by one call: of the core, where that has the same.
pub(super) fn call(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    if !entry.takes_cosine() {
        return answer(cx, id);
    }
    let (arguments, name) = (cx.signatures.arguments(&entry.given), public_name(entry));
    let given = arguments.names();
    quote!(self.#name(#(#given),*))
}

/// The core's answer to the arguments of an entry point. The amplitude of a given cosine and sine is
/// divided out here, because an angle's have none.
fn answer(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    let (arguments, core) =
        (cx.signatures.arguments(&entry.given), core_name(&cx.signatures, entry));
    let (names, [result, ok]) = (arguments.names(), ["result_", "ok_"].map(generated));
    if !entry.takes_cosine() {
        return quote!(self.#core(#(#names),*));
    }
    let (given, rates) = names.split_at(2);
    let ([cos, sin, near], on_circle) =
        (["cos_", "sin_", "near_"].map(generated), cx.paths.item("on_circle"));
    let square = cx.lowered.takes_square(id).then(|| {
        // A sum with −0 is the other number, whatever it is, and no addition.
        let none = cx.literal(-0.0, -0.0);
        quote!(, #none)
    });
    quote! {
        let (#cos, #sin, #near) = #on_circle(#(#given),*);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)* #square);
        (#result, #ok & #near)
    }
}

/// The fast path of a sweep's pose, whose searches begin by the seeds of their unknowns; none where nothing is
/// searched by a seed, or where the formulas are another entry point's.
pub(super) fn following(cx: &Context<'_>, id: EntryId) -> Option<TokenStream> {
    let Compute::Own { routine, stage, asked } = cx.compute(id) else { return None };
    let has_seeds = cx.lowered.searches.iter().any(|search| search.apart.is_some());
    let entry = cx.entry(id);
    if !has_seeds || !entry.is_a_stage() {
        return None;
    }
    let (scalar, seeds) = (&cx.names.scalar, generated("seeds_"));
    let number = quote!(#scalar);
    let received = cx.signatures.arguments(&entry.given).received(&number);
    let [start, seed] = ["AllMet", "Seed"].map(|item| cx.paths.item(item));
    let start = quote!(#start::following(#seeds));
    let call = formulas::Call { routine: *routine, stage: *stage };
    let body = compared(cx, id, call, asked, &start);
    let (name, result) =
        (following_name(entry), results::ty(cx.interface, &cx.paths, entry.result, &number));
    let docs = doc_comments::lines(&format!(
        "`{}` in a sweep: searches begin by what the pose before has left.",
        public_name(entry),
    ));
    Some(quote! {
        #docs
        fn #name(&self, #(#received,)* #seeds: &mut [#seed<#scalar>]) -> (#result, #scalar::Mask) {
            #body
        }
    })
}

/// The name of the function that [`following`] makes.
pub(super) fn following_name(entry: &Entry) -> Ident {
    generated(&format!("follow_{}_", entry.name()))
}

/// The formulas, every condition compared by these checks, and the test that every result is finite.
fn compared(
    cx: &Context<'_>,
    id: EntryId,
    call: formulas::Call,
    asked: &FinitenessChecks,
    start: &TokenStream,
) -> TokenStream {
    let [all_met, result] = ["all_met_", "result_"].map(generated);
    let formulas = call.under(cx, &quote!(&mut #all_met));
    let finite = asked.finite.as_ref().map(|finite| is_finite(cx, id, finite));
    let finite = finite.map(|finite| quote!(& #finite));
    quote! {
        let mut #all_met = #start;
        let #result = #formulas;
        (#result, #all_met.all() #finite)
    }
}

/// The core of the other entry point, given the angle's cosine and sine.
fn by_cosine(cx: &Context<'_>, arguments: &Arguments<'_>, other: EntryId) -> TokenStream {
    let [sin, cos, result, ok] = ["sin_", "cos_", "result_", "ok_"].map(generated);
    let (sin_cos, core) = (cx.scalar("sin_cos_near"), core_name(&cx.signatures, cx.entry(other)));
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    if cx.lowered.takes_square(other) {
        return quote! {
            let (#sin, #cos) = #sin_cos(#angle);
            self.#core(#cos, #sin #(, #rates)*, #angle * #angle)
        };
    }
    let is_near = cx.scalar("is_near");
    quote! {
        let (#sin, #cos) = #sin_cos(#angle);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)*);
        (#result, #is_near(#angle) & #ok)
    }
}

/// The square of the angle, for a core that compares it together with its rates; zero where cosine and sine
/// are given.
const SQUARE: &str = "square_";

/// The velocities at a rate of one, a column of rows.
fn at_unit_rate(cx: &Context<'_>, arguments: &Arguments<'_>, velocity: EntryId) -> TokenStream {
    let [result, ok] = ["result_", "ok_"].map(generated);
    let (answer, column) = (of_unit_rate(cx, arguments, velocity), cx.paths.item("column"));
    quote! {
        let (#result, #ok) = #answer;
        (#column(#result.rows()), #ok)
    }
}

/// The core's answer to a rate of one.
pub(super) fn of_unit_rate(
    cx: &Context<'_>,
    arguments: &Arguments<'_>,
    velocity: EntryId,
) -> TokenStream {
    let (names, one) = (arguments.names(), cx.literal(1.0, 1.0));
    let core = core_name(&cx.signatures, cx.entry(velocity));
    quote!(self.#core(#(#names,)* #one))
}

/// Tests that the result is finite, as a term of a mask.
fn is_finite(cx: &Context<'_>, id: EntryId, finite: &Finite) -> TokenStream {
    let entry = cx.entry(id);
    let components = results::components(cx.interface, entry.result, "result_");
    // One test of the sum is enough: a term that is not finite makes the sum not finite.
    let (is_finite, sum) = (cx.scalar("is_finite"), Text::from(sum(&finite.sum, &components)));
    let Some(([wide, narrow], bounds)) = &finite.instead else {
        return quote!(#is_finite(#sum));
    };
    let (plain, unless) = (cx.scalar("plain"), cx.paths.item("is_finite_unless"));
    let arguments = cx.signatures.arguments(&entry.given);
    let bounds = bounds.iter().map(|bound| is_kept(cx, &arguments, bound));
    quote!(#(#bounds&)* #unless(#plain(#wide, #narrow), #sum))
}

/// A comparison of inputs with a limit.
fn is_kept(cx: &Context<'_>, arguments: &Arguments<'_>, bound: &Bound) -> TokenStream {
    let [is_within, fused, at_least] = ["is_within", "fused", "ge"].map(|item| cx.scalar(item));
    let read = |node| Text::from(arguments.written(node).expect("what is asked is given"));
    let literal = |[wide, narrow]: [f64; 2]| cx.literal(wide, narrow as f32);
    match *bound {
        Bound::Within { value, limit } => {
            let (value, limit) = (read(value), literal(limit));
            quote!(#is_within(#value, #limit))
        }
        Bound::WithRate { rate, second, limit } => {
            let ([rate, second], limit) = ([rate, second].map(read), literal(limit));
            quote!(#is_within(#second, #fused(-#rate, #rate, #limit)))
        }
        Bound::OnCircle { rate, second, limit } => {
            let (square, limit) = (generated(SQUARE), literal(limit));
            let squares = match rate.map(read) {
                Some(rate) => quote!(#fused(#rate, #rate, #square)),
                None => quote!(#square),
            };
            match second.map(read) {
                Some(second) => {
                    quote!(#at_least(#limit, #fused(#squares, #squares, #second * #second)))
                }
                None => quote!(#at_least(#limit, #squares)),
            }
        }
    }
}
