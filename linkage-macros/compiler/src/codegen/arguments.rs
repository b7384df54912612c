//! The arguments of an entry point or routine, and how its statements read them.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::{CIRCLE, SWEEP_ARGUMENTS, argument};
use super::text::Text;
use crate::interface::entries::{Analysis, ArgumentKind};
use crate::ir::graph::Node;
use crate::lower::label;
use crate::lower::places::{ArgumentPart, Place, argument as argument_of, place};

/// The names of the arguments of all functions, without repetition.
pub(super) fn all_names(cx: &Context<'_>) -> impl Iterator<Item = String> {
    let entries = cx.interface.entries.iter();
    let names = entries.flat_map(|entry| Arguments::new(cx, &entry.given).names);
    let told = (cx.inputs().is_some() && cx.interface.has(Analysis::EquationsOfMotion))
        .then(|| Ident::new("given", Span::call_site()));
    let names = names.chain(told).map(|name| name.to_string());
    names.chain(SWEEP_ARGUMENTS.map(str::to_string)).collect::<BTreeSet<_>>().into_iter()
}

/// The shape of an argument.
pub(super) enum Form<'a> {
    Number,
    /// A record, and its fields.
    Record(&'a Ident, Vec<&'a Ident>),
    /// So many numbers.
    List(usize),
}

impl Form<'_> {
    pub(super) fn ty(&self, scalar: &TokenStream) -> TokenStream {
        match self {
            Self::Number => scalar.clone(),
            Self::Record(record, _) => quote!(#record<#scalar>),
            Self::List(count) => {
                let count = Literal::usize_unsuffixed(*count);
                quote!([#scalar; #count])
            }
        }
    }

    /// The count of numbers that it holds.
    pub(super) fn numbers(&self) -> usize {
        match self {
            Self::Number => 1,
            Self::Record(_, fields) => fields.len(),
            Self::List(count) => *count,
        }
    }
}

/// A load may be called like an argument that is about the inputs: then it gets a tail.
pub(super) fn clear_of(names: &[Ident], mut name: Ident) -> Ident {
    while names.contains(&name) {
        name = Ident::new(&format!("{name}_"), name.span());
    }
    name
}

/// One input: an argument for its value, rate and second rate; several: a record for each.
pub(super) struct Arguments<'a> {
    cx: &'a Context<'a>,
    given: &'a [ArgumentKind],
    names: Vec<Ident>,
}

impl<'a> Arguments<'a> {
    pub(super) fn new(cx: &'a Context<'a>, given: &'a [ArgumentKind]) -> Self {
        let plain = |name| Ident::new(name, Span::call_site());
        let order = |nth: usize| match cx.inputs() {
            None => cx.names.only_input[nth].clone(),
            Some(_) => plain(["inputs", "rates", "accelerations"][nth]),
        };
        let mut names: Vec<Ident> = Vec::new();
        for given in given {
            let name = match given {
                ArgumentKind::Value => order(0),
                ArgumentKind::Rate => order(1),
                ArgumentKind::Acceleration => order(2),
                ArgumentKind::Cosine => plain(CIRCLE[0]),
                ArgumentKind::Sine => plain(CIRCLE[1]),
                ArgumentKind::Loads => match &cx.mechanism.dynamics.loads[..] {
                    [only] => clear_of(&names, argument(&only.name, "")),
                    _ => clear_of(&names, plain("loads")),
                },
                ArgumentKind::Drives => clear_of(&names, plain("drive")),
            };
            names.push(name);
        }
        Self { cx, given, names }
    }

    /// Those of a function that only generated code calls, for formulas that are written as text: the
    /// names have nothing of the tokens that the user may have had a macro write.
    pub(super) fn with_call_site_spans(cx: &'a Context<'a>, given: &'a [ArgumentKind]) -> Self {
        let mut arguments = Self::new(cx, given);
        arguments.names.iter_mut().for_each(|name| name.set_span(Span::call_site()));
        arguments
    }

    /// The arguments as a call passes them on.
    pub(super) fn names(&self) -> &[Ident] {
        &self.names
    }

    /// The declarations of the arguments in a public function, for numbers of this type.
    pub(super) fn declared(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let declare = |(name, form): (&Ident, Form<'_>)| match form {
            Form::Record(record, _) => {
                let (inputs, ty) = (self.cx.paths.item("Inputs"), quote!(#record<#scalar>));
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
    pub(super) fn received(&self, scalar: &TokenStream) -> Vec<TokenStream> {
        let receive = |(name, form): (&Ident, Form<'_>)| {
            let ty = form.ty(scalar);
            quote!(#name: #ty)
        };
        self.parts().map(receive).collect()
    }

    /// Each argument with what it is.
    pub(super) fn parts(&self) -> impl Iterator<Item = (&Ident, Form<'a>)> {
        self.given.iter().zip(&self.names).map(|(given, name)| (name, self.form(*given)))
    }

    fn form(&self, given: ArgumentKind) -> Form<'a> {
        let mechanism = self.cx.mechanism;
        let inputs = || mechanism.inputs.iter().map(|input| &input.name).collect();
        let loads = || mechanism.dynamics.loads.iter().map(|load| &load.name).collect();
        match (given, self.cx.inputs(), self.cx.loads()) {
            (ArgumentKind::Loads, _, Some(record)) => Form::Record(record, loads()),
            (ArgumentKind::Drives, Some(_), _) => Form::List(mechanism.inputs.len()),
            (ArgumentKind::Loads, _, None) | (_, None, _) => Form::Number,
            (_, Some(record), _) => Form::Record(record, inputs()),
        }
    }

    /// True if a public function converts an argument into a record.
    pub(super) fn has_records(&self) -> bool {
        self.parts().any(|(_, form)| matches!(form, Form::Record(..)))
    }

    /// Makes records of what a public function was given; nothing for plain numbers.
    pub(super) fn converted(&self, scalar: &TokenStream) -> TokenStream {
        let into = self.cx.paths.item("Into");
        let convert = |(name, form): (&Ident, Form<'_>)| {
            let Form::Record(record, _) = form else { return None };
            Some(quote!(let #name: #record<#scalar> = #into::into(#name);))
        };
        self.parts().filter_map(convert).collect()
    }

    /// Names the arguments that are not read, so that none counts as forgotten.
    pub(super) fn unread(&self, reads: &[Node]) -> TokenStream {
        let read: Vec<usize> =
            reads.iter().filter_map(|&node| argument_of(self.given, node)).collect();
        let unread = self.names.iter().enumerate().filter(|(i, _)| !read.contains(i));
        unread.map(|(_, name)| quote!(let _ = #name;)).collect()
    }

    /// The expression that reads an input or a parameter.
    pub(super) fn written(&self, node: Node) -> Option<String> {
        let cx = self.cx;
        Some(match place(cx.mechanism, cx.interface, self.given, node)? {
            Place::Param(field) => format!("self.{field}"),
            Place::Argument(at, ArgumentPart::All) => self.names[at].to_string(),
            Place::Argument(at, ArgumentPart::Field(field)) => {
                format!("{}.{field}", self.names[at])
            }
            Place::Argument(at, ArgumentPart::Index(index)) => {
                format!("{}[{index}]", self.names[at])
            }
        })
    }

    /// A list of inputs and parameters, each with what an error calls it.
    pub(super) fn labelled(&self, nodes: &[Node]) -> Text {
        let mut list = Text::default();
        let read = |&node: &Node| Some((self.written(node)?, label(self.cx.mechanism, node)?));
        list.put("[").list(nodes.iter().filter_map(read), |to, (value, label)| {
            to.put(&format!("({value}, {label:?})"));
        });
        list.put("]");
        list
    }
}
