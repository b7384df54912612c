//! The types of a mechanism: its parameters, inputs, loads and results as structures.

use proc_macro2::Ident;

use super::Plc;
use super::st_names::BlockNames;
use crate::codegen::c::header::about_field;
use crate::codegen::identifiers::text;
use crate::interface::components::Component;
use crate::interface::quantity::Order;
use crate::interface::records::{Record, Shape};
use crate::interface::units_in_words::unit;
use crate::model::mechanism::{ParamKind, Sign};

/// A text within a comment. What would end it is taken apart, and our own signs are written in ASCII.
pub(super) fn in_comment(text: &str) -> String {
    let mut text = text.to_string();
    for (sign, ascii) in
        [("*)", "* )"), ("(*", "( *"), ("²", "^2"), ("³", "^3"), ("·", "*"), ("∂", "d"), ("`", "")]
    {
        text = text.replace(sign, ascii);
    }
    text
}

/// A comment on a line of its own.
pub(super) fn comment(text: &str) -> String {
    format!("(* {} *)", in_comment(text.trim_end_matches('.').trim()))
}

/// The name of a field among those of its record.
pub(super) fn field<'n>(all: impl Iterator<Item = &'n Ident>, name: &Ident) -> String {
    let all: Vec<String> = all.map(text).collect();
    let at = all.iter().position(|of| *of == text(name)).expect("a record has its fields");
    BlockNames::default().names(all).swap_remove(at)
}

impl Plc<'_> {
    /// The types of one width.
    pub(super) fn types(self, to: &mut String) {
        if self.has_params() {
            self.parameters(to);
        }
        let interface = self.interface();
        for record in interface.records.iter().filter(|record| interface.is_used(record)) {
            self.record(record, to);
        }
    }

    fn structure(
        self,
        about: &str,
        name: &str,
        fields: &[(String, String, String)],
        to: &mut String,
    ) {
        *to += &format!("\n{}\nTYPE {} :\nSTRUCT\n", comment(about), self.type_name(name));
        for (name, ty, about) in fields {
            *to += &format!("    {name} : {ty}; {}\n", comment(about));
        }
        *to += "END_STRUCT;\nEND_TYPE\n";
    }

    fn parameters(self, to: &mut String) {
        let names = self.mechanism.params.iter().map(|param| text(&param.name));
        let names = BlockNames::default().names(names);
        let fields =
            self.mechanism.params.iter().zip(names).map(|(param, name)| match &param.kind {
                ParamKind::Number { dimension, default, .. } => {
                    let digits = self.digits(default.to_f64(), default.to_f32());
                    let unit = unit(*dimension, Order::Position);
                    (name, format!("{} := {digits}", self.real()), format!("In {unit}"))
                }
                ParamKind::Mode { of, default } => {
                    let sign = if *default == Sign::Plus { "1" } else { "-1" };
                    (name, format!("INT := {sign}"), of.row().in_c.to_string())
                }
            });
        let solver = text(&self.mechanism.name);
        let about = format!("The parameters of {solver}, as declared where nothing else is given");
        self.structure(&about, &solver, &fields.collect::<Vec<_>>(), to);
    }

    fn record(self, record: &Record, to: &mut String) {
        let words = record.kind.in_words(self.mechanism).in_c;
        let about = words.replace('@', &self.mechanism.name.to_string());
        let names =
            BlockNames::default().names(record.fields.iter().map(|field| text(&field.name)));
        let fields = record.fields.iter().zip(names).map(|(field, name)| {
            (name, self.type_of(field.shape), about_field(self.mechanism, field.subject))
        });
        self.structure(&about, &text(&record.name), &fields.collect::<Vec<_>>(), to);
    }

    /// The type of a field or a pin.
    pub(super) fn type_of(self, shape: Shape) -> String {
        let real = self.real();
        match shape {
            Shape::Number => real.to_string(),
            Shape::List(count) => format!("ARRAY[0..{}] OF {real}", count - 1),
            Shape::Matrix { rows, columns } => {
                format!("ARRAY[0..{}, 0..{}] OF {real}", rows - 1, columns - 1)
            }
            Shape::Record(record) => self.type_name(&text(&self.interface().record(record).name)),
            Shape::Quantity(quantity, order) => match quantity.layout(order).record {
                Some(record) => self.width.shared_type_name(record),
                None => real.to_string(),
            },
        }
    }

    /// The places of a result's numbers, in the order of the sinks.
    pub(super) fn components(self, shape: Shape, name: &str) -> Vec<String> {
        let ways = self.interface().components(shape);
        ways.iter().map(|way| self.component(shape, way, name.to_string())).collect()
    }

    fn component(self, shape: Shape, way: &[Component], so_far: String) -> String {
        match (way, shape) {
            ([], _) => so_far,
            ([Component::Index(row), Component::Index(column)], _) => {
                format!("{so_far}[{row}, {column}]")
            }
            ([Component::Index(at), rest @ ..], _) => {
                self.component(shape, rest, format!("{so_far}[{at}]"))
            }
            ([Component::Field(name), rest @ ..], Shape::Record(id)) => {
                let record = self.interface().record(id);
                let own = record.fields.iter().find(|field| field.name == name);
                let own = own.expect("a record has its fields");
                let all = record.fields.iter().map(|field| &field.name);
                let name = field(all, &own.name);
                self.component(own.shape, rest, format!("{so_far}.{name}"))
            }
            ([Component::Field(name), rest @ ..], _) => {
                let name = BlockNames::default().name(name);
                self.component(shape, rest, format!("{so_far}.{name}"))
            }
        }
    }

    /// The words about a result.
    pub(super) fn words_of_result(self, shape: Shape) -> String {
        match shape {
            Shape::Record(id) => {
                let words = self.interface().record(id).kind.in_words(self.mechanism).in_c;
                words.replace('@', &self.mechanism.name.to_string())
            }
            Shape::Matrix { .. } => "A row an output, a column an input".to_string(),
            Shape::Number | Shape::List(_) | Shape::Quantity(..) => {
                "In the order of the inputs".to_string()
            }
        }
    }
}
