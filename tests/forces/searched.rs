//! Efforts beside an unknown: the same machine driven where nothing is searched, and energy.

use linkage_core::{Differentiable, Record, SolveError, Status, unwanted};
use linkage_tests::mechanisms::searched_forces::*;
use num_dual::Dual64;

/// Angles between the press's dead points, rates and accelerations.
fn states() -> impl Iterator<Item = [f64; 3]> {
    (0..40).map(|step| {
        let part = f64::from(step) / 39.0;
        [0.3 + 2.4 * part, 9.0 - 17.0 * part, 40.0 * part - 11.0]
    })
}

/// Within 1e-12 of the sizes of what it is made of. The sought angle is off by an ulp of the slide
/// over its slope, 1e-14 rad where that is least; and what it is made of is some 1e2 times that.
#[track_caller]
fn close(found: f64, expected: f64, size: f64) {
    let size = size.abs() + expected.abs();
    assert!((found - expected).abs() <= 1e-12 * size, "{found} {expected} of {size}");
}

#[test]
fn a_press_has_the_efforts_of_the_press_that_its_crank_drives() {
    let (ram, crank) = (RamDriven::new(), CrankDriven::new());
    for [theta, omega, alpha] in states() {
        let m = crank.motion(theta, omega, alpha).expect("it turns fully");
        let [x, rate, accel] =
            [m.position.ram.slide, m.velocity.ram.slide, m.acceleration.ram.slide];
        let slope = crank.velocity(theta, 1.0).expect("it turns fully").ram.slide;
        let work = 300.0 * theta.sin();
        let expected = crank.forces(theta, omega, alpha, work).expect("it turns fully");
        let found = ram.forces(x, rate, accel, work).expect("within the stroke");
        close(found.theta.drive, expected.theta.drive, 100.0);
        close(found.x.drive * slope, expected.theta.drive, 100.0);
        close(found.balance.force, expected.balance.force, 1.0);
        close(found.coil.torque, expected.coil.torque, 1.0);
        close(found.shaking.x, expected.shaking.x, 1000.0);
        close(found.shaking.y, expected.shaking.y, 1000.0);
        close(found.shaking.couple, expected.shaking.couple, 1000.0);

        let expected = crank.statics(theta, work).expect("it turns fully");
        let found = ram.statics(x, work).expect("within the stroke");
        close(found.theta.drive, expected.theta.drive, 100.0);
        close(found.x.drive * slope, expected.theta.drive, 100.0);
        assert_eq!(found.shaking.couple, 0.0);

        let expected = crank.energy(theta, omega).expect("it turns fully");
        let found = ram.energy(x, rate).expect("within the stroke");
        close(found.kinetic, expected.kinetic, 1.0);
        close(found.potential, expected.potential, 1.0);
        let (here, there) = (ram.position(x), m.position.centre_of_mass);
        let here = here.expect("within the stroke").centre_of_mass;
        close(here.distance(there), 0.0, 1.0);
    }
}

#[test]
fn motion_from_forces_gives_the_accelerations_back() {
    let (ram, crank) = (RamDriven::new(), CrankDriven::new());
    for [theta, omega, alpha] in states() {
        let m = crank.motion(theta, omega, alpha).expect("it turns fully");
        let [x, rate, accel] =
            [m.position.ram.slide, m.velocity.ram.slide, m.acceleration.ram.slide];
        let drive = ram.forces(x, rate, accel, 70.0).expect("within the stroke").x.drive;
        let found = ram.forward_dynamics(x, rate, drive, 70.0).expect("within the stroke");
        close(found, accel, 100.0);
        let slope = crank.velocity(theta, 1.0).expect("it turns fully").ram.slide;
        let by_ram = ram.equations_of_motion(x, rate, 70.0).expect("within the stroke").mass;
        let by_crank = crank.equations_of_motion(theta, omega, 70.0).expect("it turns").mass;
        close(by_ram[0][0] * slope * slope, by_crank[0][0], 0.0);
        assert_eq!(ram.state_rates([x, rate], drive, 70.0), Ok([rate, found]));
    }
}

/// The growth of energy along q + q̇ t + ½ q̈ t², by dual numbers: nothing is damped.
#[test]
fn drives_put_in_what_the_energy_grows_by() {
    let along = |[q, rate, accel]: [f64; 3]| [Dual64::new(q, rate), Dual64::new(rate, accel)];
    let triad = HeavyTriad::new();
    for step in 0..50 {
        let state = [0.13 * f64::from(step), 3.0 - 0.2 * f64::from(step), 1.5];
        let [q, rate] = along(state);
        let energy = triad.lift::<Dual64>().energy(q, rate).expect("it turns fully");
        let growth = (energy.kinetic + energy.potential).eps;
        let f = triad.forces(state[0], state[1], state[2]).expect("it turns fully");
        close(f.turn.drive * state[1], growth, 100.0);
    }
    let pair = HeavyPair::new();
    for (x, h) in [(0.2, 0.3), (0.25, 0.1), (0.3, 0.55)] {
        let states = [[x, 0.4, 1.3], [h, -0.2, -0.7]];
        let [x, h] = states.map(along);
        let energy = pair.lift::<Dual64>().energy([x[0], h[0]], [x[1], h[1]]);
        let energy = energy.expect("within reach");
        let growth = (energy.kinetic + energy.potential).eps;
        let order = |k: usize| states.map(|state| state[k]);
        let f = pair.forces(order(0), order(1), order(2)).expect("within reach");
        close(f.x.drive * 0.4 - f.h.drive * 0.2, growth, 100.0);
        let drives = [f.x.drive, f.h.drive];
        let found = pair.forward_dynamics(order(0), order(1), drives).expect("within reach");
        close(found[0], 1.3, 10.0);
        close(found[1], -0.7, 10.0);
    }
}

/// A declaration that names no effort gets the efforts that its power determines; where a bar holds the equation,
/// all reactions.
#[test]
fn without_outputs_the_inputs_and_named_springs_have_efforts() {
    let f = HeavyTriad::new().statics(0.4).expect("it turns fully");
    assert_eq!(<HeavyTriadForces<f64> as Record>::LABELS[0], "turn.drive");
    assert!(<HeavyTriadForces<f64> as Record>::LABELS.len() > 10);
    assert!(f.turn.drive.abs() > 1.0, "{f:?}");
    fn single<T: Differentiable>(x: T) -> Result<T, SolveError> {
        let press = RamDriven::<T>::default();
        Ok(press.statics(x, T::lit(40.0, 40.0))?.theta.drive)
    }
    let (wide, narrow) = (single(0.25_f64), single(0.25_f32));
    let (wide, narrow) = (wide.expect("in the stroke"), narrow.expect("in the stroke"));
    assert!((f64::from(narrow) - wide).abs() < 1e-4 * wide.abs(), "{narrow} {wide}");
}

#[test]
fn a_dead_point_has_no_efforts_and_a_far_target_no_pose() {
    let ram = RamDriven::new();
    let far = ram.forces(0.5, 0.0, 0.0, 0.0);
    assert!(matches!(far, Err(SolveError::NoSolution { unknown: "theta", .. })), "{far:?}");
    let text = far.map(|_| ()).unwrap_err().to_string();
    assert!(
        text.starts_with("theta: no solution between its ends, 17") && text.contains(" mm is"),
        "{text}"
    );
    let still = TurningBack::new().statics(0.0).map(|_| ());
    assert_eq!(still, Err(SolveError::Singular { group: "theta" }));
    let f = TurningBack::new().statics(0.125).expect("in the stroke");
    assert!((f.x.drive - 100.0 * 0.25).abs() < 1e-12, "{f:?}");
    let none = ram.forces(0.25, f64::NAN, 0.0, 0.0).map(|_| ());
    assert_eq!(none, Err(SolveError::NotFinite { name: "x_rate" }));
    let none = ram.statics(0.25, f64::INFINITY).map(|_| ());
    assert_eq!(none, Err(SolveError::NotFinite { name: "work" }));
}

#[test]
fn a_sweep_of_forces_is_the_single_call_at_every_pose() {
    let ram = RamDriven::new();
    let x: Vec<f64> = (0..60).map(|step| 0.16 + 0.003 * f64::from(step)).collect();
    let (mut drive, mut status) = (vec![0.0; x.len()], vec![Status::Solved; x.len()]);
    let out = RamDrivenForces { x: RamDrivenForcesOfx { drive: &mut drive[..] }, ..unwanted() };
    ram.sweep_forces(&x, 1.5, -2.0, 40.0, out, &mut status, ()).expect("slices of one length");
    let mut refused = 0;
    for (pose, &x) in x.iter().enumerate() {
        match ram.forces(x, 1.5, -2.0, 40.0) {
            Ok(single) => assert_eq!((status[pose], drive[pose]), (Status::Solved, single.x.drive)),
            Err(error) => {
                refused += 1;
                assert_eq!(status[pose], Status::from(error));
                assert!(drive[pose].is_nan());
            }
        }
    }
    assert!((5..40).contains(&refused), "{refused}");
}
