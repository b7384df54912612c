//! The arguments of an entry point or routine, and how its statements read them.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::{SWEEP_ARGUMENTS, text};
use super::token_list::Tokens;
use crate::interface::entries::Given;
use crate::ir::graph::Node;

/// What all arguments of all functions are called.
pub(super) fn all_names(cx: &Context<'_>) -> impl Iterator<Item = String> {
    let entries = cx.interface.entries.iter();
    let names = entries.flat_map(|entry| Arguments::new(cx, entry.given).names);
    let names = names.map(|name| name.to_string());
    names.chain(SWEEP_ARGUMENTS.map(str::to_string)).collect::<BTreeSet<_>>().into_iter()
}

/// One input: an argument for its value, rate and second rate; several: a record for each.
pub(super) struct Arguments<'a> {
    cx: &'a Context<'a>,
    given: &'static [Given],
    names: Vec<Ident>,
}

impl<'a> Arguments<'a> {
    pub(super) fn new(cx: &'a Context<'a>, given: &'static [Given]) -> Self {
        let plain = |name| Ident::new(name, Span::call_site());
        let order = |nth: usize| match cx.inputs() {
            None => cx.names.only_input[nth].clone(),
            Some(_) => plain(["inputs", "rates", "accelerations"][nth]),
        };
        let name = |given: &Given| match given {
            Given::Value => order(0),
            Given::Rate => order(1),
            Given::Acceleration => order(2),
            Given::Cosine => plain("cos"),
            Given::Sine => plain("sin"),
        };
        Self { cx, given, names: given.iter().map(name).collect() }
    }

    /// The arguments as a call passes them on.
    pub(super) fn names(&self) -> &[Ident] {
        &self.names
    }

    /// How a public function declares them, for numbers of this type.
    pub(super) fn declared(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let ty = match self.cx.inputs() {
            Some(_) => {
                let (into, record) = (self.cx.paths.item("Into"), self.ty(scalar));
                quote!(impl #into<#record>)
            }
            None => scalar.clone(),
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
        match self.cx.inputs() {
            Some(record) => quote!(#record<#scalar>),
            None => scalar.clone(),
        }
    }

    /// Whether each argument is a record of all inputs.
    pub(super) fn are_records(&self) -> bool {
        self.cx.inputs().is_some()
    }

    /// Makes records of what a public function was given; nothing for plain numbers.
    pub(super) fn converted(&self, scalar: &TokenStream) -> TokenStream {
        let Some(record) = self.cx.inputs() else { return TokenStream::new() };
        let (names, into) = (&self.names, self.cx.paths.item("Into"));
        quote!(#(let #names: #record<#scalar> = #into::into(#names);)*)
    }

    /// Names the arguments that are not read, so that none counts as forgotten.
    pub(super) fn unread(&self, reads: &[Node]) -> TokenStream {
        let read: Vec<usize> = reads.iter().filter_map(|&node| self.position_of(node)).collect();
        let unread = self.names.iter().enumerate().filter(|(i, _)| !read.contains(i));
        unread.map(|(_, name)| quote!(let _ = #name;)).collect()
    }

    /// Which argument a node reads.
    fn position_of(&self, node: Node) -> Option<usize> {
        let given = match node {
            Node::InputCos(_) => Given::Cosine,
            Node::InputSin(_) => Given::Sine,
            Node::Input { order, .. } => {
                [Given::Value, Given::Rate, Given::Acceleration][usize::from(order)]
            }
            _ => return None,
        };
        self.given.iter().position(|&known| known == given)
    }

    /// The expression that reads an input or a parameter.
    pub(super) fn read(&self, node: Node) -> Option<Tokens> {
        if let Node::Param(param) = node {
            let field = &self.cx.mechanism.params[param as usize].name;
            return Some(quote!(self.#field).into());
        }
        let name = &self.names[self.position_of(node)?];
        match node {
            Node::Input { input, .. } if self.are_records() => {
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
