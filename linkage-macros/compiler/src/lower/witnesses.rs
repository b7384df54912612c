//! Sinks that need a test for being finite.
//!
//! A value that is not finite makes every sum, difference, product, root, determinant and
//! numerator it enters not finite as well: +∞ − ∞, 0 · ∞ and √−∞ are no numbers, and none of
//! them brings a finite value back. So a sink that enters another tested sink on such a path needs
//! no test of its own. A denominator (1/∞ = 0), an angle and a rounding error do not carry on.

use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};

/// The sinks that need a test of their own, each node once, in the order of the graph.
pub fn witnesses(graph: &Graph, sinks: &[Id]) -> Vec<Id> {
    // True if a value that is not finite shows in a tested sink further on.
    let mut shows = vec![false; graph.len()];
    let mut is_sink = vec![false; graph.len()];
    for sink in sinks {
        is_sink[sink.0 as usize] = true;
    }
    let mut tested = Vec::new();
    for index in (0..graph.len()).rev() {
        let (id, node) = (Id(index as u32), graph.node(Id(index as u32)));
        if is_sink[index] && !shows[index] && !always_finite(node) {
            tested.push(id);
        }
        if is_sink[index] || shows[index] {
            for_carried(graph, id, &mut |operand| shows[operand.0 as usize] = true);
        }
    }
    tested.reverse();
    tested
}

fn always_finite(node: Node) -> bool {
    matches!(node, Node::Constant(_) | Node::Low(_) | Node::Mode(_))
}

/// Calls `f` with every operand whose being not finite the node carries on.
fn for_carried(graph: &Graph, id: Id, f: &mut impl FnMut(Id)) {
    match graph.node(id) {
        Node::Neg(_)
        | Node::Add(..)
        | Node::Sub(..)
        | Node::Mul(..)
        | Node::Apply(Function::Sqrt, _)
        | Node::Det(_)
        | Node::Fused(..) => graph.node(id).for_operands(f),
        Node::Div(numerator, _) => f(numerator),
        _ => graph.beneath(id).into_iter().for_each(f),
    }
}
