//! Thresholds of small graphs.

pub(crate) mod whole_turns;

use crate::exact::Exact;
use crate::function::Function;
use crate::ir::graph::{Check, Graph, Guard, Id, Node};
pub(crate) use linkage_compiler::lower::ranges::*;

const WIDE: Assumed = Assumed {
    input: 1e60,
    share: 1e-30,
    square: 1e-276,
    normal: 2.3e-308,
    epsilon: 2.3e-16,
    largest: 1e300,
    factor: 1e297,
};

struct Sample {
    graph: Graph,
    angle: Id,
    rate: Id,
}

fn sample() -> Sample {
    let mut graph = Graph::new();
    let angle = graph.push(Node::Input { input: 0, order: 0 });
    let rate = graph.push(Node::Input { input: 0, order: 1 });
    Sample { graph, angle, rate }
}

impl Sample {
    fn number(&mut self, value: f64) -> Id {
        self.graph.constant(Exact::float(value).unwrap())
    }

    fn push(&mut self, node: Node) -> Id {
        self.graph.push(node)
    }

    fn guard(&mut self, value: Id, check: Check) -> Id {
        self.graph.guard(value, Guard { check, group: 0, operands: Vec::new() })
    }

    /// a + b·cos θ.
    fn affine(&mut self, a: f64, b: f64) -> Id {
        let (cos, a, b) =
            (self.push(Node::Apply(Function::Cos, self.angle)), self.number(a), self.number(b));
        let product = self.push(Node::Mul(b, cos));
        self.push(Node::Add(a, product))
    }

    /// True if a value is asked over whole turns.
    fn is_asked_on_some_arc(&self, value: Id) -> bool {
        let values = Values::new(&self.graph, &vec![true; self.graph.len()]);
        let mut sizes = values.thresholds(&WIDE).expect("all is bounded");
        assert!(sizes.0[&value].is_some(), "one interval shows it");
        values.leave_out_those_of_every_arc(&WIDE, &mut sizes, |_| true);
        sizes.0[&value].is_some()
    }

    fn of_angle(&mut self, function: Function, angle: Id, factor: f64) -> Id {
        let (value, factor) = (self.push(Node::Apply(function, angle)), self.number(factor));
        self.push(Node::Mul(factor, value))
    }

    fn sum(&mut self, terms: &[Id]) -> Id {
        let (first, rest) = terms.split_first().expect("terms");
        rest.iter().fold(*first, |sum, &term| self.push(Node::Add(sum, term)))
    }

    fn thresholds(&self, limits: &Assumed) -> Option<Thresholds> {
        Values::new(&self.graph, &vec![true; self.graph.len()])
            .thresholds(limits)
            .map(|(thresholds, _)| thresholds)
    }
}

#[test]
fn what_is_known_to_be_large_is_not_asked() {
    let mut sample = sample();
    let square = sample.affine(3.0, 2.0);
    let sound = sample.guard(square, Check::Square);
    let one = sample.number(1.0);
    sample.push(Node::Div(one, sound));
    assert_eq!(sample.thresholds(&WIDE).unwrap()[&square], None);
}

/// A target's sine may be wrong by a 1024th: 2 + 2 cos may then be -0.00195.
#[test]
fn what_the_own_sine_alone_shows_is_asked() {
    let mut sample = sample();
    for (least, is_asked) in [(0.001, true), (0.003, false)] {
        let square = sample.affine(2.0 + least, 2.0);
        let sound = sample.guard(square, Check::Square);
        let one = sample.number(1.0);
        sample.push(Node::Div(one, sound));
        assert_eq!(sample.thresholds(&WIDE).unwrap()[&square].is_some(), is_asked, "{least}");
    }
}

#[test]
fn a_divisor_that_may_vanish_has_a_threshold_and_a_root_has_not() {
    let mut sample = sample();
    let product = sample.affine(2.0, 2.0);
    let reach = sample.guard(product, Check::ReachCircles);
    let root = sample.push(Node::Apply(Function::Sqrt, reach));
    let loose = Assumed { share: 0.0, ..WIDE };
    assert_eq!(sample.thresholds(&loose).unwrap()[&product], Some(0.0));
    // Behind 1/√x the sign alone is not enough.
    sample.push(Node::Div(root, reach));
    assert!(sample.thresholds(&loose).is_none());
    let threshold = sample.thresholds(&WIDE).unwrap()[&product].unwrap();
    assert!((threshold / 4e-30 - 1.0).abs() < 1e-5, "{threshold}");
}

/// A value that is known to be above zero, and not to be above its threshold.
#[test]
fn what_is_known_to_be_small_alone_is_asked() {
    let mut sample = sample();
    let cosine = sample.push(Node::Apply(Function::Cos, sample.angle));
    let square = sample.push(Node::Mul(cosine, cosine));
    for (least, is_asked) in [(1e-32, true), (1e-28, false)] {
        let least = sample.number(least);
        let sum = sample.push(Node::Add(square, least));
        sample.guard(sum, Check::ReachCircles);
        let threshold = sample.thresholds(&WIDE).unwrap()[&sum];
        assert_eq!(threshold.is_some(), is_asked, "{threshold:?}");
        // The share of a range up to one.
        assert!(threshold.is_none_or(|least| (least / 1e-30 - 1.0).abs() < 1e-5), "{threshold:?}");
    }
    // At zero exactly, where the sign is enough.
    let loose = Assumed { share: 0.0, ..WIDE };
    sample.guard(square, Check::ReachCircles);
    assert_eq!(sample.thresholds(&loose).unwrap()[&square], Some(0.0));
}

/// A choice is what either of the two may be: a root of it has no sign to fear, and a divisor has.
#[test]
fn a_choice_has_the_values_of_both() {
    let mut sample = sample();
    let [low, high] = [(3.0, 2.0), (12.0, 2.0)].map(|(mean, swing)| sample.affine(mean, swing));
    let choice = sample.push(Node::Select([sample.rate, sample.rate, low, high]));
    let ten = sample.number(10.0);
    let rest = sample.push(Node::Sub(ten, choice));
    sample.guard(rest, Check::Positive("l".to_string()));
    // From 10 − 14 to 10 − 1.
    let share = Assumed { share: 1e-3, ..WIDE };
    let threshold = sample.thresholds(&share).unwrap()[&rest].unwrap();
    assert!((threshold / 9e-3 - 1.0).abs() < 1e-5, "{threshold}");
    // From 1 to 14: nothing to ask.
    sample.guard(choice, Check::Square);
    assert_eq!(sample.thresholds(&WIDE).unwrap()[&choice], None);
}

#[test]
fn overflow_is_found_at_the_node_where_it_happens() {
    let mut sample = sample();
    let square = sample.push(Node::Mul(sample.rate, sample.rate));
    assert!(sample.thresholds(&WIDE).is_some());
    let fourth = sample.push(Node::Mul(square, square));
    assert!(sample.thresholds(&WIDE).is_some());
    sample.push(Node::Mul(fourth, square));
    assert!(sample.thresholds(&WIDE).is_none());
}

#[test]
fn a_square_is_not_negative_and_a_product_may_be() {
    let mut sample = sample();
    let sine = sample.push(Node::Apply(Function::Sin, sample.angle));
    let cosine = sample.push(Node::Apply(Function::Cos, sample.angle));
    let square = sample.push(Node::Mul(sine, sine));
    sample.push(Node::Apply(Function::Sqrt, square));
    assert!(sample.thresholds(&WIDE).is_some());
    let product = sample.push(Node::Mul(sine, cosine));
    sample.push(Node::Apply(Function::Sqrt, product));
    assert!(sample.thresholds(&WIDE).is_none());
}

#[test]
fn a_product_that_underflows_is_not_away_from_zero() {
    let mut sample = sample();
    let small = sample.number(1e-20);
    let square = sample.push(Node::Mul(small, small));
    let one = sample.number(1.0);
    sample.push(Node::Div(one, square));
    assert!(sample.thresholds(&WIDE).is_none());
}

#[test]
fn a_parameter_may_be_anything() {
    let mut sample = sample();
    sample.push(Node::Param(0));
    assert!(sample.thresholds(&WIDE).is_none());
}

#[test]
fn a_factor_of_an_exact_product_must_leave_room_to_be_split() {
    let mut sample = sample();
    let (large, small) = (sample.number(1e299), sample.number(1e-290));
    sample.push(Node::Mul(large, small));
    assert!(sample.thresholds(&WIDE).is_some());
    for exact in [Node::MulErr(large, small), Node::Det([small, large, small, small])] {
        let mut graph = sample.graph.clone();
        graph.push(exact);
        assert!(Values::new(&graph, &vec![true; graph.len()]).thresholds(&WIDE).is_none());
    }
}

/// A divisor that is a hypotenuse is bounded by what the fast path asks of it.
#[test]
fn a_hypotenuse_is_at_least_a_share_of_its_largest() {
    let mut sample = sample();
    let (x, y) = (sample.affine(3.0, 2.0), sample.affine(0.0, 1.0));
    let hypotenuse = sample.push(Node::Apply2(Function::Hypot, x, y));
    sample.push(Node::Div(sample.rate, hypotenuse));
    let lengths = |limits: &Assumed| {
        let values = Values::new(&sample.graph, &vec![true; sample.graph.len()]);
        values.thresholds(limits).map(|(_, lengths)| lengths[&hypotenuse])
    };
    // 3 + 2 and 1.
    let least = lengths(&WIDE).expect("10⁶⁰ over 6 · 10⁻³⁰ is no overflow");
    assert!((least / 6e-30 - 1.0).abs() < 1e-5, "{least:e}");
    // The root of the smallest square alone is less than underflow may take from it.
    assert_eq!(lengths(&Assumed { share: 0.0, ..WIDE }), None);
    assert_eq!(lengths(&Assumed { share: 1e-240, ..WIDE }), None);
}

#[test]
fn roundings_are_counted_as_at_run_time() {
    assert_eq!(ROUNDINGS, linkage_core::private::ROUNDINGS);
}

/// Extremes of a sum of a cosine and a sine are found within what a target's sine may be wrong by, whatever the angle at
/// which they lie; a value that fails somewhere is asked.
#[test]
fn an_amplitude_is_known_on_arcs() {
    for (a, b) in [(3.0, 4.0), (-4.0, 3.0), (3.0, -4.0), (-3.0, -4.0), (0.3, 5.0)] {
        let amplitude = f64::hypot(a, b);
        // Both factors times a 1024th, and twice that for arcs of a 1024th of a turn.
        for (mean, is_asked) in [(1.01, false), (1.006, false), (1.0005, true), (0.99, true)] {
            let mut sample = sample();
            let angle = sample.angle;
            let terms = [
                sample.of_angle(Function::Cos, angle, a),
                sample.of_angle(Function::Sin, angle, b),
                sample.number(amplitude * mean),
            ];
            let sum = sample.sum(&terms);
            sample.guard(sum, Check::ReachCircles);
            assert_eq!(sample.is_asked_on_some_arc(sum), is_asked, "{a} {b} {mean}");
        }
    }
}

/// cos q cos r + sin q sin r is the cosine of the difference. More than two inputs are not cut into arcs.
#[test]
fn two_inputs_are_known_on_arcs() {
    for (mean, is_asked) in [(1.5, false), (0.9, true)] {
        let mut sample = sample();
        let (q, r) = (sample.angle, sample.push(Node::Input { input: 1, order: 0 }));
        let products = [Function::Cos, Function::Sin].map(|function| {
            let (x, y) = (sample.of_angle(function, q, 1.0), sample.of_angle(function, r, 1.0));
            sample.push(Node::Mul(x, y))
        });
        let mean = sample.number(mean);
        let sum = sample.sum(&[products[0], products[1], mean]);
        sample.guard(sum, Check::ReachCircles);
        assert_eq!(sample.is_asked_on_some_arc(sum), is_asked, "{mean:?}");
        let third = sample.push(Node::Input { input: 2, order: 0 });
        sample.push(Node::Apply(Function::Cos, third));
        assert!(sample.is_asked_on_some_arc(sum));
    }
}

/// A condition need not hold behind another one where that fails, and the other one is asked.
#[test]
fn what_fails_behind_another_condition_is_not_asked() {
    for (inner, is_asked) in [(0.05, false), (-0.2, true)] {
        let mut sample = sample();
        let first = sample.affine(-0.1, 1.0);
        let reached = sample.guard(first, Check::ReachCircles);
        // cos q + inner, above zero wherever cos q is above 0.1.
        let number = sample.number(0.1 + inner);
        let second = sample.push(Node::Add(reached, number));
        sample.guard(second, Check::Square);
        assert!(sample.is_asked_on_some_arc(first));
        let values = Values::new(&sample.graph, &vec![true; sample.graph.len()]);
        let mut sizes = values.thresholds(&WIDE).expect("all is bounded");
        values.leave_out_those_of_every_arc(&WIDE, &mut sizes, |_| true);
        assert_eq!(sizes.0[&second].is_some(), is_asked, "{inner}");
    }
}

/// The rest that rounding leaves of a constant may lie on either side, whatever the constant's own sign.
#[test]
fn the_rest_of_a_constant_is_asked() {
    for value in [0.1, -0.1] {
        let mut sample = sample();
        let number = sample.number(value);
        let Node::Constant(constant) = sample.graph.node(number) else { panic!("it is constant") };
        let rest = sample.push(Node::Low(constant));
        sample.guard(rest, Check::Square);
        let values = Values::new(&sample.graph, &vec![true; sample.graph.len()]);
        let (thresholds, _) = values.thresholds(&WIDE).expect("all is bounded");
        assert!(thresholds[&rest].is_some(), "{value}");
    }
}
