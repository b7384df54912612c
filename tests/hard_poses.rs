//! Poses next to toggles, change points and parallel guides, tiny, huge and far from the origin.
//!
//! Each case says what error rounding its inputs to the solver's width would cost. The inputs are
//! exact here, so a solver may do better; each of its roundings behind the joint costs about as
//! much as one of the inputs', and some eight of a pose's twenty do not cancel. Where forms that
//! are not careful lose digits beyond that, they lose half of them or all: a factor of eight
//! cannot hide it.

mod data {
    pub(crate) mod hard;
}
mod mechanisms {
    pub(crate) mod driven_groups;
    pub(crate) mod hard;
}

use core::f64::consts::PI;
use data::hard::{self, Case};
use linkage_core::{Real, Side, SolveError};
use mechanisms::{driven_groups::*, hard::*};

const ALLOWED: f64 = 8.0;

fn number<T: Real>(value: f64) -> T {
    T::lit(value, value as f32)
}

fn list<T: Real, const N: usize>(values: [f64; N]) -> [T; N] {
    values.map(number)
}

/// Prints every error over what is achievable, then fails on the first that is too large.
#[track_caller]
fn assert_achieved(case: &Case, epsilon: f64, found: &[f64]) {
    assert_eq!(case.truth.len(), found.len());
    let counts: Vec<f64> = case
        .truth
        .iter()
        .zip(found)
        .map(|(&(high, low, achievable), value)| {
            let error = ((value - high) - low).abs();
            // A result cannot be closer than its own last place.
            error / achievable.max(epsilon / 2.0 * high.abs())
        })
        .collect();
    println!("{}: {counts:.2?}", case.name);
    assert!(counts.iter().all(|count| *count <= ALLOWED), "{}: {counts:?}", case.name);
}

/// The side of BD that the truth has its pin on: left where the bars, seen from outside, turn left
/// from the first to the second.
fn side(case: &Case) -> Side {
    let (first, second) = (case.truth[2].0, case.truth[3].0);
    if (second - first).sin() > 0.0 { Side::Left } else { Side::Right }
}

fn two_bars<T: Real>(case: &Case) -> Result<[f64; 8], SolveError> {
    let &[bx, by, dx, dy, l1, l2, vx, vy, ax, ay] = case.inputs else { panic!("{}", case.name) };
    let bars = DrivenRrr { l1: number::<T>(l1), l2: number(l2), elbow: side(case) };
    let (q, rate) = (list([bx, by, dx, dy]), list([vx, vy, 0.0, 0.0]));
    let m = bars.motion(q, rate, list([ax, ay, 0.0, 0.0]))?;
    let found = [
        m.position.C.x,
        m.position.C.y,
        m.position.BC.angle(),
        m.position.DC.angle(),
        m.velocity.BC.omega,
        m.velocity.DC.omega,
        m.acceleration.BC.alpha,
        m.acceleration.DC.alpha,
    ];
    Ok(found.map(|value| value.value()))
}

#[test]
fn rrr_near_toggles_and_across_scales() {
    for case in hard::RRR.iter().filter(|case| case.name != "scale_1e-160") {
        assert_achieved(case, f64::EPSILON, &two_bars::<f64>(case).unwrap());
    }
}

#[test]
fn rrr_in_single_precision() {
    for case in hard::RRR_F32 {
        assert_achieved(case, f64::from(f32::EPSILON), &two_bars::<f32>(case).unwrap());
    }
}

#[test]
fn rrr_far_from_the_origin_is_the_same_group() {
    // The coordinates' differences are exact: what is relative does not suffer at all.
    let far = |name: &str| hard::RRR.iter().find(|case| case.name == name).unwrap();
    let near = DrivenRrr { l1: 1.5, l2: 1.25, ..DrivenRrr::new() };
    let case = far("ground_offset_1e+06");
    let (rate, second) = ([0.3, 0.7, 0.0, 0.0], [-0.2, 0.5, 0.0, 0.0]);
    let unit = near.motion([0.0, 0.0, 2.0, 0.0], rate, second).unwrap();
    for case in [case, far("ground_offset_9.0072e+15")] {
        let found = two_bars::<f64>(case).unwrap();
        assert_eq!(found[2], unit.position.BC.angle(), "{}", case.name);
        assert_eq!(found[3], unit.position.DC.angle(), "{}", case.name);
        assert_eq!(found[4], unit.velocity.BC.omega, "{}", case.name);
        assert_eq!(found[5], unit.velocity.DC.omega, "{}", case.name);
        assert_eq!(found[6], unit.acceleration.BC.alpha, "{}", case.name);
        assert_eq!(found[7], unit.acceleration.DC.alpha, "{}", case.name);
    }
}

#[test]
fn lengths_whose_squares_leave_the_range_are_refused() {
    // (1e-160)² is below the normal numbers: an answer could only be wrong.
    let case = hard::RRR.iter().find(|case| case.name == "scale_1e-160").unwrap();
    assert_eq!(two_bars::<f64>(case), Err(SolveError::NotFinite { name: "BC, DC" }));
    let tiny = 5.0e-324;
    let bars = DrivenRrr { l1: tiny, l2: tiny, ..DrivenRrr::new() };
    // The square is zero: the pivots look as if they coincided.
    let answer = bars.position([0.0, 0.0, tiny, 0.0]);
    assert_eq!(answer, Err(SolveError::Singular { group: "BC, DC" }));
}

macro_rules! four_bar {
    ($mechanism:ident, $case:expr, $elbow:expr) => {{
        let &[theta, crank, base, rocker, coupler, omega] = $case.inputs else { panic!() };
        let bars = $mechanism { crank, base, rocker, coupler, elbow: $elbow };
        bars.motion(theta, omega, 0.0).map(|m| {
            let (c, v) = (m.position.C, m.velocity);
            [c.x, c.y, v.BC.omega, v.DC.omega, m.acceleration.DC.alpha]
        })
    }};
}

fn change_points() -> impl Iterator<Item = (&'static Case, Side)> {
    let left = hard::FOUR_BAR_LEFT.iter().chain(hard::KITE).map(|case| (case, Side::Left));
    left.chain(hard::FOUR_BAR_RIGHT.iter().map(|case| (case, Side::Right)))
}

#[test]
fn four_bars_near_change_points() {
    for (case, elbow) in change_points() {
        match four_bar!(AnyFourBar, case, elbow) {
            Ok(found) => assert_achieved(case, f64::EPSILON, &found),
            // Where rounding the inputs could change a velocity by more than itself, the squares
            // may cancel altogether: the pose is at its limit then, and is there.
            Err(error) => {
                assert_eq!(error, SolveError::Singular { group: "BC, DC" }, "{}", case.name);
                let (velocity, _, achievable) = case.truth[2];
                assert!(achievable > velocity.abs(), "{}", case.name);
                let &[theta, crank, base, rocker, coupler, _] = case.inputs else { panic!() };
                let bars = AnyFourBar { crank, base, rocker, coupler, elbow };
                let c = bars.position(theta).unwrap().C;
                let pose = Case { truth: &case.truth[..2], ..*case };
                assert_achieved(&pose, f64::EPSILON, &[c.x, c.y]);
            }
        }
    }
}

#[test]
fn compensated_four_bars_near_change_points() {
    // With products in twice the width nothing cancels: B is rounded, and no more.
    for (case, elbow) in change_points() {
        assert_achieved(case, f64::EPSILON, &four_bar!(CompensatedFourBar, case, elbow).unwrap());
    }
}

#[test]
fn compensated_bars_pay_nothing_for_a_toggle() {
    // All inputs are exact, so the errors are those of twenty to sixty roundings of the results
    // themselves, however close to the toggle.
    for case in hard::RRR.iter().filter(|case| case.name.contains("toggle")) {
        let &[bx, by, dx, dy, l1, l2, vx, vy, ax, ay] = case.inputs else { panic!() };
        let bars = CompensatedBars { l1, l2, elbow: side(case) };
        let m = bars.motion([bx, by, dx, dy], [vx, vy, 0.0, 0.0], [ax, ay, 0.0, 0.0]).unwrap();
        let found = [
            m.position.C.x,
            m.position.C.y,
            m.position.BC.angle(),
            m.position.DC.angle(),
            m.velocity.BC.omega,
            m.velocity.DC.omega,
            m.acceleration.BC.alpha,
            m.acceleration.DC.alpha,
        ];
        let units: Vec<f64> = case
            .truth
            .iter()
            .zip(found)
            .map(|((high, low, _), value)| {
                ((value - high) - low).abs() / (f64::EPSILON * high.abs())
            })
            .collect();
        println!("{}: {units:.2?} ε", case.name);
        // 2 √(20/12) for positions and 2 √(40/12) for velocities; an acceleration multiplies the
        // error of the height by three and adds 2 √(60/12) of its own.
        for (count, allowed) in units.iter().zip([2.6, 2.6, 2.6, 2.6, 3.7, 3.7, 12.3, 12.3]) {
            assert!(*count <= allowed, "{}: {units:?}", case.name);
        }
    }
}

#[test]
fn nearly_parallel_guides() {
    for case in hard::PRP {
        let &[kx, ky, jx, jy, phi, psi, vx, vy] = case.inputs else { panic!() };
        let (q, rate) = ([kx, ky, phi, jx, jy, psi], [vx, vy, 0.0, 0.0, 0.0, 0.0]);
        let m = DrivenPrp::new().motion(q, rate, [0.0; 6]).unwrap();
        let (p, v) = (m.position, m.velocity);
        assert_achieved(
            case,
            f64::EPSILON,
            &[p.C.x, p.C.y, p.p.slide, p.q.slide, v.p.slide, v.q.slide],
        );
    }
}

#[test]
fn a_slot_nearly_along_its_rail() {
    for case in hard::RPP {
        let &[phi, slot, bx, by, vx, vy, ax, ay] = case.inputs else { panic!() };
        let yoke = DrivenRpp { slot, ..DrivenRpp::new() };
        let rate = [vx, vy, 0.0, 0.0, 0.0];
        let m = yoke.motion([bx, by, 0.0, 0.0, phi], rate, [ax, ay, 0.0, 0.0, 0.0]).unwrap();
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        let found = [p.yoke.slide, p.block.slide, v.yoke.slide, v.block.slide, a.block.slide];
        assert_achieved(case, f64::EPSILON, &found);
    }
}

#[test]
fn a_constant_slot_nearly_along_its_rail() {
    // The same with constants: the sine of 0.1 mrad is folded and costs one rounding, although
    // the angles between axes, slot and rail are all that a solver would otherwise see.
    let case = &hard::RPP[0];
    let &[_, _, bx, by, vx, vy, ..] = case.inputs else { panic!() };
    let rate = NarrowSlot::new().velocity([bx, by], [vx, vy]).unwrap();
    let pose = NarrowSlot::new().position([bx, by]).unwrap();
    let found = [pose.yoke.slide, pose.block.slide, rate.yoke.slide, rate.block.slide];
    let case = Case { truth: &case.truth[..4], ..*case };
    assert_achieved(&case, f64::EPSILON, &found);
}

#[test]
fn a_pin_close_to_its_bars_pivot() {
    for case in hard::RPR {
        let &[bx, by, dx, dy, vx, vy, ax, ay, e] = case.inputs else { panic!() };
        let bar = DrivenRpr { e, ..DrivenRpr::new() };
        let (q, rate) = ([bx, by, dx, dy], [vx, vy, 0.0, 0.0]);
        let motion = bar.motion(q, rate, [ax, ay, 0.0, 0.0]);
        if case.name == "rpr_over_pivot_1e-150" {
            // The squares are normal numbers, 5e-300, but ω² s² needs (1e150)²: in range as well.
            // What leaves the range must say so and never answer wrongly.
            if let Err(error) = motion {
                assert!(matches!(error, SolveError::NotFinite { .. }), "{error:?}");
                continue;
            }
        }
        let m = motion.unwrap();
        let found = [
            m.position.bar.angle(),
            m.velocity.bar.omega,
            m.acceleration.bar.alpha,
            m.position.block.slide,
            m.velocity.block.slide,
            m.acceleration.block.slide,
        ];
        assert_achieved(case, f64::EPSILON, &found);
    }
}

#[test]
fn a_short_crank_and_a_large_angle() {
    for case in hard::SLIDER_CRANK {
        let &[theta, crank, rod, e, omega] = case.inputs else { panic!() };
        let m = AnySliderCrank { crank, rod, e }.motion(theta, omega, 0.0).unwrap();
        let found = [
            m.position.block.slide,
            m.velocity.block.slide,
            m.acceleration.block.slide,
            m.position.BC.angle(),
            m.velocity.BC.omega,
        ];
        assert_achieved(case, f64::EPSILON, &found);
    }
}

#[test]
fn large_angles_are_reduced_exactly() {
    // The large angle's truth used the exact f64; so its errors must be those of a small angle:
    // a millionth of what rounding the large one would cost.
    let case = hard::SLIDER_CRANK.iter().find(|case| case.name == "large_crank_angle").unwrap();
    let &[theta, crank, rod, e, omega] = case.inputs else { panic!() };
    let m = AnySliderCrank { crank, rod, e }.motion(theta, omega, 0.0).unwrap();
    let found = [m.position.block.slide, m.velocity.block.slide, m.acceleration.block.slide];
    for ((high, low, _), value) in case.truth.iter().zip(found) {
        let error = ((value - high) - low).abs() / high.abs();
        assert!(error <= 20.0 * f64::EPSILON, "{value}: {error:e}");
    }
}

#[test]
fn a_double_rocker_reaches_its_limit_angle() {
    // Crank 2.5, coupler 8.4, rocker 5, ground 12.5: published as 105.84048029945892°. The limit
    // angle's condition is 12 rad per unit relative change of the lengths.
    let limit = 1.847_264_863_117_762_8;
    assert!((limit / PI * 180.0 - 105.840_480_299_458_92_f64).abs() < 1.0e-12);
    let bars = AnyFourBar { crank: 2.5, base: 12.5, rocker: 5.0, coupler: 8.4, elbow: Side::Left };
    let step = 100.0 * 12.0 * f64::EPSILON;
    assert!(bars.position(limit - step).is_ok());
    let beyond = bars.position(limit + step);
    assert!(matches!(beyond, Err(SolveError::OutOfReach { group: "BC, DC", .. })), "{beyond:?}");
}
