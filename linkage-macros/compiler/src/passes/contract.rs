//! Contracts a sum with a product into one fused operation.
//!
//! Where the number has a fused operation this saves a rounding, and an instruction where nothing
//! else uses the product; where something does, the sum no longer waits for it. Where the number
//! has none, the fused node is the product and the sum it was made of, and the compiler computes
//! a shared product once. A product or a sum whose rounding error is asked for stays as it is,
//! because the error would no longer be its own; and so does a sum whose other operand was made
//! from the product: x + |x| is nothing below zero only as long as both are the same x.

use crate::ir::construct::rebuild_with;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Set;
use crate::ir::liveness::{Path, live};
use crate::ir::program::Program;

/// The program with products contracted into the sums that use them.
pub fn fuse_products(program: &Program) -> Program {
    let graph = &program.graph;
    let asked = asked_for_errors(program);
    let product = |id: Id| match graph.node(id) {
        Node::Mul(a, b) if !asked[id.index()] => Some((a, b)),
        _ => None,
    };
    rebuild_with(program, &[], |maker, id, moved| {
        let node = graph.node(id);
        if asked[id.index()] {
            return None;
        }
        let (a, b) = match node {
            Node::Add(a, b) | Node::Sub(a, b) => (a, b),
            _ => return None,
        };
        let minus = matches!(node, Node::Sub(..));
        let beside = |id: Id, rest: Id| product(id).filter(|_| !is_made_from(graph, rest, id));
        // The product that was made later is the one that would be waited for.
        let fused = match (beside(a, b), beside(b, a)) {
            (Some((x, y)), other) if other.is_none() || a > b => {
                let (x, y, rest) = (moved.of(x), moved.of(y), moved.of(b));
                let rest = if minus { maker.make(Node::Neg(rest)) } else { rest };
                Node::Fused(x, y, rest)
            }
            (_, Some((x, y))) => {
                let (x, y, rest) = (moved.of(x), moved.of(y), moved.of(a));
                let x = if minus { maker.make(Node::Neg(x)) } else { x };
                Node::Fused(x, y, rest)
            }
            _ => return None,
        };
        Some(maker.make(fused))
    })
}

/// True if `node` is `other` or depends on it.
fn is_made_from(graph: &Graph, node: Id, other: Id) -> bool {
    let (mut seen, mut left) = (Set::default(), vec![node]);
    // Operands stand before what is made from them.
    while let Some(id) = left.pop() {
        if id == other {
            return true;
        }
        if id > other && seen.insert(id) {
            graph.for_operands(graph.node(id), Path::Unchecked, &mut |operand| left.push(operand));
        }
    }
    false
}

/// For every node, whether somebody asks for the rounding error of this very operation.
pub(super) fn asked_for_errors(program: &Program) -> Vec<bool> {
    let graph = &program.graph;
    let live = live(graph, &program.sinks(), Path::Slow);
    let mut asked = vec![false; graph.len()];
    mark_asked_errors(graph, &live, &mut asked);
    asked
}

/// Marks the products and sums whose rounding errors are asked for.
fn mark_asked_errors(graph: &Graph, live: &[bool], marks: &mut [bool]) {
    for (_, node) in graph.iter().filter(|(id, _)| live[id.index()]) {
        let asked = match node {
            Node::MulErr(a, b) => [graph.find(Node::Mul(a, b)), graph.find(Node::Mul(b, a))],
            Node::AddErr(a, b) => [graph.find(Node::Add(a, b)), graph.find(Node::Add(b, a))],
            _ => continue,
        };
        for id in asked.into_iter().flatten() {
            marks[id.index()] = true;
        }
        if let Node::AddErr(a, b) = node {
            mark_difference(graph, a, b, marks);
        }
    }
}

/// The error of a + (−b) is asked of the difference a − b.
fn mark_difference(graph: &Graph, a: Id, b: Id, marks: &mut [bool]) {
    for (minuend, subtrahend) in [(a, b), (b, a)] {
        if let Node::Neg(inner) = graph.node(subtrahend)
            && let Some(id) = graph.find(Node::Sub(minuend, inner))
        {
            marks[id.index()] = true;
        }
    }
}
