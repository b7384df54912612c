//! The names in C of a solver's records and functions.

use proc_macro2::Ident;

use crate::codegen::c::c_identifiers::{Width, distinct, file_stem, snake_case};
use crate::codegen::c::c_names::components;
use crate::codegen::identifiers::text;
use crate::interface::Interface;
use crate::interface::entries::Analysis;
use crate::interface::quantity::{Order, Quantity};
use crate::model::mechanism::Mechanism;

/// A set of inputs, the mechanism that it drives, and what is printed of that.
pub(crate) struct SetInC<'a> {
    pub set: &'a Ident,
    pub mechanism: &'a Mechanism,
    pub interface: &'a Interface,
}

/// A row of the outputs in a record.
pub(super) enum RowInC {
    Number(String),
    /// Cosine and sine.
    Angle([String; 2]),
}

impl SetInC<'_> {
    pub(super) fn name(&self) -> String {
        text(&self.mechanism.name)
    }

    pub(super) fn file(&self) -> String {
        file_stem(&self.name())
    }

    pub(super) fn count(&self) -> usize {
        self.mechanism.inputs.len()
    }

    pub(super) fn has_parameters(&self) -> bool {
        !self.mechanism.params.is_empty()
    }

    /// The type of its parameters.
    pub(super) fn parameters(&self, width: Width) -> String {
        width.type_name(&self.name())
    }

    /// A function of this solver.
    pub(super) fn function(&self, action: &str, width: Width) -> String {
        let suffix = if width == Width::Single { "_f32" } else { "" };
        format!("{}_{action}{suffix}", snake_case(&self.name()))
    }

    /// The function of an analysis.
    pub(super) fn answers(&self, analysis: Analysis, width: Width) -> String {
        self.function(analysis.by_value().name(), width)
    }

    /// The type of its inputs.
    pub(super) fn input(&self, width: Width) -> String {
        match self.interface.input_record() {
            Some(record) => width.type_name(&text(record)),
            None => width.in_c().to_string(),
        }
    }

    /// Its inputs as an argument.
    pub(super) fn given(&self, name: &str, width: Width) -> String {
        match self.interface.input_record() {
            Some(_) => format!("const {} *{name}", self.input(width)),
            None => format!("{} {name}", self.input(width)),
        }
    }

    /// The places of the inputs in their record at this place, a number where there is one.
    pub(super) fn inputs_in(&self, place: &str) -> Vec<String> {
        if self.interface.input_record().is_none() {
            return vec![place.to_string()];
        }
        let names = self.mechanism.inputs.iter().map(|input| text(&input.name));
        let names = distinct(&self.mechanism.name, names);
        let field =
            |name: String| match place.strip_prefix("(*").and_then(|of| of.strip_suffix(')')) {
                Some(pointer) => format!("{pointer}->{name}"),
                None => format!("{place}.{name}"),
            };
        names.into_iter().map(field).collect()
    }

    /// The type of the record that an analysis answers with.
    pub(super) fn record(&self, analysis: Analysis, width: Width) -> String {
        let id = self.interface.find(analysis.by_value()).expect("it is printed");
        let shape = self.interface.entry(id).result;
        crate::codegen::c::header::type_of(self.interface, shape, width)
    }

    /// The rows of an answer, those of all orders of a motion.
    pub(super) fn rows(&self, analysis: Analysis, place: &str) -> Vec<Vec<RowInC>> {
        let id = self.interface.find(analysis.by_value()).expect("it is printed");
        let shape = self.interface.entry(id).result;
        let mut parts = components(self.mechanism, self.interface, shape, place).into_iter();
        let orders: &[Order] = match analysis {
            Analysis::Motion => &Order::ALL,
            Analysis::Velocity => &[Order::Velocity],
            _ => &[Order::Position],
        };
        let mut next = || parts.next().expect("an answer has its numbers");
        let mut of_order = |order: Order| {
            let mut rows = Vec::new();
            for output in &self.mechanism.outputs {
                for is_angle in Quantity::of(&output.kind).layout(order).are_angles() {
                    rows.push(match is_angle {
                        true => RowInC::Angle([next(), next()]),
                        false => RowInC::Number(next()),
                    });
                }
            }
            rows
        };
        orders.iter().map(|&order| of_order(order)).collect()
    }
}
