//! The module around the generated code, and what it changes about visibilities and paths.
//!
//! A second mechanism of one name would have the compiler report every function and trait of it as
//! defined twice. In a module of its own it reports the module, once: what is inside belongs to
//! another struct then.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Visibility;

use super::context::Context;
use super::paths::{a_module_can_hold, seen_from_inside};
use crate::codegen::identifiers::{generated, text};
use crate::interface::entries::Analysis;
use crate::model::mechanism::Mechanism;

/// The code in its module, and its items where the declaration stands.
pub(super) fn around(cx: &Context<'_>, code: &TokenStream) -> TokenStream {
    if !a_module_can_hold(cx.mechanism) {
        return code.clone();
    }
    let (module, visibility) = (name(&cx.names.solver), &cx.mechanism.visibility);
    // The stub of a declaration with mistakes may lack a requested function, which must not be reported as
    // absent. The stub's list of references is empty.
    let is_understood = !cx.mechanism.references.made.is_empty();
    let absent = is_understood.then(|| {
        // Where nothing about forces is absent, loads make no difference.
        let has = |analysis| cx.interface.has(analysis);
        let has_all = has(Analysis::Forces) && has(Analysis::ForwardDynamics);
        let takes_loads = !cx.mechanism.dynamics.loads.is_empty() && !has_all;
        let absent = cx.paths.item(if takes_loads { "AbsentUnderLoads" } else { "Absent" });
        quote!(#[doc(hidden)] pub use #absent as _;)
    });
    let (import, names_are_as_declared) = (cx.paths.import_in_module(), allowed());
    quote! {
        #names_are_as_declared
        mod #module {
            #import
            #absent
            #code
        }
        #[allow(unused_imports, clippy::wildcard_imports, reason = "all that stands in the module")]
        #visibility use #module::*;
    }
}

/// The lints that generated code is allowed to trip: names are as declared, records derive no `Eq`, and
/// hardly anyone reads every result.
pub(super) fn allowed() -> TokenStream {
    quote! {
        #[allow(
            dead_code,
            non_snake_case,
            clippy::derive_partial_eq_without_eq,
            reason = "names are as declared, and results are there to choose from"
        )]
    }
}

/// The same in front of a struct, unless the module around it says so.
pub(super) fn allowed_outside(mechanism: &Mechanism) -> Option<TokenStream> {
    (!a_module_can_hold(mechanism)).then(allowed)
}

fn name(solver: &Ident) -> Ident {
    generated(&format!("{}_", text(solver)))
}

/// The visibility of the structs inside the module that gives them the declared visibility outside.
pub(super) fn visibility_inside(mechanism: &Mechanism) -> TokenStream {
    let visibility = &mechanism.visibility;
    if !a_module_can_hold(mechanism) {
        return quote!(#visibility);
    }
    match visibility {
        Visibility::Inherited => quote!(pub(super)),
        Visibility::Restricted(restricted) => match seen_from_inside(&restricted.path) {
            path if path.to_string() == "crate" => quote!(pub(crate)),
            path if path.to_string() == "super" => quote!(pub(super)),
            path => quote!(pub(in #path)),
        },
        Visibility::Public(_) => quote!(#visibility),
    }
}
