//! Tests of `ir/cost`.

use crate::function::Function;
use crate::ir::graph::{Check, Graph, Guard, Id, Node};
pub(crate) use linkage_compiler::ir::cost::*;

fn input(graph: &mut Graph, input: u32) -> Id {
    graph.push(Node::Input { input, order: 0 })
}

#[test]
fn sine_and_cosine_of_one_angle_are_one_call() {
    let mut graph = Graph::new();
    let (a, b) = (input(&mut graph, 0), input(&mut graph, 1));
    let sinks = [
        Node::Apply(Function::Sin, a),
        Node::Apply(Function::Cos, a),
        Node::Apply(Function::Cos, b),
    ]
    .map(|node| graph.push(node));
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
    let root = graph.push(Node::Apply(Function::Sqrt, product));
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
