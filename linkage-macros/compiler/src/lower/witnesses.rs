//! Sinks that need a test for being finite.
//!
//! A value that is not finite makes every sum, difference, product, root, determinant and
//! numerator it enters not finite as well: +∞ − ∞, 0 · ∞ and √−∞ are no numbers, and none of
//! them brings a finite value back. So a sink that enters another tested sink on such a path needs
//! no test of its own. A denominator (1/∞ = 0), an angle and a rounding error do not carry on.

use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};

/// The sinks that need a test of their own, each node once, in the order of the graph.
pub(super) fn witnesses(graph: &Graph, sinks: &[Id]) -> Vec<Id> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn graph_of_two() -> (Graph, Id, Id) {
        let mut graph = Graph::new();
        let a = graph.push(Node::Input { input: 0, order: 0 });
        let b = graph.push(Node::Input { input: 1, order: 0 });
        (graph, a, b)
    }

    #[test]
    fn an_operand_of_a_sum_product_root_or_determinant_is_dominated() {
        for build in [
            |a, b| Node::Add(a, b),
            |a, b| Node::Sub(b, a),
            |a, b| Node::Mul(b, a),
            |a, b| Node::Det([b, b, b, a]),
            |a, b| Node::Fused(b, b, a),
            |a, b| Node::Div(a, b),
        ] {
            let (mut graph, a, b) = graph_of_two();
            let sink = graph.push(build(a, b));
            assert_eq!(witnesses(&graph, &[a, sink]), [sink]);
        }
    }

    #[test]
    fn a_denominator_an_angle_and_a_rounding_error_are_not_dominated() {
        for build in [
            |a, b| Node::Div(b, a),
            |a, _| Node::Apply(Function::Sin, a),
            |a, b| Node::Apply2(Function::Atan2, a, b),
            |a, b| Node::MulErr(a, b),
            |a, b| Node::AddErr(a, b),
        ] {
            let (mut graph, a, b) = graph_of_two();
            let sink = graph.push(build(a, b));
            assert_eq!(witnesses(&graph, &[a, sink]), [a, sink]);
        }
    }

    #[test]
    fn a_path_must_carry_on_at_every_step() {
        let (mut graph, a, b) = graph_of_two();
        let product = graph.push(Node::Mul(a, b));
        let root = graph.push(Node::Apply(Function::Sqrt, product));
        let quotient = graph.push(Node::Div(b, root));
        let sum = graph.push(Node::Add(quotient, b));
        // b enters the sum; a enters it only below the fraction bar.
        assert_eq!(witnesses(&graph, &[a, b, sum]), [a, sum]);
        // Through the root, a sink itself, a is dominated.
        assert_eq!(witnesses(&graph, &[a, root, sum]), [root, sum]);
    }

    #[test]
    fn constants_need_no_test_and_a_repeated_sink_needs_one() {
        let (mut graph, a, _) = graph_of_two();
        let mode = graph.push(Node::Mode(0));
        assert_eq!(witnesses(&graph, &[mode, a, a]), [a]);
    }
}
