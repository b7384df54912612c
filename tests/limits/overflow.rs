//! Inputs of any size: what is called solved is finite.
//!
//! The straight line asks inputs and divisors where bounds show that nothing overflows, and the
//! results elsewhere. These poses lie on both sides of every bound, near limits and away from
//! them, in both widths and with derivatives: a sample of those of `.ci/nightly`.

use linkage_core::Scalar;
use linkage_core::num_dual::Dual;
use linkage_tests::mechanisms::change_points::{EqualSliderCrank, FourOneTwoThree};
use linkage_tests::mechanisms::published::{FourBar, FunctionGenerator, SixBar};
use linkage_tests::mechanisms::single_groups::{
    CouplerFourBar, CrossedGuides, InclinedSliderCrank, ObliqueYoke, OffsetQuickReturn,
};
use linkage_tests::mechanisms::twins::ConstantDragLink;
use linkage_tests::random::{Random, cases};

/// The counts of poses, by the path that answered.
#[derive(Default)]
struct Answers {
    straight: u32,
    careful: u32,
    refused: u32,
}

impl Answers {
    /// Each way of answering occurs, or the poses would show nothing.
    #[track_caller]
    fn are_of_every_kind(&self) {
        let Self { straight, careful, refused } = *self;
        assert!(straight > 100 && careful > 0 && refused > 100, "{straight} {careful} {refused}");
    }
}

/// A magnitude up to the width's largest, all exponents alike, of either sign.
fn any_size(random: &mut Random, digits: f64) -> f64 {
    let size = 10f64.powf(random.between(-10.0, digits));
    if random.between(-1.0, 1.0) < 0.0 { -size } else { size }
}

/// An angle near a multiple of a quarter turn, where dead points are, or anywhere.
fn any_angle(random: &mut Random) -> f64 {
    let quarter = random.between(-4.0, 4.0).round() * std::f64::consts::FRAC_PI_2;
    match random.between(0.0, 3.0) as u32 {
        0 => random.between(-9.0, 9.0),
        1 => quarter,
        _ => quarter + any_size(random, 0.0),
    }
}

/// The poses of one mechanism in one kind of number; `$of` makes it of a value.
macro_rules! poses {
    ($answers:ident, $random:ident, $digits:literal, $t:ty, $of:expr, [$($mechanism:ident),*]) => {$(
        let solver = $mechanism::<$t>::default();
        for _ in 0..cases(1200, 4000) {
            let theta = $of(any_angle(&mut $random));
            let [omega, alpha] = [(); 2].map(|()| $of(any_size(&mut $random, $digits)));
            let all_finite = |rows: &[&[$t]]| rows.concat().into_iter().all(Scalar::is_finite);
            let (motion, ok) = solver.solve_motion(theta, omega, alpha);
            let (p, v, a) =
                (motion.position.rows(), motion.velocity.rows(), motion.acceleration.rows());
            if ok {
                $answers.straight += 1;
                assert!(all_finite(&[&p, &v, &a]), "{theta:?} {omega:?} {alpha:?}: {motion:?}");
            }
            match solver.motion(theta, omega, alpha) {
                Ok(motion) => {
                    $answers.careful += u32::from(!ok);
                    let (p, v, a) = (
                        motion.position.rows(),
                        motion.velocity.rows(),
                        motion.acceleration.rows(),
                    );
                    assert!(all_finite(&[&p, &v, &a]), "{theta:?} {omega:?} {alpha:?}: {motion:?}");
                }
                Err(_) => {
                    assert!(!ok, "{theta:?} {omega:?} {alpha:?} is solved and refused");
                    $answers.refused += 1;
                }
            }
        }
    )*};
}

macro_rules! every_mechanism {
    ($answers:ident, $random:ident, $digits:literal, $t:ty, $of:expr) => {
        poses!(
            $answers,
            $random,
            $digits,
            $t,
            $of,
            [
                CouplerFourBar,
                InclinedSliderCrank,
                OffsetQuickReturn,
                CrossedGuides,
                ObliqueYoke,
                FourBar,
                SixBar,
                FunctionGenerator,
                FourOneTwoThree,
                EqualSliderCrank
            ]
        )
    };
}

#[test]
fn what_is_solved_in_f64_is_finite() {
    let (mut random, mut answers) = (Random::new(1), Answers::default());
    every_mechanism!(answers, random, 308.0, f64, |x: f64| x);
    answers.are_of_every_kind();
}

#[test]
fn what_is_solved_in_f32_is_finite() {
    let (mut random, mut answers) = (Random::new(2), Answers::default());
    every_mechanism!(answers, random, 38.0, f32, |x: f64| x as f32);
    answers.are_of_every_kind();
}

/// A derivative may overflow where the value does not.
#[test]
fn what_is_solved_with_derivatives_is_finite_with_them() {
    let (mut random, mut answers) = (Random::new(3), Answers::default());
    every_mechanism!(answers, random, 308.0, Dual<f64>, |x: f64| Dual::new(x, x));
    answers.are_of_every_kind();
}

/// The straight line compares an angle and its rates at once: each goes to its own limit, where the others are
/// small, and what is beyond is left to the careful path.
macro_rules! limits_of_an_angle {
    ($solver:ty, $t:ty, $near:expr) => {{
        let (solver, near): (_, $t) = (<$solver>::default(), $near);
        for (input, limit) in [near, near, near * near].into_iter().enumerate() {
            let alone =
                |value: $t| std::array::from_fn(|nth| if nth == input { value } else { 1.0 });
            let cos_sin = |theta: $t| Scalar::sin_cos(theta);
            for (part, is_within) in [(0.99, true), (1.01, false), (<$t>::NAN, false)] {
                let [theta, omega, alpha]: [$t; 3] = alone(limit * part);
                let (sin, cos) = cos_sin(if input == 0 { 1.0 } else { theta });
                assert_eq!(
                    solver.solve_motion(theta, omega, alpha).1,
                    is_within,
                    "{theta} {omega} {alpha}"
                );
                assert_eq!(
                    solver.solve_velocity(theta, omega).1,
                    is_within || input == 2,
                    "{theta} {omega}"
                );
                // Cosine and sine leave all of the limit to the rates.
                let at = solver.solve_motion_at(cos, sin, omega, alpha).1;
                assert_eq!(at, is_within || input == 0, "{omega} {alpha}");
                let at = solver.solve_velocity_at(cos, sin, omega).1;
                assert_eq!(at, is_within || input != 1, "{omega}");
                assert_eq!(solver.motion(theta, omega, alpha).is_ok(), !part.is_nan());
            }
        }
    }};
}

#[test]
fn an_angle_and_its_rates_are_compared_at_once() {
    limits_of_an_angle!(FourBar<f64>, f64, 2.0_f64.powi(20));
    limits_of_an_angle!(ConstantDragLink<f64>, f64, 2.0_f64.powi(20));
    limits_of_an_angle!(FourBar<f32>, f32, 51_471.0);
    limits_of_an_angle!(ConstantDragLink<f32>, f32, 51_471.0);
}

/// Beyond the bounds of the straight line the careful path still solves what can be solved.
#[test]
fn what_is_finite_is_solved() {
    let bars = CouplerFourBar::<f64>::default();
    // About 1e59, 1e61, 1e100 and 1e140.
    for omega in [196, 203, 332, 465].map(|power| 2.0_f64.powi(power)) {
        let motion = bars.motion(1.0, omega, 0.0).unwrap();
        let unit = bars.motion(1.0, 1.0, 0.0).unwrap();
        // Velocities are linear and accelerations quadratic in the rate; a few roundings each.
        for (value, unit) in motion.velocity.rows().into_iter().zip(unit.velocity.rows()) {
            assert!((value / omega - unit).abs() <= 8.0 * f64::EPSILON * unit.abs());
        }
        for (value, unit) in motion.acceleration.rows().into_iter().zip(unit.acceleration.rows()) {
            assert!((value / omega / omega - unit).abs() <= 32.0 * f64::EPSILON * unit.abs());
        }
    }
    assert!(bars.motion(1.0, 1e200, 0.0).is_err());
}
