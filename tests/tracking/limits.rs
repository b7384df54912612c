//! Where a tracker must refuse, and what it counts as a change point.

use core::f64::consts::FRAC_PI_2;
use linkage_core::{Float, Sense, Side, SolveError, Tracker};
use linkage_tests::mechanisms::change_points::*;
use linkage_tests::mechanisms::scaled_change_points::*;
use linkage_tests::random::cases;

/// 92° from one side of the change point at 0 to the other.
#[test]
fn a_step_above_a_quarter_turn_keeps_a_parallelogram() {
    let mut tracker = Tracker::new(Parallelogram::new());
    assert!(tracker.motion(1.5785, 1.0, 0.0).is_ok());
    let m = tracker.motion(-0.0215, 1.0, 0.0).unwrap();
    assert!((m.velocity.DC.omega - 1.0).abs() < 1e-7, "{m:?}");
}

/// Rates at the end of the number's range overflow in an interpolation where they do not alone.
#[test]
fn what_is_interpolated_is_a_number_or_an_error() {
    fn check<T: Float>(rows: Result<[T; 13], SolveError>) {
        match rows {
            Ok(rows) => assert!(rows.iter().all(|row| row.is_finite()), "{rows:?}"),
            Err(error) => assert!(matches!(error, SolveError::NotFinite { .. }), "{error}"),
        }
    }
    fn rows<T: Float>(m: ParallelogramMotion<T>) -> [T; 13] {
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        [
            p.C.x, p.C.y, p.DC.cos, p.DC.sin, v.C.x, v.C.y, v.BC.omega, v.DC.omega, a.C.x, a.C.y,
            a.BC.alpha, a.DC.alpha, p.BC.sin,
        ]
    }
    for elbow in [Side::Left, Side::Right] {
        for second in [4e307, -4e307, f64::MAX, 1e308] {
            let mut wide = Tracker::new(Parallelogram { elbow, ..Parallelogram::new() });
            assert!(wide.motion(-1.6, 1.0, 0.0).is_ok());
            check(wide.motion(0.01, 0.36, second).map(rows));
        }
        for second in [2.808_152_1e38, -1e38, f32::MAX] {
            let mut narrow = Tracker::new(Parallelogram::<f32> { elbow, ..Default::default() });
            assert!(narrow.motion(2.704_713_6, 1.0, 0.0).is_ok());
            check(narrow.motion(3.141_646_9, 1.0, second).map(rows));
        }
    }
}

/// A first pose on a change point, at a rate whose square underflows or overflows.
#[test]
fn a_first_pose_is_a_number_or_an_error() {
    for unit in [0.1, 1.0, 1e-9] {
        for (theta, rate) in [(FRAC_PI_2, 3.2e-165), (3.2e-165, FRAC_PI_2), (FRAC_PI_2, 1e200)] {
            for second in [1e308, -1e308, 1.0] {
                let solver = ScaledSliderCrank { unit, ..ScaledSliderCrank::new() };
                match Tracker::new(solver).motion(theta, rate, second) {
                    Ok(m) => {
                        let (v, a) = (m.velocity, m.acceleration);
                        let rows = [v.C.x, v.C.y, v.BC.omega, a.C.x, a.C.y, a.BC.alpha];
                        assert!(rows.iter().all(|row| row.is_finite()), "{m:?}");
                    }
                    Err(SolveError::NotFinite { .. } | SolveError::Singular { .. }) => {}
                    Err(error) => panic!("{error}"),
                }
            }
        }
    }
}

/// The places of a walk of two turns. Steps of half a degree make one turn, which passes both change points, and
/// both turns in `.ci/nightly`.
fn places(step: f64) -> u32 {
    ((720.0 / step) as u32).min(cases(720, 1440) as u32)
}

/// A parallelogram at a ground of 1000.1, whose bars miss the change point by a part in 10¹⁴ …
/// 10⁻⁹ either way, turns through it as one does.
#[test]
fn a_change_point_missed_by_less_than_counts_is_one() {
    for unit in [1e-9, 500.05, 1e9] {
        for misfit in [-3e-9, -1e-10, -1e-14, 0.0, 1e-14, 1e-12, 1e-10, 3e-9] {
            for step in [0.5_f64, 7.0, 33.0, 91.0, 180.0] {
                let base = 2.0 * unit * (1.0 + misfit);
                let solver = ScaledPairs { unit, base, ..ScaledPairs::new() };
                let mut tracker = Tracker::new(solver);
                for i in 0..places(step) {
                    let theta = (20.0 + step * f64::from(i)).to_radians();
                    let m = tracker.motion(theta, 1.0, 0.0).unwrap_or_else(|error| {
                        panic!("× {unit:e} misfit {misfit:e} step {step}: {theta}: {error}")
                    });
                    assert!(
                        (m.velocity.DC.omega - 1.0).abs() < 1e-2,
                        "× {unit:e} misfit {misfit:e} step {step}: {theta}: {m:?}"
                    );
                }
            }
        }
    }
}

/// Two parallelograms in a row, each of which misses the change point by less than counts, turn
/// through it together.
#[test]
fn two_change_points_missed_by_less_than_counts_are_passed_at_once() {
    for (first, second) in [(-3e-9, 3e-9), (-3e-9, 0.0), (3e-9, -3e-9), (0.0, -3e-9), (3e-9, 3e-9)]
    {
        let grounds = [first, second].map(|misfit| 2.0 * (1.0 + misfit));
        for step in [0.5_f64, 7.0, 33.0, 91.0, 180.0] {
            let [first, second] = grounds;
            let mut tracker = Tracker::new(TwoGrounds { first, second, ..TwoGrounds::new() });
            for i in 0..places(step) {
                let theta = (20.0 + step * f64::from(i)).to_radians();
                let m = tracker
                    .motion(theta, 1.0, 0.0)
                    .unwrap_or_else(|error| panic!("{grounds:?} by {step}: {theta}: {error}"));
                let rates = [m.velocity.DC.omega - 1.0, m.velocity.FE.omega - 1.0];
                // √(misfit) of the bars' angle, over the distance of an interpolation's nodes.
                assert!(
                    rates.iter().all(|rate| rate.abs() < 1e-2),
                    "{grounds:?} by {step}: {theta}: {m:?}"
                );
            }
        }
    }
}

/// A group that turns three times as fast as the crank, and misses its change point by more than
/// counts but so little that the whole gap lies next to the first group's change point, ends the
/// motion there.
#[test]
fn a_gap_beside_a_change_point_ends_the_motion() {
    // The value below the root, (d² − 1)/8, is −misfit/2. It counts as zero down to √ε of its scale of 10/16:
    // misfits of up to 1.9e-8.
    for misfit in [2.2e-8, 3e-8, 4e-8, 1e-7, 1e-6] {
        // Crossed bars: DC turns by −3 where the crank passes 0, and C comes within 1 − 2 misfit of
        // F, which bars of 2 and 1 do not reach.
        let second = 2.0 * (1.0 - misfit);
        let start = TwoGrounds { second, elbow: Side::Left, ..TwoGrounds::new() };
        for knee in [Side::Left, Side::Right] {
            let mut tracker = Tracker::new(TwoGrounds { knee, ..start });
            assert!(tracker.motion(-0.5, 1.0, 0.0).is_ok(), "{misfit}");
            let beyond = tracker.motion(0.5, 1.0, 0.0);
            assert!(beyond.is_err(), "{misfit}: {beyond:?}");
        }
    }
}

/// A first pose on a change point has the modes of the poses to come, on whichever side of the
/// change point rounding has put it.
#[test]
fn a_first_pose_on_a_change_point_looks_ahead() {
    for off in [0.0, 1e-9, -1e-9, 1e-6, -1e-6, 1e-5, -1e-5] {
        for (rate, elbow) in
            [(1.0, Side::Left), (1.0, Side::Right), (-1.0, Side::Left), (-1.0, Side::Right)]
        {
            let solver = Parallelogram { elbow, ..Parallelogram::new() };
            let mut tracker = Tracker::new(solver);
            let first = tracker.motion(FRAC_PI_2 * 2.0 + off, rate, 0.0).unwrap();
            let next = FRAC_PI_2 * 2.0 + rate;
            let (found, wanted) =
                (tracker.motion(next, rate, 0.0).unwrap(), solver.motion(next, rate, 0.0).unwrap());
            let by = found.velocity.DC.omega - wanted.velocity.DC.omega;
            assert!(by.abs() < 1e-12, "{off} at {rate}, {elbow:?}: {first:?}, {found:?}");
        }
    }
}

/// A ground and a crank of a thousand metres that fit their short bars to 2e-9 of themselves, which is
/// 2e-6 of the bars: a change point all the same.
#[test]
fn a_misfit_is_measured_by_all_lengths() {
    for misfit in [-2e-9, -1e-12, 0.0, 1e-12, 2e-9] {
        let base = 1001.0 * (1.0 + misfit);
        let mut bars = Tracker::new(LongCrank { base, ..LongCrank::new() });
        let mut block = Tracker::new(LongCrankPivot { base, ..LongCrankPivot::new() });
        for theta in [-0.002, 0.002] {
            let bars = bars.position(theta);
            assert!(bars.is_ok(), "bars, {misfit:e} at {theta}: {bars:?}");
            let block = block.position(theta);
            assert!(block.is_ok(), "block, {misfit:e} at {theta}: {block:?}");
        }
        assert_eq!(bars.solver().elbow, Side::Right, "{misfit:e}");
        assert_eq!(block.solver().side, Sense::Behind, "{misfit:e}");
    }
}
