//! A pose, a velocity or a derivative is right, or it is refused with the reason: the corners in
//! which random and adversarial numbers found it otherwise.

use linkage_core::{Real, SolveError};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::mechanisms::near_limits::CompensatedRrp;
use linkage_tests::mechanisms::right_or_refused::*;
use linkage_tests::random::{Random, cases};
use linkage_tests::widths::{list, number};

#[track_caller]
fn assert_out_of_reach<P>(answer: Result<P, SolveError>, group: &str, by: f64, epsilon: f64) {
    match answer.map(|_| ()) {
        Err(SolveError::OutOfReach { group: found, by: missing }) => {
            assert_eq!(found, group);
            assert!((missing - by).abs() <= 8.0 * epsilon * by, "{missing:e} for {by:e}");
        }
        other => panic!("{other:?} where {by:e} m are missing"),
    }
}

/// A bar of 10⁻⁷ times what is missing to its guide, so short that both squares underflow.
fn a_tiny_bar_far_from_its_guide<T: Real>(length: f64) {
    let (l, y) = (number::<T>(length), length * 1e7);
    for y in [y, -y] {
        let level = CompensatedRrp { l, e: number(0.0) };
        let driven = DrivenRrp { l, ..Default::default() };
        let by = number::<T>(y).value().abs() - l.value();
        assert_out_of_reach(level.position(list([0.0, y])), "BC, block", by, f64::EPSILON);
        let q = list([0.0, y, 0.0, 0.0, 0.0]);
        assert_out_of_reach(driven.position(q), "BC, block", by, f64::EPSILON);
    }
    // Within reach its square has lost its digits, and that is said; square to its guide it has
    // none, and along it none are needed.
    let driven = DrivenRrp { l, ..Default::default() };
    let within = driven.position(list([0.0, 0.5 * length, 0.0, 0.0, 0.0]));
    assert_eq!(within.map(|_| ()), Err(SolveError::NotFinite { name: "BC, block" }));
    let square = driven.position(list([0.0, length, 0.0, 0.0, 0.0])).unwrap();
    assert_eq!((square.C.x.value(), square.C.y.value()), (0.0, 0.0));
}

#[test]
fn a_tiny_bar_far_from_its_guide_is_out_of_reach() {
    a_tiny_bar_far_from_its_guide::<f64>(1e-190);
    a_tiny_bar_far_from_its_guide::<f32>(1e-30);
    // As they were found.
    let narrow = DrivenRrp { l: 1e-30_f32, ..Default::default() };
    assert!(narrow.position([0.0, 1e-23, 0.0, 0.0, 0.0]).is_err());
    let wide = DrivenRrp { l: 1e-190, ..Default::default() };
    assert!(wide.position([0.0, 1e-170, 0.0, 0.0, 0.0]).is_err());
}

fn distances<T: Real>() {
    let found = Measured::<T>::default();
    // The rounded distances are short by up to an ulp of them more or less.
    let epsilon = 16.0 * T::EPSILON;
    assert_out_of_reach(found.position(list([0.4, 0.5])), "AB", 0.1, epsilon);
    assert_out_of_reach(found.position(list([0.25, 1.5])), "AB", 0.25, epsilon);
    assert_out_of_reach(found.position(list([1.5, 0.25])), "AB", 0.25, epsilon);
    // 10⁻²³ m of a bar of 1 m, where squares underflow in single precision.
    assert_out_of_reach(found.position(list([1e-23, 1e-30])), "AB", 1.0, epsilon);
    for (q, name) in [
        ([-0.6, 0.8], "first"),
        ([0.6, -0.8], "second"),
        ([0.0, 1.0], "first"),
        ([1.0, 0.0], "second"),
    ] {
        let error = SolveError::Invalid { group: "AB", name };
        assert_eq!(found.position(list(q)).map(|_| ()), Err(error));
    }
    // At the limit there is a place and no velocity, and short of it by four units in the last
    // place of the longest length, 4 ε of the bar's 1 m.
    for gap in 0..=16 {
        let q = list([0.5, 0.5 - f64::from(gap) * T::EPSILON / 4.0]);
        let place = found.position(q).unwrap().P;
        assert!((place.x.value() - 0.5).abs() <= 4.0 * T::EPSILON && place.y.value() == 0.0);
        let velocity = found.velocity(q, list([0.1, 0.1]));
        assert_eq!(velocity.map(|_| ()), Err(SolveError::Singular { group: "AB" }));
    }
    assert_out_of_reach(
        found.position(list([0.5, 0.5 - 5.0 * T::EPSILON])),
        "AB",
        5.0 * T::EPSILON,
        f64::EPSILON,
    );
    let v = found.velocity(list([0.6, 0.8]), list([1.0, 0.0])).unwrap();
    // x = (r₁² − r₂² + 1)/2 and x ẋ + y ẏ = r₁ ṙ₁ at (0.36, 0.48).
    assert!((v.P.x.value() - 0.6).abs() <= 8.0 * T::EPSILON, "{v:?}");
    assert!((v.P.y.value() - (0.6 - 0.36 * 0.6) / 0.48).abs() <= 8.0 * T::EPSILON, "{v:?}");
}

/// Distances that do not change leave a velocity at their limit: the point stands on its bar.
fn tuned_distances<T: Real>() {
    let at_limit = Tuned::<T> { first: number(0.5), second: number(0.5), ..Default::default() };
    let v = at_limit.velocity(number(0.0), number(2.0)).unwrap();
    assert_eq!((v.P.x.value(), v.P.y.value()), (0.0, 1.0));
    let negative = Tuned::<T> { second: number(-0.8), ..Default::default() };
    let error = SolveError::Invalid { group: "AB", name: "second" };
    assert_eq!(negative.position(number(0.0)).map(|_| ()), Err(error));
    let short = Tuned::<T> { first: number(0.4), second: number(0.5), ..Default::default() };
    assert_out_of_reach(short.position(number(0.3)), "AB", 0.1, 16.0 * T::EPSILON);
}

/// Moves the number by so many last places of its width.
fn moved<T: Real>(value: f64, ulps: i32) -> f64 {
    let last_place = 2f64.powi(value.abs().log2().floor() as i32) * T::EPSILON;
    value + f64::from(ulps) * last_place
}

/// The sign of (l₁ + l₂)² − d² without rounding: all are whole numbers of 16ths of ε.
fn sign_of_difference<T: Real>(d: f64, l1: f64, l2: f64) -> i32 {
    let whole = |x: f64| (x / (T::EPSILON / 16.0)) as i128;
    let (d, sum) = (whole(d), whole(l1) + whole(l2));
    (sum * sum - d * d).signum() as i32
}

/// Poses within 6 ulp of a toggle: beyond it the pin is on the line and there is no velocity, and
/// directions are of unit length whatever the bars' lengths. A sample of the poses of `.ci/nightly`.
fn at_toggles<T: Real>() {
    let mut random = Random::new(13);
    let (mut beyond, mut within) = (0, 0);
    let poses = cases(4000, 20_000);
    for _ in 0..poses {
        // Coarser than the last place of the sum, so that it is exact.
        let l1 = number::<T>(random.between(0.25, 1.0)).value();
        let l2 = number::<T>(random.between(1.0, 4.0)).value();
        let d = moved::<T>(number::<T>(l1 + l2).value(), random.between(-6.5, 6.5).round() as i32);
        let group = DrivenRrr { l1: number::<T>(l1), l2: number(l2), ..Default::default() };
        let q = list([0.0, 0.0, d, 0.0]);
        let Ok(pose) = group.position(q) else { continue };
        let velocity = group.velocity(q, list([0.0, 0.5, 0.0, 0.0]));
        if sign_of_difference::<T>(d, l1, l2) <= 0 {
            beyond += 1;
            assert_eq!(pose.C.y.value(), 0.0, "{l1:?} {l2:?} {d:?}");
            let singular = Err(SolveError::Singular { group: "BC, DC" });
            assert_eq!(velocity.map(|_| ()), singular, "{l1:?} {l2:?} {d:?}");
        } else {
            within += 1;
            assert!(pose.C.y.value() > 0.0 && velocity.is_ok(), "{l1:?} {l2:?} {d:?}");
        }
    }
    assert!(beyond > poses / 10 && within > poses / 10, "{beyond} {within}");
}

#[test]
fn the_pose_that_was_found_off_the_line_is_on_it() {
    let group = DrivenRrr { l1: 0.5, l2: 4.055085354483839, ..Default::default() };
    let q = [0.0, 0.0, 4.555085354483839, 0.0];
    let beyond = sign_of_difference::<f64>(q[2], group.l1, group.l2);
    let y = group.position(q).unwrap().C.y;
    assert_eq!(y == 0.0, beyond <= 0, "{y:e}");
    assert_eq!(group.velocity(q, [0.0, 0.5, 0.0, 0.0]).is_err(), beyond <= 0);
}

fn unit_error<T: Real>(cos: T, sin: T) -> f64 {
    (cos.value().hypot(sin.value()) - 1.0).abs()
}

/// At both toggles and within 6 ulp of them, in any direction, both bars keep their lengths: a sample of the poses
/// of `.ci/nightly`.
fn unequal_bars<T: Real>(ratio: f64) {
    let mut random = Random::new(7);
    let mut solved = 0;
    let poses = cases(1000, 4000);
    for _ in 0..poses {
        let short = number::<T>(random.between(0.5, 1.0)).value();
        let long = number::<T>(ratio * random.between(0.5, 1.0)).value();
        let turn = random.between(-3.0, 3.0);
        let lengths = if random.between(-1.0, 1.0) < 0.0 { [short, long] } else { [long, short] };
        let reach = if random.between(-1.0, 1.0) < 0.0 { long + short } else { long - short };
        let d = moved::<T>(reach, random.between(-6.5, 6.5).round() as i32);
        let [l1, l2] = lengths.map(number::<T>);
        let group = DrivenRrr { l1, l2, ..Default::default() };
        let q = list([0.0, 0.0, d * turn.cos(), d * turn.sin()]);
        let Ok(pose) = group.position(q) else { continue };
        solved += 1;
        // Some ten roundings on the way from d to a direction.
        let error = unit_error(pose.BC.cos, pose.BC.sin).max(unit_error(pose.DC.cos, pose.DC.sin));
        assert!(error <= 8.0 * T::EPSILON, "{error:e} of {lengths:?} {d} {turn}");
    }
    assert!(solved > poses / 4, "{solved}");
}

fn bars_of_known_lengths<T: Real>() {
    let group = UnequalBars::<T>::default();
    for reach in [1.001, 0.999] {
        for ulps in -6..=6 {
            let d = moved::<T>(number::<T>(reach).value(), ulps);
            let Ok(pose) = group.position(list([d, 0.0])) else { continue };
            let (bc, dc) = (pose.BC, pose.DC);
            let error = unit_error(bc.cos, bc.sin).max(unit_error(dc.cos, dc.sin));
            assert!(error <= 8.0 * T::EPSILON, "{error:e} at {d}");
        }
    }
}

#[test]
fn unequal_bars_keep_their_lengths_at_their_toggles() {
    for ratio in [1.0, 1e3, 1e7] {
        unequal_bars::<f32>(ratio);
        unequal_bars::<f64>(ratio);
    }
    unequal_bars::<f64>(1e12);
}

/// Where a motion touches a limit or passes it, what passes it has no derivative.
#[test]
fn a_jacobian_at_a_limit_is_singular() {
    let bars = SolveError::Singular { group: "BC, DC" };
    let block = SolveError::Singular { group: "block, bar" };
    assert_eq!(Parallelogram::new().coefficients(0.0).map(|_| ()), Err(bars));
    assert_eq!(Parallelogram::new().jacobian(0.0).map(|_| ()), Err(bars));
    assert_eq!(Parallelogram::<f32>::default().jacobian(0.0).map(|_| ()), Err(bars));
    assert_eq!(PassingBlock::new().jacobian(0.0).map(|_| ()), Err(block));
    assert_eq!(PassingBlock::<f32>::default().jacobian(0.0).map(|_| ()), Err(block));
    assert_eq!(TouchingBars::new().jacobian(0.0).map(|_| ()), Err(bars));
    assert_eq!(TouchingBars::<f32>::default().jacobian(0.0).map(|_| ()), Err(bars));
}

/// A group at rest at its limit does not prevent derivatives of the parts that move, but it has no
/// sensitivity.
#[test]
fn a_group_at_rest_at_its_limit_has_a_jacobian_and_no_sensitivity() {
    let jacobian = StandingLimit::new().jacobian(0.5).unwrap();
    let (sin, cos) = 0.5_f64.sin_cos();
    assert_eq!([jacobian[0], jacobian[1]], [0.0; 2]);
    assert!((jacobian[2] + sin).abs() + (jacobian[3] - cos).abs() <= 2.0 * f64::EPSILON);
    let error = SolveError::Singular { group: "BC, DC" };
    assert_eq!(StandingLimit::new().sensitivity(0.5).map(|_| ()), Err(error));
}

in_both_widths! { distances tuned_distances at_toggles bars_of_known_lengths }
