//! The comparisons of an entry point's fast path, as they are printed.

use crate::interface::EntryId;
use crate::ir::graph::{Check, Id, Node};
use crate::lower::routine::{Bound, Compute, FinitenessChecks, Instruction, Lowered, Threshold};
use crate::prove::demand::Demand;
use crate::prove::width::Precision;

/// The comparisons on the way to what an entry point computes.
pub(super) fn demands(lowered: &Lowered<'_>, id: EntryId) -> Vec<Demand> {
    let Some((routine, last, _)) = own(lowered, id) else { return Vec::new() };
    let stages = &lowered.routines[routine].stages[..=last];
    stages.iter().flat_map(|stage| &stage.statements).filter_map(demand).collect()
}

/// The routine and the stage that compute an entry point, and what it asks beside.
fn own<'l>(lowered: &'l Lowered<'_>, id: EntryId) -> Option<(usize, usize, &'l FinitenessChecks)> {
    let mut id = id;
    // One by rates of one goes by velocities, which may go by cosine and sine.
    for _ in 0..3 {
        match lowered.compute(id) {
            Compute::Own { routine, stage, asked } => return Some((*routine, *stage, asked)),
            Compute::Delegate { entry, .. } => id = *entry,
        }
    }
    None
}

fn demand(statement: &Instruction) -> Option<Demand> {
    match statement {
        Instruction::Check(condition) => {
            let comparison = condition.comparison;
            let comparison = comparison.map(|(comparison, least)| (comparison, numbers(least)));
            let asks = comparison.is_some() || condition.above_rounding.is_some();
            let is_of_both = condition.check.is_of_both_paths();
            (asks || is_of_both).then_some(Demand::Compare {
                value: condition.value,
                comparison,
                above_rounding: condition.above_rounding,
                group: condition.group,
                certifies: condition.check == Check::Certified,
            })
        }
        Instruction::Length { id, least_square } => {
            Some(Demand::Length { id: *id, least_square: numbers(*least_square) })
        }
        Instruction::SinCos { angle, is_checked: true, .. } => Some(Demand::Near(*angle)),
        Instruction::SinCos { .. }
        | Instruction::Let(_)
        | Instruction::Solve(_)
        | Instruction::ReportClearances { .. } => None,
    }
}

fn numbers(threshold: Threshold) -> [f64; 2] {
    match threshold {
        Threshold::Number(double, single) => [double, single],
        Threshold::SmallestSquare => {
            [Precision::DOUBLE, Precision::SINGLE].map(Precision::smallest_square)
        }
    }
}

/// The largest rate of the inputs at which the fast path does not ask whether its results overflow, in double and in
/// single precision; none where no rate is asked.
pub(super) fn largest_rate(lowered: &Lowered<'_>, id: EntryId) -> Option<[f64; 2]> {
    let (_, _, asked) = own(lowered, id)?;
    let (_, bounds) = asked.finite.as_ref()?.instead.as_ref()?;
    let rates = bounds.iter().filter_map(|bound| match bound {
        Bound::Within { value: Node::Input { order: 1, .. }, limit } => Some(*limit),
        Bound::Within { .. } => None,
        Bound::WithRate { limit, .. } => Some(limit.map(f64::sqrt)),
        Bound::OnCircle { rate: None, .. } => None,
        Bound::OnCircle { second: None, limit, .. } => Some(limit.map(f64::sqrt)),
        Bound::OnCircle { limit, .. } => Some(limit.map(|limit| limit.sqrt().sqrt())),
    });
    rates.reduce(|[a, b], [c, d]| [a.min(c), b.min(d)])
}

/// The nodes that an entry point's results are.
pub(super) fn sinks<'l>(lowered: &'l Lowered<'_>, id: EntryId) -> &'l [Id] {
    &lowered.program.answers[id.index()].sinks
}
