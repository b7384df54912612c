//! Rewriting into chains of sums: which terms, in which order, and where signs go.

use crate::function::Function;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::liveness::{Path, live};
use crate::ir::program::{EntryOutputs, Program};
use crate::ir::text::text;
use crate::passes::product_sums::{chain_products, negate_within};

/// A graph of numbers `a` to `e` that are known at the start, of which `e` is a rate, and `late`, which waits
/// for `e`.
struct Sample {
    graph: Graph,
    numbers: [Id; 5],
    late: Id,
}

fn sample() -> Sample {
    let mut graph = Graph::new();
    let [a, b, c, d] = [0, 1, 2, 3].map(|param| graph.push(Node::Param(param)));
    let numbers = [a, b, c, d, graph.push(Node::Input { input: 0, order: 1 })];
    let late = graph.push(Node::Apply(Function::Sqrt, numbers[4]));
    Sample { graph, numbers, late }
}

impl Sample {
    fn push(&mut self, node: Node) -> Id {
        self.graph.push(node)
    }

    /// late · b and c · d.
    fn products(&mut self) -> [Id; 2] {
        let [_, b, c, d, _] = self.numbers;
        [self.push(Node::Mul(self.late, b)), self.push(Node::Mul(c, d))]
    }

    /// The line of the only sink after the pass, and those that it is made of but numbers and products.
    fn after(self, pass: fn(&Program) -> Program, sinks: &[Id]) -> Vec<String> {
        let answers =
            vec![EntryOutputs { entry: Some(EntryPoint::named("motion")), sinks: sinks.to_vec() }];
        let (clearances, closures, groups) = (Vec::new(), Vec::new(), Vec::new());
        let program = pass(&Program { graph: self.graph, answers, clearances, closures, groups });
        let live = live(&program.graph, &program.sinks(), Path::Slow);
        let text = text(&program);
        let lines = text.lines().zip(live).filter_map(|(line, is_live)| is_live.then_some(line));
        let is_sum = |line: &&str| [" add ", " sub ", " neg "].iter().any(|sum| line.contains(sum));
        lines.filter(is_sum).map(str::to_string).collect()
    }
}

type Sum = fn(Id, Id) -> Node;

/// %6 is late · b, %7 is c · d.
#[test]
fn what_is_known_last_is_added_last_and_keeps_its_sign() {
    let (add, sub): (Sum, Sum) = (Node::Add, Node::Sub);
    for (outer, inner, lines) in [
        (add, add, ["%9 = add %0 %7", "%10 = add %9 %6"]),
        (add, sub, ["%9 = sub %0 %7", "%10 = add %9 %6"]),
        (sub, add, ["%9 = sub %0 %7", "%10 = sub %9 %6"]),
        (sub, sub, ["%9 = add %0 %7", "%10 = sub %9 %6"]),
    ] {
        let mut sample = sample();
        let [late, early] = sample.products();
        let sum = sample.push(inner(late, early));
        let sink = sample.push(outer(sample.numbers[0], sum));
        assert_eq!(sample.after(chain_products, &[sink]), lines);
    }
    // Whichever of the two is written first, and the number behind them.
    let mut sample = sample();
    let [late, early] = sample.products();
    let sum = sample.push(Node::Sub(early, late));
    let sink = sample.push(Node::Add(sum, sample.numbers[0]));
    assert_eq!(sample.after(chain_products, &[sink]), ["%9 = add %0 %7", "%10 = sub %9 %6"]);
}

#[test]
fn what_somebody_else_reads_or_has_no_number_stays() {
    let left = |also: fn(&mut Sample, Id, Id) -> Id| {
        let mut sample = sample();
        let [late, early] = sample.products();
        let sum = sample.push(Node::Add(late, early));
        let sink = sample.push(Node::Add(sample.numbers[0], sum));
        let other = also(&mut sample, sum, sink);
        sample.after(chain_products, &[sink, other]).contains(&"%9 = add %0 %8".to_string())
    };
    assert!(!left(|sample, _, _| sample.late));
    assert!(left(|_, sum, _| sum));
    assert!(left(|sample, sum, _| sample.push(Node::Neg(sum))));
    // Its error would be another's.
    assert!(left(|sample, sum, _| sample.push(Node::AddErr(sample.numbers[0], sum))));
    // Two products and a third are as short as they can be.
    let mut sample = sample();
    let [late, early] = sample.products();
    let third = sample.push(Node::Mul(sample.numbers[0], sample.numbers[1]));
    let sum = sample.push(Node::Add(late, early));
    let sink = sample.push(Node::Add(third, sum));
    assert_eq!(sample.after(chain_products, &[sink]), ["%9 = add %6 %7", "%10 = add %8 %9"]);
}

#[test]
fn positions_are_rounded_as_they_are_written() {
    let mut sample = sample();
    let [a, b, c, d, _] = sample.numbers;
    let products = [sample.push(Node::Mul(a, b)), sample.push(Node::Mul(c, d))];
    let sum = sample.push(Node::Sub(products[0], products[1]));
    let sink = sample.push(Node::Add(a, sum));
    let sinks = [sink, sample.late];
    let lines = sample.after(chain_products, &sinks);
    assert_eq!(lines, ["%8 = sub %6 %7", "%9 = add %0 %8"]);
}

#[test]
fn a_sign_goes_into_sums_with_products() {
    let negated = |sum: fn(&mut Sample, [Id; 2]) -> Id| {
        let mut sample = sample();
        let products = sample.products();
        let sum = sum(&mut sample, products);
        let sink = sample.push(Node::Neg(sum));
        // All numbers are somebody's, so that they keep their names.
        sample.after(negate_within, &[sink, products[1]])
    };
    let number_and_product =
        |sample: &mut Sample, [late, _]: [Id; 2]| sample.push(Node::Add(late, sample.numbers[0]));
    assert_eq!(negated(number_and_product), ["%9 = neg %0", "%10 = sub %9 %6"]);
    let difference =
        |sample: &mut Sample, [late, _]: [Id; 2]| sample.push(Node::Sub(sample.numbers[0], late));
    assert_eq!(negated(difference), ["%9 = sub %6 %0"]);
    let of_three = |sample: &mut Sample, [late, early]: [Id; 2]| {
        let sum = sample.push(Node::Sub(sample.numbers[0], early));
        sample.push(Node::Add(sum, late))
    };
    assert_eq!(negated(of_three), ["%10 = sub %7 %0", "%11 = sub %10 %6"]);
    // Without a product nothing takes the sign.
    let of_numbers = |sample: &mut Sample, _: [Id; 2]| {
        let [a, b, ..] = sample.numbers;
        sample.push(Node::Add(a, b))
    };
    assert_eq!(negated(of_numbers).len(), 2);
}

#[test]
fn a_sum_that_is_read_with_both_signs_stays() {
    let mut sample = sample();
    let [late, early] = sample.products();
    let sum = sample.push(Node::Add(late, sample.numbers[0]));
    let sink = sample.push(Node::Neg(sum));
    assert_eq!(sample.after(negate_within, &[sum, sink, early]).last().unwrap(), "%9 = neg %8");
}
