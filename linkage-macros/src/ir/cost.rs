//! What a set of sinks costs: floating-point operations of the fast path.
//!
//! Signs, comparisons and constants are free. What `linkage-core` computes by several operations
//! counts as those of a target with a fused multiply-add.

use std::ops::AddAssign;

use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Set;
use crate::ir::liveness::{Path, live, live_nodes, trial_nodes, tried, unguarded};

/// Counts of floating-point operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Operations {
    /// Additions and subtractions.
    pub additions: u32,
    pub multiplications: u32,
    pub divisions: u32,
    pub roots: u32,
    /// Sine and cosine pairs, and other transcendental functions.
    pub sines: u32,
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        self.additions += other.additions;
        self.multiplications += other.multiplications;
        self.divisions += other.divisions;
        self.roots += other.roots;
        self.sines += other.sines;
    }
}

/// The operations that computing the sinks takes, each node once, but for what searches compute.
pub(crate) fn operations(graph: &Graph, sinks: &[Id]) -> Operations {
    let live = live(graph, sinks, Path::Fast);
    let tried = tried(graph);
    of_nodes(graph, live_nodes(graph, &live).filter(|(id, _)| !tried[id.index()]))
}

/// The operations of one trial of an equation, given its sides and its slope.
pub(crate) fn operations_of_trial(graph: &Graph, sides: &[Id]) -> Operations {
    of_nodes(graph, trial_nodes(graph, sides).into_iter())
}

fn of_nodes(graph: &Graph, nodes: impl Iterator<Item = (Id, Node)>) -> Operations {
    let mut total = Operations::default();
    let (mut turned, mut multiplied) = (Set::default(), Set::default());
    for (_, node) in nodes {
        match node {
            Node::Sin(angle) | Node::Cos(angle) => {
                total.sines += u32::from(turned.insert(unguarded(graph, angle)));
            }
            Node::Mul(a, b) | Node::Fused(a, b, _) => {
                total.additions += u32::from(matches!(node, Node::Fused(..)));
                // A product that a fused operation shares with others is computed once where
                // nothing is fused, and is no operation more where it is.
                total.multiplications += u32::from(multiplied.insert(factors(graph, a, b)));
            }
            // The comparison with what is not known before run time takes its last places.
            Node::Guard(..) => {
                let spread = graph.spread(node).filter(|&id| graph.as_constant(id).is_none());
                total.multiplications += u32::from(spread.is_some());
            }
            _ => total += of(node),
        }
    }
    total
}

/// What is multiplied, whatever the signs and the order.
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
fn of(node: Node) -> Operations {
    let none = Operations::default();
    match node {
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
        | Node::Sin(_)
        | Node::Cos(_)
        | Node::Trial(_)
        | Node::Root(_)
        | Node::Size(_) => none,
        Node::Add(..) | Node::Sub(..) => Operations { additions: 1, ..none },
        Node::Mul(..) => Operations { multiplications: 1, ..none },
        Node::Div(..) => Operations { divisions: 1, ..none },
        Node::Sqrt(_) => Operations { roots: 1, ..none },
        Node::Tan(_) | Node::Asin(_) | Node::Acos(_) | Node::Atan(_) | Node::Atan2(..) => {
            Operations { sines: 1, ..none }
        }
        Node::Hypot(..) => Operations { additions: 1, multiplications: 2, roots: 1, ..none },
        Node::Det(_) => Operations { additions: 1, multiplications: 2, ..none },
        Node::MulErr(..) | Node::Fused(..) => {
            Operations { additions: 1, multiplications: 1, ..none }
        }
        // s is computed once: z = s − a, (a − (s − z)) + (b − z).
        Node::AddErr(..) => Operations { additions: 5, ..none },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::graph::{Check, Guard};

    fn input(graph: &mut Graph, input: u32) -> Id {
        graph.push(Node::Input { input, order: 0 })
    }

    #[test]
    fn sine_and_cosine_of_one_angle_are_one_call() {
        let mut graph = Graph::new();
        let (a, b) = (input(&mut graph, 0), input(&mut graph, 1));
        let sinks = [Node::Sin(a), Node::Cos(a), Node::Cos(b)].map(|node| graph.push(node));
        assert_eq!(operations(&graph, &sinks).sines, 2);
        assert_eq!(operations(&graph, &sinks[..2]).sines, 1);
    }

    #[test]
    fn a_product_of_the_same_factors_is_one_multiplication() {
        let mut graph = Graph::new();
        let (a, b) = (input(&mut graph, 0), input(&mut graph, 1));
        let less = graph.push(Node::Neg(a));
        let sinks = [Node::Mul(a, b), Node::Fused(less, b, a), Node::Fused(b, a, b)]
            .map(|node| graph.push(node));
        let counted = operations(&graph, &sinks);
        let expected = Operations { additions: 2, multiplications: 1, ..Operations::default() };
        assert_eq!(counted, expected);
    }

    #[test]
    fn only_what_the_sinks_need_is_counted_and_only_once() {
        let mut graph = Graph::new();
        let (a, b) = (input(&mut graph, 0), input(&mut graph, 1));
        let product = graph.push(Node::Mul(a, b));
        let square = graph.push(Node::Mul(product, product));
        let root = graph.push(Node::Sqrt(product));
        let quotient = graph.push(Node::Div(a, b));
        let counted = operations(&graph, &[square, root]);
        let expected = Operations { multiplications: 2, roots: 1, ..Operations::default() };
        assert_eq!(counted, expected);
        assert_eq!(operations(&graph, &[quotient]).divisions, 1);
        assert_eq!(operations(&graph, &[quotient]).multiplications, 0);
    }

    #[test]
    fn what_only_the_careful_path_looks_at_is_free() {
        let mut graph = Graph::new();
        let (a, b) = (input(&mut graph, 0), input(&mut graph, 1));
        let looked_at = graph.push(Node::Div(a, b));
        let guard = Guard { check: Check::Nonzero, group: 0, operands: vec![looked_at] };
        let guarded = graph.guard(a, guard);
        let sink = graph.push(Node::Add(guarded, b));
        let expected = Operations { additions: 1, ..Operations::default() };
        assert_eq!(operations(&graph, &[sink]), expected);
    }
}
