//! The text of the header: the types and functions as C sees them, field for field what the
//! generated Rust lays out.

use syn::{Attribute, Expr, ExprLit, Lit, Meta};

use super::names::{Width, default, distinct, function, snake_case};
use super::{PARAMETERS, answer_name};
use crate::codegen::names::text as plain;
use crate::codegen::results::Order;
use crate::codegen::units::unit;
use crate::codegen::{Context, docs, entry};
use crate::ir::program::{Entry, EntryKind};
use crate::model::mechanism::{Output, Param, ParamKind};

/// What all headers share: status codes, modes and the records that outputs are made of.
const SHARED: &str = include_str!("linkage.h");

/// The whole header.
pub(super) fn text(cx: &Context<'_>) -> String {
    let solver = plain(&cx.names.solver);
    let guard = snake_case(&solver).to_uppercase();
    let about = about(cx, &solver);
    let mut header = format!(
        "{about}\n#ifndef {guard}_H\n#define {guard}_H\n\n\
         #include <stddef.h>\n#include <stdint.h>\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{SHARED}\n\
         #define {guard}_INPUTS {}\n#define {guard}_OUTPUTS {}\n",
        cx.columns(),
        cx.rows(),
    );
    for width in Width::ALL {
        header += &types(cx, width);
    }
    for width in Width::ALL {
        header += &functions(cx, width);
    }
    header + &format!("\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {guard}_H */\n")
}

fn about(cx: &Context<'_>, solver: &str) -> String {
    let mut lines = vec![format!("{solver}, generated from its declaration in Rust; do not edit.")];
    lines.extend(own_words(&cx.mechanism.docs));
    lines.extend(
        [
            "",
            "A function returns LINKAGE_OK, or why there is no answer; then what its answer would",
            "have been written to is left as it was. `error` may be null; otherwise it is filled in",
            "every time. Any other null pointer is reported. Pointers that are not null have to be",
            "valid. Nothing is allocated or kept between calls, so any number of threads may call.",
        ]
        .map(str::to_string),
    );
    comment(&lines, "")
}

/// The user's doc comments, line by line.
fn own_words(attributes: &[Attribute]) -> Vec<String> {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(pair) => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(line), .. }) => Some(line.value().trim().to_string()),
            _ => None,
        },
        _ => None,
    };
    attributes.iter().filter_map(line).collect()
}

/// A comment of one line or several. What would end it or begin another is taken apart, and our
/// own signs are written in ASCII.
fn comment(lines: &[String], indent: &str) -> String {
    let mut text = lines.join(&format!("\n{indent} * ")).replace(" \n", "\n");
    for (sign, ascii) in
        [("*/", "* /"), ("/*", "/ *"), ("²", "^2"), ("³", "^3"), ("·", "*"), ("∂", "d"), ("`", "")]
    {
        text = text.replace(sign, ascii);
    }
    format!("{indent}/* {text} */\n")
}

/// A record: its comment, its name, and its fields with a type and a comment each.
struct Record {
    about: String,
    name: String,
    fields: Vec<(String, String, String)>,
}

impl Record {
    fn text(&self) -> String {
        let names = distinct(self.fields.iter().map(|(_, name, _)| name.clone()));
        let field = |((ty, _, about), name): (&(String, String, String), String)| {
            let about = about.trim_end_matches('.').to_string();
            format!("{}    {ty} {name};\n", comment(&[about], "    "))
        };
        let fields: String = self.fields.iter().zip(names).map(field).collect();
        let (about, name) = (comment(std::slice::from_ref(&self.about), ""), &self.name);
        format!("\n{about}typedef struct {name} {{\n{fields}}} {name};\n")
    }
}

/// The types of one width.
fn types(cx: &Context<'_>, width: Width) -> String {
    let parameters = (!cx.mechanism.params.is_empty()).then(|| parameters(cx, width));
    let inputs = (cx.mechanism.inputs.len() > 1).then(|| inputs(cx, width));
    let orders = Order::ALL.map(|order| record(cx, width, order));
    let margins = cx.entry(EntryKind::Margins).map(|_| margins(cx, width));
    let records = parameters.into_iter().chain(inputs).chain(orders);
    let records = records.chain([motion(cx, width)]).chain(margins);
    records.map(|record| record.text()).collect()
}

fn parameters(cx: &Context<'_>, width: Width) -> Record {
    let solver = plain(&cx.names.solver);
    let field = |param: &Param| {
        let name = plain(&param.name);
        let (ty, about) = match &param.kind {
            ParamKind::Number { dimension, default } => {
                let unit = unit(*dimension, Order::Position);
                (width.in_c(), format!("In {unit}; as declared {}", default.to_f64()))
            }
            ParamKind::Side { .. } => ("int32_t", "LINKAGE_LEFT or LINKAGE_RIGHT".to_string()),
            ParamKind::Sense { .. } => ("int32_t", "LINKAGE_AHEAD or LINKAGE_BEHIND".to_string()),
        };
        (ty.to_string(), name, about)
    };
    Record {
        about: format!("The parameters of {solver}."),
        name: width.type_name(&solver),
        fields: cx.mechanism.params.iter().map(field).collect(),
    }
}

fn inputs(cx: &Context<'_>, width: Width) -> Record {
    let fields = cx.mechanism.inputs.iter().map(|input| {
        let unit = unit(input.dimension, Order::Position);
        let about = format!("In {unit}, its rates in {unit}/s and {unit}/s²");
        (width.in_c().to_string(), plain(&input.name), about)
    });
    Record {
        about: format!("The inputs of {}, or their first or second rates.", cx.names.solver),
        name: width.type_name(&plain(&cx.names.input)),
        fields: fields.collect(),
    }
}

/// The type of an output at one order.
fn output_type(output: &Output, order: Order, width: Width) -> String {
    match order.fields(output.kind.shape()).0 {
        Some(ty) => width.type_name(&format!("Linkage{ty}")),
        None => width.in_c().to_string(),
    }
}

fn record(cx: &Context<'_>, width: Width, order: Order) -> Record {
    let (what, name) = match order {
        Order::Position => ("Positions", &cx.names.position),
        Order::Velocity => ("Velocities", &cx.names.velocity),
        Order::Acceleration => ("Accelerations", &cx.names.acceleration),
    };
    let field = |output: &Output| {
        let ty = output_type(output, order, width);
        (ty, plain(&output.field), docs::describe(cx, output, order))
    };
    Record {
        about: format!("{what} of the outputs."),
        name: width.type_name(&plain(name)),
        fields: cx.mechanism.outputs.iter().map(field).collect(),
    }
}

fn motion(cx: &Context<'_>, width: Width) -> Record {
    let names = [&cx.names.position, &cx.names.velocity, &cx.names.acceleration];
    let fields = [
        ("position", "In m and rad"),
        ("velocity", "In m/s and rad/s"),
        ("acceleration", "In m/s² and rad/s²"),
    ];
    let fields = names.into_iter().zip(fields).map(|(name, (field, about))| {
        (width.type_name(&plain(name)), field.to_string(), about.to_string())
    });
    Record {
        about: "Position, velocity and acceleration of the outputs.".to_string(),
        name: width.type_name(&plain(&cx.names.motion)),
        fields: fields.collect(),
    }
}

fn margins(cx: &Context<'_>, width: Width) -> Record {
    let field = |output: &Output| {
        let ty = output_type(output, Order::Position, width);
        (ty, plain(&output.field), docs::describe(cx, output, Order::Position))
    };
    let outputs = cx.mechanism.outputs.iter().filter(|output| output.is_margin());
    Record {
        about: "Distances of the groups from their limits.".to_string(),
        name: width.type_name(&plain(&cx.names.margins)),
        fields: outputs.map(field).collect(),
    }
}

/// The functions of one width.
fn functions(cx: &Context<'_>, width: Width) -> String {
    let solver = &cx.names.solver;
    let mut text = String::new();
    if !cx.mechanism.params.is_empty() {
        let (ty, name) = (width.type_name(&plain(solver)), default(solver, width));
        let about = comment(&["The parameters as declared.".to_string()], "");
        text += &format!("\n{about}{ty} {name}(void);\n");
    }
    text + &cx.program.entries.iter().map(|entry| prototype(cx, entry, width)).collect::<String>()
}

fn prototype(cx: &Context<'_>, of: &Entry, width: Width) -> String {
    let (arguments, answer) = (cx.arguments(of.kind), answer_name(of.kind));
    // The inputs come last here, so that they give way to the names that are always there.
    let fixed = [PARAMETERS, answer, "error"].map(str::to_string);
    let names = distinct(fixed.into_iter().chain(arguments.names().iter().map(plain)));
    let ty = match arguments.are_records() {
        true => format!("const {} *", width.type_name(&plain(&cx.names.input))),
        false => format!("{} ", width.in_c()),
    };
    let parameters = (!cx.mechanism.params.is_empty())
        .then(|| format!("const {} *{}", width.type_name(&plain(&cx.names.solver)), names[0]));
    let inputs = names[3..].iter().map(|name| format!("{ty}{name}"));
    let list: Vec<String> = parameters
        .into_iter()
        .chain(inputs)
        .chain([answer_argument(cx, of.kind, width), "LinkageError *error".to_string()])
        .collect();
    let mut about = vec![format!("{}.", docs::subject(of.kind))];
    if of.kind == EntryKind::Coefficients {
        about.push(format!("Row by row: {}.", crate::codegen::rows::names(cx).join(", ")));
    }
    let (about, name) = (comment(&about, ""), function(&cx.names.solver, of.kind, width));
    format!("\n{about}LinkageStatus {name}({});\n", list.join(", "))
}

/// Where the answer goes.
fn answer_argument(cx: &Context<'_>, kind: EntryKind, width: Width) -> String {
    let name = answer_name(kind);
    match entry::record(cx, kind) {
        Some(record) => format!("{} *{name}", width.type_name(&plain(record))),
        None => format!("{} {name}[{}][{}]", width.in_c(), cx.rows(), cx.columns()),
    }
}
