//! Amounts of friction that depend on each other, by straight-line steps.
//!
//! ```text
//! xⱼ = Φⱼ(x) = cⱼ ‖Gⱼ + Σₖ Aⱼₖ xₖ‖
//! ```
//!
//! From Φ(0) Newton's method takes at most three steps where friction is moderate, so three are written
//! down, and the condition that they have ended. A fourth one brings derivatives of every order to
//! the end: those of a step at a solution are the solution's. Where the condition does not hold, the slow path
//! searches on, or finds that friction may hold itself. The run-time crate's `friction.rs` has the theory.

use crate::equations::symbol::Sym;
use crate::ir::graph::{Check, Contacts};

/// One amount's equation.
pub(super) struct Row<'s> {
    /// c
    pub share: Sym<'s>,
    /// G
    pub free: [Sym<'s>; 2],
    /// A, by amount.
    pub changes: Vec<[Sym<'s>; 2]>,
    pub is_guide: bool,
    /// The joint, as errors name it.
    pub joint: String,
}

/// Steps of Newton's method before the condition is asked.
const STEPS: usize = 3;

/// The amounts, provided that they solve their equations.
pub(super) fn solved<'s>(rows: &[Row<'s>], group: u32) -> Vec<Sym<'s>> {
    let start: Vec<_> = rows.iter().map(|row| row.share * row.size(row.free)).collect();
    let depends = |row: &Row<'s>| row.changes.iter().flatten().any(|change| !change.is_zero());
    if !rows.iter().any(depends) {
        return start;
    }
    let last = (0..STEPS).fold(start, |amounts, _| newton(rows, &amounts));
    let operands: Vec<_> = rows.iter().zip(&last).flat_map(|(row, x)| row.operands(*x)).collect();
    let joints: Vec<_> = rows.iter().map(|row| (row.joint.clone(), row.is_guide)).collect();
    let found = newton(rows, &last).into_iter().enumerate();
    let provided = found.map(|(at, amount)| {
        let contacts = Contacts { at, joints: joints.clone() };
        amount.guarded_by(Check::Amount(contacts), group, &operands)
    });
    provided.collect()
}

/// x + (I − Φ′)⁻¹ (Φ(x) − x)
fn newton<'s>(rows: &[Row<'s>], amounts: &[Sym<'s>]) -> Vec<Sym<'s>> {
    let one = amounts[0].builder().integer(1);
    let (mut matrix, mut right) = (Vec::new(), Vec::new());
    for (j, row) in rows.iter().enumerate() {
        let (size, slopes) = row.size_and_slopes(row.reaction(amounts));
        let entry = |(k, slope): (usize, Sym<'s>)| {
            let slope = -(row.share * slope);
            if j == k { one + slope } else { slope }
        };
        matrix.push(slopes.into_iter().enumerate().map(entry).collect::<Vec<_>>());
        right.push(row.share * size - amounts[j]);
    }
    let steps = eliminated(matrix, right);
    amounts.iter().zip(steps).map(|(amount, step)| *amount + step).collect()
}

/// The solution of a system whose elimination needs no exchanges.
fn eliminated<'s>(mut matrix: Vec<Vec<Sym<'s>>>, mut right: Vec<Sym<'s>>) -> Vec<Sym<'s>> {
    let count = right.len();
    for k in 0..count {
        let inverse = matrix[k][k].recip();
        for j in k + 1..count {
            let factor = matrix[j][k] * inverse;
            let (above, below) = matrix.split_at_mut(j);
            for (entry, pivot) in below[0].iter_mut().zip(&above[k]).skip(k + 1) {
                *entry = *entry - factor * *pivot;
            }
            right[j] = right[j] - factor * right[k];
        }
    }
    for k in (0..count).rev() {
        let known = (k + 1..count).fold(right[k], |sum, i| sum - matrix[k][i] * right[i]);
        right[k] = known / matrix[k][k];
    }
    right
}

impl<'s> Row<'s> {
    /// c, G, the amount and A, as the run-time crate lays a row out.
    fn operands(&self, amount: Sym<'s>) -> Vec<Sym<'s>> {
        let [x, y] = self.free;
        let changes = self.changes.iter().flatten().copied();
        [self.share, x, y, amount].into_iter().chain(changes).collect()
    }

    fn reaction(&self, amounts: &[Sym<'s>]) -> [Sym<'s>; 2] {
        let sum = |axis: usize| {
            let changes = self.changes.iter().zip(amounts);
            changes.fold(self.free[axis], |sum, (change, amount)| sum + change[axis] * *amount)
        };
        [sum(0), sum(1)]
    }

    fn size(&self, [x, y]: [Sym<'s>; 2]) -> Sym<'s> {
        match (self.is_guide, self.has_couple()) {
            (false, _) => x.hypot(y),
            (true, false) => x.magnitude(),
            (true, true) => {
                let [x, y] = [x, y].map(Sym::magnitude);
                x.at_least(y, x, y)
            }
        }
    }

    /// True if the couple at a guide counts.
    fn has_couple(&self) -> bool {
        [self.free].iter().chain(&self.changes).any(|[_, couple]| !couple.is_zero())
    }

    /// The size of a reaction, and its slope by each amount; at a corner that of one side.
    fn size_and_slopes(&self, [x, y]: [Sym<'s>; 2]) -> (Sym<'s>, Vec<Sym<'s>>) {
        let zero = x.builder().zero();
        let changes = self.changes.iter();
        let signed = |of: Sym<'s>, value: Sym<'s>| of.at_least(zero, value, -value);
        match (self.is_guide, self.has_couple()) {
            (false, _) => {
                let size = x.hypot(y);
                let inverse = zero.at_least(size, zero, size.recip());
                let [x, y] = [x, y].map(|part| part * inverse);
                (size, changes.map(|[by_x, by_y]| *by_x * x + *by_y * y).collect())
            }
            (true, false) => (x.magnitude(), changes.map(|[by, _]| signed(x, *by)).collect()),
            (true, true) => {
                let sizes = [x, y].map(Sym::magnitude);
                let larger = |first, second| sizes[0].at_least(sizes[1], first, second);
                let slope =
                    |[by_x, by_y]: &[Sym<'s>; 2]| larger(signed(x, *by_x), signed(y, *by_y));
                (larger(sizes[0], sizes[1]), changes.map(slope).collect())
            }
        }
    }
}
