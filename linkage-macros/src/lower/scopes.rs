//! Which statements stand together in a scope of their own.
//!
//! rustc's work on a block grows faster than its length, and a debug build keeps a stack slot for
//! every local. A long routine is therefore cut into scopes that hand on only what is used later.

use super::routine::Statement;
use super::schedule::{Schedule, defines};
use crate::ir::graph::Id;
use crate::ir::hash::Map;

/// The most statements that stand in one scope.
const LONGEST: usize = 64;

/// The statements in scopes, where there are many. The locals in `kept` stay in scope.
pub(super) fn lay_out(
    schedule: &Schedule<'_>,
    statements: Vec<Statement>,
    kept: &[Id],
) -> Vec<Statement> {
    if statements.len() <= LONGEST {
        return statements;
    }
    let scopes: Vec<&[Statement]> = statements.chunks(LONGEST).collect();
    let last_use = last_uses(schedule, &scopes, kept);
    let scope = |(index, scope): (usize, &&[Statement])| {
        let defined = scope.iter().flat_map(defines);
        let hands_on = defined.filter(|id| last_use.get(id).is_some_and(|&last| last > index));
        Statement::Scope { hands_on: hands_on.collect(), statements: scope.to_vec() }
    };
    scopes.iter().enumerate().map(scope).collect()
}

/// The last scope in which each local is read.
fn last_uses(schedule: &Schedule<'_>, scopes: &[&[Statement]], kept: &[Id]) -> Map<Id, usize> {
    let mut last = Map::default();
    for (index, scope) in scopes.iter().enumerate() {
        for id in scope.iter().flat_map(|statement| schedule.uses(statement)) {
            last.insert(id, index);
        }
    }
    last.extend(kept.iter().map(|&id| (id, usize::MAX)));
    last
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::graph::{Graph, Node};
    use crate::ir::liveness::Path;
    use crate::lower::routine::Locals;

    /// The scopes of v1, v2, …, each the sum of its predecessor and of v1, of which some are kept.
    fn scopes(length: u32, kept: &[u32]) -> Vec<(usize, Vec<u32>)> {
        let mut graph = Graph::new();
        let mut last = graph.push(Node::Mode(0));
        let first = last;
        for _ in 1..length {
            last = graph.push(Node::Add(last, first));
        }
        let locals = Locals::default();
        let mut schedule = Schedule::new(&graph, &locals, Path::Slow, None, &[]);
        let statements = schedule.stage(&[last]);
        let kept: Vec<Id> = kept.iter().map(|&id| Id(id)).collect();
        let laid_out = lay_out(&schedule, statements, &kept);
        laid_out
            .into_iter()
            .filter_map(|statement| match statement {
                Statement::Scope { statements, hands_on } => {
                    Some((statements.len(), hands_on.iter().map(|id| id.0).collect()))
                }
                _ => None,
            })
            .collect()
    }

    #[test]
    fn a_short_routine_stays_in_one_piece() {
        assert_eq!(scopes(64, &[63]), []);
    }

    #[test]
    fn a_scope_hands_on_what_later_scopes_and_the_result_use() {
        let expected = [(64, vec![0, 5, 63]), (64, vec![127]), (2, vec![129])];
        assert_eq!(scopes(130, &[5, 129]), expected);
    }
}
