//! The arguments of an entry point, and how its core reads them.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::names::text;
use super::pieces::Pieces;
use super::{Context, entry, sweeps};
use crate::ir::graph::Node;
use crate::ir::program::EntryKind;

/// What all arguments of all functions are called.
pub(super) fn all_names(cx: &Context<'_>) -> impl Iterator<Item = String> {
    let entries = cx.program.entries.iter();
    let names = entries.flat_map(|entry| Arguments::new(cx, entry.kind).names);
    let names = names.map(|name| name.to_string());
    names.chain(sweeps::ARGUMENTS.map(str::to_string)).collect::<BTreeSet<_>>().into_iter()
}

/// One input: an argument for its value, rate and second rate; several: a record for each.
pub(super) struct Arguments<'a> {
    cx: &'a Context<'a>,
    kind: EntryKind,
    names: Vec<Ident>,
    /// Whether each argument is a record of all inputs.
    records: bool,
}

impl<'a> Arguments<'a> {
    pub(super) fn new(cx: &'a Context<'a>, kind: EntryKind) -> Self {
        let orders = entry::orders(kind);
        let plain = |name| Ident::new(name, Span::call_site());
        let (records, mut names) = match &cx.mechanism.inputs[..] {
            [_] if entry::takes_cosine(kind) => {
                let rates = cx.names.only_input[1..].iter().cloned();
                (false, [plain("cos"), plain("sin")].into_iter().chain(rates).collect())
            }
            [_] => (false, cx.names.only_input.clone()),
            _ => (true, ["inputs", "rates", "accelerations"].map(plain).to_vec()),
        };
        names.truncate(orders + usize::from(entry::takes_cosine(kind)));
        Self { cx, kind, names, records }
    }

    /// The arguments as a call passes them on.
    pub(super) fn names(&self) -> &[Ident] {
        &self.names
    }

    /// How a public function declares them, for numbers of this type.
    pub(super) fn declared(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let ty = if self.records {
            let into = self.cx.paths.item("Into");
            let record = self.record(scalar);
            quote!(impl #into<#record>)
        } else {
            scalar.clone()
        };
        self.names.iter().map(|name| quote!(#name: #ty)).collect()
    }

    /// How a private function declares them: as the records themselves.
    pub(super) fn received(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let ty = self.ty(scalar);
        self.names.iter().map(|name| quote!(#name: #ty)).collect()
    }

    /// The type of every argument.
    pub(super) fn ty(&self, scalar: &TokenStream) -> TokenStream {
        if self.records { self.record(scalar) } else { scalar.clone() }
    }

    /// Whether each argument is a record of all inputs.
    pub(super) fn are_records(&self) -> bool {
        self.records
    }

    /// Makes records of what a public function was given; nothing for plain numbers.
    pub(super) fn converted(&self, scalar: &TokenStream) -> TokenStream {
        if !self.records {
            return TokenStream::new();
        }
        let (names, record) = (&self.names, self.record(scalar));
        let into = self.cx.paths.item("Into");
        quote!(#(let #names: #record = #into::into(#names);)*)
    }

    /// Names the arguments that a core does not read, so that none counts as forgotten.
    pub(super) fn unread(&self, leaves: &[Node]) -> TokenStream {
        let read: Vec<usize> = leaves.iter().filter_map(|&node| self.position_of(node)).collect();
        let unread = self.names.iter().enumerate().filter(|(i, _)| !read.contains(i));
        unread.map(|(_, name)| quote!(let _ = #name;)).collect()
    }

    fn record(&self, scalar: &TokenStream) -> TokenStream {
        let input = &self.cx.names.input;
        quote!(#input<#scalar>)
    }

    /// Which argument a node reads.
    fn position_of(&self, node: Node) -> Option<usize> {
        let shift = usize::from(entry::takes_cosine(self.kind));
        match node {
            Node::InputCos(_) => Some(0),
            Node::InputSin(_) => Some(1),
            Node::Input { order, .. } => Some(usize::from(order) + shift),
            _ => None,
        }
    }

    /// The expression by which a core reads an input or a parameter.
    pub(super) fn leaf(&self, node: Node) -> Option<Pieces> {
        if let Node::Param(param) = node {
            let field = &self.cx.mechanism.params[param as usize].name;
            return Some(quote!(self.#field).into());
        }
        let name = &self.names[self.position_of(node)?];
        match node {
            Node::Input { input, .. } if self.records => {
                let field = &self.cx.mechanism.inputs[input as usize].name;
                Some(quote!(#name.#field).into())
            }
            _ => Some(name.clone().into()),
        }
    }

    /// What an error calls the input or parameter.
    pub(super) fn label(&self, node: Node) -> Option<String> {
        match node {
            Node::Param(param) => Some(text(&self.cx.mechanism.params[param as usize].name)),
            Node::InputCos(_) => Some("cos".to_string()),
            Node::InputSin(_) => Some("sin".to_string()),
            Node::Input { input, order } => {
                let suffix = ["", "_rate", "_acceleration"][usize::from(order)];
                let name = text(&self.cx.mechanism.inputs[input as usize].name);
                Some(format!("{name}{suffix}"))
            }
            _ => None,
        }
    }
}
