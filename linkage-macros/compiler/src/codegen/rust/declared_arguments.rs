//! The arguments of an entry point or routine in Rust: how functions declare, convert and read them.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::paths::Paths;
use crate::codegen::arguments::{Arguments, Form, Signatures};
use crate::codegen::identifiers::SWEEP_ARGUMENTS;
use crate::codegen::text::Text;
use crate::interface::entries::Analysis;
use crate::ir::graph::Node;
use crate::lower::label;
use crate::lower::places::{ArgumentPart, Place, argument as argument_of, place};

/// The names of the arguments of all functions, without repetition.
pub(in crate::codegen) fn all_names(signatures: &Signatures<'_>) -> impl Iterator<Item = String> {
    let interface = signatures.interface;
    let entries = interface.entries.iter();
    let names = entries.flat_map(|entry| signatures.arguments(&entry.given).names().to_vec());
    let told = (interface.inputs.is_some() && interface.has(Analysis::EquationsOfMotion))
        .then(|| Ident::new("given", Span::call_site()));
    let names = names.chain(told).map(|name| name.to_string());
    names.chain(SWEEP_ARGUMENTS.map(str::to_string)).collect::<BTreeSet<_>>().into_iter()
}

impl Form<'_> {
    pub(in crate::codegen) fn ty(&self, scalar: &TokenStream) -> TokenStream {
        match self {
            Self::Number => scalar.clone(),
            Self::Record(record, _) => quote!(#record<#scalar>),
            Self::List(count) => {
                let count = Literal::usize_unsuffixed(*count);
                quote!([#scalar; #count])
            }
        }
    }
}

impl Arguments<'_> {
    /// The declarations of the arguments in a public function, for numbers of this type.
    pub(in crate::codegen) fn declared(
        &self,
        paths: &Paths,
        scalar: &TokenStream,
    ) -> Vec<TokenStream> {
        let declare = |(name, form): (&Ident, Form<'_>)| match form {
            Form::Record(record, _) => {
                let (inputs, ty) = (paths.item("Inputs"), quote!(#record<#scalar>));
                quote!(#name: impl #inputs<#ty>)
            }
            form => {
                let ty = form.ty(scalar);
                quote!(#name: #ty)
            }
        };
        self.parts().map(declare).collect()
    }

    /// The declarations of the arguments in a private function, which takes records as they are.
    pub(in crate::codegen) fn received(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let receive = |(name, form): (&Ident, Form<'_>)| {
            let ty = form.ty(scalar);
            quote!(#name: #ty)
        };
        self.parts().map(receive).collect()
    }

    /// Makes records of what a public function was given; nothing for plain numbers.
    pub(in crate::codegen) fn converted(&self, paths: &Paths, scalar: &TokenStream) -> TokenStream {
        let into = paths.item("Into");
        let convert = |(name, form): (&Ident, Form<'_>)| {
            let Form::Record(record, _) = form else { return None };
            Some(quote!(let #name: #record<#scalar> = #into::into(#name);))
        };
        self.parts().filter_map(convert).collect()
    }

    /// Names the arguments that are not read, so that none counts as forgotten.
    pub(in crate::codegen) fn unread(&self, reads: &[Node]) -> TokenStream {
        let read: Vec<usize> =
            reads.iter().filter_map(|&node| argument_of(self.given, node)).collect();
        let unread = self.names().iter().enumerate().filter(|(i, _)| !read.contains(i));
        unread.map(|(_, name)| quote!(let _ = #name;)).collect()
    }

    /// The expression that reads an input or a parameter.
    pub(in crate::codegen) fn written(&self, node: Node) -> Option<String> {
        let Signatures { mechanism, interface, .. } = *self.of;
        Some(match place(mechanism, interface, self.given, node)? {
            Place::Param(field) => format!("self.{field}"),
            Place::Argument(at, ArgumentPart::All) => self.names()[at].to_string(),
            Place::Argument(at, ArgumentPart::Field(field)) => {
                format!("{}.{field}", self.names()[at])
            }
            Place::Argument(at, ArgumentPart::Index(index)) => {
                format!("{}[{index}]", self.names()[at])
            }
        })
    }

    /// A list of inputs and parameters, each with what an error calls it.
    pub(in crate::codegen) fn labelled(&self, nodes: &[Node]) -> Text {
        let mut list = Text::default();
        let read = |&node: &Node| Some((self.written(node)?, label(self.of.mechanism, node)?));
        list.put("[").list(nodes.iter().filter_map(read), |to, (value, label)| {
            to.put(&format!("({value}, {label:?})"));
        });
        list.put("]");
        list
    }
}
