//! The names of a declaration for editors: hovering over one, going to where it is made and
//! renaming it work wherever a token of the generated code has the user's own span.
//!
//! Most names are fields. The others are made fields of a struct that nothing else uses, and an
//! uncalled function reads each name wherever the declaration does.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::context::Context;
use crate::codegen::identifiers::{generated, text};
use crate::interface::quantity::Order;
use crate::interface::records::RecordKind;
use crate::model::mechanism::Mechanism;

/// Nothing for stubs, which have references of their own in their messages.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let references = &cx.mechanism.references;
    if references.made.is_empty() {
        return TokenStream::new();
    }
    let places = Places::new(cx.mechanism);
    let made = references.made.iter().filter(|(name, _)| places.place(name).is_none());
    let fields = made.map(|(name, made_by)| {
        let doc = format!(" `{}`, made by `{made_by}`.", text(name));
        quote!(#[doc = #doc] #name: ())
    });
    let uses = references.used.iter().map(|name| match places.place(name) {
        Some(place) => quote!(&#place.#name),
        None => quote!(&self.#name),
    });
    let scalar = &cx.names.scalar;
    let position =
        cx.interface.records.iter().find(|r| r.kind == RecordKind::Outputs(Order::Position));
    let records = [
        ("solver_", Some(&cx.names.solver)),
        ("inputs_", cx.interface.input_record()),
        ("position_", position.map(|record| &record.name)),
    ];
    let read: HashSet<_> = references.used.iter().filter_map(|name| places.place(name)).collect();
    let arguments: Vec<_> = records
        .into_iter()
        .map(|(place, record)| (generated(place), record))
        .filter(|(place, _)| read.contains(place))
        .filter_map(|(place, record)| Some((place, record?)))
        .map(|(place, record)| quote!(#place: &#record<#scalar>))
        .collect();
    let generics = (!arguments.is_empty()).then(|| quote!(<#scalar>));
    quote! {
        #[allow(dead_code, non_snake_case, reason = "names are as declared, and for editors alone")]
        struct Names_ { #(#fields,)* }

        #[allow(dead_code, reason = "for editors alone")]
        impl Names_ {
            fn uses_ #generics(&self, #(#arguments),*) {
                let _ = (#(#uses,)*);
            }
        }
    }
}

/// The names that are fields already, by the record that has them.
struct Places {
    params: HashSet<String>,
    inputs: HashSet<String>,
    outputs: HashSet<String>,
}

impl Places {
    fn new(mechanism: &Mechanism) -> Self {
        // A single input has no record, and is no field.
        let inputs = mechanism.inputs.iter().filter(|_| mechanism.inputs.len() > 1);
        Self {
            params: mechanism.params.iter().map(|param| param.name.to_string()).collect(),
            inputs: inputs.map(|input| input.name.to_string()).collect(),
            outputs: mechanism.outputs.iter().map(|output| output.field.to_string()).collect(),
        }
    }

    /// The argument of which the name is a field.
    fn place(&self, name: &Ident) -> Option<Ident> {
        let name = name.to_string();
        let found =
            [("solver_", &self.params), ("inputs_", &self.inputs), ("position_", &self.outputs)];
        found.iter().find(|(_, names)| names.contains(&name)).map(|(place, _)| generated(place))
    }
}
