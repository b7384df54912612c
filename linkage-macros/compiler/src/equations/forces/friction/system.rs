//! Amounts of friction that depend on each other, as a condition on where steps to them begin.
//!
//! ```text
//! xⱼ = Φⱼ(x) = cⱼ ‖Gⱼ + Σₖ Aⱼₖ xₖ‖
//! ```
//!
//! Few amounts are solved in [`straight`]-line code. The run-time crate's `friction.rs` takes over where that has
//! not ended, makes the steps of more amounts, from Φ(0), and has the theory.

use super::amount::Row;
use super::straight::{self, Straight, straight};
use crate::equations::symbol::Sym;
use crate::ir::graph::{Check, Contacts, Proofs};

/// The amounts, provided that friction does not hold itself.
pub(super) fn solved<'s>(rows: &[Row<'s>], group: u32) -> Vec<Sym<'s>> {
    let starts: Vec<_> = rows.iter().map(|row| row.share * row.size()).collect();
    let depends = |row: &Row<'s>| row.changes.iter().flatten().any(|change| !change.is_zero());
    if !rows.iter().any(depends) {
        return starts;
    }
    let joints: Vec<_> = rows.iter().map(|row| (row.joint.clone(), row.is_guide)).collect();
    let mut operands: Vec<_> =
        rows.iter().flat_map(Row::operands).chain(starts.iter().copied()).collect();
    let (mut found, mut proofs) = (starts, Proofs::default());
    if rows.len() <= straight::MOST {
        let Straight { amounts, positive, small } = straight(rows);
        (found, proofs) = (amounts, Proofs { positive: positive.len(), small: small.len() });
        operands.extend(positive.into_iter().chain(small.into_iter().flatten()));
    }
    let provided = found.iter().enumerate().map(|(at, found)| {
        let contacts = Contacts { at, joints: joints.clone(), proofs };
        found.guarded_by(Check::Amount(contacts), group, &operands)
    });
    provided.collect()
}

/// The same of rows that are given, each c, G and A as the run-time crate lays it out.
#[cfg(test)]
pub(in crate::equations) fn amounts_of<'s>(
    rows: &[Vec<Sym<'s>>],
    are_guides: &[bool],
) -> Vec<Sym<'s>> {
    let row = |(row, &is_guide): (&Vec<Sym<'s>>, &bool)| Row {
        share: row[0],
        free: [row[1], row[2]],
        changes: row[3..].chunks(2).map(|change| [change[0], change[1]]).collect(),
        is_guide,
        joint: String::new(),
    };
    let rows: Vec<_> = rows.iter().zip(are_guides).map(row).collect();
    solved(&rows, 0)
}
