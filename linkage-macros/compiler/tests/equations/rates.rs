//! Velocity and acceleration against differences of the position along q(t).

use crate::equations::declarations::{UNKNOWNS, VARIANTS, Variant};
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::interface::quantity::{Order, Quantity};
use crate::ir::interpret::{Number, ProgramValues};
use crate::model::mechanism::Mechanism;
use crate::oracle::{Digits, defaults, derivatives, mechanism, values};
use crate::{equations, passes};

/// The rates of every output from its positions' derivatives in time: a direction's angular
/// velocity is cos·(sin)˙ − sin·(cos)˙, and the same with second derivatives is its angular
/// acceleration.
fn rates_of(mechanism: &Mechanism, position: &[Digits], derivative: &[Digits]) -> Vec<Digits> {
    let mut rates = Vec::new();
    let mut at = 0;
    for output in &mechanism.outputs {
        let quantity = Quantity::of(&output.kind);
        let end = at + quantity.layout(Order::Position).parts.len();
        if matches!(quantity, Quantity::Direction | Quantity::SlidingDirection) {
            let turning =
                position[at].mul(&derivative[at + 1]).sub(&position[at + 1].mul(&derivative[at]));
            rates.push(turning);
            at += 2;
        }
        rates.extend_from_slice(&derivative[at..end]);
        at = end;
    }
    rates
}

/// Every second variant; `.ci/nightly` takes the others.
#[test]
fn velocities_and_accelerations_are_derivatives_of_the_position() {
    are_derivatives_of_the_position(0);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn velocities_and_accelerations_are_derivatives_in_other_variants() {
    are_derivatives_of_the_position(1);
}

/// In every second variant from the first on.
fn are_derivatives_of_the_position(first: usize) {
    for variant in VARIANTS.iter().chain(UNKNOWNS).chain(PARALLELOGRAMS).skip(first).step_by(2) {
        motion_is_derived_from_the_position(variant);
    }
}

pub(super) fn motion_is_derived_from_the_position(variant: &Variant) {
    let mechanism = mechanism(variant.source);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let given = |t: &Digits| ProgramValues {
        inputs: variant
            .inputs
            .iter()
            .map(|q| {
                let [value, rate, accel] = q.map(Digits::float);
                let half = accel.mul(t).mul(&Digits::float(0.5));
                let moved = value.add(&rate.add(&half).mul(t));
                [moved, rate.add(&accel.mul(t)), accel]
            })
            .collect(),
        params: defaults(&mechanism),
        loads: Vec::new(),
        drives: Vec::new(),
        unit: None,
    };
    let now = given(&Digits::float(0.0));
    let position = values(&program, "position", &now);
    let (first, second) = derivatives(|t| values(&program, "position", &given(t)));
    let velocity = rates_of(&mechanism, &position, &first);
    let acceleration = rates_of(&mechanism, &position, &second);
    let expected = [&position[..], &velocity, &acceleration].concat();
    let motion = values(&program, "motion", &now);
    assert_eq!(motion.len(), expected.len(), "{}", variant.name);
    for (index, (formula, truth)) in motion.iter().zip(&expected).enumerate() {
        // The differences are good to h⁶ times a sixth derivative: 2⁻²⁴⁰ times at most some
        // 1e12 for these mechanisms, with room 1e-50.
        let apart = formula.apart(truth);
        assert!(
            apart < 1e-50,
            "{}: component {index} of its motion is {} and should be {}",
            variant.name,
            formula.to_f64(),
            truth.to_f64()
        );
    }
}

#[test]
fn coefficients_are_the_velocities_at_unit_rates() {
    for variant in VARIANTS.iter().chain(UNKNOWNS).chain(PARALLELOGRAMS) {
        let mechanism = mechanism(variant.source);
        let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
        let given = |rates: &[f64]| ProgramValues {
            inputs: variant
                .inputs
                .iter()
                .zip(rates)
                .map(|(q, &rate)| [q[0], rate, 0.0].map(Digits::float))
                .collect(),
            params: defaults(&mechanism),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        let count = variant.inputs.len();
        let coefficients = values(&program, "coefficients", &given(&vec![9.0; count]));
        for moving in 0..count {
            let mut rates = vec![0.0; count];
            rates[moving] = 1.0;
            let velocity = values(&program, "velocity", &given(&rates));
            let rows = coefficients.len() / count;
            for (row, truth) in velocity.iter().enumerate() {
                let apart = coefficients[moving * rows + row].apart(truth);
                assert!(apart < 1e-80, "{}: row {row} for input {moving}", variant.name);
            }
        }
    }
}
