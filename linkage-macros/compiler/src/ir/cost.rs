//! Cost of a set of sinks: floating-point operations of the fast path.
//!
//! Signs, comparisons and constants are free. What `linkage-core` computes by several operations
//! counts as those of a target with a fused multiply-add.

use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::{Path, live, tried};
use crate::ir::liveness::{trial_nodes, unguarded};
pub use crate::ir::operations::Operations;

/// Costs of a graph's nodes: found once, and added up for many sinks.
pub(crate) struct Costs<'g> {
    graph: &'g Graph,
    nodes: Vec<Cost>,
    tried: &'g [bool],
}

/// Cost of a node.
#[derive(Clone, Copy)]
enum Cost {
    Nothing,
    Alone(Operations),
    /// A sine, a cosine or a product: several nodes may be one operation. It goes by the first of these
    /// in the graph, and whatever else the node takes is an addition.
    Shared {
        by: Id,
        is_sine: bool,
        adds: bool,
    },
}

impl<'g> Costs<'g> {
    pub(crate) fn of(graph: &'g Graph, tried: &'g [bool]) -> Self {
        let (mut turned, mut multiplied) = (Map::default(), Map::default());
        let mut cost = |(id, node): (Id, Node)| match node {
            Node::Apply(Function::Sin | Function::Cos, angle) => {
                let by = *turned.or_insert(unguarded(graph, angle), id);
                Cost::Shared { by, is_sine: true, adds: false }
            }
            // A product that a fused operation shares with others is computed once where nothing is
            // fused, and is no operation more where it is.
            Node::Mul(a, b) | Node::Fused(a, b, _) => {
                let by = *multiplied.or_insert(factors(graph, a, b), id);
                Cost::Shared { by, is_sine: false, adds: matches!(node, Node::Fused(..)) }
            }
            // The comparison with what is not known before run time takes its last places.
            Node::Guard(..) => match graph.spread(node) {
                Some(spread) if graph.as_constant(spread).is_none() => {
                    Cost::Alone(Operations { multiplications: 1, ..Operations::default() })
                }
                _ => Cost::Nothing,
            },
            node => match of(graph, node) {
                operations if operations == Operations::default() => Cost::Nothing,
                operations => Cost::Alone(operations),
            },
        };
        let nodes = graph.iter().map(&mut cost).collect();
        Self { graph, nodes, tried }
    }

    /// The operations that computing the live nodes takes, each once, but for what searches compute.
    pub(crate) fn operations(&self, live: &[bool]) -> Operations {
        let is_counted = |index: &usize| live[*index] && !self.tried[*index];
        self.sum((0..live.len()).filter(is_counted))
    }

    /// The operations of one trial of an equation, given its sides and its slope.
    pub(crate) fn of_trial(&self, sides: &[Id]) -> Operations {
        self.sum(trial_nodes(self.graph, self.tried, sides).into_iter().map(|(id, _)| id.index()))
    }

    fn sum(&self, nodes: impl Iterator<Item = usize>) -> Operations {
        let (mut total, mut taken) = (Operations::default(), vec![false; self.nodes.len()]);
        for index in nodes {
            match self.nodes[index] {
                Cost::Nothing => {}
                Cost::Alone(operations) => total += operations,
                Cost::Shared { by, is_sine, adds } => {
                    let first = !std::mem::replace(&mut taken[by.index()], true);
                    let count = if is_sine { &mut total.sines } else { &mut total.multiplications };
                    *count += u32::from(first);
                    total.additions += u32::from(adds);
                }
            }
        }
        total
    }
}

/// The operations that computing the sinks takes.
pub fn operations(graph: &Graph, sinks: &[Id]) -> Operations {
    Costs::of(graph, &tried(graph)).operations(&live(graph, sinks, Path::Fast))
}

/// Factors of a product, regardless of signs, guards and order.
fn factors(graph: &Graph, a: Id, b: Id) -> [Id; 2] {
    let mut factors = [a, b].map(|factor| {
        let mut factor = unguarded(graph, factor);
        while let Node::Neg(inner) = graph.node(factor) {
            factor = unguarded(graph, inner);
        }
        factor
    });
    factors.sort();
    factors
}

/// The operations of one node on its own: two sines and cosines may be one call, and two products
/// one multiplication.
fn of(graph: &Graph, node: Node) -> Operations {
    let none = Operations::default();
    match node {
        Node::Solved(solve, output, _) => graph.implicit(solve).cost(output),
        Node::Constant(_)
        | Node::Input { .. }
        | Node::InputCos(_)
        | Node::InputSin(_)
        | Node::Param(_)
        | Node::Load(_)
        | Node::Drive(_)
        | Node::Mode(_)
        | Node::Low(_)
        | Node::Neg(_)
        | Node::Guard(..)
        | Node::Apply(Function::Sin | Function::Cos, _)
        | Node::Trial(_) => none,
        // A comparison costs what a difference does.
        Node::Add(..) | Node::Sub(..) | Node::Select(_) => Operations { additions: 1, ..none },
        Node::Mul(..) => Operations { multiplications: 1, ..none },
        Node::Div(..) => Operations { divisions: 1, ..none },
        Node::Apply(Function::Sqrt, _) => Operations { roots: 1, ..none },
        Node::Apply2(Function::Hypot, ..) => {
            Operations { additions: 1, multiplications: 2, roots: 1, ..none }
        }
        Node::Apply(..) | Node::Apply2(..) => Operations { sines: 1, ..none },
        Node::Det(_) => Operations { additions: 1, multiplications: 2, ..none },
        Node::MulErr(..) | Node::Fused(..) => {
            Operations { additions: 1, multiplications: 1, ..none }
        }
        // s is computed once: z = s − a, (a − (s − z)) + (b − z).
        Node::AddErr(..) => Operations { additions: 5, ..none },
    }
}
