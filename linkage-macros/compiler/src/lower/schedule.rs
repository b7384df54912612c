//! In which order the values of a routine are computed: the graph's own, operands before their
//! users, with sine and cosine of one angle at the place of whichever comes first.

use super::checks;
use super::overflow::Overflow;
use super::routine::{Instruction, Locals, Search, Solving, Threshold, is_leaf};
use crate::function::Function;
use crate::ir::graph::{Graph, Id, ImplicitId, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::{Path, live_nodes};

/// Nodes scheduled so far, and the values they read from outside.
#[derive(Clone)]
pub struct Schedule<'a> {
    pub graph: &'a Graph,
    pub locals: &'a Locals,
    pub path: Path,
    /// Limits on divisors, tested in place of results.
    pub overflow: Option<&'a Overflow>,
    done: Vec<bool>,
    /// Nodes that the fast path needs for the last sinks.
    fast: &'a [bool],
    /// The inputs and parameters that are read, in the order of the graph.
    pub reads: Vec<Node>,
    /// True if a check has been scheduled.
    pub has_checks: bool,
    /// Nodes that only a search computes.
    tried: &'a [bool],
    /// The searches, by their roots.
    searches: &'a [Search],
}

/// The sine and the cosine of one angle, as far as they are needed.
#[derive(Clone, Copy, Default)]
pub(super) struct SinCosPair {
    pub sin: Option<Id>,
    pub cos: Option<Id>,
}

impl<'a> Schedule<'a> {
    pub fn new(
        graph: &'a Graph,
        locals: &'a Locals,
        path: Path,
        overflow: Option<&'a Overflow>,
        searches: &'a [Search],
        tried: &'a [bool],
        fast: &'a [bool],
    ) -> Self {
        let (done, reads) = (vec![false; graph.len()], Vec::new());
        Self {
            graph,
            locals,
            path,
            overflow,
            done,
            fast,
            reads,
            has_checks: false,
            tried,
            searches,
        }
    }

    /// Statements for the live nodes, beyond those scheduled before.
    pub fn stage(&mut self, live: &[bool]) -> Vec<Instruction> {
        let graph = self.graph;
        let mut pairs = pairs(live_nodes(graph, live));
        let mut statements = Vec::new();
        for (id, node) in live_nodes(graph, live) {
            if self.tried[id.index()] || std::mem::replace(&mut self.done[id.index()], true) {
                continue;
            }
            // A hypotenuse that the slow path alone reads is not tested on the fast one.
            let is_measured = matches!(node, Node::Apply2(Function::Hypot, ..))
                && self.path != Path::Unchecked
                && self.fast[id.index()];
            self.has_checks |= is_measured || self.is_checked(node);
            let statement = match node {
                Node::Apply2(Function::Hypot, ..) if is_measured => {
                    let known = self.overflow.map(|overflow| overflow.least_square(id));
                    let least_square = known.unwrap_or(Threshold::SmallestSquare);
                    Some(Instruction::Length { id, least_square })
                }
                _ if is_leaf(node) => {
                    self.reads.push(node);
                    None
                }
                Node::Constant(_) | Node::Low(_) => None,
                Node::Neg(_) if !self.locals.components.contains(&id) => None,
                Node::Apply(Function::Sin | Function::Cos, angle) => {
                    take(&mut pairs, angle).map(|pair| {
                        let SinCosPair { sin, cos } = pair;
                        Instruction::SinCos { angle, sin, cos, is_checked: self.is_checked(node) }
                    })
                }
                _ if self.path == Path::Unchecked && graph.beneath(id).is_some() => None,
                Node::Solved(implicit, ..) => {
                    Some(Instruction::Solve(self.solving(live, implicit)))
                }
                Node::Guard(value, guard) => {
                    let guard = graph.condition(guard);
                    let condition = checks::condition(graph, self.overflow, id, value, guard);
                    Some(Instruction::Check(condition))
                }
                _ => Some(Instruction::Let(id)),
            };
            statements.extend(statement);
        }
        statements
    }

    /// All that comes out of these equations, as far as it is live: it is found with the first.
    fn solving(&mut self, live: &[bool], implicit: ImplicitId) -> Solving {
        let row = self.graph.implicit(implicit);
        let mut outputs = vec![None; row.outputs()];
        // A later stage may want the size of a root.
        for (id, node) in self.graph.iter() {
            if let Node::Solved(of, output, _) = node
                && of == implicit
                && (live[id.index()] || row.is_search())
            {
                outputs[output as usize] = Some(id);
                self.done[id.index()] = true;
            }
        }
        let search = self.searches.iter().find(|search| search.implicit == implicit);
        let given = search.map_or(&[][..], |search| &search.given);
        let beneath = outputs.iter().flatten().filter_map(|&id| self.graph.beneath(id));
        let (reads, compares) = row.reads(given, beneath);
        Solving { implicit, outputs, reads, compares }
    }

    /// Conditions are, and angles that are not constant: a large one takes more than the fast
    /// path's reduction.
    fn is_checked(&self, node: Node) -> bool {
        let is_constant = |id| matches!(self.graph.node(id), Node::Constant(_));
        self.path != Path::Unchecked
            && match node {
                Node::Guard(..) | Node::Solved(..) => true,
                Node::Apply(Function::Sin | Function::Cos, angle) => !is_constant(angle),
                _ => false,
            }
    }

    /// Tells each local among the values.
    pub(super) fn for_locals(&self, ids: &[Id], each: &mut dyn FnMut(Id)) {
        let read = |&id: &Id| self.locals.reading(self.graph, self.path, id).local();
        ids.iter().filter_map(read).for_each(each);
    }

    /// Tells each local that a statement reads, in the order in which it does.
    pub(super) fn for_uses(&self, statement: &Instruction, each: &mut dyn FnMut(Id)) {
        match statement {
            Instruction::Let(id) | Instruction::Length { id, .. } => {
                let node = self.graph.node(*id);
                node.for_operands(&mut |operand| self.for_locals(&[operand], each));
            }
            Instruction::SinCos { angle, .. } => self.for_locals(&[*angle], each),
            Instruction::Check(condition) => {
                self.for_locals(&[condition.value], each);
                self.for_locals(&condition.operands, each);
            }
            Instruction::Solve(solving) => {
                solving.compares.iter().for_each(|compared| self.for_locals(compared, each));
                self.for_locals(&solving.reads, each);
            }
            Instruction::ReportClearances { statements, clearances } => {
                statements.iter().for_each(|statement| self.for_uses(statement, each));
                self.for_locals(clearances, each);
            }
        }
    }
}

/// The locals that a statement binds.
pub fn defines(statement: &Instruction) -> Vec<Id> {
    match statement {
        Instruction::Let(id) | Instruction::Length { id, .. } => vec![*id],
        Instruction::SinCos { sin, cos, .. } => sin.iter().chain(cos).copied().collect(),
        Instruction::Check(condition) => vec![condition.id],
        Instruction::Solve(solving) => solving.bound().collect(),
        Instruction::ReportClearances { .. } => Vec::new(),
    }
}

pub(super) fn pairs(nodes: impl Iterator<Item = (Id, Node)>) -> Map<Id, SinCosPair> {
    let mut pairs: Map<Id, SinCosPair> = Map::default();
    for (id, node) in nodes {
        match node {
            Node::Apply(Function::Sin, angle) => {
                pairs.or_insert(angle, SinCosPair::default()).sin = Some(id)
            }
            Node::Apply(Function::Cos, angle) => {
                pairs.or_insert(angle, SinCosPair::default()).cos = Some(id)
            }
            _ => {}
        }
    }
    pairs
}

/// Takes the pair of the angle; none if it has been taken.
pub(super) fn take(pairs: &mut Map<Id, SinCosPair>, angle: Id) -> Option<SinCosPair> {
    let pair = std::mem::take(pairs.or_insert(angle, SinCosPair::default()));
    (pair.sin.is_some() || pair.cos.is_some()).then_some(pair)
}
