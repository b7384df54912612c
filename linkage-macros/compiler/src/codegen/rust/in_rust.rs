//! Statements in Rust: conditions are calls of the checks that a function is handed, functions are those of
//! the type parameter.

use proc_macro2::{Ident, Literal};

use super::context::Context;
use crate::codegen::arguments::Arguments;
use crate::codegen::identifiers::generated;
use crate::codegen::printer::{Dialect, Operation, Printer};
use crate::codegen::text::Text;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::check::{Check, Comparison};
use crate::ir::graph::{Id, Node, RootSearch, Target};
use crate::ir::implicit::{Contacts, Implicit};
use crate::ir::liveness::Path;
use crate::lower::routine::{Condition, Instruction, Routine, Solving, Threshold};
use crate::model::mechanism::ParamKind;

/// Rust, with all that a routine's statements read.
pub(super) struct InRust<'a> {
    pub cx: &'a Context<'a>,
    pub arguments: Arguments<'a>,
    /// Whose functions compute: the type parameter.
    number: String,
}

/// The printer of one routine's statements.
pub(super) type RustPrinter<'a> = Printer<'a, InRust<'a>>;

impl<'a> RustPrinter<'a> {
    pub(super) fn new(cx: &'a Context<'a>, routine: &'a Routine) -> Self {
        let (arguments, number) = (cx.signatures.with_call_site_spans(&routine.given), cx.number());
        let dialect = InRust { cx, arguments, number: number.to_string() };
        Self { lowered: cx.lowered, routine, dialect }
    }

    /// For a function that holds all of the routine: its constants are bound first.
    pub(super) fn beginning(cx: &'a Context<'a>, routine: &'a Routine, to: &mut Text) -> Self {
        let printer = Self::new(cx, routine);
        printer.constants(to);
        printer
    }

    pub(super) fn name(&self, id: Id) -> Ident {
        generated(&self.local(id))
    }
}

impl InRust<'_> {
    fn threshold(&self, threshold: Threshold, to: &mut Text) {
        match threshold {
            Threshold::SmallestSquare => to.put(&self.number).put("::smallest_square()"),
            Threshold::Number(wide, narrow) => to.put(&self.cx.written(wide, narrow as f32)),
        };
    }

    fn scalar(&self, function: &str, to: &mut Text) {
        to.put(&self.number).put("::").put(function);
    }
}

impl Dialect for InRust<'_> {
    fn binding(&self) -> &str {
        "let "
    }

    fn leaf(&self, node: Node, to: &mut Text) {
        let leaf = self.arguments.written(node);
        to.put(&leaf.expect("a routine reads what it is given"));
    }

    fn constant(&self, node: Node, to: &mut Text) {
        to.put(&self.cx.constant(node));
    }

    fn mode(&self, param: u32, to: &mut Text) {
        let param = &self.cx.mechanism.params[param as usize];
        let ty = self.cx.paths.written(match param.kind {
            ParamKind::Mode { of, .. } => of.row().type_name,
            ParamKind::Number { .. } => unreachable!("the sign of a number is not asked for"),
        });
        // Spaces: two signs without one between are read as one operator's.
        let scalar = self.cx.names.scalar.to_string();
        to.put(&ty).put("::sign:: <").put(&scalar).put(">(self.");
        to.put(&param.name.to_string()).put(")");
    }

    fn function(&self, operation: Operation, to: &mut Text) {
        self.scalar(operation.name(), to);
    }

    fn select(printer: &Printer<'_, Self>, [a, b, x, y]: [Id; 4], to: &mut Text) {
        printer.dialect.scalar("select(", to);
        printer.dialect.scalar("ge(", to);
        printer.values(&[a, b], to);
        printer.values(&[x, y], to.put("), "));
        to.put(")");
    }

    fn sin_cos(
        printer: &Printer<'_, Self>,
        angle: Id,
        pair: [Option<Id>; 2],
        is_checked: bool,
        to: &mut Text,
    ) {
        printer.names(&pair, "_", to.put("let ("));
        match is_checked {
            true => to.put(") = checks_.sin_cos("),
            false => to.put(") = ").put(&printer.dialect.number).put("::sin_cos("),
        };
        printer.value(angle, to);
        to.put(");\n");
    }

    fn length(
        printer: &Printer<'_, Self>,
        id: Id,
        of: [Id; 2],
        least_square: Threshold,
        to: &mut Text,
    ) {
        to.put("let ").put(&printer.local(id)).put(" = checks_.hypot(");
        printer.values(&of, to);
        printer.dialect.threshold(least_square, to.put(", "));
        to.put(");\n");
    }

    /// A condition as two calls: one that compares, unless it is known to hold, and one that
    /// diagnoses, whose answer goes on in the value's place. What is compared with a spread is compared
    /// once more where limits ask for more.
    fn condition(printer: &Printer<'_, Self>, condition: &Condition, to: &mut Text) {
        let value = printer.value_alone(condition.value);
        let group = quoted(&printer.dialect.cx.program().groups[condition.group as usize]);
        let word = condition.check.word().map(quoted);
        let operands = condition.operands.iter();
        if let Check::Closed(_) = condition.check {
            to.put("checks_.closed(").append(&value);
            operands.for_each(|&operand| printer.value(operand, to.put(", ")));
            to.put(", ").put(&group);
            word.iter().for_each(|unit| {
                to.put(", ").put(unit);
            });
            to.put(");\n");
            return;
        }
        if let Some((comparison, threshold)) = condition.comparison {
            to.put("checks_.").put(match comparison {
                Comparison::Above => "above(",
                Comparison::AtLeast => "at_least(",
                Comparison::Away => "away(",
            });
            to.append(&value);
            to.put(", ");
            printer.dialect.threshold(threshold, to);
            to.put(");\n");
        }
        if let Some(spread) = condition.above_rounding {
            to.put("checks_.above_rounding(").append(&value);
            printer.value(spread, to.put(", "));
            to.put(");\n");
        }
        let diagnosis = printer.dialect.cx.paths.written(condition.check.row().diagnosis);
        to.put("let ").put(&printer.local(condition.id)).put(" = checks_.guard(").append(&value);
        to.put(", ").put(&diagnosis).put("(");
        if condition.check.row().reads_operands {
            to.put("[").list(operands, |to, &id| printer.value(id, to)).put("], ");
        }
        to.put(&group);
        word.iter().for_each(|word| {
            to.put(", ").put(word);
        });
        to.put("));\n");
    }

    fn solve(printer: &Printer<'_, Self>, solving: &Solving, to: &mut Text) {
        match printer.lowered.implicit(solving) {
            Implicit::Root(sought) => printer.find(sought, solving, to),
            Implicit::Amounts(contacts) => printer.amounts(contacts, solving, to),
        }
    }

    /// Passes the groups' clearances to the checks, and returns zeros for the result.
    fn tell(
        printer: &Printer<'_, Self>,
        statements: &[Instruction],
        clearances: &[Id],
        to: &mut Text,
    ) {
        let stages = &printer.routine.stages;
        let numbers: usize = stages.iter().map(|stage| stage.sinks.len()).sum();
        to.put(&format!("if ORDER == {} {{\n", stages.len()));
        printer.statements(statements, to);
        to.put("checks_.clearances(&[").list(clearances.chunks(2), |to, of_group| {
            to.put("[").list(of_group, |to, &id| printer.value(id, to)).put("]");
        });
        let as_array = printer.dialect.cx.paths.written("Record");
        to.put(&format!("]);\nreturn {as_array}::from_array([zero_; {numbers}]);\n}}\n"));
    }
}

impl RustPrinter<'_> {
    /// One call for all amounts: each stands in the equations of the others.
    fn amounts(&self, contacts: &Contacts, solving: &Solving, to: &mut Text) {
        let [amounts, system] =
            ["Amounts", "System"].map(|item| self.dialect.cx.paths.written(item));
        let (rows, starts) = contacts.parts();
        self.names(&solving.outputs, "_", to.put("let ["));
        if contacts.are_found() {
            self.values(
                &solving.found(self.graph(), starts),
                to.put("] = checks_.straight_amounts(["),
            );
            self.values(&contacts.positive, to.put("], ["));
            self.lists(contacts.small.chunks(2), to.put("], ["));
            to.put("], [");
        } else {
            to.put("] = checks_.amounts([");
        }
        self.values(starts, to);
        to.put("], ").put(&amounts).put(" { system: ").put(&system).put(" { rows: [");
        self.lists(rows, to);
        to.put(&format!("], guides: {} }}, joints: [", contacts.guides()));
        to.list(&contacts.joints, |to, (joint, _)| {
            to.put(&quoted(joint));
        });
        to.put("] });\n");
    }

    /// The root of an equation, found by a function of its own.
    fn find(&self, sought: &RootSearch, solving: &Solving, to: &mut Text) {
        let (cx, (_, search)) = (self.dialect.cx, self.lowered.search_by(solving));
        let mut found = Text::default();
        self.values(&search.given, found.put("self.").put(&search.routine.name).put("(["));
        let is_checked = self.routine.path != Path::Unchecked;
        found.put("]").put(&match search.apart {
            // The checks hold the seed, and are asked for it before they are told of the root.
            Some(_) if is_checked => format!(", checks_.seed({}))", sought.unknown),
            Some(_) => format!(", {}::None)", cx.paths.written("Option")),
            None => ")".to_string(),
        });
        let unknown = &cx.mechanism.unknowns[sought.unknown as usize];
        self.names(&solving.outputs, "_", to.put("let ("));
        to.put(") = ");
        if let Target::End(_) = sought.wanted {
            to.append(&found);
        } else if !is_checked {
            to.put(&cx.paths.written("open")).put("(").append(&found);
            to.put(")");
        } else {
            let unit = unit(unknown.measure, Order::Position);
            let named = [quoted(cx.mechanism.title_of_unknown(unknown)), quoted(&unit)].join(", ");
            let is_apart = search.apart.is_some();
            to.put(if is_apart { "{ let found_ = " } else { "checks_.root(" }).append(&found);
            to.put(if is_apart { "; checks_.root(found_, " } else { ", " }).put(&named);
            to.put(if is_apart { ") }" } else { ")" });
        }
        to.put(";\n");
    }
}

/// A string as code.
fn quoted(text: &str) -> String {
    Literal::string(text).to_string()
}
