//! Equal conditions of two groups: asked once, and by the first.

use super::rules::{nested, x, y};
use crate::function::Function;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Check, Graph, Guard, Id, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::ir::program::{EntryOutputs, Program};
pub(crate) use linkage_compiler::passes::conditions::*;

fn provided(g: &mut Graph, value: Id, check: Check, group: u32, operands: Vec<Id>) -> Id {
    g.guard(value, Guard { check, group, operands })
}

/// The conditions that the entry's answer stands under after the pass, by group, and the answer without them.
fn asked(entry: &'static str, build: impl FnOnce(&mut Graph) -> Id) -> (Vec<u32>, String) {
    let mut graph = Graph::new();
    let sinks = vec![build(&mut graph)];
    let answers = vec![EntryOutputs { entry: Some(EntryPoint::named(entry)), sinks }];
    let groups = vec!["AB".into(), "CD".into()];
    let program = Program { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups };
    let after = ask_once(&program);
    let sinks = &after.answers[0].sinks;
    let live = live(&after.graph, sinks, Path::Slow);
    let guards = live_nodes(&after.graph, &live).filter_map(|(_, node)| match node {
        Node::Guard(_, guard) => Some(after.graph.condition(guard).group),
        _ => None,
    });
    (guards.collect(), nested(&after.graph, sinks[0]))
}

/// b/√a of group 0 and the same of group 1, each under a second condition that stands on the first.
fn two_assemblies(g: &mut Graph) -> Id {
    let (a, b) = (x(g), y(g));
    let roots = [0, 1].map(|group| {
        let square = provided(g, a, Check::ReachOffset, group, vec![b]);
        let root = g.push(Node::Apply(Function::Sqrt, square));
        let root = provided(g, root, Check::Nonzero, group, vec![]);
        g.push(Node::Div(b, root))
    });
    g.push(Node::Add(roots[0], roots[1]))
}

#[test]
fn two_groups_under_one_condition_share_what_they_make() {
    let (groups, text) = asked("forward_dynamics", two_assemblies);
    assert_eq!((groups, &text[..]), (vec![0, 0], "(y/sqrt(x) + y/sqrt(x))"));
    let (groups, text) = asked("motion", two_assemblies);
    assert_eq!(groups, [0, 0, 1, 1], "{text}");
}

#[test]
fn another_condition_is_asked_for_itself() {
    let (groups, _) = asked("forward_dynamics", |g| {
        let (a, b) = (x(g), y(g));
        let others = [
            (a, Check::Nonzero, vec![]),
            (b, Check::Nonzero, vec![]),
            (a, Check::Square, vec![]),
            (a, Check::ReachOffset, vec![b]),
            (a, Check::ReachOffset, vec![a]),
            (a, Check::Positive("l".into()), vec![]),
            (a, Check::Positive("m".into()), vec![]),
        ];
        others.into_iter().zip(0..).fold(a, |sum, ((value, check, operands), group)| {
            let value = provided(g, value, check, group, operands);
            g.push(Node::Add(sum, value))
        })
    });
    assert_eq!(groups, [0, 1, 2, 3, 4, 5, 6], "none is that of another group");
}

#[test]
fn a_group_that_stands_alone_keeps_its_name() {
    let (groups, _) = asked("forward_dynamics", |g| {
        let (a, b) = (x(g), y(g));
        let aside = provided(g, a, Check::Nonzero, 0, vec![]);
        g.push(Node::Apply(Function::Sqrt, aside));
        let own = provided(g, a, Check::Nonzero, 1, vec![]);
        g.push(Node::Mul(own, b))
    });
    assert_eq!(groups, [1], "AB is asked for nothing here");
}
