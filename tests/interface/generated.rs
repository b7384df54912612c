//! The generated interface as a user types it: fields, arrays and named inputs, defaults, angles.

use core::f64::consts::{PI, TAU};
use linkage_core::Side;
use linkage_tests::mechanisms::{drivers::*, published::*, single_groups::*};

#[test]
fn constants_need_no_type() {
    assert_eq!(CrankRpp::OUTPUTS, ["B.x", "B.y", "block.slide", "yoke.slide"]);
    assert_eq!(CrankRpp::INPUTS, ["theta"]);
    assert_eq!(CrankRpp::PARAMS, [""; 0]);
    assert_eq!(FunctionGenerator::PARAMS, ["coupler", "rocker"]);
    assert!(CrankRpp::COST.position.total() < CrankRpp::COST.motion.total());
    const YOKE: CrankRpp = CrankRpp::new();
    assert!(YOKE.position(0.0).is_ok());
}

#[test]
fn inputs_by_name_or_in_order() {
    let arm = PolarArm::new();
    let named = PolarArmInput { phi: 0.5, r: 0.75 };
    assert_eq!(arm.position(named).unwrap(), arm.position([0.5, 0.75]).unwrap());
    let rates = PolarArmInput { phi: 1.0, r: -1.0 };
    assert_eq!(
        arm.velocity(named, rates).unwrap(),
        arm.velocity([0.5, 0.75], [1.0, -1.0]).unwrap()
    );
}

#[test]
fn a_motion_holds_what_the_others_return() {
    // One graph each: the same numbers up to what is shared differently.
    let shear = FlyingShear::new();
    let motion = shear.motion(2.0, 0.5, 0.25).unwrap();
    assert_eq!(motion.position, shear.position(2.0).unwrap());
    let velocity = shear.velocity(2.0, 0.5).unwrap();
    for (one, other) in motion.velocity.rows().into_iter().zip(velocity.rows()) {
        assert!((one - other).abs() <= 8.0 * f64::EPSILON * one.abs());
    }
}

#[test]
fn a_resolver_gives_sine_and_cosine() {
    let shear = FlyingShear::new();
    for step in -64..=64 {
        let theta = f64::from(step) * 0.046875;
        let (sin, cos) = theta.sin_cos();
        let by_angle = shear.motion(theta, 0.5, 0.25).unwrap();
        let by_resolver = shear.motion_at(cos, sin, 0.5, 0.25).unwrap();
        // Sine and cosine may differ by an ulp; the table's conditions are below 40.
        for (one, other) in by_angle.position.rows().into_iter().zip(by_resolver.position.rows()) {
            assert!((one - other).abs() <= 80.0 * f64::EPSILON);
        }
        assert_eq!(by_resolver.position, shear.position_at(cos, sin).unwrap());
        let rows = shear.velocity_at(cos, sin, 0.5).unwrap().rows();
        for (one, other) in by_resolver.velocity.rows().into_iter().zip(rows) {
            assert!((one - other).abs() <= 8.0 * f64::EPSILON * one.abs());
        }
    }
}

#[test]
fn angles_unroll_over_turns() {
    let bars = CouplerFourBar::new();
    let mut crank = bars.position(0.0).unwrap().AB.angle();
    for step in 1..=100 {
        let theta = f64::from(step) * 0.25;
        let ab = bars.position(theta).unwrap().AB;
        crank = ab.angle_near(crank);
        assert!((crank - theta - 0.2).abs() <= 4.0 * f64::EPSILON * crank, "{crank} at {theta}");
        assert!(ab.angle() > -PI && ab.angle() <= PI);
    }
    assert!(crank > 3.0 * TAU);
}

#[test]
fn an_angle_between_links_does_not_jump() {
    let generator = FunctionGenerator::new();
    let bars = CouplerFourBar { elbow: Side::Right, ..CouplerFourBar::new() };
    for degree in 0..360 {
        let theta = f64::from(degree).to_radians();
        let pose = generator.position(theta).unwrap();
        // The transmission angle stays on its side of 0 and π.
        assert!(pose.fold.sin < -0.5 || pose.fold.sin > 0.5);
        let pose = bars.position(theta).unwrap();
        let between = pose.BC.angle_from(pose.DC);
        let direct = pose.BC.cos * pose.DC.cos + pose.BC.sin * pose.DC.sin;
        assert!((between.cos() - direct).abs() <= 4.0 * f64::EPSILON);
    }
}

#[test]
fn defaults_serve_every_scalar() {
    let narrow = FunctionGenerator::<f32>::default();
    assert_eq!((narrow.coupler, narrow.rocker), (4.128_654, 2.322_462));
    let lifted = FunctionGenerator::new().lift::<f32>();
    assert_eq!(lifted.coupler, narrow.coupler);
    let changed = FunctionGenerator { coupler: 4.2, ..FunctionGenerator::new() };
    assert_eq!((changed.coupler, changed.rocker), (4.2, 2.322_462));
    let copy = changed;
    assert_eq!(format!("{copy:?}"), format!("{changed:?}"));
}

#[test]
fn the_straight_line_says_whether_its_numbers_may_be_used() {
    // The pose of a double-rocker exists on a part of the turn only.
    let reach = FunctionGenerator { coupler: 1.5, rocker: 3.0 };
    let mut there = 0;
    for degree in 0..360 {
        let theta = f64::from(degree).to_radians();
        let (pose, usable) = reach.solve_position(theta);
        let answer = reach.position(theta);
        assert_eq!(usable, answer.is_ok(), "at {degree}°");
        if let Ok(found) = answer {
            assert_eq!(found, pose);
            there += 1;
        }
    }
    assert!(there > 0 && there < 360);
    assert!(!reach.solve_position(f64::NAN).1);
    assert!(!reach.solve_motion(0.0, 1.0e200, 0.0).1);
}
