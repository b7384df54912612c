//! The promise of `numerics compensated;`: where inputs and dimensions are exact numbers, nearness to a limit
//! costs no accuracy.
//!
//! Next to a limit at the share g of the lengths, whatever rounding is not put back changes the
//! root by ε/4g of itself or more: at 1e-12 a thousand million times what is allowed here. The truth
//! is the plain solver on numbers of twice the width, whose own error there is ε²/g; it takes every
//! dimension as a parameter, so that it shares no constant with what is tested.

use linkage_core::{Real, Sense, Side};
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::compensated::*;
use linkage_tests::mechanisms::driven_groups::{DrivenRpr, DrivenRrp, DrivenRrr};
use linkage_tests::mechanisms::near_limits::{CompensatedRrp, CompensatedRrr};
use linkage_tests::random::Random;
use linkage_tests::widths::number;

type Wide = DoubleDouble<false>;

fn wide(value: f64) -> Wide {
    Wide::new(value)
}

/// Tenths, exactly.
fn tenths(count: f64) -> Wide {
    wide(count) / wide(10.0)
}

/// The nearest number of the width.
fn rounded<T: Real>(value: f64) -> f64 {
    number::<T>(value).value()
}

/// Directions and turning of both bars.
struct Bars<T> {
    directions: [T; 4],
    omega: [T; 2],
    alpha: [T; 2],
}

macro_rules! bars {
    ($motion:expr) => {{
        let m = $motion;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        Bars {
            directions: [p.BC.cos, p.BC.sin, p.DC.cos, p.DC.sin],
            omega: [v.BC.omega, v.DC.omega],
            alpha: [a.BC.alpha, a.DC.alpha],
        }
    }};
}

const RATES: [f64; 4] = [0.3125, -0.25, -0.4375, 0.6875];
const SECONDS: [f64; 4] = [0.5, 0.1875, -0.375, 0.25];

/// The truth for bars of these lengths.
fn truth(q: [Wide; 4], [l1, l2]: [Wide; 2], elbow: Side) -> Bars<Wide> {
    let group = DrivenRrr { l1, l2, elbow };
    let (motion, ok) = group.solve_motion(q, RATES.map(wide), SECONDS.map(wide));
    assert!(ok);
    bars!(motion)
}

fn apart(found: f64, truth: Wide) -> f64 {
    ((found - truth.high) - truth.low).abs()
}

/// A direction is (a d ± h d⊥)/l. Next to a limit, S has the roundings of two differences and
/// of three products and, where the lengths are no constants, of the three that make 1/4l₂l₃ twice:
/// eleven of half an ε, half of them in h; five more make h and the direction. Beside it a has six.
const DIRECTION: f64 = 5.5;

#[track_caller]
fn assert_directions<T: Real>(found: [T; 4], truth: &Bars<Wide>) {
    for (found, truth) in found.iter().zip(truth.directions) {
        let units = apart(found.value(), truth) / T::EPSILON;
        assert!(units <= DIRECTION, "{units} ε: {:e} for {:e}", found.value(), truth.high);
    }
}

/// Calls `check` with distances from a limit, from those where rounding would show to the last that
/// the width resolves, and a source of random numbers.
fn near_a_limit<T: Real>(mut check: impl FnMut(f64, &mut Random)) {
    let mut random = Random::new(17);
    let last = if T::EPSILON > 1e-10 { 6 } else { 14 };
    for exponent in 1..=last {
        for _ in 0..40 {
            check(10.0_f64.powi(-exponent), &mut random);
        }
    }
}

/// B anywhere, D at the distance d from it, all rounded.
fn joints<T: Real>(random: &mut Random, d: f64) -> [f64; 4] {
    let (x, y) = (random.anywhere(-1.0, 1.0), random.anywhere(-1.0, 1.0));
    let (sin, cos) = random.anywhere(-3.1, 3.1).sin_cos();
    [x, y, x + d * cos, y + d * sin].map(rounded::<T>)
}

/// The distance of the joints next to the outer or the inner toggle; rounding the joints may move
/// it by twice the last places of their coordinates.
fn distance<T: Real>(random: &mut Random, gap: f64, [l1, l2]: [f64; 2]) -> f64 {
    let away = gap * (l1 + l2) + 16.0 * T::EPSILON;
    if random.anywhere(0.0, 1.0) < 0.5 { l1 + l2 - away } else { (l1 - l2).abs() + away }
}

/// Lengths, and joints whose difference is no number of the width.
fn lengths_to_tune<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let lengths = [random.anywhere(0.3, 1.0), random.anywhere(1.2, 3.0)].map(rounded::<T>);
        let d = distance::<T>(random, gap, lengths);
        let q = joints::<T>(random, d);
        for elbow in [Side::Left, Side::Right] {
            let truth = truth(q.map(wide), lengths.map(wide), elbow);
            let [l1, l2] = lengths.map(number::<T>);
            let group = CompensatedRrr { l1, l2, elbow };
            let motion = group.motion(q.map(number), RATES.map(number), SECONDS.map(number));
            let found = bars!(motion.unwrap());
            assert_directions(found.directions, &truth);
            assert_turning(&found, &truth, lengths);
        }
    });
}

/// ω and α against the size of what they are made of: ω = w·r/J, α = (g + ω² r)·r/J.
fn assert_turning<T: Real>(found: &Bars<T>, truth: &Bars<Wide>, [l1, l2]: [f64; 2]) {
    let [c1, s1, c2, s2] = truth.directions;
    let sine = (c1 * s2 - s1 * c2).high.abs();
    let size = |v: [f64; 4]| (v[2] - v[0]).hypot(v[3] - v[1]);
    // Six roundings of h less make 1/J, to which r adds a direction's and the product three.
    let omega = [l1, l2].map(|l| size(RATES) / (l * sine));
    let forces = size(SECONDS) + omega[0] * omega[0] * l1 + omega[1] * omega[1] * l2;
    let allowed = 3.0 + DIRECTION + 2.0;
    for k in 0..2 {
        let units = apart(found.omega[k].value(), truth.omega[k]) / (T::EPSILON * omega[k]);
        assert!(units <= allowed, "ω: {units} ε");
        // The squares of ω have twice its error, and what is made of them a direction's more.
        let alpha = forces / ([l1, l2][k] * sine);
        let units = apart(found.alpha[k].value(), truth.alpha[k]) / (T::EPSILON * alpha);
        assert!(units <= 3.0 * allowed, "α: {units} ε");
    }
}

fn lengths_that_are_constants<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let d = distance::<T>(random, gap, [0.1, 0.2]);
        let q = joints::<T>(random, d);
        let elbow = Side::Right;
        let truth = truth(q.map(wide), [tenths(1.0), tenths(2.0)], elbow);
        let pose =
            ConstantBars { elbow, ..ConstantBars::<T>::default() }.position(q.map(number)).unwrap();
        let found = [pose.BC.cos, pose.BC.sin, pose.DC.cos, pose.DC.sin];
        assert_directions(found, &truth);
    });
}

fn one_length_to_tune<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let l1 = rounded::<T>(random.anywhere(0.3, 1.0));
        let d = distance::<T>(random, gap, [l1, 0.2]);
        let q = joints::<T>(random, d);
        let truth = truth(q.map(wide), [wide(l1), tenths(2.0)], Side::Left);
        let group = HalfConstantBars { l1: number::<T>(l1), elbow: Side::Left };
        let pose = group.position(q.map(number)).unwrap();
        let found = [pose.BC.cos, pose.BC.sin, pose.DC.cos, pose.DC.sin];
        assert_directions(found, &truth);
    });
}

fn one_coordinate_constant<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let [by, dy] = [0, 1].map(|_| rounded::<T>(random.anywhere(-1.0, 1.0)));
        let d = 0.3_f64.hypot(dy - by);
        // Bars that just span the joints, or of which one just reaches over the other.
        let l1 = rounded::<T>(d * random.anywhere(0.2, 0.8));
        let away = gap * d + 4.0 * T::EPSILON;
        let inner = random.anywhere(0.0, 1.0) < 0.5;
        let l2 = rounded::<T>(if inner { d + l1 - away } else { d - l1 + away });
        let q = [tenths(1.0), wide(by), tenths(4.0), wide(dy)];
        let truth = truth(q, [wide(l1), wide(l2)], Side::Left);
        let [l1, l2] = [l1, l2].map(number::<T>);
        let group = ConstantBreadth { l1, l2, elbow: Side::Left };
        let pose = group.position([by, dy].map(number)).unwrap();
        let found = [pose.BC.cos, pose.BC.sin, pose.DC.cos, pose.DC.sin];
        assert_directions(found, &truth);
    });
}

fn a_cylinder_between_fixed_pivots<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let (d, away) = (0.5_f64.sqrt(), gap + 4.0 * T::EPSILON);
        let inner = random.anywhere(0.0, 1.0) < 0.5;
        let cylinder = if inner { d + 0.4 - away } else { d - 0.4 + away };
        let lift = rounded::<T>(cylinder - 0.2);
        let q = [1.0, 2.0, 8.0, 3.0].map(tenths);
        let truth = truth(q, [wide(lift) + tenths(2.0), tenths(4.0)], Side::Left);
        let pose = Cylinder::<T>::default().position(number(lift)).unwrap();
        let found = [pose.BC.cos, pose.BC.sin, pose.DC.cos, pose.DC.sin];
        assert_directions(found, &truth);

        let arm = rounded::<T>(random.anywhere(0.2, 0.6));
        let cylinder = if inner { d + arm - away } else { d - arm + away };
        let lift = rounded::<T>(cylinder - 0.2);
        let truth = self::truth(q, [wide(lift) + tenths(2.0), wide(arm)], Side::Left);
        let pose = CylinderOnArm { arm: number::<T>(arm) }.position(number(lift)).unwrap();
        let found = [pose.BC.cos, pose.BC.sin, pose.DC.cos, pose.DC.sin];
        assert_directions(found, &truth);
    });
}

in_both_widths! {
    lengths_to_tune
    lengths_that_are_constants
    one_length_to_tune
    one_coordinate_constant
    a_cylinder_between_fixed_pivots
    bars_against_guides
    blocks_at_their_offsets
}

/// The cosine of the bar, X/l, where its foot stands `gap` from the limit: two differences, their
/// product, the root and two roundings more of half an ε, two of them under the root.
const COSINE: f64 = 2.5;

/// A bar's direction against the truth in the guide's axes.
#[track_caller]
fn assert_cosine<T: Real>(found: T, q: [Wide; 5], l: Wide, e: Wide) {
    let group = DrivenRrp { l, e, side: Sense::Ahead };
    let (pose, ok) = group.solve_position(q);
    assert!(ok);
    let truth = pose.BC.cos;
    let units = apart(found.value(), truth) / (T::EPSILON * truth.high.abs());
    assert!(units <= COSINE, "{units} ε: {:e} for {:e}", found.value(), truth.high);
}

fn bars_against_guides<T: Real>() {
    let zero = wide(0.0);
    near_a_limit::<T>(|gap, random| {
        let side = if random.anywhere(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
        let away = |l: f64| side * (l - gap * l - 4.0 * T::EPSILON);
        let bx = rounded::<T>(random.anywhere(-1.0, 1.0));
        // y = e − t, from a guide at 0.1.
        let by = rounded::<T>(0.1 + 0.2 - away(0.3));
        let q = [number(bx), number(by)];
        let pose = ConstantRrp::<T>::default().position(q).unwrap();
        let place = [wide(bx), wide(by), zero, tenths(1.0), zero];
        assert_cosine(pose.BC.cos, place, tenths(3.0), tenths(2.0));

        let e = rounded::<T>(random.anywhere(-1.0, 1.0));
        // The guide runs along −x: its normal is −y, and B's distance 0.1 − y.
        let by = rounded::<T>(0.1 - (e - away(0.3)));
        let pose = HalfConstantRrp { e: number::<T>(e) }.position([bx, by].map(number)).unwrap();
        let place = [-wide(bx), -wide(by), zero, -tenths(1.0), zero];
        assert_cosine(-pose.BC.cos, place, tenths(3.0), wide(e));

        let l = rounded::<T>(random.anywhere(0.3, 2.0));
        let by = rounded::<T>(e - away(l));
        let group = CompensatedRrp { l: number::<T>(l), e: number(e) };
        let pose = group.position([bx, by].map(number)).unwrap();
        assert_cosine(pose.BC.cos, [wide(bx), wide(by), zero, zero, zero], wide(l), wide(e));
    });
}

/// s = √(b² − e²), a difference and a root: half an ε under it and half for itself, with room for
/// the second order.
const SLIDE: f64 = 1.0;

#[track_caller]
fn assert_slide<T: Real>(found: T, q: [Wide; 4], e: Wide) {
    let (pose, ok) = DrivenRpr { e, side: Sense::Ahead }.solve_position(q);
    assert!(ok);
    let truth = pose.block.slide;
    let units = apart(found.value(), truth) / (T::EPSILON * truth.high);
    assert!(units <= SLIDE, "{units} ε: {:e} for {:e}", found.value(), truth.high);
}

fn blocks_at_their_offsets<T: Real>() {
    near_a_limit::<T>(|gap, random| {
        let b = 0.3 + gap * 0.3 + 4.0 * T::EPSILON;
        let (sin, cos) = random.anywhere(-3.1, 3.1).sin_cos();
        let [x, y] = [b * cos, b * sin].map(rounded::<T>);
        let pose = ConstantRpr::<T>::default().position([x, y].map(number)).unwrap();
        assert_slide(pose.block.slide, [x, y, 0.0, 0.0].map(wide), tenths(3.0));

        let e = rounded::<T>(random.anywhere(0.3, 2.0));
        let [dx, dy, bx, by] = joints::<T>(random, e + gap * e + 16.0 * T::EPSILON);
        let q = [bx, by, dx, dy];
        let pose = CompensatedRpr { e: number::<T>(e) }.position(q.map(number)).unwrap();
        assert_slide(pose.block.slide, q.map(wide), wide(e));
    });
}
