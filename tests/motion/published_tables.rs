//! The numbers printed in the course work that the published mechanisms come from.

use core::f64::consts::{FRAC_PI_2, PI};
use linkage_tests::mechanisms::published::*;
use linkage_tests::tables;

#[track_caller]
fn assert_close(value: f64, printed: f64, tolerance: f64) {
    let error = (value - printed).abs();
    assert!(error <= tolerance, "{value} against {printed}: {error:e} > {tolerance:e}");
}

#[test]
fn the_four_bar_has_its_printed_table() {
    for &(degrees, printed) in tables::four_bar_published::ROWS {
        let motion = FourBar::new().motion(f64::to_radians(degrees), 250.0, 0.0).unwrap();
        let found = [
            motion.position.BC.angle().to_degrees(),
            motion.position.DC.angle().to_degrees(),
            motion.velocity.BC.omega,
            motion.velocity.DC.omega,
            motion.acceleration.BC.alpha,
            motion.acceleration.DC.alpha,
        ];
        for (value, cell) in found.into_iter().zip(printed) {
            // Half a unit of the last printed place, and what printing it in f64 adds.
            if let Some(cell) = cell {
                assert_close(value, cell, 0.5 + 1.0e-7);
            }
        }
    }
}

#[test]
fn the_four_bar_has_its_exact_anchors() {
    // With the bars in one line the velocities are rational: −250/2 at 0°, 250/4 at 180°. Both
    // poses are well conditioned (table: 6e2 and 3e2 rad/s per unit relative change).
    let start = FourBar::new().velocity(0.0, 250.0).unwrap();
    assert_close(start.BC.omega, -125.0, 20.0 * 1.3e3 * f64::EPSILON);
    assert_close(start.DC.omega, -125.0, 20.0 * 1.3e3 * f64::EPSILON);
    let half = FourBar::new().velocity(PI, 250.0).unwrap();
    assert_close(half.BC.omega, 62.5, 20.0 * 1.3e3 * f64::EPSILON);
    assert_close(half.DC.omega, 62.5, 20.0 * 1.3e3 * f64::EPSILON);
}

#[test]
fn the_crank_with_rpp_starts_as_corrected() {
    // At rest positions every number is a product of two: one rounding each, at most three more
    // where sin 90° meets cos 90° of 6e-17.
    let tolerance = 4.0 * f64::EPSILON;
    let motion = CrankRpp::new().motion(0.0, 10.0, 0.0).unwrap();
    assert_close(motion.position.block.slide, 0.8, tolerance);
    assert_close(motion.velocity.block.slide, 4.0, 4.0 * tolerance);
    assert_close(motion.acceleration.block.slide, 0.0, 40.0 * tolerance);
    assert_close(motion.position.yoke.slide, 0.4, tolerance);
    assert_close(motion.velocity.yoke.slide, 0.0, 4.0 * tolerance);
    assert_close(motion.acceleration.yoke.slide, -40.0, 40.0 * tolerance);
    let motion = CrankRpp::new().motion(FRAC_PI_2, 10.0, 0.0).unwrap();
    assert_close(motion.position.block.slide, 1.2, tolerance);
    assert_close(motion.velocity.yoke.slide, -4.0, 4.0 * tolerance);
    assert_close(motion.acceleration.block.slide, -40.0, 40.0 * tolerance);
}

#[test]
fn the_six_bar_starts_as_printed() {
    // Printed with four decimals. The printed slide of the pin, 0.4 m, contradicts the stated
    // 800 mm and is left out; the pin is 0.2 m below the ram's rail.
    let printed = 5.1e-5;
    let motion = SixBar::new().motion(FRAC_PI_2, 10.0, 0.0).unwrap();
    assert_close(motion.position.block.slide, 1.4, 1.0e-14);
    assert_close(motion.velocity.block.slide, 0.0, 1.0e-13);
    assert_close(motion.position.rod.angle(), FRAC_PI_2, 1.0e-15);
    assert_close(motion.velocity.rod.omega, 2.8571, printed);
    assert_close(motion.position.ram.slide, 0.0, 1.0e-14);
    assert_close(motion.velocity.ram.slide, -4.5714, printed);
    assert_close(motion.velocity.pin.slide, 0.0, 1.0e-13);
    assert_close(motion.position.pin.slide, -0.2, 1.0e-14);
}

/// The squared error of the function to be generated, added up over `steps` of 90° of crank from
/// the right-hand limit.
fn objective(generator: &FunctionGenerator, steps: u32) -> f64 {
    let (l1, l2, l3, l4) = (1.0_f64, generator.coupler, generator.rocker, 5.0_f64);
    let far = l1 + l2;
    let start = ((far * far - l3 * l3 + l4 * l4) / (2.0 * far * l4)).acos();
    let limit = PI - ((l3 * l3 + l4 * l4 - far * far) / (2.0 * l3 * l4)).acos();
    (1..=steps)
        .map(|step| {
            let swing = FRAC_PI_2 * f64::from(step) / f64::from(steps);
            let wanted = limit + 2.0 / (3.0 * PI) * swing * swing;
            let found = generator.position(start + swing).unwrap().DC.angle();
            (found - wanted).powi(2)
        })
        .sum()
}

#[test]
fn the_function_generator_is_as_good_as_printed() {
    // Lengths printed with four decimals, the objective with two digits.
    let printed = FunctionGenerator { coupler: 4.1285, rocker: 2.3226 };
    assert_close(objective(&printed, 30), 0.0076, 5.0e-5);
    // The optimum in 50 digits with its lengths rounded to 1e-6: the objective is 0.00759237434,
    // and 30 squares of angles of 0.02 good to 1e-15 add nothing to that.
    assert_close(objective(&FunctionGenerator::new(), 30), 0.007_592_374_34, 1.0e-11);
}

#[test]
fn the_function_generator_is_at_its_upper_transmission_limit() {
    // Crank and ground in one line: the transmission angle is extreme there. The limit is 135°;
    // a micrometre of the lengths (in crank lengths) moves the angle by less than a microradian.
    let fold = |theta| FunctionGenerator::new().position(theta).unwrap().fold.angle().abs();
    assert_close(fold(PI).to_degrees(), 135.0, 1.0e-4);
    assert_close(fold(0.0).to_degrees(), 70.379, 5.0e-4);
    for degree in 0..360 {
        let angle = fold(f64::from(degree).to_radians());
        assert!(angle <= fold(PI) && angle >= fold(0.0), "{angle} at {degree}°");
    }
}
