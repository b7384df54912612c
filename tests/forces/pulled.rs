//! Loads that drive inputs, against the same mechanisms under given loads: no other effort is put in.

use linkage_core::num_dual::DualSVec;
use linkage_core::{Record, SolveError, Status, differentiate};
use linkage_tests::mechanisms::pulled::*;
use linkage_tests::random::Random;

/// Efforts and reactions are sums of some fifty products each: a hundred roundings of the largest.
const ROUNDING: f64 = 100.0 * f64::EPSILON;

#[track_caller]
fn close(found: &[f64], expected: &[f64]) {
    let largest = expected.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= ROUNDING * largest, "{found} is not {expected}");
    }
}

/// Away from the dead centres, where the load grows beyond bounds and its rounding with it.
fn angle(random: &mut Random) -> f64 {
    let half = if random.between(0.0, 1.0) < 0.5 { 0.0 } else { core::f64::consts::PI };
    half + random.between(0.5, 2.6)
}

#[test]
fn an_engine_has_the_reactions_of_the_given_load() {
    let (engine, given, mut random) = (Engine::new(), GivenEngine::new(), Random::new(3));
    for _ in 0..300 {
        let q = angle(&mut random);
        let (rate, second) = (random.between(-30.0, 30.0), random.between(-900.0, 900.0));
        let brake = random.between(-50.0, 50.0);
        let f = engine.forces(q, rate, second, brake).unwrap();
        let g = given.forces(q, rate, second, [brake, f.gas]).unwrap();
        let pins = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| [a, b, c].concat();
        let own = pins([f.AB.A.x, f.AB.A.y], [f.BC.B.x, f.BC.B.y], [f.BC.C.x, f.BC.C.y]);
        let other = pins([g.AB.A.x, g.AB.A.y], [g.BC.B.x, g.BC.B.y], [g.BC.C.x, g.BC.C.y]);
        close(&own, &other);
        let bore = [f.piston.bore.normal, g.piston.bore.normal];
        assert!((bore[0] - bore[1]).abs() <= ROUNDING * own[4].hypot(own[5]));
        // The arm is 80 mm: what is left of a drive is the rounding of the couple.
        let couple = 0.08 * own[0].hypot(own[1]) + brake.abs() + 0.1 * second.abs();
        assert!(g.theta.drive.abs() <= ROUNDING * couple, "{} of {couple}", g.theta.drive);
        assert_eq!(f.shaking, g.shaking);
        close(&[f.on_piston, f.twice], &[g.on_piston, g.twice]);
    }
}

#[test]
fn a_load_at_rest_balances_what_acts() {
    let (engine, given) = (Engine::new(), GivenEngine::new());
    for step in 0..20 {
        let q = 0.4 + 0.1 * f64::from(step);
        let f = engine.statics(q, 15.0).unwrap();
        let g = given.statics(q, [15.0, f.gas]).unwrap();
        assert!(g.theta.drive.abs() <= ROUNDING * (15.0 + 0.08 * f.gas.abs()), "{q}");
        assert!(f.gas != 0.0 && f.twice == 0.0);
        close(&[f.AB.A.x, f.AB.A.y], &[g.AB.A.x, g.AB.A.y]);
    }
}

/// The power of the load is that of all energies, the damper and the brake.
#[test]
fn an_engine_puts_in_what_is_taken() {
    type One = DualSVec<f64, 1>;
    let (engine, lifted) = (Engine::new(), Engine::<One>::default());
    let mut random = Random::new(5);
    for _ in 0..100 {
        let (q, rate) = (angle(&mut random), random.between(-30.0, 30.0));
        let (second, brake) = (random.between(-900.0, 900.0), random.between(-50.0, 50.0));
        let f = engine.forces(q, rate, second, brake).unwrap();
        let v = engine.velocity(q, rate).unwrap();
        let real = One::from_re;
        let growth = differentiate([0.0], |[t]: [One; 1]| {
            let e = lifted.energy(t * real(rate) + real(q), t * real(second) + real(rate))?;
            Ok([e.kinetic + e.potential])
        });
        let growth = growth.unwrap()[0];
        // On the piston along its bore, and up on the crank pin.
        let slide = v.piston.slide;
        let up = 0.08 * q.cos() * rate;
        let work = f.on_piston * slide + 0.1 * f.gas / (1.0 + rate / 50.0) * up;
        let p = engine.position(q).unwrap();
        let reach = p.C.x.hypot(p.C.y);
        let stretching = (p.C.x * v.C.x + p.C.y * v.C.y) / reach;
        let taken = brake * rate + 5.0 * stretching * stretching;
        let size = growth.abs() + work.abs() + taken.abs() + (f.gas * slide).abs();
        // The energy's rate is made of some hundred operations with duals.
        assert!((work - growth - taken).abs() <= 10.0 * ROUNDING * size, "{work} {growth} {taken}");
    }
}

#[test]
fn an_arm_is_held_by_its_cylinder() {
    let (arm, given, mut random) = (Arm::new(), GivenArm::new(), Random::new(7));
    for _ in 0..300 {
        let q = [random.between(-3.0, 3.0), random.between(0.4, 2.2)];
        let mut pair = |size: f64| [(); 2].map(|()| random.between(-size, size));
        let (rates, seconds, [hand, _]) = (pair(3.0), pair(20.0), pair(90.0));
        let f = arm.forces(q, rates, seconds, hand).unwrap();
        let g = given.forces(q, rates, seconds, [f.cylinder, hand]).unwrap();
        // Levers of a tenth of a metre and more.
        let size = f.cylinder.abs() + 100.0 + f.fore.E.x.hypot(f.fore.E.y);
        assert!(g.elbow.drive.abs() <= ROUNDING * size, "{}", g.elbow.drive);
        assert!((g.shoulder.drive - f.shoulder.drive).abs() <= ROUNDING * size);
        close(&[f.fore.E.x, f.fore.E.y], &[g.fore.E.x, g.fore.E.y]);
        close(&[f.upper.O.x, f.upper.O.y], &[g.upper.O.x, g.upper.O.y]);
        // Forwards the load is what the drive was, and gives the same motion as any load.
        let drives = [f.shoulder.drive, f.cylinder];
        let found = arm.forward_dynamics(q, rates, drives, hand).unwrap();
        let same =
            given.forward_dynamics(q, rates, [f.shoulder.drive, 0.0], [f.cylinder, hand]).unwrap();
        assert_eq!(found, same);
        // Inertias of half a kg m² and more.
        for (found, second) in found.into_iter().zip(seconds) {
            assert!((found - second).abs() <= 100.0 * ROUNDING * size, "{found} {second}");
        }
    }
}

#[test]
fn motion_under_the_load_asks_for_the_load() {
    let (engine, given, mut random) = (Engine::new(), GivenEngine::new(), Random::new(11));
    for _ in 0..300 {
        let (q, rate) = (angle(&mut random), random.between(-30.0, 30.0));
        let (gas, brake) = (random.between(-900.0, 900.0), random.between(-50.0, 50.0));
        let second = engine.forward_dynamics(q, rate, gas, brake).unwrap();
        assert_eq!(second, given.forward_dynamics(q, rate, 0.0, [brake, gas]).unwrap());
        assert_eq!(engine.state_rates([q, rate], gas, brake).unwrap(), [rate, second]);
        let f = engine.forces(q, rate, second, brake).unwrap();
        // The acceleration's rounding comes back over an arm of 20 mm and more, times 0.06 kg m².
        let size = gas.abs() + 50.0 * (brake.abs() + 20.0) + 3.0 * second.abs();
        assert!((f.gas - gas).abs() <= 10.0 * ROUNDING * size, "{} {gas}", f.gas);
    }
    // The load may move nothing forwards: there is no division.
    assert!(engine.forward_dynamics(0.0, 1.0, 500.0, 0.0).is_ok());
}

#[test]
fn an_unknown_is_driven_in_place_of_its_input() {
    let (press, asked) = (Commanded::new(), AskedPress::new());
    for step in 0..20 {
        let x = 0.2 + 0.006 * f64::from(step);
        let f = press.forces(x, -0.4, 3.0, 5e3).unwrap();
        let g = asked.forces(x, -0.4, 3.0, 5e3).unwrap();
        close(&[f.motor], &[g.theta.drive]);
    }
}

/// Where the load does no work on the input nothing that it is puts in an effort.
#[test]
fn a_dead_point_is_singular() {
    let straight = Lever::new();
    let refused = Err(SolveError::Singular { group: "drive theta by push" });
    assert_eq!(straight.forces(0.0, 1.0, 2.0), refused);
    // At rest nothing acts on it.
    assert_eq!(straight.statics(0.0).unwrap().push, 0.0);
    let f = straight.forces(0.1, 1.0, 2.0).unwrap();
    // J q̈ = p r sin q
    close(&[f.push], &[-0.5 * 2.0 / (0.3 * 0.1_f64.sin())]);
    // A lever of a tenth of a nanometre asks for a large load, and no more.
    assert!(straight.forces(1e-9, 1.0, 2.0).unwrap().push < -1e9);
}

#[test]
fn single_precision_sweeps_and_duals() {
    let (wide, narrow) = (Engine::new(), Engine::<f32>::default());
    let angles: Vec<f64> = (0..40).map(|step| 0.5 + 0.05 * f64::from(step)).collect();
    let (mut gas, mut status) = ([0.0; 40], [Status::Solved; 40]);
    assert!(EngineForces::<f64>::LABELS.contains(&"gas"));
    let mut out = <EngineForces<&mut [f64]> as Record>::from_array(
        [(); EngineForces::<f64>::LABELS.len()].map(|()| &mut [][..]),
    );
    out.gas = &mut gas;
    wide.sweep_forces(&angles, 3.0, -20.0, 8.0, out, &mut status, ()).unwrap();
    for (k, &q) in angles.iter().enumerate() {
        let f = wide.forces(q, 3.0, -20.0, 8.0).unwrap();
        // A sweep may fuse where a single call does not.
        assert!((gas[k] - f.gas).abs() < 1e-12 * f.gas.abs().max(100.0), "{q}");
        let at = f64::from(q as f32);
        let exact = wide.forces(at, 3.0, -20.0, 8.0).unwrap();
        let single = narrow.forces(q as f32, 3.0, -20.0, 8.0).unwrap();
        assert!((f64::from(single.gas) - exact.gas).abs() < 1e-4 * exact.gas.abs().max(100.0));
    }
    let slope = differentiate([0.9], |[q]: [DualSVec<f64, 1>; 1]| {
        let real = DualSVec::from_re;
        Ok([Engine::default().forces(q, real(3.0), real(-20.0), real(8.0))?.gas])
    });
    let at = |q: f64| wide.forces(q, 3.0, -20.0, 8.0).unwrap().gas;
    let difference = (at(0.9 + 1e-5) - at(0.9 - 1e-5)) / 2e-5;
    assert!((slope.unwrap()[0] - difference).abs() < 1e-6 * difference.abs());
}
