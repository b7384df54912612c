//! The search where straight-line steps have not ended: on plain numbers, with a stated bound of steps.

use super::{System, eliminate, magnitude, solve, without};

/// Steps of Newton's method before steps are guarded. Of 56,000 random problems of up to eight amounts five
/// took more: all of them cycles.
pub(super) const NEWTON: usize = 8;

/// Steps of the guarded search. One gains the factor 1 − 1/max w at least.
pub(super) const GUARDED: usize = 64;

impl<const W: usize, const M: usize> System<f64, W, M> {
    /// The only solution; or the contact at which friction may hold itself.
    #[inline(always)]
    pub(super) fn solved(&self) -> Result<[f64; M], usize> {
        self.solved_in().map(|(amounts, _)| amounts)
    }

    /// The same, and the number of steps.
    #[inline(always)]
    pub(super) fn solved_in(&self) -> Result<([f64; M], usize), usize> {
        let bounds = self.bounds();
        jammed(bounds).map_or(Ok(()), Err)?;
        let (start, _) = self.linear([0.0; M], &mut libm::hypot);
        let mut amounts = start;
        for step in 0..=NEWTON {
            let (values, slope) = self.linear(amounts, &mut libm::hypot);
            if Self::settled(amounts, values, start, &bounds) {
                return Ok((amounts, step));
            }
            amounts = Self::newton(amounts, values, slope);
        }
        self.guarded(start, &bounds).ok_or(0)
    }

    /// Newton's steps, each replaced by Φ where it gains less than that.
    #[inline(always)]
    fn guarded(&self, start: [f64; M], bounds: &[[f64; M]; M]) -> Option<([f64; M], usize)> {
        let mut units = [1.0; M];
        for j in 0..M {
            let mut changes = 0.0;
            for (bound, start) in bounds[j].iter().zip(&start) {
                changes += bound * start;
            }
            let size = start[j] + changes;
            if size > 0.0 {
                units[j] = size;
            }
        }
        let weights = solve(without(*bounds), units);
        let off = |amounts: [f64; M], values: [f64; M]| {
            let mut off = [0.0; M];
            for j in 0..M {
                off[j] = magnitude(values[j] - amounts[j]) / weights[j];
            }
            largest(off)
        };
        let mut gains = [0.0; M];
        for j in 0..M {
            gains[j] = 1.0 - units[j] / weights[j];
        }
        let least_gain = largest(gains);
        let mut amounts = start;
        let (mut values, mut slope) = self.linear(amounts, &mut libm::hypot);
        for step in 0..=GUARDED {
            if Self::settled(amounts, values, start, bounds) {
                return Some((amounts, NEWTON + step));
            }
            let next = Self::newton(amounts, values, slope);
            let (next_values, _) = self.linear(next, &mut libm::hypot);
            let is_gain = off(next, next_values) <= least_gain * off(amounts, values);
            amounts = if is_gain { next } else { values };
            (values, slope) = self.linear(amounts, &mut libm::hypot);
        }
        None
    }
}

/// Solutions and their steps, by all of the search and by guarded steps alone: beside those of a page's script.
#[cfg(all(test, feature = "page"))]
impl<const W: usize, const M: usize> System<f64, W, M> {
    pub(crate) fn in_steps(&self) -> [Option<([f64; M], usize)>; 2] {
        let (start, _) = self.linear([0.0; M], &mut libm::hypot);
        [self.solved_in().ok(), self.guarded(start, &self.bounds())]
    }
}

/// The largest of these, or zero.
#[inline(always)]
fn largest<const M: usize>(numbers: [f64; M]) -> f64 {
    let mut largest = 0.0;
    for number in numbers {
        largest = f64::max(largest, number);
    }
    largest
}

/// The first contact whose pivot is not positive.
#[inline(always)]
pub(super) fn jammed<const M: usize>(bounds: [[f64; M]; M]) -> Option<usize> {
    let (mut matrix, mut right) = (without(bounds), [0.0; M]);
    for k in 0..M {
        let pivot = matrix[k][k];
        // NaN is no positive pivot.
        if pivot <= 0.0 || pivot.is_nan() {
            return Some(k);
        }
        eliminate(&mut matrix, &mut right, k);
    }
    None
}
