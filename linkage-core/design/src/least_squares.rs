//! Least squares by damped steps, where nothing but the ranges limits them.

use nalgebra::{DMatrix, DVector};

use crate::kernel::{Evaluation, Goal, Kernel, Slsqp};

/// Levenberg and Marquardt's method within the ranges: few steps where residuals stay small, as in a calibration.
/// A design that keeps something is searched by [`Slsqp`].
#[derive(Clone, Copy, Debug)]
pub struct LeastSquares {
    /// The most steps.
    pub steps: usize,
    /// The part of the sum of squares by which a step must promise to lower it.
    pub reduction: f64,
}

impl Default for LeastSquares {
    fn default() -> Self {
        // A sum of squares is rounded to about this.
        Self { steps: 200, reduction: 1e-15 }
    }
}

impl Kernel for LeastSquares {
    fn search(&self, goal: &dyn Goal, start: &[f64]) -> Vec<f64> {
        let Some(mut at) = goal.evaluate(start, true) else { return start.to_vec() };
        if !at.keeps.values.is_empty() {
            return Slsqp::default().search(goal, start);
        }
        let (mut x, mut damping, mut growth) = (DVector::from_column_slice(start), 1e-3, 2.0);
        for _ in 0..self.steps {
            let Some(step) = step(&at, &x, damping) else { break };
            let linear = &at.aims.values + &at.aims.slopes * &step;
            let (now, predicted) = (at.cost(), at.cost() - linear.norm_squared());
            if predicted <= self.reduction * now {
                break;
            }
            let next = (&x + step).map(|x| x.clamp(0.0, 1.0));
            let tried = goal.evaluate(next.as_slice(), true);
            match tried.filter(|tried| now - tried.cost() > 1e-4 * predicted) {
                Some(better) => {
                    // Nielsen, Damping parameter in Marquardt's method, 1999.
                    let gain = (now - better.cost()) / predicted;
                    damping *= f64::max(1.0 / 3.0, 1.0 - (2.0 * gain - 1.0).powi(3));
                    (x, at, growth) = (next, better, 2.0);
                }
                None if damping > 1e20 => break,
                None => (damping, growth) = (damping * growth, growth * 2.0),
            }
        }
        x.as_slice().to_vec()
    }
}

/// The damped step. Numbers at an end of their range that would leave it stand still, and so do, one after
/// the other, those that the step brings beyond it.
fn step(at: &Evaluation, x: &DVector<f64>, damping: f64) -> Option<DVector<f64>> {
    let n = x.len();
    let slope = at.aims.slopes.tr_mul(&at.aims.values);
    let squares = at.aims.slopes.tr_mul(&at.aims.slopes);
    let leaves = |i: usize| (x[i] <= 0.0 && slope[i] > 0.0) || (x[i] >= 1.0 && slope[i] < 0.0);
    let mut free: Vec<usize> = (0..n).filter(|&i| !leaves(i)).collect();
    let mut fixed = DVector::zeros(n);
    // Each round fixes one number more.
    while !free.is_empty() {
        let own = squares.select_rows(free.iter()).select_columns(free.iter());
        let largest = own.diagonal().amax().max(f64::MIN_POSITIVE);
        let damped = DMatrix::from_fn(free.len(), free.len(), |i, j| {
            own[(i, j)] + if i == j { damping * own[(i, i)].max(1e-12 * largest) } else { 0.0 }
        });
        let right = -(&slope + &squares * &fixed).select_rows(free.iter());
        let solved = damped.cholesky()?.solve(&right);
        let over = |(&i, step): (&usize, &f64)| (-(x[i] + step)).max(x[i] + step - 1.0);
        let beyond: Vec<f64> = free.iter().zip(solved.iter()).map(over).collect();
        let worst = (0..free.len()).max_by(|&a, &b| beyond[a].total_cmp(&beyond[b]))?;
        if beyond[worst] <= 0.0 {
            let mut step = fixed;
            free.iter().zip(solved.iter()).for_each(|(&i, by)| step[i] = *by);
            return Some(step);
        }
        let i = free.remove(worst);
        fixed[i] = if x[i] + solved[worst] < 0.0 { -x[i] } else { 1.0 - x[i] };
    }
    (fixed.amax() > 0.0).then_some(fixed)
}
