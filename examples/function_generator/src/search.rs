//! The lengths as a design, and the steps of a search for them.

use std::sync::Mutex;

use linkage_design::{DesignError, Evaluation, Found, Goal, Kernel, Slsqp, free};

use super::generator::{FunctionGenerator, Lengths, Limit, Transmission, steps};

/// Lengths between which every start and every step lies.
const BOUNDS: [[f64; 2]; 2] = [[2.0, 8.0], [1.0, 6.0]];

/// Where the searches start: within the limits and beyond them, with long and with short bars.
pub(crate) const STARTS: [Lengths; 6] =
    [[4.5, 2.5], [5.0, 3.0], [4.0, 3.5], [5.5, 2.0], [4.6, 4.0], [6.0, 4.5]];

/// One evaluation of objective and limits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) lengths: Lengths,
    /// The sum of squared errors; none where the machine cannot be assembled.
    pub(crate) objective: Option<f64>,
    pub(crate) with_slopes: bool,
}

/// The result of a search.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) found: Found<FunctionGenerator, 2>,
    /// Every evaluation, in order.
    pub(crate) steps: Vec<Step>,
}

impl Outcome {
    /// The lengths that were found.
    pub(crate) fn lengths(&self) -> Lengths {
        self.found.values
    }

    /// The number of evaluations after which one was within 10⁻⁶ of the end in both lengths.
    pub(crate) fn to_six_digits(&self) -> Option<usize> {
        let away = |step: &Step, i: usize| (step.lengths[i] - self.found.values[i]).abs();
        let hit = self.steps.iter().position(|step| away(step, 0).max(away(step, 1)) < 1e-6);
        hit.map(|place| place + 1)
    }
}

/// A kernel that notes what its search asks.
#[derive(Default)]
struct Noted {
    steps: Mutex<Vec<Step>>,
}

struct NotedGoal<'g> {
    goal: &'g dyn Goal,
    noted: &'g Noted,
}

impl Goal for NotedGoal<'_> {
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation> {
        let at = self.goal.evaluate(x, with_slopes);
        let lengths = core::array::from_fn(|i| BOUNDS[i][0] + x[i] * (BOUNDS[i][1] - BOUNDS[i][0]));
        let step = Step { lengths, objective: at.as_ref().map(Evaluation::cost), with_slopes };
        self.noted.steps.lock().expect("no thread panics with it").push(step);
        at
    }
}

impl Kernel for &Noted {
    fn search(&self, goal: &dyn Goal, start: &[f64]) -> Vec<f64> {
        Slsqp::default().search(&NotedGoal { goal, noted: self }, start)
    }
}

/// The search from one start.
pub(crate) fn search([coupler, rocker]: Lengths) -> Result<Outcome, DesignError> {
    let noted = Noted::default();
    let found = free!(FunctionGenerator: coupler, rocker; of FunctionGenerator { coupler, rocker })
        .within(BOUNDS.map(|[from, to]| from..=to))
        .aim("parabola", steps(), |machine, turn| {
            Ok([machine.position(turn.into())?.error.angle()])
        })
        .keep("transmission", Limit::BOTH, |machine, limit| {
            let bars = Transmission { coupler: machine.coupler, rocker: machine.rocker };
            Ok([-limit.excess(&bars)?])
        })
        .kernel(&noted)
        .run()?;
    Ok(Outcome { found, steps: noted.steps.into_inner().expect("no thread panics with it") })
}
