//! Every value of a program with any kind of number: the oracle for everything that rewrites programs.

mod amounts;

use super::{ProgramValues, Searched, value};
use crate::exact::Exact;
use crate::ir::graph::{Graph, Id, Node, RootSearch, Target};
use crate::ir::implicit::Contacts;
use crate::ir::liveness::{trial_nodes, tried};
use crate::ir::program::Program;

/// The value of every node.
pub(crate) fn interpret<N: Searched>(program: &Program, given: &ProgramValues<N>) -> Vec<N> {
    let graph = &program.graph;
    let tried = tried(graph);
    let mut values: Vec<N> = Vec::with_capacity(graph.len());
    let mut last = None;
    for (id, node) in graph.iter() {
        let value = match node {
            // Nodes that depend on a trial are computed inside the search.
            _ if tried[id.index()] => N::exact(&Exact::integer(0)),
            Node::Solved(solve, output, on) => match graph.implicit(solve).contacts() {
                None => match graph.search(id) {
                    Some((_, sought)) => root(program, given, &tried, &mut values, &sought),
                    // The size of a root.
                    None => N::exact(&Exact::integer(1)),
                },
                Some(contacts) => {
                    // The numbers of one system follow each other, and are solved once.
                    if last.as_ref().is_none_or(|(known, _)| *known != solve) {
                        let operands = contacts.equations.iter().map(|id| &values[id.index()]);
                        let operands: Vec<_> = operands.collect();
                        last = Some((solve, amounts::all(contacts, &operands).ok()));
                    }
                    let all = last.as_ref().and_then(|(_, all)| all.as_ref());
                    let found = all.map(|all| &all[output as usize]);
                    let on = on.map(|on| &values[on.index()]);
                    found.or(on).expect("an amount stands on a value").clone()
                }
            },
            _ => value(program, given, &values, node, None),
        };
        values.push(value);
    }
    values
}

/// The joint at which friction may hold itself in a pose, if there is one.
pub(crate) fn jams<N: Searched>(graph: &Graph, values: &[N]) -> Option<String> {
    graph.iter().find_map(|(_, node)| {
        let Node::Solved(solve, ..) = node else { return None };
        let contacts = graph.implicit(solve).contacts()?;
        let operands: Vec<_> = contacts.equations.iter().map(|id| &values[id.index()]).collect();
        amounts::all(contacts, &operands).err().map(|at| contacts.joints[at].0.clone())
    })
}

/// The amounts of friction by their equations, given the values of the rows and where steps begin.
pub(crate) fn amounts<N: Searched>(contacts: &Contacts, operands: &[&N]) -> Option<Vec<N>> {
    amounts::all(contacts, operands).ok()
}

/// Newton's method from where the root is expected, or from the middle: declarations of tests are
/// such that it converges.
fn root<N: Searched>(
    program: &Program,
    given: &ProgramValues<N>,
    tried: &[bool],
    values: &mut [N],
    sought: &RootSearch,
) -> N {
    let half = N::exact(&Exact::float(0.5).expect("finite"));
    let [from, to] = sought.between.map(|end| values[end.index()].clone());
    // As far as rewriting goes, the end of the interval is as good a place as a dead point.
    match sought.wanted {
        Target::End(0) => return from,
        Target::End(_) => return to,
        Target::Root => {}
    }
    let middle = from.add(&to).mul(&half);
    let mut trial = sought.near.map_or(middle, |near| values[near.index()].clone()).point();
    let nodes = trial_nodes(&program.graph, tried, &sought.sides);
    if sought.near.is_none() {
        trial = halved(program, given, values, sought, &nodes);
    }
    for _ in 0..STEPS {
        for &(id, node) in &nodes {
            values[id.index()] = value(program, given, values, node, Some(&trial));
        }
        let [left, right, slope] = sought.sides.map(|side| values[side.index()].clone());
        trial = trial.sub(&left.sub(&right).div(&slope)).point();
    }
    trial
}

/// The middle of a small interval around the root, at whose ends the equation changes its sign.
fn halved<N: Searched>(
    program: &Program,
    given: &ProgramValues<N>,
    values: &mut [N],
    sought: &RootSearch,
    nodes: &[(Id, Node)],
) -> N {
    let half = N::exact(&Exact::float(0.5).expect("finite"));
    let [mut from, mut to] = sought.between.map(|end| values[end.index()].point());
    let mut is_above = |trial: &N| {
        for &(id, node) in nodes {
            values[id.index()] = value(program, given, values, node, Some(trial));
        }
        values[sought.sides[0].index()].is_at_least(&values[sought.sides[1].index()])
    };
    if is_above(&from) == is_above(&to) {
        // Between them is a dead point with a root on each side: the ends are those of the first part that holds the root of
        // the trend.
        let rises = sought.trend.sign().map(|sign| sign > 0.0);
        let width = to.sub(&from).div(&N::exact(&Exact::integer(PARTS)));
        let mut low = from.clone();
        for _ in 0..PARTS {
            let high = low.add(&width).point();
            let [before, behind] = [&low, &high].map(&mut is_above);
            if before != behind && rises.is_none_or(|rises| rises == behind) {
                (from, to) = (low, high);
                break;
            }
            low = high;
        }
    }
    let first = is_above(&from);
    for _ in 0..HALVINGS {
        let middle = from.add(&to).mul(&half).point();
        if is_above(&middle) == first {
            from = middle;
        } else {
            to = middle;
        }
    }
    from.add(&to).mul(&half).point()
}

/// The parts of an interval in which one of two roots is looked for.
const PARTS: i64 = 32;

/// Enough for Newton's method to converge.
const HALVINGS: usize = 16;

/// More than Newton's method takes to a hundred digits from the first.
const STEPS: usize = 14;
