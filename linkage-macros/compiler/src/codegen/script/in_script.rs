//! Statements in JavaScript, for the page on which a mechanism is dragged.
//!
//! Inputs and their rates are the lists `q`, `v` and `a`, parameters `p`, loads `l`, drives `e`: only locals have names,
//! all of which end in an underscore, so that none is a word of the language or one of the page's own.
//! Functions are those of the page's `kernels.js`, conditions methods of its `checks.js`, friction is solved by
//! its `friction.js`.

use crate::codegen::identifiers::CIRCLE;
use crate::codegen::printer::{Dialect, Operation, Printer};
use crate::codegen::text::Text;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::implicit::Implicit;
use crate::lower::routine::{Condition, Instruction, Solving, Threshold};
use crate::model::mechanism::Mechanism;

/// JavaScript.
pub(super) struct InScript<'a> {
    pub mechanism: &'a Mechanism,
    pub graph: &'a Graph,
    /// Names of the groups, as errors have them.
    pub groups: &'a [String],
    /// True for an entry point, whose checks know its fast path's lengths and angles.
    pub is_fast: bool,
}

impl Dialect for InScript<'_> {
    fn binding(&self) -> &str {
        "const "
    }

    fn leaf(&self, node: Node, to: &mut Text) {
        to.put(&read(node).expect("a search is given its trial by name"));
    }

    fn constant(&self, node: Node, to: &mut Text) {
        let value = match node {
            Node::Low(constant) => self.graph.value(constant).low_f64(),
            Node::Constant(constant) => self.graph.value(constant).to_f64(),
            _ => unreachable!("only constants are read as such"),
        };
        to.put(&number(value));
    }

    fn mode(&self, param: u32, to: &mut Text) {
        // The page holds +1 or −1.
        to.put(&format!("p[{param}]"));
    }

    fn function(&self, operation: Operation, to: &mut Text) {
        to.put(match operation {
            Operation::MulErr => "mulErr",
            Operation::AddErr => "addErr",
            other => other.name(),
        });
    }

    fn select(printer: &Printer<'_, Self>, [a, b, x, y]: [Id; 4], to: &mut Text) {
        printer.value(a, to.put("select("));
        printer.value(b, to.put(" >= "));
        printer.values(&[x, y], to.put(", "));
        to.put(")");
    }

    fn sin_cos(
        printer: &Printer<'_, Self>,
        angle: Id,
        pair: [Option<Id>; 2],
        is_checked: bool,
        to: &mut Text,
    ) {
        let of_checks = if is_checked && printer.dialect.is_fast { "c." } else { "" };
        printer.names(&pair, "", to.put("const ["));
        to.put("] = ").put(of_checks).put("sinCos(");
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
        let is_fast = printer.dialect.is_fast;
        to.put("const ").put(&printer.local(id));
        printer.values(&of, to.put(if is_fast { " = c.length(" } else { " = hypot(" }));
        if is_fast {
            to.put(", ").put(&match least_square {
                Threshold::SmallestSquare => "SMALLEST_SQUARE".to_string(),
                Threshold::Number(wide, _) => number(wide),
            });
        }
        to.put(");\n");
    }

    /// The diagnosis alone: nothing is fast here.
    fn condition(printer: &Printer<'_, Self>, condition: &Condition, to: &mut Text) {
        let row = condition.check.row();
        if !condition.check.is_of_both_paths() {
            to.put("const ").put(&printer.local(condition.id)).put(" = ");
        }
        to.put("c.").put(row.diagnosis).put("(");
        printer.value(condition.value, to);
        if row.reads_operands {
            condition.operands.iter().for_each(|&operand| printer.value(operand, to.put(", ")));
        }
        to.put(", ").put(&quoted(&printer.dialect.groups[condition.group as usize]));
        if let Some(word) = condition.check.word() {
            to.put(", ").put(&quoted(word));
        }
        to.put(");\n");
    }

    /// By a function of the script's object, which `script` prints, or by one of the page's `friction.js`.
    fn solve(printer: &Printer<'_, Self>, solving: &Solving, to: &mut Text) {
        printer.names(&solving.outputs, "", to.put("const ["));
        match printer.lowered.implicit(solving) {
            Implicit::Root(sought) => {
                let (_, search) = printer.lowered.search_by(solving);
                to.put("] = c.root(MACHINE.").put(&search.routine.name).put(", p, [");
                printer.values(&search.given, to);
                let mechanism = printer.dialect.mechanism;
                let unknown = &mechanism.unknowns[sought.unknown as usize];
                let unit = unit(unknown.measure, Order::Position);
                let [name, unit] = [mechanism.title_of_unknown(unknown), &unit].map(quoted);
                to.put("], ").put(&name).put(", ").put(&unit);
            }
            Implicit::Amounts(contacts) => {
                let (rows, starts) = contacts.parts();
                printer.values(starts, to.put("] = amountsOf(c, ["));
                printer.lists(rows, to.put("], ["));
                let names = list(contacts.joints.iter().map(|(joint, _)| joint));
                to.put(&format!("], {}, {names}", contacts.guides()));
                if contacts.are_found() {
                    printer.values(&solving.found(printer.dialect.graph, starts), to.put(", ["));
                    printer.values(&contacts.positive, to.put("], ["));
                    printer.lists(contacts.small.chunks(2), to.put("], ["));
                    to.put("]");
                }
            }
        }
        to.put(");\n");
    }

    /// A page asks for no clearances.
    fn tell(_: &Printer<'_, Self>, _: &[Instruction], _: &[Id], _: &mut Text) {}
}

/// The expression that reads a leaf.
pub(super) fn read(node: Node) -> Option<String> {
    Some(match node {
        Node::Param(param) => format!("p[{param}]"),
        Node::Load(load) => format!("l[{load}]"),
        Node::Drive(input) => format!("e[{input}]"),
        Node::InputCos(_) => CIRCLE[0].to_string(),
        Node::InputSin(_) => CIRCLE[1].to_string(),
        Node::Input { input, order } => format!("{}[{input}]", ["q", "v", "a"][usize::from(order)]),
        _ => return None,
    })
}

/// The shortest digits that mean the number. A negative one stands in parentheses: two signs side by side
/// are another operator.
pub(super) fn number(value: f64) -> String {
    let digits = match value.is_finite() {
        true => format!("{value:?}"),
        false => format!("{}Infinity", if value < 0.0 { "-" } else { "" }),
    };
    let digits = digits.strip_suffix(".0").map(str::to_string).unwrap_or(digits);
    if digits.starts_with('-') { format!("({digits})") } else { digits }
}

/// A string.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = "\"".to_string();
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            letter if letter < ' ' => quoted += &format!("\\u{:04x}", u32::from(letter)),
            letter => quoted.push(letter),
        }
    }
    quoted + "\""
}

/// A list of strings.
pub(super) fn list<T: AsRef<str>>(texts: impl IntoIterator<Item = T>) -> String {
    let quoted: Vec<String> = texts.into_iter().map(|text| quoted(text.as_ref())).collect();
    format!("[{}]", quoted.join(", "))
}
