//! Tests of `lower/nesting`.

use crate::ir::graph::{Graph, Id, Node};
use crate::ir::liveness::{Path, live, tried};
use crate::lower::routine::Locals;
use crate::lower::schedule::{Schedule, defines};
pub(crate) use linkage_compiler::lower::nesting::*;

/// Numbers of the nodes with locals of their own, in a graph over two values, a = 0 and b = 1.
fn locals_of(make: impl FnOnce(&mut Graph, [Id; 2]) -> Vec<Id>, named: &[u32]) -> Vec<u32> {
    let mut graph = Graph::new();
    let given = [0, 1].map(|param| graph.push(Node::Mode(param)));
    let sinks = make(&mut graph, given);
    let mut locals = Locals::default();
    locals.names.extend(named.iter().map(|&id| (Id(id), "letter_".to_string())));
    let unnamed = Locals::default();
    let (tried, live) = (tried(&graph), live(&graph, &sinks, Path::Slow));
    let mut schedule = Schedule::new(&graph, &unnamed, Path::Slow, None, &[], &tried, &live);
    let statements = schedule.stage(&live);
    let before: Vec<Id> = statements.iter().flat_map(defines).collect();
    let reads = reads(&schedule, std::slice::from_ref(&statements), &sinks);
    let statements = nest(&schedule, &reads, &mut locals, statements);
    let left: Vec<Id> = statements.iter().flat_map(defines).collect();
    assert!(before.iter().all(|id| left.contains(id) != locals.nested.contains(id)));
    left.into_iter().map(|id| id.0).collect()
}

#[test]
fn what_the_next_statement_alone_reads_is_written_there() {
    // 2 = ab, 3 = ab + b.
    let sum = |g: &mut Graph, [a, b]: [Id; 2]| {
        let product = g.push(Node::Mul(a, b));
        vec![g.push(Node::Add(product, b))]
    };
    assert_eq!(locals_of(sum, &[]), [0, 1, 3]);
    assert_eq!(locals_of(sum, &[2]), [0, 1, 2, 3], "a letter is kept");
    let results = |g: &mut Graph, given: [Id; 2]| [Id(2), sum(g, given)[0]].to_vec();
    assert_eq!(locals_of(results, &[]), [0, 1, 2, 3], "a result is read by its name");
    let square = |g: &mut Graph, given: [Id; 2]| {
        let sum = sum(g, given)[0];
        vec![g.push(Node::Mul(sum, sum))]
    };
    assert_eq!(locals_of(square, &[]), [0, 1, 3, 4], "what is read twice is computed once");
}

#[test]
fn operations_stay_in_their_order() {
    // 2 = ab and 3 = a + b, …
    let pair = |g: &mut Graph, [a, b]: [Id; 2]| [g.push(Node::Mul(a, b)), g.push(Node::Add(a, b))];
    // … of which the first is on the left, or on the right.
    let forth = |g: &mut Graph, given| {
        let [first, second] = pair(g, given);
        vec![g.push(Node::Sub(first, second))]
    };
    let back = |g: &mut Graph, given| {
        let [first, second] = pair(g, given);
        vec![g.push(Node::Sub(second, first))]
    };
    assert_eq!(locals_of(forth, &[]), [0, 1, 4]);
    assert_eq!(locals_of(back, &[]), [0, 1, 2, 4]);
    // Something else stands between 2 and its reader.
    let apart = |g: &mut Graph, given| {
        let [first, second] = pair(g, given);
        let sum = g.push(Node::Sub(first, given[0]));
        vec![sum, g.push(Node::Add(second, second))]
    };
    assert_eq!(locals_of(apart, &[]), [0, 1, 2, 3, 4, 5]);
}

#[test]
fn an_expression_has_four_operations_at_most() {
    let chain =
        |g: &mut Graph, [a, b]: [Id; 2]| vec![(0..9).fold(a, |sum, _| g.push(Node::Add(sum, b)))];
    assert_eq!(locals_of(chain, &[]), [0, 1, 5, 9, 10]);
}
