//! The names that generated code gives to types, arguments and locals.
//!
//! User identifiers appear as types, fields and strings only, with their own spans. A local under
//! a bare user name would collide with a constant of that name in the user's scope.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::ToTokens;
use syn::ext::IdentExt;

use crate::model::mechanism::Mechanism;

/// The names that do not come with the interface.
pub(super) struct GeneratedNames {
    pub solver: Ident,
    /// The type parameter of all of them: `T`.
    pub scalar: Ident,
    /// The type parameter that `lift` converts to: `U`.
    pub lifted: Ident,
}

impl GeneratedNames {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        // The struct itself has the span of the declaration; what uses it does not.
        let solver = used(&mechanism.name);
        Self { scalar: clear_of("T", &solver), lifted: clear_of("U", &solver), solver }
    }
}

/// The name of a type or module that does not hide a mechanism of the same name.
pub fn clear_of(preferred: &str, solver: &Ident) -> Ident {
    let clash = if solver == preferred { "_" } else { "" };
    Ident::new(&format!("{preferred}{clash}"), Span::call_site())
}

/// A function that the generated code defines, or a local that no identifier outside it can meet: a local's
/// name ends in an underscore.
pub(super) fn generated(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// The names of a sweep's arguments beside the inputs.
pub(super) const SWEEP_ARGUMENTS: [&str; 3] = ["out", "status", "progress"];

/// The names of the arguments that give an angle by its cosine and sine.
pub(super) const CIRCLE: [&str; 2] = ["cos", "sin"];

/// An argument named after an input, in lower case. It has no span of the input's: an editor would show
/// every argument of that name where the input is declared.
pub fn argument(input: &Ident, suffix: &str) -> Ident {
    let name = format!("{}{suffix}", input.unraw()).to_lowercase();
    let span = Span::call_site();
    // A keyword or a name that fits nowhere gets a tail, and so does what another argument is called.
    let is_free = !SWEEP_ARGUMENTS.iter().chain(&CIRCLE).any(|other| *other == name);
    match syn::parse_str::<Ident>(&name) {
        Ok(_) if is_free => Ident::new(&name, span),
        _ => Ident::new(&format!("{name}_"), span),
    }
}

/// A name where generated code uses what it has defined under it. It has no span of the declaration's, where an
/// editor would show every such place.
pub(super) fn used(field: &Ident) -> Ident {
    let mut field = field.clone();
    field.set_span(Span::call_site());
    field
}

/// A string about a user identifier, with its span.
pub(super) fn string(text: &str, span: Span) -> TokenStream {
    let mut literal = Literal::string(text);
    literal.set_span(span);
    literal.into_token_stream()
}

/// The identifier as the user wrote it, without `r#`.
pub(super) fn text(ident: &Ident) -> String {
    ident.unraw().to_string()
}
