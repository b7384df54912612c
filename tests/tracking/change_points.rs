//! A tracker keeps its motion through change points, whatever the steps; a solver keeps its mode.
//!
//! Truth is in closed form: a parallelogram's rocker turns with the crank; an antiparallelogram's
//! (bars 1 and 2) satisfies tan φ/2 = −3 tan θ/2; bars 4, 1, 2 and 3 change their mode at every
//! passage of θ = π. Where the pose is clear of the change point, the tracker's answer is the
//! solver's; next to it, an interpolation's from nodes at most 0.1 rad away with the rounding
//! ε^(1/2)·10 of accelerations there, so that 1e-7 cannot hide a wrong motion (which is off by
//! about 1) nor a kink.

use core::f64::consts::{PI, TAU};
use linkage_core::{Side, Tracker};
use linkage_tests::mechanisms::change_points::*;
use linkage_tests::random::cases;

/// Steps in degrees: whole parts of a turn, which fall on change points, and others.
const STEPS: [f64; 8] = [0.1, 0.7, 1.0, 6.0, 7.3, 10.0, 18.0 / 0.7, 30.0];

/// First samples in degrees: on a change point, half a step off one, and anywhere, so that steps
/// straddle the change points at any share.
fn starts(step: f64) -> [f64; 3] {
    [0.0, step / 2.0, 77.7]
}

/// A thousand turns, as far as a build without optimisation gets in a fifth of a second, and four times as far
/// in `.ci/nightly`; one turn at least, which passes both change points.
fn turns(step: f64) -> f64 {
    let far = 2.5 * cases(1, 4) as f64 * step;
    if cfg!(debug_assertions) { far.clamp(1.0, 1000.0) } else { 1000.0 }
}

/// Calls `check` with every angle of every walk, forward and backward.
fn walks(mut check: impl FnMut(&str, f64, f64, &mut dyn Iterator<Item = f64>)) {
    for step in STEPS {
        for start in starts(step) {
            for sign in [1.0, -1.0] {
                let count = (turns(step) * 360.0 / step) as u32;
                let mut angles =
                    (0..count).map(|i| (start + sign * f64::from(i) * step).to_radians());
                check(&format!("{step}° from {start}°"), start, sign, &mut angles);
            }
        }
    }
}

/// Angle, first and second derivative of an output against the crank's angle.
type Truth = fn(f64) -> [f64; 3];

fn parallelogram(theta: f64) -> [f64; 3] {
    [theta, 1.0, 0.0]
}

fn antiparallelogram(theta: f64) -> [f64; 3] {
    let (s, c) = (theta / 2.0).sin_cos();
    let below = 1.0 + 8.0 * s * s;
    [-2.0 * (3.0 * s).atan2(c), -3.0 / below, 24.0 * s * c / (below * below)]
}

/// The mode of a parallelogram or an antiparallelogram at angles next to `theta`, ahead.
fn mode(truth: Truth, theta: f64, sign: f64) -> Side {
    let upper = (theta + 1e-4 * sign).rem_euclid(TAU) < PI;
    let parallel = truth(1.0)[1] > 0.0;
    if upper == parallel { Side::Left } else { Side::Right }
}

fn follow_bars_equal_in_pairs(truth: Truth) {
    let mut worst = [0.0_f64; 4];
    walks(|walk, start, sign, angles| {
        let elbow = mode(truth, start.to_radians(), sign);
        let mut tracker = Tracker::new(Parallelogram { elbow, ..Parallelogram::new() });
        for theta in angles {
            let (rate, second) = (3.0 * sign, 0.5);
            let motion = tracker.motion(theta, rate, second);
            let motion = motion.unwrap_or_else(|error| panic!("{walk} at {theta}: {error}"));
            let [phi, first, curvature] = truth(theta);
            let rocker = motion.position.DC;
            let errors = [
                rocker.cos - phi.cos(),
                rocker.sin - phi.sin(),
                motion.velocity.DC.omega - first * rate,
                motion.acceleration.DC.alpha - (first * second + curvature * rate * rate),
            ];
            for (worst, error) in worst.iter_mut().zip(errors) {
                assert!(error.abs() <= 1e-7, "{walk} at {theta}: {errors:?}");
                *worst = worst.max(error.abs());
            }
        }
    });
    println!("{worst:?}");
}

#[test]
fn a_parallelogram_stays_one() {
    follow_bars_equal_in_pairs(parallelogram);
}

#[test]
fn an_antiparallelogram_stays_one() {
    follow_bars_equal_in_pairs(antiparallelogram);
}

#[test]
fn bars_4_1_2_3_change_their_mode_every_turn() {
    let mut worst = [0.0_f64; 4];
    walks(|walk, start, sign, angles| {
        let first = Side::Right;
        let elbow = |theta: f64| {
            let passed = ((theta - PI) / TAU).floor() - ((start.to_radians() - PI) / TAU).floor();
            if passed.rem_euclid(2.0) == 0.0 { first } else { first.flipped() }
        };
        let mut tracker = Tracker::new(FourOneTwoThree { elbow: first, ..FourOneTwoThree::new() });
        for theta in angles {
            let motion = tracker.motion(theta, sign, 0.0);
            let motion = motion.unwrap_or_else(|error| panic!("{walk} at {theta}: {error}"));
            let off = (theta - PI).rem_euclid(TAU);
            let off = off.min(TAU - off);
            let (rates, truth) = if off < 1e-9 {
                // ω of coupler and rocker solve a quadratic at the change point: (1 ± √6)/5 and
                // (1 ∓ √(8/3))/5; by symmetry there is no acceleration.
                let side = if elbow(theta - 1e-3) == Side::Left { 1.0 } else { -1.0 };
                let root = 6.0_f64.sqrt();
                ([(1.0 - side * root) / 5.0, (1.0 + side * root * 2.0 / 3.0) / 5.0], None)
            } else {
                let solver = FourOneTwoThree { elbow: elbow(theta), ..FourOneTwoThree::new() };
                let m = solver.motion(theta, 1.0, 0.0).unwrap();
                ([m.velocity.BC.omega, m.velocity.DC.omega], Some(m))
            };
            // The solver's own errors: ε over the square and the cube of the distance, and more.
            let near = 50.0 * f64::EPSILON / (off.max(0.01) * off).min(1.0);
            let allowed = if off < 1e-9 { 1e-8 } else { 1e-8 + near };
            let errors = [
                motion.velocity.BC.omega - sign * rates[0],
                motion.velocity.DC.omega - sign * rates[1],
                truth.map_or(0.0, |m| motion.position.C.x - m.position.C.x),
                truth.map_or(0.0, |m| motion.position.C.y - m.position.C.y),
            ];
            for (worst, error) in worst.iter_mut().zip(errors) {
                assert!(error.abs() <= allowed, "{walk} at {theta}, {off:e} off: {errors:?}");
                *worst = worst.max(error.abs());
            }
        }
    });
    println!("{worst:?}");
}

/// A solver on the same walks: what it answers has its mode, and where it stands on the change
/// point it says so or lies on the line of centres to the last places.
#[test]
fn a_solver_never_leaves_its_mode() {
    walks(|walk, _, _, angles| {
        for theta in angles {
            for (elbow, sign) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
                let pair = Parallelogram { elbow, ..Parallelogram::new() }.position(theta);
                let four = FourOneTwoThree { elbow, ..FourOneTwoThree::new() }.position(theta);
                let (s, c) = theta.sin_cos();
                for (d, pin) in [(2.0, pair.map(|p| p.C)), (4.0, four.map(|p| p.C))] {
                    let pin = pin.unwrap_or_else(|error| panic!("{walk} at {theta}: {error}"));
                    // d − b crossed with C − b: twice the area on the mode's side. Its rounding is
                    // that of products of lengths up to 5.
                    let side = (d - c) * (pin.y - s) + s * (pin.x - c);
                    assert!(sign * side >= -64.0 * f64::EPSILON, "{walk} at {theta}: {side:e}");
                }
            }
        }
    });
}

/// One step from anywhere over the change point to anywhere, and the first pose on it: what comes
/// next to the change point is a matter of rounding alone.
#[test]
fn a_step_may_end_as_near_a_change_point_as_numbers_do() {
    for distance in (0..=17).map(|exponent| 10.0_f64.powi(-exponent)) {
        for (from, to) in [(-1.0, 1.0), (-1.0, -1.0), (-1e-3, 1.0), (1.0, -1.0), (1e-9, 1.0)] {
            let at = PI + distance.min(0.5) * to;
            let elbow = mode(parallelogram, PI + from, 0.0);
            let mut tracker = Tracker::new(Parallelogram { elbow, ..Parallelogram::new() });
            for theta in [PI + from, at, PI + 1.0, at, PI, at, PI - 1.0] {
                let rocker = tracker.motion(theta, 1.0, 0.0).unwrap();
                let [cos, sin] = [rocker.position.DC.cos, rocker.position.DC.sin];
                let turned = (theta.cos() * sin - theta.sin() * cos).abs();
                assert!(turned <= 1e-7, "{from} {distance:e} {to}: {theta}: {rocker:?}");
                let rates = [rocker.velocity.DC.omega - 1.0, rocker.acceleration.DC.alpha];
                assert!(rates.iter().all(|rate| rate.abs() <= 1e-7), "{theta}: {rates:?}");
            }
        }
    }
}
