//! The statements of a routine, printed one by one.

use proc_macro2::{Ident, Literal};

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{generated, text};
use super::text::Text;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::check::{Check, Comparison};
use crate::ir::graph::{Id, Node, Wanted};
use crate::ir::liveness::Path;
use crate::lower::routine::{Condition, Reading, Routine, Statement, Threshold};
use crate::model::mechanism::ParamKind;

/// The printer of one routine's statements, with all that they read.
pub(super) struct Printer<'a> {
    pub cx: &'a Context<'a>,
    pub arguments: Arguments<'a>,
    pub routine: &'a Routine,
    /// Whose functions compute: the type parameter.
    number: String,
}

impl<'a> Printer<'a> {
    pub(super) fn new(cx: &'a Context<'a>, routine: &'a Routine) -> Self {
        let (arguments, number) = (Arguments::of_our_own(cx, &routine.given), cx.number());
        Self { cx, arguments, routine, number: number.to_string() }
    }

    /// For a function that holds all of the routine: its constants are bound first.
    pub(super) fn beginning(cx: &'a Context<'a>, routine: &'a Routine, to: &mut Text) -> Self {
        for (constant, name) in routine.constants.iter() {
            to.put("let ").put(name).put(" = ").put(&cx.constant(*constant)).put(";\n");
        }
        Self::new(cx, routine)
    }

    pub(super) fn statements(&self, statements: &[Statement], to: &mut Text) {
        statements.iter().for_each(|statement| self.statement(statement, to));
    }

    fn statement(&self, statement: &Statement, to: &mut Text) {
        match statement {
            Statement::Let(id) => {
                to.put("let ").put(&self.local(*id)).put(" = ");
                self.expression(self.node(*id), to);
                to.put(";\n");
            }
            Statement::SinCos { angle, sin, cos, is_checked } => {
                self.sin_cos(*angle, [*sin, *cos], *is_checked, to);
            }
            Statement::Hypot { id, least_square } => {
                let Node::Apply2(_, x, y) = self.node(*id) else { unreachable!("it is one") };
                to.put("let ").put(&self.local(*id)).put(" = checks_.hypot(");
                for operand in [x, y] {
                    self.value(operand, to);
                    to.put(", ");
                }
                self.threshold(*least_square, to);
                to.put(");\n");
            }
            Statement::Check(condition) => self.condition(condition, to),
            Statement::Find { search, root, size } => self.find(*search, *root, *size, to),
            Statement::Tell { statements, clearances } => self.tell(statements, clearances, to),
        }
    }

    /// Passes the groups' clearances to the checks, and returns zeros for the result.
    fn tell(&self, statements: &[Statement], clearances: &[Id], to: &mut Text) {
        let stages = &self.routine.stages;
        let numbers: usize = stages.iter().map(|stage| stage.sinks.len()).sum();
        to.put(&format!("if ORDER == {} {{\n", stages.len()));
        self.statements(statements, to);
        to.put("checks_.clearances(&[").list(clearances.chunks(2), |to, of_group| {
            to.put("[").list(of_group, |to, &id| self.value(id, to)).put("]");
        });
        let as_array = self.cx.paths.written("Record");
        to.put(&format!("]);\nreturn {as_array}::from_array([zero_; {numbers}]);\n}}\n"));
    }

    /// The root of an equation, found by a function of its own.
    fn find(&self, search: usize, root: Id, size: Option<Id>, to: &mut Text) {
        let search = &self.cx.lowered.searches[search];
        let size = size.map_or("_".to_string(), |size| self.local(size));
        let mut found = Text::default();
        found.put("self.").put(&search.routine.name).put("([");
        found.list(&search.given, |to, &id| self.value(id, to)).put("]");
        let is_checked = self.routine.path != Path::Unchecked;
        found.put(&match search.apart {
            // The checks hold the seed, and are asked for it before they are told of the root.
            Some(_) if is_checked => format!(", checks_.seed({}))", search.sought.unknown),
            Some(_) => format!(", {}::None)", self.cx.paths.written("Option")),
            None => ")".to_string(),
        });
        let unknown = &self.cx.mechanism.unknowns[search.sought.unknown as usize];
        to.put("let (").put(&self.local(root)).put(", ").put(&size).put(") = ");
        if let Wanted::End(_) = search.sought.wanted {
            to.append(&found);
        } else if !is_checked {
            to.put(&self.cx.paths.written("open")).put("(").append(&found);
            to.put(")");
        } else {
            let unit = unit(unknown.measure, Order::Position);
            let named = [quoted(&text(&unknown.name)), quoted(&unit)].join(", ");
            let is_apart = search.apart.is_some();
            to.put(if is_apart { "{ let found_ = " } else { "checks_.root(" }).append(&found);
            to.put(if is_apart { "; checks_.root(found_, " } else { ", " }).put(&named);
            to.put(if is_apart { ") }" } else { ")" });
        }
        to.put(";\n");
    }

    pub(super) fn name(&self, id: Id) -> Ident {
        generated(&self.local(id))
    }

    fn local(&self, id: Id) -> String {
        self.routine.locals.name(id)
    }

    fn node(&self, id: Id) -> Node {
        self.cx.graph().node(id)
    }

    /// Writes the expression that reads a node's value.
    pub(super) fn value(&self, id: Id, to: &mut Text) {
        self.read(&self.routine.reading(self.cx.graph(), id), to);
    }

    /// The same alone.
    pub(super) fn value_alone(&self, id: Id) -> Text {
        let mut text = Text::default();
        self.value(id, &mut text);
        text
    }

    fn read(&self, reading: &Reading, to: &mut Text) {
        match reading {
            Reading::Leaf(node) => {
                let leaf = self.arguments.written(*node);
                to.put(&leaf.expect("a routine reads what it is given"));
            }
            Reading::Constant(node) => match self.routine.constants.get(node) {
                Some(name) => {
                    to.put(name);
                }
                None => {
                    to.put(&self.cx.constant(*node));
                }
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
        };
        match reading {
            Reading::Nested(id) if is_infix(*id) => {
                self.read(reading, to.put("("));
                to.put(")");
            }
            _ => self.read(reading, to),
        }
    }

    fn operand(&self, id: Id, to: &mut Text) {
        self.read_operand(&self.routine.reading(self.cx.graph(), id), to);
    }

    /// `let (sine, cosine) = …;` of an angle.
    fn sin_cos(&self, angle: Id, pair: [Option<Id>; 2], is_checked: bool, to: &mut Text) {
        let [sin, cos] = pair.map(|id| id.map_or("_".to_string(), |id| self.local(id)));
        to.put("let (").put(&sin).put(", ").put(&cos).put(") = ");
        match is_checked {
            true => to.put("checks_.sin_cos("),
            false => to.put(&self.number).put("::sin_cos("),
        };
        self.value(angle, to);
        to.put(");\n");
    }

    /// A condition as two calls: one that compares, unless it is known to hold, and one that
    /// diagnoses, whose answer goes on in the value's place. What is compared with a spread is compared
    /// once more where limits ask for more.
    fn condition(&self, condition: &Condition, to: &mut Text) {
        let value = self.value_alone(condition.value);
        let group = quoted(&self.cx.program().groups[condition.group as usize]);
        let word = condition.check.word().map(quoted);
        let operands = condition.operands.iter();
        if let Check::Closed(_) = condition.check {
            to.put("checks_.closed(").append(&value);
            operands.for_each(|&operand| self.value(operand, to.put(", ")));
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
            self.threshold(threshold, to);
            to.put(");\n");
        }
        if let Some(spread) = condition.above_rounding {
            to.put("checks_.above_rounding(").append(&value);
            self.value(spread, to.put(", "));
            to.put(");\n");
        }
        let diagnosis = self.cx.paths.written(condition.check.row().diagnosis);
        to.put("let ").put(&self.local(condition.id)).put(" = checks_.guard(").append(&value);
        to.put(", ").put(&diagnosis).put("(");
        if condition.check.row().reads_operands {
            to.put("[").list(operands, |to, &id| self.value(id, to)).put("], ");
        }
        to.put(&group);
        word.iter().for_each(|word| {
            to.put(", ").put(word);
        });
        to.put("));\n");
    }

    fn threshold(&self, threshold: Threshold, to: &mut Text) {
        match threshold {
            Threshold::SmallestSquare => to.put(&self.number).put("::smallest_square()"),
            Threshold::Number(wide, narrow) => to.put(&self.cx.written(wide, narrow as f32)),
        };
    }

    fn expression(&self, node: Node, to: &mut Text) {
        match node {
            Node::Neg(a) => self.operand(a, to.put("-")),
            Node::Add(a, b) => self.infix(a, " + ", b, to),
            Node::Sub(a, b) => self.infix(a, " - ", b, to),
            Node::Mul(a, b) => self.infix(a, " * ", b, to),
            Node::Div(a, b) => self.infix(a, " / ", b, to),
            Node::Apply(function, a) => self.call(function.name(), &[a], to),
            Node::Apply2(function, a, b) => self.call(function.name(), &[a, b], to),
            Node::Det(operands) => self.call("det", &operands, to),
            Node::Select([a, b, x, y]) => {
                to.put(&self.number).put("::select(");
                self.call("ge", &[a, b], to);
                to.put(", ").list(&[x, y], |to, &id| self.value(id, to)).put(")");
            }
            Node::MulErr(a, b) => self.call("mul_err", &[a, b], to),
            Node::AddErr(a, b) => self.call("add_err", &[a, b], to),
            Node::Fused(a, b, c) => self.call("fused", &[a, b, c], to),
            Node::Mode(param) => self.mode(param, to),
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_)
            | Node::Trial(_)
            | Node::Root(_)
            | Node::Size(_)
            | Node::Guard(..) => unreachable!("read in place, or a statement of its own kind"),
        }
    }

    fn infix(&self, a: Id, sign: &str, b: Id, to: &mut Text) {
        self.operand(a, to);
        self.operand(b, to.put(sign));
    }

    fn call(&self, function: &str, operands: &[Id], to: &mut Text) {
        to.put(&self.number).put("::").put(function).put("(");
        to.list(operands, |to, &id| self.value(id, to)).put(")");
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
}

/// A string as code.
fn quoted(text: &str) -> String {
    Literal::string(text).to_string()
}
