//! Tests of `lower/unique_root`.

use crate::function::Function;
use crate::ir::graph::{GuardId, Id, Node};
use crate::lower::interval::Interval;
pub(crate) use linkage_compiler::lower::unique_root::*;

/// The walk over a slope, in pieces of these signs, and of its curvature.
fn walk(pieces: &[(Option<bool>, Option<bool>)]) -> bool {
    let walk = |course: SlopeCourse, &(slope, grows): &(Option<bool>, Option<bool>)| {
        course.after(slope, grows)
    };
    pieces.iter().try_fold(SlopeCourse::Before, walk).is_some()
}

#[test]
fn one_stretch_of_the_trend_is_one_root() {
    let [plus, minus] = [true, false].map(|sign| (Some(sign), None));
    let [grows, falls] = [true, false].map(|sign| (None, Some(sign)));
    let unknown = (None, None);
    for one in [
        &[plus, plus][..],
        &[minus, minus],
        &[minus, grows, grows, plus, falls, falls, minus],
        &[falls, minus, falls],
        &[grows, falls],
    ] {
        assert!(walk(one), "{one:?}");
    }
    for several in [
        &[plus, minus, plus][..],
        &[plus, falls, grows, plus],
        &[plus, falls, plus],
        &[plus, minus, grows],
        &[minus, unknown, minus],
        &[falls, grows],
    ] {
        assert!(!walk(several), "{several:?}");
    }
}

#[test]
fn intervals_hold_what_they_are_made_of() {
    let holds = |x: Interval, value: f64| x.low <= value && value <= x.high;
    for (a, b) in [(-0.3, 0.2), (0.1, 0.4), (-2.0, -1.9), (0.0, 1.0)] {
        let x = Interval::of(a, b);
        for part in [0.0, 0.3, 0.5, 1.0] {
            let at = a + part * (b - a);
            assert!(holds(x.squared().widened(), at * at) && holds(x.times(x).widened(), at * at));
            assert!(holds(x.wave(f64::sin, f64::cos), at.sin()));
            assert!(holds(x.wave(f64::cos, f64::sin), at.cos()));
            assert!(x.reciprocal().is_none_or(|inverse| holds(inverse.widened(), 1.0 / at)));
            assert!(x.root().is_none_or(|root| holds(root.widened(), at.sqrt())));
        }
    }
    // The rounded number is off by up to half a unit in its last place, to either side.
    let [a, b] = [0.1, 0.7].map(Interval::point);
    for (interval, rounded) in [
        (a.plus(b).widened(), 0.1 + 0.7),
        (a.times(b).widened(), 0.1 * 0.7),
        (b.squared().widened(), 0.7 * 0.7),
        (b.reciprocal().expect("it is not zero").widened(), 1.0 / 0.7),
        (b.root().expect("it is above zero").widened(), 0.7_f64.sqrt()),
        (Interval::around(0.1), 0.1),
    ] {
        assert!(interval.low < rounded && rounded < interval.high, "{interval:?}");
    }
    let unsigned = Interval::of(-1.0, 1.0);
    assert!(unsigned.reciprocal().is_none() && unsigned.root().is_none());
    let infinite = Interval::of(0.0, f64::INFINITY).times(Interval::of(0.0, 1.0));
    assert!(infinite.sign().is_none());
}

/// Every operation of the graph, on intervals whose ends are sums of few powers of two.
#[test]
fn operations_of_the_graph_are_those_of_intervals() {
    let given =
        [(0.25, 0.5), (-2.0, -1.5), (3.0, 3.25), (-0.5, 0.125)].map(|(a, b)| Interval::of(a, b));
    let values = given.map(Some);
    let [a, b, c, d] = [0, 1, 2, 3].map(Id);
    for (node, [low, high]) in [
        (Node::Trial(0), [10.0, 11.0]),
        (Node::Guard(a, GuardId(0)), [0.25, 0.5]),
        (Node::Neg(a), [-0.5, -0.25]),
        (Node::Add(a, b), [-1.75, -1.0]),
        (Node::Sub(a, b), [1.75, 2.5]),
        (Node::Sub(b, a), [-2.5, -1.75]),
        (Node::Mul(a, b), [-1.0, -0.375]),
        (Node::Mul(d, d), [0.0, 0.25]),
        (Node::Fused(a, b, c), [2.0, 2.875]),
        (Node::Det([a, b, c, d]), [-1.406_25, 1.25]),
        (Node::Div(a, c), [0.25 / 3.25, 0.5 / 3.0]),
        (Node::Apply(Function::Sqrt, a), [0.5, 0.5_f64.sqrt()]),
        (Node::MulErr(a, b), [0.0, 0.0]),
    ] {
        let found = value(&values, node, Interval::of(10.0, 11.0)).expect("it is known");
        // Each of at most three operations widens by an ulp of at most four.
        let is_close = |found: f64, end: f64| (found - end).abs() <= 12.0 * f64::EPSILON;
        assert!(found.low <= low && high <= found.high, "{node:?}: {found:?}");
        assert!(is_close(found.low, low) && is_close(found.high, high), "{node:?}: {found:?}");
    }
    assert!(value(&values, Node::Apply(Function::Tan, a), Interval::point(0.0)).is_none());
}
