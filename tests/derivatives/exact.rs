//! Automatic differentiation and the formulas check each other, for every driver and every group,
//! fixed and moving, in both modes, at thousands of random dimensions and poses.
//!
//! - Velocity and acceleration from each group's own equations, against second-order dual numbers
//!   through the position along q(t).
//! - The Jacobian by dual numbers, against the coefficients from the velocity equations.
//! - The sensitivity to the dimensions by dual numbers, against the coefficients of the same
//!   mechanism with its dimensions as inputs: there the velocity equations carry the rates of
//!   lengths, offsets and guides.
//! - Mixed second and third derivatives of the position, against dual numbers through the formulas.
//! - Jacobian, sensitivity and coefficients against tables computed with 150 digits; the tables'
//!   conditions also hold those conditions that the random tests compute by differentiation.
//!
//! Neither side knows the other: the position holds no formula of a velocity, and the velocity
//! equations hold no derivative of a square root.
//!
//! The tolerance: a result is compared in units of ε times its condition, which is what rounding
//! every dimension, input and rate once may do to it. A position takes up to 60 operations, each
//! on three parts, with some 8 roundings in all: 500 roundings up to ε/2, about as harmful as
//! rounding a dimension. Of either sign they add up to √(500/12) ε ≈ 6.5 ε; two and a half times
//! that is allowed.

use linkage_core::{Real, SolveError};
use linkage_tests::conditioning::{
    Differentiated, Jacobians, Matrix, Sensitivities, State, Worst, any_state, columns, conditions,
    shared,
};
use linkage_tests::mechanisms::differentiated::*;
use linkage_tests::random::{Random, cases};
use linkage_tests::tables::slopes::{self, Case, Slope};
use num_dual::{Dual, Dual2, Dual3, DualNum, HyperDual};

const ALLOWED: f64 = 16.0;

/// Poses of each declaration in each width, a sample of those of `.ci/nightly`.
fn poses() -> usize {
    if cfg!(debug_assertions) { cases(150, 500) } else { 5000 }
}

/// `f32` or `f64`; the states hold numbers that both do.
trait Width: Real + DualNum {
    fn of(number: f64) -> Self {
        Self::lit(number, number as f32)
    }
}

impl Width for f32 {}
impl Width for f64 {}

/// Runs `check` at random states that can be assembled.
fn at_random_states<M: Differentiated, F: Width>(
    wanted: usize,
    mut check: impl FnMut(&State<f64>, &State<F>) -> Result<(), SolveError>,
) {
    let mut random = Random::new(M::NAME.len() as u64);
    let mut poses = 0;
    for _ in 0..2 * wanted {
        let state = any_state::<M>(&mut random, poses % M::MODES == 1);
        match check(&state, &state.map(F::of)) {
            Ok(()) => poses += 1,
            Err(SolveError::OutOfReach { .. }) => {}
            Err(error) => panic!("{}: {error} at {state:?}", M::NAME),
        }
        if poses == wanted {
            return;
        }
    }
    panic!("{}: {poses} poses only", M::NAME);
}

/// Position, velocity and acceleration from the formulas.
fn motion<M: Differentiated, T: Real>(at: &State<T>) -> Result<Vec<T>, SolveError> {
    Ok(M::motion(at)?.concat())
}

/// The same from the position along q(t).
fn differentiated_motion<M: Differentiated, F: Width>(at: &State<F>) -> Result<Vec<F>, SolveError> {
    let mut along = at.map(Dual2::from_re);
    for (input, (rate, second)) in along.inputs.iter_mut().zip(at.rates.iter().zip(&at.seconds)) {
        (input.v1, input.v2) = (*rate, *second);
    }
    let rows = M::position(&along)?;
    let order = |part: fn(&Dual2<F>) -> F| rows.iter().map(part).collect::<Vec<_>>();
    Ok([order(|row| row.re), order(|row| row.v1), order(|row| row.v2)].concat())
}

fn motions_agree<M: Differentiated, F: Width>() {
    let rows = M::OUTPUTS.len();
    let mut worst = [Worst::default(); 3];
    at_random_states::<M, F>(poses(), |state, at| {
        let (formulas, duals) = (motion::<M, F>(at)?, differentiated_motion::<M, F>(at)?);
        let conditions = shared::<M>(conditions(state, |at| motion::<M, _>(at))?);
        for (place, (formula, dual)) in formulas.iter().zip(duals).enumerate() {
            let (order, name) = (place / rows, M::OUTPUTS[place % rows]);
            // The components of a direction carry products of the rates that make up its own; in
            // its angle's acceleration they cancel.
            let turning = order == 2 && name.ends_with(".angle");
            let rate = if turning { conditions[place - rows] } else { 0.0 };
            let condition = conditions[place] + rate * rate;
            let error = formula.value() - dual.value();
            worst[order].note(error, <F as Real>::EPSILON, condition, ALLOWED, || {
                format!("{}, {name} of order {order}: {formula:?}, {dual:?} at {state:?}", M::NAME)
            });
        }
        Ok(())
    });
    println!("{} motion: {:.1?} ε", M::NAME, worst.map(|worst| worst.0));
}

/// Compares two matrices that are the same in real numbers, the conditions being the second's.
fn matrices_agree<M: Differentiated, F: Width>(
    what: &str,
    found: impl Fn(&State<F>) -> Result<Matrix<F>, SolveError>,
    expected: impl Fn(&State<F>) -> Result<Matrix<F>, SolveError>,
    conditions: impl Fn(&State<f64>) -> Result<Vec<f64>, SolveError>,
) {
    let mut worst = Worst::default();
    at_random_states::<M, F>(poses(), |state, at| {
        let (found, expected) = (columns(&found(at)?), columns(&expected(at)?));
        let conditions = shared::<M>(conditions(state)?);
        assert!(found.len() == expected.len() && found.len() == conditions.len());
        for (place, (found, expected)) in found.into_iter().zip(expected).enumerate() {
            let error = found.value() - expected.value();
            worst.note(error, <F as Real>::EPSILON, conditions[place], ALLOWED, || {
                let rows = M::OUTPUTS.len();
                let (row, column) = (M::OUTPUTS[place % rows], place / rows);
                let name = M::NAME;
                format!("{name}, {what} of {row} by {column}: {found:?}, {expected:?} at {state:?}")
            });
        }
        Ok(())
    });
    println!("{} {what}: {:.1?} ε", M::NAME, worst.0);
}

fn jacobian_is_the_coefficients<M: Differentiated + Jacobians<F>, F: Width>() {
    matrices_agree::<M, F>("jacobian", M::jacobian, M::coefficients::<F>, |state| {
        conditions(state, |at| Ok(columns(&M::coefficients(at)?)))
    });
}

/// The dimensions behind the inputs, as inputs.
fn all_moving<T: Copy>(at: &State<T>) -> State<T> {
    let inputs = [&at.inputs[..], &at.params].concat();
    State { inputs, params: Vec::new(), ..at.clone() }
}

fn sensitivity_is_the_coefficients<M, Moving, F: Width>()
where
    M: Differentiated + Sensitivities<F>,
    Moving: Differentiated,
{
    fn by_dimensions<M: Differentiated, Moving: Differentiated, T: Real>(
        at: &State<T>,
    ) -> Result<Matrix<T>, SolveError> {
        let slopes = Moving::coefficients(&all_moving(at))?;
        Ok(slopes.iter().map(|row| row[M::INPUTS..].to_vec()).collect())
    }
    assert_eq!(M::OUTPUTS, Moving::OUTPUTS);
    matrices_agree::<M, F>("sensitivity", M::sensitivity, by_dimensions::<M, Moving, F>, |state| {
        conditions(state, |at| Ok(columns(&by_dimensions::<M, Moving, _>(at)?)))
    });
}

/// The second derivative with the rates once and the accelerations once: the velocity's change
/// along the accelerations.
fn mixed<M: Differentiated, T: Real + DualNum>(at: &State<T>) -> Result<Vec<T>, SolveError> {
    let mut along = at.map(Dual::from_re);
    along.inputs.iter_mut().zip(&at.seconds).for_each(|(input, second)| input.eps = *second);
    Ok(M::motion(&along)?[1].iter().map(|row| row.eps).collect())
}

/// The rate of the acceleration, where the inputs have no third rate.
fn third<M: Differentiated, T: Real + DualNum>(at: &State<T>) -> Result<Vec<T>, SolveError> {
    let mut along = at.map(Dual::from_re);
    along.inputs.iter_mut().zip(&at.rates).for_each(|(input, rate)| input.eps = *rate);
    along.rates.iter_mut().zip(&at.seconds).for_each(|(rate, second)| rate.eps = *second);
    Ok(M::motion(&along)?[2].iter().map(|row| row.eps).collect())
}

/// The same two through the position.
fn higher_derivatives<M: Differentiated>(at: &State<f64>) -> Result<[Vec<f64>; 2], SolveError> {
    let (mut hyper, mut cubic) = (at.map(HyperDual::from_re), at.map(Dual3::from_re));
    for (i, (rate, second)) in at.rates.iter().zip(&at.seconds).enumerate() {
        (hyper.inputs[i].eps1, hyper.inputs[i].eps2) = (*rate, *second);
        (cubic.inputs[i].v1, cubic.inputs[i].v2) = (*rate, *second);
    }
    let mixed = M::position(&hyper)?.iter().map(|row| row.eps1eps2).collect();
    Ok([mixed, M::position(&cubic)?.iter().map(|row| row.v3).collect()])
}

/// Conditions of the two, with the products of rates that a direction's components carry.
fn higher_conditions<M: Differentiated>(at: &State<f64>) -> Result<[Vec<f64>; 2], SolveError> {
    let along_seconds = State { rates: at.seconds.clone(), ..at.clone() };
    let [by_rates, by_seconds] = [
        conditions(at, |at| motion::<M, _>(at))?,
        conditions(&along_seconds, |at| motion::<M, _>(at))?,
    ];
    let (mut mixed, mut third) =
        (shared::<M>(conditions(at, mixed::<M, _>)?), shared::<M>(conditions(at, third::<M, _>)?));
    let rows = M::OUTPUTS.len();
    for row in (0..rows).filter(|&row| M::OUTPUTS[row].ends_with(".angle")) {
        let (rate, second) = (by_rates[rows + row], by_rates[2 * rows + row]);
        mixed[row] += rate * by_seconds[rows + row];
        third[row] += rate * (rate * rate + 3.0 * second);
    }
    Ok([mixed, third])
}

/// A third derivative takes four parts with 20 roundings each, of which the square root of the
/// number allows half as much again.
fn higher_derivatives_agree<M: Differentiated>() {
    let mut worst = [Worst::default(); 2];
    at_random_states::<M, f64>(poses() / 4, |state, at| {
        let formulas = [mixed::<M, f64>(at)?, third::<M, f64>(at)?];
        let (duals, conditions) = (higher_derivatives::<M>(at)?, higher_conditions::<M>(at)?);
        for kind in 0..2 {
            for (row, name) in M::OUTPUTS.iter().enumerate() {
                let (formula, dual) = (formulas[kind][row], duals[kind][row]);
                let condition = conditions[kind][row];
                worst[kind].note(formula - dual, f64::EPSILON, condition, 1.5 * ALLOWED, || {
                    format!("{}, {name}, {kind}: {formula}, {dual} at {state:?}", M::NAME)
                });
            }
        }
        Ok(())
    });
    println!("{} mixed and third: {:.1?} ε", M::NAME, worst.map(|worst| worst.0));
}

/// All there is to check of a mechanism and its twin whose dimensions are inputs.
macro_rules! checked {
    ($($test:ident: $fixed:ident, $moving:ident;)+) => {$(
        mod $test {
            use super::*;

            #[test]
            fn motion_is_what_dual_numbers_say() {
                motions_agree::<$fixed, f64>();
                motions_agree::<$fixed, f32>();
            }

            #[test]
            fn motion_of_all_dimensions_is_what_dual_numbers_say() {
                motions_agree::<$moving, f64>();
                motions_agree::<$moving, f32>();
            }

            #[test]
            fn jacobians_are_the_coefficients() {
                jacobian_is_the_coefficients::<$fixed, f64>();
                jacobian_is_the_coefficients::<$fixed, f32>();
                jacobian_is_the_coefficients::<$moving, f64>();
                jacobian_is_the_coefficients::<$moving, f32>();
            }

            #[test]
            fn sensitivities_are_the_coefficients_of_moving_dimensions() {
                sensitivity_is_the_coefficients::<$fixed, $moving, f64>();
                sensitivity_is_the_coefficients::<$fixed, $moving, f32>();
            }

            #[test]
            fn higher_derivatives_are_those_of_the_formulas() {
                higher_derivatives_agree::<$fixed>();
                higher_derivatives_agree::<$moving>();
            }
        }
    )+};
}

checked! {
    rrr: Bars, MovingBars;
    rrp: Press, MovingPress;
    rpr: QuickReturn, MovingQuickReturn;
    prp: CrossedGuides, MovingCrossedGuides;
    rpp: Yoke, MovingYoke;
    drivers: Manipulator, MovingManipulator;
}

/// Few numbers are compared with the tables, and the worst of few is not multiplied.
const ALLOWED_BY_TABLES: f64 = 6.5;

fn tabulated<M: Differentiated>(case: &Case) -> State<f64> {
    assert_eq!(case.numbers.len(), M::RANGES.len());
    let (inputs, params) = case.numbers.split_at(M::INPUTS);
    State {
        is_flipped: case.is_flipped,
        params: params.to_vec(),
        inputs: inputs.to_vec(),
        rates: Vec::new(),
        seconds: Vec::new(),
    }
}

/// Slopes, column by column, against the first columns of the table.
fn compare<M: Differentiated, T: Real>(worst: &mut Worst, case: &Case, from: usize, slopes: &[T]) {
    let truths: Vec<Slope> = case.columns[from..].concat();
    let conditions = shared::<M>(truths.iter().map(|truth| truth.2).collect());
    for (place, slope) in slopes.iter().enumerate() {
        let (high, low, _) = truths[place];
        let error = (slope.value() - high) - low;
        worst.note(error, T::EPSILON, conditions[place], ALLOWED_BY_TABLES, || {
            let rows = M::OUTPUTS.len();
            let (row, column) = (M::OUTPUTS[place % rows], from + place / rows);
            format!("{}: {row} by number {column}: {slope:?} for {high}", M::NAME)
        });
    }
}

fn slopes_are_tabulated<M>(cases: &[Case])
where
    M: Differentiated + Jacobians<f64> + Jacobians<f32> + Sensitivities<f64> + Sensitivities<f32>,
{
    let mut worst = [Worst::default(); 2];
    for case in cases {
        let at = tabulated::<M>(case);
        let narrow = at.map(|number| number as f32);
        let [wide_units, narrow_units] = &mut worst;
        let matrices = [M::jacobian(&at), M::coefficients(&at), M::sensitivity(&at)];
        for (from, matrix) in [0, 0, M::INPUTS].into_iter().zip(matrices) {
            compare::<M, _>(wide_units, case, from, &columns(&matrix.unwrap()));
        }
        let matrices = [M::jacobian(&narrow), M::coefficients(&narrow), M::sensitivity(&narrow)];
        for (from, matrix) in [0, 0, M::INPUTS].into_iter().zip(matrices) {
            compare::<M, _>(narrow_units, case, from, &columns(&matrix.unwrap()));
        }
    }
    println!("{}: {:.2?} ε", M::NAME, worst.map(|worst| worst.0));
}

#[test]
fn jacobians_and_sensitivities_are_those_of_fifty_digits() {
    slopes_are_tabulated::<Bars>(&slopes::BARS);
    slopes_are_tabulated::<Press>(&slopes::PRESS);
    slopes_are_tabulated::<QuickReturn>(&slopes::QUICK_RETURN);
    slopes_are_tabulated::<CrossedGuides>(&slopes::CROSSED_GUIDES);
    slopes_are_tabulated::<Yoke>(&slopes::YOKE);
    slopes_are_tabulated::<Manipulator>(&slopes::MANIPULATOR);
}

/// The tables round their conditions up to two digits.
fn conditions_are_tabulated<M: Differentiated>(cases: &[Case]) {
    for case in cases {
        let by_duals =
            conditions(&tabulated::<M>(case), |at| Ok(columns(&M::coefficients(at)?))).unwrap();
        let truths = case.columns[..M::INPUTS].concat();
        assert_eq!(by_duals.len(), truths.len());
        for (found, (.., rounded_up)) in by_duals.into_iter().zip(truths) {
            let is_close = 0.9 * rounded_up < found && found <= rounded_up * (1.0 + 1e-9);
            assert!(is_close || found == rounded_up, "{}: {found} for {rounded_up}", M::NAME);
        }
    }
}

#[test]
fn conditions_by_dual_numbers_are_those_of_the_tables() {
    conditions_are_tabulated::<Bars>(&slopes::BARS);
    conditions_are_tabulated::<Press>(&slopes::PRESS);
    conditions_are_tabulated::<QuickReturn>(&slopes::QUICK_RETURN);
    conditions_are_tabulated::<CrossedGuides>(&slopes::CROSSED_GUIDES);
    conditions_are_tabulated::<Yoke>(&slopes::YOKE);
    conditions_are_tabulated::<Manipulator>(&slopes::MANIPULATOR);
}
