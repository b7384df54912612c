//! Amounts of friction that depend on each other, as a condition on where steps to them begin.
//!
//! ```text
//! xⱼ = Φⱼ(x) = cⱼ ‖Gⱼ + Σₖ Aⱼₖ xₖ‖
//! ```
//!
//! The steps begin at Φ(0). The run-time crate's `friction.rs` makes them, and has the theory.

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

/// The amounts, provided that friction does not hold itself.
pub(super) fn solved<'s>(rows: &[Row<'s>], group: u32) -> Vec<Sym<'s>> {
    let starts: Vec<_> = rows.iter().map(|row| row.share * row.size()).collect();
    let depends = |row: &Row<'s>| row.changes.iter().flatten().any(|change| !change.is_zero());
    if !rows.iter().any(depends) {
        return starts;
    }
    let joints: Vec<_> = rows.iter().map(|row| (row.joint.clone(), row.is_guide)).collect();
    let operands: Vec<_> =
        rows.iter().flat_map(Row::operands).chain(starts.iter().copied()).collect();
    let provided = starts.iter().enumerate().map(|(at, start)| {
        let contacts = Contacts { at, joints: joints.clone() };
        start.guarded_by(Check::Amount(contacts), group, &operands)
    });
    provided.collect()
}

impl<'s> Row<'s> {
    /// c, G and A, as the run-time crate lays a row out.
    fn operands(&self) -> impl Iterator<Item = Sym<'s>> {
        let changes = self.changes.iter().flatten().copied();
        std::iter::once(self.share).chain(self.free).chain(changes)
    }

    /// The size of the reaction without friction.
    fn size(&self) -> Sym<'s> {
        let [x, y] = self.free;
        if !self.is_guide {
            return x.hypot(y);
        }
        let [x, y] = [x, y].map(Sym::magnitude);
        if y.is_zero() { x } else { x.at_least(y, x, y) }
    }
}
