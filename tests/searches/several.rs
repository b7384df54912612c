//! Set-points in intervals that hold several dead points.

use std::f64::consts::TAU;

use linkage_core::find::{Crossing, Search, Trend};
use linkage_core::range::limits;
use linkage_core::{SolveError, Status, Tracker, unwanted};
use linkage_tests::mechanisms::unknowns::{Comb, CombPosition, Press, PressPosition, Reach};
use linkage_tests::random::Random;

use super::set_points::{Width, ram};

const PRESS: [f64; 3] = [0.08, 0.25, 0.03];

/// The angles from −π to π at which the ram is in a place, rising first: by the law of cosines in the
/// triangle of shaft, crank pin and ram's pin.
fn angles(x: f64) -> [f64; 2] {
    let [r, l, e] = PRESS;
    let reach = x.hypot(e);
    let (to, turn) = (e.atan2(x), ((r * r + reach * reach - l * l) / (2.0 * r * reach)).acos());
    [to - turn, to + turn]
}

/// An angle in an interval, of those a turn apart.
fn within(angle: f64, [from, to]: [f64; 2]) -> Vec<f64> {
    (-2..=2).map(|k| angle + TAU * f64::from(k)).filter(|at| from < *at && *at < to).collect()
}

fn over_two_dead_points<T: Width>() {
    let [r, l, e] = PRESS.map(T::of);
    for (of, trend) in [Trend::Rising, Trend::Falling].into_iter().enumerate() {
        for x in [0.2, 0.26, 0.31] {
            let between = [-110.0_f64, 240.0].map(f64::to_radians);
            let search = Search::new(between.map(T::of), trend);
            let root = search.find(|theta| ram([r, l, e, T::of(x)], theta)).expect("in the stroke");
            let expected = within(angles(x)[of], between);
            let at: f64 = root.at.into();
            // The dead points are 0.2 rad away and more: the ram's rounding over 20 mm a radian.
            let near = |expected: &f64| (at - expected).abs() < 100.0 * T::HALF_UNIT;
            assert!(expected.iter().any(near), "{trend:?} {x} {at} {expected:?}");
            assert!(root.evaluations <= 2 * Search::<T>::MOST);
        }
    }
}

#[test]
fn a_press_is_found_over_both_its_dead_points() {
    over_two_dead_points::<f64>();
    over_two_dead_points::<f32>();
}

/// A declaration's unknown between any ends at most a turn apart: a root of its mode is found if there is
/// one, and the other root is named if that is all there is.
#[test]
fn a_press_is_solved_between_any_ends() {
    let mut random = Random::new(41);
    let (mut found, mut named, mut none) = (0, 0, 0);
    for _ in 0..4000 {
        let from = random.anywhere(-4.0, 4.0);
        let between = [from, from + random.anywhere(0.1, TAU - 0.01)];
        let x = random.anywhere(0.175, 0.327);
        let press = Press { from: between[0], to: between[1], ..Press::new() };
        let [rising, falling] = angles(x).map(|angle| within(angle, between));
        match press.position(x) {
            Ok(p) => {
                found += 1;
                assert!(falling.iter().any(|at| (at - p.theta).abs() < 1e-12), "{between:?} {x}");
            }
            Err(SolveError::NoSolution { unknown: "theta", by, unit: "m", other }) => {
                assert!(falling.is_empty() && by > 0.0, "{between:?} {x} {falling:?}");
                match other {
                    Some(Crossing { trend, at }) => {
                        named += 1;
                        assert!(trend == Trend::Rising && (at - rising[0]).abs() < 1e-12);
                    }
                    None => {
                        none += 1;
                        assert!(rising.is_empty(), "{between:?} {x} {rising:?}");
                    }
                }
            }
            other => panic!("{between:?} {x} {other:?}"),
        }
    }
    assert!(found > 1000 && named > 200 && none > 200, "{found} {named} {none}");
}

#[test]
fn what_is_not_found_is_said_in_words() {
    let degrees =
        |from: f64, to: f64| Press { from: from.to_radians(), to: to.to_radians(), ..Press::new() };
    let error = degrees(-110.0, -5.0).position(0.26).unwrap_err().to_string();
    let at = angles(0.26)[0];
    let expected = format!(
        "theta: no falling root between its ends; the equation rises through zero at {at:.2}"
    );
    assert_eq!(error, expected);
    let comb = Comb::new().position(1.002).unwrap_err();
    assert_eq!(comb, SolveError::SeveralDeadPoints { unknown: "theta" });
    let text = "theta: several dead points between the ends; narrow the interval";
    assert_eq!(comb.to_string(), text);
    // Within its reach the comb has forty roots, one of which is found.
    let theta = Comb::new().position(0.5).expect("it rises there").theta;
    assert!(((40.0 * theta).sin() - 0.5).abs() < 1e-13 && (40.0 * theta).cos() > 0.0);
    let mut status = [Status::default(); 3];
    let mut theta = [0.0_f64; 3];
    let out = CombPosition { theta: &mut theta[..], ..unwanted() };
    Comb::new()
        .sweep_position(&[0.5, 1.002, 0.5], out, &mut status, ())
        .expect("slices of one length");
    assert_eq!(status, [Status::Solved, Status::SeveralDeadPoints, Status::Solved]);
    assert!(theta[1].is_nan() && theta[0] == theta[2]);
}

/// Ends that parameters give are asked for their order and distance in every entry point.
#[test]
fn ends_given_by_parameters_are_asked_at_run_time() {
    let between = |from: f64, to: f64| Press { from, to, ..Press::new() };
    let too_wide = SolveError::Invalid { group: "theta", name: "ends of between" };
    let reversed = SolveError::Invalid { group: "theta", name: "width of between" };
    for (from, to, expected) in [
        (0.0, TAU + 1e-9, too_wide),
        (0.0, 1e15, too_wide),
        (-1e30, 1e30, too_wide),
        (1.0, -1.0, reversed),
        (1.0, 1.0, reversed),
    ] {
        let press = between(from, to);
        assert_eq!(press.position(0.26), Err(expected));
        assert_eq!(press.velocity(0.26, 1.0), Err(expected));
        assert_eq!(press.motion(0.26, 1.0, 0.0), Err(expected));
        assert_eq!(press.coefficients(0.26).map(|_| ()), Err(expected));
        assert_eq!(press.jacobian(0.26).map(|_| ()), Err(expected));
        assert_eq!(press.sensitivity(0.26).map(|_| ()), Err(expected));
        assert_eq!(Tracker::new(press).position(0.26), Err(expected));
        assert_eq!(limits(&press, [0.2, 0.3]).map(|_| ()), Err(expected.into()));
        let single = Press::<f32> { from: from as f32, to: to as f32, ..Press::default() };
        let is_turn = to as f32 - from as f32 == TAU as f32;
        assert!(single.position(0.26) == Err(expected) || is_turn, "{from} {to}");
        let (mut status, mut theta) = ([Status::default(); 1], [0.0; 1]);
        let out = PressPosition { theta: &mut theta[..], ..unwanted() };
        press.sweep_position(&[0.26], out, &mut status, ()).expect("slices of one length");
        assert_eq!(status, [Status::Invalid]);
    }
    // A turn, whatever its ends are rounded to.
    for part in 0..40 {
        let from = -4.0 + 0.1 * f64::from(part);
        assert!(between(from, from + TAU).position(0.26).is_ok(), "{from}");
        let from = from as f32;
        let single = Press::<f32> { from, to: from + TAU as f32, ..Press::default() };
        assert!(single.position(0.26).is_ok(), "{from}");
    }
    let text = "theta: the ends of `between` must be at most a turn apart";
    assert_eq!(too_wide.to_string(), text);
    // A slide may go as far as it likes.
    assert!(Reach { to: 1e6 }.position(0.3).is_ok());
    assert_eq!(
        Reach { to: -1.0 }.position(0.3).map(|p| p.s),
        Err(SolveError::Invalid { group: "s", name: "width of between" })
    );
}
