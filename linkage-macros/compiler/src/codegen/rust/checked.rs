//! The function of an entry point that returns a `Result`: the fast path, and where its mask says
//! no, the slow path.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::Context;
use super::token_list::Tokens;
use super::{fast_path, results, slow_path};
use crate::codegen::docs;
use crate::codegen::identifiers::generated;
use crate::interface::EntryId;
use crate::lower::routine::{ArgumentAdapter, Compute};

pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    let scalar = &cx.names.scalar;
    let scalar = quote!(#scalar);
    let arguments = cx.signatures.arguments(&entry.given);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &scalar), arguments.converted(&cx.paths, &scalar));
    let result = results::ty(cx.interface, &cx.paths, entry.result, &scalar);
    let name = generated(entry.name());
    let docs = docs::checked(cx.mechanism, cx.lowered, id);
    let (outcome, error, ok) =
        (cx.paths.item("Result"), cx.paths.item("SolveError"), cx.paths.item("Ok"));
    let (value, usable) = (generated("result_"), generated("ok_"));
    let given = arguments.names().iter().cloned().map(Tokens::from);
    let body = match cx.compute(id) {
        // The velocities at a rate of one.
        Compute::Delegate { entry: velocity, given: ArgumentAdapter::UnitRate } => {
            let given: Vec<_> = given.chain([cx.literal(1.0, 1.0)]).collect();
            let answer = fast_path::of_unit_rate(cx, &arguments, *velocity);
            let (diagnose, column) =
                (slow_path::call(cx, *velocity, &given), cx.paths.item("column"));
            quote! {
                let (#value, #usable) = #answer;
                let #value = if #usable { #value } else { #diagnose? };
                #ok(#column(#value.rows()))
            }
        }
        _ => {
            let given: Vec<_> = given.collect();
            let (answer, diagnose) = (fast_path::call(cx, id), slow_path::call(cx, id, &given));
            quote! {
                let (#value, #usable) = #answer;
                if #usable { #ok(#value) } else { #diagnose }
            }
        }
    };
    quote! {
        #docs
        #[inline]
        pub fn #name(&self, #(#declared),*) -> #outcome<#result, #error> {
            #converted
            #body
        }
    }
}
