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
//! one side. Corners may send the steps in a cycle. So a search that has not ended after a
//! few steps begins anew, and a step that gains less than Φ would is replaced by Φ (`guarded.rs`).
//!
//! # Straight-line code
//! Generated code finds up to three amounts itself, and hands proofs to the checks (`straight.rs` of
//! `linkage-compiler`). The search is for where they fail, and for more amounts.
//!
//! # No panic
//! Libraries without the standard library link at every level of optimisation, so that no index may be out of
//! range for all that the compiler knows. At a level of size it knows an index from `0..M`, in the function
//! that holds the loop: not one that an iterator counts, nor one that is handed on.
//!
//! # The end
//! |Φⱼ(x) − xⱼ| ≤ 4ε (cⱼ ‖Gⱼ‖ + (L x)ⱼ), what rounding leaves of Φ: newtons stand beside newton metres, and
//! each amount is measured by its own. For every x the solution x* obeys |x − x*| ≤ (I − L)⁻¹ |Φ(x) − x|.

#![allow(clippy::needless_range_loop, reason = "see above: no panic")]

mod guarded;
#[cfg(test)]
mod tests;

use crate::{Mask, Real, Scalar, SolveError};

/// Units in the last place that rounding leaves of Φ.
const ROUNDINGS: f32 = 4.0;

/// Amounts of friction that depend on each other: the condition on values that straight-line code has
/// found.
#[derive(Clone, Copy, Debug)]
pub struct Amounts<T, const W: usize, const M: usize> {
    /// Their equations.
    pub system: System<T, W, M>,
    /// The joints, as errors name them.
    pub joints: [&'static str; M],
}

impl<T: Scalar, const W: usize, const M: usize> Amounts<T, W, M> {
    /// The solution.
    ///
    /// Newton's method in the number's own arithmetic adds an order of derivatives a step to the solution
    /// of the values.
    pub(crate) fn diagnose(self, start: [T; M]) -> Result<[T; M], SolveError>
    where
        T: Real,
    {
        let own = self.system;
        let plain = System { rows: own.rows.map(|row| row.map(T::value)), guides: own.guides };
        let is_given = |row: &[f64; W]| row.iter().copied().all(f64::is_finite);
        let mut rows = self.joints.iter().zip(&plain.rows);
        if let Some((name, _)) = rows.find(|(_, row)| !is_given(row)) {
            return Err(SolveError::NotFinite { name });
        }
        let (amounts, met) = own.stepped(start);
        if met && amounts.iter().all(|amount| amount.value().is_finite()) {
            return Ok(amounts);
        }
        // The optimiser does not know that it is one of them, and an index could panic.
        let named = |joint: usize| self.joints.get(joint).copied().unwrap_or_default();
        let found = plain.solved().map_err(|joint| SolveError::Jams { joint: named(joint) })?;
        let mut amounts = found.map(T::num);
        for _ in 0..T::ORDER {
            let (values, slope) = own.linear(amounts, &mut T::hypot);
            amounts = System::<T, W, M>::newton(amounts, values, slope);
        }
        Ok(amounts)
    }
}

/// Steps of Newton's method before the fast path asks whether they have ended.
const STEPS: usize = 3;

/// Places in a row.
const SHARE: usize = 0;
const FREE: usize = 1;
const CHANGES: usize = 3;

/// Equations of M amounts that depend on each other.
///
/// Each has a row of 3 + 2M numbers: c, both components of G, and both components of A for each amount.
#[derive(Clone, Copy, Debug)]
pub struct System<T, const W: usize, const M: usize> {
    /// The rows.
    pub rows: [[T; W]; M],
    /// Bit j is set if contact j is a guide.
    pub guides: u32,
}

impl<T: Scalar, const W: usize, const M: usize> System<T, W, M> {
    /// The solution from Φ(0), and where it is one: steps without a branch, as many as moderate friction
    /// takes. A step from a solution to within rounding brings derivatives of every order to the end:
    /// those of a step at a solution are the solution's.
    ///
    /// Without optimisation every operation that is inlined has a place of its own on the stack, and a machine
    /// with many groups overflows it.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn stepped(&self, start: [T; M]) -> ([T; M], T::Mask) {
        let least = T::smallest_square();
        let mut are_near = T::Mask::ALL;
        let mut near = |x: T, y: T| {
            let (length, is_near) = x.hypot_near(y, least);
            are_near = are_near & is_near;
            length
        };
        let bounds = self.bounds();
        let (mut amounts, mut met) = (start, T::Mask::ALL);
        for step in 0..=STEPS {
            let (values, slope) = self.linear(amounts, &mut near);
            if step == STEPS {
                let settled = Self::settled(amounts, values, start, &bounds);
                met = pivots_are_positive(bounds) & settled;
            }
            amounts = Self::newton(amounts, values, slope);
        }
        (amounts, met & are_near)
    }

    /// x + (I − Φ′)⁻¹ (Φ(x) − x)
    #[inline(always)]
    fn newton(mut amounts: [T; M], mut values: [T; M], slope: [[T; M]; M]) -> [T; M] {
        for (value, &amount) in values.iter_mut().zip(&amounts) {
            *value = *value - amount;
        }
        let step = solve(without(slope), values);
        for (amount, step) in amounts.iter_mut().zip(step) {
            *amount = *amount + step;
        }
        amounts
    }

    /// Φ(x) and its slope, ∂Φⱼ/∂xₖ; at a corner that of one side.
    #[inline(always)]
    fn linear(&self, amounts: [T; M], hypot: &mut impl FnMut(T, T) -> T) -> ([T; M], [[T; M]; M]) {
        let zero = T::lit(0.0, 0.0);
        let (mut values, mut slope) = ([zero; M], [[zero; M]; M]);
        for j in 0..M {
            let (size, [x, y]) = self.size_and_direction(j, self.reaction(j, amounts), hypot);
            let share = self.rows[j][SHARE];
            values[j] = share * size;
            let [x, y] = [share * x, share * y];
            for k in 0..M {
                let [by_x, by_y] = self.pair(j, CHANGES + 2 * k);
                slope[j][k] = T::fused(by_x, x, by_y * y);
            }
        }
        (values, slope)
    }

    /// The size of a reaction, and its slope by each component.
    #[inline(always)]
    fn size_and_direction(
        &self,
        j: usize,
        [x, y]: [T; 2],
        hypot: &mut impl FnMut(T, T) -> T,
    ) -> (T, [T; 2]) {
        let [zero, one] = [T::lit(0.0, 0.0), T::lit(1.0, 1.0)];
        if self.is_guide(j) {
            let [sizes, signs] = [[magnitude(x), magnitude(y)], [sign(x), sign(y)]];
            let larger = |first, second| T::select(sizes[0].ge(sizes[1]), first, second);
            return (larger(sizes[0], sizes[1]), [larger(signs[0], zero), larger(zero, signs[1])]);
        }
        let size = hypot(x, y);
        let inverse = T::select(zero.ge(size), zero, one / size);
        (size, [x * inverse, y * inverse])
    }

    #[inline(always)]
    fn is_guide(&self, j: usize) -> bool {
        self.guides >> j & 1 == 1
    }

    /// Two numbers of a row.
    #[inline(always)]
    fn pair(&self, j: usize, first: usize) -> [T; 2] {
        [self.rows[j][first], self.rows[j][first + 1]]
    }

    /// cⱼ times the size of a reaction; a pin's may underflow.
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

    /// L
    #[inline(always)]
    fn bounds(&self) -> [[T; M]; M] {
        let mut bounds = [[T::lit(0.0, 0.0); M]; M];
        for j in 0..M {
            for k in 0..M {
                bounds[j][k] = self.amount(j, self.pair(j, CHANGES + 2 * k));
            }
        }
        bounds
    }

    /// Changes come first: contacts that a couple loads alike share their sum.
    #[inline(always)]
    fn reaction(&self, j: usize, amounts: [T; M]) -> [T; 2] {
        let mut sum = [T::lit(0.0, 0.0); 2];
        for k in 0..M {
            let ([x, y], amount) = (self.pair(j, CHANGES + 2 * k), amounts[k]);
            sum = match k {
                0 => [x * amount, y * amount],
                _ => [T::fused(x, amount, sum[0]), T::fused(y, amount, sum[1])],
            };
        }
        let [x, y] = self.pair(j, FREE);
        [x + sum[0], y + sum[1]]
    }

    /// True where the amounts solve their equations as far as rounding can tell; `values` is Φ of them, `start`
    /// Φ(0), and `bounds` L.
    #[inline(always)]
    fn settled(amounts: [T; M], values: [T; M], start: [T; M], bounds: &[[T; M]; M]) -> T::Mask {
        let mut met = T::Mask::ALL;
        for j in 0..M {
            let mut size = start[j];
            for (&bound, &amount) in bounds[j].iter().zip(&amounts) {
                size = T::fused(bound, amount, size);
            }
            met = met & (values[j] - amounts[j]).is_within(rounding(size));
        }
        met
    }
}

/// The rounding of a number that is made of parts as large as this.
#[inline(always)]
pub(crate) fn rounding<T: Scalar>(size: T) -> T {
    T::lit(f64::from(ROUNDINGS) * f64::EPSILON, ROUNDINGS * f32::EPSILON) * size
}

/// I − the matrix.
#[inline(always)]
fn without<T: Scalar, const M: usize>(mut matrix: [[T; M]; M]) -> [[T; M]; M] {
    for (j, row) in matrix.iter_mut().enumerate() {
        for (k, entry) in row.iter_mut().enumerate() {
            *entry = if j == k { T::lit(1.0, 1.0) - *entry } else { -*entry };
        }
    }
    matrix
}

/// True where ρ(L) < 1.
#[inline(always)]
fn pivots_are_positive<T: Scalar, const M: usize>(bounds: [[T; M]; M]) -> T::Mask {
    let (mut matrix, mut right) = (without(bounds), [T::lit(0.0, 0.0); M]);
    let mut met = T::Mask::ALL;
    for k in 0..M {
        met = met & matrix[k][k].gt(T::lit(0.0, 0.0));
        eliminate(&mut matrix, &mut right, k);
    }
    met
}

/// Clears a column below its pivot, in the right side as well, and puts the pivot's inverse in its place.
///
/// Loops run over all indices: only those of a constant length are unrolled.
#[inline(always)]
fn eliminate<T: Scalar, const M: usize>(matrix: &mut [[T; M]; M], right: &mut [T; M], k: usize) {
    let (top, above, inverse) = (matrix[k], right[k], T::lit(1.0, 1.0) / matrix[k][k]);
    for j in 0..M {
        if j > k {
            let factor = -(matrix[j][k] * inverse);
            for i in 0..M {
                matrix[j][i] = T::fused(factor, top[i], matrix[j][i]);
            }
            right[j] = T::fused(factor, above, right[j]);
        }
    }
    matrix[k][k] = inverse;
}

#[inline(always)]
fn magnitude<T: Scalar>(value: T) -> T {
    T::select(value.ge(T::lit(0.0, 0.0)), value, -value)
}

#[inline(always)]
fn sign<T: Scalar>(value: T) -> T {
    T::select(value.ge(T::lit(0.0, 0.0)), T::lit(1.0, 1.0), T::lit(-1.0, -1.0))
}

/// The solution of a system whose elimination needs no exchanges.
#[inline(always)]
fn solve<T: Scalar, const M: usize>(mut matrix: [[T; M]; M], mut right: [T; M]) -> [T; M] {
    for k in 0..M {
        eliminate(&mut matrix, &mut right, k);
    }
    for back in 0..M {
        let k = M - 1 - back;
        for j in 0..M {
            if j > k {
                right[k] = T::fused(-matrix[k][j], right[j], right[k]);
            }
        }
        right[k] = right[k] * matrix[k][k];
    }
    right
}
