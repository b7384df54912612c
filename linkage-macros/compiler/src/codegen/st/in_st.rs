//! Statements in structured text. A condition ends the block where it does not hold, so that nothing is divided by zero
//! and no root is taken of what has none.
//!
//! A number that is no zero is a constant with a type, since literals have none on which all controllers agree. Standard
//! functions have an operand in parentheses: a name alone is read as that of a formal operand by some.

use std::cell::RefCell;

use super::Plc;
use super::st_names::{BlockNames, quoted};
use crate::codegen::c::c_identifiers::Width;
use crate::codegen::printer::{Dialect, Operation, Printer};
use crate::codegen::text::Text;
use crate::function::Function;
use crate::interface::entries::ArgumentKind;
use crate::ir::check::Comparison;
use crate::ir::graph::{Id, Node};
use crate::lower::always_finite::{FiniteStep, SizeCheck};
use crate::lower::routine::{Condition, Instruction, Solving, Threshold, is_leaf, label};
use crate::lower::used::Used;

/// The statuses beside the numbers of groups.
pub(super) const GIVEN: i32 = -1;
pub(super) const MODE: i32 = -2;
pub(super) const SIZE: i32 = -3;
pub(super) const CIRCLE: i32 = -4;

/// The status where a value on the way is too large.
const ON_THE_WAY: &str = "a value on the way";

/// Structured text of one width.
pub(super) struct InSt<'a> {
    pub to: Plc<'a>,
    pub given: &'a [ArgumentKind],
    /// The names of the pins that leaves are read from, and that of the parameters.
    pub pins: &'a [String],
    pub used: &'a Used,
    pub declared: RefCell<BlockVariables>,
}

/// The variables and constants that are written into statements, and have to be declared.
#[derive(Default)]
pub(super) struct BlockVariables {
    pub scope: BlockNames,
    /// By the name of the local.
    pub reals: Vec<(String, String)>,
    pub bools: Vec<String>,
    /// By the digits.
    pub constants: Vec<(String, String)>,
}

impl BlockVariables {
    /// A variable of this purpose.
    pub(super) fn real(&mut self, local: &str) -> String {
        if let Some((_, name)) = self.reals.iter().find(|(known, _)| known == local) {
            return name.clone();
        }
        let name = self.scope.name(local);
        self.reals.push((local.to_string(), name.clone()));
        name
    }

    fn constant(&mut self, digits: String) -> String {
        if let Some((_, name)) = self.constants.iter().find(|(known, _)| *known == digits) {
            return name.clone();
        }
        let name = self.scope.name(&format!("k{}", self.constants.len() + 1));
        self.constants.push((digits, name.clone()));
        name
    }
}

impl InSt<'_> {
    /// The constant of a number; zero is a literal.
    pub(super) fn number(&self, wide: f64, narrow: f32) -> String {
        let digits = self.to.digits(wide, narrow);
        if digits == "0.0" {
            return digits;
        }
        self.declared.borrow_mut().constant(digits)
    }

    /// A limit of this width.
    pub(super) fn limit(&self, limit: f64) -> String {
        self.number(limit, limit as f32)
    }

    fn threshold(&self, threshold: Threshold) -> String {
        match threshold {
            Threshold::SmallestSquare => {
                let wide = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);
                self.number(wide, f32::MIN_POSITIVE / (f32::EPSILON * f32::EPSILON))
            }
            Threshold::Number(wide, narrow) => self.number(wide, narrow as f32),
        }
    }

    /// A variable beside the locals.
    pub(super) fn own(&self, name: &str) -> String {
        self.declared.borrow_mut().real(name)
    }

    /// A variable for what a function says beside its numbers.
    pub(super) fn answer(&self) -> String {
        let mut declared = self.declared.borrow_mut();
        if declared.bools.is_empty() {
            let name = declared.scope.name("is_done");
            declared.bools.push(name);
        }
        declared.bools[0].clone()
    }

    /// The name of a function of the run-time of this width.
    pub(super) fn run_time(&self, name: &str) -> String {
        format!("linkage_{name}{}", self.to.ending())
    }

    fn refused_as(&self, group: u32) -> (i32, &str) {
        // Groups are counted from one.
        (group as i32 + 1, &self.to.lowered.program.groups[group as usize])
    }
}

/// Ends the block with a status and a name unless a condition holds.
pub(super) fn unless(condition: &str, (status, name): (i32, &str), to: &mut Text) {
    to.put(&format!(
        "IF NOT ({condition}) THEN\nstatus := {status};\nrefused := {};\nEXIT;\nEND_IF;\n",
        quoted(name)
    ));
}

/// |value| ≤ limit, without a function. Both sides are computed by many controllers, and either may be.
pub(super) fn is_within(value: &str, limit: &str) -> String {
    format!("({value} <= {limit}) AND ({value} >= (-{limit}))")
}

impl Dialect for InSt<'_> {
    const ASSIGN: &'static str = " := ";
    const SIGNS_STAND_APART: bool = true;

    fn binding(&self) -> &str {
        ""
    }

    fn local(&self, name: String) -> String {
        self.declared.borrow_mut().real(&name)
    }

    fn leaf(&self, node: Node, to: &mut Text) {
        to.put(&self.to.leaf(self.given, self.pins, node).expect("a block reads what it is given"));
    }

    fn constant(&self, node: Node, to: &mut Text) {
        let value = |constant| self.to.lowered.program.graph.value(constant);
        to.put(&match node {
            Node::Low(low) => self.number(value(low).low_f64(), value(low).low_f32()),
            Node::Constant(of) => self.number(value(of).to_f64(), value(of).to_f32()),
            _ => unreachable!("only constants are read as such"),
        });
    }

    /// The local into which a block's first statements put the sign.
    fn mode(&self, of: u32, to: &mut Text) {
        to.put(&self.own(&format!("mode{of}")));
    }

    fn function(&self, operation: Operation, to: &mut Text) {
        to.put(&match operation {
            Operation::Of(Function::Sqrt) => "SQRT".to_string(),
            Operation::Of(Function::Tan) => "TAN".to_string(),
            Operation::Of(Function::Exp) => "EXP".to_string(),
            Operation::Of(Function::Ln) => "LN".to_string(),
            Operation::Of(Function::Pow) => "EXPT".to_string(),
            other => self.run_time(other.name()),
        });
    }

    fn call(printer: &Printer<'_, Self>, operation: Operation, operands: &[Id], to: &mut Text) {
        let formal: &[&str] = match operation {
            Operation::Fused => return fused(printer, operands, to),
            Operation::Of(Function::Atan2) => &["y", "x"],
            Operation::Of(Function::Asin | Function::Acos | Function::Atan) => &["x"],
            Operation::Of(_) => &[],
            Operation::Det | Operation::MulErr | Operation::AddErr => &["a", "b", "c", "d"],
        };
        printer.dialect.function(operation, to);
        to.put("(").list(operands.iter().enumerate(), |to, (nth, &operand)| {
            match formal.get(nth) {
                Some(name) => printer.value(operand, to.put(name).put(" := ")),
                None => {
                    printer.value(operand, to.put("("));
                    to.put(")");
                }
            };
        });
        to.put(")");
    }

    fn select(printer: &Printer<'_, Self>, operands: [Id; 4], to: &mut Text) {
        to.put(&printer.dialect.run_time("chosen")).put("(");
        to.list(["a", "b", "x", "y"].into_iter().zip(operands), |to, (name, operand)| {
            printer.value(operand, to.put(name).put(" := "));
        });
        to.put(")");
    }

    fn sin_cos(
        printer: &Printer<'_, Self>,
        angle: Id,
        pair: [Option<Id>; 2],
        _: bool,
        to: &mut Text,
    ) {
        let dialect = &printer.dialect;
        let known = pair.map(|id| id.map(|id| printer.local(id)));
        let other = ["a_sine", "a_cosine"];
        let [sine, cosine] =
            [0, 1].map(|at| known[at].clone().unwrap_or_else(|| dialect.own(other[at])));
        let angle = printer.value_alone(angle);
        dialect.turned(angle.as_str(), [&sine, &cosine], to);
    }

    fn length(
        printer: &Printer<'_, Self>,
        id: Id,
        [x, y]: [Id; 2],
        least_square: Threshold,
        to: &mut Text,
    ) {
        let dialect = &printer.dialect;
        let square = dialect.own("square");
        let mut legs = [x, y].map(|leg| {
            let mut text = Text::default();
            printer.operand(leg, &mut text);
            text.into_string()
        });
        let [x, y] = &mut legs;
        to.put(&format!("{square} := {x} * {x} + {y} * {y};\n"));
        let least = dialect.threshold(least_square);
        // A hypotenuse is no group's.
        unless(&format!("{square} >= {least}"), (SIZE, ON_THE_WAY), to);
        to.put(&format!("{} := SQRT(({square}));\n", printer.local(id)));
    }

    fn condition(printer: &Printer<'_, Self>, condition: &Condition, to: &mut Text) {
        let dialect = &printer.dialect;
        let refused = dialect.refused_as(condition.group);
        let mut operand = Text::default();
        printer.operand(condition.value, &mut operand);
        let value = operand.as_str();
        if let Some((comparison, threshold)) = condition.comparison {
            let least = dialect.threshold(threshold);
            let question = match comparison {
                Comparison::Above => format!("{value} > {least}"),
                Comparison::AtLeast => format!("{value} >= {least}"),
                Comparison::Away if least == "0.0" => format!("{value} <> {least}"),
                Comparison::Away => format!("({value} > {least}) OR ({value} < (-{least}))"),
            };
            unless(&question, refused, to);
        }
        if let Some(spread) = condition.above_rounding {
            let rounding = dialect.number(16.0 * f64::EPSILON, 16.0 * f32::EPSILON);
            let mut spread_text = Text::default();
            printer.operand(spread, &mut spread_text);
            unless(&format!("{value} > {rounding} * {}", spread_text.as_str()), refused, to);
        }
        if dialect.used.reads(condition.id) {
            let name = printer.local(condition.id);
            to.put(&format!("{name} := {};\n", printer.value_alone(condition.value).as_str()));
        }
    }

    fn solve(_: &Printer<'_, Self>, _: &Solving, _: &mut Text) {
        unreachable!("no block is printed of what is solved for")
    }

    /// Following is not offered.
    fn tell(_: &Printer<'_, Self>, _: &[Instruction], _: &[Id], _: &mut Text) {}
}

/// ab + c, rounded twice.
fn fused(printer: &Printer<'_, InSt<'_>>, operands: &[Id], to: &mut Text) {
    let [a, b, c] = operands else { unreachable!("a product and a sum have three operands") };
    printer.operand(*a, to);
    printer.operand(*b, to.put(" * "));
    printer.operand(*c, to.put(" + "));
}

impl InSt<'_> {
    /// The sine and the cosine of an angle that is near.
    pub(super) fn turned(&self, angle: &str, [sine, cosine]: [&str; 2], to: &mut Text) {
        to.put(&match self.to.by_controller {
            true => format!("{sine} := SIN(({angle}));\n{cosine} := COS(({angle}));\n"),
            false => format!(
                "{} := {}(x := {angle}, to_sine := {sine}, to_cosine := {cosine});\n",
                self.answer(),
                self.run_time("sin_cos")
            ),
        });
    }
}

impl Printer<'_, InSt<'_>> {
    /// Statements, and the questions in front of them: those about values that have no name of the user's in one.
    pub(super) fn steps(&self, steps: &[FiniteStep], to: &mut Text) {
        let mut questions: Vec<String> = Vec::new();
        for step in steps {
            match step {
                FiniteStep::Ask(check) => match self.of_a_leaf(*check) {
                    Some(name) => unless(&self.question(*check), (GIVEN, &name), to),
                    None => questions.push(self.question(*check)),
                },
                FiniteStep::Do(statement) => {
                    self.all(&mut questions, to);
                    self.statements(std::slice::from_ref(statement), to);
                }
            }
        }
        self.all(&mut questions, to);
    }

    fn all(&self, questions: &mut Vec<String>, to: &mut Text) {
        if !questions.is_empty() {
            let together = match &questions[..] {
                [only] => only.clone(),
                several => format!("({})", several.join(") AND\n    (")),
            };
            unless(&together, (SIZE, ON_THE_WAY), to);
            questions.clear();
        }
    }

    /// The name of what is given, where that is asked.
    fn of_a_leaf(&self, check: SizeCheck) -> Option<String> {
        let (SizeCheck::AtMost(id, _) | SizeCheck::AtLeast(id, _) | SizeCheck::Away(id, _)) = check
        else {
            return None;
        };
        let node = self.graph().node(id);
        if is_leaf(node) { label(self.dialect.to.mechanism, node) } else { None }
    }

    fn question(&self, check: SizeCheck) -> String {
        let limit = |limit| self.dialect.limit(limit);
        let read = |id: Id| {
            let mut text = Text::default();
            self.operand(id, &mut text);
            text.into_string()
        };
        match check {
            SizeCheck::AtMost(id, most) => is_within(&read(id), &limit(most)),
            SizeCheck::AtLeast(id, least) => format!("{} >= {}", read(id), limit(least)),
            SizeCheck::Away(id, least) => {
                let (value, least) = (read(id), limit(least));
                format!("({value} >= {least}) OR ({value} <= (-{least}))")
            }
            SizeCheck::Quotient([a, b], share) => {
                format!("{} * ABS(({})) < ABS(({}))", limit(share), read(a), read(b))
            }
        }
    }
}

impl Plc<'_> {
    /// The digits of a number of this width, with a point.
    pub(super) fn digits(&self, wide: f64, narrow: f32) -> String {
        let digits = match self.width {
            Width::Double => format!("{wide:?}"),
            Width::Single => format!("{narrow:?}"),
        };
        let Some((mantissa, exponent)) = digits.split_once('e') else { return digits };
        let point = if mantissa.contains('.') { "" } else { ".0" };
        format!("{mantissa}{point}E{exponent}")
    }
}
