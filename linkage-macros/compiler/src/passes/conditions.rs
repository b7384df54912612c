//! Asks a condition once where two groups stand under the same.
//!
//! Two groups on the same joints with the same lengths, the two assemblies of one triangle, have
//! their square, their root and their divisions in common but for the group that a condition names.
//! Where an answer needs both, the first one is asked first and the second has nothing left to
//! find: it is that of the first, and so is what is made under it.
//!
//! In the equations of motion alone: they stand on every group that carries mass.

use super::{RULES, in_dynamics};
use crate::ir::construct::remade;
use crate::ir::graph::{Check, Id, Node};
use crate::ir::hash::Map;
use crate::ir::program::Program;

/// The program with conditions that are equal but for their group made one, in its equations of
/// motion.
pub fn ask_once(program: &Program) -> Program {
    let old = &program.graph;
    in_dynamics(program, |graph, sinks| {
        let mut first: Map<(Id, Check, Vec<Id>), u32> = Map::default();
        remade(graph, sinks, RULES, |maker, id, moved| {
            let Node::Guard(value, guard) = old.node(id) else { return None };
            let (value, mut guard) = (moved(value), old.condition(guard).on(moved));
            let key = (value, guard.check.clone(), guard.operands.clone());
            guard.group = *first.or_insert(key, guard.group);
            Some(maker.make_guarded(value, guard))
        })
    })
}
