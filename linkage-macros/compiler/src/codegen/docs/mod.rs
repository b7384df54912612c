//! The documentation of the generated code: the meaning, the unit, the source and the cost of each item. The
//! user's own doc comments come first.

pub mod costs_in_words;
pub mod doc_comments;
pub(super) mod force_docs;
pub mod found_groups;
mod groups_in_words;
mod numbers_as_declared;
mod powers_of_lengths;
mod ranges_in_words;
mod searches_in_words;
mod solved_together;
mod stub_docs;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Attribute, Expr, ExprLit, Lit, Meta, MetaNameValue};

use self::doc_comments::{after, lines};
use crate::codegen::identifiers::text;
use crate::interface::entries::{ArgumentKind, Entry};
use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{Field, Record, Shape, Subject};
use crate::interface::units_in_words::{per_time, unit};
use crate::interface::{EntryId, Interface, labels};
use crate::lower::routine::Lowered;
use crate::model::mechanism::{
    DeclaredOutput, Dimension, Input, Mechanism, OutputKind, Param, ParamKind, Sign,
};
use crate::syntax::anatomy::{ModeRow, Modes};

/// The words of the user's comments, to be put behind our own.
fn quoted(own: &[Attribute]) -> String {
    let words = words(own);
    if words.is_empty() { words } else { format!(": {words}") }
}

/// The words of the user's comments in one line.
pub(super) fn words(own: &[Attribute]) -> String {
    let lines: Vec<String> = own_lines(own).collect();
    lines.iter().flat_map(|line| line.split_whitespace()).collect::<Vec<_>>().join(" ")
}

/// The user's comments line by line.
pub(super) fn own_lines(own: &[Attribute]) -> impl Iterator<Item = String> {
    own.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(MetaNameValue {
            value: Expr::Lit(ExprLit { lit: Lit::Str(line), .. }),
            ..
        }) => Some(line.value()),
        _ => None,
    })
}

/// The struct of the mechanism: the page a user lands on.
pub(super) fn solver(mechanism: &Mechanism, lowered: &Lowered<'_>) -> TokenStream {
    if mechanism.is_stub {
        return stub_docs::solver(mechanism);
    }
    let mut page = String::from(match mechanism.unknowns.is_empty() {
        true => "Solver of position, velocity and acceleration in closed form.\n",
        false => {
            "Solver of position, velocity and acceleration: in closed form, but for what is searched.\n"
        }
    });
    let section = |title: &str, items: Vec<String>| match items.is_empty() {
        true => String::new(),
        false => format!("\n# {title}\n- {}\n", items.join("\n- ")),
    };
    let inputs = mechanism.inputs.iter().map(|input| {
        let unit = unit(input.dimension, Order::Position);
        format!("`{}` in {unit}{}", text(&input.name), quoted(&input.docs))
    });
    page += &section("Inputs", inputs.collect());
    let outputs = mechanism.outputs.iter();
    page += &section(
        "Outputs",
        outputs.map(|output| describe(mechanism, output, Order::Position)).collect(),
    );
    let efforts = 0..mechanism.dynamics.asked.len();
    page +=
        &section("Forces", efforts.map(|index| force_docs::describe(mechanism, index)).collect());
    let groups = mechanism.groups.iter();
    page += &section(
        "Groups, in the order they are solved",
        groups.enumerate().map(|(index, _)| groups_in_words::in_words(mechanism, index)).collect(),
    );
    page += &section("Searches, in every call", searches_in_words::in_words(mechanism, lowered));
    let ranges = mechanism.rotatabilities.iter();
    let in_words = |found| ranges_in_words::in_words(mechanism, &lowered.interface, found);
    let ranges = ranges.map(in_words);
    let touchings = mechanism.touchings.iter().filter(|found| !found.inputs.is_empty());
    let touchings =
        touchings.map(|found| ranges_in_words::of_touching(mechanism, &lowered.interface, found));
    page += &section("Range", ranges.chain(touchings).collect());
    let costs = lowered.interface.entries.iter().zip(&lowered.costs);
    let costs = costs
        .map(|(entry, cost)| format!("`{}`: {}", entry.name(), costs_in_words::in_words(*cost)));
    page += &section("Cost of one call", costs.collect());
    after(&found_groups::all_docs(mechanism), &page)
}

pub(super) fn param(mechanism: &Mechanism, param: &Param) -> TokenStream {
    if mechanism.is_stub {
        return stub_docs::param(param);
    }
    let line = match &param.kind {
        ParamKind::Number { dimension, default, .. } => {
            let unit = unit(*dimension, Order::Position);
            format!(
                "Parameter `{}` in {unit}; as declared {}.",
                text(&param.name),
                default.to_f64()
            )
        }
        ParamKind::Mode { of, default } => mode(param, *default, *of),
    };
    after(&param.docs, &line)
}

fn mode(param: &Param, default: Sign, of: Modes) -> String {
    let ModeRow { words, type_name, .. } = of.row();
    let word = words[usize::from(default == Sign::Minus)];
    let [plus, minus] = words.map(|word| format!("`{type_name}::{}`", Modes::variant(word)));
    format!("Assembly mode `{}`, {plus} or {minus}; as declared {word}.", text(&param.name))
}

fn input(input: &Input) -> TokenStream {
    let unit = unit(input.dimension, Order::Position);
    let line =
        format!("Input `{}` in {unit}, its rates in {unit}/s and {unit}/s².", text(&input.name));
    after(&input.docs, &line)
}

pub(super) fn record(mechanism: &Mechanism, record: &Record) -> TokenStream {
    let words = record.kind.in_words(mechanism).in_rust;
    lines(&words.replace('@', &format!("[`{}`]", text(&mechanism.name))))
}

/// A field of a record.
pub(super) fn field(mechanism: &Mechanism, field: &Field) -> TokenStream {
    let of_mistakes = mechanism.is_stub.then(|| stub_docs::field(mechanism, field));
    if let Some(docs) = of_mistakes.flatten() {
        return docs;
    }
    match field.subject {
        Subject::Input(index) => input(&mechanism.inputs[index]),
        Subject::Load(index) => force_docs::load(&mechanism.dynamics.loads[index]),
        Subject::Effort(index) => force_docs::effort(mechanism, index),
        Subject::Efforts(index) => force_docs::owner(mechanism, index),
        Subject::Mass => quote! {
            /// The mass matrix, symmetric: in kg along a length, in kg·m² about an angle.
        },
        Subject::GeneralizedForce => quote! {
            /// What acts along each input, of what is applied, weight, springs and the inertia that is left
            /// without accelerations: in N along a length, in N·m about an angle.
        },
        Subject::KineticEnergy => quote! {
            /// In J: ½ m v² + ½ J ω² of every mass.
        },
        Subject::PotentialEnergy => quote! {
            /// In J: of every mass in the field of gravity, zero at the ground's origin, and of every
            /// spring, zero where it is slack.
        },
        Subject::Output(index, order) => output(mechanism, &mechanism.outputs[index], order),
        Subject::Outputs(Order::Position) => quote! {
            /// In metres and radians.
        },
        Subject::Outputs(Order::Velocity) => quote! {
            /// In m/s and rad/s.
        },
        Subject::Outputs(Order::Acceleration) => quote! {
            /// In m/s² and rad/s².
        },
    }
}

/// `COST`.
pub(super) fn cost(is_stub: bool) -> TokenStream {
    match is_stub {
        true => stub_docs::cost(),
        false => quote! {
            /// The floating-point operations of one call.
        },
    }
}

pub(super) fn rows(order: Order) -> TokenStream {
    lines(match order {
        Order::Position => {
            "The rows in the order of `OUTPUTS`; a direction's row is its angle in (−π, π]."
        }
        Order::Velocity => "The rows in the order of `OUTPUTS`; a direction's row is ω.",
        Order::Acceleration => "The rows in the order of `OUTPUTS`; a direction's row is α.",
    })
}

/// An output as a field of a record.
fn output(mechanism: &Mechanism, output: &DeclaredOutput, order: Order) -> TokenStream {
    let mut own = output.docs.clone();
    let of_thing: &[Attribute] = match output.kind {
        OutputKind::Point(point) => &mechanism.points[point.index()].docs,
        OutputKind::Link { link, .. } => &mechanism.links[link.index()].docs,
        _ => &[],
    };
    if quote!(#(#own)*).to_string() != quote!(#(#of_thing)*).to_string() {
        own.extend_from_slice(of_thing);
    }
    let line = describe(mechanism, output, order);
    after(&own, &format!("{line}."))
}

/// One output in words: what it is, what made it, its unit.
pub(super) fn describe(mechanism: &Mechanism, output: &DeclaredOutput, order: Order) -> String {
    let name = text(&output.field);
    let words = Quantity::of(&output.kind).layout(order).words;
    match &output.kind {
        OutputKind::Point(point) => {
            format!("Point `{name}` ({}): {words}", mechanism.maker(*point))
        }
        OutputKind::Link { link, .. } => {
            let made_by = mechanism.statement(mechanism.links[link.index()].made_by);
            format!("Link `{name}` ({made_by}): {words}")
        }
        OutputKind::Value { dimension, .. } | OutputKind::Ratio { dimension, .. } => {
            format!("`{name}`{words} in {}", unit(*dimension, order))
        }
        OutputKind::Angle(_) => format!("Angle `{name}`: {words}"),
        OutputKind::CentreOfMass => format!("Centre of all masses: {words}"),
        OutputKind::Pole(links) => {
            let names: Vec<_> = links.iter().map(|(_, link)| format!("`{}`", text(link))).collect();
            format!("Pole `{name}` of {}, the instant centre: {words}", names.join(" against "))
        }
        OutputKind::Margin(id) => {
            let group = mechanism.statement(*id);
            format!("Distance of {group} from its limit{words} in m{}", per_time(order))
        }
        OutputKind::Transmission(id) => {
            let (group, unit) = (mechanism.statement(*id), unit(Dimension::ANGLE, order));
            let range = if order == Order::Position { ", from 0 to π" } else { "" };
            format!("Transmission angle of {group}{words} in {unit}{range}")
        }
    }
}

/// The arguments in words, and the meaning of the list of coefficients.
fn details(mechanism: &Mechanism, interface: &Interface, entry: &Entry) -> String {
    let mut text = match (&mechanism.inputs[..], interface.input_record()) {
        ([only], _) => {
            let (name, unit) = (text(&only.name), unit(only.dimension, Order::Position));
            let given = entry.given.iter().filter_map(|given| match given {
                ArgumentKind::Cosine => {
                    Some(format!("`{name}` by its cosine and sine (any amplitude from 0.9 to 1.1)"))
                }
                ArgumentKind::Sine => None,
                ArgumentKind::Value => Some(format!("`{name}` in {unit}")),
                ArgumentKind::Rate => Some(format!("its rate in {unit}/s")),
                ArgumentKind::Acceleration => Some(format!("its acceleration in {unit}/s²")),
                ArgumentKind::Loads => None,
                ArgumentKind::Drives => Some(match &mechanism.dynamics.pull {
                    Some(load) => format!("the load `{}`, which drives it", text(&load.name)),
                    None => "the effort of its drive".to_string(),
                }),
            });
            format!("Given {}.", given.collect::<Vec<_>>().join(", "))
        }
        (_, Some(record)) => format!(
            "Every order of the inputs is an array in the order of `INPUTS` or a [`{record}`]."
        ),
        _ => String::new(),
    };
    if entry.given.contains(&ArgumentKind::Drives) && interface.input_record().is_some() {
        text += "\nThe efforts of the drives are an array in the order of `INPUTS`.";
        if let Some((input, load)) = mechanism.dynamics.driven() {
            let [input, load] = [&mechanism.inputs[input.index()].name, &load.name].map(self::text);
            text +=
                &format!(" In the place of `{input}` stands the load `{load}`, which drives it.");
        }
    }
    if entry.given.contains(&ArgumentKind::Loads) {
        text += &force_docs::loads(mechanism, interface);
    }
    if matches!(entry.result, Shape::Matrix { .. }) {
        text += "\nA row an output in the order of `OUTPUTS`, a column an input in the order of \
                 `INPUTS`; from the velocity equations.";
    }
    text
}

pub(super) fn fast_path(mechanism: &Mechanism, lowered: &Lowered<'_>, id: EntryId) -> TokenStream {
    let entry = lowered.interface.entry(id);
    if mechanism.is_stub {
        return stub_docs::entry(entry);
    }
    lines(&format!(
        "{}, {}and whether they may be used.\n\n{}\n\n\
         Where the mask says no, the numbers mean nothing. Costs {}.",
        entry.point.row().subject,
        if mechanism.unknowns.is_empty() { "without a branch, " } else { "" },
        details(mechanism, &lowered.interface, entry),
        costs_in_words::in_words(lowered.costs[id.index()]),
    ))
}

pub(super) fn checked(mechanism: &Mechanism, lowered: &Lowered<'_>, id: EntryId) -> TokenStream {
    let entry = lowered.interface.entry(id);
    if mechanism.is_stub {
        return stub_docs::entry(entry);
    }
    lines(&format!(
        "{}.\n\n{}\n\nCosts {}.\n\n# Errors\n\
         The group that cannot be assembled, is singular or was given an invalid length, or the \
         input or result that is not finite.{}{}",
        entry.point.row().subject,
        details(mechanism, &lowered.interface, entry),
        costs_in_words::in_words(lowered.costs[id.index()]),
        exceptions(&lowered.interface, entry),
        if mechanism.unknowns.is_empty() { "" } else { NO_SOLUTION }.to_string()
            + if mechanism.tracked.is_empty() { "" } else { NOT_CERTIFIED },
    ))
}

const NO_SOLUTION: &str = " `NoSolution` where an equation has no root of its mode between its ends, \
     `SeveralDeadPoints` where that is not known.";

const NOT_CERTIFIED: &str =
    " `NotCertified` beyond the stretch on which a group was followed from the drawing.";

/// The errors that only an entry point of this kind returns, or never returns.
fn exceptions(interface: &Interface, entry: &Entry) -> &'static str {
    if entry.takes_cosine() {
        return " `OffCircle` where the amplitude is no resolver's.";
    }
    entry.point.row().errors[usize::from(interface.inputs.is_some())]
}

pub(super) fn sweep(mechanism: &Mechanism, interface: &Interface, entry: &Entry) -> TokenStream {
    if mechanism.is_stub {
        return stub_docs::entry(entry);
    }
    let has_list = entry.given.contains(&ArgumentKind::Drives) && interface.inputs.is_some();
    let list =
        if has_list { " Those of an array are `(&slice).into()` or `0.0.into()`." } else { "" };
    lines(&format!(
        "{}, at many poses.\n\n{} Each is a slice with a number for every pose, or one number \
         for all.{list}\n\n\
         Every component of the results goes to a slice of its own in `out`, as many long as there \
         are poses, or empty where it is not wanted; `status` is such a slice too. Where \
         `{}` would be an error, the numbers are NaN and `status` has the error's kind. `progress` is called with \
         how many poses are done, and how many there are, every few thousand poses; `()` tells nobody.\n\n\
         # Errors\nTwo slices are not of one length; nothing was computed.",
        entry.point.row().subject,
        details(mechanism, interface, entry),
        entry.name(),
    ))
}

pub(super) fn slow_path(entry: &Entry) -> TokenStream {
    lines(&format!("Why `solve_{}` gave no answer, or the answer at a limit.", entry.name()))
}

pub(super) fn jacobian(mechanism: &Mechanism) -> TokenStream {
    let columns = mechanism.inputs.iter().map(|input| text(&input.name)).collect();
    let what = "∂outputs/∂inputs: the `coefficients` as a matrix";
    lines(&matrix(
        mechanism,
        what,
        columns,
        " A group that no coefficient depends on is not looked at.",
    ))
}

pub(super) fn sensitivity(mechanism: &Mechanism, params: &[&Param]) -> TokenStream {
    let columns = params.iter().map(|param| text(&param.name)).collect();
    let what = "∂outputs/∂params by automatic differentiation of the position";
    lines(&matrix(mechanism, what, columns, ""))
}

fn matrix(mechanism: &Mechanism, what: &str, columns: Vec<String>, beside: &str) -> String {
    let list = |names: Vec<String>| format!("`{}`", names.join("`, `"));
    let rows = labels::all_rows(mechanism);
    format!(
        "{what}.\n\nRows: {}; columns: {}.\n\n\
         # Errors\nThose of `position`; `Singular` where a derivative does not exist.{beside}",
        list(rows),
        list(columns),
    )
}
