//! The context that generated Rust is printed from. A function that needs one part of it is given that part.

use std::cell::RefCell;
use std::rc::Rc;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::paths::Paths;
use super::token_list::Tokens;
use crate::codegen::arguments::Signatures;
use crate::codegen::identifiers::{GeneratedNames, generated};
use crate::codegen::text::Text;
use crate::interface::entries::Entry;
use crate::interface::records::{Record, RecordId};
use crate::interface::{EntryId, Interface};
use crate::ir::graph::{Graph, Node};
use crate::ir::hash::Map;
use crate::ir::program::Program;
use crate::lower::routine::{Compute, Lowered};
use crate::model::mechanism::{Mechanism, Param, ParamKind};

pub(in crate::codegen) struct Context<'a> {
    pub mechanism: &'a Mechanism,
    pub lowered: &'a Lowered<'a>,
    pub interface: &'a Interface,
    pub signatures: Signatures<'a>,
    pub paths: Paths,
    pub names: GeneratedNames,
    /// The written form of each constant, rounded once.
    constants: RefCell<Map<Node, Rc<str>>>,
    /// True if the solver computes with `f64` alone, so that constants are plain numbers.
    is_double: bool,
}

impl<'a> Context<'a> {
    pub(in crate::codegen) fn new(mechanism: &'a Mechanism, lowered: &'a Lowered<'a>) -> Self {
        let names = GeneratedNames::new(mechanism);
        let records = lowered.interface.records.iter().map(|record| record.name.to_string());
        let paths = Paths::new(mechanism, records.chain([names.solver.to_string()]).collect());
        let interface = &lowered.interface;
        let (signatures, constants) = (Signatures::new(mechanism, interface), RefCell::default());
        let is_double = false;
        Self { mechanism, lowered, interface, signatures, paths, names, constants, is_double }
    }

    /// For code that computes in `f64` alone.
    pub(in crate::codegen) fn in_double(
        mechanism: &'a Mechanism,
        lowered: &'a Lowered<'a>,
    ) -> Self {
        let cx = Self::new(mechanism, lowered);
        let names = GeneratedNames { scalar: cx.paths.imported("f64"), ..cx.names };
        Self { names, is_double: true, ..cx }
    }

    pub(in crate::codegen) fn program(&self) -> &'a Program {
        self.lowered.program
    }

    pub(in crate::codegen) fn graph(&self) -> &'a Graph {
        &self.lowered.program.graph
    }

    pub(in crate::codegen) fn entries(&self) -> impl Iterator<Item = EntryId> + use<> {
        self.interface.ids()
    }

    pub(in crate::codegen) fn entry(&self, id: EntryId) -> &'a Entry {
        self.interface.entry(id)
    }

    pub(in crate::codegen) fn compute(&self, id: EntryId) -> &'a Compute {
        self.lowered.compute(id)
    }

    pub(in crate::codegen) fn record(&self, id: RecordId) -> &'a Record {
        self.interface.record(id)
    }

    /// The type of the inputs in a call: a number, or the record of several.
    pub(in crate::codegen) fn input(&self, number: &impl ToTokens) -> TokenStream {
        match self.interface.input_record() {
            Some(record) => quote!(#record<#number>),
            None => quote!(#number),
        }
    }

    /// True if the mechanism has an unknown, which is found by a search.
    pub(in crate::codegen) fn searches(&self) -> bool {
        !self.mechanism.unknowns.is_empty()
    }

    /// The number of rows of `OUTPUTS`.
    pub(in crate::codegen) fn rows(&self) -> Literal {
        Literal::usize_unsuffixed(self.interface.rows)
    }

    /// The number of inputs.
    pub(in crate::codegen) fn columns(&self) -> Literal {
        Literal::usize_unsuffixed(self.interface.columns)
    }

    /// A function of the type parameter, which nothing but its bound can provide.
    pub(in crate::codegen) fn scalar(&self, function: &str) -> Tokens {
        Tokens::path(self.number(), generated(function))
    }

    /// The type or trait whose functions compute: the type parameter, or `Scalar` for `f64`.
    pub(in crate::codegen) fn number(&self) -> Ident {
        // `f64` has functions of its own by these names, which are each platform's.
        match self.is_double {
            true => self.paths.imported("Scalar"),
            false => self.names.scalar.clone(),
        }
    }

    /// A constant as the type parameter's number, rounded to each width; where rounding twice does not
    /// show, as one literal.
    pub(in crate::codegen) fn literal(&self, wide: f64, narrow: f32) -> Tokens {
        Text::from(self.written(wide, narrow)).into_token_stream().into()
    }

    /// The same as text.
    pub(in crate::codegen) fn written(&self, wide: f64, narrow: f32) -> String {
        if self.is_double {
            return digits(wide);
        }
        let number = self.number();
        match (wide as f32).to_bits() == narrow.to_bits() {
            true => format!("{number}::num({})", digits(wide)),
            false => format!("{number}::lit({}, {})", digits(wide), digits(narrow)),
        }
    }

    /// A constant of the graph as text.
    pub(in crate::codegen) fn constant(&self, node: Node) -> Rc<str> {
        if let Some(known) = self.constants.borrow().get(&node) {
            return known.clone();
        }
        let value = |constant| self.graph().value(constant);
        let (wide, narrow) = match node {
            Node::Low(constant) => (value(constant).low_f64(), value(constant).low_f32()),
            Node::Constant(constant) => (value(constant).to_f64(), value(constant).to_f32()),
            _ => unreachable!("only constants are read as such"),
        };
        let written: Rc<str> = self.written(wide, narrow).into();
        self.constants.borrow_mut().insert(node, written.clone());
        written
    }
}

/// The parameters that are numbers.
pub(in crate::codegen) fn numeric_params(mechanism: &Mechanism) -> Vec<&Param> {
    let numeric = |param: &&Param| matches!(param.kind, ParamKind::Number { .. });
    mechanism.params.iter().filter(numeric).collect()
}

/// The shortest digits that mean the number; of an infinity, which none mean, a quotient.
fn digits(value: impl std::fmt::Debug) -> String {
    let digits = format!("{value:?}");
    match digits.bytes().last() {
        Some(b'0'..=b'9') => digits,
        _ if digits.starts_with('-') => "-(1.0 / 0.0)".to_string(),
        _ => "(1.0 / 0.0)".to_string(),
    }
}

/// The same as tokens.
pub(in crate::codegen) fn literal(value: impl std::fmt::Debug) -> Tokens {
    Text::from(digits(value)).into_token_stream().into()
}
