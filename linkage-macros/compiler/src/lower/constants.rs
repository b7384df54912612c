//! Constants that a function reads more than once: bound to names where it begins. Each is a call for
//! the compiler, a fifth of all that a mechanism's formulas make, and nothing at run time.

use super::routine::{Instruction, Locals, Stage};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;

/// The constants that the stages read more than once, in the order in which they do, and their names.
pub(super) fn shared(graph: &Graph, locals: &Locals, stages: &[Stage]) -> Map<Node, String> {
    let mut count = Count { graph, locals, times: Map::default() };
    for stage in stages {
        count.statements(&stage.statements);
        stage.sinks.iter().for_each(|&sink| count.value(sink));
    }
    let mut stem = "k".to_string();
    while locals.names.values().any(|name| name.starts_with(&stem)) {
        stem.push('k');
    }
    let often = count.times.iter().filter(|(_, times)| *times > 1);
    often.enumerate().map(|(nth, (node, _))| (*node, format!("{stem}{nth}_"))).collect()
}

/// Number of reads of each constant.
struct Count<'g> {
    graph: &'g Graph,
    locals: &'g Locals,
    times: Map<Node, u32>,
}

impl Count<'_> {
    fn statements(&mut self, statements: &[Instruction]) {
        for statement in statements {
            match statement {
                Instruction::Let(id) | Instruction::Length { id, .. } => self.operands(*id),
                Instruction::Check(condition) => {
                    self.value(condition.value);
                    condition.operands.iter().for_each(|&operand| self.value(operand));
                }
                // Signs of constants are handed to a search, which is no formula.
                Instruction::Solve(solving)
                    if self.graph.implicit(solving.implicit).is_search() => {}
                Instruction::Solve(solving) => {
                    let compared = solving.compares.iter().flatten();
                    compared.chain(&solving.reads).for_each(|&id| self.value(id));
                }
                Instruction::ReportClearances { statements, clearances } => {
                    self.statements(statements);
                    clearances.iter().for_each(|&id| self.value(id));
                }
                Instruction::SinCos { .. } => {}
            }
        }
    }

    fn value(&mut self, id: Id) {
        match self.graph.node(id) {
            node @ (Node::Constant(_) | Node::Low(_)) => *self.times.or_insert(node, 0) += 1,
            Node::Neg(of) => self.value(of),
            _ if self.locals.nested.contains(&id) => self.operands(id),
            _ => {}
        }
    }

    fn operands(&mut self, id: Id) {
        self.graph.node(id).for_operands(&mut |operand| self.value(operand));
    }
}
