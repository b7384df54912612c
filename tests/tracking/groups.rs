//! Trackers of every group with an assembly mode, of chains, and of motions that end.

use core::f64::consts::{FRAC_PI_2, PI};
use linkage_core::{Sense, Side, SolveError, Tracker};
use linkage_tests::mechanisms::change_points::*;
use linkage_tests::random::cases;

/// Walks over `span` with steps of different sizes, some of which fall on its middle. The smallest are a fifth as
/// large in `.ci/nightly`.
fn walks(span: [f64; 2], mut walk: impl FnMut(&mut dyn Iterator<Item = f64>)) {
    for count in [2, 3, 4, 7, 40, 101, cases(200, 1000) as u32] {
        let angle = |i: u32| span[0] + (span[1] - span[0]) * f64::from(i) / f64::from(count);
        walk(&mut (0..=count).map(angle));
        walk(&mut (0..=count).rev().map(angle));
    }
}

/// Interpolated from nodes at most 0.1 rad away: a wrong branch is off by about 1.
const ALLOWED: f64 = 1e-8;

#[track_caller]
fn assert_close(found: &[f64], wanted: &[f64], at: f64) {
    for (f, w) in found.iter().zip(wanted) {
        assert!((f - w).abs() <= ALLOWED * w.abs().max(1.0), "{found:?} for {wanted:?} at {at}");
    }
}

/// The slide of crank and rod of one length is 2 cos θ.
#[test]
fn a_rod_passes_the_square_to_its_guide() {
    walks([FRAC_PI_2 - 1.0, FRAC_PI_2 + 1.0], |angles| {
        let mut tracker = None;
        for theta in angles {
            let side = if theta.cos() > 0.0 { Sense::Ahead } else { Sense::Behind };
            let start = || Tracker::new(EqualSliderCrank { side, ..EqualSliderCrank::new() });
            let m = tracker.get_or_insert_with(start).motion(theta, 1.0, 0.0).unwrap();
            let found =
                [m.position.block.slide, m.velocity.block.slide, m.acceleration.block.slide];
            let wanted = [2.0 * theta.cos(), -2.0 * theta.sin(), -2.0 * theta.cos()];
            assert_close(&found, &wanted, theta);
        }
    });
}

/// C = (1 + cos θ, sin θ)/2 + √(4 − sin² θ/2) (cos θ/2, sin θ/2).
#[test]
fn a_kite_passes_over_its_fixed_pin() {
    walks([-1.5, 1.5], |angles| {
        let mut tracker = None;
        for theta in angles {
            let elbow = if theta > 0.0 { Side::Left } else { Side::Right };
            let start = || Tracker::new(TurningKite { elbow, ..TurningKite::new() });
            let m = tracker.get_or_insert_with(start).motion(theta, 1.0, 0.0).unwrap();
            let (s, c) = (theta / 2.0).sin_cos();
            let far = (4.0 - s * s).sqrt();
            let x = (1.0 + theta.cos()) / 2.0 + far * c;
            let y = theta.sin() / 2.0 + far * s;
            let slope = -s * c / 2.0 / far;
            let vx = -theta.sin() / 2.0 + slope * c - far * s / 2.0;
            let vy = theta.cos() / 2.0 + slope * s + far * c / 2.0;
            let found = [m.position.C.x, m.position.C.y, m.velocity.C.x, m.velocity.C.y];
            assert_close(&found, &[x, y, vx, vy], theta);
        }
    });
}

/// The bar stands at θ/2 and the slide is 2 cos θ/2.
#[test]
fn a_block_passes_over_its_bars_pivot() {
    walks([PI - 1.0, PI + 1.0], |angles| {
        let mut tracker = None;
        for theta in angles {
            let side = if theta < PI { Sense::Ahead } else { Sense::Behind };
            let start = || Tracker::new(OverThePivot { side, ..OverThePivot::new() });
            let m = tracker.get_or_insert_with(start).motion(theta, 1.0, 0.0).unwrap();
            let (s, c) = (theta / 2.0).sin_cos();
            let (p, v, a) = (m.position, m.velocity, m.acceleration);
            let found = [p.bar.sin, v.bar.omega, a.bar.alpha];
            assert_close(&found, &[s, 0.5, 0.0], theta);
            let found = [p.block.slide, v.block.slide, a.block.slide];
            assert_close(&found, &[2.0 * c, -s, -c / 2.0], theta);
        }
    });
}

/// With b = (1.5 + cos θ, sin θ) the slide is ± √(b² − 1/4) = ± √3 |cos θ/2|, without the bars.
#[test]
fn a_block_touches_the_limit_of_its_offset() {
    walks([PI - 1.0, PI + 1.0], |angles| {
        let mut tracker = None;
        for theta in angles {
            let side = if theta < PI { Sense::Ahead } else { Sense::Behind };
            let start = || Tracker::new(TouchingOffset { side, ..TouchingOffset::new() });
            let m = tracker.get_or_insert_with(start).motion(theta, 1.0, 0.0).unwrap();
            let (s, c) = (theta / 2.0).sin_cos();
            let root = 6.0_f64.sqrt();
            let (p, v, a) = (m.position.block, m.velocity.block, m.acceleration);
            let found = [p.slide, v.slide, a.block.slide];
            assert_close(&found, &[root * c, -root * s / 2.0, -root * c / 4.0], theta);
        }
    });
}

/// Two groups flat at once, and one behind them that is not: all cranks turn alike.
#[test]
fn groups_change_together_and_what_is_behind_goes_on() {
    walks([PI - 2.0, PI + 2.0], |angles| {
        let mut tracker = None;
        let mut before: Option<([f64; 2], f64)> = None;
        for theta in angles {
            let elbow = if theta < PI { Side::Left } else { Side::Right };
            let start = ThreeCranks { first: elbow, second: elbow, ..ThreeCranks::new() };
            let tracker = tracker.get_or_insert_with(|| Tracker::new(start));
            let m = tracker.motion(theta, 1.0, 0.0).unwrap();
            let (s, c) = theta.sin_cos();
            let (p, v) = (m.position, m.velocity);
            let found = [p.C.x, p.C.y, p.E.x, p.E.y, v.E.x, v.E.y];
            assert_close(&found, &[2.0 + c, s, 4.0 + c, s, -s, c], theta);
            assert_eq!(tracker.solver().third, Side::Left);
            // The rocker goes on without a jump: its acceleration stays below 2.
            if let Some(([x, y], at)) = before {
                let step = (theta - at).abs();
                let moved = (p.H.x - x).hypot(p.H.y - y);
                assert!(moved <= 2.0 * step + 2.0 * step * step, "{moved} at {theta}");
            }
            before = Some(([p.H.x, p.H.y], theta));
        }
    });
}

#[test]
fn a_shared_mode_changes_where_all_its_groups_do() {
    walks([PI - 2.0, PI + 2.0], |angles| {
        let mut tracker = None;
        for theta in angles {
            let elbow = if theta < PI { Side::Left } else { Side::Right };
            let start = || Tracker::new(OneModeForTwo { elbow, ..OneModeForTwo::new() });
            let m = tracker.get_or_insert_with(start).motion(theta, 1.0, 0.0).unwrap();
            let found = [m.position.FE.cos, m.position.FE.sin, m.velocity.FE.omega];
            assert_close(&found, &[theta.cos(), theta.sin(), 1.0], theta);
        }
    });
}

#[test]
fn a_mode_that_cannot_follow_is_named() {
    let mut torn = Tracker::new(TornMode::new());
    assert!(torn.motion(2.0, 1.0, 0.0).is_ok());
    let singular = SolveError::Singular { group: "CE, FE" };
    assert_eq!(torn.motion(4.0, 1.0, 0.0).unwrap_err(), singular);
    let mut behind = Tracker::new(TornBehind::new());
    assert!(behind.motion(2.0, 1.0, 0.0).is_ok());
    let singular = SolveError::Singular { group: "BC, DC" };
    assert_eq!(behind.motion(4.0, 1.0, 0.0).unwrap_err(), singular);
    let mut constant = Tracker::new(ConstantMode::new());
    assert!(constant.position(2.0).is_ok());
    let singular = SolveError::Singular { group: "BC, DC" };
    assert_eq!(constant.position(4.0).unwrap_err(), singular);
    // The tracker stays at the last pose and can go back.
    assert!(constant.position(1.0).is_ok());
}

/// cos θ at which the bars are stretched: 9 + 2.25 − 9 cos θ = 6.25.
fn last_angle() -> f64 {
    (5.0_f64 / 9.0).acos()
}

#[test]
fn the_end_of_a_motion_is_reported() {
    let mut tracker = Tracker::new(StoppingCrank::new());
    let limit = last_angle();
    for theta in [0.5, 0.8, limit - 1e-3, limit - 1e-9] {
        let solved = StoppingCrank::new().motion(theta, 1.0, 0.0).unwrap();
        assert_eq!(tracker.motion(theta, 1.0, 0.0).unwrap(), solved);
    }
    for beyond in [limit + 1e-9, limit + 0.01, 2.0] {
        let missing = StoppingCrank::new().position(beyond).unwrap_err();
        assert_eq!(tracker.motion(beyond, 1.0, 0.0).unwrap_err(), missing);
        assert!(matches!(missing, SolveError::OutOfReach { group: "BC, DC", .. }));
    }
    // Back again, with the same mode.
    let back = tracker.motion(0.7, -1.0, 0.0).unwrap();
    assert_eq!(back, StoppingCrank::new().motion(0.7, -1.0, 0.0).unwrap());
}

/// The crank angles 0.9 and 2π − 0.9 are both reachable; what is between them is not.
#[test]
fn a_gap_between_two_samples_is_not_jumped() {
    let mut tracker = Tracker::new(StoppingCrank::new());
    assert!(tracker.motion(0.9, 1.0, 0.0).is_ok());
    assert!(StoppingCrank::new().position(2.0 * PI - 0.9).is_ok());
    let jump = tracker.motion(2.0 * PI - 0.9, 1.0, 0.0).unwrap_err();
    assert!(matches!(jump, SolveError::OutOfReach { group: "BC, DC", .. }), "{jump}");
    assert!(tracker.motion(-0.9, 1.0, 0.0).is_ok());
}

/// The pin passes by at a distance of 1 = 3 − 2 from the origin, along y = 1: at x = 0 the bars
/// lie on one line, C = (0, −2).
#[test]
fn two_inputs_pass_a_change_point() {
    for count in [2, 3, 9, 40, 333] {
        for elbow in [Side::Left, Side::Right] {
            let mut tracker = Tracker::new(FoldingBars { elbow, ..FoldingBars::new() });
            for i in 0..=count {
                let x = -1.0 + 2.0 * f64::from(i) / f64::from(count);
                let m = tracker.motion([x, 1.0], [1.0, 0.0], [0.0, 0.0]).unwrap();
                let side = if x < 0.0 { elbow } else { elbow.flipped() };
                if x.abs() > 0.05 {
                    let solver = FoldingBars { elbow: side, ..FoldingBars::new() };
                    let solved = solver.motion([x, 1.0], [1.0, 0.0], [0.0, 0.0]).unwrap();
                    assert_eq!(m, solved, "{x}");
                } else {
                    assert!((m.position.C.y + 2.0).abs() < 0.02, "{m:?}");
                }
            }
        }
    }
}

/// A near miss of a change point keeps the mode.
#[test]
fn a_near_miss_is_no_change() {
    for step in [0.01, 0.1, 0.5] {
        let mut tracker = Tracker::new(NearlyFlat::new());
        for i in 0..2000 {
            let theta = 0.3 + step * f64::from(i);
            let solved = NearlyFlat::new().motion(theta, 1.0, 0.0).unwrap();
            assert_eq!(tracker.motion(theta, 1.0, 0.0).unwrap(), solved);
        }
    }
}

/// A single-precision tracker over forty turns: nodes half a radian away, with the rounding of
/// accelerations of 1e-2 there.
#[test]
fn single_precision_follows_as_well() {
    for step in [1.0_f32, 7.3, 30.0] {
        let mut tracker = Tracker::new(Parallelogram::<f32>::default());
        for i in 0..(40.0 * 360.0 / step) as u16 {
            let theta = (20.0 + step * f32::from(i)).to_radians();
            let m = tracker.motion(theta, 1.0, 0.0).unwrap();
            assert!((m.position.DC.sin - theta.sin()).abs() < 1e-3, "{theta}: {m:?}");
            assert!((m.velocity.DC.omega - 1.0).abs() < 1e-2, "{theta}: {m:?}");
        }
    }
}
