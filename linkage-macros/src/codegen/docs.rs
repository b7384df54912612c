//! What rustdoc and editors say about the generated code: what it is, its unit, what made it, what
//! it costs. The user's own doc comments come first.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Attribute, Expr, ExprLit, Lit, Meta, MetaNameValue};

use super::names::text;
use super::results::Order;
use super::units::{per_time, unit};
use super::{Context, cost, entry, rows, turning};
use crate::ir::program::{Entry, EntryKind};
use crate::model::mechanism::{Input, Output, OutputKind, Param, ParamKind, Sign};

/// The user's comments, then a paragraph of our own.
fn after(own: &[Attribute], paragraph: &str) -> TokenStream {
    let gap = (!own.is_empty()).then(|| quote!(#[doc = ""]));
    let lines = lines(paragraph);
    quote!(#(#own)* #gap #lines)
}

/// A doc attribute for every line.
fn lines(paragraph: &str) -> TokenStream {
    let attribute = |line: String| {
        let line = if line.is_empty() { line } else { format!(" {line}") };
        quote!(#[doc = #line])
    };
    paragraph.lines().flat_map(wrapped).map(attribute).collect()
}

/// The longest line of a doc comment.
const WIDTH: usize = 92;

/// The line in lines of readable length; those that continue a list's item are indented.
fn wrapped(line: &str) -> Vec<String> {
    if line.len() <= WIDTH {
        return vec![line.to_string()];
    }
    let indent = if line.starts_with("- ") { "  " } else { "" };
    let mut lines = vec![String::new()];
    for word in line.split(' ') {
        let current = lines.last_mut().expect("there is a line from the start");
        if !current.trim().is_empty() && current.chars().count() + word.chars().count() >= WIDTH {
            lines.push(format!("{indent}{word}"));
        } else {
            if !current.is_empty() {
                current.push(' ');
            }
            current.push_str(word);
        }
    }
    lines
}

/// The words of the user's comments, to be put behind our own.
fn quoted(own: &[Attribute]) -> String {
    let words = own.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(MetaNameValue {
            value: Expr::Lit(ExprLit { lit: Lit::Str(line), .. }),
            ..
        }) => Some(line.value()),
        _ => None,
    });
    let words: Vec<String> = words.flat_map(|line| words_of(&line)).collect();
    if words.is_empty() { String::new() } else { format!(": {}", words.join(" ")) }
}

fn words_of(line: &str) -> Vec<String> {
    line.split_whitespace().map(str::to_string).collect()
}

/// The struct of the mechanism: the page a user lands on.
pub(super) fn solver(cx: &Context<'_>) -> TokenStream {
    let mut page = String::from("Solver of position, velocity and acceleration in closed form.\n");
    let section = |title: &str, items: Vec<String>| match items.is_empty() {
        true => String::new(),
        false => format!("\n# {title}\n- {}\n", items.join("\n- ")),
    };
    let inputs = cx.mechanism.inputs.iter().map(|input| {
        let unit = unit(input.dimension, Order::Position);
        format!("`{}` in {unit}{}", text(&input.name), quoted(&input.docs))
    });
    page += &section("Inputs", inputs.collect());
    let outputs = cx.mechanism.outputs.iter();
    page +=
        &section("Outputs", outputs.map(|output| describe(cx, output, Order::Position)).collect());
    let groups = cx.mechanism.groups.iter();
    page += &section(
        "Groups, in the order they are solved",
        groups.map(|group| format!("{} {}", group.keyword, group.title)).collect(),
    );
    let turnings = cx.mechanism.turnings.iter();
    page += &section("Range", turnings.map(|turning| turning::in_words(cx, turning)).collect());
    let costs = cx.program.entries.iter().map(|entry| {
        format!("`{}`: {}", entry::method(entry.kind), cost::in_words(cost::of(cx, entry)))
    });
    page += &section("Cost of one call", costs.collect());
    after(&cx.mechanism.docs, &page)
}

pub(super) fn param(param: &Param) -> TokenStream {
    let line = match &param.kind {
        ParamKind::Number { dimension, default } => {
            let unit = unit(*dimension, Order::Position);
            format!(
                "Parameter `{}` in {unit}; as declared {}.",
                text(&param.name),
                default.to_f64()
            )
        }
        ParamKind::Side { default } => mode(param, *default, ["left", "right"]),
        ParamKind::Sense { default } => mode(param, *default, ["ahead", "behind"]),
    };
    after(&param.docs, &line)
}

fn mode(param: &Param, default: Sign, words: [&str; 2]) -> String {
    let word = words[usize::from(default == Sign::Minus)];
    format!("Assembly mode `{}`; as declared {word}.", text(&param.name))
}

pub(super) fn input(input: &Input) -> TokenStream {
    let unit = unit(input.dimension, Order::Position);
    let line =
        format!("Input `{}` in {unit}, its rates in {unit}/s and {unit}/s².", text(&input.name));
    after(&input.docs, &line)
}

pub(super) fn input_record(cx: &Context<'_>) -> TokenStream {
    lines(&format!("The inputs of [`{}`], or their first or second rates.", text(&cx.names.solver)))
}

/// The record of all outputs at one order.
pub(super) fn record(cx: &Context<'_>, order: Order) -> TokenStream {
    let (what, units) = match order {
        Order::Position => ("Positions", "metres and radians"),
        Order::Velocity => ("Velocities", "m/s and rad/s"),
        Order::Acceleration => ("Accelerations", "m/s² and rad/s²"),
    };
    lines(&format!("{what} of the outputs of [`{}`], in {units}.", text(&cx.names.solver)))
}

pub(super) fn motion(cx: &Context<'_>) -> TokenStream {
    let solver = text(&cx.names.solver);
    lines(&format!("Position, velocity and acceleration of the outputs of [`{solver}`]."))
}

pub(super) fn margins(cx: &Context<'_>) -> TokenStream {
    lines(&format!(
        "How far the groups of [`{}`] are from their limits, also where the pose does not exist.",
        text(&cx.names.solver)
    ))
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

/// A field of a record.
pub(super) fn output(cx: &Context<'_>, output: &Output, order: Order) -> TokenStream {
    let mut own = output.docs.clone();
    let of_thing: &[Attribute] = match output.kind {
        OutputKind::Point(point) => &cx.mechanism.points[point.index()].docs,
        OutputKind::Link { link, .. } => &cx.mechanism.links[link.index()].docs,
        _ => &[],
    };
    if quote!(#(#own)*).to_string() != quote!(#(#of_thing)*).to_string() {
        own.extend_from_slice(of_thing);
    }
    let line = describe(cx, output, order);
    after(&own, &format!("{line}."))
}

/// One output in words: what it is, what made it, its unit.
pub(super) fn describe(cx: &Context<'_>, output: &Output, order: Order) -> String {
    let (mechanism, name) = (cx.mechanism, text(&output.field));
    let group = |index: usize| {
        let group = &mechanism.groups[index];
        format!("{} {}", group.keyword, group.title)
    };
    let rate = match order {
        Order::Position => "",
        Order::Velocity => ", its rate",
        Order::Acceleration => ", its second rate",
    };
    let quantity = |unit: &str| format!("{rate} in {unit}{}", per_time(order));
    match &output.kind {
        OutputKind::Point(point) => {
            let made_by = &mechanism.points[point.index()].made_by;
            format!("Point `{name}` ({made_by}): {}", place(order))
        }
        OutputKind::Link { link, direction, slide } => {
            let made_by = group(mechanism.links[link.index()].made_by.index());
            let parts = [direction.then(|| turn(order)), slide.then(|| slid(order))];
            let parts: Vec<_> = parts.into_iter().flatten().collect();
            format!("Link `{name}` ({made_by}): {}", parts.join("; "))
        }
        OutputKind::Value { dimension, .. } => {
            format!("`{name}`{rate} in {}", unit(*dimension, order))
        }
        OutputKind::Turn(_) => format!("Angle `{name}`: {}", turn(order)),
        OutputKind::Margin(id) => {
            format!("Distance of {} from its limit{}", group(id.index()), quantity("m"))
        }
        OutputKind::Transmission(id) => {
            format!("Sine of the transmission angle of {}{rate}", group(id.index()))
        }
    }
}

fn place(order: Order) -> &'static str {
    match order {
        Order::Position => "coordinates in m",
        Order::Velocity => "velocity in m/s",
        Order::Acceleration => "acceleration in m/s²",
    }
}

fn turn(order: Order) -> &'static str {
    match order {
        Order::Position => "unit direction, counter-clockwise from +x",
        Order::Velocity => "angular velocity in rad/s, counter-clockwise",
        Order::Acceleration => "angular acceleration in rad/s², counter-clockwise",
    }
}

fn slid(order: Order) -> &'static str {
    match order {
        Order::Position => "slide along its guide in m",
        Order::Velocity => "rate of its slide in m/s",
        Order::Acceleration => "second rate of its slide in m/s²",
    }
}

/// What a function computes.
pub(super) fn subject(kind: EntryKind) -> &'static str {
    match kind {
        EntryKind::Position | EntryKind::PositionAt => "Positions of the outputs",
        EntryKind::Velocity | EntryKind::VelocityAt => "Velocities of the outputs",
        EntryKind::Motion | EntryKind::MotionAt => {
            "Positions, velocities and accelerations of the outputs"
        }
        EntryKind::Coefficients => "Kinematic coefficients ∂outputs/∂inputs",
        EntryKind::Margins => "Distances of the groups from their limits",
    }
}

/// What goes in, and what the list of coefficients means.
fn details(cx: &Context<'_>, kind: EntryKind) -> String {
    let mut text = match &cx.mechanism.inputs[..] {
        [only] => {
            let (name, unit) = (text(&only.name), unit(only.dimension, Order::Position));
            let first = match entry::takes_cosine(kind) {
                true => format!("`{name}` by its cosine and sine (any amplitude from 0.9 to 1.1)"),
                false => format!("`{name}` in {unit}"),
            };
            let rates = [format!("its rate in {unit}/s"), format!("its second rate in {unit}/s²")];
            let given: Vec<_> =
                std::iter::once(first).chain(rates).take(entry::orders(kind)).collect();
            format!("Given {}.", given.join(", "))
        }
        _ => format!(
            "Every order of the inputs is an array in the order of `INPUTS` or a [`{}`].",
            cx.names.input
        ),
    };
    if kind == EntryKind::Coefficients {
        text += "\nA row an output in the order of `OUTPUTS`, a column an input in the order of \
                 `INPUTS`; from the velocity equations.";
    }
    text
}

pub(super) fn straight(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    lines(&format!(
        "{}, without a branch, and whether they may be used.\n\n{}\n\n\
         Where the mask says no, the numbers mean nothing. Costs {}.",
        subject(entry.kind),
        details(cx, entry.kind),
        cost::in_words(cost::of(cx, entry)),
    ))
}

pub(super) fn checked(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    lines(&format!(
        "{}.\n\n{}\n\nCosts {}.\n\n# Errors\n\
         The group that cannot be assembled, is singular or was given an invalid length, or the \
         input or result that is not finite.{}",
        subject(entry.kind),
        details(cx, entry.kind),
        cost::in_words(cost::of(cx, entry)),
        exceptions(entry.kind),
    ))
}

/// What is refused, or is not, in an entry point of this kind alone.
fn exceptions(kind: EntryKind) -> &'static str {
    match kind {
        EntryKind::Coefficients => " An input that no coefficient depends on is not looked at.",
        EntryKind::Margins => {
            " A margin is there also beyond its own group's limit, but not behind another group \
             that has no pose: the error names that one, and by how much it is out of reach."
        }
        EntryKind::PositionAt | EntryKind::VelocityAt | EntryKind::MotionAt => {
            " `OffCircle` where the amplitude is no resolver's."
        }
        EntryKind::Position | EntryKind::Velocity | EntryKind::Motion => "",
    }
}

pub(super) fn sweep(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    lines(&format!(
        "{}, at many poses.\n\n{} Each is a slice with a number for every pose, or one number \
         for all.\n\n\
         Every component of the results goes to a slice of its own in `out`, as many long as there \
         are poses, or empty where it is not wanted; `status` is such a slice too. A pose that \
         `{}` refuses has numbers that are none, and its error's kind in `status`. `progress` is told the \
         poses done and their total every few thousand poses; `()` tells nobody.\n\n\
         # Errors\nTwo slices are not of one length; nothing was computed.",
        subject(entry.kind),
        details(cx, entry.kind),
        entry::method(entry.kind),
    ))
}

pub(super) fn careful(entry: &Entry) -> TokenStream {
    lines(&format!(
        "Why `solve_{}` gave no answer, or the answer at a limit.",
        entry::method(entry.kind)
    ))
}

pub(super) fn jacobian(cx: &Context<'_>) -> TokenStream {
    let columns = cx.mechanism.inputs.iter().map(|input| text(&input.name)).collect();
    lines(&matrix(cx, "∂outputs/∂inputs", columns))
}

pub(super) fn sensitivity(cx: &Context<'_>) -> TokenStream {
    let columns = cx.numeric_params().iter().map(|param| text(&param.name)).collect();
    lines(&matrix(cx, "∂outputs/∂params", columns))
}

fn matrix(cx: &Context<'_>, what: &str, columns: Vec<String>) -> String {
    let list = |names: Vec<String>| format!("`{}`", names.join("`, `"));
    let rows = cx.mechanism.outputs.iter().flat_map(rows::of).collect();
    format!(
        "{what} by automatic differentiation of the position.\n\nRows: {}; columns: {}.\n\n\
         # Errors\nThose of `position`; `Singular` where a derivative does not exist.",
        list(rows),
        list(columns),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_wrapped_and_their_words_kept() {
        let words = vec!["word"; 40].join(" ");
        let lines = wrapped(&format!("- {words}"));
        assert!(lines.iter().all(|line| line.len() <= WIDTH), "{lines:?}");
        assert!(lines[1].starts_with("  word") && lines.len() == 3, "{lines:?}");
        let text: Vec<&str> = lines.iter().flat_map(|line| line.split_whitespace()).collect();
        assert_eq!(text.join(" "), format!("- {words}"));
        assert_eq!(wrapped("short"), ["short"]);
        assert_eq!(wrapped(""), [""]);
    }
}
