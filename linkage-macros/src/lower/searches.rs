//! What finds roots: for every root of the program a function of its own, which position, velocity and
//! motion share. It is given what no trial changes, so that a trial computes nothing else.

use super::locals;
use super::routine::{Locals, Routine, Search, Stage, Statement};
use super::schedule::pairs;
use crate::interface::records::Shape;
use crate::ir::cost::operations_of_trial;
use crate::ir::graph::{Graph, Id, Node, Sought};
use crate::ir::liveness::{Path, trial_nodes, tried};
use crate::ir::program::Program;
use crate::model::mechanism::Mechanism;

/// The searches of all roots, by functions whose names begin like this.
pub(super) fn searches(mechanism: &Mechanism, program: &Program, prefix: &str) -> Vec<Search> {
    let roots = program.closures.iter().map(|closure| closure.root);
    let mut searches: Vec<Search> = Vec::new();
    for root in roots {
        let Node::Root(sought) = program.graph.node(root) else { continue };
        let name = mechanism.unknowns[sought.unknown as usize].name.to_string();
        // An unknown is searched in one way for an angle, in another for its cosine and sine.
        let is_known = searches.iter().any(|known| known.sought.unknown == sought.unknown);
        let suffix = if is_known { "_at" } else { "" };
        let name = locals::single_underscores(&format!("{prefix}_{name}{suffix}").to_lowercase());
        searches.push(search(&program.graph, root, sought, name));
    }
    searches
}

fn search(graph: &Graph, root: Id, sought: Sought, name: String) -> Search {
    let (tried, nodes) = (tried(graph), trial_nodes(graph, &sought.sides));
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
    let mut pairs = pairs(of_trial());
    let mut statements = Vec::new();
    for (id, node) in of_trial() {
        statements.extend(match node {
            Node::Trial(_) | Node::Neg(_) => None,
            Node::Sin(angle) | Node::Cos(angle) => pairs.remove(&angle).map(|pair| {
                Statement::SinCos { angle, sin: pair.sin, cos: pair.cos, is_checked: false }
            }),
            _ => Some(Statement::Let(id)),
        });
    }
    let locals = Locals { given: given.iter().copied().collect(), ..Locals::default() };
    let mut locals = locals::with_letters(&locals, graph, &statements);
    let trial = of_trial().find(|(_, node)| matches!(node, Node::Trial(_)));
    if let Some((trial, _)) = trial {
        locals.given.insert(trial);
        locals.names.insert(trial, TRIAL.to_string());
    }
    let routine = Routine {
        name,
        given: &[],
        result: Shape::List(sought.sides.len()),
        path: Path::Unchecked,
        stages: vec![Stage {
            result: Shape::List(sought.sides.len()),
            sinks: sought.sides.to_vec(),
            statements,
        }],
        reads: Vec::new(),
        has_checks: false,
        locals,
    };
    let cost = operations_of_trial(graph, &sought.sides);
    Search { routine, root, sought, given, cost }
}

/// What a trial is called.
pub(crate) const TRIAL: &str = "trial_";
