//! The amounts of friction that depend on each other, as the solution of their equations.
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
use crate::ir::graph::Node;
use crate::ir::implicit::Contacts;

/// The amounts, provided that friction does not hold itself.
pub(super) fn solved<'s>(rows: &[Row<'s>]) -> Vec<Sym<'s>> {
    let starts: Vec<_> = rows.iter().map(|row| row.share * row.size()).collect();
    let depends = |row: &Row<'s>| row.changes.iter().flatten().any(|change| !change.is_zero());
    if !rows.iter().any(depends) {
        return starts;
    }
    let joints = rows.iter().map(|row| (row.joint.clone(), row.is_guide)).collect();
    let equations = rows.iter().flat_map(Row::operands).chain(starts.iter().copied());
    let equations = equations.map(|value| value.id).collect();
    let (mut found, [mut positive, mut small]) = (starts, [Vec::new(), Vec::new()]);
    if rows.len() <= straight::MOST {
        let Straight { amounts, positive: above_zero, small: pairs } = straight(rows);
        positive.extend(above_zero.into_iter().map(|value| value.id));
        small.extend(pairs.into_iter().flatten().map(|value| value.id));
        found = amounts;
    }
    let builder = rows[0].share.builder();
    let contacts = Contacts { joints, equations, positive, small };
    let solve = builder.implicit(contacts.into());
    let solved = found.iter().zip(0..);
    solved.map(|(on, at)| builder.node(Node::Solved(solve, at, Some(on.id)))).collect()
}

/// The same of rows that are given, each c, G and A as the run-time crate lays it out.
pub fn amounts_of<'s>(rows: &[Vec<Sym<'s>>], are_guides: &[bool]) -> Vec<Sym<'s>> {
    let row = |(row, &is_guide): (&Vec<Sym<'s>>, &bool)| Row {
        share: row[0],
        free: [row[1], row[2]],
        changes: row[3..].chunks(2).map(|change| [change[0], change[1]]).collect(),
        is_guide,
        joint: String::new(),
    };
    let rows: Vec<_> = rows.iter().zip(are_guides).map(row).collect();
    solved(&rows)
}
