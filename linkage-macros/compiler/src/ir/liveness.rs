//! Nodes to be computed for a set of sinks.

use crate::ir::graph::{Graph, Id, Node};
pub use crate::ir::node::Path;

/// For every node of the graph, whether one of the sinks needs it.
pub fn live(graph: &Graph, sinks: &[Id], path: Path) -> Vec<bool> {
    let mut live = vec![false; graph.len()];
    sinks.iter().for_each(|sink| live[sink.index()] = true);
    spread(graph, &mut live, path);
    live
}

/// Marks what the nodes that are live need.
pub(super) fn spread(graph: &Graph, live: &mut [bool], path: Path) {
    // Operands stand before their users, so one walk from back to front is enough.
    let nodes = graph.nodes();
    let mut index = nodes.len();
    while index > 0 {
        index -= 1;
        if !live[index] {
            continue;
        }
        let node = nodes[index];
        graph.for_operands(node, path, &mut |operand| live[operand.0 as usize] = true);
    }
}

/// The live nodes in the order of the graph, operands before users.
pub fn live_nodes<'a>(graph: &'a Graph, live: &'a [bool]) -> impl Iterator<Item = (Id, Node)> + 'a {
    graph.iter().filter(|(id, _)| live[id.0 as usize])
}

/// For every node, whether its value depends on a trial: it is computed inside a search alone.
pub fn tried(graph: &Graph) -> Vec<bool> {
    let mut tried = vec![false; graph.len()];
    // Most mechanisms search nothing.
    if !graph.has_trials() {
        return tried;
    }
    for (id, node) in graph.iter() {
        let mut depends = matches!(node, Node::Trial(_));
        if !matches!(node, Node::Solved(..)) {
            graph.for_operands(node, Path::Slow, &mut |operand| depends |= tried[operand.index()]);
        }
        tried[id.index()] = depends;
    }
    tried
}

/// Nodes that a trial computes for the sides of an equation, operands before users. Nodes that no trial
/// changes, another root included, are not followed.
pub fn trial_nodes(graph: &Graph, tried: &[bool], sides: &[Id]) -> Vec<(Id, Node)> {
    let mut needed = vec![false; graph.len()];
    sides.iter().for_each(|side| needed[side.index()] = true);
    for index in (0..graph.len()).rev() {
        if needed[index] && tried[index] {
            graph.node(Id(index as u32)).for_operands(&mut |id| needed[id.index()] = true);
        }
    }
    graph.iter().filter(|(id, _)| needed[id.index()] && tried[id.index()]).collect()
}

/// The node itself, or the value that it stands on: nothing is computed in between in the fast path.
pub fn unguarded(graph: &Graph, mut id: Id) -> Id {
    while let Some(value) = graph.beneath(id) {
        id = value;
    }
    id
}
