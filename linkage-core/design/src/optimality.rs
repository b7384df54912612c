//! Conditions of Kuhn and Tucker: prices of what is at its limit, and what remains of the slope.

use nalgebra::{DMatrix, DVector};

use crate::kernel::Evaluation;

/// A reserve at its limit, or an end of a range: something that pushes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    Reserve(usize),
    Least(usize),
    Most(usize),
}

/// The prices at a place, and the slope that they do not balance.
#[derive(Clone, Debug)]
pub(crate) struct Optimality {
    /// For each active limit the fall of the cost by its slackening by one, in numbers from 0 to 1.
    pub(crate) prices: Vec<(Limit, f64)>,
    /// The largest part of the slope that no price balances, against the slopes of single residuals.
    pub(crate) residual: f64,
}

/// A reserve below this, against how far it changes over the ranges, is at its limit.
pub(crate) const ACTIVE: f64 = 1e-7;

impl Optimality {
    /// The prices are the non-negative least squares of the slope on the slopes of the active limits.
    pub(crate) fn of(x: &[f64], at: &Evaluation) -> Self {
        let slope = at.aims.slopes.tr_mul(&at.aims.values) * 2.0;
        let limits = active(x, at);
        let columns = DMatrix::from_fn(x.len(), limits.len(), |i, column| match limits[column] {
            Limit::Reserve(row) => at.keeps.slopes[(row, i)],
            Limit::Least(j) => f64::from(u8::from(i == j)),
            Limit::Most(j) => -f64::from(u8::from(i == j)),
        });
        let prices = non_negative(&columns, &slope);
        let left = (slope - &columns * &prices).amax();
        let largest = at.aims.slopes.column_iter().map(|c| c.norm()).fold(0.0, f64::max);
        // Residuals below 10⁻⁸ of how far they change over the ranges count as zero, and zero has no angle.
        let size = 2.0 * largest * f64::max(at.aims.values.norm(), 1e-8 * largest);
        let residual = if left > 0.0 { left / size } else { 0.0 };
        Self { prices: limits.into_iter().zip(prices.iter().copied()).collect(), residual }
    }
}

/// The limits that are reached.
pub(crate) fn active(x: &[f64], at: &Evaluation) -> Vec<Limit> {
    let reserves = (0..at.keeps.values.len())
        .filter(|&row| at.keeps.values[row] <= ACTIVE * at.keeps.slopes.row(row).norm())
        .map(Limit::Reserve);
    let least = (0..x.len()).filter(|&i| x[i] <= ACTIVE).map(Limit::Least);
    let most = (0..x.len()).filter(|&i| x[i] >= 1.0 - ACTIVE).map(Limit::Most);
    reserves.chain(least).chain(most).collect()
}

/// The numbers, none negative, whose combination of the columns is nearest to a vector (Lawson and Hanson,
/// Solving Least Squares Problems, 1974, chapter 23).
fn non_negative(columns: &DMatrix<f64>, to: &DVector<f64>) -> DVector<f64> {
    let n = columns.ncols();
    let mut prices = DVector::zeros(n);
    let mut chosen: Vec<usize> = Vec::new();
    // Each round adds a column; 3 n rounds are Lawson and Hanson's own bound.
    for _ in 0..3 * n {
        let gain = columns.tr_mul(&(to - columns * &prices));
        let weight = |&column: &usize| gain[column] / columns.column(column).norm().max(1e-300);
        let rest = (0..n).filter(|column| !chosen.contains(column));
        let best = rest.max_by(|a, b| weight(a).total_cmp(&weight(b)));
        let Some(best) = best.filter(|best| weight(best) > 1e-13 * to.norm()) else { break };
        chosen.push(best);
        while !step(columns, to, &mut chosen, &mut prices) {}
    }
    prices
}

/// Moves to the least squares of the chosen columns, or to the first of them that becomes zero, which is
/// dropped; true where the least squares are reached.
fn step(
    columns: &DMatrix<f64>,
    to: &DVector<f64>,
    chosen: &mut Vec<usize>,
    prices: &mut DVector<f64>,
) -> bool {
    let picked = columns.select_columns(chosen.iter());
    let Ok(wanted) = picked.svd(true, true).solve(to, 1e-12) else { return true };
    let share = |(&column, &wanted): (&usize, &f64)| {
        let now = prices[column];
        if wanted > 0.0 { 1.0 } else { now / (now - wanted).max(1e-300) }
    };
    let way = chosen.iter().zip(wanted.iter()).map(share).fold(1.0, f64::min);
    for (&column, &wanted) in chosen.iter().zip(wanted.iter()) {
        prices[column] += way * (wanted - prices[column]);
    }
    if way >= 1.0 {
        return true;
    }
    let top = prices.amax();
    let before = chosen.len();
    chosen.retain(|&column| prices[column] > 1e-14 * top);
    for column in 0..prices.len() {
        if !chosen.contains(&column) {
            prices[column] = 0.0;
        }
    }
    chosen.len() == before || chosen.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prices_are_least_squares_where_these_are_positive_and_zero_elsewhere() {
        let columns = DMatrix::from_column_slice(3, 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 0.0]);
        let both = non_negative(&columns, &DVector::from_vec(vec![3.0, 1.0, 7.0]));
        assert!((both - DVector::from_vec(vec![2.0, 1.0])).norm() < 1e-14);
        // The least squares would be (1.5, −1); without the second column the first is 0.5.
        let one = non_negative(&columns, &DVector::from_vec(vec![0.5, -1.0, 0.0]));
        assert!((one - DVector::from_vec(vec![0.5, 0.0])).norm() < 1e-14);
        let none = non_negative(&columns, &DVector::from_vec(vec![-1.0, -1.0, 0.0]));
        assert_eq!(none.norm(), 0.0);
    }
}
