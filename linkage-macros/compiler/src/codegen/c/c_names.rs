//! The names of fields and arguments inside the functions.

use proc_macro2::Ident;

use super::In;
use super::c_identifiers::distinct;
use super::header;
use crate::codegen::arguments::Form;
use crate::codegen::identifiers::text;
use crate::interface::Interface;
use crate::interface::components::Component;
use crate::interface::entries::ArgumentKind;
use crate::interface::records::{Record, Shape};
use crate::ir::graph::Node;
use crate::lower::places::{ArgumentPart, Place, place};
use crate::model::mechanism::Mechanism;

/// The argument that points to the parameters.
pub(super) const PARAMETERS: &str = "self";

/// The name in C of a field, among all of its record.
fn field_in_c(solver: &Ident, all: impl Iterator<Item = String> + Clone, field: &str) -> String {
    let at = all.clone().position(|name| name == field).expect("a record has its fields");
    distinct(solver, all).swap_remove(at)
}

/// The name in C of a record's field.
fn field_of(mechanism: &Mechanism, record: &Record, field: &str) -> String {
    field_in_c(&mechanism.name, record.fields.iter().map(|field| text(&field.name)), field)
}

/// The name in C of a parameter.
pub(super) fn param(mechanism: &Mechanism, name: &str) -> String {
    param_of(&mechanism.name, mechanism, name)
}

/// The same in the record of this name.
pub(super) fn param_of(record: &Ident, mechanism: &Mechanism, name: &str) -> String {
    field_in_c(record, mechanism.params.iter().map(|param| text(&param.name)), name)
}

/// The name of an argument that holds this.
fn name_of(given: ArgumentKind) -> &'static str {
    match given {
        ArgumentKind::Value => "q",
        ArgumentKind::Rate => "qd",
        ArgumentKind::Acceleration => "qdd",
        ArgumentKind::Cosine => "cosine",
        ArgumentKind::Sine => "sine",
        ArgumentKind::Loads => "loads",
        ArgumentKind::Drives => "drives",
    }
}

impl In<'_> {
    /// The arguments of a function of our own: types in front, or the names alone.
    pub(super) fn declared(self, given: &[ArgumentKind]) -> Vec<String> {
        let own = self.has_params().then(|| format!("const {} *{PARAMETERS}", self.params_type()));
        let arguments = self.signatures.arguments(given);
        let declare = |(given, (_, form)): (&ArgumentKind, _)| self.declare(&form, name_of(*given));
        own.into_iter().chain(given.iter().zip(arguments.parts()).map(declare)).collect()
    }

    pub(super) fn names(self, given: &[ArgumentKind]) -> Vec<String> {
        let own = self.has_params().then(|| PARAMETERS.to_string());
        own.into_iter().chain(given.iter().map(|&given| name_of(given).to_string())).collect()
    }

    /// An argument that is passed.
    pub(super) fn declare(self, form: &Form<'_>, name: &str) -> String {
        match form {
            Form::Number => format!("{} {name}", self.real()),
            Form::Record(record, _) => {
                format!("const {} *{name}", self.width.type_name(&text(record)))
            }
            Form::List(count) => format!("const {} {name}[{count}]", self.real()),
        }
    }

    pub(super) fn has_params(self) -> bool {
        !self.mechanism.params.is_empty()
    }

    pub(super) fn params_type(self) -> String {
        self.width.type_name(&text(&self.mechanism.name))
    }

    /// An argument, or a local, that holds a result of this shape.
    pub(super) fn result(self, shape: Shape, name: &str) -> String {
        format!("{} {name}{}", self.result_type(shape), header::dimensions(shape))
    }

    pub(super) fn result_type(self, shape: Shape) -> String {
        header::type_of(self.interface(), shape, self.width)
    }

    /// An argument through which a result is handed back.
    pub(super) fn returned(self, shape: Shape, name: &str) -> String {
        match is_array(shape) {
            true => self.result(shape, name),
            false => format!("{} *{name}", self.result_type(shape)),
        }
    }

    /// The places of a result's numbers, in the order of the sinks.
    pub(super) fn components(self, shape: Shape, name: &str) -> Vec<String> {
        components(self.mechanism, self.interface(), shape, name)
    }

    /// The same of a result that a pointer leads to.
    pub(super) fn components_behind(self, shape: Shape, pointer: &str) -> Vec<String> {
        match is_array(shape) {
            true => self.components(shape, pointer),
            false => {
                let behind = |place: String| match place.strip_prefix("*.") {
                    Some(rest) => format!("{pointer}->{rest}"),
                    None => format!("*{pointer}"),
                };
                self.components(shape, "*").into_iter().map(behind).collect()
            }
        }
    }

    /// The expression that reads an input, a load, a drive or a parameter among these arguments.
    pub(super) fn leaf(self, given: &[ArgumentKind], node: Node) -> Option<String> {
        let (mechanism, interface) = (self.mechanism, self.interface());
        Some(match place(mechanism, interface, given, node)? {
            Place::Param(field) => format!("{PARAMETERS}->{}", param(mechanism, &text(field))),
            Place::Argument(at, ArgumentPart::All) => name_of(given[at]).to_string(),
            Place::Argument(at, ArgumentPart::Field(field)) => {
                let record = match given[at] {
                    ArgumentKind::Loads => interface.loads,
                    _ => interface.inputs,
                };
                let record = interface.record(record.expect("several have a record"));
                let field = field_of(mechanism, record, &text(field));
                format!("{}->{field}", name_of(given[at]))
            }
            Place::Argument(at, ArgumentPart::Index(index)) => {
                format!("{}[{index}]", name_of(given[at]))
            }
        })
    }
}

/// The places of the numbers of a result of a mechanism, in the order of the sinks.
pub(super) fn components(
    mechanism: &Mechanism,
    interface: &Interface,
    shape: Shape,
    name: &str,
) -> Vec<String> {
    let ways = interface.components(shape);
    ways.iter().map(|way| component((mechanism, interface), shape, way, name.to_string())).collect()
}

fn component(
    (mechanism, interface): (&Mechanism, &Interface),
    shape: Shape,
    way: &[Component],
    so_far: String,
) -> String {
    let Some((step, rest)) = way.split_first() else { return so_far };
    let of = (mechanism, interface);
    match (step, shape) {
        (Component::Index(at), shape) => component(of, shape, rest, format!("{so_far}[{at}]")),
        (Component::Field(name), Shape::Record(id)) => {
            let record = interface.record(id);
            let field = record.fields.iter().find(|field| field.name == name);
            let shape = field.expect("a record has its fields").shape;
            let name = field_of(mechanism, record, &plain(name));
            component(of, shape, rest, format!("{so_far}.{name}"))
        }
        (Component::Field(name), shape) => component(of, shape, rest, format!("{so_far}.{name}")),
    }
}

/// True if C passes it as an array.
pub(super) fn is_array(shape: Shape) -> bool {
    matches!(shape, Shape::Matrix { .. } | Shape::List(_))
}

/// A name as the user wrote it, without `r#`.
fn plain(name: &str) -> String {
    name.strip_prefix("r#").unwrap_or(name).to_string()
}

/// A string in C. What is not ASCII is written byte by byte.
pub(super) fn quoted(text: &str) -> String {
    let byte = |byte: u8| match byte {
        b'"' | b'\\' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        _ => format!("\\{byte:03o}"),
    };
    format!("\"{}\"", text.bytes().map(byte).collect::<String>())
}
