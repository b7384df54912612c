//! Properties that hold exactly, whatever the solver does: straight lines, ellipses, cognates.
//!
//! Tolerances: a mechanism of n groups rounds some 20 n times; each rounding costs at most
//! ε/2 · size · amplification, the latter the product of 1/|sin| of the angles at the inner
//! joints. Where a test says `k * EPSILON`, k is that product with the numbers next to it.

use core::f64::consts::{FRAC_PI_2, PI};
use linkage_core::Side;
use linkage_tests::mechanisms::identities::*;

const EPSILON: f64 = f64::EPSILON;

#[track_caller]
fn assert_close(value: f64, truth: f64, tolerance: f64) {
    let error = (value - truth).abs();
    assert!(error <= tolerance, "{value} against {truth}: {error:e} > {tolerance:e}");
}

fn every_degree(from: i32, to: i32) -> impl Iterator<Item = f64> {
    (from..=to).map(|degree| f64::from(degree).to_radians())
}

#[test]
fn peaucelliers_point_runs_on_a_straight_line() {
    // Three groups, two of them in a chain, of sizes 8.5 and 9: the angles at U and L stay above
    // 15°, the one at P between 77° and 111°.
    let tolerance = 40.0 * EPSILON * 9.0 / 0.25;
    for theta in every_degree(-60, 60) {
        let motion = Peaucellier::new().motion(theta, 1.3, 0.4).unwrap();
        assert_close(motion.position.P.x, 4.875, tolerance);
        assert_close(motion.position.P.y, 4.875 * (theta / 2.0).tan(), tolerance);
        assert_close(motion.velocity.P.x, 0.0, 10.0 * tolerance);
        let half = (theta / 2.0).cos().powi(-2) / 2.0;
        assert_close(motion.velocity.P.y, 4.875 * half * 1.3, 10.0 * tolerance);
        assert_close(motion.acceleration.P.x, 0.0, 100.0 * tolerance);
        let turning = half * (theta / 2.0).tan() * 1.3 * 1.3 + half * 0.4;
        assert_close(motion.acceleration.P.y, 4.875 * turning, 100.0 * tolerance);
    }
}

#[test]
fn scott_russells_point_runs_up_and_down() {
    // One group of size 3; rod and guide meet at θ, so 1/cos θ ≤ 6 up to 80°.
    let tolerance = 10.0 * EPSILON * 3.0 * 6.0;
    for theta in every_degree(-80, 80) {
        let (omega, alpha) = (2.0, -1.0);
        let motion = ScottRussell::new().motion(theta, omega, alpha).unwrap();
        let (sin, cos) = theta.sin_cos();
        assert_close(motion.position.P.x, 0.0, tolerance);
        assert_close(motion.position.P.y, 3.0 * sin, tolerance);
        assert_close(motion.position.block.slide, 3.0 * cos, tolerance);
        assert_close(motion.velocity.P.x, 0.0, 12.0 * tolerance);
        assert_close(motion.velocity.block.slide, -3.0 * omega * sin, 12.0 * tolerance);
        let second = -3.0 * (omega * omega * cos + alpha * sin);
        assert_close(motion.acceleration.block.slide, second, 150.0 * tolerance);
        assert_close(motion.acceleration.P.x, 0.0, 150.0 * tolerance);
    }
}

#[test]
fn a_trammel_draws_an_ellipse() {
    for step in -49..=49 {
        let x = f64::from(step) / 10.0;
        let motion = Trammel::new().motion(x, 1.0, 0.0).unwrap();
        let height = ((5.0 - x) * (5.0 + x)).sqrt();
        // The block's height is 5²/height times as sensitive as x; one group of size 5.
        let tolerance = 10.0 * EPSILON * 25.0 / height;
        assert_close(motion.position.block.slide, height, tolerance);
        assert_close(motion.velocity.block.slide, -x / height, 10.0 * tolerance / height);
        // P is 2/5 as high as the block: its height times that error loses the denominator.
        let at = motion.position.P;
        assert_close((at.x / 3.0).powi(2) + (at.y / 2.0).powi(2), 1.0, 40.0 * EPSILON);
        let middle = motion.position.middle;
        assert_close(middle.x.hypot(middle.y), 2.5, 60.0 * EPSILON);
    }
}

#[test]
fn freudensteins_equation_holds() {
    // K1 = d/a, K2 = d/c, K3 = (a² − b² + c² + d²)/(2ac). The angle at C stays within 65°
    // and 131°, so the rocker's angle is good to 10 ε · 10.5/2.5/0.75; the equation multiplies that
    // by at most K1 + 1.
    let (k1, k2, k3) = (4.0, 4.0 / 2.5, (1.0 - 9.0 + 6.25 + 16.0) / 5.0);
    for theta in every_degree(-180, 180) {
        let psi = Freudenstein::new().position(theta).unwrap().DC.angle();
        let sum = k1 * psi.cos() - k2 * theta.cos() + k3 - (theta - psi).cos();
        assert_close(sum, 0.0, 5.0 * 60.0 * EPSILON);
    }
}

#[test]
fn a_parallelogram_keeps_its_coupler_level() {
    // One group of size 6; sin of the angle at C is |sin θ|. Left is the parallelogram for
    // 0 < θ < π and the antiparallelogram beyond.
    for (degree, elbow) in [(20, Side::Left), (100, Side::Left), (170, Side::Left)]
        .into_iter()
        .chain([(190, Side::Right), (250, Side::Right), (340, Side::Right)])
    {
        let theta = f64::from(degree).to_radians();
        let tolerance = 10.0 * EPSILON * 6.0 / theta.sin().abs();
        let bars = ChangePoint { elbow, ..ChangePoint::new() };
        let motion = bars.motion(theta, 1.0, 0.0).unwrap();
        assert_close(motion.position.BC.angle(), 0.0, tolerance);
        assert_close(motion.velocity.BC.omega, 0.0, tolerance / theta.sin().abs());
        assert_close(motion.velocity.DC.omega, 1.0, tolerance / theta.sin().abs());
        assert_close(motion.acceleration.DC.alpha, 0.0, tolerance / theta.sin().powi(2));

        let crossed = ChangePoint { elbow: elbow.flipped(), ..ChangePoint::new() };
        let psi = crossed.position(theta).unwrap().DC.angle();
        let ratio = (psi / 2.0).tan() / (theta / 2.0).tan();
        let swing = 1.0 + (psi / 2.0).tan().powi(2);
        assert_close(ratio, -3.0, tolerance * swing / (theta / 2.0).tan().abs());
    }
}

#[test]
fn a_following_crank_passes_the_change_points() {
    for theta in every_degree(-180, 180).chain([0.0, PI, -PI, 1.0e-9]) {
        let motion = Parallelogram::new().motion(theta, 3.0, -2.0).unwrap();
        let (b, c) = (motion.position.B, motion.position.C);
        // The same direction serves both cranks: only the base differs.
        assert_close(c.x - b.x, 2.0, EPSILON);
        assert_eq!(c.y, b.y);
        assert_eq!(motion.velocity.DC.omega, motion.velocity.AB.omega);
        assert_eq!(motion.acceleration.C.x, motion.acceleration.B.x);
    }
}

#[test]
fn cognates_draw_one_curve() {
    let sides = [(5, Side::Left), (50, Side::Left), (95, Side::Left)].into_iter().chain([
        (160, Side::Right),
        (222, Side::Right),
        (300, Side::Right),
    ]);
    for (degree, elbow) in sides {
        let theta = f64::from(degree).to_radians();
        let motion = Cognates { elbow, ..Cognates::new() }.motion(theta, 2.0, 0.5).unwrap();
        // Two groups of size 10 and 7; at these angles both keep 1/|sin| below 6.
        let tolerance = 40.0 * EPSILON * 10.0 * 6.0;
        assert_close(motion.position.P.x, motion.position.Q.x, tolerance);
        assert_close(motion.position.P.y, motion.position.Q.y, tolerance);
        assert_close(motion.velocity.P.x, motion.velocity.Q.x, 12.0 * tolerance);
        assert_close(motion.velocity.P.y, motion.velocity.Q.y, 12.0 * tolerance);
        assert_close(motion.acceleration.P.x, motion.acceleration.Q.x, 150.0 * tolerance);
        assert_close(motion.acceleration.P.y, motion.acceleration.Q.y, 150.0 * tolerance);
    }
}

#[test]
fn scotch_yokes_are_harmonic() {
    let (omega, alpha, r) = (7.0, 3.0, 0.8);
    let (cot, csc) = (1.1_f64.tan().recip(), 1.1_f64.sin().recip());
    for theta in every_degree(-180, 180) {
        let motion = ScotchYokes::new().motion(theta, omega, alpha).unwrap();
        let (sin, cos) = theta.sin_cos();
        let (first, second) = (omega, omega * omega);
        let place = motion.position;
        // No inner joint: five roundings of numbers below 2 r.
        let tolerance = 5.0 * EPSILON * 2.0 * r;
        assert_close(place.yoke.slide, r * cos, tolerance);
        assert_close(place.die.slide, r * sin, tolerance);
        assert_close(place.wedge.slide, r * (cos - sin * cot), tolerance);
        assert_close(place.shoe.slide, r * sin * csc, tolerance);
        let rate = motion.velocity;
        assert_close(rate.yoke.slide, -r * first * sin, tolerance * first);
        assert_close(rate.wedge.slide, -r * first * (sin + cos * cot), tolerance * first);
        let twice = motion.acceleration;
        let x = -r * (second * cos + alpha * sin);
        let y = r * (alpha * cos - second * sin);
        assert_close(twice.yoke.slide, x, tolerance * second);
        assert_close(twice.die.slide, y, tolerance * second);
        assert_close(twice.wedge.slide, x - y * cot, tolerance * second);
        assert_close(twice.shoe.slide, y * csc, tolerance * second);
    }
}

#[test]
fn whitworths_bar_follows_its_formula() {
    // s² = 1 + d² + 2 d sin θ, ω₃ = ω (1 + d sin θ)/s², α₃ = ω² d cos θ (d² − 1)/s⁴.
    let omega = 3.0;
    for depth in [2.0, 0.4] {
        let press = Whitworth { depth };
        for theta in every_degree(-180, 180) {
            let motion = press.motion(theta, omega, 0.0).unwrap();
            let (sin, cos) = theta.sin_cos();
            let square = 1.0 + depth * depth + 2.0 * depth * sin;
            // Sizes 1 + d over s ≥ |d − 1| ≥ 0.6: a relative 3 at the worst, squared for the rest.
            let tolerance = 10.0 * EPSILON * (1.0 + depth) * 3.0;
            assert_close(motion.position.block.slide, square.sqrt(), tolerance);
            let swing = omega * (1.0 + depth * sin) / square;
            assert_close(motion.velocity.bar.omega, swing, 9.0 * omega * tolerance);
            let second = omega * omega * depth * cos * (depth * depth - 1.0) / (square * square);
            assert_close(motion.acceleration.bar.alpha, second, 81.0 * omega * omega * tolerance);
        }
    }
}

#[test]
fn the_quick_return_takes_the_time_its_formula_says() {
    // The bar of d = 2 r turns back where the crank is square to it: at θ = −90° ± 60°, so the
    // slow stroke takes 240° of the crank, the quick one 120°.
    let press = Whitworth::new();
    for (degrees, sign) in [(-31, -1.0), (-29, 1.0), (209, 1.0), (211, -1.0)] {
        let rate = press.velocity(f64::from(degrees).to_radians(), 1.0).unwrap();
        assert!(rate.bar.omega * sign > 0.0, "at {degrees}°: {}", rate.bar.omega);
    }
    let dead = press.velocity(-FRAC_PI_2 + PI / 3.0, 1.0).unwrap();
    // 1 + d sin θ vanishes: what is left is the rounding of sin θ times d over s² = 3.
    assert_close(dead.bar.omega, 0.0, 4.0 * EPSILON);
}
