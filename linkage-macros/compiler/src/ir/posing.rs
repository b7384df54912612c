//! The numbers of one pose, computed without generated code: the program by which a mechanism is drawn, in `f64`, under
//! the conditions of its slow path. What a condition asks, and how a root is found, is the run-time's.

use crate::ir::graph::{Id, ImplicitId, Node, RootSearch, Target};
use crate::ir::hash::Map;
use crate::ir::implicit::Implicit;
use crate::ir::interpret::{ProgramValues, value};
use crate::ir::liveness::{trial_nodes, tried};
use crate::ir::program::{Liveness, Program};

/// A condition on a value.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct GuardedValue<'a> {
    /// The name of its type in the run-time crate.
    pub kind: &'a str,
    /// The title of the group whose failure it is.
    pub group: &'a str,
    /// The name of a length, or the unit of an equation; empty for other conditions.
    pub word: &'a str,
    /// The value under the condition.
    pub value: f64,
    /// The numbers that decide where rounding could.
    pub operands: &'a [f64],
}

/// A root that is searched for.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct SoughtRoot<'a> {
    /// The title of the unknown.
    pub unknown: &'a str,
    /// The unit of its equation.
    pub unit: &'a str,
    /// The ends of its interval.
    pub between: [f64; 2],
    /// True if the equation rises through its root.
    pub rises: bool,
    /// The value near which the root is expected.
    pub near: Option<f64>,
    /// True if the ends are angles whose distance, at most a turn, is known here alone.
    pub checks_span_at_run_time: bool,
}

/// The run-time's part of a pose.
pub trait Conditions {
    /// The value under a condition, or its replacement at a limit.
    fn guard(&mut self, condition: &GuardedValue<'_>) -> f64;

    /// Told the difference of an equation's sides in the final pose, the value of the condition, and the size of
    /// these sides, its operand.
    fn closed(&mut self, condition: &GuardedValue<'_>);

    /// The root, and the size that its rounding is measured by. `sides` gives left, right, and the slope of their
    /// difference.
    fn root(&mut self, sought: &SoughtRoot<'_>, sides: &mut dyn FnMut(f64) -> [f64; 3])
    -> [f64; 2];

    /// An end of the stretch on which the equation has its trend, and one at a dead point. `sides` gives the
    /// difference, its slope, and its curvature.
    fn bound(
        &mut self,
        sought: &SoughtRoot<'_>,
        end: usize,
        sides: &mut dyn FnMut(f64) -> [f64; 3],
    ) -> [f64; 2];
}

/// The words for an unknown: its title, the unit of its equation, and whether its ends are asked for a turn.
pub(crate) struct UnknownWords {
    pub title: String,
    pub unit: String,
    pub checks_span_at_run_time: bool,
}

/// The nodes that the first answer of a program needs: found once for any poses.
pub(crate) struct Placing<'p> {
    program: &'p Program,
    nodes: Vec<(Id, Node)>,
    tried: Vec<bool>,
}

impl<'p> Placing<'p> {
    pub(crate) fn new(program: &'p Program) -> Self {
        let graph = &program.graph;
        let live = Liveness::of(program, &program.answers[0].sinks).slow;
        let tried = tried(graph);
        let is_placed = |(id, _): &(Id, Node)| live[id.index()] && !tried[id.index()];
        Self { program, nodes: graph.iter().filter(is_placed).collect(), tried }
    }

    /// The numbers of the answer.
    pub(crate) fn numbers(
        &self,
        given: &ProgramValues<f64>,
        unknowns: &[UnknownWords],
        conditions: &mut dyn Conditions,
    ) -> Vec<f64> {
        let program = self.program;
        let values = vec![0.0; program.graph.len()];
        let mut pose = PoseValues { program, given, unknowns, values, found: Map::default() };
        for &(id, node) in &self.nodes {
            pose.values[id.index()] = pose.number(id, node, &self.tried, conditions);
        }
        program.answers[0].sinks.iter().map(|sink| pose.values[sink.index()]).collect()
    }
}

struct PoseValues<'p> {
    program: &'p Program,
    given: &'p ProgramValues<f64>,
    unknowns: &'p [UnknownWords],
    values: Vec<f64>,
    /// Both numbers of each search.
    found: Map<ImplicitId, [f64; 2]>,
}

impl PoseValues<'_> {
    fn number(
        &mut self,
        id: Id,
        node: Node,
        tried: &[bool],
        conditions: &mut dyn Conditions,
    ) -> f64 {
        match node {
            Node::Solved(solve, output, _) => {
                let Implicit::Root(sought) = self.program.graph.implicit(solve) else {
                    unreachable!("no place depends on friction")
                };
                if !self.found.contains(&solve) {
                    let found = self.search(sought, tried, conditions);
                    self.found.insert(solve, found);
                }
                self.found[&solve][output as usize]
            }
            Node::Guard(..) => self.guard(id, node, conditions),
            _ => value(self.program, self.given, &self.values, node, None),
        }
    }

    fn guard(&self, id: Id, node: Node, conditions: &mut dyn Conditions) -> f64 {
        let Node::Guard(under, guard) = node else { unreachable!("{id:?} is a guard") };
        let guard = self.program.graph.condition(guard);
        let at = |id: &Id| self.values[id.index()];
        let operands: Vec<f64> = guard.operands.iter().map(at).collect();
        let condition = GuardedValue {
            kind: guard.check.row().diagnosis,
            group: &self.program.groups[guard.group as usize],
            word: guard.check.word().unwrap_or_default(),
            value: at(&under),
            operands: &operands,
        };
        if guard.check.is_of_both_paths() {
            conditions.closed(&condition);
            return condition.value;
        }
        conditions.guard(&condition)
    }

    fn search(
        &mut self,
        search: &RootSearch,
        tried: &[bool],
        conditions: &mut dyn Conditions,
    ) -> [f64; 2] {
        let words = &self.unknowns[search.unknown as usize];
        let by_mode =
            || search.trend.param().map_or(0.0, |param| self.given.params[param as usize]);
        let rises = search.trend.sign().unwrap_or_else(by_mode) > 0.0;
        let sought = SoughtRoot {
            unknown: &words.title,
            unit: &words.unit,
            between: search.between.map(|end| self.values[end.index()]),
            rises,
            near: search.near.map(|near| self.values[near.index()]),
            checks_span_at_run_time: words.checks_span_at_run_time,
        };
        let nodes = trial_nodes(&self.program.graph, tried, &search.sides);
        let (program, given, values) = (self.program, self.given, &mut self.values);
        let mut sides = |trial: f64| {
            for &(id, node) in &nodes {
                values[id.index()] = value(program, given, values, node, Some(&trial));
            }
            search.sides.map(|side| values[side.index()])
        };
        match search.wanted {
            Target::Root => conditions.root(&sought, &mut sides),
            Target::End(end) => conditions.bound(&sought, end.into(), &mut sides),
        }
    }
}
