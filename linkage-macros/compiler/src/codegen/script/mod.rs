//! The script of a page: the formulas as functions of JavaScript that return lists of numbers, and what the
//! numbers are.

mod in_script;
pub(crate) mod page;
mod plan_object;
mod printed_marks;

use self::in_script::{InScript, list, quoted, read};
use crate::codegen::docs::force_docs::unit_of;
use crate::codegen::drawn_plan::pushed;
use crate::codegen::identifiers::{CIRCLE, text};
use crate::codegen::printer::Printer;
use crate::codegen::text::Text;
use crate::interface::entries::{Analysis, ArgumentKind};
use crate::interface::quantity::{Order, Quantity, QuantityPart};
use crate::interface::records::Shape;
use crate::interface::units_in_words::unit;
use crate::interface::{force_records, labels};
use crate::ir::graph::{Node, RootSearch, Target};
use crate::lower::routine::{Compute, Lowered, Routine};
use crate::lower::{APPLIED, PLACED, TRIAL, bound_once, label};
use crate::model::acting::{Effort, RequestedEffort};
use crate::model::mechanism::{DeclaredOutput, Mechanism, OutputKind};

/// An object: where everything stands, what stands beside bodies, the outputs' motion, forces, the drives that hold the
/// mechanism, its accelerations under given drives, and names.
pub(super) fn object(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    (placing, marks): (&Lowered<'_>, Option<&Lowered<'_>>),
) -> String {
    let mut script = Text::long();
    script.put("{\nplace: (p, q) => ");
    let routine = &placing.routines[PLACED];
    let read = given(mechanism, routine.reads.iter().copied());
    function(mechanism, placing, routine, 1, &read, false, &mut script);
    script.put(", nameOfPlace),\n");
    if let Some(routine) = placing.routines.get(APPLIED) {
        let read = given(mechanism, routine.reads.iter().copied());
        script.put("applied: (p, q, v, a, l, e) => ");
        function(mechanism, placing, routine, 1, &read, false, &mut script);
        let points: Vec<String> = pushed(mechanism).map(|point| point.to_string()).collect();
        script.put(", (k) => PLAN.points[MACHINE.appliedAt[k >> 1]]),\nappliedAt: [");
        script.put(&points.join(", ")).put("],\n");
    }
    printed_marks::put(mechanism, marks, &mut script);
    [placing, lowered].iter().for_each(|lowered| searches(mechanism, lowered, &mut script));
    for analysis in Analysis::ON_PAGES {
        entry(mechanism, lowered, analysis, &mut script);
    }
    let outputs = mechanism.outputs.iter().map(output);
    let efforts = mechanism.dynamics.asked.iter().map(|asked| effort(mechanism, asked));
    for (name, objects) in [("outputs", outputs.collect()), ("efforts", efforts.collect())] {
        let objects: Vec<String> = objects;
        script.put(name).put(": [").put(&objects.join(", ")).put("],\n");
    }
    script.put("}");
    script.into_string()
}

/// The formulas of an entry point, and the names of its numbers, if the mechanism has it.
fn entry(mechanism: &Mechanism, lowered: &Lowered<'_>, analysis: Analysis, to: &mut Text) {
    let (interface, name) = (&lowered.interface, analysis.by_value().answer());
    let Some(id) = interface.find(analysis.by_value()) else { return };
    let own = match lowered.entries[id.index()] {
        Compute::Own { .. } => id,
        Compute::Delegate { entry, .. } => entry,
    };
    let Compute::Own { routine, stage, asked } = &lowered.entries[own.index()] else {
        unreachable!("an entry point that goes by another goes by one with formulas")
    };
    let mut given = given(mechanism, asked.given.iter().copied());
    if own != id {
        // The angle of the cosine and the sine is looked at first.
        given.insert(0, format!("[q[0], {}]", quoted(&text(&mechanism.inputs[0].name))));
    }
    to.put(name).put(": (p, q, v, a, l, e) => ");
    function(mechanism, lowered, &lowered.routines[*routine], stage + 1, &given, true, to);
    let names = list(labels::of_result(interface, mechanism, interface.entry(id)));
    to.put(&format!(", (k) => MACHINE.{name}Names[k]),\n{name}Names: {names},\n"));
}

/// The numbers that are read and must be finite, each with its name in errors; a cosine and a sine are.
fn given(mechanism: &Mechanism, nodes: impl Iterator<Item = Node>) -> Vec<String> {
    let is_made = |node: &Node| matches!(node, Node::InputCos(_) | Node::InputSin(_));
    let named = |node| Some(format!("[{}, {}]", read(node)?, quoted(&label(mechanism, node)?)));
    nodes.filter(|node| !is_made(node)).filter_map(named).collect()
}

/// `solved([…], (c) => { … return […]; }` of so many stages of a routine.
fn function(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    routine: &Routine,
    stages: usize,
    given: &[String],
    is_fast: bool,
    to: &mut Text,
) {
    let printer = printer(mechanism, lowered, routine, is_fast);
    to.put(&format!("solved([{}], (c) => {{\n", given.join(", ")));
    if routine.given.contains(&ArgumentKind::Cosine) {
        let [cos, sin] = CIRCLE;
        to.put(&format!("const [{sin}, {cos}] = c.sinCos(q[0]);\n"));
    }
    printer.constants(to);
    let stages = &routine.stages[..stages];
    bound_once(stages).iter().for_each(|statements| printer.statements(statements, to));
    let sinks = stages.iter().flat_map(|stage| &stage.sinks);
    to.put("return [").list(sinks, |to, &sink| printer.value(sink, to)).put("];\n}");
}

fn printer<'a>(
    mechanism: &'a Mechanism,
    lowered: &'a Lowered<'a>,
    routine: &'a Routine,
    is_fast: bool,
) -> Printer<'a, InScript<'a>> {
    let (graph, groups) = (&lowered.program.graph, &lowered.program.groups);
    Printer { lowered, routine, dialect: InScript { mechanism, graph, groups, is_fast } }
}

/// A function for every root, by the parameters and what no trial changes.
fn searches(mechanism: &Mechanism, lowered: &Lowered<'_>, to: &mut Text) {
    let sought = lowered.searches.iter().filter(|search| search.sought.wanted == Target::Root);
    for search in sought {
        let (RootSearch { between, trend, near, sides, .. }, routine) =
            (search.sought, &search.routine);
        let printer = printer(mechanism, lowered, routine, false);
        let given = search.given.iter().map(|&id| printer.local(id));
        let given = given.collect::<Vec<_>>().join(", ");
        let finder = if search.checks_span_at_run_time { "rootWithinATurn" } else { "rootOf" };
        to.put(&format!("{}: (p, [{given}]) => {finder}([", routine.name));
        printer.values(&between, to);
        let chosen = trend.param().map(|param| format!("p[{param}]"));
        let sign = trend.sign().map(|sign| sign.to_string());
        to.put("], ").put(&chosen.or(sign).unwrap_or_default());
        to.put(", ");
        match near {
            Some(near) => printer.value(near, to),
            None => _ = to.put("null"),
        }
        to.put(&format!(", ({TRIAL}) => {{\n"));
        routine.stages.iter().for_each(|stage| printer.statements(&stage.statements, to));
        printer.values(&sides, to.put("return ["));
        to.put(if search.is_steady() { "];\n}, true),\n" } else { "];\n}),\n" });
    }
}

/// An output: its name, its kind and the unit of a plain number.
fn output(output: &DeclaredOutput) -> String {
    let kind = match Quantity::of(&output.kind) {
        Quantity::Point => "point",
        Quantity::Direction => "direction",
        Quantity::SlidingDirection => "sliding",
        Quantity::Slide => "slide",
        _ => "value",
    };
    let unit = match &output.kind {
        OutputKind::Value { dimension, .. } | OutputKind::Ratio { dimension, .. } => {
            unit(*dimension, Order::Position)
        }
        OutputKind::Margin(_) => "m".to_string(),
        OutputKind::Transmission(_) => "rad".to_string(),
        _ => "1".to_string(),
    };
    // An output that is asked for as `DC.margin` is a field `DC_margin`.
    let name = text(&output.field);
    let title = match &output.kind {
        OutputKind::Margin(_) | OutputKind::Transmission(_) => name.rsplit_once('_'),
        _ => None,
    };
    let title =
        title.map(|(link, asked)| format!(", title: {}", quoted(&format!("{link}.{asked}"))));
    let ([name, unit], title) = ([name, unit].map(|text| quoted(&text)), title.unwrap_or_default());
    format!("{{name: {name}, kind: \"{kind}\", unit: {unit}{title}}}")
}

/// A force, couple or effort: its name, its rows, their units, and the point at which an arrow shows it.
fn effort(mechanism: &Mechanism, asked: &RequestedEffort) -> String {
    let (rows, units): (&[&str], Vec<String>) = match force_records::shape(asked.effort) {
        Shape::Quantity(quantity, order) => {
            let unit =
                |part: &QuantityPart| if part.field == "couple" { "N·m" } else { "N" }.to_string();
            (quantity.rows(), quantity.layout(order).parts.iter().map(unit).collect())
        }
        _ => (&[""], vec![unit_of(mechanism, asked.effort)]),
    };
    let point = match asked.effort {
        Effort::Pin(_, point) | Effort::Bearing(_, point) => point.0.to_string(),
        _ => "null".to_string(),
    };
    let name = quoted(&force_records::path(asked));
    format!("{{name: {name}, rows: {}, units: {}, point: {point}}}", list(rows), list(units))
}
