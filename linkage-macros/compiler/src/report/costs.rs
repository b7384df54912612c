//! Operations of a call, and what of it is not straight-line.

use syn::ext::IdentExt;

use super::OperationsReport;
use super::comparisons::sinks;
use crate::codegen::{MOST, in_words};
use crate::interface::EntryId;
use crate::ir::graph::Node;
use crate::ir::liveness::{Path, live, live_nodes};
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

pub(super) fn operations(lowered: &Lowered<'_>, id: EntryId) -> OperationsReport {
    let cost = lowered.costs[id.index()];
    let graph = &lowered.program.graph;
    let live = live(graph, sinks(lowered, id), Path::Fast);
    let fused = live_nodes(graph, &live).filter(|(_, node)| matches!(node, Node::Fused(..)));
    OperationsReport {
        additions: cost.additions,
        multiplications: cost.multiplications,
        fused: fused.count() as u32,
        divisions: cost.divisions,
        roots: cost.roots,
        functions: cost.sines,
    }
}

pub(super) fn beside(mechanism: &Mechanism, lowered: &Lowered<'_>, id: EntryId) -> Vec<String> {
    let graph = &lowered.program.graph;
    let live = live(graph, sinks(lowered, id), Path::Fast);
    let solved = |of| {
        let mut nodes = live_nodes(graph, &live);
        nodes.any(|(_, node)| matches!(node, Node::Solved(implicit, ..) if implicit == of))
    };
    let searches = lowered.searches.iter().filter(|search| solved(search.implicit)).map(|search| {
        let name = mechanism.unknowns[search.sought.unknown as usize].name.unraw();
        let [double, single] = MOST;
        format!(
            "a search for `{name}` takes at most {double} evaluations in f64 and {single} in f32, 3 more with a seed, \
             each of {}",
            in_words(search.cost)
        )
    });
    let mut beside: Vec<String> = searches.collect();
    let rubs = live_nodes(graph, &live).any(|(_, node)| match node {
        Node::Solved(implicit, ..) => graph.implicit(implicit).contacts().is_some(),
        _ => false,
    });
    if rubs {
        beside.push(
            "amounts of friction are solved by three steps in a straight line; where these are not shown to be enough, \
             the slow path goes on"
                .to_string(),
        );
    }
    beside
}
