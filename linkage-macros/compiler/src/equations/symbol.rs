//! Symbols that can be written like numbers: the formulas of this room are ordinary expressions
//! over [`Sym`] and [`Vector`], and each operator makes a node.
//!
//! The graph under construction sits in a cell so that a symbol can be `Copy` and carry its graph;
//! this is the one place of the compiler where that is so, and nothing of it leaves the room.

use std::cell::{Cell, RefCell};
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::Exact;
use crate::function::Function;
use crate::ir::construct::{Maker, Rule, remade};
use crate::ir::graph::{Check, ConstantId, Graph, Guard, Id, ImplicitId, Letter, Node};
use crate::ir::implicit::Implicit;
use crate::ir::liveness::{Path, live, live_nodes};

/// The graph that symbols are made in.
pub struct GraphBuilder<'r> {
    pub(super) graph: RefCell<Graph>,
    rules: &'r [Rule],
    /// True while conditions are ignored: a trial of an equation refuses nothing.
    are_guards_ignored: Cell<bool>,
}

/// A scalar on a builder.
#[derive(Clone, Copy)]
pub struct Sym<'s> {
    builder: &'s GraphBuilder<'s>,
    pub id: Id,
}

/// A vector in the plane.
#[derive(Clone, Copy)]
pub struct Vector<'s> {
    pub x: Sym<'s>,
    pub y: Sym<'s>,
}

impl<'r> GraphBuilder<'r> {
    pub fn new(rules: &'r [Rule]) -> Self {
        Self { graph: RefCell::new(Graph::new()), rules, are_guards_ignored: Cell::new(false) }
    }

    pub fn into_graph(self) -> Graph {
        self.graph.into_inner()
    }

    /// The graph as it is so far.
    pub fn graph(&self) -> Graph {
        self.graph.borrow().clone()
    }
}

impl<'s> GraphBuilder<'s> {
    pub fn node(&'s self, node: Node) -> Sym<'s> {
        let mut graph = self.graph.borrow_mut();
        let id = Maker { graph: &mut graph, rules: self.rules }.make(node);
        Sym { builder: self, id }
    }

    /// The sinks with one input rate 1, the others 0. Nodes free of rates are reused.
    pub(crate) fn at_unit_rate(&self, sinks: &[Id], moving: u32) -> Vec<Id> {
        remade(&mut self.graph.borrow_mut(), sinks, self.rules, |maker, id, to| {
            let new = match maker.graph.node(id) {
                Node::Input { input, order: 1 } => {
                    maker.constant(Exact::integer(i64::from(input == moving)))
                }
                node => maker.remake(id, node, to),
            };
            if let Some(name) = maker.graph.name_of(id).filter(|_| new != id) {
                let name = name.clone();
                maker.graph.name(new, name);
            }
            Some(new)
        })
    }

    /// The equations that numbers are solved by.
    pub(crate) fn implicit(&self, implicit: Implicit) -> ImplicitId {
        self.graph.borrow_mut().intern_implicit(implicit)
    }

    pub(crate) fn constant(&'s self, value: Exact) -> Sym<'s> {
        Sym { builder: self, id: self.graph.borrow_mut().constant(value) }
    }

    /// True if any sink needs the value of an input beside its cosine and sine.
    pub(crate) fn reads_input(&self, sinks: &[Id]) -> bool {
        let graph = self.graph.borrow();
        let live = live(&graph, sinks, Path::Slow);
        live_nodes(&graph, &live).any(|(_, node)| matches!(node, Node::Input { order: 0, .. }))
    }

    /// The symbol of a node that has been made.
    pub fn known(&'s self, id: Id) -> Sym<'s> {
        Sym { builder: self, id }
    }

    pub fn integer(&'s self, value: i64) -> Sym<'s> {
        self.constant(Exact::integer(value))
    }

    pub fn zero(&'s self) -> Sym<'s> {
        self.integer(0)
    }

    pub fn zero_vector(&'s self) -> Vector<'s> {
        Vector { x: self.zero(), y: self.zero() }
    }

    /// Gives the symbol a name in the generated code.
    pub(crate) fn name(&self, sym: Sym<'s>, text: String) {
        self.graph.borrow_mut().name(sym.id, Letter { text, is_in_passing: false });
    }

    /// The same where the symbol is no local for the sake of its name.
    pub(crate) fn note(&self, sym: Sym<'s>, text: String) {
        self.graph.borrow_mut().name(sym.id, Letter { text, is_in_passing: true });
    }

    /// Sets whether conditions are left out of what is made from now on.
    pub(crate) fn set_guards_ignored(&self, are_ignored: bool) {
        self.are_guards_ignored.set(are_ignored);
    }

    /// a·b − c·d as one operation.
    pub(crate) fn det(&'s self, a: Sym<'s>, b: Sym<'s>, c: Sym<'s>, d: Sym<'s>) -> Sym<'s> {
        self.node(Node::Det([a.id, b.id, c.id, d.id]))
    }
}

impl<'s> Sym<'s> {
    pub(crate) fn builder(self) -> &'s GraphBuilder<'s> {
        self.builder
    }

    fn unary(self, node: fn(Id) -> Node) -> Self {
        self.builder.node(node(self.id))
    }

    fn binary(self, other: Self, node: fn(Id, Id) -> Node) -> Self {
        self.builder.node(node(self.id, other.id))
    }

    /// A function of this number.
    pub(crate) fn apply(self, function: Function) -> Self {
        self.builder.node(Node::Apply(function, self.id))
    }

    pub fn sqrt(self) -> Self {
        self.apply(Function::Sqrt)
    }

    pub fn sin(self) -> Self {
        self.apply(Function::Sin)
    }

    pub fn cos(self) -> Self {
        self.apply(Function::Cos)
    }

    pub fn apply2(self, function: Function, other: Self) -> Self {
        self.builder.node(Node::Apply2(function, self.id, other.id))
    }

    pub(crate) fn hypot(self, other: Self) -> Self {
        self.apply2(Function::Hypot, other)
    }

    /// This to a power.
    pub(crate) fn pow(self, exponent: Self) -> Self {
        self.builder.node(Node::Apply2(Function::Pow, self.id, exponent.id))
    }

    /// `x` where this is at least as large as the other, `y` elsewhere.
    pub fn at_least(self, other: Self, x: Self, y: Self) -> Self {
        self.builder.node(Node::Select([self.id, other.id, x.id, y.id]))
    }

    /// The sign, −1 or 1; `at_zero` where there is none. NaN stays NaN.
    pub(crate) fn sign_or(self, at_zero: Self) -> Self {
        let [zero, one] = [0, 1].map(|value| self.builder.integer(value));
        if self.is_zero() {
            return at_zero;
        }
        let above = zero.at_least(self, at_zero, one);
        let below = zero.at_least(self, -one, self);
        self.at_least(zero, above, below)
    }

    /// The absolute value.
    pub(crate) fn magnitude(self) -> Self {
        self.at_least(self.builder.zero(), self, -self)
    }

    pub(crate) fn squared(self) -> Self {
        self * self
    }

    pub(crate) fn twice(self) -> Self {
        self.builder.integer(2) * self
    }

    pub fn half(self) -> Self {
        self.builder.constant(Exact::float(0.5).expect("finite")) * self
    }

    pub(crate) fn recip(self) -> Self {
        self.builder.integer(1) / self
    }

    /// The rounding error of the product.
    pub(crate) fn mul_err(self, other: Self) -> Self {
        self.binary(other, Node::MulErr)
    }

    /// The rounding error of the sum.
    pub(crate) fn add_err(self, other: Self) -> Self {
        self.binary(other, Node::AddErr)
    }

    /// The low word of a constant; zero for everything else.
    pub(crate) fn low(self) -> Self {
        match self.constant_id() {
            Some(constant) => self.builder.node(Node::Low(constant)),
            None => self.builder.zero(),
        }
    }

    /// The two terms of a sum or a difference, looking through guards; `None` for everything else.
    pub(crate) fn terms(self) -> Option<[Self; 2]> {
        let node = self.builder.graph.borrow().node(self.id);
        let term = |id| Self { builder: self.builder, id };
        match node {
            Node::Add(a, b) => Some([term(a), term(b)]),
            Node::Sub(a, b) => Some([term(a), -term(b)]),
            Node::Neg(a) => term(a).terms().map(|terms| terms.map(Neg::neg)),
            _ => self.beneath()?.terms(),
        }
    }

    /// True if this is made of inputs, parameters and constants by addition and subtraction alone.
    pub(crate) fn is_sum_of_given(self) -> bool {
        let node = self.builder.graph.borrow().node(self.id);
        let is_given = |id| Self { builder: self.builder, id }.is_sum_of_given();
        match node {
            Node::Constant(_)
            | Node::Input { order: 0, .. }
            | Node::Param(_)
            | Node::Trial(_)
            | Node::Solved(_, 0, None) => true,
            Node::Neg(a) => is_given(a),
            Node::Add(a, b) | Node::Sub(a, b) => is_given(a) && is_given(b),
            _ => self.beneath().is_some_and(Self::is_sum_of_given),
        }
    }

    /// True if this is an input, one of its rates or a constant, the opposite or a product: rounded once at most.
    pub(crate) fn is_multiple_of_input(self) -> bool {
        let graph = self.builder.graph.borrow();
        let is_given = |id| matches!(graph.node(id), Node::Constant(_) | Node::Input { .. });
        match graph.node(self.id) {
            Node::Neg(a) => is_given(a),
            Node::Mul(a, b) => is_given(a) && is_given(b),
            _ => is_given(self.id),
        }
    }

    /// The value that this stands on, under a condition.
    fn beneath(self) -> Option<Self> {
        let beneath = self.builder.graph.borrow().beneath(self.id);
        beneath.map(|id| Self { builder: self.builder, id })
    }

    /// The value, provided that the check holds for the group.
    pub(crate) fn guarded_by(self, check: Check, group: u32, operands: &[Self]) -> Self {
        if self.builder.are_guards_ignored.get() {
            return self;
        }
        let guard = Guard { check, group, operands: operands.iter().map(|o| o.id).collect() };
        let mut graph = self.builder.graph.borrow_mut();
        let id =
            Maker { graph: &mut graph, rules: self.builder.rules }.make_guarded(self.id, guard);
        Self { builder: self.builder, id }
    }

    fn constant_id(self) -> Option<ConstantId> {
        match self.builder.graph.borrow().node(self.id) {
            Node::Constant(constant) => Some(constant),
            _ => None,
        }
    }

    pub(crate) fn is_constant(self) -> bool {
        self.constant_id().is_some()
    }

    /// About the value, if it is a constant.
    pub(crate) fn constant_value(self) -> Option<f64> {
        self.builder.graph.borrow().as_constant(self.id).map(Exact::to_f64)
    }

    /// The integer that it is known to be.
    pub(crate) fn constant_integer(self) -> Option<i64> {
        self.builder.graph.borrow().as_constant(self.id).and_then(Exact::to_integer)
    }

    /// True if this is written as the opposite of something.
    pub(crate) fn is_negated(self) -> bool {
        matches!(self.builder.graph.borrow().node(self.id), Node::Neg(_))
    }

    /// True if the form alone shows that this is zero.
    pub(crate) fn is_zero(self) -> bool {
        self.builder.graph.borrow().is_zero(self.id)
    }
}

macro_rules! operator {
    ($trait:ident $method:ident $node:ident) => {
        impl $trait for Sym<'_> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.binary(other, Node::$node)
            }
        }
    };
}

operator!(Add add Add);
operator!(Sub sub Sub);
operator!(Mul mul Mul);
operator!(Div div Div);

impl Neg for Sym<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Node::Neg)
    }
}

impl<'s> Vector<'s> {
    pub(crate) fn dot(self, other: Self) -> Sym<'s> {
        self.x * other.x + self.y * other.y
    }

    /// a × b, positive where b is counter-clockwise of a.
    pub(crate) fn cross(self, other: Self) -> Sym<'s> {
        self.x * other.y - self.y * other.x
    }

    /// The normal 90° counter-clockwise of it, of the same length.
    pub fn normal(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.x.is_zero() && self.y.is_zero()
    }

    /// This direction turned by another: the product of the two as complex numbers.
    pub(crate) fn turned(self, by: Self) -> Self {
        Self { x: self.x * by.x - self.y * by.y, y: self.x * by.y + self.y * by.x }
    }

    /// The mirror image about the x axis: a direction's inverse.
    pub(crate) fn conjugate(self) -> Self {
        Self { x: self.x, y: -self.y }
    }
}

impl Add for Vector<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Vector<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Vector<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<'s> Mul<Vector<'s>> for Sym<'s> {
    type Output = Vector<'s>;
    fn mul(self, vector: Vector<'s>) -> Vector<'s> {
        Vector { x: self * vector.x, y: self * vector.y }
    }
}
