//! Random states of a mechanism, and how much its results depend on all the numbers in them.
//!
//! Nothing about one mechanism belongs here.

use linkage_core::{Real, SolveError};
use num_dual::Dual64;

use crate::random::Random;

/// A dimension or an input, drawn between these.
pub type Range = (f64, f64);

/// Rows by columns.
pub type Matrix<T> = Vec<Vec<T>>;

/// All numbers that a mechanism's motion depends on, and whether its groups stand in the other
/// mode than the declared one.
#[derive(Clone, Debug)]
pub struct State<T> {
    pub is_flipped: bool,
    pub params: Vec<T>,
    pub inputs: Vec<T>,
    pub rates: Vec<T>,
    pub seconds: Vec<T>,
}

/// A mechanism as the tests see it, on any number.
pub trait Differentiated {
    const NAME: &'static str;
    const OUTPUTS: &'static [&'static str];
    /// The ranges of the inputs, then of the parameters.
    const RANGES: &'static [Range];
    const INPUTS: usize;
    /// One, or two where the group has two assembly modes.
    const MODES: usize;

    fn position<T: Real>(at: &State<T>) -> Result<Vec<T>, SolveError>;
    fn motion<T: Real>(at: &State<T>) -> Result<[Vec<T>; 3], SolveError>;
    fn coefficients<T: Real>(at: &State<T>) -> Result<Matrix<T>, SolveError>;
}

/// The Jacobian, which a mechanism has for `f32` and `f64` only.
pub trait Jacobians<F> {
    fn jacobian(at: &State<F>) -> Result<Matrix<F>, SolveError>;
}

/// The sensitivity, which only a mechanism with parameters has.
pub trait Sensitivities<F> {
    fn sensitivity(at: &State<F>) -> Result<Matrix<F>, SolveError>;
}

impl<T: Copy> State<T> {
    pub fn map<U>(&self, mut f: impl FnMut(T) -> U) -> State<U> {
        let mut all = |numbers: &[T]| numbers.iter().map(|&number| f(number)).collect();
        State {
            is_flipped: self.is_flipped,
            params: all(&self.params),
            inputs: all(&self.inputs),
            rates: all(&self.rates),
            seconds: all(&self.seconds),
        }
    }

    /// The count of numbers that it holds.
    fn len(&self) -> usize {
        self.params.len() + self.inputs.len() + self.rates.len() + self.seconds.len()
    }
}

/// A state with rates up to 2 and accelerations up to 4; every number is one that `f32` holds.
pub fn any_state<M: Differentiated>(random: &mut Random, is_flipped: bool) -> State<f64> {
    let (inputs, params) = M::RANGES.split_at(M::INPUTS);
    let mut draw = |ranges: &[Range]| -> Vec<f64> {
        ranges.iter().map(|&(low, high)| random.between(low, high)).collect()
    };
    State {
        is_flipped,
        params: draw(params),
        inputs: draw(inputs),
        rates: draw(&[(-2.0, 2.0)].repeat(M::INPUTS)),
        seconds: draw(&[(-4.0, 4.0)].repeat(M::INPUTS)),
    }
}

/// A matrix column by column: each column holds every row once.
pub fn columns<T: Copy>(matrix: &Matrix<T>) -> Vec<T> {
    let width = matrix.first().map_or(0, Vec::len);
    (0..width).flat_map(|column| matrix.iter().map(move |row| row[column])).collect()
}

/// The factors of ε that measure the errors of results that depend on the state.
///
/// Each result's condition is the sum, over all numbers of the state, of its change per unit
/// relative change of the number, and its own size: ε times that is what rounding every number
/// once may do to it.
pub fn conditions(
    at: &State<f64>,
    results: impl Fn(&State<Dual64>) -> Result<Vec<Dual64>, SolveError>,
) -> Result<Vec<f64>, SolveError> {
    let constant = at.map(|number| Dual64::new(number, 0.0));
    let mut sums: Vec<f64> = results(&constant)?.iter().map(|result| result.re.abs()).collect();
    for varied in 0..at.len() {
        let mut place = 0;
        let seeded = at.map(|number| {
            place += 1;
            // The derivative by the relative change of a number is the number times its own.
            Dual64::new(number, if place == varied + 1 { number } else { 0.0 })
        });
        for (sum, result) in sums.iter_mut().zip(results(&seeded)?) {
            *sum += result.eps.abs();
        }
    }
    Ok(sums)
}

/// Conditions of blocks of a mechanism's rows, where the coordinates and slides of one block share
/// the largest: a point's error does not know the ground's axes, and a coordinate that hardly
/// moves may be the difference of a slide and of the guide's own way.
pub fn shared<M: Differentiated>(mut conditions: Vec<f64>) -> Vec<f64> {
    let is_angle = |row: usize| M::OUTPUTS[row].ends_with(".angle");
    for block in conditions.chunks_mut(M::OUTPUTS.len()) {
        let lengths = block.iter_mut().enumerate().filter(|(row, _)| !is_angle(*row));
        let lengths: Vec<_> = lengths.map(|(_, condition)| condition).collect();
        let largest = lengths.iter().fold(0.0, |largest: f64, condition| largest.max(**condition));
        lengths.into_iter().for_each(|condition| *condition = largest);
    }
    conditions
}

/// Errors in units of ε times the conditions; an error where nothing can be wrong is infinite.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst(pub f64);

impl Worst {
    /// Notes an error of numbers of the width `epsilon`, and refuses what exceeds `allowed`.
    #[track_caller]
    pub fn note(
        &mut self,
        error: f64,
        epsilon: f64,
        condition: f64,
        allowed: f64,
        what: impl FnOnce() -> String,
    ) {
        let units = if error == 0.0 { 0.0 } else { error.abs() / (epsilon * condition) };
        // Not a number is not within the allowance either.
        let is_allowed = units <= allowed;
        assert!(is_allowed, "{}: {units} ε of {condition:e}", what());
        self.0 = self.0.max(units);
    }
}
