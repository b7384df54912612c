//! The slow path: the same formulas once more, each condition looked at in full. It runs only
//! where the fast path's mask said no.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::token_list::Tokens;
use super::{formulas, results};
use crate::codegen::arguments::Arguments;
use crate::codegen::docs;
use crate::codegen::identifiers::{generated, text};
use crate::codegen::text::Text;
use crate::interface::entries::Entry;
use crate::interface::records::{RecordKind, Shape};
use crate::interface::{EntryId, labels};
use crate::lower::routine::{ArgumentAdapter, Compute, FinitenessChecks};

/// The name of the function on the slow path of an entry point.
fn name(entry: &Entry) -> Ident {
    generated(&format!("diagnose_{}_", entry.name()))
}

/// The expression that a public function returns where its fast path gave no answer.
///
/// The optimiser may pair the positions of a motion, which are there long before the rates, and so the
/// sums for sine and cosine: their constants are half as many. Whatever comes last it must not.
pub(super) fn call(cx: &Context<'_>, id: EntryId, arguments: &[Tokens]) -> TokenStream {
    let found = found(cx, id, arguments);
    let Shape::Record(record) = cx.entry(id).result else { return found };
    let (apart, record) = (cx.paths.item("apart"), cx.record(record));
    let paired = match record.kind {
        RecordKind::Motion => cx.interface.numbers(record.fields[0].shape),
        _ => 0,
    };
    let first = Literal::usize_unsuffixed(paired);
    quote!(#apart(#found, #first))
}

/// The call of an entry point's slow path. A given cosine and sine are first scaled onto the unit circle;
/// those of an angle lie on it.
fn found(cx: &Context<'_>, id: EntryId, arguments: &[Tokens]) -> TokenStream {
    let (entry, [cos, sin]) = (cx.entry(id), ["cos_", "sin_"].map(generated));
    let (found, own, given) = match cx.compute(id) {
        Compute::Delegate { entry: other, given: ArgumentAdapter::CosineAndSine } => {
            ("from_angle", cx.entry(*other), 1)
        }
        _ if entry.takes_cosine() => ("from_circle", entry, 2),
        _ => {
            let name = name(entry);
            return quote!(self.#name(#(#arguments),*));
        }
    };
    let ((given, rates), name) = (arguments.split_at(given), name(own));
    let (found, label) = (cx.paths.item(found), text(&cx.mechanism.inputs[0].name));
    quote! {
        #found(#(#given,)* #label, move |#cos, #sin| self.#name(#cos, #sin #(, #rates)*))
    }
}

/// The function that says why the fast path of an entry point gave no answer; none where another's
/// does.
pub(super) fn function(cx: &Context<'_>, id: EntryId) -> Option<TokenStream> {
    let (entry, scalar) = (cx.entry(id), &cx.names.scalar);
    let number = quote!(#scalar);
    let Compute::Own { routine, stage, asked } = cx.compute(id) else { return None };
    let arguments = cx.signatures.arguments(&entry.given);
    let (name, received) = (name(entry), arguments.received(&number));
    let call = formulas::Call { routine: *routine, stage: *stage };
    let body = diagnosed(cx, entry, &arguments, call, asked);
    let [outcome, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let (docs, result) =
        (docs::slow_path(entry), results::ty(cx.interface, &cx.paths, entry.result, &number));
    Some(quote! {
        #docs
        #[cold]
        #[inline(never)]
        fn #name(&self, #(#received),*) -> #outcome<#result, #error> { #body }
    })
}

/// The body of the slow path: it checks that every argument is finite, then every condition, then that the
/// results are finite.
fn diagnosed(
    cx: &Context<'_>,
    entry: &Entry,
    arguments: &Arguments<'_>,
    call: formulas::Call,
    asked: &FinitenessChecks,
) -> TokenStream {
    let [checks, result] = ["checks_", "result_"].map(generated);
    let given = arguments.labelled(&asked.given);
    let (formulas, diagnose) = (call.under(cx, &quote!(#checks)), cx.paths.item("diagnose"));
    if entry.point.row().is_known_in_part {
        let diagnose = cx.paths.item("diagnose_in_part");
        return quote!(#diagnose(&#given, |#checks| #formulas, |#checks| #formulas));
    }
    if let Shape::Record(_) = entry.result {
        return quote!(#diagnose(&#given, |#checks| #formulas));
    }
    let diagnose_all = cx.paths.item("diagnose_all");
    let labels = labels::of_result(cx.interface, cx.mechanism, entry);
    let values = results::components(cx.interface, entry.result, "result_");
    let pairs = asked.results.iter().map(|&at| {
        let (value, label) = (Text::from(values[at].clone()), &labels[at]);
        quote!((#value, #label))
    });
    // An entry point without arguments and results to check leaves the type of its numbers open.
    let (scalar, count) = (&cx.names.scalar, Literal::usize_unsuffixed(asked.results.len()));
    quote! {
        #diagnose_all::<#scalar, _, #count>(
            &#given,
            |#checks| #formulas,
            |#result| [#(#pairs),*],
        )
    }
}
