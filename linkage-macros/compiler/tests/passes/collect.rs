//! Multiples of one value in a sum: what is collected, what is not, and that nothing changes.

use super::dynamics::SQUEEZER;
use super::rules::{c, nested, x, y};
use crate::equations;
use crate::equations::declarations::VARIANTS;
use crate::equations::forces::loaded;
use crate::interface::entries::EntryPoint;
use crate::ir::construct::rebuild;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::interpret::ProgramValues;
use crate::ir::program::{EntryOutputs, Program};
use crate::ir::text::text;
use crate::oracle::{Digits, defaults, mechanism, values};
use crate::passes::{RULES, shortened};
pub(crate) use linkage_compiler::passes::collect::*;

/// A program of these answers, made without rules.
fn program<const N: usize>(
    entries: [&'static str; N],
    build: impl FnOnce(&mut Graph) -> [Id; N],
) -> Program {
    let mut graph = Graph::new();
    let sinks = build(&mut graph);
    let answers = entries.into_iter().zip(sinks);
    let answers = answers
        .map(|(entry, sink)| EntryOutputs {
            entry: Some(EntryPoint::named(entry)),
            sinks: vec![sink],
        })
        .collect();
    Program { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups: Vec::new() }
}

/// The only answer, one of the equations of motion, as nested text after the pass.
fn collected(build: impl FnOnce(&mut Graph) -> Id) -> String {
    let program = collect_multiples(&program(["forward_dynamics"], |g| [build(g)]));
    nested(&program.graph, program.answers[0].sinks[0])
}

/// A constant times a value.
fn times(g: &mut Graph, factor: &str, of: Id) -> Id {
    let factor = c(g, factor);
    g.push(Node::Mul(factor, of))
}

#[test]
fn multiples_in_a_sum_become_one() {
    let sum = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (first, second) = (times(g, "0.3", a), times(g, "0.4", a));
        let s = g.push(Node::Add(first, b));
        g.push(Node::Add(s, second))
    });
    assert_eq!(sum, "(y + 0.7*x)");
}

#[test]
fn signs_count() {
    let difference = collected(|g| {
        let (a, b) = (x(g), y(g));
        let [p, q, r] = ["0.3", "0.5", "0.1"].map(|factor| times(g, factor, a));
        let inner = g.push(Node::Sub(b, p));
        let negative = g.push(Node::Neg(inner));
        let s = g.push(Node::Sub(negative, q));
        g.push(Node::Sub(s, r))
    });
    // −(y − 0.3 x) − 0.5 x − 0.1 x
    assert_eq!(difference, "-(y + 0.3*x)");
    let twice_taken = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (p, q) = (times(g, "0.3", a), times(g, "0.7", a));
        let inner = g.push(Node::Sub(b, p));
        g.push(Node::Sub(q, inner))
    });
    assert_eq!(twice_taken, "(x - y)");
}

#[test]
fn what_cancels_is_gone() {
    let left = collected(|g| {
        let (a, b) = (x(g), y(g));
        let p = times(g, "0.3", a);
        let s = g.push(Node::Add(p, b));
        g.push(Node::Sub(s, p))
    });
    assert_eq!(left, "y");
}

#[test]
fn a_product_that_stands_three_times_is_one() {
    let sum = collected(|g| {
        let (a, b) = (x(g), y(g));
        let p = times(g, "0.3", a);
        let s = g.push(Node::Add(p, b));
        let s = g.push(Node::Add(s, p));
        g.push(Node::Add(p, s))
    });
    assert_eq!(sum, "(y + 0.9*x)");
}

#[test]
fn what_would_be_off_by_more_stays() {
    // 1.1 x is rounded where x is not.
    let sum = collected(|g| {
        let (a, b) = (x(g), y(g));
        let s = g.push(Node::Sub(a, b));
        let p = times(g, "0.1", a);
        g.push(Node::Add(s, p))
    });
    assert_eq!(sum, "((x - y) + 0.1*x)");
    // Powers of two are exact, and their sum is not.
    let sum = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (p, q) = (times(g, "2", a), times(g, "0.5", a));
        let s = g.push(Node::Add(p, b));
        g.push(Node::Add(s, q))
    });
    assert_eq!(sum, "((2*x + y) + 0.5*x)");
    // Here it is.
    let sum = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (p, q) = (times(g, "1.5", a), times(g, "0.5", a));
        let s = g.push(Node::Add(p, b));
        g.push(Node::Add(s, q))
    });
    assert_eq!(sum, "(y + 2*x)");
    let difference = collected(|g| {
        let (a, b) = (x(g), y(g));
        let p = times(g, "0.9", a);
        let s = g.push(Node::Sub(a, b));
        g.push(Node::Sub(s, p))
    });
    assert_eq!(difference, "(0.1*x - y)");
}

#[test]
fn what_saves_nothing_stays() {
    let twice = collected(|g| {
        let (a, b) = (x(g), y(g));
        let s = g.push(Node::Add(a, b));
        g.push(Node::Add(s, a))
    });
    assert_eq!(twice, "((x + y) + x)");
    // Both products are there anyway, one of them for the divisor.
    let used_elsewhere = collected(|g| {
        let a = x(g);
        let (p, q) = (times(g, "0.3", a), times(g, "0.4", a));
        let (sum, product) = (g.push(Node::Add(p, q)), g.push(Node::Mul(p, q)));
        g.push(Node::Div(sum, product))
    });
    assert_eq!(used_elsewhere, "(0.3*x + 0.4*x)/0.3*x*0.4*x");
}

#[test]
fn a_sum_with_two_users_is_not_opened() {
    let square = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (p, q) = (times(g, "0.3", a), times(g, "0.4", a));
        let s = g.push(Node::Add(p, b));
        let t = g.push(Node::Add(s, q));
        g.push(Node::Mul(s, t))
    });
    assert_eq!(square, "(0.3*x + y)*((0.3*x + y) + 0.4*x)");
}

#[test]
fn a_sum_whose_error_is_asked_for_is_not_opened() {
    let compensated = collected(|g| {
        let (a, b) = (x(g), y(g));
        let (p, q) = (times(g, "0.3", a), times(g, "0.4", a));
        let s = g.push(Node::Add(p, b));
        let e = g.push(Node::AddErr(p, b));
        let t = g.push(Node::Add(s, q));
        g.push(Node::Add(t, e))
    });
    assert_eq!(compensated, "(((0.3*x + y) + 0.4*x) + add_err(0.3*x, y))");
}

fn sum_of_multiples(g: &mut Graph) -> Id {
    let (a, b) = (x(g), y(g));
    let (p, q) = (times(g, "0.3", a), times(g, "0.4", a));
    let s = g.push(Node::Add(p, b));
    g.push(Node::Add(s, q))
}

#[test]
fn only_the_equations_of_motion_are_collected() {
    for entry in ["position", "motion", "forces", "statics", "energy"] {
        let before = program([entry], |g| [sum_of_multiples(g)]);
        assert_eq!(text(&collect_multiples(&before)), text(&before), "{entry}");
    }
    // A sum that the motion needs as well stays; one that forces need as well is made twice.
    for (entry, expected) in [("motion", "((0.3*x + y) + 0.4*x)"), ("forces", "(y + 0.7*x)")] {
        let before = program([entry, "equations_of_motion"], |g| [sum_of_multiples(g); 2]);
        let after = collect_multiples(&before);
        let [shared, own] = [0, 1].map(|i| nested(&after.graph, after.answers[i].sinks[0]));
        assert_eq!((&shared[..], &own[..]), ("((0.3*x + y) + 0.4*x)", expected), "{entry}");
    }
}

#[test]
fn a_long_sum_takes_no_stack() {
    let small = std::thread::Builder::new().stack_size(256 << 10);
    let collected = small.spawn(|| {
        collected(|g| {
            let (a, mut sum) = (x(g), y(g));
            for k in 0..20_000_i32 {
                let p = times(g, &format!("{}", 2 * (k % 7) + 3), a);
                sum = g.push(Node::Add(sum, p));
            }
            sum
        })
    });
    let sum: i32 = (0..20_000).map(|k| 2 * (k % 7) + 3).sum();
    let collected = collected.expect("a thread starts").join().expect("the stack is enough");
    assert_eq!(collected, format!("(y + {sum}*x)"));
}

/// Every eighth variant; `.ci/nightly` takes all of them.
#[test]
fn collecting_changes_no_value() {
    assert!(collected_alike(8) > 1);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn collecting_changes_no_value_of_any_variant() {
    assert!(collected_alike(1) > 10);
}

/// The count of programs with multiples to collect, among those of every nth variant.
fn collected_alike(nth: usize) -> usize {
    let mut collects = 0;
    let variants =
        VARIANTS.iter().step_by(nth).map(|variant| (loaded(variant.source), variant.inputs));
    let squeezer = (SQUEEZER.to_string(), &[[0.4, 1.3, -0.6]][..]);
    for (source, inputs) in variants.chain([squeezer]) {
        let mechanism = mechanism(&source);
        let raw = rebuild(&equations::derive(&mechanism, RULES), RULES);
        let given = ProgramValues {
            inputs: inputs.iter().map(|q| q.map(Digits::float)).collect(),
            params: defaults(&mechanism),
            loads: Vec::new(),
            drives: vec![Digits::float(0.65); inputs.len()],
            unit: None,
        };
        // Not every input moves mass in every variant.
        let entries = ["forward_dynamics", "equations_of_motion"].into_iter();
        for entry in entries.filter(|entry| raw.answer(entry).is_some()) {
            let expected = values(&raw, entry, &given);
            let (one, all) = (collect_multiples(&raw), shortened(&raw));
            collects += usize::from(one.graph.len() > raw.graph.len());
            for passed in [one, all] {
                let found = values(&passed, entry, &given);
                for (found, expected) in found.iter().zip(&expected) {
                    assert!(found.apart(expected) < 1e-55, "{source}");
                }
            }
        }
    }
    collects
}
