//! Statements in C: conditions are comparisons on the fast path, calls of the run-time on the slow one.

use super::In;
use super::c_identifiers::snake_case;
use super::c_names::{PARAMETERS, param, quoted};
use crate::codegen::identifiers::text;
use crate::codegen::printer::{Dialect, Operation, Printer};
use crate::codegen::text::Text;
use crate::interface::entries::ArgumentKind;
use crate::ir::check::Comparison;
use crate::ir::graph::{Id, Node};
use crate::ir::implicit::{Contacts, Implicit};
use crate::lower::routine::{Condition, Instruction, Lowered, Solving, Threshold};
use crate::lower::used::{Asks, Used};

/// C of one width on one path.
pub(super) struct InC<'a> {
    pub to: In<'a>,
    pub given: &'a [ArgumentKind],
    pub asks: Asks,
    pub used: &'a Used,
    /// The words in front of a name that is bound once.
    pub binding: &'static str,
}

/// True if some of what is printed asks for amounts of friction that depend on each other.
pub(super) fn rubs(lowered: &Lowered<'_>) -> bool {
    let stages = lowered.routines.iter().flat_map(|routine| &routine.stages);
    stages.flat_map(|stage| &stage.statements).any(|statement| match statement {
        Instruction::Solve(solving) => lowered.implicit(solving).contacts().is_some(),
        _ => false,
    })
}

/// 64 roots of rounding: the permitted difference of an equation's sides, in units of their size.
const OPEN_BY: (f64, f32) = (9.5367431640625e-7, 0.022_097_087);

impl InC<'_> {
    fn threshold(&self, threshold: Threshold) -> String {
        match threshold {
            Threshold::SmallestSquare => {
                format!("linkage_smallest_square{}()", self.to.ending())
            }
            Threshold::Number(wide, narrow) => self.to.number(wide, narrow as f32),
        }
    }

    fn magnitude(&self) -> &'static str {
        if self.to.ending().is_empty() { "fabs" } else { "fabsf" }
    }

    /// A call of the run-time's function of this width.
    fn call(&self, name: &str) -> String {
        format!("linkage_{name}{}", self.to.ending())
    }
}

impl Dialect for InC<'_> {
    fn binding(&self) -> &str {
        self.binding
    }

    fn leaf(&self, node: Node, to: &mut Text) {
        let leaf = self.to.leaf(self.given, node);
        to.put(&leaf.expect("a routine reads what it is given"));
    }

    fn constant(&self, node: Node, to: &mut Text) {
        let value = |constant| self.to.lowered.program.graph.value(constant);
        to.put(&match node {
            Node::Low(low) => self.to.number(value(low).low_f64(), value(low).low_f32()),
            Node::Constant(of) => self.to.number(value(of).to_f64(), value(of).to_f32()),
            _ => unreachable!("only constants are read as such"),
        });
    }

    fn mode(&self, of: u32, to: &mut Text) {
        let mechanism = self.to.mechanism;
        let field = param(mechanism, &text(&mechanism.params[of as usize].name));
        to.put(&format!("({}){PARAMETERS}->{field}", self.to.real()));
    }

    fn function(&self, operation: Operation, to: &mut Text) {
        to.put(&self.call(operation.name()));
    }

    fn select(printer: &Printer<'_, Self>, operands: [Id; 4], to: &mut Text) {
        to.put(&printer.dialect.call("select")).put("(");
        printer.values(&operands, to);
        to.put(")");
    }

    fn sin_cos(
        printer: &Printer<'_, Self>,
        angle: Id,
        pair: [Option<Id>; 2],
        is_checked: bool,
        to: &mut Text,
    ) {
        let dialect = &printer.dialect;
        let known = pair.map(|id| id.map(|id| printer.local(id)));
        let stem = known.iter().flatten().next().expect("one is needed").clone();
        let [sin, cos] = [("sine", 0), ("cosine", 1)]
            .map(|(tail, at): (&str, usize)| known[at].clone().unwrap_or(format!("{stem}{tail}")));
        let angle = printer.value_alone(angle);
        let is_compared = is_checked && dialect.asks == Asks::Compares;
        if is_compared {
            to.put(&format!("ok &= {}({});\n", dialect.call("is_near"), angle.as_str()));
        }
        let function = dialect.call(if is_compared { "sin_cos_near" } else { "sin_cos" });
        let real = dialect.to.real();
        to.put(&format!("{real} {sin}, {cos};\n{function}({}, &{sin}, &{cos});\n", angle.as_str()));
    }

    fn length(
        printer: &Printer<'_, Self>,
        id: Id,
        of: [Id; 2],
        least_square: Threshold,
        to: &mut Text,
    ) {
        let (dialect, name, mut operands) = (&printer.dialect, printer.local(id), Text::default());
        printer.values(&of, &mut operands);
        let operands = operands.as_str();
        to.put(&match dialect.asks {
            Asks::Compares => format!(
                "{} {name};\nok &= {}({operands}, {}, &{name});\n",
                dialect.to.real(),
                dialect.call("hypot_near"),
                dialect.threshold(least_square)
            ),
            Asks::Diagnoses => {
                format!("{}{name} = {}({operands});\n", dialect.binding, dialect.call("hypot"))
            }
        });
    }

    fn condition(printer: &Printer<'_, Self>, condition: &Condition, to: &mut Text) {
        match printer.dialect.asks {
            Asks::Compares => compared(printer, condition, to),
            Asks::Diagnoses => diagnosed(printer, condition, to),
        }
    }

    fn solve(printer: &Printer<'_, Self>, solving: &Solving, to: &mut Text) {
        match printer.lowered.implicit(solving) {
            Implicit::Root(_) => printer.find(solving, to),
            Implicit::Amounts(contacts) => printer.amounts(contacts, solving, to),
        }
    }

    /// Following is not offered.
    fn tell(_: &Printer<'_, Self>, _: &[Instruction], _: &[Id], _: &mut Text) {}
}

impl Printer<'_, InC<'_>> {
    /// One call for all amounts, which hands them back in a list.
    fn amounts(&self, contacts: &Contacts, solving: &Solving, to: &mut Text) {
        let (dialect, real, count) = (&self.dialect, self.dialect.to.real(), contacts.joints.len());
        if contacts.are_found() && dialect.asks == Asks::Compares {
            return self.found(contacts, solving, to);
        }
        let first = self.local(solving.bound().next().expect("one is needed"));
        let [rows, starts, found] =
            ["rows", "starts", "found"].map(|tail: &str| format!("{first}{tail}"));
        let parts = contacts.parts();
        for (name, values) in [(&rows, &parts.0.concat()[..]), (&starts, parts.1)] {
            to.put(&format!("const {real} {name}[{}] = {{ ", values.len()));
            self.values(values, to);
            to.put(" };\n");
        }
        to.put(&format!("{real} {found}[{count}];\n"));
        let passed = format!("{count}, {}u, {rows}, {starts}, {found}", contacts.guides());
        to.put(&match dialect.asks {
            Asks::Compares => format!("ok &= {}({passed});\n", dialect.call("amounts")),
            Asks::Diagnoses => {
                let names: Vec<String> =
                    contacts.joints.iter().map(|(joint, _)| quoted(joint)).collect();
                format!(
                    "static const char *const {first}joints[{count}] = {{ {} }};\n{}(why, {first}joints, {passed});\n",
                    names.join(", "),
                    dialect.call("friction")
                )
            }
        });
        self.bind(&found, solving, to);
    }

    /// The amounts that straight-line code has found, and what shows it.
    fn found(&self, contacts: &Contacts, solving: &Solving, to: &mut Text) {
        for &value in &contacts.positive {
            to.put("ok &= ").append(&self.value_alone(value));
            to.put(&format!(" > {};\n", self.dialect.to.number(0.0, 0.0)));
        }
        for pair in contacts.small.chunks(2) {
            self.values(pair, to.put("ok &= ").put(&self.dialect.call("is_settled")).put("("));
            to.put(");\n");
        }
        for id in solving.bound().filter(|&id| self.dialect.used.reads(id)) {
            let amount = self.graph().beneath(id).expect("an amount stands on a value");
            to.put(self.dialect.binding).put(&self.local(id)).put(" = ");
            self.value(amount, to);
            to.put(";\n");
        }
    }

    /// The call of a search, whose numbers no trial changes.
    fn find(&self, solving: &Solving, to: &mut Text) {
        let (dialect, (nth, search)) = (&self.dialect, self.lowered.search_by(solving));
        let (real, mut given) = (dialect.to.real(), "NULL".to_string());
        if !search.given.is_empty() {
            given = format!("given{nth}");
            to.put(&format!("const {real} {given}[{}] = {{ ", search.given.len()));
            self.values(&search.given, to);
            to.put(" };\n");
        }
        let (name, trend) = (dialect.to.root_name(search), dialect.to.chosen_trend(search));
        let (answer, why) = match dialect.asks {
            Asks::Compares => ("ok &= ", "NULL"),
            Asks::Diagnoses => ("(void)", "why"),
        };
        to.put(&format!(
            "{real} found{nth}[2];\n{answer}{name}({why}, {trend}{given}, found{nth});\n"
        ));
        self.bind(&format!("found{nth}"), solving, to);
    }

    /// Binds what is read of a list of all that comes out.
    fn bind(&self, found: &str, solving: &Solving, to: &mut Text) {
        for (at, id) in solving.outputs.iter().enumerate() {
            if let Some(id) = id.filter(|&id| self.dialect.used.reads(id)) {
                to.put(self.dialect.binding).put(&self.local(id));
                to.put(&format!(" = {found}[{at}];\n"));
            }
        }
    }
}

fn compared(printer: &Printer<'_, InC<'_>>, condition: &Condition, to: &mut Text) {
    let dialect = &printer.dialect;
    let value = printer.value_alone(condition.value);
    let mut operand = Text::default();
    printer.operand(condition.value, &mut operand);
    let (value, operand) = (value.as_str(), operand.as_str());
    if condition.check.is_of_both_paths() {
        let [wide, narrow] = [OPEN_BY.0, f64::from(OPEN_BY.1)];
        let mut size = Text::default();
        condition.operands.iter().for_each(|&id| printer.operand(id, &mut size));
        to.put(&format!(
            "ok &= {}({value}, {} * {});\n",
            dialect.call("is_within"),
            dialect.to.number(wide, narrow as f32),
            size.as_str()
        ));
        return;
    }
    if let Some((comparison, threshold)) = condition.comparison {
        let least = dialect.threshold(threshold);
        to.put(&match comparison {
            Comparison::Above => format!("ok &= {operand} > {least};\n"),
            Comparison::AtLeast => format!("ok &= {operand} >= {least};\n"),
            Comparison::Away => format!("ok &= {}({value}) > {least};\n", dialect.magnitude()),
        });
    }
    if let Some(spread) = condition.above_rounding {
        let spread = printer.value_alone(spread);
        let rounding = dialect.call("rounding");
        to.put(&format!("ok &= {operand} > {rounding}({});\n", spread.as_str()));
    }
    if dialect.used.reads(condition.id) {
        let name = printer.local(condition.id);
        to.put(dialect.binding).put(&format!("{name} = {value};\n"));
    }
}

fn diagnosed(printer: &Printer<'_, InC<'_>>, condition: &Condition, to: &mut Text) {
    let dialect = &printer.dialect;
    let row = condition.check.row();
    let mut call = Text::default();
    call.put(&format!("linkage_{}(why, ", snake_case(row.diagnosis)));
    printer.value(condition.value, &mut call);
    if row.reads_operands {
        condition.operands.iter().for_each(|&operand| printer.value(operand, call.put(", ")));
    }
    let group = &dialect.to.lowered.program.groups[condition.group as usize];
    call.put(", ").put(&quoted(group));
    // The word of an equation is its unit, which no status tells.
    let word = condition.check.word().filter(|_| !condition.check.is_of_both_paths());
    if let Some(word) = word {
        call.put(", ").put(&quoted(word));
    }
    call.put(")");
    match dialect.used.reads(condition.id) {
        false => to.put("(void)").put(call.as_str()),
        true => {
            let cast = if dialect.to.ending().is_empty() { "" } else { "(float)" };
            let name = printer.local(condition.id);
            to.put(dialect.binding).put(&format!("{name} = {cast}{}", call.as_str()))
        }
    };
    to.put(";\n");
}
