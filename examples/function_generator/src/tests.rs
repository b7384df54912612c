//! The function-generating crank-rocker of the example ends at its optimum from every start.

use crate::generator::{
    FunctionGenerator, Lengths, Limit, error, objective, sloped_objective, wanted,
};
use crate::search::{STARTS, Step, by_gradients, without_gradients};
use linkage_core::differentiate_twice;

/// The optimum to 50 digits, rounded; the printed source has 4.1285, 2.3226 and 0.0076.
const COUPLER: f64 = 4.128_654_158_009_783;
const ROCKER: f64 = 2.322_461_712_412_169_4;
const OBJECTIVE: f64 = 0.007_592_373_605_334_677;

/// The searches are asked for at least nine digits of the lengths and may lose some to rounding.
const SIX_DIGITS: f64 = 5e-7;

fn assert_optimal([coupler, rocker]: Lengths, objective: f64) {
    assert!((coupler / COUPLER - 1.0).abs() < SIX_DIGITS, "coupler {coupler}");
    assert!((rocker / ROCKER - 1.0).abs() < SIX_DIGITS, "rocker {rocker}");
    assert!((objective / OBJECTIVE - 1.0).abs() < SIX_DIGITS, "objective {objective}");
    let [least, largest] =
        Limit::BOTH.map(|limit| limit.angle([coupler, rocker]).unwrap().to_degrees());
    assert!((largest / 135.0 - 1.0).abs() < SIX_DIGITS, "{largest}°");
    assert!((least - 70.379).abs() < 1e-3, "{least}°");
}

#[test]
fn exact_gradients_lead_to_the_optimum_from_every_start() {
    for start in STARTS {
        let found = by_gradients(start, &|_, _| {});
        assert_optimal(found.lengths, found.objective);
        let others = without_gradients(start, &|_, _| {});
        assert_optimal(others.lengths, others.objective);
        let [with, without] = [&found, &others].map(|found| found.to_six_digits().unwrap());
        assert!(2 * with < without, "{start:?}, {}: {with} {without}", found.status);
        assert!(others.steps.iter().all(|Step { with_gradient, .. }| !with_gradient));
    }
}

#[test]
fn progress_tells_every_evaluation() {
    let told = std::cell::Cell::new(0);
    let found = by_gradients(STARTS[0], &|count, step| {
        assert_eq!(count, told.get() + 1);
        assert_eq!(step.objective, objective(step.lengths).unwrap());
        told.set(count);
    });
    assert_eq!(told.get(), found.steps.len());
}

/// The rocker's angle by the law of cosines, without the mechanism.
fn error_by_hand([coupler, rocker]: Lengths, turn: f64) -> f64 {
    let cosines = |a: f64, b: f64, c: f64| ((a * a + b * b - c * c) / (2.0 * a * b)).acos();
    let phi = cosines(1.0 + coupler, 5.0, rocker) + turn;
    let (x, y) = (5.0 - phi.cos(), phi.sin());
    let diagonal = x.hypot(y);
    // At the rocker's pivot: the angle of the diagonal below the ground, and of the rocker above it.
    let rocker_angle = cosines(diagonal, rocker, coupler) - y.atan2(x);
    let limit = cosines(5.0, rocker, 1.0 + coupler);
    // Both angles are measured at the pivot from the ground towards the crank.
    limit - (rocker_angle + 2.0 * y.atan2(x)) - wanted(turn)
}

#[test]
fn the_error_is_that_of_the_law_of_cosines() {
    for lengths in STARTS {
        for turn in crate::generator::steps() {
            let (found, expected) = (error(lengths, turn).unwrap(), error_by_hand(lengths, turn));
            // Arc cosines of numbers up to 0.99 lose a digit.
            assert!((found - expected).abs() < 1e-14, "{lengths:?} {turn}: {found} {expected}");
        }
    }
}

/// The truncation of a central difference over h is h²/6 times the third derivative, its rounding
/// ε/h times the value: about 1e-10 of either at h = 1e-5.
#[test]
fn gradients_are_those_of_differences() {
    let h = 1e-5;
    for start in STARTS {
        let sloped = sloped_objective(start).unwrap();
        assert_eq!(sloped.value, objective(start).unwrap());
        for length in 0..2 {
            let moved = |by: f64| {
                let mut lengths = start;
                lengths[length] += by;
                lengths
            };
            let difference =
                (objective(moved(h)).unwrap() - objective(moved(-h)).unwrap()) / (2.0 * h);
            assert!((difference - sloped.slope[length]).abs() < 1e-8);
            for limit in Limit::BOTH {
                let excess = |by| limit.excess(moved(by)).unwrap();
                let difference = (excess(h) - excess(-h)) / (2.0 * h);
                let sloped = limit.sloped_excess(start).unwrap();
                assert!((difference - sloped.slope[length]).abs() < 1e-8);
            }
        }
    }
}

/// At the optimum the objective's gradient is a negative multiple of the constraint's, and along
/// the constraint the objective curves upwards.
#[test]
fn the_optimum_satisfies_the_conditions_of_kuhn_and_tucker() {
    let at = [COUPLER, ROCKER];
    let [cost, limit] = [sloped_objective(at).unwrap(), Limit::Largest.sloped_excess(at).unwrap()];
    let cross = cost.slope[0] * limit.slope[1] - cost.slope[1] * limit.slope[0];
    let dot = cost.slope[0] * limit.slope[0] + cost.slope[1] * limit.slope[1];
    // The lengths are rounded to 2e-16, and second derivatives stay below 100.
    assert!(cross.abs() < 1e-13 && dot < -1e-3, "{cross} {dot}");
    let curved = differentiate_twice(at, |[coupler, rocker]| {
        let generator = FunctionGenerator { coupler, rocker };
        let mut sum = linkage_core::num_dual::Dual2SVec::from(0.0);
        for turn in crate::generator::steps() {
            let error = generator.position(turn.into())?.error.angle();
            sum += error * error;
        }
        Ok(sum)
    })
    .unwrap();
    assert!((curved.value - OBJECTIVE).abs() < 1e-15);
    for length in 0..2 {
        assert!((curved.gradient[length] - cost.slope[length]).abs() < 1e-14);
    }
    let along = [-limit.slope[1], limit.slope[0]];
    let curvature: f64 = (0..2)
        .flat_map(|i| (0..2).map(move |j| (i, j)))
        .map(|(i, j)| curved.hessian[(i, j)] * along[i] * along[j])
        .sum();
    assert!(curvature > 0.0, "{curvature}");
}
