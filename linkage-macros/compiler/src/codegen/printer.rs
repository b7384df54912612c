//! The statements of a routine, printed by one walk in every language.
//!
//! The printer knows the order of statements, where a value is written and where a name, and when an
//! expression needs parentheses. A [`Dialect`] knows the words of one language.

use super::text::Text;
use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};
use crate::lower::routine::{
    Condition, Instruction, Lowered, Reading, Routine, Solving, Sum, Threshold,
};

/// A language that routines are printed in. Infix operators and their precedence are those that
/// Rust, C and JavaScript share, and so is the call of a function.
pub(super) trait Dialect: Sized {
    /// The sign between a name and its value.
    const ASSIGN: &'static str = " = ";

    /// True if no two signs may stand side by side, and a product is added by signs.
    const SIGNS_STAND_APART: bool = false;

    /// Words in front of a name that is bound once.
    fn binding(&self) -> &str;

    /// Expression that reads an input, a parameter, a load or a drive.
    fn leaf(&self, node: Node, to: &mut Text);

    /// A constant of the graph.
    fn constant(&self, node: Node, to: &mut Text);

    /// The sign of a mode that is chosen at run time.
    fn mode(&self, param: u32, to: &mut Text);

    /// Name of the function that computes an operation.
    fn function(&self, operation: Operation, to: &mut Text);

    /// The name of a local, where the language allows not every one.
    fn local(&self, name: String) -> String {
        name
    }

    /// An operation as the call of its function.
    fn call(printer: &Printer<'_, Self>, operation: Operation, operands: &[Id], to: &mut Text) {
        printer.dialect.function(operation, to);
        printer.values(operands, to.put("("));
        to.put(")");
    }

    /// `x` where a ≥ b, otherwise `y`.
    fn select(printer: &Printer<'_, Self>, operands: [Id; 4], to: &mut Text);

    /// Binds the sine and the cosine of an angle, of which one may be needed nowhere.
    fn sin_cos(
        printer: &Printer<'_, Self>,
        angle: Id,
        pair: [Option<Id>; 2],
        is_checked: bool,
        to: &mut Text,
    );

    /// Binds a hypotenuse, and asks that its square is not below the threshold.
    fn length(
        printer: &Printer<'_, Self>,
        id: Id,
        of: [Id; 2],
        least_square: Threshold,
        to: &mut Text,
    );

    /// Asks a condition, and binds what goes on in its value's place.
    fn condition(printer: &Printer<'_, Self>, condition: &Condition, to: &mut Text);

    /// Solves equations, and binds what comes out and goes on.
    fn solve(printer: &Printer<'_, Self>, solving: &Solving, to: &mut Text);

    /// Ends the routine where clearances are asked for, values and scales in turn.
    fn tell(
        printer: &Printer<'_, Self>,
        statements: &[Instruction],
        clearances: &[Id],
        to: &mut Text,
    );
}

/// An operation that is a call in every language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    Of(Function),
    /// ad − bc of (a, b, c, d), with the rounding of its products put right.
    Det,
    /// The rounding of a product.
    MulErr,
    /// The rounding of a sum.
    AddErr,
    /// ab + c.
    Fused,
}

impl Operation {
    /// Name of its function, where a language needs no other.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Of(function) => function.name(),
            Self::Det => "det",
            Self::MulErr => "mul_err",
            Self::AddErr => "add_err",
            Self::Fused => "fused",
        }
    }
}

/// A routine and the language that it is printed in.
pub(super) struct Printer<'a, D> {
    pub lowered: &'a Lowered<'a>,
    pub routine: &'a Routine,
    pub dialect: D,
}

impl<'a, D: Dialect> Printer<'a, D> {
    /// Binds the constants that the routine reads more than once.
    pub(super) fn constants(&self, to: &mut Text) {
        for (constant, name) in self.routine.constants.iter() {
            to.put(self.dialect.binding()).put(name).put(D::ASSIGN);
            self.dialect.constant(*constant, to);
            to.put(";\n");
        }
    }

    pub(super) fn statements(&self, statements: &[Instruction], to: &mut Text) {
        statements.iter().for_each(|statement| self.statement(statement, to));
    }

    fn statement(&self, statement: &Instruction, to: &mut Text) {
        match statement {
            Instruction::Let(id) => {
                to.put(self.dialect.binding()).put(&self.local(*id)).put(D::ASSIGN);
                self.expression(self.node(*id), to);
                to.put(";\n");
            }
            Instruction::SinCos { angle, sin, cos, is_checked } => {
                D::sin_cos(self, *angle, [*sin, *cos], *is_checked, to);
            }
            Instruction::Length { id, least_square } => {
                let Node::Apply2(_, x, y) = self.node(*id) else { unreachable!("it is one") };
                D::length(self, *id, [x, y], *least_square, to);
            }
            Instruction::Check(condition) => D::condition(self, condition, to),
            Instruction::Solve(solving) => D::solve(self, solving, to),
            Instruction::ReportClearances { statements, clearances } => {
                D::tell(self, statements, clearances, to);
            }
        }
    }

    pub(super) fn graph(&self) -> &'a Graph {
        &self.lowered.program.graph
    }

    /// Name of a value that a statement binds.
    pub(super) fn local(&self, id: Id) -> String {
        self.dialect.local(self.routine.locals.name(id))
    }

    fn node(&self, id: Id) -> Node {
        self.graph().node(id)
    }

    /// Writes the expression that reads a node's value.
    pub(super) fn value(&self, id: Id, to: &mut Text) {
        self.read(&self.routine.reading(self.graph(), id), to);
    }

    /// Writes the same for several nodes, with commas between.
    pub(super) fn values(&self, ids: &[Id], to: &mut Text) {
        to.list(ids, |to, &id| self.value(id, to));
    }

    /// Writes several of these, each in brackets.
    pub(super) fn lists<'i>(&self, lists: impl IntoIterator<Item = &'i [Id]>, to: &mut Text) {
        to.list(lists, |to, list| {
            self.values(list, to.put("["));
            to.put("]");
        });
    }

    /// Writes the names of what is bound at once, another one in the place of what is not.
    pub(super) fn names(&self, ids: &[Option<Id>], other: &str, to: &mut Text) {
        to.list(ids, |to, id| {
            to.put(&id.map_or(other.to_string(), |id| self.local(id)));
        });
    }

    /// The expression alone.
    pub(super) fn value_alone(&self, id: Id) -> Text {
        let mut text = Text::default();
        self.value(id, &mut text);
        text
    }

    fn read(&self, reading: &Reading, to: &mut Text) {
        match reading {
            Reading::Leaf(node) => self.dialect.leaf(*node, to),
            Reading::Constant(node) => match self.routine.constants.get(node) {
                Some(name) => {
                    to.put(name);
                }
                None => self.dialect.constant(*node, to),
            },
            Reading::Negated(inner) => self.read_operand(inner, to.put("-")),
            Reading::Local(id) => {
                to.put(&self.local(*id));
            }
            Reading::Nested(id) => self.expression(self.node(*id), to),
        }
    }

    /// The same behind a sign or beside one.
    fn read_operand(&self, reading: &Reading, to: &mut Text) {
        let is_infix = |id: Id| {
            let node = self.node(id);
            matches!(node, Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Div(..))
                || D::SIGNS_STAND_APART && matches!(node, Node::Fused(..) | Node::Neg(_))
        };
        let is_apart = match reading {
            Reading::Nested(id) => is_infix(*id),
            Reading::Negated(_) => D::SIGNS_STAND_APART,
            Reading::Leaf(_) | Reading::Constant(_) | Reading::Local(_) => false,
        };
        match is_apart {
            true => {
                self.read(reading, to.put("("));
                to.put(")");
            }
            false => self.read(reading, to),
        }
    }

    /// Writes a value that stands beside a sign.
    pub(super) fn operand(&self, id: Id, to: &mut Text) {
        self.read_operand(&self.routine.reading(self.graph(), id), to);
    }

    fn expression(&self, node: Node, to: &mut Text) {
        match node {
            Node::Neg(a) => self.operand(a, to.put("-")),
            Node::Add(a, b) => self.infix(a, " + ", b, to),
            Node::Sub(a, b) => self.infix(a, " - ", b, to),
            Node::Mul(a, b) => self.infix(a, " * ", b, to),
            Node::Div(a, b) => self.infix(a, " / ", b, to),
            Node::Apply(function, a) => self.call(Operation::Of(function), &[a], to),
            Node::Apply2(function, a, b) => self.call(Operation::Of(function), &[a, b], to),
            Node::Det(operands) => self.call(Operation::Det, &operands, to),
            Node::Select(operands) => D::select(self, operands, to),
            Node::MulErr(a, b) => self.call(Operation::MulErr, &[a, b], to),
            Node::AddErr(a, b) => self.call(Operation::AddErr, &[a, b], to),
            Node::Fused(a, b, c) => self.call(Operation::Fused, &[a, b, c], to),
            Node::Mode(param) => self.dialect.mode(param, to),
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_)
            | Node::Trial(_)
            | Node::Solved(..)
            | Node::Guard(..) => unreachable!("read in place, or a statement of its own kind"),
        }
    }

    fn infix(&self, a: Id, sign: &str, b: Id, to: &mut Text) {
        self.operand(a, to);
        self.operand(b, to.put(sign));
    }

    fn call(&self, operation: Operation, operands: &[Id], to: &mut Text) {
        D::call(self, operation, operands, to);
    }
}

/// A sum of components.
pub(super) fn sum(of: &Sum, components: &[String]) -> String {
    let term = |part: &Sum| match part {
        Sum::One(_) => sum(part, components),
        Sum::Of(_) => format!("({})", sum(part, components)),
    };
    match of {
        Sum::One(at) => components[*at].clone(),
        Sum::Of(parts) => parts.each_ref().map(term).join(" + "),
    }
}
