//! Two ways to the optimum: sequential quadratic programming with exact gradients, and linear
//! approximation without any.

use std::cell::RefCell;

use linkage_core::SolveError;

use super::generator::{Lengths, Limit, Sloped, objective, sloped_objective};

/// Lengths between which every start and every step lies.
const BOUNDS: [(f64, f64); 2] = [(2.0, 8.0), (1.0, 6.0)];

/// Where the searches start: within the limits and beyond them, with long and with short bars.
pub(crate) const STARTS: [Lengths; 6] =
    [[4.5, 2.5], [5.0, 3.0], [4.0, 3.5], [5.5, 2.0], [4.6, 4.0], [6.0, 4.5]];

/// One evaluation of the objective.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) lengths: Lengths,
    pub(crate) objective: f64,
    pub(crate) with_gradient: bool,
}

/// The result of a search.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    /// The status that the search reports.
    pub(crate) status: String,
    pub(crate) lengths: Lengths,
    pub(crate) objective: f64,
    /// Every evaluation of the objective, in order.
    pub(crate) steps: Vec<Step>,
}

impl Outcome {
    /// The number of evaluations after which one was within 10⁻⁶ of the end in both lengths.
    pub(crate) fn to_six_digits(&self) -> Option<usize> {
        let away = |step: &Step, i: usize| (step.lengths[i] - self.lengths[i]).abs();
        let hit = self.steps.iter().position(|step| away(step, 0).max(away(step, 1)) < 1e-6);
        hit.map(|place| place + 1)
    }
}

/// A function that is called with every evaluation.
pub(crate) type Progress<'a> = &'a dyn Fn(usize, Step);

/// Notes the evaluations of the objective.
struct Record<'a> {
    steps: RefCell<Vec<Step>>,
    progress: Progress<'a>,
}

impl<'a> Record<'a> {
    fn new(progress: Progress<'a>) -> Self {
        Self { steps: RefCell::new(Vec::new()), progress }
    }

    fn note(&self, step: Step) -> f64 {
        let mut steps = self.steps.borrow_mut();
        steps.push(step);
        (self.progress)(steps.len(), step);
        step.objective
    }

    fn outcome(self, status: String, lengths: &[f64], objective: f64) -> Outcome {
        let steps = self.steps.into_inner();
        Outcome { status, lengths: both(lengths), objective, steps }
    }
}

fn both(lengths: &[f64]) -> Lengths {
    [lengths[0], lengths[1]]
}

/// The answer to a gradient search. Where the mechanism cannot be assembled, the value is infinite. Along
/// a line the search asks for values only.
fn told(
    value: impl FnOnce() -> Result<f64, SolveError>,
    sloped: impl FnOnce() -> Result<Sloped, SolveError>,
    gradient: Option<&mut [f64]>,
) -> f64 {
    let Some(gradient) = gradient else { return value().unwrap_or(f64::INFINITY) };
    let Ok(Sloped { value, slope }) = sloped() else { return f64::INFINITY };
    gradient.copy_from_slice(&slope);
    value
}

/// Sequential quadratic programming; the gradients of objective and constraints are exact.
pub(crate) fn by_gradients(start: Lengths, progress: Progress<'_>) -> Outcome {
    let record = Record::new(progress);
    let cost = |lengths: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
        let (lengths, with_gradient) = (both(lengths), gradient.is_some());
        let value = told(|| objective(lengths), || sloped_objective(lengths), gradient);
        record.note(Step { lengths, objective: value, with_gradient })
    };
    let limits = Limit::BOTH.map(|limit| {
        move |lengths: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
            let lengths = both(lengths);
            told(|| limit.excess(lengths), || limit.sloped_excess(lengths), gradient)
        }
    });
    let limits: [&dyn slsqp::Func<()>; 2] = [&limits[0], &limits[1]];
    let until = slsqp::StopTols { xtol_rel: 1e-12, ftol_rel: 1e-15, ..slsqp::StopTols::default() };
    let ended = slsqp::minimize(cost, &start, &BOUNDS, &limits, (), 200, Some(until));
    let (status, lengths, objective) = match ended {
        Ok((status, lengths, objective)) => (format!("{status:?}"), lengths, objective),
        // At the optimum rounding may end the search before the tolerance does: judge the point.
        Err((status, lengths, objective)) => (format!("{status:?}"), lengths, objective),
    };
    record.outcome(status, &lengths, objective)
}

/// Linear approximations on a shrinking simplex; no gradient is computed.
pub(crate) fn without_gradients(start: Lengths, progress: Progress<'_>) -> Outcome {
    /// Worse than any pose that exists, and finite, since the approximation is made of it.
    const UNASSEMBLED: f64 = 10.0;
    let record = Record::new(progress);
    let cost = |lengths: &[f64], (): &mut ()| {
        let lengths = both(lengths);
        let objective = objective(lengths).unwrap_or(UNASSEMBLED);
        record.note(Step { lengths, objective, with_gradient: false })
    };
    let limits = Limit::BOTH.map(|limit| {
        // Positive where the limit is kept.
        move |lengths: &[f64], (): &mut ()| -limit.excess(both(lengths)).unwrap_or(UNASSEMBLED)
    });
    let limits: [&dyn cobyla::Func<()>; 2] = [&limits[0], &limits[1]];
    let until = cobyla::StopTols { xtol_rel: 1e-9, ..cobyla::StopTols::default() };
    let simplex = cobyla::RhoBeg::All(0.25);
    let ended = cobyla::minimize(cost, &start, &BOUNDS, &limits, (), 2000, simplex, Some(until));
    let (status, lengths, objective) = match ended {
        Ok((status, lengths, objective)) => (format!("{status:?}"), lengths, objective),
        Err((status, lengths, objective)) => (format!("{status:?}"), lengths, objective),
    };
    record.outcome(status, &lengths, objective)
}
