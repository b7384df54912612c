//! Node by node: these find what errors of whole programs hide.

use std::collections::BTreeMap;

use super::computed::{applied, computed};
use super::machines::{Case, MACHINES};
use crate::ir::graph::{Id, Node};
use crate::ir::interpret::Number;
use crate::oracle::Digits;
use crate::prove::adjoint::Adjoints;
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;

/// Boxes a range is cut into.
const BOXES: usize = 24;
/// Poses tried in each.
const POSES: usize = 12;

/// Boxes of the first input, the others in the middle fifth of their ranges.
fn boxes(case: &Case) -> impl Iterator<Item = Vec<[f64; 2]>> {
    (0..BOXES).map(|at| {
        let part = |[from, to]: [f64; 2], low: f64, high: f64| {
            [from + (to - from) * low, from + (to - from) * high]
        };
        let (first, rest) = case.given.ranges.split_first().expect("an input");
        let share = |end: usize| end as f64 / BOXES as f64;
        let first = part(*first, share(at), share(at + 1));
        [first].into_iter().chain(rest.iter().map(|range| part(*range, 0.4, 0.6))).collect()
    })
}

/// The function of a node, of what its operands were computed to, in more digits.
fn exact(node: Node, pose: &[f64], v: &dyn Fn(Id) -> f64) -> Option<f64> {
    Some(match node {
        Node::InputCos(input) => pose[input as usize].cos(),
        Node::InputSin(input) => pose[input as usize].sin(),
        Node::Add(a, b) => v(a) + v(b),
        Node::Sub(a, b) => v(a) - v(b),
        Node::Mul(a, b) => v(a) * v(b),
        Node::Div(a, b) => v(a) / v(b),
        Node::Fused(a, b, c) => v(a) * v(b) + v(c),
        Node::Det([a, b, c, d]) => v(a) * v(b) - v(c) * v(d),
        Node::MulErr(..) | Node::AddErr(..) => 0.0,
        Node::Apply(function, a) => applied(function, v(a), v(a)),
        Node::Apply2(function, a, b) => applied(function, v(a), v(b)),
        Node::Neg(a) => -v(a),
        _ => return None,
    })
}

/// A node's result of the `f32` that it is given is no further from the same function of these than its own
/// error. `f64` is off by 2⁻²⁹ of that, and more where terms cancel: these are exact in it.
#[test]
fn no_node_rounds_by_more_than_its_own_error() {
    let mut nearest: BTreeMap<&str, f64> = BTreeMap::new();
    for machine in MACHINES {
        let case = machine.case([1.0, 0.5]);
        let subject =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::SINGLE);
        let mut largest = vec![0.0f64; subject.nodes.len()];
        for sides in boxes(&case) {
            let values = OneBox::new(&subject, InputBox::new(&sides));
            for pose in 0..POSES * 2 {
                let at = |[from, to]: &[f64; 2]| {
                    f64::from(
                        (from + (to - from) * ((pose / 2) as f64 + 0.37) / POSES as f64) as f32,
                    )
                };
                let pose_at: Vec<f64> = sides.iter().map(at).collect();
                let found = computed::<f32>(&subject, &pose_at, pose % 2 == 1, None);
                let of = |id: Id| f64::from(found[subject.place(id)]);
                for (place, &(_, node)) in subject.nodes.iter().enumerate() {
                    let value = f64::from(found[place]);
                    let range = values.values[place].range();
                    assert!(
                        range.low <= value && value <= range.high,
                        "{}: {node:?} at {pose_at:?}: {value} is outside {range:?}",
                        machine.name
                    );
                    let Some(exact) = exact(node, &pose_at, &of) else { continue };
                    let (error, own) = ((value - exact).abs(), values.errors[place][0]);
                    assert!(
                        error <= own * (1.0 + 1e-6) + 1e-16 * exact.abs(),
                        "{}: {node:?} at {pose_at:?}: {error:e} is above {own:e}",
                        machine.name
                    );
                    if own > 0.0 {
                        largest[place] = largest[place].max(error / own);
                        let nearest = nearest.entry(kind(node)).or_default();
                        *nearest = nearest.max(error / own);
                    }
                }
            }
        }
        // An error that nothing comes near is too large: sums that are exact by luck aside, most nodes see a half.
        let seen: Vec<f64> = largest.into_iter().filter(|&share| share > 0.0).collect();
        let near = seen.iter().filter(|&&share| share > 0.3).count();
        assert!(near * 3 > seen.len() * 2, "{}: {near} of {}", machine.name, seen.len());
    }
    // Half of an error of its own would be too little for every kind of node.
    println!("{nearest:?}");
    nearest.remove("difference of products");
    assert!(nearest.len() >= 6, "{nearest:?}");
    assert!(nearest.values().all(|share| *share > 0.5), "{nearest:?}");
}

/// The kind of a node that rounds.
fn kind(node: Node) -> &'static str {
    match node {
        Node::Add(..) | Node::Sub(..) => "sum",
        Node::Mul(..) => "product",
        Node::Div(..) => "quotient",
        Node::Fused(..) => "fused",
        Node::InputCos(_) | Node::InputSin(_) => "sine",
        Node::Apply(..) | Node::Apply2(..) => "function",
        Node::MulErr(..) => "error of a product",
        Node::AddErr(..) => "error of a sum",
        _ => "difference of products",
    }
}

/// A constant's error is known, with its sign.
#[test]
fn errors_of_constants_are_those_of_their_rounding() {
    let mut inexact = 0;
    for machine in MACHINES {
        let case = machine.case([1.0, 0.5]);
        for width in [Precision::SINGLE, Precision::DOUBLE] {
            let subject = Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, width);
            for (place, (_, node)) in subject.nodes.iter().enumerate() {
                let Node::Constant(constant) = node else { continue };
                let known = subject.known(place).expect("constants are known");
                let value = Digits::exact(case.program.graph.value(*constant));
                let rounded = Digits::float(width.round(case.program.graph.value(*constant)));
                let error = rounded.sub(&value).to_f64();
                assert!(
                    known.error.low <= error && error <= known.error.high,
                    "{known:?} {error:e}"
                );
                assert!(known.error.magnitude() <= error.abs() * (1.0 + 1e-9), "{known:?}");
                inexact += usize::from(error != 0.0);
            }
        }
    }
    assert!(inexact > 50, "{inexact}");
}

/// A change of a node moves each result by what its adjoint says, with its sign.
#[test]
fn a_change_of_a_node_moves_results_by_its_adjoint() {
    for machine in MACHINES {
        let case = machine.case([1.0, 0.5]);
        let subject =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::DOUBLE);
        for sides in boxes(&case).step_by(5) {
            let values = OneBox::new(&subject, InputBox::new(&sides));
            let backwards =
                Adjoints { subject: &subject, frame: &values.frame, values: &values.values };
            let middle: Vec<f64> = sides.iter().map(|[from, to]| (from + to) / 2.0).collect();
            let adjoints: Vec<_> =
                case.sinks.iter().map(|&sink| backwards.adjoints(sink)).collect();
            for place in 0..subject.nodes.len() {
                const STEP: f64 = 1e-6;
                let [up, down] = [STEP, -STEP]
                    .map(|by| computed::<f64>(&subject, &middle, false, Some((place, by))));
                for (&sink, adjoints) in case.sinks.iter().zip(&adjoints) {
                    let at = subject.place(sink);
                    let slope = (up[at] - down[at]) / (2.0 * STEP);
                    let range =
                        adjoints[place].map_or([0.0; 2], |jet| [jet.range().low, jet.range().high]);
                    // The third derivative of a machine of a metre, times the square of the step, and rounding over
                    // the step.
                    let slack = 1e-7 * (1.0 + slope.abs());
                    assert!(
                        range[0] - slack <= slope && slope <= range[1] + slack,
                        "{}: {:?} at {middle:?}: {slope} is outside {range:?}",
                        machine.name,
                        subject.nodes[place].1
                    );
                }
            }
        }
    }
}
