//! Planted chains of one to ten groups: every group stands on the pin of the one before.
//!
//! Pins are put anywhere near their pivots, the lengths are measured from them, and the solver
//! has to find the pins again. Velocities and accelerations are determined by the chain; that a
//! bar does not stretch says all about them, so they are checked by that: with r the bar and v
//! and a the differences of its ends' velocities and accelerations, v·r = 0 and a·r + v·v = 0.

use linkage_core::Side;
use linkage_tests::mechanisms::chains::*;
use linkage_tests::random::Random;

const POSES: usize = 2000;

struct Plan {
    theta: f64,
    groups: Vec<(f64, f64, Side)>,
    /// C0, C1, …, Cn.
    pins: Vec<[f64; 2]>,
    /// The distance that each pin may have from its plan.
    tolerances: Vec<f64>,
}

fn pivot(group: usize) -> [f64; 2] {
    [2.0 * group as f64, if group % 2 == 1 { 0.5 } else { 0.25 }]
}

fn between(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Pins whose groups are all away from a toggle.
fn plan(random: &mut Random, count: usize) -> Plan {
    let theta = random.between(-3.0, 3.0);
    let start = [0.5 * theta.cos(), 0.5 * theta.sin()];
    let mut plan =
        Plan { theta, groups: vec![], pins: vec![start], tolerances: vec![4.0 * f64::EPSILON] };
    while plan.groups.len() < count {
        let group = plan.groups.len() + 1;
        let (from, pivot) = (plan.pins[group - 1], pivot(group));
        let pin = [pivot[0] + random.between(-1.5, 1.5), pivot[1] + random.between(-1.5, 1.5)];
        let (bar, rocker) = (between(from, pin), between(pivot, pin));
        let (l1, l2) = (bar[0].hypot(bar[1]), rocker[0].hypot(rocker[1]));
        let sin = cross(bar, rocker).abs() / (l1 * l2);
        if l1 < 0.3 || l2 < 0.3 || sin < 0.5 {
            continue;
        }
        let side = if cross(between(from, pivot), bar) > 0.0 { Side::Left } else { Side::Right };
        // The pin moves by at most (what its bars' ends moved and lengths changed) / |sin|; the
        // group adds twenty roundings of half ε of its own coordinates and lengths.
        let own = 10.0 * f64::EPSILON * (l1 + l2 + pivot[0] + from[0].abs() + from[1].abs());
        plan.tolerances.push((plan.tolerances[group - 1] + own) / sin);
        plan.groups.push((l1, l2, side));
        plan.pins.push(pin);
    }
    plan
}

/// The rows of one order as points, C0 first.
fn points(rows: &[f64]) -> Vec<[f64; 2]> {
    rows.chunks(2).map(|point| [point[0], point[1]]).collect()
}

fn assert_rigid(ends: [&[[f64; 2]]; 3], others: [[f64; 2]; 3], pin: usize, slack: f64) {
    let [r, v, a] = [0, 1, 2].map(|order| between(others[order], ends[order][pin]));
    // Two products of differences, each rounded from coordinates up to 22 m and their rates;
    // the rates satisfy equations that were solved with the error of the pose.
    let size = |v: [f64; 2]| v[0].hypot(v[1]);
    let far: [f64; 3] = [0, 1, 2].map(|order| size(ends[order][pin]) + size(others[order]));
    let stretch = dot(v, r).abs();
    let allowed = 8.0 * (f64::EPSILON * far[0] + slack) * far[1];
    assert!(stretch <= allowed, "pin {pin}: {stretch:e} > {allowed:e}");
    let stretch = (dot(a, r) + dot(v, v)).abs();
    let allowed = 8.0 * (f64::EPSILON * far[0] + slack) * (far[2] + far[1] * far[1] / size(r));
    assert!(stretch <= allowed, "pin {pin}: {stretch:e} > {allowed:e}");
}

fn check(plan: &Plan, rows: [&[f64]; 3]) {
    let [places, rates, seconds] = rows.map(points);
    for (pin, planned) in plan.pins.iter().enumerate() {
        let away = between(*planned, places[pin]);
        let allowed = plan.tolerances[pin];
        assert!(away[0].hypot(away[1]) <= allowed, "C{pin} is off by {away:?} > {allowed:e}");
    }
    for pin in 1..plan.pins.len() {
        let ends = [&places[..], &rates, &seconds];
        let zero = [0.0, 0.0];
        let slack = plan.tolerances[pin];
        assert_rigid(ends, [places[pin - 1], rates[pin - 1], seconds[pin - 1]], pin, slack);
        assert_rigid(ends, [pivot(pin), zero, zero], pin, slack);
    }
}

macro_rules! planted_chains {
    ($($test:ident $chain:ident $count:literal)+) => {
        $(#[test]
        fn $test() {
            let mut random = Random::new($count);
            for _ in 0..POSES {
                let plan = plan(&mut random, $count);
                let chain = $chain::planned(&plan.groups);
                let motion = chain.motion(plan.theta, 1.5, -0.75).unwrap();
                let orders =
                    [motion.position.rows(), motion.velocity.rows(), motion.acceleration.rows()];
                check(&plan, [&orders[0], &orders[1], &orders[2]]);
            }
        })+
    };
}

planted_chains! {
    one_group Chain1 1
    two_groups Chain2 2
    three_groups Chain3 3
    four_groups Chain4 4
    five_groups Chain5 5
    six_groups Chain6 6
    seven_groups Chain7 7
    eight_groups Chain8 8
    nine_groups Chain9 9
    ten_groups Chain10 10
}
