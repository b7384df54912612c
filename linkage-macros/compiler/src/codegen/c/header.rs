//! The text of the header: the types and functions as C sees them, field for field what the
//! generated Rust lays out.

use proc_macro2::Ident;

use super::c_identifiers::{
    PARAMETERS, Width, arguments, default, distinct, file_stem, function, snake_case,
};
use crate::codegen::arguments::{Form, Signatures};
use crate::codegen::docs::{self, force_docs};
use crate::codegen::identifiers::text as plain;
use crate::interface::entries::Entry;
use crate::interface::quantity::Order;
use crate::interface::records::{self, Field, RecordKind, Shape, Subject};
use crate::interface::units_in_words::unit;
use crate::interface::{Interface, labels};
use crate::model::mechanism::{Mechanism, Param, ParamKind};

/// The part that all headers share: status codes, modes and the records that outputs are made of.
pub const SHARED: &str = include_str!("linkage.h");

/// The records that forces are made of, where they are asked for.
const FORCES: &str = include_str!("forces.h");

/// The status of mechanisms in which something is searched.
pub const NO_SOLUTION: &str = "\
/* The unknown `name` has no solution of its mode between its ends; `by` is left of its equation. */
#define LINKAGE_NO_SOLUTION 8
/* The equation of `name` has several dead points between its ends: narrow the interval. */
#define LINKAGE_SEVERAL_DEAD_POINTS 9

";

/// The status of mechanisms in which something rubs.
pub const JAMS: &str = "\
/* Friction may hold itself at the joint `name`. */
#define LINKAGE_JAMS 10

";

/// The status of mechanisms in which a group is solved by all its unknowns at once.
pub const NOT_CERTIFIED: &str = "\
/* The group was not followed so far from the drawing. */
#define LINKAGE_NOT_CERTIFIED 12

";

/// The whole header, for numbers of these widths, with what a library has beside its functions.
pub(in crate::codegen) fn text(
    signatures: &Signatures<'_>,
    widths: &[Width],
    beside: &str,
) -> String {
    let Signatures { mechanism, interface, .. } = *signatures;
    let solver = plain(&mechanism.name);
    let [stem, guard] = [snake_case(&solver), file_stem(&solver)].map(|stem| stem.to_uppercase());
    let about = about(mechanism, &solver);
    let no_solution = if mechanism.unknowns.is_empty() { "" } else { NO_SOLUTION };
    let jams = if mechanism.dynamics.frictions.is_empty() { "" } else { JAMS };
    let certified = if mechanism.tracked.is_empty() { "" } else { NOT_CERTIFIED };
    let mut header = format!(
        "{about}\n#ifndef {guard}_H\n#define {guard}_H\n\n\
         #include <stddef.h>\n#include <stdint.h>\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{SHARED}\n{no_solution}{jams}{certified}\
         #define {stem}_INPUTS {}\n#define {stem}_OUTPUTS {}\n",
        interface.columns, interface.rows,
    );
    if has_forces(interface) {
        header += &format!("\n{FORCES}");
    }
    for &width in widths {
        header += &types(mechanism, interface, width);
    }
    for &width in widths {
        header += &functions(signatures, width);
    }
    header + beside + &format!("\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {guard}_H */\n")
}

/// True if some function hands back forces.
fn has_forces(interface: &Interface) -> bool {
    let mut forces = interface.records.iter().filter(|of| of.kind == RecordKind::Forces);
    forces.any(|of| interface.is_used(of))
}

fn about(mechanism: &Mechanism, solver: &str) -> String {
    let mut lines = vec![format!("{solver}, generated from its declaration in Rust; do not edit.")];
    lines.extend(
        docs::own_lines(&docs::found_groups::all_docs(mechanism))
            .map(|line| line.trim().to_string()),
    );
    lines.extend(
        [
            "",
            "A function returns LINKAGE_OK, or why there is no answer; then what its answer would",
            "have been written to is left as it was. `error` may be null; otherwise it is written",
            "where there is no answer, and left as it was where there is one. Any other null pointer",
            "is reported. Pointers that are not null have to be valid. Nothing is allocated or kept",
            "between calls, so any number of threads may call.",
        ]
        .map(str::to_string),
    );
    comment(&lines, "")
}

/// A comment of one line or several. What would end it or begin another is taken apart, and our
/// own signs are written in ASCII.
pub(super) fn comment(lines: &[String], indent: &str) -> String {
    let mut text = lines.join(&format!("\n{indent} * ")).replace(" \n", "\n");
    for (sign, ascii) in
        [("*/", "* /"), ("/*", "/ *"), ("²", "^2"), ("³", "^3"), ("·", "*"), ("∂", "d"), ("`", "")]
    {
        text = text.replace(sign, ascii);
    }
    format!("{indent}/* {text} */\n")
}

/// A record: its comment, its name, and its fields with a type, a comment and, of a list, its dimensions.
pub(super) struct CStruct {
    about: String,
    name: String,
    fields: Vec<(String, String, String, String)>,
}

impl CStruct {
    pub(super) fn text(&self, solver: &Ident) -> String {
        let names = distinct(solver, self.fields.iter().map(|(_, name, ..)| name.clone()));
        let field = |((ty, _, about, list), name): (&(String, String, String, String), String)| {
            let about = about.trim_end_matches('.').to_string();
            format!("{}    {ty} {name}{list};\n", comment(&[about], "    "))
        };
        let fields: String = self.fields.iter().zip(names).map(field).collect();
        let (about, name) = (comment(std::slice::from_ref(&self.about), ""), &self.name);
        format!("\n{about}typedef struct {name} {{\n{fields}}} {name};\n")
    }
}

/// The types of one width.
fn types(mechanism: &Mechanism, interface: &Interface, width: Width) -> String {
    let parameters =
        (!mechanism.params.is_empty()).then(|| parameters(&mechanism.name, mechanism, width));
    let records = interface.records.iter();
    let returned = records.filter(|record| interface.is_used(record));
    let records = returned.map(|of| record(mechanism, interface, width, of));
    parameters.into_iter().chain(records).map(|record| record.text(&mechanism.name)).collect()
}

/// The record of a mechanism's parameters, under this name.
pub(super) fn parameters(name: &Ident, mechanism: &Mechanism, width: Width) -> CStruct {
    let solver = plain(name);
    let field = |param: &Param| {
        let name = plain(&param.name);
        let (ty, about) = match &param.kind {
            ParamKind::Number { dimension, default, .. } => {
                let unit = unit(*dimension, Order::Position);
                (width.in_c(), format!("In {unit}; as declared {}", default.to_f64()))
            }
            ParamKind::Mode { of, .. } => ("int32_t", of.row().in_c.to_string()),
        };
        (ty.to_string(), name, about, String::new())
    };
    CStruct {
        about: format!("The parameters of {solver}."),
        name: width.type_name(&solver),
        fields: mechanism.params.iter().map(field).collect(),
    }
}

fn record(
    mechanism: &Mechanism,
    interface: &Interface,
    width: Width,
    of: &records::Record,
) -> CStruct {
    let words = of.kind.in_words(mechanism).in_c;
    let about = words.replace('@', &mechanism.name.to_string());
    let field = |field: &Field| {
        let ty = type_of(interface, field.shape, width);
        let name = plain(&field.name);
        (ty, name, about_field(mechanism, field.subject), dimensions(field.shape))
    };
    let fields = of.fields.iter().map(field).collect();
    CStruct { about, name: width.type_name(&plain(&of.name)), fields }
}

/// The dimensions in brackets behind the name of an array.
pub(in crate::codegen) fn dimensions(shape: Shape) -> String {
    match shape {
        Shape::Matrix { rows, columns } => format!("[{rows}][{columns}]"),
        Shape::List(count) => format!("[{count}]"),
        Shape::Number | Shape::Quantity(..) | Shape::Record(_) => String::new(),
    }
}

/// The type of a field.
pub(in crate::codegen) fn type_of(interface: &Interface, shape: Shape, width: Width) -> String {
    match shape {
        Shape::Record(record) => width.type_name(&plain(&interface.record(record).name)),
        Shape::Quantity(quantity, order) => match quantity.layout(order).record {
            Some(record) => width.shared_type_name(record),
            None => width.in_c().to_string(),
        },
        Shape::Number | Shape::List(_) | Shape::Matrix { .. } => width.in_c().to_string(),
    }
}

pub(in crate::codegen) fn about_field(mechanism: &Mechanism, subject: Subject) -> String {
    match subject {
        Subject::Input(index) => {
            let unit = unit(mechanism.inputs[index].dimension, Order::Position);
            format!("In {unit}, its rates in {unit}/s and {unit}/s²")
        }
        Subject::Output(index, order) => {
            docs::describe(mechanism, &mechanism.outputs[index], order)
        }
        Subject::Outputs(Order::Position) => "In m and rad".to_string(),
        Subject::Outputs(Order::Velocity) => "In m/s and rad/s".to_string(),
        Subject::Outputs(Order::Acceleration) => "In m/s² and rad/s²".to_string(),
        Subject::Load(index) => {
            format!("In {}", unit(mechanism.dynamics.loads[index].dimension, Order::Position))
        }
        Subject::Effort(index) => force_docs::describe(mechanism, index),
        Subject::Efforts(first) => {
            format!("Forces of {}", plain(&mechanism.dynamics.asked[first].owner))
        }
        Subject::KineticEnergy | Subject::PotentialEnergy => "In J".to_string(),
        Subject::Mass => "Row by row; along a length in kg, about an angle in kg*m^2".to_string(),
        Subject::GeneralizedForce => "In N along a length, in N*m about an angle".to_string(),
    }
}

/// The functions of one width.
fn functions(signatures: &Signatures<'_>, width: Width) -> String {
    let Signatures { mechanism, interface, .. } = *signatures;
    let solver = &mechanism.name;
    let mut text = String::new();
    if !mechanism.params.is_empty() {
        let (ty, name) = (width.type_name(&plain(solver)), default(solver, width));
        let about = comment(&["The parameters as declared.".to_string()], "");
        text += &format!("\n{about}{ty} {name}(void);\n");
    }
    let entries = interface.entries.iter();
    text + &entries.map(|entry| prototype(signatures, entry, width)).collect::<String>()
}

fn prototype(signatures: &Signatures<'_>, of: &Entry, width: Width) -> String {
    let Signatures { mechanism, interface, .. } = *signatures;
    let (given, answer) = (signatures.arguments(&of.given), of.point.answer());
    let fixed = [PARAMETERS, answer, "error"];
    let names = arguments(&mechanism.name, fixed, given.names().iter().map(plain));
    let inputs = given.parts().zip(&names[3..]).map(|((_, form), name)| match form {
        Form::Record(record, _) => format!("const {} *{name}", width.type_name(&plain(record))),
        Form::Number => format!("{} {name}", width.in_c()),
        Form::List(count) => format!("const {} {name}[{count}]", width.in_c()),
    });
    let parameters = (!mechanism.params.is_empty())
        .then(|| format!("const {} *{}", width.type_name(&plain(&mechanism.name)), names[0]));
    let list: Vec<String> = parameters
        .into_iter()
        .chain(inputs)
        .chain([answer_argument(interface, of, width), "LinkageError *error".to_string()])
        .collect();
    let mut about = vec![format!("{}.", of.point.row().subject)];
    if matches!(of.result, Shape::Matrix { .. }) {
        about.push(format!("Row by row: {}.", labels::all_rows(mechanism).join(", ")));
    }
    let (about, name) = (comment(&about, ""), function(&mechanism.name, of, width));
    format!("\n{about}LinkageStatus {name}({});\n", list.join(", "))
}

/// The parameter through which C receives the answer.
fn answer_argument(interface: &Interface, of: &Entry, width: Width) -> String {
    let (name, ty) = (of.point.answer(), type_of(interface, of.result, width));
    match of.result {
        Shape::Matrix { .. } | Shape::List(_) => format!("{ty} {name}{}", dimensions(of.result)),
        Shape::Number | Shape::Quantity(..) | Shape::Record(_) => format!("{ty} *{name}"),
    }
}
