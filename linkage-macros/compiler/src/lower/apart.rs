//! Equations that stand apart: one side is made of constants, parameters and the unknown, the other of what
//! no trial changes. From one pose of a sweep to the next the first of them stays what it is at every trial.

use super::routine::{Apart, Search};
use super::unique_root;
use crate::ir::graph::{Graph, Id, Node, Target};
use crate::ir::liveness::trial_nodes;

/// Form of a search whose equation stands apart; none for any other search. A declared seed asks for
/// another search, and ends that are parameters may be more than a turn apart.
pub(super) fn apart(graph: &Graph, tried: &[bool], search: &Search) -> Option<Apart> {
    let sought = search.sought;
    let [left, right, slope] = sought.sides;
    let are_constant = sought.between.into_iter().all(|end| graph.as_constant(end).is_some());
    if sought.wanted != Target::Root || sought.near.is_some() || !are_constant {
        return None;
    }
    let (given, side) = match [left, right].map(|side| tried[side.index()]) {
        [true, false] => (1, left),
        [false, true] => (0, right),
        _ => return None,
    };
    let moves = moves(graph);
    let of_trial = trial_nodes(graph, tried, &[side, slope]);
    if [side, slope]
        .into_iter()
        .chain(of_trial.iter().map(|&(id, _)| id))
        .any(|id| moves[id.index()])
    {
        return None;
    }
    let is_proved = search.has_one_root == Some(true);
    let has_one_root = is_proved && unique_root::is_steady(graph, sought.between, side, slope);
    Some(Apart { given, has_one_root })
}

/// For every node, whether its value may be another one at the next pose, for the same trial.
fn moves(graph: &Graph) -> Vec<bool> {
    let mut moves = vec![false; graph.len()];
    for (id, node) in graph.iter() {
        moves[id.index()] = match node {
            Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Load(_)
            | Node::Drive(_)
            | Node::Solved(..) => true,
            node => {
                let mut moved = false;
                node.for_operands(&mut |operand: Id| moved |= moves[operand.index()]);
                moved
            }
        };
    }
    moves
}
