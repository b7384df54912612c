//! The expression graph: every number that any entry point needs, each once.
//!
//! # Order
//! A [`Graph`] is a list of nodes; a node's operands stand strictly before it, so that a plain walk
//! from front to back meets every operand before its user, and one from back to front every user
//! before its operands. Nothing is scheduled but by that order: code is written down as the graph
//! stands.
//!
//! # Sharing
//! Equal nodes are the same node (hash-consing): what two formulas have in common is computed once,
//! without anybody looking for it. An entry point is a list of nodes, its sinks; what it computes is
//! what these need, however much more the graph holds.
//!
//! # Numbers
//! A constant is an exact real number: nothing is rounded before code generation. What the nodes
//! mean is real arithmetic. What floating-point arithmetic makes of them is fixed by the code that
//! is emitted: one rounding a node, except where a node says otherwise.
//!
//! # Conditions
//! A node may stand under a condition ([`Guard`]): it is its value, provided that the condition
//! holds. That is how a group's failure stands in the graph: whoever needs a number behind the
//! condition asks for it, and whoever does not never fails by it. The fast path compares and goes
//! on; the slow path looks at the operands of the condition, which are nodes as well. Where nobody
//! is to refuse anything, conditions are passed by (`liveness::Path`).
//!
//! # Roots
//! A number that an equation fixes is a node like any other ([`Node::Root`]); its operands are the
//! sides of the equation at a trial. What depends on a trial means nothing outside its search.
//!
//! # Names
//! A value that the derivation of its formula has a letter for keeps it (`Graph::name`), through
//! every rewrite, for whoever reads the generated code. Names mean nothing to the compiler.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use crate::exact::Exact;

/// A node of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Id(pub u32);

impl Id {
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }
}

/// An interned exact constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct ConstantId(pub u32);

/// A condition, see [`Guard`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct GuardId(pub u32);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    Constant(ConstantId),
    /// An input (`order` 0), its rate (1) or its second rate (2).
    Input {
        input: u32,
        order: u8,
    },
    /// The cosine of an input, where an `_at` entry is given it: with `InputSin` a point of the unit
    /// circle, which rewrites may take for granted. The run-time crate divides the amplitude out
    /// of what a resolver gives before any formula sees it.
    InputCos(u32),
    /// The sine of an input, where an `_at` entry is given it.
    InputSin(u32),
    /// A numeric parameter.
    Param(u32),
    /// A load: a force, a torque or a number that a call is given.
    Load(u32),
    /// The effort that drives an input, where a call is given it.
    Drive(u32),
    /// A mode parameter as +1 or −1.
    Mode(u32),
    Neg(Id),
    Add(Id, Id),
    Sub(Id, Id),
    Mul(Id, Id),
    Div(Id, Id),
    Sqrt(Id),
    /// Sine and cosine of the same angle are one call in the generated code.
    Sin(Id),
    Cos(Id),
    Tan(Id),
    Asin(Id),
    Acos(Id),
    Atan(Id),
    /// `Atan2(y, x)`
    Atan2(Id, Id),
    Hypot(Id, Id),
    /// a·b − c·d, rounded as if it were one operation; opaque to simplification except where it
    /// collapses to a single product.
    Det([Id; 4]),
    /// The rounding error of a product: zero in real arithmetic.
    MulErr(Id, Id),
    /// The rounding error of a sum: zero in real arithmetic.
    AddErr(Id, Id),
    /// The low word of a constant: what rounding it to a number of the working width leaves.
    Low(ConstantId),
    /// a·b + c, fused where the number has a fused operation.
    Fused(Id, Id, Id),
    /// The value, provided that the guard's condition holds.
    Guard(Id, GuardId),
    /// A value at which the equation of an unknown is tried. What depends on it is computed inside
    /// the search alone.
    Trial(u32),
    /// The root of an unknown's equation.
    Root(Sought),
    /// The size by which the rounding of a root's equation is measured.
    Size(Id),
}

/// What a root is searched by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Sought {
    pub unknown: u32,
    /// The sign of the slope at the root.
    pub rises: bool,
    pub between: [Id; 2],
    pub near: Option<Id>,
    /// The two sides at the trial, and the slope of their difference.
    pub sides: [Id; 3],
}

/// A condition on a value. In the generated code's straight line it is one comparison; where that
/// fails, the slow path looks at the operands and decides.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Guard {
    pub check: Check,
    /// The group whose failure it is: an index into `Program::groups`.
    pub group: u32,
    /// What the slow path looks at.
    pub operands: Vec<Id>,
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Check {
    /// Fast path: value above what rounding does to it. Slow path: circles of radii l₁ and l₂ about
    /// points d = (dx, dy) apart must meet. Operands dx, dy, l₁, l₂ and the spread, a number that
    /// rounding changes the value in the last places of. The value is
    /// (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²)/(4 l₁ l₂)²; where rounding could have changed its sign it is
    /// replaced by what it is without, and at the limit by 0.
    ReachCircles,
    /// Fast path: nothing. Slow path: where the `ReachCircles` of the first operand, its value, is
    /// decided without rounding, so is this, (d² + l₁² − l₂²)/2d²; at the limit it is ± l₁/|d|. The
    /// other operands are those of `ReachCircles`.
    ShareOfCentres,
    /// Fast path: value above what rounding does to it. Slow path: a point must have the
    /// distances r₁ and r₂ from (0, 0) and (l, 0). Operands l, r₁, r₂ and the spread. The value is the
    /// square of the point's y, replaced as that of `ReachCircles` is.
    ReachDistances,
    /// Fast path: value ≥ the smallest number of full precision. Slow path: |t| ≤ l. Operands t, l.
    /// At the limit the value is replaced by 0.
    ReachLine,
    /// Fast path: value ≥ 0. Slow path: |e| ≤ |(bx, by)|. Operands bx, by, e. At the limit the
    /// value is replaced by 0.
    ReachOffset,
    /// Fast path: |value| > 0. Slow path: zero is `Singular`.
    Nonzero,
    /// Fast path: value > 0. Slow path: zero or negative is `Invalid` with this name.
    Positive(String),
    /// Fast path: value ≥ 0. Slow path: negative is `Invalid` with this name.
    NotNegative(String),
    /// An equation's left − right in the final pose. Operand: the size of its sides. Both paths ask
    /// whether it is closed; `NoSolution`, where it is not, bears the group's name.
    Closed,
    /// The slope of an equation at its root, in the wanted way. Fast path: above what rounding does
    /// to it. Slow path: `Singular` where it is not. Operand: the spread.
    Moving,
    /// Fast path: value ≥ the smallest square of full precision. Slow path: a squared length
    /// below it is refused, as `Singular` where it is the square of zero. With the operands of
    /// `ReachCircles` it is the square of d, and out of reach where the circles do not meet.
    Square,
}

impl Guard {
    /// The same condition on other operands.
    pub(crate) fn on(&self, moved: &dyn Fn(Id) -> Id) -> Self {
        let operands = self.operands.iter().map(|&operand| moved(operand)).collect();
        Self { operands, ..self.clone() }
    }
}

impl Check {
    /// Whether the last operand is a spread, which the straight line compares the value with.
    pub(crate) fn has_spread(&self) -> bool {
        matches!(self, Self::ReachCircles | Self::ReachDistances | Self::Moving)
    }
}

/// A constant, and which of 0, 1 and −1 it is: every sum and product asks, and the answer takes an
/// expression's enclosure.
#[derive(Clone, Debug)]
struct Constant {
    value: Exact,
    unit: Option<usize>,
}

/// Hashes the few small numbers of a node. Nobody chooses them to collide, and the standard
/// library's hash takes a tenth of the time of a macro that is built without optimisation.
#[derive(Clone, Copy, Debug, Default)]
struct Mixer(u64);

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(byte.into()));
    }

    fn write_u8(&mut self, number: u8) {
        self.write_u64(number.into());
    }

    fn write_u32(&mut self, number: u32) {
        self.write_u64(number.into());
    }

    fn write_isize(&mut self, number: isize) {
        self.write_u64(number as u64);
    }

    fn write_u64(&mut self, number: u64) {
        // Two to the 64th over the golden ratio.
        self.0 = (self.0.rotate_left(5) ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn finish(&self) -> u64 {
        // The table takes its slot from the low bits, which multiplication mixes least.
        self.0.rotate_left(26)
    }
}

/// See the module's documentation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    constants: Vec<Constant>,
    guards: Vec<Guard>,
    node_ids: HashMap<Node, Id, BuildHasherDefault<Mixer>>,
    constant_ids: HashMap<Exact, ConstantId>,
    guard_ids: HashMap<Guard, GuardId>,
    /// What formulas call their values; most values have no name.
    names: HashMap<Id, String>,
}

impl Graph {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// The id of the node, which is made unless an equal one exists.
    pub(crate) fn push(&mut self, node: Node) -> Id {
        if let Some(&id) = self.node_ids.get(&node) {
            return id;
        }
        let id = Id(u32::try_from(self.nodes.len()).expect("a graph has fewer than 2^32 nodes"));
        self.for_operands_of(node, &mut |operand| assert!(operand < id, "operands come first"));
        self.nodes.push(node);
        self.node_ids.insert(node, id);
        id
    }

    pub(crate) fn intern(&mut self, value: Exact) -> ConstantId {
        if let Some(&id) = self.constant_ids.get(&value) {
            return id;
        }
        let id = ConstantId(self.constants.len() as u32);
        let unit = value.first_of(&[0, 1, -1]);
        self.constants.push(Constant { value: value.clone(), unit });
        self.constant_ids.insert(value, id);
        id
    }

    pub(crate) fn constant(&mut self, value: Exact) -> Id {
        let constant = self.intern(value);
        self.push(Node::Constant(constant))
    }

    pub(crate) fn intern_guard(&mut self, guard: Guard) -> GuardId {
        if let Some(&id) = self.guard_ids.get(&guard) {
            return id;
        }
        let id = GuardId(self.guards.len() as u32);
        self.guards.push(guard.clone());
        self.guard_ids.insert(guard, id);
        id
    }

    /// Gives the value a name, for whoever reads the generated code; the first one stays.
    pub(crate) fn name(&mut self, id: Id, name: String) {
        self.names.entry(id).or_insert(name);
    }

    /// What formulas call the value.
    pub(crate) fn name_of(&self, id: Id) -> Option<&str> {
        self.names.get(&id).map(|name| &name[..])
    }

    /// The value under the guard.
    #[cfg(test)]
    pub(crate) fn guard(&mut self, value: Id, guard: Guard) -> Id {
        let guard = self.intern_guard(guard);
        self.push(Node::Guard(value, guard))
    }

    /// The node, if it has been made.
    pub(crate) fn find(&self, node: Node) -> Option<Id> {
        self.node_ids.get(&node).copied()
    }

    pub(crate) fn node(&self, id: Id) -> Node {
        self.nodes[id.index()]
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// All nodes, operands before users.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Id, Node)> + '_ {
        self.nodes.iter().enumerate().map(|(i, &node)| (Id(i as u32), node))
    }

    pub(crate) fn value(&self, constant: ConstantId) -> &Exact {
        &self.constants[constant.0 as usize].value
    }

    /// Whether the node is the constant 0.
    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.unit(id) == Some(0)
    }

    /// Whether the node is the constant 1.
    pub(crate) fn is_one(&self, id: Id) -> bool {
        self.unit(id) == Some(1)
    }

    /// Whether the node is the constant 1 or −1.
    pub(crate) fn is_one_or_minus_one(&self, id: Id) -> bool {
        self.unit(id).is_some_and(|unit| unit > 0)
    }

    fn unit(&self, id: Id) -> Option<usize> {
        match self.node(id) {
            Node::Constant(constant) => self.constants[constant.0 as usize].unit,
            _ => None,
        }
    }

    pub(crate) fn condition(&self, guard: GuardId) -> &Guard {
        &self.guards[guard.0 as usize]
    }

    /// The exact constant that the node is, if it is one.
    pub(crate) fn as_constant(&self, id: Id) -> Option<&Exact> {
        match self.node(id) {
            Node::Constant(constant) => Some(self.value(constant)),
            _ => None,
        }
    }

    /// Calls `f` with every operand that the fast path computes or compares with.
    pub(crate) fn for_fast_operands_of(&self, node: Node, f: &mut impl FnMut(Id)) {
        node.for_operands(f);
        self.spread(node).into_iter().for_each(f);
    }

    /// What a guard's value is compared with.
    pub(crate) fn spread(&self, node: Node) -> Option<Id> {
        let Node::Guard(_, guard) = node else { return None };
        let guard = self.condition(guard);
        guard.operands.last().copied().filter(|_| guard.check.has_spread())
    }

    /// Calls `f` with every operand, what only the slow path looks at included.
    pub(crate) fn for_operands_of(&self, node: Node, f: &mut impl FnMut(Id)) {
        if let Node::Guard(_, guard) = node {
            self.condition(guard).operands.iter().for_each(|&operand| f(operand));
        }
        node.for_operands(f);
    }
}

impl Node {
    /// Calls `f` with every operand that the fast path computes with.
    pub(crate) fn for_operands(self, f: &mut impl FnMut(Id)) {
        self.map_operands(&mut |operand| {
            f(operand);
            operand
        });
    }

    /// The same node on other operands; a guard's own operands are not among them.
    pub(crate) fn map_operands(self, f: &mut impl FnMut(Id) -> Id) -> Self {
        match self {
            Self::Constant(_)
            | Self::Input { .. }
            | Self::InputCos(_)
            | Self::InputSin(_)
            | Self::Param(_)
            | Self::Load(_)
            | Self::Drive(_)
            | Self::Mode(_)
            | Self::Trial(_)
            | Self::Low(_) => self,
            Self::Root(sought) => Self::Root(Sought {
                between: sought.between.map(&mut *f),
                near: sought.near.map(&mut *f),
                sides: sought.sides.map(&mut *f),
                ..sought
            }),
            Self::Size(root) => Self::Size(f(root)),
            Self::Neg(a) => Self::Neg(f(a)),
            Self::Sqrt(a) => Self::Sqrt(f(a)),
            Self::Sin(a) => Self::Sin(f(a)),
            Self::Cos(a) => Self::Cos(f(a)),
            Self::Tan(a) => Self::Tan(f(a)),
            Self::Asin(a) => Self::Asin(f(a)),
            Self::Acos(a) => Self::Acos(f(a)),
            Self::Atan(a) => Self::Atan(f(a)),
            Self::Guard(a, guard) => Self::Guard(f(a), guard),
            Self::Add(a, b) => Self::Add(f(a), f(b)),
            Self::Sub(a, b) => Self::Sub(f(a), f(b)),
            Self::Mul(a, b) => Self::Mul(f(a), f(b)),
            Self::Div(a, b) => Self::Div(f(a), f(b)),
            Self::Atan2(a, b) => Self::Atan2(f(a), f(b)),
            Self::Hypot(a, b) => Self::Hypot(f(a), f(b)),
            Self::MulErr(a, b) => Self::MulErr(f(a), f(b)),
            Self::AddErr(a, b) => Self::AddErr(f(a), f(b)),
            Self::Fused(a, b, c) => Self::Fused(f(a), f(b), f(c)),
            Self::Det(operands) => Self::Det(operands.map(f)),
        }
    }
}
