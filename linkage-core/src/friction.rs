//! Friction that follows from reactions: amounts that are shares of what they change themselves.
//!
//! # The equation
//! Amount xⱼ ≥ 0 of contact j is a share of the size of the contact's reaction, which is affine in all
//! amounts, because the links' equations are linear:
//!
//! ```text
//! xⱼ = Φⱼ(x) = cⱼ ‖Gⱼ + Σₖ Aⱼₖ xₖ‖        Lⱼₖ = cⱼ ‖Aⱼₖ‖
//! ```
//!
//! The size of a pin's force (Rx, Ry) is its Euclidean length. The size of what a guide exerts, (N, 2T/b) at
//! a block of length b, is the larger magnitude of the two.
//!
//! # One solution
//! |Φ(x) − Φ(y)| ≤ L |x − y|, component by component. If the spectral radius ρ of L ≥ 0 is below one, Φ
//! contracts in a norm that is weighed by (I − L)⁻¹v of any v > 0, so there is exactly one solution, for
//! every load. And ρ < 1 just where elimination of I − L without exchanges leaves positive pivots: it is an
//! M-matrix then. Where ρ ≥ 1, some load leaves one amount none or two solutions: friction may hold itself,
//! and the answer is `Jams`.
//!
//! # The search
//! Newton's method from Φ(0). The slope of Φ is at most L in magnitude, so that its matrix needs no
//! exchanges either. At a corner, where two components are equal or a reaction is zero, the slope is that of
//! one side. Corners may send the steps in a cycle. So a search that has not ended after [`NEWTON`]
//! steps begins anew, and a step that gains less than Φ would is replaced by Φ.
//!
//! # The end
//! |Φⱼ(x) − xⱼ| ≤ 4ε (cⱼ ‖Gⱼ‖ + (L x)ⱼ), what rounding leaves of Φ: newtons stand beside newton metres, and
//! each amount is measured by its own. For every x the solution x* obeys |x − x*| ≤ (I − L)⁻¹ |Φ(x) − x|.

#[cfg(test)]
mod tests;

use crate::diagnosis::Diagnosis;
use crate::{Mask, Real, Scalar, SolveError};

/// Steps of Newton's method before steps are guarded. Of 56,000 random problems of up to eight amounts five
/// took more: all of them cycles.
const NEWTON: usize = 8;

/// Steps of the guarded search. One gains the factor 1 − 1/max w at least.
const GUARDED: usize = 64;

/// Units in the last place that rounding leaves of Φ.
const ROUNDINGS: f32 = 4.0;

/// An amount of friction: the condition on a value that straight-line code has found.
///
/// Each of M amounts has a row of 4 + 2M numbers: c, both components of G, the value before the last
/// step, and both components of A for each amount.
#[derive(Clone, Copy, Debug)]
pub struct Amount<T, const W: usize, const M: usize> {
    /// The rows of all amounts.
    pub rows: [[T; W]; M],
    /// The row of this one.
    pub at: usize,
    /// Bit j is set if contact j is a guide.
    pub guides: u32,
    /// The joints, as errors name them.
    pub joints: [&'static str; M],
}

impl<T: Scalar, const W: usize, const M: usize> Diagnosis<T> for Amount<T, W, M> {
    /// Newton's method in the number's own arithmetic adds an order of derivatives a step to the solution
    /// of the values.
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let plain = System { rows: self.rows.map(|row| row.map(T::value)), guides: self.guides };
        // Steps that jam may end anywhere.
        let given = plain.rows.iter().flat_map(|row| row[..LAST].iter().chain(&row[CHANGES..]));
        if !given.copied().all(f64::is_finite) {
            return Err(SolveError::NotFinite { name: self.joints[self.at] });
        }
        let own = System { rows: self.rows, guides: self.guides };
        let last = own.rows.map(|row| row[LAST]);
        if own.pivots_are_positive() && own.settled(last) && value.value().is_finite() {
            return Ok(value);
        }
        let found =
            plain.solved().map_err(|joint| SolveError::Jams { joint: self.joints[joint] })?;
        let (_, reactions) = plain.at(found);
        let slope = plain.without(|j, k| plain.slope(j, k, reactions[j]));
        let mut amounts = found.map(T::num);
        for _ in 0..T::ORDER {
            for (k, (off, _)) in own.residual(amounts).into_iter().enumerate() {
                for (amount, step) in amounts.iter_mut().zip(inverse_column(slope, k)) {
                    *amount = *amount + T::num(step) * off;
                }
            }
        }
        Ok(amounts[self.at])
    }

    #[inline(always)]
    fn behind(self, met: T::Mask, _: T) -> T::Mask {
        let system = System { rows: self.rows, guides: self.guides };
        let settled = system.settled(system.rows.map(|row| row[LAST]));
        met.and_condition(system.pivots_are_positive() & settled).behind_condition()
    }
}

/// Places in a row.
const SHARE: usize = 0;
const FREE: usize = 1;
const LAST: usize = 3;
const CHANGES: usize = 4;

/// The amounts of contacts that depend on each other.
#[derive(Clone, Copy)]
struct System<T, const W: usize, const M: usize> {
    rows: [[T; W]; M],
    guides: u32,
}

impl<T: Scalar, const W: usize, const M: usize> System<T, W, M> {
    fn is_guide(&self, j: usize) -> bool {
        self.guides >> j & 1 == 1
    }

    fn pair(&self, j: usize, first: usize) -> [T; 2] {
        [self.rows[j][first], self.rows[j][first + 1]]
    }

    /// cⱼ times the size of a reaction.
    #[inline(always)]
    fn amount(&self, j: usize, [x, y]: [T; 2]) -> T {
        let size = if self.is_guide(j) {
            let [x, y] = [magnitude(x), magnitude(y)];
            T::select(x.ge(y), x, y)
        } else {
            T::fused(x, x, y * y).sqrt()
        };
        self.rows[j][SHARE] * size
    }

    /// Lⱼₖ
    #[inline(always)]
    fn bound(&self, j: usize, k: usize) -> T {
        self.amount(j, self.pair(j, CHANGES + 2 * k))
    }

    #[inline(always)]
    fn reaction(&self, j: usize, amounts: [T; M]) -> [T; 2] {
        let mut sum = self.pair(j, FREE);
        for (k, &amount) in amounts.iter().enumerate() {
            let [x, y] = self.pair(j, CHANGES + 2 * k);
            sum = [T::fused(x, amount, sum[0]), T::fused(y, amount, sum[1])];
        }
        sum
    }

    /// Φⱼ(x) − xⱼ, and what its rounding is measured by.
    #[inline(always)]
    fn residual(&self, amounts: [T; M]) -> [(T, T); M] {
        core::array::from_fn(|j| {
            let off = self.amount(j, self.reaction(j, amounts)) - amounts[j];
            let mut size = self.amount(j, self.pair(j, FREE));
            for (k, &amount) in amounts.iter().enumerate() {
                size = T::fused(self.bound(j, k), amount, size);
            }
            (off, size)
        })
    }

    /// True where the amounts solve their equations as far as rounding can tell.
    #[inline(always)]
    fn settled(&self, amounts: [T; M]) -> T::Mask {
        let share = T::lit(f64::from(ROUNDINGS) * f64::EPSILON, ROUNDINGS * f32::EPSILON);
        let mut met = T::Mask::ALL;
        for (off, size) in self.residual(amounts) {
            met = met & off.is_within(share * size);
        }
        met
    }

    /// I − the matrix.
    #[inline(always)]
    fn without(&self, entry: impl Fn(usize, usize) -> T) -> [[T; M]; M] {
        let unit = |j, k| if j == k { T::lit(1.0, 1.0) } else { T::lit(0.0, 0.0) };
        core::array::from_fn(|j| core::array::from_fn(|k| unit(j, k) - entry(j, k)))
    }

    /// True where ρ(L) < 1.
    #[inline(always)]
    fn pivots_are_positive(&self) -> T::Mask {
        let mut matrix = self.without(|j, k| self.bound(j, k));
        let mut met = T::Mask::ALL;
        for k in 0..M {
            met = met & matrix[k][k].gt(T::lit(0.0, 0.0));
            eliminate(&mut matrix, k);
        }
        met
    }
}

/// Clears a column below its pivot.
#[inline(always)]
fn eliminate<T: Scalar, const M: usize>(matrix: &mut [[T; M]; M], k: usize) {
    let top = matrix[k];
    for row in matrix.iter_mut().skip(k + 1) {
        let factor = row[k] / top[k];
        for (entry, &above) in row.iter_mut().zip(&top) {
            *entry = T::fused(-factor, above, *entry);
        }
    }
}

impl<const W: usize, const M: usize> System<f64, W, M> {
    /// Φ(x), and the reactions there.
    fn at(&self, amounts: [f64; M]) -> ([f64; M], [[f64; 2]; M]) {
        let reactions = core::array::from_fn(|j| self.reaction(j, amounts));
        (core::array::from_fn(|j| self.size(j, reactions[j])), reactions)
    }

    /// [`Self::amount`] without underflow.
    fn size(&self, j: usize, reaction: [f64; 2]) -> f64 {
        match self.is_guide(j) {
            true => self.amount(j, reaction),
            false => self.rows[j][SHARE] * libm::hypot(reaction[0], reaction[1]),
        }
    }

    /// ∂Φⱼ/∂xₖ; at a corner that of one side.
    fn slope(&self, j: usize, k: usize, [x, y]: [f64; 2]) -> f64 {
        let [by_x, by_y] = self.pair(j, CHANGES + 2 * k);
        let slope = match (self.is_guide(j), libm::hypot(x, y)) {
            (true, _) if magnitude(x) >= magnitude(y) => libm::copysign(by_x, by_x * x),
            (true, _) => libm::copysign(by_y, by_y * y),
            (false, size) if size > 0.0 => by_x * (x / size) + by_y * (y / size),
            (false, _) => 0.0,
        };
        self.rows[j][SHARE] * slope
    }

    /// x + (I − Φ′)⁻¹ (Φ(x) − x)
    fn newton(&self, amounts: [f64; M]) -> [f64; M] {
        let (value, reactions) = self.at(amounts);
        let matrix = self.without(|j, k| self.slope(j, k, reactions[j]));
        let step = solve(matrix, core::array::from_fn(|j| value[j] - amounts[j]));
        core::array::from_fn(|j| amounts[j] + step[j])
    }

    /// The only solution; or the contact at which friction may hold itself.
    fn solved(&self) -> Result<[f64; M], usize> {
        self.solved_in().map(|(amounts, _)| amounts)
    }

    /// The same, and the number of steps.
    fn solved_in(&self) -> Result<([f64; M], usize), usize> {
        self.jammed().map_or(Ok(()), Err)?;
        let (start, _) = self.at([0.0; M]);
        let mut amounts = start;
        for step in 0..=NEWTON {
            if self.settled(amounts) {
                return Ok((amounts, step));
            }
            amounts = self.newton(amounts);
        }
        self.guarded(start).ok_or(0)
    }

    /// The first contact whose pivot is not positive.
    fn jammed(&self) -> Option<usize> {
        let mut matrix = self.without(|j, k| self.bound(j, k));
        (0..M).find(|&k| {
            // NaN is no positive pivot.
            let pivot = matrix[k][k];
            eliminate(&mut matrix, k);
            pivot <= 0.0 || pivot.is_nan()
        })
    }

    /// Newton's steps, each replaced by Φ where it gains less than that.
    fn guarded(&self, start: [f64; M]) -> Option<([f64; M], usize)> {
        let unit = |j: usize| {
            let size = start[j] + (0..M).map(|k| self.bound(j, k) * start[k]).sum::<f64>();
            if size > 0.0 { size } else { 1.0 }
        };
        let units: [f64; M] = core::array::from_fn(unit);
        let weights = solve(self.without(|j, k| self.bound(j, k)), units);
        let gain = (0..M).map(|j| 1.0 - units[j] / weights[j]).fold(0.0, f64::max);
        let off = |amounts: [f64; M]| {
            let (value, _) = self.at(amounts);
            (0..M).map(|j| magnitude(value[j] - amounts[j]) / weights[j]).fold(0.0, f64::max)
        };
        let mut amounts = start;
        for step in 0..=GUARDED {
            if self.settled(amounts) {
                return Some((amounts, NEWTON + step));
            }
            let next = self.newton(amounts);
            let gains = off(next) <= gain * off(amounts);
            amounts = if gains { next } else { self.at(amounts).0 };
        }
        None
    }
}

#[inline(always)]
fn magnitude<T: Scalar>(value: T) -> T {
    T::select(value.ge(T::lit(0.0, 0.0)), value, -value)
}

/// The solution of a system whose elimination needs no exchanges.
fn solve<const M: usize>(mut matrix: [[f64; M]; M], mut right: [f64; M]) -> [f64; M] {
    for k in 0..M {
        for j in k + 1..M {
            right[j] -= matrix[j][k] / matrix[k][k] * right[k];
        }
        eliminate(&mut matrix, k);
    }
    for k in (0..M).rev() {
        for j in k + 1..M {
            right[k] -= matrix[k][j] * right[j];
        }
        right[k] /= matrix[k][k];
    }
    right
}

fn inverse_column<const M: usize>(matrix: [[f64; M]; M], k: usize) -> [f64; M] {
    solve(matrix, core::array::from_fn(|j| if j == k { 1.0 } else { 0.0 }))
}
