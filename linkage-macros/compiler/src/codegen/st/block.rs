//! The function block of an entry point: what it is given, its formulas between the questions that keep them within
//! their width, and its results, zero where there are none.

use std::cell::RefCell;

use super::in_st::{BlockVariables, CIRCLE, GIVEN, InSt, MODE, is_within, unless};
use super::st_names::BlockNames;
use super::types::comment;
use super::{BlockPrinter, Plc, Refusal, indented};
use crate::codegen::arguments::Form;
use crate::codegen::c::c_identifiers::{Width, function};
use crate::codegen::identifiers::text;
use crate::codegen::text::Text;
use crate::interface::EntryId;
use crate::interface::entries::{ArgumentKind, Entry};
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::graph::{Id, Node};
use crate::ir::hash::{Map, Set};
use crate::lower::always_finite::steps;
use crate::lower::label;
use crate::lower::room::Room;
use crate::lower::routine::{
    ArgumentAdapter, Bound, Compute, FinitenessChecks, Instruction, Routine,
};
use crate::lower::used::Used;
use crate::model::mechanism::{Param, ParamKind};

/// The pins of a block: their declarations, and the names of those that formulas read.
struct Pins {
    scope: BlockNames,
    answer: String,
    /// The parameters, and the arguments in their order.
    read: Vec<String>,
    declared: String,
}

impl<'a> Plc<'a> {
    pub(super) fn block(self, id: EntryId) -> Result<String, Refusal> {
        let entry = self.interface().entry(id);
        if entry.point.is_about_forces() && !self.mechanism.dynamics.frictions.is_empty() {
            return Err(self.friction());
        }
        let pins = self.pins(entry);
        let name = self.globals.name(&function(&self.mechanism.name, entry, self.width));
        let subject = comment(entry.point.row().subject);
        let begin = format!("\n{subject}\nFUNCTION_BLOCK {name}\n{}", pins.declared);
        let body = match self.lowered.compute(id) {
            Compute::Delegate { entry: velocity, given: ArgumentAdapter::UnitRate } => {
                self.at_unit_rate(entry, *velocity, pins)
            }
            Compute::Delegate { entry: other, given: ArgumentAdapter::CosineAndSine } => {
                self.formulas(entry, *other, pins)?
            }
            Compute::Own { .. } => self.formulas(entry, id, pins)?,
        };
        Ok(format!("{begin}{body}END_FUNCTION_BLOCK\n"))
    }

    fn friction(self) -> Refusal {
        Refusal {
            why: format!("structured text prints no friction of `{}`", text(&self.mechanism.name)),
            because: "`--only motion` prints the motion, and `export c` all of it".to_string(),
        }
    }

    fn pins(self, entry: &Entry) -> Pins {
        let mut scope = BlockNames::default();
        let answer = entry.point.answer();
        let [status, refused, answer] = ["status", "refused", answer].map(|name| scope.name(name));
        let mechanism = scope.name("mechanism");
        let mut declared = "VAR_INPUT\n".to_string();
        if self.has_params() {
            let ty = self.type_name(&text(&self.mechanism.name));
            declared += &format!("    {mechanism} : {ty}; (* The parameters *)\n");
        }
        let mut read = vec![mechanism];
        for (given, (argument, form)) in
            entry.given.iter().zip(self.signatures.arguments(&entry.given).parts())
        {
            let name = scope.name(&text(argument));
            let ty = match form {
                Form::Number => self.real().to_string(),
                Form::Record(record, _) => self.type_name(&text(record)),
                Form::List(count) => format!("ARRAY[0..{}] OF {}", count - 1, self.real()),
            };
            declared += &format!("    {name} : {ty};{}\n", self.unit_of(*given));
            read.push(name);
        }
        declared += "END_VAR\nVAR_OUTPUT\n";
        let (ty, about) = (self.type_of(entry.result), self.words_of_result(entry.result));
        declared += &format!(
            "    {status} : INT; (* 0 where there is an answer *)\n    \
             {refused} : STRING; (* Whatever is to blame where there is none *)\n    \
             {answer} : {ty}; {}\nEND_VAR\n",
            comment(&about)
        );
        Pins { scope, answer, read, declared }
    }

    /// The unit of a number that is given, in a comment; several have theirs in their record.
    fn unit_of(self, given: ArgumentKind) -> String {
        let orders = match given {
            ArgumentKind::Value => Order::Position,
            ArgumentKind::Rate => Order::Velocity,
            ArgumentKind::Acceleration => Order::Acceleration,
            ArgumentKind::Cosine
            | ArgumentKind::Sine
            | ArgumentKind::Loads
            | ArgumentKind::Drives => return String::new(),
        };
        match &self.mechanism.inputs[..] {
            [only] => format!(" {}", comment(&format!("In {}", unit(only.dimension, orders)))),
            _ => String::new(),
        }
    }

    /// The velocities at a rate of one, by their own block.
    fn at_unit_rate(self, entry: &Entry, velocity: EntryId, pins: Pins) -> String {
        let Pins { mut scope, answer, read, .. } = pins;
        let velocity = self.interface().entry(velocity);
        let block = self.globals.name(&function(&self.mechanism.name, velocity, self.width));
        let [instance, rate] = ["at_unit_rate", "unit_rate"].map(|name| scope.name(name));
        let theirs = self.pins(velocity);
        let mut given: Vec<String> = read.iter().cloned().chain([rate.clone()]).collect();
        let mut formal = theirs.read.clone();
        if !self.has_params() {
            given.remove(0);
            formal.remove(0);
        }
        let given = formal.iter().zip(given).map(|(name, value)| format!("{name} := {value}"));
        let places = self.components(entry.result, &answer);
        let from = self.components(velocity.result, &format!("{instance}.{}", theirs.answer));
        let copied = places.iter().zip(from).map(|(to, from)| format!("{to} := {from};\n"));
        // Without an answer all of them are zero.
        let body = format!(
            "{instance}({});\nstatus := {instance}.status;\nrefused := {instance}.refused;\n{}",
            given.collect::<Vec<_>>().join(", "),
            copied.collect::<String>()
        );
        format!(
            "VAR CONSTANT\n    {rate} : {} := 1.0;\nEND_VAR\nVAR\n    {instance} : {block};\nEND_VAR\n{}",
            self.real(),
            indented(&body)
        )
    }

    /// The formulas of an entry point, which may be those of another one: then the angle is given, and that one takes
    /// its cosine and sine.
    fn formulas(self, entry: &Entry, own: EntryId, pins: Pins) -> Result<String, Refusal> {
        let Compute::Own { routine, stage, asked } = self.lowered.compute(own) else {
            unreachable!("an entry point that goes by another goes by one with formulas")
        };
        let formulas = self.interface().entry(own);
        let is_via_angle = formulas.takes_cosine() && !entry.takes_cosine();
        let Pins { scope, answer, mut read, .. } = pins;
        let given = read.clone();
        let mut declared = BlockVariables { scope, ..BlockVariables::default() };
        let turned =
            formulas.takes_cosine().then(|| ["a_cosine", "a_sine"].map(|name| declared.real(name)));
        if let Some(turned) = &turned {
            let count = if is_via_angle { 1 } else { 2 };
            read.splice(1..=count, turned.clone());
        }
        let sinks = &self.lowered.program.answers[own.index()].sinks;
        let routine = &self.lowered.routines[*routine];
        let used = Used::of_results(self.lowered, routine, *stage, sinks);
        let statements: Vec<Instruction> = used.stages.concat();
        let mut lines = Text::long();
        let declared = RefCell::new(declared);
        let dialect = InSt { to: self, given: &formulas.given, pins: &read, used: &used, declared };
        let block = FunctionBlock {
            to: self,
            given: &formulas.given,
            read: &read,
            asked,
            angle: is_via_angle.then_some(&given[1][..]),
        };
        if let Some(turned) = &turned {
            block.turn(&dialect, &given, turned, &mut lines);
        }
        let graph = &self.lowered.program.graph;
        let known = block.bounds(&dialect, &mut lines);
        let made = steps(graph, routine, &statements, sinks, self.room(), &known);
        let made = made.map_err(|of| self.refusal(of))?;
        let routine = named(routine, &made.named);
        let printer = BlockPrinter { lowered: self.lowered, routine: &routine, dialect };
        printer.steps(&made.steps, &mut lines);
        let places = self.components(entry.result, &answer);
        for (place, &sink) in places.iter().zip(sinks) {
            printer.value(sink, lines.put(place).put(" := "));
            lines.put(";\n");
        }
        let modes = self.modes(&printer.dialect, &read[0]);
        let body = in_body(&format!("{modes}{}", lines.as_str()), &places);
        let BlockVariables { reals, bools, constants, .. } = printer.dialect.declared.into_inner();
        let real = self.real();
        let constants =
            constants.iter().map(|(digits, name)| format!("    {name} : {real} := {digits};\n"));
        let reals = reals.iter().map(|(_, name)| format!("    {name} : {real};\n"));
        let bools = bools.iter().map(|name| format!("    {name} : BOOL;\n"));
        Ok(section("VAR CONSTANT", constants.collect())
            + &section("VAR", reals.chain(bools).collect())
            + &indented(&body))
    }

    fn room(self) -> Room {
        match self.width {
            Width::Double => Room::WIDE,
            Width::Single => Room::NARROW,
        }
    }

    /// The signs of modes: all are looked at, as they are in C.
    fn modes(self, dialect: &InSt<'_>, params: &str) -> String {
        let of = |(nth, param): (usize, &Param)| {
            let ParamKind::Mode { .. } = param.kind else { return None };
            let (name, key) = (text(&param.name), format!("mode{nth}"));
            let field = format!("{params}.{}", self.param(&name));
            let mut lines = Text::default();
            unless(&format!("({field} = 1) OR ({field} = (-1))"), (MODE, &name), &mut lines);
            let declared = dialect.declared.borrow();
            if let Some((_, local)) = declared.reals.iter().find(|(known, _)| *known == key) {
                lines.put(&format!(
                    "IF {field} = 1 THEN\n{local} := 1.0;\nELSE\n{local} := -1.0;\nEND_IF;\n"
                ));
            }
            Some(lines.into_string())
        };
        self.mechanism.params.iter().enumerate().filter_map(of).collect()
    }
}

/// The statements of a block between its status and, where there is no answer, zeros.
fn in_body(statements: &str, places: &[String]) -> String {
    let zeros: String = places.iter().map(|place| format!("{place} := 0.0;\n")).collect();
    format!(
        "status := 0;\nrefused := '';\nREPEAT\n{statements}UNTIL TRUE\nEND_REPEAT;\n\
         IF status <> 0 THEN\n{zeros}END_IF;\n"
    )
}

/// A block's declarations of one kind, if there are any.
fn section(kind: &str, lines: String) -> String {
    if lines.is_empty() { lines } else { format!("{kind}\n{lines}END_VAR\n") }
}

/// The routine with names for these values, and with none for its constants.
fn named(routine: &Routine, values: &Set<Id>) -> Routine {
    let mut locals = routine.locals.clone();
    locals.nested = locals.nested.without(values);
    Routine {
        name: routine.name.clone(),
        given: routine.given.clone(),
        result: routine.result,
        path: routine.path,
        stages: Vec::new(),
        tells: false,
        reads: Vec::new(),
        has_checks: routine.has_checks,
        locals,
        constants: Map::default(),
    }
}

/// The questions about what a block is given.
struct FunctionBlock<'a> {
    to: Plc<'a>,
    given: &'a [ArgumentKind],
    read: &'a [String],
    asked: &'a FinitenessChecks,
    /// The angle, where formulas take its cosine and sine.
    angle: Option<&'a str>,
}

impl FunctionBlock<'_> {
    /// The cosine and the sine that formulas take: of the angle, or of those that are given.
    fn turn(&self, dialect: &InSt<'_>, pins: &[String], turned: &[String; 2], to: &mut Text) {
        let ([cosine, sine], input) = (turned, text(&self.to.mechanism.inputs[0].name));
        if let Some(angle) = self.angle {
            let near = dialect.limit(self.to.room().near);
            unless(&is_within(angle, &near), (GIVEN, &input), to);
            return dialect.turned(angle, [sine, cosine], to);
        }
        let answer = dialect.answer();
        to.put(&format!(
            "{answer} := {}(cosine := {}, sine := {}, to_cosine := {cosine}, to_sine := {sine});\n",
            dialect.run_time("on_circle"),
            pins[1],
            pins[2]
        ));
        unless(&answer, (CIRCLE, &input), to);
    }

    /// The comparisons of inputs with limits, and the largest magnitudes that are known by them.
    fn bounds(&self, dialect: &InSt<'_>, to: &mut Text) -> Vec<(Id, f64)> {
        let graph = &self.to.lowered.program.graph;
        let is_turned = |node| matches!(node, Node::InputCos(_) | Node::InputSin(_));
        let turned = graph.iter().filter(|&(_, node)| is_turned(node));
        let mut known: Vec<(Id, f64)> = turned.map(|(id, _)| (id, 1.0 + 1e-6)).collect();
        let bounds = self.asked.finite.iter().filter_map(|finite| finite.instead.as_ref());
        for bound in bounds.flat_map(|(_, bounds)| bounds) {
            for (node, limit) in self.bound(dialect, bound, to) {
                known.extend(graph.iter().find(|(_, of)| *of == node).map(|(id, _)| (id, limit)));
            }
        }
        known
    }

    /// A comparison of inputs with a limit, and what each input is within.
    fn bound(&self, dialect: &InSt<'_>, bound: &Bound, to: &mut Text) -> Vec<(Node, f64)> {
        let room = self.to.room();
        let of_width = |[wide, narrow]: [f64; 2]| match self.to.width {
            Width::Double => wide,
            Width::Single => narrow,
        };
        let read =
            |node| self.to.leaf(self.given, self.read, node).expect("what is asked is given");
        let name = |node| label(self.to.mechanism, node).unwrap_or_default();
        let mut within = Vec::new();
        let mut ask = |node, limit: f64, to: &mut Text| {
            let limit = limit.min(room.given);
            let question = is_within(&read(node), &dialect.limit(limit));
            unless(&question, (GIVEN, &name(node)), to);
            within.push((node, limit));
        };
        match *bound {
            Bound::Within { value, limit } => ask(value, of_width(limit), to),
            Bound::WithRate { rate, second, limit } => {
                let limit = of_width(limit);
                // Beyond these the test fails.
                ask(rate, 1.01 * limit.sqrt(), to);
                ask(second, limit, to);
                let (left, rate_read) = (dialect.own("left"), read(rate));
                let limit = dialect.limit(limit);
                to.put(&format!("{left} := (-{rate_read}) * {rate_read} + {limit};\n"));
                unless(&is_within(&read(second), &left), (GIVEN, &name(second)), to);
            }
            Bound::OnCircle { rate, second, limit } => {
                let limit = of_width(limit);
                let (of_rate, of_second) = match second {
                    Some(_) => (limit.sqrt().sqrt(), limit.sqrt()),
                    None => (limit.sqrt(), limit),
                };
                rate.into_iter().for_each(|rate| ask(rate, 1.01 * of_rate, to));
                second.into_iter().for_each(|second| ask(second, 1.01 * of_second, to));
                let square = self.angle.map(|angle| format!("{angle} * {angle}"));
                let of_rate = rate.map(|rate| format!("{0} * {0}", read(rate)));
                let parts: Vec<String> = of_rate.into_iter().chain(square).collect();
                if parts.is_empty() {
                    return within;
                }
                let squares = dialect.own("squares");
                to.put(&format!("{squares} := {};\n", parts.join(" + ")));
                let second = second.map(|second| format!(" + {0} * {0}", read(second)));
                let sum = match second {
                    Some(second) => format!("{squares} * {squares}{second}"),
                    None => squares,
                };
                let blamed = rate.or_else(|| Some(within.first()?.0));
                let blamed =
                    blamed.map(name).unwrap_or_else(|| text(&self.to.mechanism.inputs[0].name));
                unless(&format!("{sum} <= {}", dialect.limit(limit)), (GIVEN, &blamed), to);
            }
        }
        within
    }
}
