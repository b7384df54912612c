//! The entry points: what each is called, takes and returns.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::names::{function_name, generated};
use super::{Context, docs, explanations, straight};
use crate::ir::program::{Entry, EntryKind};

/// The name of the function that returns a `Result`; `solve_` in front is the straight line's.
pub(super) fn method(kind: EntryKind) -> &'static str {
    match kind {
        EntryKind::Position => "position",
        EntryKind::Velocity => "velocity",
        EntryKind::Motion => "motion",
        EntryKind::Coefficients => "coefficients",
        EntryKind::PositionAt => "position_at",
        EntryKind::VelocityAt => "velocity_at",
        EntryKind::MotionAt => "motion_at",
        EntryKind::Margins => "margins",
    }
}

/// How many orders of the inputs it takes: values, rates, second rates.
pub(super) fn orders(kind: EntryKind) -> usize {
    match kind {
        EntryKind::Position
        | EntryKind::PositionAt
        | EntryKind::Coefficients
        | EntryKind::Margins => 1,
        EntryKind::Velocity | EntryKind::VelocityAt => 2,
        EntryKind::Motion | EntryKind::MotionAt => 3,
    }
}

/// Whether the only input is given by its cosine and sine.
pub(super) fn takes_cosine(kind: EntryKind) -> bool {
    matches!(kind, EntryKind::PositionAt | EntryKind::VelocityAt | EntryKind::MotionAt)
}

/// The type of the result, for numbers of the type parameter.
pub(super) fn result(cx: &Context<'_>, kind: EntryKind) -> TokenStream {
    let scalar = &cx.names.scalar;
    result_of(cx, kind, &quote!(#scalar))
}

/// The type of the result, for numbers of this type.
pub(super) fn result_of(cx: &Context<'_>, kind: EntryKind, scalar: &TokenStream) -> TokenStream {
    match record(cx, kind) {
        Some(record) => quote!(#record<#scalar>),
        None => {
            let (rows, columns) = (cx.rows(), cx.columns());
            quote!([[#scalar; #columns]; #rows])
        }
    }
}

/// The record that is the result; none for a list of rows.
pub(super) fn record<'a>(cx: &'a Context<'_>, kind: EntryKind) -> Option<&'a Ident> {
    match kind {
        EntryKind::Position | EntryKind::PositionAt => Some(&cx.names.position),
        EntryKind::Velocity | EntryKind::VelocityAt => Some(&cx.names.velocity),
        EntryKind::Motion | EntryKind::MotionAt => Some(&cx.names.motion),
        EntryKind::Margins => Some(&cx.names.margins),
        EntryKind::Coefficients => None,
    }
}

/// The function that returns a `Result`: the straight line, and where its mask says no, the
/// careful path.
pub(super) fn function(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let (arguments, scalar) = (cx.arguments(entry.kind), &cx.names.scalar);
    let (declared, converted) =
        (arguments.declared(&quote!(#scalar)), arguments.converted(&quote!(#scalar)));
    let result = result(cx, entry.kind);
    let name = function_name(method(entry.kind));
    let answer = straight::answer(cx, entry);
    let (explain, docs) = (explanations::call(cx, entry), docs::checked(cx, entry));
    let (outcome, error, ok) =
        (cx.paths.item("Result"), cx.paths.item("SolveError"), cx.paths.item("Ok"));
    let (value, usable) = (generated("result_"), generated("ok_"));
    quote! {
        #docs
        #[inline]
        pub fn #name(&self, #(#declared),*) -> #outcome<#result, #error> {
            #converted
            let (#value, #usable) = { #answer };
            if #usable { #ok(#value) } else { #explain }
        }
    }
}
