//! Motion under given drives, with friction.

use linkage_core::SolveError;
use linkage_tests::mechanisms::friction::*;
use linkage_tests::mechanisms::told::HalfSmooth;
use linkage_tests::random::{Random, cases};

use super::table::{CRANKS_FORWARD, FOUR_BARS_FORWARD};

/// Accelerations come from the mass matrix and from reactions, some fifty operations each, and from amounts that
/// are right within 4ε/(1 − ρ), ρ below a half.
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} is not {expected}");
}

#[test]
fn second_rates_agree_with_the_full_matrix() {
    for ([mu, block, offset], [q, rate, drive], expected) in CRANKS_FORWARD {
        let press = RubbingPress { pins: mu, ways: mu, block, offset, ..RubbingPress::new() };
        close(press.forward_dynamics(q, rate, drive, -500.0).unwrap(), expected);
    }
    for (mu, [q, rate, drive], expected) in FOUR_BARS_FORWARD {
        let four_bar = RubbingFourBar { mu, ..RubbingFourBar::new() };
        close(four_bar.forward_dynamics(q, rate, drive).unwrap(), expected);
    }
}

#[test]
fn guide_forward() {
    let found = RubbingRam::new().forward_dynamics(1.0, 12.0, 50.0, -500.0).unwrap();
    close(found, 218.497_553_048_732_848);
}

#[test]
fn painleve_klein() {
    let at = |mu| PainleveKlein { mu, ..PainleveKlein::new() };
    close(at(0.4).forward_dynamics(0.0, 1.0, 0.0).unwrap(), -1.071_605_807_015_359_96);
    let from = 1.070_154_359_890_551_17;
    assert!(at(from * (1.0 - 1e-12)).forward_dynamics(0.0, 1.0, 0.0).is_ok());
    let jams = at(from * (1.0 + 1e-12)).forward_dynamics(0.0, 1.0, 0.0);
    assert_eq!(jams, Err(SolveError::Jams { joint: "one" }));
    // Its inverse dynamics never jams.
    assert!(at(3.0).forces(0.0, 1.0, -1.0).is_ok());
}

/// `forces` at the accelerations under a drive gives the drive back, wherever both are known.
#[test]
fn forces_give_the_drive_back() {
    let (mut random, mut compared) = (Random::new(17), 0);
    for _ in 0..2000 {
        let mu = 0.4 * random.between(0.0, 1.0);
        let (q, rate, drive) =
            (random.between(-3.1, 3.1), random.between(-9.0, 9.0), random.between(-90.0, 90.0));
        let press = RubbingPress { pins: mu, ways: mu, ..RubbingPress::new() };
        let Ok(second) = press.forward_dynamics(q, rate, drive, -300.0) else { continue };
        let Ok(f) = press.forces(q, rate, second, -300.0) else { continue };
        // Rounding of the acceleration comes back with the mass, and that of the amounts with the arm of 80 mm.
        let size = drive.abs() + 0.1 * f64::hypot(f.BC.B.x, f.BC.B.y) + f64::abs(second);
        assert!((f.theta.drive - drive).abs() <= 1e-11 * size, "{q} {mu}");
        compared += 1;
    }
    assert!(compared > 1200, "{compared}");
}

#[test]
fn an_arm_gives_its_drives_back() {
    let mut random = Random::new(19);
    for _ in 0..300 {
        let arm = RubbingArm { mu: random.between(0.0, 0.5) };
        let mut pair = |size: f64| [(); 2].map(|()| random.between(-size, size));
        let (q, rates, drives) = (pair(3.0), pair(5.0), pair(30.0));
        let second = arm.forward_dynamics(q, rates, drives).unwrap();
        let f = arm.forces(q, rates, second).unwrap();
        for (found, drive) in [f.shoulder.drive, f.elbow.drive].into_iter().zip(drives) {
            assert!((found - drive).abs() < 1e-11 * 100.0, "{q:?}: {found} {drive}");
        }
    }
}

/// At rest the drive has to leave the band; beyond its ends the motion starts from zero, without a jump.
#[test]
fn a_drive_inside_the_band_moves_nothing() {
    let press = RubbingPress::new();
    for step in 0..60 {
        let q = 0.1 * f64::from(step) + 0.05;
        let Ok([backwards, forwards]) = press.holding(q, -500.0) else { continue };
        let second = |drive| press.forward_dynamics(q, 0.0, drive, -500.0).unwrap();
        let size = forwards - backwards;
        let inside = [0.1, 0.5, 0.999].map(|share| backwards + share * size);
        for drive in inside.into_iter().chain([backwards, forwards]) {
            assert_eq!(second(drive), 0.0, "{q} {drive}");
        }
        // The inertia of the crank alone bounds what a drive that is hardly larger can do: 0.05 kg m².
        for over in [1e-6, 1e-3, 1.0] {
            let (up, down) = (second(forwards + over), second(backwards - over));
            assert!(up > 0.0 && up < 40.0 * over && down < 0.0 && down > -40.0 * over, "{q}");
        }
    }
}

/// The dry sign alone holds at rest, where a smooth one is none.
#[test]
fn a_dry_joint_holds_beside_a_smooth_one() {
    let (machine, free) = (HalfSmooth::new(), HalfSmooth { pin: 0.0 });
    for q in [0.4, 1.3, 2.2, -1.9] {
        let second = |drive| machine.forward_dynamics(q, 0.0, drive).unwrap();
        // The block's 4.9 N at the arms of the crank, 40 to 105 mm: 0.19 to 0.52 N m.
        for drive in [0.0, 0.1, -0.1] {
            assert_eq!(second(drive), 0.0, "{q} {drive}");
        }
        assert!(second(0.9) > 0.1 && second(-0.9) < -0.1, "{q}");
        for drive in [0.9, -0.9] {
            close(second(drive), free.forward_dynamics(q, 0.0, drive).unwrap());
        }
    }
}

/// Eight half turns from one turning point to the next, each an arc of a circle, and rest where the spring is held.
#[test]
fn an_oscillator_comes_to_rest() {
    let (oscillator, mut x) = (Oscillator::new(), 0.1_f64);
    let (omega, band) = (20.0_f64, 0.25 * 2.0 * 9.81 / 800.0);
    let mut half_turns = 0;
    while oscillator.forward_dynamics(x, 0.0, 0.0).unwrap() != 0.0 {
        // The acceleration at a turning point, and on the way: both are those of the closed form.
        let start = oscillator.forward_dynamics(x, 0.0, 0.0).unwrap();
        let rate = -0.3 * x.signum();
        close(start, -omega * omega * (x - band * x.signum()));
        let way = oscillator.forward_dynamics(0.2 * x, rate, 0.0).unwrap();
        close(way, -omega * omega * (0.2 * x - band * x.signum()));
        x = -x.signum() * (x.abs() - 2.0 * band);
        half_turns += 1;
    }
    assert_eq!(half_turns, 8);
    assert!(x.abs() <= band);
}

/// Whatever the coefficient, an answer is a number or a refusal: a sample of the draws of `.ci/nightly`.
#[test]
fn nothing_is_ever_no_number() {
    let (mut random, mut counts) = (Random::new(23), [0; 3]);
    let draws = cases(4000, 20_000);
    for nth in 0..draws {
        let mu = 10.0_f64.powf(random.between(-3.0, 2.0));
        let press = RubbingPress { pins: mu, ways: mu, ..RubbingPress::new() };
        let rate = if nth % 5 == 0 { 0.0 } else { random.between(-9.0, 9.0) };
        let (q, drive) = (random.between(-3.2, 3.2), random.between(-90.0, 90.0));
        match press.forward_dynamics(q, rate, drive, -300.0) {
            Ok(second) => {
                assert!(second.is_finite());
                counts[0] += 1;
                // In motion nobody asks what would hold at rest.
                counts[2] += usize::from(rate != 0.0 && press.holding(q, -300.0).is_err());
            }
            Err(SolveError::Jams { .. }) => counts[1] += 1,
            Err(error) => panic!("{error} at {q} {mu}"),
        }
    }
    assert!(counts[0] > draws / 4 && counts[1] > draws / 10 && counts[2] > 0, "{counts:?}");
}
