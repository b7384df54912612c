//! Contracts a sum with a product that only sums use into one fused operation.
//!
//! Where the number has a fused operation this saves an instruction and a rounding; where it has
//! none, the fused node is the product and the sum it was made of. A product or a sum whose
//! rounding error is asked for stays as it is, because the error would no longer be its own.

use crate::ir::construct::rebuild_with;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::liveness::{Course, live};
use crate::ir::program::Program;

/// The program with products contracted into the sums that alone use them.
pub(crate) fn fuse_products(program: &Program) -> Program {
    let graph = &program.graph;
    let uses = uses(program);
    let product = |id: Id| match graph.node(id) {
        Node::Mul(a, b) if uses[id.index()] == Uses::Sums => Some((a, b)),
        _ => None,
    };
    rebuild_with(program, &[], |maker, id, moved| {
        let node = graph.node(id);
        if uses[id.index()] == Uses::Error {
            return None;
        }
        let (a, b) = match node {
            Node::Add(a, b) | Node::Sub(a, b) => (a, b),
            _ => return None,
        };
        let minus = matches!(node, Node::Sub(..));
        // The product that was made later is the one that would be waited for.
        let fused = match (product(a), product(b)) {
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

/// What a node's value is used for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Uses {
    /// Nothing but sums and differences.
    Sums,
    Other,
    /// Somebody asks for the rounding error of this very operation.
    Error,
}

fn uses(program: &Program) -> Vec<Uses> {
    let graph = &program.graph;
    let sinks = program.sinks();
    let live = live(graph, &sinks, Course::Careful);
    let mut uses = vec![Uses::Sums; graph.len()];
    sinks.iter().for_each(|sink| uses[sink.index()] = Uses::Other);
    for (_, node) in graph.iter().filter(|(id, _)| live[id.index()]) {
        if !matches!(node, Node::Add(..) | Node::Sub(..)) {
            graph.for_operands_of(node, &mut |operand| uses[operand.index()] = Uses::Other);
        }
    }
    keep_asked_errors(graph, &live, &mut uses);
    uses
}

/// Marks the products and sums whose rounding errors are asked for.
fn keep_asked_errors(graph: &Graph, live: &[bool], uses: &mut [Uses]) {
    for (_, node) in graph.iter().filter(|(id, _)| live[id.index()]) {
        let asked = match node {
            Node::MulErr(a, b) => [graph.find(Node::Mul(a, b)), graph.find(Node::Mul(b, a))],
            Node::AddErr(a, b) => [graph.find(Node::Add(a, b)), graph.find(Node::Add(b, a))],
            _ => continue,
        };
        for id in asked.into_iter().flatten() {
            uses[id.index()] = Uses::Error;
        }
        if let Node::AddErr(a, b) = node {
            keep_difference(graph, a, b, uses);
        }
    }
}

/// The error of a + (−b) is asked of the difference a − b.
fn keep_difference(graph: &Graph, a: Id, b: Id, uses: &mut [Uses]) {
    for (minuend, subtrahend) in [(a, b), (b, a)] {
        if let Node::Neg(inner) = graph.node(subtrahend)
            && let Some(id) = graph.find(Node::Sub(minuend, inner))
        {
            uses[id.index()] = Uses::Error;
        }
    }
}
