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
pub(super) fn reads(
    schedule: &Schedule<'_>,
    stages: &[Vec<Instruction>],
    sinks: &[Id],
) -> Vec<u32> {
    let mut reads = vec![0; schedule.graph.len()];
    let mut read = |id: Id| reads[id.index()] += 1;
    stages.iter().flatten().for_each(|statement| schedule.for_uses(statement, &mut read));
    schedule.for_locals(sinks, &mut read);
    reads
}

/// The statements without those whose values are written inside of the next one, of which `locals` is
/// told.
pub(super) fn nest(
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::graph::{Graph, Node};
    use crate::ir::liveness::{Path, live, tried};
    use crate::lower::schedule::defines;

    /// Numbers of the nodes with locals of their own, in a graph over two values, a = 0 and b = 1.
    fn locals_of(make: impl FnOnce(&mut Graph, [Id; 2]) -> Vec<Id>, named: &[u32]) -> Vec<u32> {
        let mut graph = Graph::new();
        let given = [0, 1].map(|param| graph.push(Node::Mode(param)));
        let sinks = make(&mut graph, given);
        let mut locals = Locals::default();
        locals.names.extend(named.iter().map(|&id| (Id(id), "letter_".to_string())));
        let unnamed = Locals::default();
        let (tried, live) = (tried(&graph), live(&graph, &sinks, Path::Slow));
        let mut schedule = Schedule::new(&graph, &unnamed, Path::Slow, None, &[], &tried, &live);
        let statements = schedule.stage(&live);
        let before: Vec<Id> = statements.iter().flat_map(defines).collect();
        let reads = reads(&schedule, std::slice::from_ref(&statements), &sinks);
        let statements = nest(&schedule, &reads, &mut locals, statements);
        let left: Vec<Id> = statements.iter().flat_map(defines).collect();
        assert!(before.iter().all(|id| left.contains(id) != locals.nested.contains(id)));
        left.into_iter().map(|id| id.0).collect()
    }

    #[test]
    fn what_the_next_statement_alone_reads_is_written_there() {
        // 2 = ab, 3 = ab + b.
        let sum = |g: &mut Graph, [a, b]: [Id; 2]| {
            let product = g.push(Node::Mul(a, b));
            vec![g.push(Node::Add(product, b))]
        };
        assert_eq!(locals_of(sum, &[]), [0, 1, 3]);
        assert_eq!(locals_of(sum, &[2]), [0, 1, 2, 3], "a letter is kept");
        let results = |g: &mut Graph, given: [Id; 2]| [Id(2), sum(g, given)[0]].to_vec();
        assert_eq!(locals_of(results, &[]), [0, 1, 2, 3], "a result is read by its name");
        let square = |g: &mut Graph, given: [Id; 2]| {
            let sum = sum(g, given)[0];
            vec![g.push(Node::Mul(sum, sum))]
        };
        assert_eq!(locals_of(square, &[]), [0, 1, 3, 4], "what is read twice is computed once");
    }

    #[test]
    fn operations_stay_in_their_order() {
        // 2 = ab and 3 = a + b, …
        let pair =
            |g: &mut Graph, [a, b]: [Id; 2]| [g.push(Node::Mul(a, b)), g.push(Node::Add(a, b))];
        // … of which the first is on the left, or on the right.
        let forth = |g: &mut Graph, given| {
            let [first, second] = pair(g, given);
            vec![g.push(Node::Sub(first, second))]
        };
        let back = |g: &mut Graph, given| {
            let [first, second] = pair(g, given);
            vec![g.push(Node::Sub(second, first))]
        };
        assert_eq!(locals_of(forth, &[]), [0, 1, 4]);
        assert_eq!(locals_of(back, &[]), [0, 1, 2, 4]);
        // Something else stands between 2 and its reader.
        let apart = |g: &mut Graph, given| {
            let [first, second] = pair(g, given);
            let sum = g.push(Node::Sub(first, given[0]));
            vec![sum, g.push(Node::Add(second, second))]
        };
        assert_eq!(locals_of(apart, &[]), [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn an_expression_has_four_operations_at_most() {
        let chain = |g: &mut Graph, [a, b]: [Id; 2]| {
            vec![(0..9).fold(a, |sum, _| g.push(Node::Add(sum, b)))]
        };
        assert_eq!(locals_of(chain, &[]), [0, 1, 5, 9, 10]);
    }
}
