//! Every path from generated code into the run-time crate, and nothing else.
//!
//! Generated code names `linkage_core::private` only: that works without a prelude, with a
//! shadowed `core` and under a renamed dependency. The mechanism's module imports it and its types,
//! so that the code can be read, and because every token costs the compiler time; code without a
//! module of its own does so in its unnamed constant alone, where no name meets one of the user's.
//! Functions and macros are named by their path: an argument may be called as they are.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::token_list::Tokens;
use crate::codegen::identifiers::clear_of;
use crate::model::mechanism::Mechanism;

pub(in crate::codegen) struct Paths {
    /// The hidden module as the user's crate finds it.
    module: TokenStream,
    /// The name of the hidden module inside the unnamed constant.
    alias: Ident,
    /// The names of the mechanism and its records, which hide imported names.
    own: Vec<String>,
    /// True if the code has a module of its own.
    is_held: bool,
}

/// The items of `private::names`: types, traits and variants that most mechanisms need.
pub const IMPORTED: [&str; 47] = [
    "AllMet",
    "AngularAcceleration",
    "AngularVelocity",
    "Checks",
    "Clearance",
    "Clone",
    "Copy",
    "Cost",
    "Debug",
    "Default",
    "Direction",
    "Float",
    "Fn",
    "FnMut",
    "FnOnce",
    "From",
    "Inputs",
    "Into",
    "LengthMismatch",
    "OfMotion",
    "OfPosition",
    "OfVelocity",
    "Ok",
    "Option",
    "PartialEq",
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
    "Solver",
    "Some",
    "Status",
    "Titles",
    "derive",
    "f64",
    "str",
    "usize",
];

impl Paths {
    pub(in crate::codegen) fn new(mechanism: &Mechanism, own: Vec<String>) -> Self {
        Self::placed(mechanism, own, a_module_can_hold(mechanism))
    }

    /// The same for code that stands beside the declaration, without a module of its own.
    pub(in crate::codegen) fn beside(mechanism: &Mechanism, own: Vec<String>) -> Self {
        Self::placed(mechanism, own, false)
    }

    fn placed(mechanism: &Mechanism, own: Vec<String>, is_held: bool) -> Self {
        let module = match &mechanism.crate_path {
            Some(path) => {
                let path = match is_held {
                    true => seen_from_inside(path),
                    false => quote!(#path),
                };
                quote!(#path::private)
            }
            None => quote!(::linkage_core::private),
        };
        Self { module, alias: clear_of("private", &mechanism.name), own, is_held }
    }

    /// The imports at the start of the code's own module, if it has one.
    pub(in crate::codegen) fn import_in_module(&self) -> Option<TokenStream> {
        self.is_held.then(|| self.import())
    }

    /// The imports at the start of the unnamed constant, unless the module around it has them.
    pub(in crate::codegen) fn import_in_constant(&self) -> Option<TokenStream> {
        (!self.is_held).then(|| self.import())
    }

    fn import(&self) -> TokenStream {
        let (module, alias) = (&self.module, &self.alias);
        let module = match alias == "private" {
            true => quote!(use #module;),
            false => quote!(use #module as #alias;),
        };
        // Names one by one would each be an item for rustc, a hundredth of a mechanism's check in all.
        let hidden = IMPORTED.iter().filter(|name| self.is_hidden(name)).map(|name| {
            let (item, local) = (Ident::new(name, Span::call_site()), self.imported(name));
            quote! {
                #[allow(unused_imports, reason = "no mechanism needs all of them")]
                use #alias::#item as #local;
            }
        });
        quote! {
            #module
            #[allow(clippy::wildcard_imports, reason = "what is generated knows what it names")]
            use #alias::names::*;
            #(#hidden)*
        }
    }

    /// True if the mechanism or one of its records has the name of an imported item.
    fn is_hidden(&self, name: &str) -> bool {
        self.own.iter().any(|own| own == name)
    }

    /// The name of an imported item in the generated code: it ends in `_` where it would be hidden.
    pub(in crate::codegen) fn imported(&self, name: &str) -> Ident {
        let clash = if self.is_hidden(name) { "_" } else { "" };
        Ident::new(&format!("{name}{clash}"), Span::call_site())
    }

    /// A function under the name of every argument: it hides a constant, a static or a unit struct
    /// of the user's that has the name, whose pattern an argument would be. What is a function may
    /// be an argument as well.
    pub(in crate::codegen) fn import_arguments(
        &self,
        names: impl Iterator<Item = String>,
    ) -> TokenStream {
        let module = &self.module;
        let names = names.map(|name| Ident::new(&name, Span::call_site()));
        quote! {
            #[allow(unused_imports, reason = "a function hides a constant of its name, and no argument")]
            use #module::{#(argument as #names),*};
        }
    }

    /// A type, trait, function or macro of the run-time crate, where things are imported.
    pub(in crate::codegen) fn item(&self, name: &str) -> Tokens {
        match IMPORTED.contains(&name) {
            true => self.imported(name).into(),
            false => Tokens::path(self.alias.clone(), Ident::new(name, Span::call_site())),
        }
    }

    /// The same as text.
    pub(in crate::codegen) fn written(&self, name: &str) -> String {
        match IMPORTED.contains(&name) {
            true => self.imported(name).to_string(),
            false => format!("{}::{name}", self.alias),
        }
    }

    /// The same in the definition of a type, which may stand beside the user's own items.
    pub(in crate::codegen) fn outside(&self, name: &str) -> Tokens {
        if self.is_held {
            return self.item(name);
        }
        let module = &self.module;
        let name = Ident::new(name, Span::call_site());
        quote!(#module::#name).into()
    }

    /// The derives of a plain record.
    pub(in crate::codegen) fn derives(&self, names: &[&str]) -> TokenStream {
        let derive = self.outside("derive");
        let names = names.iter().map(|name| self.outside(name));
        quote!(#[#derive(#(#names),*)])
    }
}

/// A path that begins with a name may mean an import beside the declaration, which cannot be seen
/// from inside a module.
pub(in crate::codegen) fn a_module_can_hold(mechanism: &Mechanism) -> bool {
    let Some(path) = &mechanism.crate_path else { return true };
    let first = path.segments.first().map(|segment| segment.ident.to_string());
    let is_start = |first: String| ["crate", "self", "super"].contains(&first.as_str());
    path.leading_colon.is_some() || first.is_some_and(is_start)
}

/// A path, as it reads inside the module.
pub(in crate::codegen) fn seen_from_inside(path: &syn::Path) -> TokenStream {
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
