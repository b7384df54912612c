//! Choice of the values that are written where they are read.
//!
//! A local costs rustc as much as the operation that it names. A value that has no letter, and is read
//! by the statement behind it alone, is therefore written inside of that: `a * b + c` in place of two
//! lines. No operation changes its place, so that the machine code stays what it was.

use super::routine::{Instruction, Locals};
use super::schedule::Schedule;
use crate::ir::graph::Id;

/// The most operations that stand in one expression.
const MOST: usize = 4;

/// Number of reads of each value of the graph as a local.
pub fn reads(schedule: &Schedule<'_>, stages: &[Vec<Instruction>], sinks: &[Id]) -> Vec<u32> {
    let mut reads = vec![0; schedule.graph.len()];
    let mut read = |id: Id| reads[id.index()] += 1;
    stages.iter().flatten().for_each(|statement| schedule.for_uses(statement, &mut read));
    schedule.for_locals(sinks, &mut read);
    reads
}

/// The statements without those whose values are written inside of the next one, of which `locals` is
/// told.
pub fn nest(
    schedule: &Schedule<'_>,
    reads: &[u32],
    locals: &mut Locals,
    statements: Vec<Instruction>,
) -> Vec<Instruction> {
    // Each with the number of its operations.
    let mut kept: Vec<(Instruction, usize)> = Vec::with_capacity(statements.len());
    for mut statement in statements {
        let mut operations = 1;
        let mut operands = Vec::new();
        match &mut statement {
            Instruction::Let(_) => {
                schedule.for_uses(&statement, &mut |operand| operands.push(operand));
            }
            Instruction::ReportClearances { statements, .. } => {
                *statements = nest(schedule, reads, locals, std::mem::take(statements));
            }
            _ => {}
        }
        while let Some(&(Instruction::Let(last), within)) = kept.last()
            && reads[last.index()] == 1
            && (locals.names.get(&last).is_none() || locals.in_passing.contains(&last))
            && operations + within <= MOST
            && let Some(place) = operands.iter().position(|&operand| operand == last)
        {
            // If two operands are written inside, the first has to be the one on the left.
            operands.truncate(place);
            operations += within;
            locals.nested.insert(last);
            kept.pop();
        }
        kept.push((statement, operations));
    }
    kept.into_iter().map(|(statement, _)| statement).collect()
}
