//! Every path from generated code into the run-time crate, and nothing else.
//!
//! Generated code names `linkage_core::private` only: that works without a prelude, with a
//! shadowed `core` and under a renamed dependency. What stands in the unnamed constant imports the
//! module and its types, so that it can be read, and because every token costs the compiler time.
//! Functions and macros are named by their path: an argument may be called as they are.

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
    /// What the mechanism and its records are called: nothing imported may hide them.
    own: Vec<String>,
}

/// What is imported: types, traits and variants that most mechanisms need.
const IMPORTED: [&str; 46] = [
    "AllMet",
    "AngularAcceleration",
    "AngularVelocity",
    "Checks",
    "Clearance",
    "Cost",
    "Default",
    "Direction",
    "Entry",
    "FirstError",
    "Float",
    "From",
    "Fusion",
    "Inputs",
    "Into",
    "LaneMask",
    "Lanes",
    "LengthMismatch",
    "Mask",
    "Mechanism",
    "Modes",
    "OfMotion",
    "OfPosition",
    "OfVelocity",
    "Ok",
    "Operations",
    "Option",
    "PhantomData",
    "Point",
    "Progress",
    "Real",
    "Record",
    "Result",
    "Scalar",
    "Series",
    "Side",
    "Slide",
    "SlidingAcceleration",
    "SlidingDirection",
    "SlidingVelocity",
    "SolveError",
    "Some",
    "Status",
    "f64",
    "str",
    "usize",
];

impl Paths {
    pub(super) fn new(mechanism: &Mechanism, own: Vec<String>) -> Self {
        let module = match &mechanism.crate_path {
            Some(path) => {
                let path = match a_module_can_hold(mechanism) {
                    true => seen_from_inside(path),
                    false => quote!(#path),
                };
                quote!(#path::private)
            }
            None => quote!(::linkage_core::private),
        };
        Self { module, alias: clear_of("private", &mechanism.name), own }
    }

    /// What an unnamed constant begins with.
    pub(super) fn import(&self) -> TokenStream {
        let (module, alias) = (&self.module, &self.alias);
        let module = match alias == "private" {
            true => quote!(use #module;),
            false => quote!(use #module as #alias;),
        };
        let items = IMPORTED.map(|name| {
            let item = Ident::new(name, Span::call_site());
            let local = self.imported(name);
            if local == name { quote!(#item) } else { quote!(#item as #local) }
        });
        quote! {
            #module
            #[allow(unused_imports, reason = "no mechanism needs all of them")]
            use #alias::{#(#items),*};
        }
    }

    /// What an imported item is called.
    pub(super) fn imported(&self, name: &str) -> Ident {
        let clash = if self.own.iter().any(|own| own == name) { "_" } else { "" };
        Ident::new(&format!("{name}{clash}"), Span::call_site())
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
        match IMPORTED.contains(&name) {
            true => self.imported(name).into(),
            false => Tokens::path(self.alias.clone(), Ident::new(name, Span::call_site())),
        }
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

/// A path that begins with a name may mean an import beside the declaration, which cannot be seen
/// from inside a module.
pub(super) fn a_module_can_hold(mechanism: &Mechanism) -> bool {
    let Some(path) = &mechanism.crate_path else { return true };
    let first = path.segments.first().map(|segment| segment.ident.to_string());
    let is_start = |first: String| ["crate", "self", "super"].contains(&first.as_str());
    path.leading_colon.is_some() || first.is_some_and(is_start)
}

/// A path, as it reads inside the module.
pub(super) fn seen_from_inside(path: &syn::Path) -> TokenStream {
    let first = path.segments.first().map(|segment| segment.ident.to_string());
    match first.as_deref() {
        Some("super") => quote!(super::#path),
        Some("self") => {
            let rest = path.segments.iter().skip(1);
            quote!(super #(::#rest)*)
        }
        _ => quote!(#path),
    }
}
