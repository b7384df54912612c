//! Every path from generated code into the run-time crate, and nothing else.
//!
//! Generated code names `linkage_core::private` only: that works without a prelude, with a
//! shadowed `core` and under a renamed dependency. What stands in the unnamed constant imports the
//! module under its own name, so that it can be read.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::identifiers::clear_of;
use super::token_list::Tokens;
use crate::model::mechanism::Mechanism;

pub(super) struct Paths {
    /// The hidden module as the user's crate finds it.
    module: TokenStream,
    /// What it is called inside the unnamed constant.
    alias: Ident,
}

impl Paths {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        let module = match &mechanism.crate_path {
            Some(path) => quote!(#path::private),
            None => quote!(::linkage_core::private),
        };
        Self { module, alias: clear_of("private", &mechanism.name) }
    }

    /// What an unnamed constant begins with.
    pub(super) fn import(&self) -> TokenStream {
        let (module, alias) = (&self.module, &self.alias);
        match alias == "private" {
            true => quote!(use #module;),
            false => quote!(use #module as #alias;),
        }
    }

    /// A function under the name of every argument: it hides a constant, a static or a unit struct
    /// of the user's that has the name, whose pattern an argument would be. What is a function may
    /// be an argument as well.
    pub(super) fn import_arguments(&self, names: impl Iterator<Item = String>) -> TokenStream {
        let module = &self.module;
        let names = names.map(|name| Ident::new(&name, Span::call_site()));
        quote! {
            #[allow(unused_imports, reason = "a function hides a constant of its name, and no argument")]
            use #module::{#(argument as #names),*};
        }
    }

    /// A type, trait, function or macro of the run-time crate, inside the unnamed constant.
    pub(super) fn item(&self, name: &str) -> Tokens {
        Tokens::path(self.alias.clone(), Ident::new(name, Span::call_site()))
    }

    /// The same beside the user's own items, where nothing was imported.
    pub(super) fn outside(&self, name: &str) -> TokenStream {
        let module = &self.module;
        let name = Ident::new(name, Span::call_site());
        quote!(#module::#name)
    }

    /// The derives of a plain record beside the user's own items.
    pub(super) fn derives(&self, names: &[&str]) -> TokenStream {
        let derive = self.outside("derive");
        let names = names.iter().map(|name| self.outside(name));
        quote!(#[#derive(#(#names),*)])
    }
}
