//! Laws that friction obeys in every machine.

use linkage_core::{Record, SolveError, Status};
use linkage_tests::mechanisms::friction::*;
use linkage_tests::random::{Random, cases};
use num_dual::{Dual2_64, Dual64};

/// Every kind of group, one draw of a state and of the friction.
fn drawn(random: &mut Random, mu: f64) -> (RubbingGroups, [f64; 4]) {
    let mut draw = |from: f64, to: f64| random.between(from, to);
    let groups = RubbingGroups { mu, radius: draw(0.0, 0.03) };
    (groups, [draw(-3.2, 3.2), draw(-9.0, 9.0), draw(-40.0, 40.0), draw(-500.0, 500.0)])
}

/// The drive's power is that of the frictionless machine and the losses: both have the same motion.
#[test]
fn the_drive_pays_for_the_losses() {
    let (mut random, mut solved) = (Random::new(3), 0);
    for _ in 0..2000 {
        let mu = 0.3 * random.between(0.0, 1.0);
        let (groups, [q, rate, accel, push]) = drawn(&mut random, mu);
        let Ok(f) = groups.forces(q, rate, accel, push) else { continue };
        let smooth = SmoothGroups::new().forces(q, rate, accel, push).unwrap();
        solved += 1;
        // Efforts and losses are sums of some hundred terms, the largest of which are the reactions' moments.
        let largest =
            f.into_array().iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let off = (f.theta.drive - smooth.theta.drive) * rate - f.losses;
        assert!(off.abs() <= 1e-12 * largest * rate.abs().max(1.0), "{q} {rate}: {off}");
        assert!(f.losses >= 0.0);
    }
    // The others are out of reach or jam.
    assert!(solved > 900, "{solved}");
}

/// The drive's power and the load's feed kinetic energy, weights and losses: each from the motion alone.
#[test]
fn power_is_kept() {
    let (mut random, mut solved) = (Random::new(5), 0);
    for _ in 0..2000 {
        let mu = 0.4 * random.between(0.0, 1.0);
        let press = RubbingPress { pins: mu, ways: mu, ..RubbingPress::new() };
        let mut draw = |size: f64| random.between(-size, size);
        let (q, rate, accel, work) = (draw(3.2), draw(9.0), draw(40.0), draw(500.0));
        let Ok(f) = press.forces(q, rate, accel, work) else { continue };
        let motion = press.motion(q, rate, accel).unwrap();
        let (v, a) = (motion.velocity, motion.acceleration);
        // A uniform bar is two thirds of its mass in the middle and a sixth at each end.
        let points = [
            [0.5, v.B.x, v.B.y, a.B.x, a.B.y],
            [
                2.0,
                0.5 * (v.B.x + v.C.x),
                0.5 * (v.B.y + v.C.y),
                0.5 * (a.B.x + a.C.x),
                0.5 * (a.B.y + a.C.y),
            ],
            [40.5, v.C.x, v.C.y, a.C.x, a.C.y],
        ];
        let mut terms = vec![0.05 * rate * accel, -work * v.C.x, f.losses, -f.theta.drive * rate];
        for [mass, vx, vy, ax, ay] in points {
            terms.extend([mass * vx * ax, mass * vy * ay, mass * 9.81 * vy]);
        }
        let size = terms.iter().fold(0.0_f64, |sum, term| sum + term.abs());
        let off = terms.iter().sum::<f64>();
        assert!(off.abs() <= 1e-12 * size, "{q} {mu}: {off} of {size}");
        solved += 1;
    }
    assert!(solved > 1500, "{solved}");
}

/// Whatever the coefficient, an answer is a number or a refusal: a sample of the draws of `.ci/nightly`.
#[test]
fn nothing_is_ever_no_number() {
    let (mut random, mut counts) = (Random::new(7), [0; 3]);
    let draws = cases(10_000, 100_000);
    for nth in 0..draws {
        // From none to far beyond what jams.
        let mu = 10.0_f64.powf(random.between(-3.0, 1.0));
        let (groups, [q, rate, accel, push]) = drawn(&mut random, mu);
        let found = match nth % 2 {
            0 => groups.forces(q, rate, accel, push),
            _ => groups.statics(q, rate, push),
        };
        let kind = match found {
            Ok(f) => {
                assert!(f.into_array().iter().all(|value| value.is_finite()), "{q} {mu}");
                0
            }
            Err(SolveError::Jams { .. }) => 1,
            Err(SolveError::OutOfReach { .. }) => 2,
            Err(error) => panic!("{error} at {q}, {mu}"),
        };
        counts[kind] += 1;
    }
    assert!(counts[..2].iter().all(|&count| count > draws / 5), "{counts:?}");
}

/// The fast path, lanes and the slow path are one function: a sweep gives the single answers.
#[test]
fn a_sweep_gives_the_single_answers() {
    for mu in [0.05, 0.4, 1.5] {
        let press = RubbingPress { pins: mu, ways: mu, ..RubbingPress::new() };
        let found = |q, rate| press.forces(q, rate, 3.0, -200.0).map(Record::into_array);
        swept(found, |q, rates, out, status| {
            let out = <RubbingPressForces<&mut [f64]> as Record>::from_array(out);
            press.sweep_forces(q, rates, 3.0, -200.0, out, status, ()).unwrap();
        });
    }
}

/// Sixteen frictions in five groups, in a thread of its own. Without optimisation every number between two steps
/// has a place of its own on the stack, and those of this sweep need more than the 2 MB of a test's thread.
#[test]
fn sixteen_frictions_are_swept() {
    let thread = std::thread::Builder::new().stack_size(16 << 20);
    let swept = thread.spawn(sweep_sixteen_frictions).expect("it starts").join();
    swept.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

fn sweep_sixteen_frictions() {
    for mu in [0.05, 0.3] {
        let groups = RubbingGroups { mu, ..RubbingGroups::new() };
        let found = |q, rate| groups.forces(q, rate, 3.0, -200.0).map(Record::into_array);
        swept(found, |q, rates, out, status| {
            let out = <RubbingGroupsForces<&mut [f64]> as Record>::from_array(out);
            groups.sweep_forces(q, rates, 3.0, -200.0, out, status, ()).unwrap();
        });
    }
}

/// Compares a sweep with single answers.
fn swept<const N: usize>(
    single: impl Fn(f64, f64) -> Result<[f64; N], SolveError>,
    sweep: impl FnOnce(&[f64], &[f64], [&mut [f64]; N], &mut [Status]),
) {
    const COUNT: usize = 257;
    let mut random = Random::new(13);
    let q: Vec<f64> = (0..COUNT).map(|_| random.between(-3.2, 3.2)).collect();
    let rates: Vec<f64> = q.iter().map(|q| 7.0 * q.sin()).collect();
    let mut rows = vec![[0.0; COUNT]; N];
    let mut status = [Status::Solved; COUNT];
    let mut parts = rows.iter_mut();
    let out = std::array::from_fn(|_| &mut parts.next().expect("a row a number")[..]);
    sweep(&q, &rates, out, &mut status);
    for (at, (&q, &rate)) in q.iter().zip(&rates).enumerate() {
        match single(q, rate) {
            Ok(single) => {
                let largest = single.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
                assert_eq!(status[at], Status::Solved);
                for (row, value) in rows.iter().zip(single) {
                    // Fused operations may differ between the two.
                    assert!((row[at] - value).abs() <= 1e-9 * largest, "{q}: {largest}");
                }
            }
            Err(error) => assert_eq!(status[at], Status::from(error), "{q}"),
        }
    }
}

/// A coefficient of zero leaves the bits of a machine that was never said to rub.
#[test]
fn a_coefficient_of_zero_leaves_no_trace() {
    for step in 0..50 {
        let q = 0.13 * f64::from(step);
        let [unloaded, free] = [
            UnloadedFourBar::new().forces(q, 5.0, -3.0).unwrap().into_array(),
            FreeFourBar::new().forces(q, 5.0, -3.0).unwrap().into_array(),
        ];
        assert_eq!(unloaded.map(f64::to_bits), free.map(f64::to_bits), "{q}");
        // A parameter of zero as well, up to the sign of a zero.
        let groups = RubbingGroups { mu: 0.0, ..RubbingGroups::new() };
        let Ok(f) = groups.forces(q, 5.0, -3.0, 100.0) else { continue };
        assert_eq!(f.losses, 0.0);
    }
}

/// First and second derivatives by dual numbers, friction's own among them, against differences.
///
/// A difference of fourth order leaves h⁴/30 of the fifth derivative and ε/h of the effort. No pin of the
/// four-bar comes near a toggle, and each derivative of its torque is at most some ten times the one before.
#[test]
fn derivatives_hold_with_friction() {
    let (mut random, mut compared) = (Random::new(21), 0);
    let h = 1e-3;
    for nth in 0..200 {
        let mu = [0.05, 0.3, 0.9][nth % 3];
        let four_bar = RubbingFourBar { mu, radius: 0.03 };
        let (q, rate, accel) =
            (random.between(-3.1, 3.1), random.between(-9.0, 9.0), random.between(-30.0, 30.0));
        // A slip that changes its sign nearby makes a jump.
        let slips = four_bar.velocity(q, rate).unwrap();
        let slips = [rate, slips.BC.omega - rate, slips.BC.omega - slips.DC.omega, slips.DC.omega];
        if slips.iter().any(|slip| slip.abs() < 0.1) {
            continue;
        }
        let plain = |steps: f64| four_bar.forces(q + steps * h, rate, accel).unwrap().theta.drive;
        let lifted = four_bar.lift::<Dual64>();
        let first = |steps: f64| {
            let q = Dual64::from_re(q + steps * h).derivative();
            let [rate, accel] = [rate, accel].map(Dual64::from_re);
            lifted.forces(q, rate, accel).unwrap().theta.drive.eps
        };
        let difference =
            |f: &dyn Fn(f64) -> f64| (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * h);
        let size = f64::abs(plain(0.0)) + 100.0;
        let off = difference(&plain) - first(0.0);
        assert!(off.abs() < 1e-7 * size, "{q} {mu}: {off}");
        let twice = four_bar.lift::<Dual2_64>();
        let found = {
            let q = Dual2_64::from_re(q).derivative();
            let [rate, accel] = [rate, accel].map(Dual2_64::from_re);
            twice.forces(q, rate, accel).unwrap().theta.drive
        };
        let off = (difference(&first) - found.v2).abs() + (first(0.0) - found.v1).abs();
        assert!(off < 1e-6 * size, "{q} {mu}: {off}");
        compared += 1;
    }
    assert!(compared > 120, "{compared}");
}

#[test]
fn coefficients_follow_laws() {
    let laws = Laws::new();
    for rate in [0.3, -2.0, 1e-3] {
        let f = laws.forces([0.1, 0.2], [rate, rate], [0.0, 0.0]).unwrap();
        let mu = 0.1 + 0.2 / (1.0 + f64::abs(rate));
        assert!((f.x.drive - 20.0 * mu * f64::signum(rate)).abs() < 1e-13);
        let smooth = 12.0 * rate / f64::hypot(rate, 0.5);
        assert!((f.y.drive - smooth).abs() < 1e-13);
        assert!((f.losses - (f.x.drive + f.y.drive) * rate).abs() < 1e-13);
    }
    // At rest a creep has a sign alone, and of a smooth one nothing is left.
    let f = laws.statics([0.1, 0.2], [1e-9, -1e9]).unwrap();
    assert!((f.x.drive - 20.0 * 0.3).abs() < 1e-13 && f.y.drive == 0.0);
}

#[test]
fn a_negative_coefficient_is_invalid() {
    let groups = RubbingGroups { mu: -0.1, ..RubbingGroups::new() };
    let error = groups.forces(0.3, 1.0, 0.0, 0.0).unwrap_err();
    assert!(matches!(error, SolveError::Invalid { .. }), "{error}");
    assert!(error.to_string().contains("must not be negative"), "{error}");
}
