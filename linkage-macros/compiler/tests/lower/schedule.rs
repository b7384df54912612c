//! Tests of `lower/schedule`.

use crate::function::Function;
use crate::ir::graph::{Check, Graph, Guard, Node};
use crate::ir::liveness::{Path, live, tried};
use crate::lower::routine::{Instruction, Locals, Threshold};
pub(crate) use linkage_compiler::lower::schedule::*;

/// The hypotenuses of a stage, and whether they are asked for their squares.
#[test]
fn a_hypotenuse_that_the_slow_path_alone_looks_at_is_not_asked() {
    let mut graph = Graph::new();
    let [a, b, c] = [0, 1, 2].map(|input| graph.push(Node::Input { input, order: 0 }));
    let (diagnosed, result) = (
        graph.push(Node::Apply2(Function::Hypot, a, b)),
        graph.push(Node::Apply2(Function::Hypot, b, c)),
    );
    // For an offset, the fast path reads the value alone.
    let check = Check::ReachOffset;
    let operands = vec![diagnosed, a, b];
    let sink = graph.guard(result, Guard { check, group: 0, operands });
    let asked = |path| {
        let locals = Locals::default();
        let (tried, fast) = (tried(&graph), live(&graph, &[sink], Path::Fast));
        let mut schedule = Schedule::new(&graph, &locals, path, None, &[], &tried, &fast);
        let statements = schedule.stage(&live(&graph, &[sink], path));
        let asked = statements.iter().filter_map(|statement| match statement {
            Instruction::Length { id, least_square } => Some((*id, *least_square)),
            _ => None,
        });
        asked.collect::<Vec<_>>()
    };
    assert_eq!(asked(Path::Slow), [(result, Threshold::SmallestSquare)]);
    assert_eq!(asked(Path::Unchecked), []);
}
