//! Springs and dampers against closed forms, energy, and what is singular of them.

use core::f64::consts::{FRAC_PI_6, TAU};

use linkage_core::num_dual::DualSVec;
use linkage_core::{SolveError, differentiate};
use linkage_tests::mechanisms::forces::*;

/// Length of the spring `shock` and its slope.
fn shock(theta: f64) -> [f64; 2] {
    let (sin, cos) = theta.sin_cos();
    let (x, y) = (0.2 * cos - 0.5, 0.2 * sin);
    let length = x.hypot(y);
    [length, (-x * 0.2 * sin + y * 0.2 * cos) / length]
}

/// The slope of what the springs of `SprungCrank` store, ½ k (L − L₀)² and their like.
fn slope(theta: f64) -> f64 {
    let ([length, rate], (sin, cos)) = (shock(theta), theta.sin_cos());
    let (x, y) = (0.2 * cos + 0.3, 0.2 * sin - 0.1);
    let soft = 20.0 * 0.2 * (-x * sin + y * cos);
    150.0 * (length - 0.25) * rate + soft + 2.0 * (theta - FRAC_PI_6)
}

#[test]
fn a_spring_is_held_by_the_slope_of_its_energy() {
    let crank = SprungCrank::new();
    for step in 0..60 {
        // Nine turns: the coil is wound up, and does not jump.
        let theta = 0.97 * f64::from(step);
        let f = crank.statics(theta).unwrap();
        // A dozen roundings of torques of up to 120 N·m.
        assert!((f.theta.drive - slope(theta)).abs() < 1e-12 * 120.0, "{theta}");
        let [length, _] = shock(theta);
        assert!((f.shock.force - 150.0 * (0.25 - length)).abs() < 1e-12, "{theta}");
        assert!((f.coil.torque + 2.0 * (theta - FRAC_PI_6)).abs() < 1e-12, "{theta}");
        let p = crank.position(theta).unwrap();
        assert!((p.shock_length - length).abs() < 1e-15 && p.coil_angle == theta - FRAC_PI_6);
    }
}

#[test]
fn dampers_take_the_power_that_they_turn_into_heat() {
    let crank = SprungCrank::new();
    for step in 0..40 {
        let (theta, omega) = (0.3 * f64::from(step), 1.7 - 0.1 * f64::from(step));
        let moving = crank.forces(theta, omega, 5.0).unwrap();
        let still = crank.statics(theta).unwrap();
        let rate = shock(theta)[1] * omega;
        let heat = 3.0 * rate * rate + (0.1 + 0.4) * omega * omega;
        let power = (moving.theta.drive - still.theta.drive) * omega;
        assert!((power - heat).abs() < 1e-12, "{theta}: {power} {heat}");
        assert!((moving.shock.force - still.shock.force + 3.0 * rate).abs() < 1e-12, "{theta}");
    }
    let rocker = SprungRocker::new();
    for step in 0..40 {
        let (theta, omega) = (0.16 * f64::from(step), 2.5);
        let v = rocker.velocity(theta, omega).unwrap();
        let power = rocker.forces(theta, omega, -3.0).unwrap().theta.drive * omega;
        let spring = rocker.position(theta).unwrap().DC.angle() - TAU / 4.0;
        let folding = v.DC.omega - v.BC.omega;
        let square = v.C.x * v.C.x + v.C.y * v.C.y;
        let expected = 12.0 * spring * v.DC.omega + 0.7 * folding * folding + 2.0 * square;
        // Powers of some 1e2 W, of a few dozen operations.
        assert!((power - expected).abs() < 1e-12, "{theta}: {power} {expected}");
    }
}

#[test]
fn where_its_ends_meet_a_spring_is_singular() {
    let meeting = Meeting::new();
    let refused = meeting.statics(0.0);
    assert_eq!(refused, Err(SolveError::Singular { group: "spring E, B" }));
    assert_eq!(
        refused.unwrap_err().to_string(),
        "spring E, B: its ends meet, and it has no direction"
    );
    let refused = Meeting::<f32>::default().forces(0.0, 1.0, 0.0);
    assert_eq!(refused, Err(SolveError::Singular { group: "spring E, B" }));
    // As near as numbers come to it the direction is that of the line, and the force 5 N.
    let near = meeting.statics(1e-9).unwrap().theta.drive;
    assert!((near + 5.0 * 0.2).abs() < 1e-6, "{near}");
    // Without a free length there is no direction to be known.
    let soft = SprungCrank::new().statics(0.0).unwrap();
    assert!(soft.theta.drive.is_finite());
}

#[test]
fn a_rope_pulls_and_does_not_push() {
    let meeting = Meeting::new();
    for step in 1..30 {
        let theta = 0.1 * f64::from(step);
        let (sin, cos) = theta.sin_cos();
        let (x, y) = (0.2 * cos - 0.8, 0.2 * sin);
        let [near_x, near_y] = [0.2 * cos - 0.2, 0.2 * sin];
        let moment =
            |x: f64, y: f64, push: f64| push * (-x * 0.2 * sin + y * 0.2 * cos) / x.hypot(y);
        let pull = 500.0 * (x.hypot(y) - 0.7).max(0.0);
        let spring = 100.0 * (0.05 - near_x.hypot(near_y));
        let expected = -moment(near_x, near_y, spring) + moment(x, y, pull);
        let found = meeting.statics(theta).unwrap().theta.drive;
        // The corner is rounded off by at most half a millimetre's pull.
        assert!((found - expected).abs() <= 0.25 * 0.2 + 1e-12, "{theta}: {found} {expected}");
    }
}

#[test]
fn numbers_of_springs_are_not_negative() {
    let crank = SprungCrank { k: -1.0, ..SprungCrank::new() };
    let expected = SolveError::Invalid { group: "spring shock", name: "stiffness" };
    assert_eq!(crank.statics(0.3), Err(expected));
    assert_eq!(expected.to_string(), "spring shock: `stiffness` must not be negative");
    let crank = SprungCrank { c: -1.0, ..SprungCrank::new() };
    let expected = SolveError::Invalid { group: "spring shock", name: "damping" };
    assert_eq!(crank.forces(0.3, 1.0, 0.0), Err(expected));
    let crank = SprungCrank { k: f64::NAN, ..SprungCrank::new() };
    assert!(matches!(crank.statics(0.3), Err(SolveError::NotFinite { .. })));
}

#[test]
fn a_drive_is_differentiated_by_a_stiffness() {
    let crank = SprungCrank::new();
    let slope = differentiate([crank.k, crank.c], |[k, c]| {
        let at = |x: f64| DualSVec::from_re(x);
        let f = SprungCrank { k, c }.forces(at(0.7), at(2.0), at(0.0))?;
        Ok([f.theta.drive])
    })
    .unwrap();
    let [length, rate] = shock(0.7);
    assert!((slope[(0, 0)] - (length - 0.25) * rate).abs() < 1e-15);
    assert!((slope[(0, 1)] - 2.0 * rate * rate).abs() < 1e-15);
}

#[test]
fn what_springs_give_is_labelled() {
    assert_eq!(SprungCrank::FORCES, ["theta.drive", "shock.force", "coil.torque"]);
    assert_eq!(SprungCrank::OUTPUTS, ["shock_length", "coil_angle"]);
    assert!(SprungRocker::FORCES.contains(&"stop.torque"));
    // Only the coil needs the angle itself.
    assert!(SprungRocker::new().forces_at(0.6, 0.8, 1.0, 0.0).is_ok());
}
