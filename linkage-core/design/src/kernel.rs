//! The optimiser behind a search: a library behind one small trait.

use std::cell::RefCell;

use crate::rows::Rows;

/// Residuals, whose sum of squares shall become least, and reserves, none of which shall be negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Residuals.
    pub aims: Rows,
    /// Reserves.
    pub keeps: Rows,
}

impl Evaluation {
    /// The sum of squares.
    #[must_use]
    pub fn cost(&self) -> f64 {
        self.aims.values.norm_squared()
    }

    /// The part of the ranges by which the worst reserve is short of zero, by its slope.
    #[must_use]
    pub fn violation(&self) -> f64 {
        let short = |row: usize| {
            let reserve = self.keeps.values[row];
            if reserve < 0.0 { -reserve / self.keeps.slopes.row(row).norm() } else { 0.0 }
        };
        (0..self.keeps.values.len()).map(short).fold(0.0, f64::max)
    }

    /// The sum of the squares of all that reserves are short of zero.
    #[must_use]
    pub fn shortage(&self) -> f64 {
        self.keeps.values.iter().map(|reserve| reserve.min(0.0).powi(2)).sum()
    }
}

/// A problem in numbers from 0 to 1.
pub trait Goal {
    /// The evaluation there, with slopes or with slopes of zero; none where the machine is refused.
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation>;
}

/// A search from one start for the least sum of squares, every number from 0 to 1, no reserve negative.
pub trait Kernel: Sync {
    /// The place where the search ends. The start is not refused.
    fn search(&self, goal: &dyn Goal, start: &[f64]) -> Vec<f64>;
}

/// Sequential quadratic programming (Kraft, DFVLR-FB 88-28, 1988), by the crate `slsqp`. A refusal is an
/// infinite value, from which the search steps back.
#[derive(Clone, Copy, Debug)]
pub struct Slsqp {
    /// The most evaluations of one run.
    pub evaluations: usize,
}

impl Default for Slsqp {
    fn default() -> Self {
        Self { evaluations: 1000 }
    }
}

/// The last evaluation: each reserve asks for itself.
struct Remembered<'a> {
    goal: &'a dyn Goal,
    last: RefCell<(Vec<f64>, bool, Option<Evaluation>)>,
}

impl Remembered<'_> {
    fn ask<R>(&self, x: &[f64], with_slopes: bool, of: impl FnOnce(Option<&Evaluation>) -> R) -> R {
        let mut last = self.last.borrow_mut();
        if last.0 != x || (with_slopes && !last.1) {
            *last = (x.to_vec(), with_slopes, self.goal.evaluate(x, with_slopes));
        }
        of(last.2.as_ref())
    }

    fn cost(&self, x: &[f64], gradient: Option<&mut [f64]>, unit: f64) -> f64 {
        self.ask(x, gradient.is_some(), |evaluation| {
            let Some(Evaluation { aims, .. }) = evaluation else { return f64::INFINITY };
            if let Some(gradient) = gradient {
                let slopes = aims.slopes.tr_mul(&aims.values) * (2.0 / unit);
                gradient.copy_from_slice(slopes.as_slice());
            }
            aims.values.norm_squared() / unit
        })
    }

    fn excess(&self, x: &[f64], gradient: Option<&mut [f64]>, row: usize) -> f64 {
        self.ask(x, gradient.is_some(), |evaluation| {
            let Some(Evaluation { keeps, .. }) = evaluation else { return f64::INFINITY };
            if let Some(gradient) = gradient {
                for (column, to) in gradient.iter_mut().enumerate() {
                    *to = -keeps.slopes[(row, column)];
                }
            }
            -keeps.values[row]
        })
    }
}

impl Slsqp {
    fn run(&self, goal: &dyn Goal, start: &[f64]) -> Vec<f64> {
        let remembered = Remembered { goal, last: RefCell::new((Vec::new(), false, None)) };
        let begun =
            remembered.ask(start, true, |at| at.map(|at| (at.cost(), at.keeps.values.len())));
        let Some((cost, reserves)) = begun else { return start.to_vec() };
        // The first step is made with the unit matrix in place of second derivatives.
        let unit = cost.max(f64::MIN_POSITIVE);
        let value = |x: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
            remembered.cost(x, gradient, unit)
        };
        let remembered = &remembered;
        let limits: Vec<_> = (0..reserves)
            .map(|row| {
                move |x: &[f64], gradient: Option<&mut [f64]>, (): &mut ()| {
                    remembered.excess(x, gradient, row)
                }
            })
            .collect();
        let until =
            slsqp::StopTols { xtol_rel: 1e-14, ftol_rel: 1e-15, ..slsqp::StopTols::default() };
        let bounds = vec![(0.0, 1.0); start.len()];
        let ended =
            slsqp::minimize(value, start, &bounds, &limits, (), self.evaluations, Some(until));
        // At the optimum rounding may end the search before the tolerance does: the place is judged.
        let (Ok((_, x, _)) | Err((_, x, _))) = ended;
        x.into_iter().map(|x| x.clamp(0.0, 1.0)).collect()
    }
}

impl Kernel for Slsqp {
    fn search(&self, goal: &dyn Goal, start: &[f64]) -> Vec<f64> {
        self.run(goal, start)
    }
}
