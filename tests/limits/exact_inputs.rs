//! Hard poses whose inputs are exact numbers: what the data would lose by rounding is not lost,
//! and a solver that cancels nothing is right to the last places of its results.

use linkage_core::{Real, Side};

use linkage_tests::mechanisms::driven_groups::DrivenRrr;
use linkage_tests::mechanisms::exact_inputs::*;
use linkage_tests::mechanisms::near_limits::CompensatedRrr;
use linkage_tests::tables::hard::{self, Case};

fn case_named(cases: &'static [Case], name: &str) -> &'static Case {
    cases.iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"))
}

/// The side of BD that the truth has its pin on: left where the bars, seen from outside, turn left
/// from the first to the second.
fn side(case: &Case) -> Side {
    let (first, second) = (case.truth[2].0, case.truth[3].0);
    if (second - first).sin() > 0.0 { Side::Left } else { Side::Right }
}

/// Errors in units of ε of the numbers themselves.
fn units(case: &Case, epsilon: f64, found: &[f64]) -> Vec<f64> {
    assert_eq!(case.truth.len(), found.len());
    let pairs = case.truth.iter().zip(found);
    pairs
        .map(|((high, low, _), value)| ((value - high) - low).abs() / (epsilon * high.abs()))
        .collect()
}

macro_rules! bars {
    ($mechanism:ident, $t:ty, $inputs:expr, $elbow:expr) => {{
        let inputs: [$t; 10] = core::array::from_fn(|i| $inputs[i] as $t);
        let [bx, by, dx, dy, l1, l2, vx, vy, ax, ay] = inputs;
        let bars = $mechanism { l1, l2, elbow: $elbow };
        let (rate, second) = ([vx, vy, 0.0, 0.0], [ax, ay, 0.0, 0.0]);
        let m = bars.motion([bx, by, dx, dy], rate, second).unwrap();
        [
            m.position.C.x,
            m.position.C.y,
            m.position.BC.angle(),
            m.position.DC.angle(),
            m.velocity.BC.omega,
            m.velocity.DC.omega,
            m.acceleration.BC.alpha,
            m.acceleration.DC.alpha,
        ]
        .map(Real::value)
    }};
}

/// Roundings of either sign, n of them up to half ε, add up to √(n/12) ε; twice that, for twenty
/// of a position and forty of a velocity. An acceleration multiplies the error of the height by
/// three and adds sixty of its own.
const TO_THE_LAST_PLACES: [f64; 8] = [2.6, 2.6, 2.6, 2.6, 3.7, 3.7, 12.3, 12.3];

#[test]
fn compensated_bars_pay_nothing_for_a_toggle() {
    for case in hard::RRR.iter().filter(|case| case.name.contains("toggle")) {
        let units = units(case, f64::EPSILON, &bars!(CompensatedRrr, f64, case.inputs, side(case)));
        println!("{}: {units:.2?} ε", case.name);
        for (count, allowed) in units.iter().zip(TO_THE_LAST_PLACES) {
            assert!(*count <= allowed, "{}: {units:?}", case.name);
        }
    }
}

#[test]
fn compensated_bars_pay_nothing_in_single_precision() {
    // Inputs that single precision holds, down to the last place of the distance of 5; the truth
    // is the double-precision solver, nine digits better.
    for gap in [0.125, 1.0 / 1024.0, 1.0 / 65536.0, 1.0 / 2097152.0] {
        let rate = [0.3125, 0.6875, 0.0, 0.0];
        let second = [-0.1875, 0.5, 0.0, 0.0];
        let inputs = [0.0, 0.0, 5.0 - gap, 0.0, 3.0, 2.0, rate[0], rate[1], second[0], second[1]];
        let wide = bars!(CompensatedRrr, f64, inputs, Side::Left);
        let narrow = bars!(CompensatedRrr, f32, inputs, Side::Left);
        for ((value, truth), allowed) in narrow.iter().zip(wide).zip(TO_THE_LAST_PLACES) {
            let units = (value - truth).abs() / (f64::from(f32::EPSILON) * truth.abs());
            assert!(units <= allowed, "gap {gap:e}: {narrow:?} for {wide:?}");
        }
    }
}

#[test]
fn compensated_four_bars_lose_what_the_crank_pin_does() {
    let left = hard::FOUR_BAR_LEFT.iter().chain(&*hard::KITE).map(|case| (case, Side::Left));
    for (case, elbow) in left.chain(hard::FOUR_BAR_RIGHT.iter().map(|case| (case, Side::Right))) {
        let [theta, crank, base, rocker, coupler, omega] = case.inputs[..] else { panic!() };
        let bars = CompensatedFourBar { crank, base, rocker, coupler, elbow };
        let m = bars.motion(theta, omega, 0.0).unwrap();
        let (c, v) = (m.position.C, m.velocity);
        let found = [c.x, c.y, v.BC.omega, v.DC.omega, m.acceleration.DC.alpha];
        // The crank pin is rounded once, which is one of the roundings that the case's error is
        // made of, and each result once.
        for ((high, low, achievable), value) in case.truth.iter().zip(found) {
            let error = ((value - high) - low).abs();
            let allowed = achievable + f64::EPSILON * high.abs();
            assert!(error <= allowed, "{}: {value}: {error:e} > {allowed:e}", case.name);
        }
    }
}

#[test]
fn far_from_the_origin_a_group_is_the_same_group() {
    // The coordinates' differences are exact: nothing that is relative may change at all.
    let near = DrivenRrr { l1: 1.5, l2: 1.25, ..DrivenRrr::new() };
    let (rate, second) = ([0.3, 0.7, 0.0, 0.0], [-0.2, 0.5, 0.0, 0.0]);
    let unit = near.motion([0.0, 0.0, 2.0, 0.0], rate, second).unwrap();
    for name in ["ground_offset_1e+06", "ground_offset_9.0072e+15"] {
        let case = case_named(&hard::RRR, name);
        let [_, _, relative @ ..] = bars!(DrivenRrr, f64, case.inputs, side(case));
        assert_eq!(
            relative,
            [
                unit.position.BC.angle(),
                unit.position.DC.angle(),
                unit.velocity.BC.omega,
                unit.velocity.DC.omega,
                unit.acceleration.BC.alpha,
                unit.acceleration.DC.alpha,
            ],
            "{name}"
        );
    }
}

#[test]
fn a_constant_slot_nearly_along_its_rail() {
    // The sine of 0.1 mrad is folded and costs one rounding, although the directions of rail and
    // slot differ by it alone; 0.2 rad and 0.1 mrad are within half an ε of the case's numbers.
    let case = &hard::RPP[0];
    let [_, _, bx, by, vx, vy, ..] = case.inputs[..] else { panic!() };
    let pose = NarrowSlot::new().position([bx, by]).unwrap();
    let rate = NarrowSlot::new().velocity([bx, by], [vx, vy]).unwrap();
    let found = [pose.yoke.slide, pose.block.slide, rate.yoke.slide, rate.block.slide];
    for ((high, low, achievable), value) in case.truth.iter().zip(found) {
        let error = ((value - high) - low).abs();
        assert!(error <= 2.0 * achievable, "{value}: {error:e}");
    }
}

#[test]
fn large_angles_are_reduced_exactly() {
    // The truth used the exact number of a million turns, so the errors must be those of a small
    // angle, a millionth of what rounding the large one would cost.
    let case = case_named(&hard::SLIDER_CRANK, "large_crank_angle");
    let [theta, crank, rod, _, omega] = case.inputs[..] else { panic!() };
    let m = SliderCrank { crank, rod }.motion(theta, omega, 0.0).unwrap();
    let found = [m.position.block.slide, m.velocity.block.slide, m.acceleration.block.slide];
    let slides = Case { name: case.name, inputs: Vec::new(), truth: case.truth[..3].to_vec() };
    // The acceleration adds numbers of either sign to a third of their size.
    for (count, allowed) in units(&slides, f64::EPSILON, &found).into_iter().zip([2.6, 3.7, 13.5]) {
        assert!(count <= allowed, "{count} ε");
    }
}
