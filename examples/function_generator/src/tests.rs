//! The function-generating crank-rocker of the example ends at its optimum from every start.

use crate::generator::{FunctionGenerator, Lengths, Limit, Transmission, error, steps, wanted};
use crate::search::{STARTS, Step, search};
use linkage_core::num_dual::Dual2SVec;
use linkage_core::{SolveError, differentiate, differentiate_twice};

/// The optimum to 50 digits, rounded; the printed source has 4.1285, 2.3226 and 0.0076.
const COUPLER: f64 = 4.128_654_158_009_783;
const ROCKER: f64 = 2.322_461_712_412_169_4;
const OBJECTIVE: f64 = 0.007_592_373_605_334_677;

#[test]
fn exact_slopes_lead_to_the_optimum_from_every_start() {
    for start in STARTS {
        let outcome = search(start).unwrap();
        let [coupler, rocker] = outcome.lengths();
        assert!((coupler / COUPLER - 1.0).abs() < 1e-9, "coupler {coupler}");
        assert!((rocker / ROCKER - 1.0).abs() < 1e-9, "rocker {rocker}");
        assert!((outcome.found.cost / OBJECTIVE - 1.0).abs() < 1e-9, "{}", outcome.found.cost);
        let bars = Transmission { coupler, rocker };
        let [least, largest] = Limit::BOTH.map(|limit| limit.angle(&bars).unwrap().to_degrees());
        assert!((largest / 135.0 - 1.0).abs() < 1e-9, "{largest}°");
        assert!((least - 70.379).abs() < 1e-3, "{least}°");
        // Without slopes a search takes 85 to 174.
        assert!(outcome.to_six_digits().unwrap() <= 100, "{start:?} {:?}", outcome.to_six_digits());
        let [price] = outcome.found.prices.as_slice() else { panic!("{}", outcome.found) };
        assert!(price.at.contains("Largest") && price.price > 0.0);
    }
}

#[test]
fn every_evaluation_is_noted() {
    let outcome = search(STARTS[0]).unwrap();
    assert!(outcome.steps.iter().any(|step| step.with_slopes));
    for Step { lengths, objective, .. } in outcome.steps {
        let squares: Result<f64, SolveError> =
            steps().map(|turn| Ok(error(lengths, turn)?.powi(2))).sum();
        // The step's lengths are rounded once more than those that were evaluated.
        match (squares, objective) {
            (Ok(squares), Some(noted)) => assert!((squares / noted - 1.0).abs() < 1e-9),
            // Lengths that cannot be assembled are a step back.
            (squares, noted) => assert!(squares.is_err() && noted.is_none(), "{lengths:?}"),
        }
    }
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
        for turn in steps() {
            let (found, expected) = (error(lengths, turn).unwrap(), error_by_hand(lengths, turn));
            // Arc cosines of numbers up to 0.99 lose a digit.
            assert!((found - expected).abs() < 1e-14, "{lengths:?} {turn}: {found} {expected}");
        }
    }
}

/// At the optimum the objective's gradient is a negative multiple of the constraint's, and along
/// the constraint the objective curves upwards.
#[test]
fn the_optimum_satisfies_the_conditions_of_kuhn_and_tucker() {
    let at = [COUPLER, ROCKER];
    let limit = differentiate(at, |[coupler, rocker]| {
        Ok([Limit::Largest.excess(&Transmission { coupler, rocker })?])
    })
    .unwrap();
    let curved = differentiate_twice(at, |[coupler, rocker]| {
        let generator = FunctionGenerator { coupler, rocker };
        let mut sum = Dual2SVec::from(0.0);
        for turn in steps() {
            let error = generator.position(turn.into())?.error.angle();
            sum += error * error;
        }
        Ok(sum)
    })
    .unwrap();
    assert!((curved.value - OBJECTIVE).abs() < 1e-15);
    let [cost, limit] = [curved.gradient, limit.transpose()];
    let cross = cost[0] * limit[1] - cost[1] * limit[0];
    // The lengths are rounded to 2e-16, and second derivatives stay below 100.
    assert!(cross.abs() < 1e-13 && cost.dot(&limit) < -1e-3, "{cross}");
    let along = [-limit[1], limit[0]];
    let curvature: f64 = (0..2)
        .flat_map(|i| (0..2).map(move |j| (i, j)))
        .map(|(i, j)| curved.hessian[(i, j)] * along[i] * along[j])
        .sum();
    assert!(curvature > 0.0, "{curvature}");
}
