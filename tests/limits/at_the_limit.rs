//! At the limit of assembly: short by at most four units in the last place of the group's longest
//! length a pose is assembled with its inner joint on the line of centres and has no velocity;
//! short by more it is refused with the missing distance; inside the limit it is an ordinary
//! pose, however close.
//!
//! All coordinates and lengths here are exact, so what is missing is known exactly.

use linkage_core::{Real, Side, SolveError};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::widths::{list, number};

/// Checks the answers at a pose that is `by` metres short of assembly: a pose without a velocity within four
/// units, a refusal beyond.
#[track_caller]
fn assert_limit<P, V>(
    position: Result<P, SolveError>,
    velocity: Result<V, SolveError>,
    assembled: bool,
    group: &str,
    by: f64,
) -> Option<P> {
    match position {
        Ok(pose) => {
            assert!(assembled, "short by {by:e} and assembled");
            let singular = matches!(velocity, Err(SolveError::Singular { group: g }) if g == group);
            assert!(singular, "short by {by:e} and a velocity");
            Some(pose)
        }
        Err(SolveError::OutOfReach { group: found, by: missing }) => {
            assert!(!assembled, "short by {by:e} and refused by {missing:e}");
            assert_eq!(found, group);
            // The distance is decided in twice the width: what is left is its own rounding.
            assert!((missing - by).abs() <= 4.0 * f64::EPSILON * by, "{missing:e} for {by:e}");
            assert!(velocity.is_err());
            None
        }
        Err(error) => panic!("short by {by:e}: {error}"),
    }
}

/// Outer toggle of bars 1 and 1 with B and D `2 + units` units of 2 apart.
fn outer_toggle<T: Real>() {
    for units in 0..=8 {
        let by = f64::from(units) * 2.0 * T::EPSILON;
        let group = DrivenRrr::<T>::default();
        let q = list([0.0, 0.0, 2.0 + by, 0.0]);
        let rate = list([0.3, 0.7, 0.0, 0.0]);
        let position = group.position(q);
        let velocity = group.velocity(q, rate);
        if let Some(pose) = assert_limit(position, velocity, units <= 4, "BC, DC", by) {
            assert_eq!(pose.C.y.value(), 0.0);
            assert_eq!(pose.BC.sin.value(), 0.0);
            // C halves the line; the line is 2, a rounding or two of it are allowed.
            assert!((pose.C.x.value() - 1.0).abs() <= 4.0 * T::EPSILON);
        }
    }
}

/// The same off the axes: bars 2 and nearly 3 along (3, 4).
fn outer_toggle_off_axis<T: Real>() {
    for units in 0..=8 {
        let by = f64::from(units) * 4.0 * T::EPSILON; // The spacing at 5 is four ε.
        for elbow in [Side::Left, Side::Right] {
            let group = DrivenRrr { l1: number::<T>(2.0), l2: number(3.0 - by), elbow };
            let q = list([0.0, 0.0, 3.0, 4.0]);
            let position = group.position(q);
            let velocity = group.velocity(q, list([0.3, 0.7, 0.0, 0.0]));
            if let Some(pose) = assert_limit(position, velocity, units <= 4, "BC, DC", by) {
                assert!((pose.C.x.value() - 1.2).abs() <= 16.0 * T::EPSILON);
                assert!((pose.C.y.value() - 1.6).abs() <= 16.0 * T::EPSILON);
            }
        }
    }
}

/// √2 apart: the missing distance is not a number of the width, only a wider one tells four
/// units from five.
#[test]
fn irrational_distances_are_decided_exactly() {
    let root = core::f64::consts::SQRT_2; // 0.435 units above √2, which lies between 1 and 2.
    for units in 1..=8 {
        let reach = root - f64::from(units) * f64::EPSILON;
        let by = (f64::from(units) - 0.435_371_5) * f64::EPSILON;
        let group = DrivenRrr { l1: 0.75, l2: reach - 0.75, ..DrivenRrr::new() };
        let q = [0.0, 0.0, 1.0, 1.0];
        let position = group.position(q);
        match position {
            Ok(_) => assert!(units <= 4, "short by {units} − 0.44 units and assembled"),
            Err(SolveError::OutOfReach { by: missing, .. }) => {
                assert!(units > 4, "short by {units} − 0.44 units and refused");
                assert!((missing - by).abs() <= 1.0e-3 * by, "{missing:e} for {by:e}");
            }
            Err(error) => panic!("{error}"),
        }
    }
}

/// Inner toggle of bars 2 and 1, B and D less than 1 apart; the longest length is 2.
fn inner_toggle<T: Real>() {
    for halves in 0..=32 {
        let by = f64::from(halves) * T::EPSILON / 2.0; // The spacing below 1.
        let group = DrivenRrr { l1: number::<T>(2.0), ..Default::default() };
        let q = list([0.0, 0.0, 1.0 - by, 0.0]);
        let position = group.position(q);
        let velocity = group.velocity(q, list([0.3, 0.7, 0.0, 0.0]));
        // Four units of 2 are 8 ε, sixteen halves.
        if let Some(pose) = assert_limit(position, velocity, halves <= 16, "BC, DC", by) {
            assert_eq!(pose.C.y.value(), 0.0);
            assert!((pose.C.x.value() - 2.0).abs() <= 32.0 * T::EPSILON);
        }
    }
}

/// A bar of 1 straight up or down to a guide that it just does not reach.
fn bar_square_to_its_guide<T: Real>() {
    for units in 0..=8 {
        let by = f64::from(units) * T::EPSILON;
        for sign in [1.0, -1.0] {
            let group = DrivenRrp::<T>::default();
            let q = list([0.5, sign * (1.0 + by), 0.0, 0.0, 0.0]);
            let position = group.position(q);
            let velocity = group.velocity(q, list([0.3, 0.0, 0.0, 0.0, 0.0]));
            if let Some(pose) = assert_limit(position, velocity, units <= 4, "BC, block", by) {
                assert_eq!(pose.block.slide.value(), 0.5);
                assert_eq!(pose.BC.cos.value(), 0.0);
            }
        }
    }
}

/// A block whose offset of 1 is more than its distance from the bar's pivot.
fn block_square_to_its_bar<T: Real>() {
    for halves in 0..=16 {
        let by = f64::from(halves) * T::EPSILON / 2.0;
        let group = DrivenRpr { e: number::<T>(1.0), ..Default::default() };
        let q = list([0.0, 1.0 - by, 0.0, 0.0]);
        let position = group.position(q);
        let velocity = group.velocity(q, list([0.3, 0.0, 0.0, 0.0]));
        // Four units of 1 are eight halves.
        if let Some(pose) = assert_limit(position, velocity, halves <= 8, "block, bar", by) {
            assert_eq!(pose.block.slide.value(), 0.0);
            // The bar's direction is scaled by what is missing.
            assert!((pose.bar.cos.value() - 1.0).abs() <= by + 2.0 * T::EPSILON);
        }
    }
}

/// Inside the toggle every pose is an ordinary one, from one unit on.
fn inside_the_toggle<T: Real>() {
    for units in 1..=8 {
        // Below 2 the spacing is ε: the height is √(2² − (2 − short)²)/2.
        let short = f64::from(units) * T::EPSILON;
        let group = DrivenRrr::<T>::default();
        let q = list([0.0, 0.0, 2.0 - short, 0.0]);
        let height = ((4.0 - short) * short).sqrt() / 2.0;
        let pose = group.position(q).unwrap();
        // The square of 2 − short is below 4, where the spacing is 2 ε: next to a difference of
        // 4 short its rounding is a quarter at the worst, an eighth of the height.
        let error = (pose.C.y.value() - height).abs();
        assert!(error <= height / 8.0 / f64::from(units), "{:?} for {height}", pose.C.y);
        let turning = group.velocity(q, list([0.3, 0.7, 0.0, 0.0])).unwrap();
        // ω = w · r₃ / J with w = (−0.3, −0.7), r₃ nearly (−1, h), J = r₂ × r₃ nearly 2 h.
        let omega = 0.3 / (2.0 * height);
        let error = (turning.BC.omega.value() - omega).abs();
        assert!(error <= omega / 4.0 / f64::from(units) + 1.0, "{:?} for {omega}", turning.BC);
    }
}

in_both_widths! {
    outer_toggle
    outer_toggle_off_axis
    inner_toggle
    bar_square_to_its_guide
    block_square_to_its_bar
    inside_the_toggle
}

#[test]
fn derivatives_do_not_exist_at_the_limit() {
    let group = DrivenRrr::new();
    for gap in [0.0, 2.0 * f64::EPSILON] {
        let q = [0.0, 0.0, 2.0 + gap, 0.0];
        assert!(group.position(q).is_ok());
        assert!(matches!(group.motion(q, [0.1; 4], [0.0; 4]), Err(SolveError::Singular { .. })));
        assert!(matches!(group.coefficients(q), Err(SolveError::Singular { .. })));
        assert!(matches!(group.jacobian(q), Err(SolveError::Singular { .. })));
        assert!(matches!(group.sensitivity(q), Err(SolveError::Singular { .. })));
    }
}
