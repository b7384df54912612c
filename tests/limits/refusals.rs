//! Bad dimensions and bad inputs: every entry point refuses them and says which.

use linkage_core::{Real, SolveError};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::mechanisms::published::FlyingShear;
use linkage_tests::widths::{list, number};

/// The answers of each entry point that needs no derivative by dual numbers.
macro_rules! answers {
    ($mechanism:expr, $q:expr, $rate:expr, $second:expr) => {{
        let mechanism = $mechanism;
        [
            mechanism.position($q).map(|_| ()),
            mechanism.velocity($q, $rate).map(|_| ()),
            mechanism.motion($q, $rate, $second).map(|_| ()),
            mechanism.coefficients($q).map(|_| ()),
        ]
    }};
}

/// The answers of the entry points by automatic differentiation.
macro_rules! derivatives {
    ($mechanism:expr, $q:expr) => {{
        let mechanism = $mechanism;
        [mechanism.jacobian($q).map(|_| ()), mechanism.sensitivity($q).map(|_| ())]
    }};
}

#[track_caller]
fn assert_all(answers: &[Result<(), SolveError>], expected: SolveError) {
    for answer in answers {
        assert_eq!(*answer, Err(expected));
    }
}

const STILL: [f64; 4] = [0.0; 4];
const APART: [f64; 4] = [0.0, 0.0, 1.5, 0.0];

/// A length of zero or less is invalid, by name; one that is not finite is reported as that.
fn bad_lengths<T: Real>() {
    let rrr =
        |l1: f64, l2: f64| DrivenRrr { l1: number::<T>(l1), l2: number(l2), ..Default::default() };
    let still = list(STILL);
    for bad in [0.0, -0.0, -1.0, -1.0e-30] {
        for (group, name) in [(rrr(bad, 1.0), "l1"), (rrr(1.0, bad), "l2"), (rrr(bad, bad), "l1")] {
            let expected = SolveError::Invalid { group: "BC, DC", name };
            assert_all(&answers!(group, list(APART), still, still), expected);
        }
        let group = DrivenRrp { l: number::<T>(bad), ..Default::default() };
        let expected = SolveError::Invalid { group: "BC, block", name: "l" };
        let (q, still) = (list([0.0, 0.5, 0.0, 0.0, 0.0]), list([0.0; 5]));
        assert_all(&answers!(group, q, still, still), expected);
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (group, name) in [(rrr(bad, 1.0), "l1"), (rrr(1.0, bad), "l2"), (rrr(bad, bad), "l1")] {
            let expected = SolveError::NotFinite { name };
            assert_all(&answers!(group, list(APART), still, still), expected);
        }
    }
}

/// An offset may be anything finite.
fn bad_offsets<T: Real>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let expected = SolveError::NotFinite { name: "e" };
        let group = DrivenRrp { e: number::<T>(bad), ..Default::default() };
        let (q, still) = (list([0.0, 0.5, 0.0, 0.0, 0.0]), list([0.0; 5]));
        assert_all(&answers!(group, q, still, still), expected);
        let group = DrivenRpr { e: number::<T>(bad), ..Default::default() };
        assert_all(&answers!(group, list(APART), list(STILL), list(STILL)), expected);

        let expected = SolveError::NotFinite { name: "e2" };
        let group = DrivenPrp { e2: number::<T>(bad), ..Default::default() };
        let (q, still) = (list([0.0, 0.0, 0.0, 1.0, 0.0, 1.0]), list([0.0; 6]));
        assert_all(&answers!(group, q, still, still), expected);
        let group = DrivenRpp { e2: number::<T>(bad), ..Default::default() };
        let (q, still) = (list([0.0, 0.5, 0.0, 0.0, 0.0]), list([0.0; 5]));
        // Velocities and coefficients do not depend on where the slot stands in the yoke.
        let [position, _, motion, _] = answers!(group, q, still, still);
        assert_all(&[position, motion], expected);
        let group = DrivenRpp { slot: number::<T>(bad), ..Default::default() };
        assert_all(&answers!(group, q, still, still), SolveError::NotFinite { name: "slot" });
    }
}

/// An input that is not a finite number is named.
fn bad_inputs<T: Real>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (place, name) in ["bx", "by", "dx", "dy"].into_iter().enumerate() {
            let mut q = APART;
            q[place] = bad;
            let answers = answers!(DrivenRrr::<T>::default(), list(q), list(STILL), list(STILL));
            assert_all(&answers, SolveError::NotFinite { name });
        }
        let shear = FlyingShear::<T>::default();
        let still = number(0.0);
        let expected = SolveError::NotFinite { name: "theta" };
        assert_all(&answers!(shear, number(bad), still, still), expected);

        // A rate that is not finite is to blame for what has rates; the pose is there.
        let rate = shear.velocity(number(1.0), number(bad));
        assert!(matches!(rate, Err(SolveError::NotFinite { name }) if name.contains("theta")));
        let second = shear.motion(number(1.0), number(1.0), number(bad));
        assert!(matches!(second, Err(SolveError::NotFinite { name }) if name.contains("theta")));

        let at = |cos: f64, sin: f64| {
            let (cos, sin) = (number::<T>(cos), number(sin));
            [
                shear.position_at(cos, sin).map(|_| ()),
                shear.velocity_at(cos, sin, number(1.0)).map(|_| ()),
                shear.motion_at(cos, sin, number(1.0), number(0.0)).map(|_| ()),
            ]
        };
        for answer in at(bad, 0.0).into_iter().chain(at(0.0, bad)) {
            assert!(matches!(answer, Err(SolveError::NotFinite { .. })), "{answer:?}");
        }
    }
}

/// A rate may be finite and its square not.
fn overflowing_rates<T: Real>(huge: f64) {
    let shear = FlyingShear::<T>::default();
    let (theta, omega) = (number::<T>(1.0), number::<T>(huge));
    let rate = shear.velocity(theta, omega).unwrap();
    assert!(rate.blade.x.value().is_finite() && rate.blade.x.value() != 0.0);
    let motion = shear.motion(theta, omega, number(0.0));
    assert!(matches!(motion, Err(SolveError::NotFinite { .. })), "{motion:?}");
}

/// Dimensions that together leave the width's range are refused, not answered with infinities.
fn overflowing_lengths<T: Real>(huge: f64) {
    let far = DrivenRrr { l1: number::<T>(huge), l2: number(huge), ..Default::default() };
    let q = list([0.0, 0.0, huge, 0.0]);
    for answer in answers!(far, q, list(STILL), list(STILL)) {
        assert!(matches!(answer, Err(SolveError::NotFinite { .. })), "{answer:?}");
    }
}

#[track_caller]
fn assert_out_of_reach(answers: &[Result<(), SolveError>], group: &str, by: f64, slack: f64) {
    for answer in answers {
        match *answer {
            Err(SolveError::OutOfReach { group: found, by: missing }) => {
                assert_eq!(found, group);
                assert!((missing - by).abs() <= slack, "{missing} for {by}");
            }
            ref other => panic!("{other:?}"),
        }
    }
}

/// Out of reach: the group and how much is missing. All numbers here are exact in both widths,
/// the distance is one rounding away from exact.
fn out_of_reach<T: Real>() {
    let still = list(STILL);
    let slack = 4.0 * T::EPSILON;
    let rrr = |l1: f64, q: [f64; 4]| {
        let bars = DrivenRrr { l1: number::<T>(l1), ..Default::default() };
        answers!(bars, list(q), still, still)
    };
    assert_out_of_reach(&rrr(1.0, [0.0, 0.0, 3.0, 0.0]), "BC, DC", 1.0, slack);
    assert_out_of_reach(&rrr(1.0, [-3.0, 0.0, 0.0, 4.0]), "BC, DC", 3.0, slack);
    assert_out_of_reach(&rrr(3.0, [0.0, 0.0, 0.0, 0.5]), "BC, DC", 1.5, slack);
    assert_out_of_reach(&rrr(2.0, [0.5, 0.5, 0.5, 0.5]), "BC, DC", 1.0, slack);

    let (rest, q) = (list([0.0; 5]), list([0.0, 1.5, 0.0, 0.0, 0.0]));
    let answers = answers!(DrivenRrp::<T>::default(), q, rest, rest);
    assert_out_of_reach(&answers, "BC, block", 0.5, slack);

    let bar = DrivenRpr { e: number::<T>(2.0), ..Default::default() };
    let answers = answers!(bar, list([3.0, 0.0, 3.0, 1.0]), still, still);
    assert_out_of_reach(&answers, "block, bar", 1.0, slack);
}

/// A pose whose group is undetermined is singular in every entry point, the position's too.
fn undetermined<T: Real>() {
    let still = list(STILL);
    let together = list([0.25, 0.5, 0.25, 0.5]);
    let answers = answers!(DrivenRrr::<T>::default(), together, still, still);
    assert_all(&answers, SolveError::Singular { group: "BC, DC" });

    let answers = answers!(DrivenRpr::<T>::default(), together, still, still);
    assert_all(&answers, SolveError::Singular { group: "block, bar" });

    for turns in [[0.5, 0.5], [-1.25, -1.25]] {
        let (q, rest) = (list([0.0, 0.0, turns[0], 1.0, 0.0, turns[1]]), list([0.0; 6]));
        let answers = answers!(DrivenPrp::<T>::default(), q, rest, rest);
        assert_all(&answers, SolveError::Singular { group: "p, q" });
    }

    let along = DrivenRpp { slot: number::<T>(0.0), ..Default::default() };
    let (q, rest) = (list([0.5, 0.5, 0.0, 0.0, 0.25]), list([0.0; 5]));
    let answers = answers!(along, q, rest, rest);
    assert_all(&answers, SolveError::Singular { group: "block, yoke" });
}

in_both_widths! {
    bad_lengths
    bad_offsets
    bad_inputs
    overflowing_rates(1.0e200, 1.0e30)
    overflowing_lengths(1.0e200, 1.0e30)
    out_of_reach
    undetermined
}

/// Jacobians and sensitivities refuse for the same reasons; they exist for `f32` and `f64` alone.
macro_rules! derivatives_refuse {
    ($($width:ident $test:ident)+) => {$(
        #[test]
        fn $test() {
            type Bars = DrivenRrr<$width>;
            let bars = |l1: $width| Bars { l1, ..Bars::default() };
            let apart = APART.map(|x| x as $width);
            let invalid = SolveError::Invalid { group: "BC, DC", name: "l1" };
            assert_all(&derivatives!(bars(0.0), apart), invalid);
            assert_all(&derivatives!(bars(-1.0), apart), invalid);
            let unknown = SolveError::NotFinite { name: "l1" };
            assert_all(&derivatives!(bars($width::NAN), apart), unknown);
            assert_all(&derivatives!(bars($width::INFINITY), apart), unknown);
            let unknown = SolveError::NotFinite { name: "dx" };
            assert_all(&derivatives!(bars(1.0), [0.0, 0.0, $width::NAN, 0.0]), unknown);
            let far = derivatives!(bars(1.0), [0.0, 0.0, 3.0, 0.0]);
            assert_out_of_reach(&far, "BC, DC", 1.0, 4.0 * f64::from($width::EPSILON));
            let singular = SolveError::Singular { group: "BC, DC" };
            assert_all(&derivatives!(bars(1.0), [0.0; 4]), singular);
        }
    )+};
}

derivatives_refuse! { f32 single_derivatives f64 double_derivatives }
