//! The statements of a core: a `let` for every node that its sinks need, in the order of the
//! graph, with sine and cosine of one angle in one call.
//!
//! At conditions and angles a guard is called; a core without guards passes them by.

use std::collections::{HashMap, HashSet};

use proc_macro2::TokenStream;
use quote::quote;

use super::arguments::Arguments;
use super::blocks::Statement;
use super::finite::Bounds;
use super::names::generated;
use super::pieces::Pieces;
use super::{Context, formulas};
use crate::ir::graph::{Check, Graph, Id, Node};
use crate::ir::liveness::{Course, live, live_nodes, unguarded};
use crate::model::mechanism::ParamKind;

/// What the statements of one core are written with.
pub(super) struct Body<'a> {
    pub cx: &'a Context<'a>,
    pub arguments: &'a Arguments<'a>,
    pub course: Course,
    /// What is asked of divisors in place of results.
    pub bounds: Option<&'a Bounds>,
}

/// The statements, and what they read from outside.
#[derive(Default)]
pub(super) struct Statements {
    pub list: Vec<Statement>,
    /// The inputs and parameters that are read, in the order of the graph.
    pub leaves: Vec<Node>,
    /// Whether a guard is called.
    pub is_guarded: bool,
}

/// The sine and the cosine of one angle, as far as they are needed.
#[derive(Clone, Copy, Default)]
struct Pair {
    sin: Option<Id>,
    cos: Option<Id>,
}

fn pairs(graph: &Graph, live: &[bool]) -> HashMap<Id, Pair> {
    let mut pairs: HashMap<Id, Pair> = HashMap::new();
    for (id, node) in live_nodes(graph, live) {
        match node {
            Node::Sin(angle) => pairs.entry(angle).or_default().sin = Some(id),
            Node::Cos(angle) => pairs.entry(angle).or_default().cos = Some(id),
            _ => {}
        }
    }
    pairs
}

impl<'a> Body<'a> {
    pub(super) fn graph(&self) -> &'a Graph {
        &self.cx.program.graph
    }

    /// Everything that the sinks need.
    pub(super) fn statements(&self, sinks: &[Id]) -> Statements {
        let mut all = Statements::default();
        self.add_statements(&mut all, &mut HashSet::new(), sinks);
        all
    }

    /// The inputs and parameters that the sinks need, in the order of the graph.
    pub(super) fn leaves(&self, sinks: &[Id]) -> Vec<Node> {
        let live = live(self.graph(), sinks, self.course);
        let nodes = live_nodes(self.graph(), &live).map(|(_, node)| node);
        nodes.filter(|&node| self.arguments.leaf(node).is_some()).collect()
    }

    /// Adds what the sinks need beyond what was done before.
    pub(super) fn add_statements(
        &self,
        all: &mut Statements,
        done: &mut HashSet<Id>,
        sinks: &[Id],
    ) {
        let graph = self.graph();
        let live = live(graph, sinks, self.course);
        let mut pairs = pairs(graph, &live);
        for (id, node) in live_nodes(graph, &live) {
            if !done.insert(id) {
                continue;
            }
            all.is_guarded |= self.calls_guard(node);
            let statement = match node {
                _ if self.is_in_place(id, node) => None,
                _ if self.arguments.leaf(node).is_some() => {
                    all.leaves.push(node);
                    None
                }
                Node::Sin(angle) | Node::Cos(angle) => {
                    pairs.remove(&angle).map(|pair| self.turn(angle, pair))
                }
                Node::Guard(..) if self.course == Course::Open => None,
                Node::Guard(value, guard) => Some(formulas::condition(self, id, value, guard)),
                _ => Some(self.binding(id, node)),
            };
            all.list.extend(statement);
        }
    }

    fn calls_guard(&self, node: Node) -> bool {
        let is_constant = |id| matches!(self.graph().node(id), Node::Constant(_));
        self.course != Course::Open
            && match node {
                Node::Guard(..) => true,
                Node::Sin(angle) | Node::Cos(angle) => !is_constant(angle),
                _ => false,
            }
    }

    /// Whether the value has passed a condition that keeps it above zero.
    pub(super) fn is_above_zero(&self, value: Id) -> bool {
        match self.graph().node(value) {
            Node::Guard(inner, guard) => {
                let check = &self.graph().condition(guard).check;
                matches!(check, Check::ReachCircles | Check::ReachDistances | Check::Positive(_))
                    || self.is_above_zero(inner)
            }
            _ => false,
        }
    }

    /// The node that a local stands for: a core without guards sees through them.
    pub(super) fn resolve(&self, id: Id) -> Id {
        match self.course {
            Course::Straight | Course::Open => unguarded(self.graph(), id),
            Course::Careful => id,
        }
    }

    /// The expression that reads a node's value.
    pub(super) fn value(&self, id: Id) -> Pieces {
        let id = self.resolve(id);
        let node = self.graph().node(id);
        let in_place = self.arguments.leaf(node).or_else(|| self.constant(node));
        in_place.unwrap_or_else(|| match node {
            Node::Neg(operand) if self.is_in_place(id, node) => self.value(operand).negated(),
            _ => self.cx.locals.name(id).into(),
        })
    }

    /// Whether a value is written down where it is used: constants and signs say more there than
    /// a name would.
    fn is_in_place(&self, id: Id, node: Node) -> bool {
        match node {
            Node::Constant(_) | Node::Low(_) => true,
            Node::Neg(_) => !self.cx.locals.is_named(id),
            _ => false,
        }
    }

    /// The locals among the nodes.
    pub(super) fn locals(&self, ids: impl IntoIterator<Item = Id>) -> Vec<Id> {
        ids.into_iter()
            .map(|id| self.below_sign(id))
            .filter(|&id| {
                let node = self.graph().node(id);
                self.arguments.leaf(node).is_none() && !self.is_in_place(id, node)
            })
            .collect()
    }

    /// The node that is read where a value is: a sign is written in place.
    fn below_sign(&self, id: Id) -> Id {
        let id = self.resolve(id);
        match self.graph().node(id) {
            node @ Node::Neg(operand) if self.is_in_place(id, node) => self.below_sign(operand),
            _ => id,
        }
    }

    fn binding(&self, id: Id, node: Node) -> Statement {
        let mut operands = Vec::new();
        node.for_operands(&mut |operand| operands.push(operand));
        let (name, expression) = (self.cx.locals.name(id), self.expression(node));
        Statement {
            defines: vec![id],
            uses: self.locals(operands),
            code: quote!(let #name = #expression;),
        }
    }

    /// `let (sine, cosine) = …;` of an angle, at the place of whichever comes first.
    fn turn(&self, angle: Id, pair: Pair) -> Statement {
        let slot = |id: Option<Id>| {
            id.map_or(quote!(_), |id| {
                let name = self.cx.locals.name(id);
                quote!(#name)
            })
        };
        let (sin, cos, value) = (slot(pair.sin), slot(pair.cos), self.value(angle));
        let call = match self.calls_guard(Node::Sin(angle)) {
            true => {
                let guard = generated("guard_");
                quote!(#guard.sin_cos(#value))
            }
            false => {
                let function = self.cx.scalar("sin_cos");
                quote!(#function(#value))
            }
        };
        Statement {
            defines: pair.sin.into_iter().chain(pair.cos).collect(),
            uses: self.locals([angle]),
            code: quote!(let (#sin, #cos) = #call;),
        }
    }

    fn expression(&self, node: Node) -> TokenStream {
        let v = |id| self.value(id);
        let call = |function: &str, operands: &[Id]| {
            let function = self.cx.scalar(function);
            let operands = operands.iter().map(|&id| v(id));
            quote!(#function(#(#operands),*))
        };
        let infix = |a, operator: TokenStream, b| {
            let (a, b) = (v(a), v(b));
            quote!(#a #operator #b)
        };
        match node {
            Node::Neg(a) => {
                let a = v(a);
                quote!(-#a)
            }
            Node::Add(a, b) => infix(a, quote!(+), b),
            Node::Sub(a, b) => infix(a, quote!(-), b),
            Node::Mul(a, b) => infix(a, quote!(*), b),
            Node::Div(a, b) => infix(a, quote!(/), b),
            Node::Sqrt(a) => call("sqrt", &[a]),
            Node::Tan(a) => call("tan", &[a]),
            Node::Asin(a) => call("asin", &[a]),
            Node::Acos(a) => call("acos", &[a]),
            Node::Atan(a) => call("atan", &[a]),
            Node::Atan2(y, x) => call("atan2", &[y, x]),
            Node::Hypot(a, b) => call("hypot", &[a, b]),
            Node::Det(operands) => call("det", &operands),
            Node::MulErr(a, b) => call("mul_err", &[a, b]),
            Node::AddErr(a, b) => call("add_err", &[a, b]),
            Node::Fused(a, b, c) => call("fused", &[a, b, c]),
            Node::Mode(param) => self.mode(param),
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Sin(_)
            | Node::Cos(_)
            | Node::Guard(..) => unreachable!("read in place, or a statement of its own kind"),
        }
    }

    /// A constant as a number.
    fn constant(&self, node: Node) -> Option<Pieces> {
        match node {
            Node::Constant(constant) => {
                let value = self.graph().value(constant);
                Some(self.cx.literal(value.to_f64(), value.to_f32()))
            }
            Node::Low(constant) => {
                let value = self.graph().value(constant);
                Some(self.cx.literal(value.low_f64(), value.low_f32()))
            }
            _ => None,
        }
    }

    fn mode(&self, param: u32) -> TokenStream {
        let param = &self.cx.mechanism.params[param as usize];
        let ty = match param.kind {
            ParamKind::Sense { .. } => self.cx.paths.item("Sense"),
            ParamKind::Side { .. } | ParamKind::Number { .. } => self.cx.paths.item("Side"),
        };
        let (field, scalar) = (&param.name, &self.cx.names.scalar);
        quote!(#ty::sign::<#scalar>(self.#field))
    }
}
