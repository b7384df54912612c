//! Tests of `lower/witnesses`.

use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};
pub(crate) use linkage_compiler::lower::witnesses::*;

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
