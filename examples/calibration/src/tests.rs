//! The six-bar of the example is calibrated, and its confidence intervals mean what they say.

use crate::fit::calibrate;
use crate::machine::{self, TRACKED, UNKNOWNS, built, drawn, six_bar, tracked};
use crate::measurement::{NOISE, POSES, measure};
use linkage_core::nalgebra::SMatrix;
use linkage_design::DesignError;

#[test]
fn without_noise_the_dimensions_are_those_of_the_machine() {
    let mut measurement = measure(built(), 1).unwrap();
    for (theta, seen) in measurement.thetas.iter().zip(&mut measurement.seen) {
        *seen = tracked(built(), *theta).unwrap();
    }
    let found = calibrate(&measurement).unwrap();
    for (found, built) in found.dimensions.into_iter().zip(built()) {
        // The normal equations' condition, below 10⁷, times a few roundings.
        assert!((found - built).abs() < 1e-8, "{found} {built}");
    }
}

#[test]
fn noise_is_estimated_and_dimensions_are_found() {
    let found = calibrate(&measure(built(), 1).unwrap()).unwrap();
    let freedom = (POSES * TRACKED - UNKNOWNS) as f64;
    // The deviation of an estimated deviation, relative to it, is 1/√(2ν): four times that.
    assert!((found.noise / NOISE - 1.0).abs() < 4.0 / (2.0 * freedom).sqrt(), "{}", found.noise);
    for i in 0..UNKNOWNS {
        let [error, off] = [found.dimensions[i], drawn()[i]].map(|x| (x - built()[i]).abs());
        assert!(error < 2.0 * found.half_widths[i]);
        // Half a millimetre, or milliradian, at the worst.
        assert!(found.half_widths[i] < 0.5e-3 && off > 0.2e-3);
    }
}

/// The count of intervals, of n, that hold the true dimension is 0.95 n with a deviation of √(0.95·0.05 n).
/// Each dimension's count is within four deviations, and the counts' mean, which deviates less, within one
/// and a half. Intervals half as wide again hold 99.7 %, those a third narrower 81 %.
#[test]
fn intervals_hold_the_truth_as_often_as_they_should() {
    let calibrations = if cfg!(debug_assertions) { 100 } else { 1000 };
    let held = crate::coverage::held(built(), calibrations).unwrap();
    let count = calibrations as f64;
    let deviation = (0.95 * 0.05 * count).sqrt();
    for held in held {
        assert!((f64::from(held) - 0.95 * count).abs() < 4.0 * deviation, "{held}");
    }
    let mean = f64::from(held.iter().sum::<u32>()) / UNKNOWNS as f64;
    assert!((mean - 0.95 * count).abs() < 1.5 * deviation, "{mean}");
    println!("{held:?} of {calibrations}, {mean:.1} on average");
}

/// The intervals are those of s² (JᵀJ)⁻¹ by the solver's own sensitivities, with Student's quantile of 202
/// degrees of freedom.
#[test]
fn intervals_are_those_of_the_normal_equations() {
    let measurement = measure(built(), 1).unwrap();
    let found = calibrate(&measurement).unwrap();
    let mut squares = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::zeros();
    for theta in &measurement.thetas {
        let slopes = six_bar(found.dimensions).sensitivity(*theta).unwrap();
        squares += slopes.transpose() * slopes;
    }
    let inverse = squares.cholesky().unwrap().inverse();
    for i in 0..UNKNOWNS {
        let quantile = found.half_widths[i] / (found.noise * inverse[(i, i)].sqrt());
        // The normal equations' condition, below 10⁷, times some roundings.
        assert!((quantile - 1.971_777).abs() < 1e-5, "{i}: {quantile}");
    }
}

#[test]
fn poses_that_say_too_little_are_refused() {
    let mut measurement = measure(built(), 1).unwrap();
    measurement.thetas.truncate(2);
    measurement.seen.truncate(2);
    let refused = calibrate(&measurement);
    assert!(matches!(refused, Err(DesignError::Undetermined { .. })), "{refused:?}");
}

#[test]
fn unknowns_are_the_parameters_in_their_order() {
    let dimensions = core::array::from_fn(|i| i as f64);
    let bars = six_bar(dimensions);
    assert_eq!(machine::SixBar::PARAMS[6], "crank");
    assert_eq!((bars.ax, bars.crank, bars.lever, bars.zero), (0.0, 6.0, 12.0, 13.0));
    assert_eq!(machine::SixBar::PARAMS[13], "zero");
}
