//! The arguments of an entry point or routine: their names and their shapes, in every language.

use proc_macro2::{Ident, Span};

use super::identifiers::{CIRCLE, argument};
use crate::interface::Interface;
use crate::interface::entries::ArgumentKind;
use crate::model::mechanism::Mechanism;

/// The shape of an argument.
pub(super) enum Form<'a> {
    Number,
    /// A record, and its fields.
    Record(&'a Ident, Vec<&'a Ident>),
    /// So many numbers.
    List(usize),
}

impl Form<'_> {
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

/// The facts that the arguments of every entry point follow from.
pub(super) struct Signatures<'a> {
    pub mechanism: &'a Mechanism,
    pub interface: &'a Interface,
    /// The arguments for the value, the rate and the acceleration of an input that is the only one.
    only_input: Vec<Ident>,
}

impl<'a> Signatures<'a> {
    pub(super) fn new(mechanism: &'a Mechanism, interface: &'a Interface) -> Self {
        let only_input = match &mechanism.inputs[..] {
            [only] => ["", "_rate", "_acceleration"].map(|s| argument(&only.name, s)).to_vec(),
            _ => Vec::new(),
        };
        Self { mechanism, interface, only_input }
    }

    /// The arguments of an entry point or routine that is given this.
    pub(super) fn arguments<'s>(&'s self, given: &'s [ArgumentKind]) -> Arguments<'s> {
        let plain = |name| Ident::new(name, Span::call_site());
        let order = |nth: usize| match self.interface.input_record() {
            None => self.only_input[nth].clone(),
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
                ArgumentKind::Loads => match &self.mechanism.dynamics.loads[..] {
                    [only] => clear_of(&names, argument(&only.name, "")),
                    _ => clear_of(&names, plain("loads")),
                },
                ArgumentKind::Drives => clear_of(&names, plain("drive")),
            };
            names.push(name);
        }
        Arguments { of: self, given, names }
    }

    /// Those of a function that only generated code calls, for formulas that are written as text: the
    /// names have nothing of the tokens that the user may have had a macro write.
    pub(super) fn with_call_site_spans<'s>(&'s self, given: &'s [ArgumentKind]) -> Arguments<'s> {
        let mut arguments = self.arguments(given);
        arguments.names.iter_mut().for_each(|name| name.set_span(Span::call_site()));
        arguments
    }
}

/// One input: an argument for its value, rate and acceleration; several: a record for each.
pub(super) struct Arguments<'a> {
    pub of: &'a Signatures<'a>,
    pub given: &'a [ArgumentKind],
    names: Vec<Ident>,
}

impl<'a> Arguments<'a> {
    /// The arguments as a call passes them on.
    pub(super) fn names(&self) -> &[Ident] {
        &self.names
    }

    /// Each argument with what it is.
    pub(super) fn parts(&self) -> impl Iterator<Item = (&Ident, Form<'a>)> {
        self.given.iter().zip(&self.names).map(|(given, name)| (name, self.form(*given)))
    }

    fn form(&self, given: ArgumentKind) -> Form<'a> {
        let Signatures { mechanism, interface, .. } = *self.of;
        let inputs = || mechanism.inputs.iter().map(|input| &input.name).collect();
        let loads = || mechanism.dynamics.loads.iter().map(|load| &load.name).collect();
        match (given, interface.input_record(), interface.load_record()) {
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
}
