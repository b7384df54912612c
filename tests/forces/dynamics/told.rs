//! Motions of which some accelerations are told: closed forms, the inverse dynamics of what was found, and derivatives.

use linkage_core::num_dual::DualSVec;
use linkage_core::{Given, Mixed, SolveError, differentiate};
use linkage_tests::mechanisms::dynamics::{GearedArm, HeavyRobot};
use linkage_tests::mechanisms::told::*;
use linkage_tests::random::Random;

/// reference/friction/hybrid.txt, the first 17 of 20 digits: the sway is −(g sin φ + ẍ cos φ)/l.
#[test]
fn a_trolley_that_is_told_sways_its_load() {
    let trolley = Trolley::new();
    let (phi, rate, told) = (0.3_f64, -0.4, 0.7);
    let given = [Given::Acceleration(told), Given::Drive(0.0)];
    let found = trolley.mixed_dynamics([2.0, phi], [1.5, rate], given).unwrap();
    // Some ten roundings, and of the drive those of masses of 280 kg beside it.
    let close = |found: f64, expected: f64, size: f64| {
        assert!((found - expected).abs() <= 10.0 * f64::EPSILON * size, "{found} {expected}");
    };
    close(found.accelerations[1], -1.189_262_923_245_221_8, 4.0);
    close(found.accelerations[1], -(9.81 * phi.sin() + told * phi.cos()) / 3.0, 4.0);
    close(found.drives[0], -88.023_079_713_478_31, 280.0);
    assert_eq!((found.accelerations[0], found.drives[1]), (told, 0.0));
    let state = [2.0, phi, 1.5, rate];
    let rates = trolley.state_rates_given(state, given).unwrap();
    assert_eq!(rates, [1.5, rate, told, found.accelerations[1]]);
}

/// A pivot's condition of the chain: accelerations may have an error of so many ε of the largest drive over an inertia.
const ROUNDING: f64 = 2e4 * f64::EPSILON;

/// Every mask: what was given stays, and the drives are those that the motion asks for.
#[track_caller]
fn check<const N: usize>(
    ranges: [f64; 3],
    solve: impl Fn([f64; N], [f64; N], [Given; N]) -> Result<Mixed<f64, N>, SolveError>,
    forces: impl Fn([f64; N], [f64; N], [f64; N]) -> [f64; N],
    forward: impl Fn([f64; N], [f64; N], [f64; N]) -> [f64; N],
) {
    let (mut random, mut compared) = (Random::new(31), 0);
    for mask in (0..1_usize << N).cycle().take(256) {
        let mut draw = |size: f64| [(); N].map(|()| random.between(-size, size));
        let (q, rates, told, drives) =
            (draw(ranges[0]), draw(ranges[1]), draw(9.0), draw(ranges[2]));
        let given: [Given; N] = core::array::from_fn(|input| match mask >> input & 1 {
            1 => Given::Acceleration(told[input]),
            _ => Given::Drive(drives[input]),
        });
        let Mixed { accelerations, drives: found } = solve(q, rates, given).unwrap();
        let asked = forces(q, rates, accelerations);
        let size = found.iter().chain(&accelerations).fold(50.0_f64, |size, x| size.max(x.abs()));
        for input in 0..N {
            match given[input] {
                Given::Acceleration(rate) => assert_eq!(accelerations[input], rate),
                Given::Drive(drive) => assert_eq!(found[input], drive),
            }
            let apart = (asked[input] - found[input]).abs();
            assert!(apart <= ROUNDING * size, "{mask:b}: {asked:?} {found:?}");
        }
        if mask == 0 {
            let expected = forward(q, rates, drives);
            let largest = expected.iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
            for (found, expected) in accelerations.into_iter().zip(expected) {
                assert!((found - expected).abs() <= ROUNDING * largest, "{found} {expected}");
            }
            compared += 1;
        }
    }
    assert!(compared > 0);
}

#[test]
fn every_mask_of_two_inputs() {
    let robot = HeavyRobot::new();
    check(
        [0.6, 3.0, 20.0],
        |[p, r], rates, given| robot.mixed_dynamics([1.9 + p, 1.2 + r], rates, given),
        |[p, r], rates, seconds| {
            let f = robot.forces([1.9 + p, 1.2 + r], rates, seconds).unwrap();
            [f.first.drive, f.second.drive]
        },
        |[p, r], rates, drives| robot.forward_dynamics([1.9 + p, 1.2 + r], rates, drives).unwrap(),
    );
}

#[test]
fn every_mask_of_three_inputs() {
    let arm = GearedArm::new();
    check(
        [3.0, 3.0, 90.0],
        |q, rates, given| arm.mixed_dynamics(q, rates, given),
        |q, rates, seconds| {
            let f = arm.forces(q, rates, seconds).unwrap();
            [f.base.drive, f.shoulder.drive, f.motor.drive]
        },
        |q, rates, drives| arm.forward_dynamics(q, rates, drives).unwrap(),
    );
}

#[test]
fn every_mask_of_five_inputs() {
    let chain = Chain::new();
    check(
        [3.0, 3.0, 20.0],
        |q, rates, given| chain.mixed_dynamics(q, rates, given, 12.0),
        |q, rates, seconds| {
            let f = chain.forces(q, rates, seconds, 12.0).unwrap();
            [f.a.drive, f.b.drive, f.c.drive, f.d.drive, f.e.drive]
        },
        |q, rates, drives| chain.forward_dynamics(q, rates, drives, 12.0).unwrap(),
    );
}

#[test]
fn single_precision_and_duals_of_a_told_motion() {
    let (wide, narrow) = (Chain::new(), Chain::<f32>::default());
    let (q, rates) = ([0.3, -0.6, 0.9, 0.4, -1.1], [0.5, -1.0, 2.0, 0.25, 1.0]);
    let told = |input: usize, x: f64| {
        if input.is_multiple_of(2) { Given::Acceleration(x) } else { Given::Drive(x) }
    };
    let numbers = [1.0, 3.0, -2.0, 0.5, 4.0];
    let given: [Given; 5] = core::array::from_fn(|input| told(input, numbers[input]));
    let found = wide.mixed_dynamics(q, rates, given, 12.0).unwrap();
    let as_single = |x: f64| x as f32;
    let given_single = given.map(|given| match given {
        Given::Acceleration(x) => Given::Acceleration(as_single(x)),
        Given::Drive(x) => Given::Drive(as_single(x)),
    });
    let single =
        narrow.mixed_dynamics(q.map(as_single), rates.map(as_single), given_single, 12.0).unwrap();
    let both = found.accelerations.into_iter().chain(found.drives);
    for (expected, found) in both.zip(single.accelerations.into_iter().chain(single.drives)) {
        // Angles of single precision are some 1e-7 off, in masses whose pivots are a tenth of themselves.
        assert!((f64::from(found) - expected).abs() < 1e-3 * expected.abs().max(10.0));
    }
    type One = DualSVec<f64, 1>;
    let dual = |x: f64| One::from_re(x);
    let slopes = differentiate([q[1]], |[b]: [One; 1]| {
        let (mut at, rates) = (q.map(dual), rates.map(dual));
        at[1] = b;
        let given = given.map(|given| match given {
            Given::Acceleration(x) => Given::Acceleration(dual(x)),
            Given::Drive(x) => Given::Drive(dual(x)),
        });
        let found = Chain::default().mixed_dynamics(at, rates, given, dual(12.0))?;
        Ok([found.accelerations[1], found.drives[0]])
    });
    let slopes = slopes.unwrap();
    let at = |b: f64| {
        let found = wide.mixed_dynamics([q[0], b, q[2], q[3], q[4]], rates, given, 12.0).unwrap();
        [found.accelerations[1], found.drives[0]]
    };
    let (more, less) = (at(q[1] + 1e-5), at(q[1] - 1e-5));
    for row in 0..2 {
        let slope = (more[row] - less[row]) / 2e-5;
        assert!((slopes[row] - slope).abs() < 1e-6 * slope.abs().max(1.0), "{row}");
    }
}

#[test]
fn a_told_motion_is_refused_by_the_name_of_an_input() {
    let chain = Chain::new();
    let still = [0.0; 5];
    let with = |input: usize, bad: Given| {
        let mut given = [Given::Drive(1.0); 5];
        given[input] = bad;
        chain.mixed_dynamics(still, still, given, 0.0)
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for given in [Given::Acceleration(bad), Given::Drive(bad)] {
            let found = with(2, given);
            assert!(matches!(found, Err(SolveError::NotFinite { .. })), "{found:?}");
        }
        let state = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, bad, 0.0, 0.0, 0.0];
        let found = chain.state_rates_given(state, [Given::Acceleration(0.0); 5], 0.0);
        assert!(matches!(found, Err(SolveError::NotFinite { .. })), "{found:?}");
    }
    // Stretched, one of the two bars has to be told.
    let arm = TwoBars::new();
    let free = [Given::Drive(1.0); 2];
    let singular = Err(SolveError::Singular { group: "second" });
    assert_eq!(arm.mixed_dynamics([0.0; 2], [0.0; 2], free), singular);
    assert_eq!(
        arm.forward_dynamics([0.0; 2], [0.0; 2], [1.0; 2]).map(|_| ()),
        singular.map(|_| ())
    );
    let told = [Given::Drive(1.0), Given::Acceleration(2.0)];
    assert!(arm.mixed_dynamics([0.0; 2], [0.0; 2], told).is_ok());
    assert!(arm.mixed_dynamics([0.0, 1.0], [0.0; 2], free).is_ok());
}
