//! Every path from generated code into the run-time crate, and nothing else.
//!
//! Generated code names `linkage_core::private` only: that works without a prelude, with a
//! shadowed `core` and under a renamed dependency.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::model::mechanism::Mechanism;

pub(super) struct Paths {
    private: TokenStream,
}

impl Paths {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        let private = match &mechanism.crate_path {
            Some(path) => quote!(#path::private),
            None => quote!(::linkage_core::private),
        };
        Self { private }
    }

    /// A type, trait, function or macro of the run-time crate.
    pub(super) fn item(&self, name: &str) -> TokenStream {
        let private = &self.private;
        let name = Ident::new(name, Span::call_site());
        quote!(#private::#name)
    }

    /// The derives of every plain record.
    pub(super) fn derives(&self, names: &[&str]) -> TokenStream {
        let derive = self.item("derive");
        let names = names.iter().map(|name| self.item(name));
        quote!(#[#derive(#(#names),*)])
    }
}
