//! Friction where a load drives an input: against the full matrix, and against the same machine under the given load.

use core::f64::consts::PI;

use linkage_core::num_dual::DualSVec;
use linkage_core::{SolveError, differentiate};
use linkage_tests::mechanisms::rubbing_pulled::*;
use linkage_tests::random::{Random, cases};

/// reference/friction/elsewhere.txt: the full matrix with the drive at the ram, in 40 digits, printed to 12.
#[test]
fn a_crank_that_its_piston_pushes() {
    let crank = PushedCrank::new();
    for (q, expected) in [(0.1, -381.780_546_153), (0.3, -43.403_855_743_3), (1.3, -12.953_823_735)]
    {
        let found = crank.statics(q, 1.0).unwrap().push;
        assert!((found - expected).abs() < 1e-11 * expected.abs(), "{q}: {found}");
    }
    // The share that comes back is 1.5009, 1.0005 and 1.0001 there, and 0.752 at 0.1.
    for q in [0.05, 0.075_070_491_076_716_5, 0.0751] {
        assert!(matches!(crank.statics(q, 1.0), Err(SolveError::Jams { .. })), "{q}");
    }
    assert!(crank.statics(0.0752, 1.0).is_ok());
    // At the dead centre itself the load does no work at all.
    let dead = crank.statics(0.0, 1.0).unwrap_err();
    let name = "drive theta by push";
    assert!(matches!(dead, SolveError::Singular { group } if group == name), "{dead:?}");
}

/// A state in which the load has a lever.
fn state(random: &mut Random) -> [f64; 4] {
    let half = if random.between(0.0, 1.0) < 0.5 { 0.0 } else { PI };
    let q = half + random.between(0.5, 2.6);
    [q, random.between(-30.0, 30.0), random.between(-900.0, 900.0), random.between(-50.0, 50.0)]
}

/// Some hundred roundings of the largest reaction, and those of amounts over 1 − ρ, ρ below 0.8.
const ROUNDING: f64 = 1e-12;

#[test]
fn reactions_and_friction_are_those_of_the_given_load() {
    let (mut random, mut compared) = (Random::new(41), 0);
    for _ in 0..500 {
        let mu = 0.2 * random.between(0.0, 1.0);
        let (engine, given) = (RubbingEngine { mu }, GivenRubbingEngine { mu });
        let [q, rate, second, brake] = state(&mut random);
        let Ok(f) = engine.forces(q, rate, second, brake) else { continue };
        let Ok(g) = given.forces(q, rate, second, [brake, f.gas]) else { continue };
        let own = [f.AB.A.x, f.AB.A.y, f.BC.B.x, f.BC.B.y, f.BC.C.x, f.BC.C.y];
        let other = [g.AB.A.x, g.AB.A.y, g.BC.B.x, g.BC.B.y, g.BC.C.x, g.BC.C.y];
        let largest = own.iter().fold(f.gas.abs(), |largest, x| largest.max(x.abs()));
        for (found, expected) in own.into_iter().zip(other) {
            assert!((found - expected).abs() <= ROUNDING * largest, "{q} {mu}: {found} {expected}");
        }
        // Levers are shorter than a metre, and slips slower than 30 m/s.
        assert!(g.theta.drive.abs() <= ROUNDING * largest, "{q} {mu}: {}", g.theta.drive);
        assert!((f.piston.bore.normal - g.piston.bore.normal).abs() <= ROUNDING * largest);
        assert!((f.piston.bore.couple - g.piston.bore.couple).abs() <= ROUNDING * largest);
        assert!((f.piston.bore_friction - g.piston.bore_friction).abs() <= ROUNDING * largest);
        assert!((f.AB.A_friction - g.AB.A_friction).abs() <= ROUNDING * largest);
        assert!((f.losses - g.losses).abs() <= 30.0 * ROUNDING * largest);
        assert!((f.taken - f.losses - brake * rate).abs() <= 30.0 * ROUNDING * largest);
        assert!(f.losses >= 0.0);
        compared += 1;
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn the_load_of_a_motion_is_the_load_that_made_it() {
    let (mut random, mut compared) = (Random::new(43), 0);
    for _ in 0..500 {
        let mu = 0.2 * random.between(0.0, 1.0);
        let (engine, given) = (RubbingEngine { mu }, GivenRubbingEngine { mu });
        let [q, rate, _, brake] = state(&mut random);
        let gas = random.between(-900.0, 900.0);
        let found = engine.forward_dynamics(q, rate, gas, brake);
        assert_eq!(found, given.forward_dynamics(q, rate, 0.0, [brake, gas]));
        let Ok(second) = found else { continue };
        let Ok(f) = engine.forces(q, rate, second, brake) else { continue };
        // The acceleration is rounded, and inertia of 0.08 kg m² takes that over a lever of 20 mm.
        let size = gas.abs() + 50.0 * (brake.abs() + 20.0) + 4.0 * second.abs();
        assert!((f.gas - gas).abs() <= 10.0 * ROUNDING * size, "{q} {mu}: {} {gas}", f.gas);
        compared += 1;
    }
    assert!(compared > 400, "{compared}");
}

/// Between the two loads that creep nothing moves, beyond them all starts from zero.
#[test]
fn loads_inside_the_band_move_nothing() {
    let (engine, mut held) = (RubbingEngine::new(), 0);
    for step in 0..40 {
        let q = 0.4 + 0.055 * f64::from(step);
        let Ok([backwards, forwards]) = engine.holding(q, 12.0) else { continue };
        let creep = |creep: f64| engine.statics(q, creep, 12.0).unwrap().gas;
        for (found, expected) in [backwards, forwards].into_iter().zip([-1.0, 1.0].map(creep)) {
            assert!((found - expected).abs() <= ROUNDING * expected.abs(), "{found} {expected}");
        }
        // On this half of the turn the piston comes in: its force is against the crank.
        let without = creep(0.0);
        assert!((backwards - without) * (without - forwards) > 0.0, "{q}");
        let second = |share: f64| {
            let gas = backwards + share * (forwards - backwards);
            engine.forward_dynamics(q, 0.0, gas, 12.0).unwrap()
        };
        assert_eq!([0.01, 0.5, 0.99].map(second), [0.0; 3], "{q}");
        assert!(second(1.01) > 0.0 && second(-0.01) < 0.0, "{q}");
        held += 1;
    }
    assert!(held > 30, "{held}");
}

/// Without friction it is the frictionless load, and the slope by a coefficient is that of a difference.
#[test]
fn friction_of_a_load_is_differentiated() {
    let at = |mu: f64| {
        let engine = RubbingEngine { mu };
        engine.forces(0.9, 3.0, -20.0, 8.0).unwrap().gas
    };
    let slope = differentiate([0.1], |[mu]: [DualSVec<f64, 1>; 1]| {
        let real = DualSVec::from_re;
        let engine = RubbingEngine { mu };
        Ok([engine.forces(real(0.9), real(3.0), real(-20.0), real(8.0))?.gas])
    });
    let difference = (at(0.1 + 1e-6) - at(0.1 - 1e-6)) / 2e-6;
    assert!((slope.unwrap()[0] - difference).abs() < 1e-6 * difference.abs());
    let (wide, narrow) = (at(0.0), at(1e-9));
    assert!((wide - narrow).abs() < 1e-6 * wide.abs());
    let single = RubbingEngine::<f32>::default().forces(0.9, 3.0, -20.0, 8.0).unwrap().gas;
    assert!((f64::from(single) - at(0.1)).abs() < 1e-3 * at(0.1).abs());
}

/// Whatever the coefficient, an answer is a number or a refusal: a sample of the draws of `.ci/nightly`.
#[test]
fn a_load_beside_friction_is_never_no_number() {
    let (mut random, mut counts) = (Random::new(47), [0; 2]);
    let draws = cases(4000, 20_000);
    for _ in 0..draws {
        let mu = 10.0_f64.powf(random.between(-3.0, 2.0));
        let engine = RubbingEngine { mu };
        let (q, rate) = (random.between(-3.2, 3.2), random.between(-9.0, 9.0));
        match engine.forces(q, rate, random.between(-90.0, 90.0), 10.0) {
            Ok(f) => {
                assert!(f.gas.is_finite() && f.losses >= 0.0);
                counts[0] += 1;
            }
            Err(SolveError::Jams { .. }) => counts[1] += 1,
            Err(error) => panic!("{error} at {q} {mu}"),
        }
    }
    assert!(counts.iter().all(|&count| count > draws / 10), "{counts:?}");
}

/// One of two inputs is driven by a load: under the load that follows, nothing is left for a drive of its own, and
/// all else is the same.
#[test]
fn one_of_several_inputs_is_driven_by_a_load() {
    let (mut random, mut counts) = (Random::new(47), [0; 2]);
    for nth in 0..500 {
        let mu = random.between(0.0, 0.6);
        let (arm, given) = (RubbingReach { mu }, GivenRubbingReach { mu });
        let mut pair = |size: f64| [(); 2].map(|()| random.between(-size, size));
        let (q, rates, seconds) = (pair(3.0), pair(5.0), pair(30.0));
        let hand = random.between(-90.0, 90.0);
        let at_rest = nth % 2 == 0;
        let found = match at_rest {
            true => arm.statics(q, rates, hand),
            false => arm.forces(q, rates, seconds, hand),
        };
        let f = match found {
            Ok(found) => found,
            Err(SolveError::Jams { .. }) => {
                counts[1] += 1;
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let loads = [hand, f.cylinder];
        let g = match at_rest {
            true => given.statics(q, rates, loads),
            false => given.forces(q, rates, seconds, loads),
        };
        let g = g.unwrap();
        let own = [f.upper.O.x, f.upper.O.y, f.fore.E.x, f.fore.E.y, f.fore.E_friction];
        let other = [g.upper.O.x, g.upper.O.y, g.fore.E.x, g.fore.E.y, g.fore.E_friction];
        let largest = own.iter().fold(f.cylinder.abs(), |largest, x| largest.max(x.abs()));
        for (found, expected) in own.into_iter().zip(other) {
            assert!((found - expected).abs() <= ROUNDING * largest, "{q:?}: {found} {expected}");
        }
        // Levers are shorter than a metre, and slips slower than 10 rad/s.
        assert!(g.elbow.drive.abs() <= ROUNDING * largest, "{q:?}: {}", g.elbow.drive);
        assert!((f.shoulder.drive - g.shoulder.drive).abs() <= ROUNDING * largest);
        assert!((f.losses - g.losses).abs() <= 10.0 * ROUNDING * largest);
        assert!(at_rest || f.losses > 0.0);
        counts[0] += 1;
    }
    assert!(counts[0] > 400 && counts[1] > 0, "{counts:?}");
}
