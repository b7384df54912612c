//! A function passed to `follow` goes on through change points: motions under forces in both widths.

use core::f64::consts::{PI, TAU};
use linkage_core::{Float, Side, SolveError, Tracker};
use linkage_tests::mechanisms::change_points::*;
use linkage_tests::random::{Random, cases};
use linkage_tests::widths::number;

const GRAVITY: f64 = 9.81;

/// q̈ of the pendulum that a parallelogram's crank is.
fn pendulum(q: f64, drive: f64) -> f64 {
    (drive - 3.0 * GRAVITY * q.cos()) * 3.0 / 8.0
}

/// The mode of a parallelogram at an angle.
fn parallel(q: f64) -> Side {
    if q.rem_euclid(TAU) < PI { Side::Left } else { Side::Right }
}

/// The largest error of accelerations, drives and energies, each as a share of v².
fn worst<T: Float>() -> [f64; 3] {
    let mut random = Random::new(7);
    let mut worst = [0.0_f64; 3];
    let count = cases(14, 300);
    for nth in 0..count {
        // From anywhere clear of the change points at 0 and π to anywhere, as close to them as numbers are: one
        // in each part of the distances, so that few are spread as many are.
        let start = random.anywhere(0.3, PI - 0.3) + PI * random.anywhere(0.0, 2.0).floor();
        let part = (nth as f64 + random.anywhere(0.0, 1.0)) / count as f64;
        let distance = 10.0_f64.powf(12.0 * part - 12.0);
        let sign = if random.anywhere(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
        let q = PI * (random.anywhere(0.0, 7.0).floor() - 3.0) + sign * distance;
        let at = |value: f64| number::<T>(value);
        let (q, v, drive) = (at(q), at(8.0), 2.0);
        let solver = HeavyParallelogram::<T> { elbow: parallel(start), ..Default::default() };
        let mut tracker = Tracker::new(solver);
        tracker.position(at(start)).expect("a pose");
        let a = tracker.follow(q, v, |solver, q| solver.forward_dynamics(q, v, at(drive)));
        let a = a.expect("it goes on");
        let f = tracker.follow(q, v, |solver, q| solver.forces(q, v, a)).expect("it goes on");
        let e = tracker.follow(q, v, |solver, q| solver.energy(q, v)).expect("it goes on");
        // State rates are those accelerations behind the rates themselves.
        let rates = tracker.follow(q, v, |solver, q| solver.state_rates([q, v], at(drive)));
        let [first, second] = rates.expect("it goes on");
        assert_eq!(first.value(), 8.0);
        let exact = pendulum(q.value(), drive);
        let errors = [
            (a.value() - exact).abs().max((second.value() - exact).abs()),
            f.AB.drive.value() - drive,
            e.kinetic.value() - 4.0 / 3.0 * 64.0,
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error.abs() / 64.0);
        }
    }
    worst
}

/// At the edge of what is interpolated, w = √(2 near), the rounding of an acceleration is some 16 ε/w³ v²,
/// and what sixteen (`f32`: the same) nodes make of theirs is up to eight times as much, for those at the
/// edge have weights up to that. Energies have no third power, but one less; drives are accelerations by a
/// mass of 8/3. Of 300 motions in each width, which `.ci/nightly` follows whole, an ordinary run has a twentieth.
#[test]
fn second_rates_over_change_points_are_the_pendulums() {
    for (name, found, epsilon, near) in [
        ("f64", worst::<f64>(), f64::EPSILON, 2e-3_f64),
        ("f32", worst::<f32>(), f64::from(f32::EPSILON), 4.8e-3),
    ] {
        let w = (2.0 * near).sqrt();
        let allowed = 8.0 * 16.0 * epsilon / w.powi(3);
        let bounds = [allowed, 3.0 * allowed, allowed * w];
        println!("{name}: {found:?} of {bounds:?}");
        assert!(
            found.iter().zip(bounds).all(|(found, bound)| *found <= bound),
            "{name}: {found:?}"
        );
    }
}

/// Two inputs: a carriage of 3 kg under a pendulum whose bars have 4 kg and their centres, each as the
/// crank or its pin moves them, 3 kg·m from the pivots: [7, −3 s; −3 s, 8/3] q̈ = [3 c v², −3 g c].
#[test]
fn two_inputs_move_through_change_points() {
    let mut tracker = Tracker::new(CarriedParallelogram::new());
    let v = [0.7, 5.0];
    for step in 0..200 {
        let q = [0.2 * f64::from(step), 0.5 + 0.1 * f64::from(step)];
        let a = tracker.follow(q, v, |solver, q| solver.forward_dynamics(q, v, [0.0, 0.0]));
        let a = a.expect("it goes on");
        let (s, c) = q[1].sin_cos();
        let [push, turn] = [3.0 * c * v[1] * v[1], -3.0 * GRAVITY * c];
        let determinant = 7.0 * 8.0 / 3.0 - 9.0 * s * s;
        let expected = [
            (8.0 / 3.0 * push + 3.0 * s * turn) / determinant,
            (7.0 * turn + 3.0 * s * push) / determinant,
        ];
        for (found, expected) in a.into_iter().zip(expected) {
            // 8 · 16 ε/w³ v² as above, and a mass matrix whose determinant is a half of its diagonal's.
            assert!((found - expected).abs() < 1e-8, "{q:?}: {a:?} for {expected}");
        }
        // Next to a change point the tracker's modes are still those before.
        if q[1].sin().abs() > 0.05 {
            assert_eq!(tracker.solver().elbow, parallel(q[1]), "{q:?}");
        }
    }
}

/// On a change point the modes are those of the poses to come: to the left the parallelogram's, to the
/// right the other motion's, whose rocker turns against the crank.
#[test]
fn a_first_pose_on_a_change_point_goes_where_its_rate_leads() {
    for (rate, is_pendulum) in [(-8.0, true), (8.0, false)] {
        let mut tracker = Tracker::new(HeavyParallelogram::new());
        let energy = tracker.follow(PI, rate, |solver, q| solver.energy(q, rate));
        let kinetic = energy.expect("it goes on").kinetic;
        // The rocker adds 1/3 kg·m² at a third of the rate; the coupler adds 2 kg at 1/3 m/s and 2/3 kg·m² at
        // two thirds of the rate.
        let other = 1.0 / 3.0 + 1.0 / 27.0 + 2.0 / 9.0 + 8.0 / 27.0;
        let mass = if is_pendulum { 8.0 / 3.0 } else { other };
        assert!((kinetic / 32.0 - mass).abs() < 1e-8, "{rate}: {} for {mass}", kinetic / 32.0);
    }
}

/// An integrator tries states, and takes some back.
#[test]
fn states_may_be_tried_in_any_order() {
    let mut tracker = Tracker::new(HeavyParallelogram::new());
    tracker.position(1.0).expect("a pose");
    let mut random = Random::new(3);
    for _ in 0..300 {
        let q = random.anywhere(-9.0, 9.0);
        let a = tracker.follow(q, 3.0, |solver, q| solver.forward_dynamics(q, 3.0, 0.0));
        // 1e-8 cannot hide the other assembly, which is off by v² and more.
        assert!((a.expect("it goes on") - pendulum(q, 0.0)).abs() < 1e-8, "{q}");
    }
}

/// A clearance is rounded as the squares of coordinates are, and far away each pose is next to a change
/// point in that sense: what is interpolated must not be what is far from it.
#[test]
fn far_from_the_origin_the_assembly_stays() {
    for far in [30.0, 1000.0] {
        let mut tracker = Tracker::new(CarriedParallelogram::new());
        for step in 0..100 {
            let q = [far, 0.5 + 0.15 * f64::from(step)];
            let motion = tracker.motion(q, [0.7, 5.0], [0.0, 0.0]).expect("it goes on");
            let off = (q[1].cos() - motion.position.DC.cos).abs();
            // A clearance of h² with an error of 16 ε far², or of half the way to a change point.
            let allowed = 1e-7 + (16.0 * f64::EPSILON * far * far).sqrt();
            assert!(off <= allowed, "{q:?}: {off:e} of {allowed:e}");
            let omega = (motion.velocity.DC.omega - 5.0).abs();
            assert!(omega <= 0.1, "{q:?}: {omega:e}");
        }
    }
}

/// An error of the solver is passed on, and the tracker stays where it was.
#[test]
fn a_refusal_is_the_answers_own_and_changes_nothing() {
    let mut tracker = Tracker::new(HeavyParallelogram::new());
    tracker.position(1.0).expect("a pose");
    let refused: Result<f64, _> =
        tracker.follow(4.0, 1.0, |_, _| Err(SolveError::Singular { group: "mine" }));
    assert_eq!(refused, Err(SolveError::Singular { group: "mine" }));
    assert_eq!(tracker.solver().elbow, Side::Left);
    let nan = tracker.follow(f64::NAN, 1.0, |solver, q| solver.forward_dynamics(q, 1.0, 0.0));
    assert!(matches!(nan, Err(SolveError::NotFinite { .. })), "{nan:?}");
    // A constant mode ends the motion, as everywhere.
    let mut constant = Tracker::new(ConstantMode::new());
    constant.position(1.0).expect("a pose");
    let ended = constant.follow(4.0, 1.0, |solver, q| solver.position(q).map(|p| p.DC.cos));
    assert!(matches!(ended, Err(SolveError::Singular { .. })), "{ended:?}");
}
