//! Published and computed cases, by name.

use linkage_core::SolveError;
use linkage_tests::mechanisms::friction::*;

use super::table::{CRANKS, FOUR_BARS};

/// Reactions are sums of some thirty products and quotients, each within an ε of itself: of the largest reaction
/// that is 10⁻¹³ at most. Amounts add 4ε/(1 − ρ) with ρ below a half.
fn close(name: &str, found: &[f64], expected: &[f64]) {
    let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-13 * largest, "{name}: {found} is not {expected}");
    }
}

#[test]
fn a_press_agrees_with_the_full_matrix() {
    for case in &CRANKS {
        let press = RubbingPress {
            pins: case.mu,
            ways: case.mu,
            block: case.block,
            offset: case.offset,
            ..RubbingPress::new()
        };
        let [q, rate, accel] = case.state;
        let found = match case.at_rest {
            true => press.statics(q, rate, -500.0),
            false => press.forces(q, rate, accel, -500.0),
        };
        let f = found.unwrap();
        let reactions =
            [f.AB.A.x, f.AB.A.y, f.BC.B.x, f.BC.B.y, f.BC.C.x, f.BC.C.y, f.ram.bed.normal];
        close(case.name, &reactions, &case.reactions[..7]);
        close(case.name, &[f.theta.drive], &[case.drive]);
        close(case.name, &[f.ram.bed.couple], &case.reactions[7..]);
        let slips = press.velocity(q, rate).unwrap();
        let slips = [rate, slips.BC.omega - rate, slips.BC.omega, slips.ram.slide];
        let losses = case.amounts.iter().zip(slips).map(|(amount, slip)| amount * slip.abs());
        close(case.name, &[f.losses], &[losses.sum()]);
    }
}

#[test]
fn a_four_bar_agrees_with_the_full_matrix() {
    for case in &FOUR_BARS {
        let four_bar = RubbingFourBar { mu: case.mu, ..RubbingFourBar::new() };
        let [q, rate, accel] = case.state;
        let f = four_bar.forces(q, rate, accel).unwrap();
        let reactions = [f.AB.A, f.BC.B, f.BC.C, f.DC.D].map(|force| [force.x, force.y]).concat();
        close("four-bar", &reactions, &case.reactions);
        close("four-bar", &[f.theta.drive], &[case.drive]);
    }
}

#[test]
fn guide_inverse() {
    let f = RubbingRam::new().forces(1.0, 12.0, 0.0, -500.0).unwrap();
    close("normal", &[f.ram.bed.normal], &[467.497_123_841_861_343]);
    close("torque", &[f.theta.drive], &[-17.729_532_922_935_056_4]);
}

/// Every joint rubs, pins of 20 mm, a block of 60 mm: torques and accelerations that a matrix in forty digits and
/// a walk over the links found alike.
#[test]
fn a_press_by_its_constants() {
    for (mu, torque, second) in [
        (0.1, -18.356_190_772_738_57, 214.909_102_167_958),
        (0.3, -10.414_682_421_485_23, 188.740_251_576_792_8),
    ] {
        let press = RubbingPress { pins: mu, ways: mu, ..RubbingPress::new() };
        let f = press.forces(1.0, 12.0, 0.0, -500.0).unwrap();
        close("torque", &[f.theta.drive], &[torque]);
        let found = press.forward_dynamics(1.0, 12.0, 50.0, -500.0).unwrap();
        // The accelerations are given to sixteen digits.
        close("acceleration", &[found], &[second]);
    }
}

/// tan(α ± 2φ), which is infinite where the wedge jams, at α + 2φ = 90°.
#[test]
fn wedge() {
    let wedge = Wedge::new();
    let [forwards, backwards] = [1.0, -1.0].map(|creep| wedge.statics(0.1, creep).unwrap().x.drive);
    close("forwards", &[forwards], &[610.910_265_029_519_968]);
    close("backwards", &[backwards], &[150.857_574_332_724_998]);
    // The last follows the angle of friction, known to some ε, by 1/cos².
    for (share, jams) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
        let angle = 35.0_f64.to_radians() * share;
        let wedge = Wedge { mu: angle.tan(), ..wedge };
        let found = wedge.statics(0.1, 1.0);
        assert_eq!(matches!(found, Err(SolveError::Jams { .. })), jams, "{found:?}");
    }
}

#[test]
fn incline() {
    let block = Incline::new();
    let drive = |creep| block.statics(0.2, creep).unwrap().s.drive;
    close("up", &[drive(1.0)], &[30.603_664_944_988_693_227]);
    close("down", &[drive(-1.0)], &[2.948_511_115_259_409_484]);
    let slides = block.forward_dynamics(0.2, -1.0, 0.0).unwrap();
    close("slides down", &[slides], &[-0.589_702_223_051_881_896_891]);
    // Without a creep friction is left out.
    close("frictionless", &[drive(0.0)], &[5.0 * 9.81 * 20.0_f64.to_radians().sin()]);
}

#[test]
fn journal() {
    let f = Journal::new().forces(0.3, 100.0, 0.0).unwrap();
    close("torque", &[f.theta.drive, f.losses], &[0.235_44, 23.544]);
    // Its acceleration does not depend on its speed.
    let seconds = |rate: f64| -rate / Journal::new().forward_dynamics(0.3, rate, 0.0).unwrap();
    close("comes to rest", &[seconds(100.0)], &[382.262_996_941_896_024]);
    assert_eq!(seconds(100.0), 1e3 * seconds(0.1));
}

#[test]
fn drawer() {
    let pull = |beside| Drawer { beside }.statics(0.1, 1.0);
    close("pull", &[pull(0.4).unwrap().x.drive], &[60.0]);
    assert!(pull(0.6 * (1.0 - 1e-12)).is_ok());
    assert_eq!(pull(0.6), Err(SolveError::Jams { joint: "drawer" }));
}

/// Beside a slip of zero the motion is just starting, and its direction decides.
#[test]
fn a_motion_that_starts_rubs_against_its_acceleration() {
    let block = Incline::new();
    let drive = |accel| block.forces(0.2, 0.0, accel).unwrap().s.drive - 5.0 * accel;
    close("up", &[drive(1e-3)], &[30.603_664_944_988_693_227]);
    close("down", &[drive(-1e-3)], &[2.948_511_115_259_409_484]);
}

/// The band is that of two creeps, and holds the drive without friction.
#[test]
fn a_band_holds_the_frictionless_drive() {
    let press = RubbingPress::new();
    for step in 0..60 {
        let q = 0.1 * f64::from(step) + 0.05;
        let Ok([backwards, forwards]) = press.holding(q, -500.0) else { continue };
        let creep = |creep| press.statics(q, creep, -500.0).unwrap().theta.drive;
        assert_eq!([backwards, forwards], [-1.0, 1.0].map(creep));
        let without = creep(0.0);
        assert!(backwards < without && without < forwards, "{q}: {backwards} {without} {forwards}");
    }
    // It holds itself from the coefficient on at which the lower end is zero, tan(α) = tan(2φ).
    let mu = 10.0_f64.to_radians().tan();
    for (share, holds) in [(0.999, false), (1.001, true)] {
        let [backwards, forwards] = Wedge { mu: mu * share, ..Wedge::new() }.holding(0.1).unwrap();
        assert_eq!(backwards < 0.0, holds);
        assert!(forwards > 0.0);
    }
}
