//! Squares of distances next to a crank: which become affine, and what of.

use crate::exact::Exact;
use crate::function::Function;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::program::{EntryOutputs, Program};
use crate::ir::text::text;
pub(crate) use linkage_compiler::passes::affine::*;

fn c(graph: &mut Graph, digits: &str) -> Id {
    graph.constant(Exact::decimal(digits).expect("a decimal literal"))
}

/// The square of the distance from (x, y) to the end of a crank of the length, after the pass.
fn square(x: &str, y: &str, length: &str, and: impl FnOnce(&mut Graph, [Id; 2]) -> Id) -> String {
    let mut g = Graph::new();
    let angle = g.push(Node::Input { input: 0, order: 0 });
    let (cos, sin) =
        (g.push(Node::Apply(Function::Cos, angle)), g.push(Node::Apply(Function::Sin, angle)));
    let length = c(&mut g, length);
    let squares = [(x, cos), (y, sin)].map(|(pivot, part)| {
        let (pivot, part) = (c(&mut g, pivot), g.push(Node::Mul(length, part)));
        let component = g.push(Node::Sub(pivot, part));
        g.push(Node::Mul(component, component))
    });
    let sink = and(&mut g, squares);
    let answers =
        vec![EntryOutputs { entry: Some(EntryPoint::named("position")), sinks: vec![sink] }];
    text(&square_distances(&Program {
        graph: g,
        answers,
        clearances: Vec::new(),
        closures: Vec::new(),
        groups: Vec::new(),
    }))
}

fn sum(g: &mut Graph, [xx, yy]: [Id; 2]) -> Id {
    g.push(Node::Add(xx, yy))
}

/// True if the text computes a constant plus or minus a multiple of the cosine, told by the constant.
fn starts_at(text: &str, constant: &str) -> bool {
    text.contains(&format!(" = {constant}\n"))
}

#[test]
fn a_distance_that_grows_by_half_at_most_is_affine() {
    // 5² + 1 − 2·5·cos θ: from 4 to 6.
    let beside = square("5", "0", "1", sum);
    assert!(starts_at(&beside, "26") && beside.contains(" = 10\n"), "{beside}");
    assert!(beside.contains("mul %13 %1\n"), "{beside}");
    assert!(beside.trim_end().ends_with("%16 = sub %11 %14\nposition: %16"), "{beside}");
    // The pivot inside the circle: 1 + 5² − 2·5·sin θ.
    let inside = square("0", "1", "5", sum);
    assert!(starts_at(&inside, "26") && inside.contains(" = 10\n"), "{inside}");
    // Aside of both axes: 3² + 4² + 0.5² − 3 cos θ − 4 sin θ.
    let aside = square("3", "4", "0.5", sum);
    assert!(
        starts_at(&aside, "25.25") && aside.contains(" = -3\n") && aside.contains(" = -4\n"),
        "{aside}"
    );
}

#[test]
fn a_constant_beside_the_square_stays_beside_it() {
    // 26 − 10 cos θ, and (4 − 3)² taken from it.
    let near = square("5", "0", "1", |g, squares| {
        let (square, limit) = (sum(g, squares), c(g, "1"));
        g.push(Node::Sub(square, limit))
    });
    assert!(starts_at(&near, "26"), "{near}");
}

#[test]
fn a_distance_that_grows_by_more_than_half_stays_a_sum_of_squares() {
    for near in [square("5", "0", "1.01", sum), square("1", "0", "1.1", sum)] {
        assert!(near.trim_end().ends_with("%13 = add %7 %11\nposition: %13"), "{near}");
    }
}

#[test]
fn what_is_asked_for_its_rounding_error_stays_a_sum_of_squares() {
    let kept = square("5", "0", "1", |g, [xx, yy]| {
        let (square, error) = (g.push(Node::Add(xx, yy)), g.push(Node::AddErr(xx, yy)));
        g.push(Node::Add(square, error))
    });
    assert!(!starts_at(&kept, "26"), "{kept}");
}

#[test]
fn what_moves_on_no_circle_stays_a_sum_of_squares() {
    let mut g = Graph::new();
    let angle = g.push(Node::Input { input: 0, order: 0 });
    let (cos, sin) =
        (g.push(Node::Apply(Function::Cos, angle)), g.push(Node::Apply(Function::Sin, angle)));
    // Along a line: cosine and sine have coefficients of one size, but not across each other.
    let turned = g.push(Node::Add(cos, sin));
    let (far, aside) = (c(&mut g, "9"), c(&mut g, "1"));
    let x = g.push(Node::Sub(far, turned));
    let squares = [x, aside].map(|part| g.push(Node::Mul(part, part)));
    let sink = sum(&mut g, squares);
    let answers =
        vec![EntryOutputs { entry: Some(EntryPoint::named("position")), sinks: vec![sink] }];
    let program = Program {
        graph: g,
        answers,
        clearances: Vec::new(),
        closures: Vec::new(),
        groups: Vec::new(),
    };
    let kept = text(&square_distances(&program));
    // 9² + 1² + 1 would be the constant of a circle.
    assert!(!starts_at(&kept, "83"), "{kept}");
}
