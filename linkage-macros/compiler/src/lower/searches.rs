//! Searches for roots: one function for every root of the program, which position, velocity and motion
//! share. It is given what no trial changes, so that a trial computes nothing else.

use super::routine::{Instruction, Locals, Routine, Search, Stage};
use super::schedule::{SinCosPair, pairs, take};
use super::{apart, locals, unique_root};
use crate::function::Function;
use crate::interface::records::Shape;
use crate::ir::cost::{Costs, Operations};
use crate::ir::graph::{Graph, Id, ImplicitId, Node, RootSearch, Target};
use crate::ir::hash::Map;
use crate::ir::liveness::{Path, live, trial_nodes};
use crate::ir::program::{Clearance, Program};
use crate::model::mechanism::Mechanism;

/// The searches of all roots, by functions whose names begin like this.
pub(super) fn searches(
    mechanism: &Mechanism,
    program: &Program,
    prefix: &str,
    (tried, costs): (&[bool], &Costs<'_>),
) -> Vec<Search> {
    let roots = program.closures.iter().map(|closure| closure.root);
    let mut searches: Vec<Search> = Vec::new();
    for root in roots.chain(ends(program)) {
        let Some((solve, sought)) = program.graph.search(root) else { continue };
        // Several groups may close by one root.
        if searches.iter().any(|known| known.implicit == solve) {
            continue;
        }
        let unknown = &mechanism.unknowns[sought.unknown as usize];
        let name = unknown.name.to_string();
        // An unknown is searched in one way for an angle, in another for its cosine and sine.
        let of_it = |sought: &RootSearch| (sought.unknown, sought.wanted);
        let is_known = searches.iter().any(|known| of_it(&known.sought) == of_it(&sought));
        let suffix = if is_known { "_at" } else { "" };
        let begin = match sought.wanted {
            Target::Root => prefix,
            Target::End(0) => "lower",
            Target::End(_) => "upper",
        };
        let name = locals::single_underscores(&format!("{begin}_{name}{suffix}").to_lowercase());
        let of_unknown = search(&program.graph, solve, sought, name, tried);
        let are_known = unknown.between.iter().all(|end| end.constant().is_some());
        let checks_span_at_run_time = unknown.dimension.angle && !are_known;
        let cost = costs.of_trial(&sought.sides);
        searches.push(Search { checks_span_at_run_time, cost, ..of_unknown });
    }
    let ends: Vec<RootSearch> = searches.iter().map(|search| search.sought).collect();
    for search in &mut searches {
        let of_it = |end: &&RootSearch| {
            end.unknown == search.sought.unknown && end.wanted == Target::End(0)
        };
        let end = ends.iter().find(of_it);
        search.has_one_root = end.and_then(|end| has_one_root(&program.graph, end));
        search.apart = apart::apart(&program.graph, tried, search);
    }
    searches
}

/// True if at most one root is proved, for both trends where a parameter chooses; none where more than
/// constants decide.
fn has_one_root(graph: &Graph, end: &RootSearch) -> Option<bool> {
    let of = |rises| unique_root::has_one_root(graph, end, rises);
    end.trend.rises().iter().try_fold(true, |all, &rises| Some(all && of(rises)?))
}

/// The ends of where roots can be, which following a motion looks at.
fn ends(program: &Program) -> impl Iterator<Item = Id> + '_ {
    let sinks: Vec<Id> = program.clearances.iter().flat_map(Clearance::sinks).collect();
    let live = live(&program.graph, &sinks, Path::Unchecked);
    let is_end = |id| {
        let sought = program.graph.search(id).map(|(_, sought)| sought.wanted);
        matches!(sought, Some(Target::End(_)))
    };
    let ids = program.graph.iter().map(|(id, _)| id);
    ids.filter(move |&id| live[id.index()] && is_end(id))
}

fn search(
    graph: &Graph,
    implicit: ImplicitId,
    sought: RootSearch,
    name: String,
    tried: &[bool],
) -> Search {
    let nodes = trial_nodes(graph, tried, &sought.sides);
    let of_trial = || nodes.iter().copied();
    let is_constant = |id: Id| matches!(graph.node(id), Node::Constant(_) | Node::Low(_));
    let mut given: Vec<Id> = Vec::new();
    let mut give = |id: Id| {
        if !tried[id.index()] && !is_constant(id) && !given.contains(&id) {
            given.push(id);
        }
    };
    sought.between.into_iter().chain(sought.near).chain(sought.sides).for_each(&mut give);
    of_trial().for_each(|(_, node)| node.for_operands(&mut give));
    let statements = trial_statements(&nodes);
    let locals = Locals { given: given.iter().copied().collect(), ..Locals::default() };
    let mut locals = locals::with_letters(&locals, graph, &statements);
    let trial = of_trial().find(|(_, node)| matches!(node, Node::Trial(_)));
    if let Some((trial, _)) = trial {
        locals.given.insert(trial);
        locals.names.insert(trial, TRIAL.to_string());
    }
    let routine = Routine {
        name,
        given: Vec::new(),
        result: Shape::List(sought.sides.len()),
        path: Path::Unchecked,
        stages: vec![Stage {
            result: Shape::List(sought.sides.len()),
            sinks: sought.sides.to_vec(),
            statements,
        }],
        tells: false,
        reads: Vec::new(),
        has_checks: false,
        locals,
        constants: Map::default(),
    };
    let (cost, has_one_root) = (Operations::default(), None);
    let (apart, checks_span_at_run_time) = (None, false);
    Search { routine, implicit, sought, given, cost, has_one_root, apart, checks_span_at_run_time }
}

/// The statements of a trial, given the nodes that it computes.
fn trial_statements(nodes: &[(Id, Node)]) -> Vec<Instruction> {
    let mut pairs = pairs(nodes.iter().copied());
    let statement = |&(id, node): &(Id, Node)| match node {
        Node::Trial(_) | Node::Neg(_) => None,
        Node::Apply(Function::Sin | Function::Cos, angle) => {
            let SinCosPair { sin, cos } = take(&mut pairs, angle)?;
            Some(Instruction::SinCos { angle, sin, cos, is_checked: false })
        }
        _ => Some(Instruction::Let(id)),
    };
    nodes.iter().filter_map(statement).collect()
}

/// Name of a trial.
pub(crate) const TRIAL: &str = "trial_";
