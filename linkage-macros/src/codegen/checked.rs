//! The function of an entry point that returns a `Result`: the fast path, and where its mask says
//! no, the slow path.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::Context;
use super::identifiers::{function_name, generated};
use super::{arguments::Arguments, docs, fast_path, results, slow_path};
use crate::interface::EntryId;

pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    let scalar = &cx.names.scalar;
    let scalar = quote!(#scalar);
    let arguments = Arguments::new(cx, entry.given);
    let (declared, converted) = (arguments.declared(&scalar), arguments.converted(&scalar));
    let result = results::ty(cx, entry.result, &scalar);
    let name = function_name(entry.name);
    let answer = fast_path::answer(cx, id);
    let (explain, docs) = (slow_path::call(cx, entry), docs::checked(cx, id));
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
