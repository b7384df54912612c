//! Constants that a function reads more than once: bound to names where it begins. Each is a call for
//! the compiler, a fifth of all that a mechanism's formulas make, and nothing at run time.

use super::context::Context;
use super::text::Text;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::lower::routine::{Locals, Routine, Statement};

/// The names of constants.
#[derive(Default)]
pub(super) struct Constants(Map<Node, String>);

impl Constants {
    /// Those that the routine reads more than once, in the order in which it does.
    pub(super) fn shared(graph: &Graph, routine: &Routine) -> Self {
        let mut count = Count { graph, locals: &routine.locals, times: Map::default() };
        for stage in &routine.stages {
            count.statements(&stage.statements);
            stage.sinks.iter().for_each(|&sink| count.value(sink));
        }
        let mut stem = "k".to_string();
        while routine.locals.names.values().any(|name| name.starts_with(&stem)) {
            stem.push('k');
        }
        let often = count.times.iter().filter(|(_, times)| *times > 1);
        let named = often.enumerate().map(|(nth, (node, _))| (*node, format!("{stem}{nth}_")));
        Self(named.collect())
    }

    pub(super) fn name(&self, constant: Node) -> Option<&str> {
        self.0.get(&constant).map(|name| &name[..])
    }

    /// Binds the names.
    pub(super) fn bind(&self, cx: &Context<'_>, to: &mut Text) {
        for (constant, name) in self.0.iter() {
            to.put("let ").put(name).put(" = ").put(&cx.constant(*constant)).put(";\n");
        }
    }
}

/// How often each constant is read.
struct Count<'g> {
    graph: &'g Graph,
    locals: &'g Locals,
    times: Map<Node, u32>,
}

impl Count<'_> {
    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Let(id) | Statement::Hypot { id, .. } => self.operands(*id),
                Statement::Check(condition) => {
                    self.value(condition.value);
                    condition.operands.iter().for_each(|&operand| self.value(operand));
                }
                Statement::Tell { statements, clearances } => {
                    self.statements(statements);
                    clearances.iter().for_each(|&id| self.value(id));
                }
                Statement::SinCos { .. } | Statement::Find { .. } => {}
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
