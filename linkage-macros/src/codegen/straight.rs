//! What the straight line does at a guard and at an angle: it goes on regardless, and a mask says
//! in the end whether the result may be used.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::blocks::{Statement, lay_out};
use super::body::{Body, Statements};
use super::dominance::undominated;
use super::names::{function_name, generated};
use super::{Context, docs, entry, results};
use crate::ir::graph::{Check, GuardId, Id, Node};
use crate::ir::liveness::Course;
use crate::ir::program::Entry;

/// One comparison of the straight line, on a local or an input.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Condition {
    NotNegative(Id),
    Nonzero(Id),
    Positive(Id),
    FullPrecision(Id),
}

impl Condition {
    pub(super) fn of(body: &Body<'_>, value: Id, guard: GuardId) -> Self {
        let value = body.resolve(value);
        match body.graph().condition(guard).check {
            Check::ReachLine | Check::ReachOffset => Self::NotNegative(value),
            Check::Nonzero => Self::Nonzero(value),
            Check::ReachCircles | Check::Positive(_) => Self::Positive(value),
            Check::Square => Self::FullPrecision(value),
        }
    }
}

impl Condition {
    /// Whether another condition among those already there implies this one.
    pub(super) fn follows(self, from: &HashSet<Self>) -> bool {
        match self {
            Self::Nonzero(id) => from.contains(&Self::Positive(id)),
            _ => false,
        }
    }
}

/// The condition as a statement without a `let`.
pub(super) fn condition(body: &Body<'_>, condition: Condition) -> Statement {
    let cx = body.cx;
    let (ge, gt, select) = (cx.scalar("ge"), cx.scalar("gt"), cx.scalar("select"));
    let zero = generated("zero_");
    let (id, holds) = match condition {
        Condition::NotNegative(id) => {
            let value = body.value(id);
            (id, quote!(#ge(#value, #zero)))
        }
        Condition::Positive(id) => {
            let value = body.value(id);
            (id, quote!(#gt(#value, #zero)))
        }
        // The magnitude, compared: neither a square, which underflows, nor a disjunction, which
        // masks do not have.
        Condition::Nonzero(id) => {
            let value = body.value(id);
            (id, quote!(#gt(#select(#ge(#value, #zero), #value, -#value), #zero)))
        }
        Condition::FullPrecision(id) => {
            let (value, smallest) = (body.value(id), cx.scalar("smallest_square"));
            (id, quote!(#ge(#value, #smallest())))
        }
    };
    Statement { uses: body.locals([id]), condition: Some(holds), ..Statement::default() }
}

/// The function that turns an angle into sine and cosine, and what it needs of the angle.
pub(super) fn sin_cos(body: &Body<'_>, angle: Id) -> (TokenStream, Option<TokenStream>) {
    let cx = body.cx;
    if let Node::Constant(_) = body.graph().node(angle) {
        return (cx.scalar("sin_cos"), None);
    }
    let (is_near, value) = (cx.scalar("is_near"), body.value(angle));
    (cx.scalar("sin_cos_near"), Some(quote!(#is_near(#value))))
}

/// The name of the core of an entry point.
pub(super) fn core_name(entry: &Entry) -> Ident {
    function_name(&format!("core_{}_", entry::method(entry.kind)))
}

/// `solve_…`, and the core of an entry point that it shares with everything else, without a
/// branch.
///
/// The core is inlined always: as a call of its own it would hand its results over through
/// memory, one more time, which costs a four-bar's solve a tenth of its throughput and a fifth of
/// its latency; and a sweep would run it on the instruction set of the rest of the program. Each
/// of the functions around it may be called.
pub(super) fn function(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, scalar) = (cx.arguments(entry.kind), &cx.names.scalar);
    let (declared, received) =
        (arguments.declared(&quote!(#scalar)), arguments.received(&quote!(#scalar)));
    let (converted, names) = (arguments.converted(&quote!(#scalar)), arguments.names());
    let body = match cx.on_the_circle(entry) {
        Some(at) => by_cosine(cx, entry, at),
        None => body(cx, entry),
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
            self.#core(#(#names),*)
        }

        #[inline(always)]
        fn #core(&self, #(#received),*) -> (#result, #scalar::Mask) {
            #body
        }
    }
}

/// What is computed, and whether it may be used.
fn body(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Straight };
    let statements = body.statements(&entry.sinks);
    let kept = body.locals(entry.sinks.iter().copied());
    let (lines, mask) = lay_out(&statements.list, &kept);
    let unread = arguments.unread(&statements.leaves);
    let zero = zero(cx, &statements);
    let ok = verdict(&body, &entry.sinks, mask.map(|ok| quote!(#ok)));
    let values = entry.sinks.iter().map(|&sink| body.value(sink)).collect();
    let (value, status) = (results::assemble(cx, entry.kind, values), generated("ok_"));
    quote! {
        #unread
        #zero
        #lines
        let #status = #ok;
        (#value, #status)
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

/// The zero that conditions compare with, where one does.
fn zero(cx: &Context<'_>, statements: &Statements) -> Option<TokenStream> {
    let compares = |condition: &Condition| !matches!(condition, Condition::FullPrecision(_));
    statements.conditions.iter().any(compares).then(|| {
        let (zero, literal) = (generated("zero_"), cx.literal(0.0, 0.0));
        quote!(let #zero = #literal;)
    })
}

/// The mask of all conditions and of the one test that every result is finite.
fn verdict(body: &Body<'_>, sinks: &[Id], mask: Option<TokenStream>) -> TokenStream {
    let cx = body.cx;
    let tested = undominated(body.graph(), sinks);
    let values: Vec<_> = tested.iter().map(|&id| body.value(id)).collect();
    let finite = (!values.is_empty()).then(|| {
        let (is_finite, sum) = (cx.scalar("is_finite"), sum(&values));
        quote!(#is_finite(#sum))
    });
    match (mask, finite) {
        (Some(mask), Some(finite)) => quote!(#mask & #finite),
        (Some(one), None) | (None, Some(one)) => one,
        (None, None) => {
            let (all, scalar) = (cx.paths.item("Mask"), &cx.names.scalar);
            quote!(<#scalar::Mask as #all>::ALL)
        }
    }
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
