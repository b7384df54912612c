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
//! holds. That is how a group's failure stands in the graph: a sink that depends on a number behind
//! the condition can fail by it, and other sinks cannot. The fast path compares and goes on; the slow
//! path reads the operands of the condition, which are nodes as well. Code that refuses nothing looks
//! through conditions (`liveness::Path`).
//!
//! # Numbers that are solved
//! A number that equations fix is a node like any other ([`Node::Solved`]). The row of the equations
//! ([`Implicit`]) says what it is made from; of a root that is, among others, the sides of its equation at a
//! trial. What depends on a trial means nothing outside its search.
//!
//! # Names
//! A value that the derivation of its formula has a letter for keeps it (`Graph::name`), through
//! every rewrite, for whoever reads the generated code. Names mean nothing to the compiler.

use crate::exact::Exact;
pub use crate::ir::check::Check;
use crate::ir::hash::{Map, Set};
use crate::ir::implicit::Implicit;
pub use crate::ir::node::{
    ConstantId, GuardId, Id, ImplicitId, Node, Path, RootSearch, Target, Trend,
};

/// A condition on a value. In the generated code's straight line it is one comparison; where that
/// fails, the slow path looks at the operands and decides.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Guard {
    pub check: Check,
    /// The group whose failure it is: an index into `Program::groups`.
    pub group: u32,
    /// Operands that the slow path reads.
    pub operands: Vec<Id>,
}

impl Guard {
    /// The same condition on other operands.
    pub(crate) fn on(&self, moved: &dyn Fn(Id) -> Id) -> Self {
        let operands = self.operands.iter().map(|&operand| moved(operand)).collect();
        Self { operands, ..self.clone() }
    }
}

/// A constant, and which of 0, 1 and −1 it is: every sum and product asks, and the answer takes an
/// expression's enclosure.
#[derive(Clone, Debug)]
struct Constant {
    value: Exact,
    unit: Option<usize>,
}

/// Forms of an operand that sums and products tell apart.
#[derive(Clone, Copy, Debug)]
pub(crate) enum OperandForm {
    Zero,
    One,
    MinusOne,
    /// Any other constant.
    Constant,
    /// The negative of this.
    Negative(Id),
    Other,
}

impl OperandForm {
    pub(crate) fn is_constant(self) -> bool {
        matches!(self, Self::Zero | Self::One | Self::MinusOne | Self::Constant)
    }
}

/// See the module's documentation.
/// The name of a value in formulas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Letter {
    pub text: String,
    /// True if the value is no local for the sake of its name.
    pub is_in_passing: bool,
}

#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    constants: Vec<Constant>,
    guards: Set<Guard>,
    implicits: Set<Implicit>,
    node_ids: Map<Node, Id>,
    constant_ids: Map<Exact, ConstantId>,
    /// Names of values in formulas; most values have none.
    names: Map<Id, Letter>,
    has_trials: bool,
}

impl Graph {
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty graph with room for so many nodes.
    pub(crate) fn with_room(nodes: usize) -> Self {
        let node_ids = Map::with_room(nodes);
        Self { nodes: Vec::with_capacity(nodes), node_ids, ..Self::default() }
    }

    /// The id of the node, which is made unless an equal one exists.
    pub fn push(&mut self, node: Node) -> Id {
        let next = Id(u32::try_from(self.nodes.len()).expect("a graph has fewer than 2^32 nodes"));
        let id = *self.node_ids.or_insert(node, next);
        if id == next {
            let is_earlier = |operand| assert!(operand < id, "operands come first");
            self.for_operands(node, Path::Slow, &mut { is_earlier });
            self.has_trials |= matches!(node, Node::Trial(_));
            self.nodes.push(node);
        }
        id
    }

    pub fn intern(&mut self, value: Exact) -> ConstantId {
        if let Some(&id) = self.constant_ids.get(&value) {
            return id;
        }
        let unit = value.first_of(&[0, 1, -1]);
        self.keep(Constant { value, unit })
    }

    /// A constant of another graph, of which is known what it is.
    pub(crate) fn intern_from(&mut self, other: &Self, constant: ConstantId) -> ConstantId {
        let constant = &other.constants[constant.0 as usize];
        let known = self.constant_ids.get(&constant.value).copied();
        known.unwrap_or_else(|| self.keep(constant.clone()))
    }

    fn keep(&mut self, constant: Constant) -> ConstantId {
        let id = ConstantId(self.constants.len() as u32);
        self.constant_ids.insert(constant.value.clone(), id);
        self.constants.push(constant);
        id
    }

    pub fn constant(&mut self, value: Exact) -> Id {
        let constant = self.intern(value);
        self.push(Node::Constant(constant))
    }

    pub(crate) fn intern_guard(&mut self, guard: Guard) -> GuardId {
        GuardId(self.guards.number(guard))
    }

    pub fn condition(&self, guard: GuardId) -> &Guard {
        self.guards.by_number(guard.0)
    }

    pub(crate) fn intern_implicit(&mut self, implicit: Implicit) -> ImplicitId {
        ImplicitId(self.implicits.number(implicit))
    }

    pub fn implicit(&self, id: ImplicitId) -> &Implicit {
        self.implicits.by_number(id.0)
    }

    /// The search that the node is the root or the end of.
    pub fn search(&self, id: Id) -> Option<(ImplicitId, RootSearch)> {
        let Node::Solved(solve, 0, _) = self.node(id) else { return None };
        let Implicit::Root(sought) = self.implicit(solve) else { return None };
        Some((solve, *sought))
    }

    /// Gives the value a name, for whoever reads the generated code. The first one stays, but for one in passing.
    pub(crate) fn name(&mut self, id: Id, letter: Letter) {
        match self.names.get(&id) {
            Some(known) if !known.is_in_passing || letter.is_in_passing => {}
            _ => {
                self.names.insert(id, letter);
            }
        }
    }

    /// Name of the value in formulas.
    pub fn name_of(&self, id: Id) -> Option<&Letter> {
        self.names.get(&id)
    }

    /// The value under the guard.
    pub fn guard(&mut self, value: Id, guard: Guard) -> Id {
        let guard = self.intern_guard(guard);
        self.push(Node::Guard(value, guard))
    }

    /// The node, if it has been made.
    pub(crate) fn find(&self, node: Node) -> Option<Id> {
        self.node_ids.get(&node).copied()
    }

    pub fn node(&self, id: Id) -> Node {
        self.nodes[id.index()]
    }

    /// All nodes, operands before users.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// True if the graph contains a search.
    pub(crate) fn has_trials(&self) -> bool {
        self.has_trials
    }

    #[expect(clippy::len_without_is_empty, reason = "no caller asks")]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The same with their ids.
    pub fn iter(&self) -> impl Iterator<Item = (Id, Node)> + '_ {
        self.nodes.iter().enumerate().map(|(i, &node)| (Id(i as u32), node))
    }

    pub fn value(&self, constant: ConstantId) -> &Exact {
        &self.constants[constant.0 as usize].value
    }

    /// True if the node is the constant 0.
    pub(crate) fn is_zero(&self, id: Id) -> bool {
        matches!(self.form(id), OperandForm::Zero)
    }

    /// True if the node is the constant 1 or −1.
    pub(crate) fn is_one_or_minus_one(&self, id: Id) -> bool {
        matches!(self.form(id), OperandForm::One | OperandForm::MinusOne)
    }

    /// Form of an operand, as sums and products tell it apart.
    pub(crate) fn form(&self, id: Id) -> OperandForm {
        match self.nodes[id.0 as usize] {
            Node::Constant(constant) => match self.constants[constant.0 as usize].unit {
                Some(0) => OperandForm::Zero,
                Some(1) => OperandForm::One,
                Some(_) => OperandForm::MinusOne,
                None => OperandForm::Constant,
            },
            Node::Neg(of) => OperandForm::Negative(of),
            _ => OperandForm::Other,
        }
    }

    /// The exact constant that the node is, if it is one.
    pub fn as_constant(&self, id: Id) -> Option<&Exact> {
        match self.node(id) {
            Node::Constant(constant) => Some(self.value(constant)),
            _ => None,
        }
    }

    /// The value that the node stands on: under a guard, or an amount that straight-line code has found.
    pub(crate) fn beneath(&self, id: Id) -> Option<Id> {
        match self.node(id) {
            Node::Guard(value, _) => Some(value),
            Node::Solved(solve, _, on) => on.filter(|_| !self.implicit(solve).is_search()),
            _ => None,
        }
    }

    /// Spread that a guard compares its value with; none for any other node or guard.
    pub fn spread(&self, node: Node) -> Option<Id> {
        let Node::Guard(_, guard) = node else { return None };
        let guard = self.condition(guard);
        guard.operands.last().copied().filter(|_| guard.check.has_spread())
    }

    /// Calls `f` with every operand that is followed on a path.
    pub fn for_operands(&self, node: Node, path: Path, f: &mut impl FnMut(Id)) {
        match node {
            Node::Guard(_, guard) => match path {
                Path::Unchecked => {}
                Path::Fast => self.spread(node).into_iter().for_each(&mut *f),
                Path::Slow => self.condition(guard).operands.iter().for_each(|&id| f(id)),
            },
            Node::Solved(solve, output, _) => self.implicit(solve).for_operands(output, path, f),
            _ => {}
        }
        node.for_operands(f);
    }
}
