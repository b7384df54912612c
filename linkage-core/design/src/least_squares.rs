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

#[cfg(test)]
mod tests {
    use nalgebra::{DVector, dmatrix, dvector};

    use super::step;
    use crate::kernel::Evaluation;
    use crate::rows::Rows;

    /// The slopes of x + y/2 − a and x/2 + y − b are M = (1, ½; ½, 1). A number that would leave its range goes to its
    /// end, and the other has the least squares beside it: its column of M, times what is left, over 5/4.
    #[test]
    fn a_step_to_an_end_takes_the_others_with_it() {
        let slopes = dmatrix![1.0, 0.5; 0.5, 1.0];
        let at = |x: &DVector<f64>, [a, b]: [f64; 2]| {
            let values = &slopes * x - dvector![a, b];
            let keeps = Rows { values: dvector![], slopes: nalgebra::DMatrix::zeros(0, 2) };
            Evaluation { aims: Rows { values, slopes: slopes.clone() }, keeps }
        };
        let x = dvector![0.5, 0.25];
        // Inside: M (0.75, 0.5) = (1, 0.875). Beyond the upper end, M (1.5, 0.5); beyond the lower, M (−1, 0.5).
        for (target, x0, y0) in [
            ([1.0, 0.875], 0.75, 0.5),
            ([1.75, 1.25], 1.0, (0.5 * (1.75 - 1.0) + (1.25 - 0.5)) / 1.25),
            ([-0.75, 0.0], 0.0, (0.5 * -0.75 + 0.0_f64) / 1.25),
        ] {
            let step = step(&at(&x, target), &x, 0.0).expect("there is a step");
            let y0 = y0.clamp(0.0, 1.0);
            let off = (&x + &step - dvector![x0, y0]).amax();
            assert!(off < 1e-14, "{target:?}: {step} for {x0}, {y0}");
        }
        // A number at its end that would leave it stands still; at the best place nothing moves.
        let x = dvector![1.0, 0.25];
        let found = step(&at(&x, [1.75, 1.25]), &x, 0.0).expect("there is a step");
        assert_eq!(found[0], 0.0);
        assert!((0.25 + found[1] - (0.5 * 0.75 + 0.75) / 1.25).abs() < 1e-14, "{found}");
        assert!(step(&at(&dvector![1.0, 0.0], [2.0, -1.0]), &dvector![1.0, 0.0], 0.0).is_none());
    }
}
