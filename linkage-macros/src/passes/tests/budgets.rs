//! What each driver and group may cost, by variant: a lost common subexpression, a constant that
//! leaves a trace, or a group that is computed though nobody asked fails here by name.
//!
//! A budget counts what an output costs beyond the declaration without it: additions,
//! multiplications, divisions, roots, and sine-cosine pairs, a fused operation counting as an
//! addition and a multiplication. Lowering a number is welcome; raising one needs a reason.

use crate::ir::cost::{Operations, operations};
use crate::ir::program::EntryKind;
use crate::oracle::mechanism;
use crate::{equations, passes};

/// Additions, multiplications, divisions, roots, sine-cosine pairs.
type Budget = [u32; 5];

fn cost(source: &str, kind: EntryKind) -> Budget {
    let program = passes::optimise(&equations::derive(&mechanism(source), passes::RULES));
    let entry = program.entries.iter().find(|entry| entry.kind == kind).expect("the entry exists");
    let Operations { additions, multiplications, divisions, roots, sines } =
        operations(&program.graph, &entry.sinks);
    [additions, multiplications, divisions, roots, sines]
}

#[track_caller]
fn budget(name: &str, source: &str, position: Budget, motion: Budget) {
    assert_eq!(cost(source, EntryKind::Position), position, "{name}: position");
    assert_eq!(cost(source, EntryKind::Motion), motion, "{name}: motion");
}
