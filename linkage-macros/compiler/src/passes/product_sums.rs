//! Adds a number to two products one after the other.
//!
//! Written down as a + (b c + d e), an acceleration takes a product, a fused operation and a sum. As
//! (a + d e) + b c it takes two fused operations and loses a rounding, and nothing but the last waits for the
//! product that is known last. Where operations are not fused it is as many operations as before.
//! Rates alone: of positions limits are decided, for which joints are rounded in every entry point alike.
//!
//! And the negative of a sum is a sum of negatives: a fused operation takes any signs, where its result would
//! have to be negated. Only a zero's sign is another.

use crate::ir::construct::{Maker, Moved, rebuild_with};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::ir::program::Program;

use super::contract::asked_for_errors;

/// Rewrites rates c + (ab + de) to the chain (c + ab) + de. The inner sum has a single use, and no rounding
/// error of either sum is requested.
pub fn chain_products(program: &Program) -> Program {
    let (graph, own) = (&program.graph, Own::of(program));
    let (depths, are_rates) = (depths(graph), rates(graph));
    rebuild_with(program, &[], |maker, id, moved| {
        let [(rest, true), (inner, is_added)] = terms(graph, id)? else { return None };
        let [first, second] = products(graph, inner)?;
        let is_free = own.has(inner) && !own.asked[id.index()] && !is_product(graph, rest);
        if !is_free || !are_rates[id.index()] {
            return None;
        }
        let in_order = depths[first.0.index()] <= depths[second.0.index()];
        let mut sum = moved.of(rest);
        for (product, is_plus) in if in_order { [first, second] } else { [second, first] } {
            let product = moved.of(product);
            sum = maker.make(match is_plus == is_added {
                true => Node::Add(sum, product),
                false => Node::Sub(sum, product),
            });
        }
        Some(sum)
    })
}

/// Moves the sign of a negated sum with a single use to the sum's terms.
pub fn negate_within(program: &Program) -> Program {
    let sums = Own::of(program);
    rebuild_with(program, &[], |maker, id, moved| match program.graph.node(id) {
        Node::Neg(sum) => sums.negative(maker, sum, moved),
        _ => None,
    })
}

/// The terms of a sum of a number and two products, these last, and whether each is added.
fn terms(graph: &Graph, id: Id) -> Option<[(Id, bool); 2]> {
    let [a, b] = summands(graph, id)?;
    let has_products = |(id, _): (Id, bool)| products(graph, id).is_some();
    Some(if has_products(b) { [a, b] } else { [b, a] })
}

/// The terms of a sum of two products.
fn products(graph: &Graph, id: Id) -> Option<[(Id, bool); 2]> {
    summands(graph, id).filter(|terms| terms.iter().all(|&(id, _)| is_product(graph, id)))
}

fn is_product(graph: &Graph, id: Id) -> bool {
    matches!(graph.node(id), Node::Mul(..))
}

fn summands(graph: &Graph, id: Id) -> Option<[(Id, bool); 2]> {
    match graph.node(id) {
        Node::Add(a, b) => Some([(a, true), (b, true)]),
        Node::Sub(a, b) => Some([(a, true), (b, false)]),
        _ => None,
    }
}

/// True for nodes that depend on an input's velocity or acceleration.
fn rates(graph: &Graph) -> Vec<bool> {
    let mut rates = Vec::with_capacity(graph.len());
    for (_, node) in graph.iter() {
        let mut is_rate = matches!(node, Node::Input { order: 1.., .. });
        graph.for_operands(node, Path::Slow, &mut |operand| is_rate |= rates[operand.index()]);
        rates.push(is_rate);
    }
    rates
}

/// Number of operations on the longest path to each node.
fn depths(graph: &Graph) -> Vec<u32> {
    let mut depths = Vec::with_capacity(graph.len());
    for (_, node) in graph.iter() {
        let mut depth = 0;
        graph.for_operands(node, Path::Slow, &mut |operand| {
            depth = u32::max(depth, 1 + depths[operand.index()]);
        });
        depths.push(depth);
    }
    depths
}

/// Nodes with a single use whose rounding error is not requested.
struct Own<'p> {
    graph: &'p Graph,
    uses: Vec<u32>,
    asked: Vec<bool>,
}

impl<'p> Own<'p> {
    fn of(program: &'p Program) -> Self {
        let (graph, sinks) = (&program.graph, program.sinks());
        let mut uses = vec![0; graph.len()];
        for (_, node) in live_nodes(graph, &live(graph, &sinks, Path::Slow)) {
            graph.for_operands(node, Path::Slow, &mut |operand| uses[operand.index()] += 1);
        }
        sinks.iter().for_each(|sink| uses[sink.index()] += 1);
        Self { graph, uses, asked: asked_for_errors(program) }
    }

    fn has(&self, id: Id) -> bool {
        self.uses[id.index()] == 1 && !self.asked[id.index()]
    }

    /// The negative of a sum that is the reader's own, if one of its terms is a product.
    fn negative(&self, maker: &mut Maker<'_>, sum: Id, moved: &Moved) -> Option<Id> {
        let [(a, _), (b, is_sum)] = summands(self.graph, sum).filter(|_| self.has(sum))?;
        let (first, second) = match [a, b].map(|id| is_product(self.graph, id)) {
            [_, true] => (a, b),
            [true, false] => (b, a),
            [false, false] => return None,
        };
        if !is_sum {
            return Some(maker.make(Node::Sub(moved.of(b), moved.of(a))));
        }
        let first = match self.negative(maker, first, moved) {
            Some(negative) => negative,
            None => maker.make(Node::Neg(moved.of(first))),
        };
        Some(maker.make(Node::Sub(first, moved.of(second))))
    }
}
