//! Makes nodes under rules: a rule may replace a node that is about to be made.
//!
//! The same rules serve while the equations are written down and when a whole program is rebuilt,
//! so a rule is written and tested once.

use crate::exact::Exact;
use crate::ir::graph::{Graph, Guard, Id, Node};
use crate::ir::hash::Map;
use crate::ir::liveness::{Path, live, live_nodes};
use crate::ir::program::{Clearance, Closure, Program};

/// Looks at a node that is about to be made and answers with what stands for it, if anything
/// simpler does.
pub type Rule = fn(&mut Maker<'_>, Node) -> Option<Id>;

/// A graph under construction and the rules that hold in it.
pub struct Maker<'g> {
    pub graph: &'g mut Graph,
    pub rules: &'g [Rule],
}

impl Maker<'_> {
    /// The node, or what the rules put in its place.
    pub fn make(&mut self, node: Node) -> Id {
        for rule in self.rules {
            if let Some(id) = rule(self, node) {
                return id;
            }
        }
        self.graph.push(node)
    }

    /// The value under the guard, or what the rules put in its place.
    pub(crate) fn make_guarded(&mut self, value: Id, guard: Guard) -> Id {
        let guard = self.graph.intern_guard(guard);
        self.make(Node::Guard(value, guard))
    }

    /// A node of this graph on the operands that stand for its own; itself where all stand for themselves.
    pub(crate) fn remake(&mut self, id: Id, node: Node, to: &dyn Fn(Id) -> Id) -> Id {
        let mut is_touched = false;
        let touches = &mut |operand| is_touched |= to(operand) != operand;
        self.graph.for_operands(node, Path::Slow, touches);
        match node {
            // An unknown is searched once for all answers.
            _ if !is_touched || self.graph.search(id).is_some() => id,
            Node::Guard(value, guard) => {
                let guard = self.graph.condition(guard).on(&to);
                self.make_guarded(to(value), guard)
            }
            Node::Solved(solve, output, on) => {
                let solve = self.graph.implicit(solve).on(&to);
                let solve = self.graph.intern_implicit(solve);
                self.make(Node::Solved(solve, output, on.map(to)))
            }
            other => self.make(other.map_operands(&mut |operand| to(operand))),
        }
    }

    pub(crate) fn constant(&mut self, value: Exact) -> Id {
        self.graph.constant(value)
    }
}

/// The program made anew under the rules; what no entry needs is left behind.
pub fn rebuild(program: &Program, rules: &[Rule]) -> Program {
    rebuild_with(program, rules, |_, _, _| None)
}

/// The program made anew. The replacement is asked for every old node first and answers with a
/// node on moved operands, or leaves the node as it is.
pub(crate) fn rebuild_with(
    program: &Program,
    rules: &[Rule],
    mut replacement: impl FnMut(&mut Maker<'_>, Id, &Moved) -> Option<Id>,
) -> Program {
    let old = &program.graph;
    let live = live(old, &program.sinks(), Path::Slow);
    let mut graph = Graph::with_room(old.len());
    let mut maker = Maker { graph: &mut graph, rules };
    let mut moved = Moved(vec![None; old.len()]);
    for (id, node) in old.iter().filter(|(id, _)| live[id.index()]) {
        let new = match replacement(&mut maker, id, &moved) {
            Some(new) => new,
            None => {
                let node = move_node(old, &mut maker, node, &moved);
                maker.make(node)
            }
        };
        if let Some(name) = old.name_of(id) {
            maker.graph.name(new, name.clone());
        }
        moved.0[id.index()] = Some(new);
    }
    let (mut answers, mut clearances) = (program.answers.clone(), program.clearances.clone());
    let of_answers = answers.iter_mut().flat_map(|answer| &mut answer.sinks);
    let of_clearances = clearances.iter_mut().flat_map(Clearance::sinks_mut);
    for sink in of_answers.chain(of_clearances) {
        *sink = moved.of(*sink);
    }
    let moved_closure = |closure: &Closure| Closure {
        root: moved.of(closure.root),
        condition: moved.of(closure.condition),
    };
    let closures = program.closures.iter().map(moved_closure).collect();
    Program { graph, answers, clearances, closures, groups: program.groups.clone() }
}

/// Remakes the nodes that these sinks need, at the end of the graph; earlier nodes stay in place. The
/// replacement is called for every node first, operands before users, and told where earlier ones are now.
pub(crate) fn remade(
    graph: &mut Graph,
    sinks: &[Id],
    rules: &[Rule],
    mut replacement: impl FnMut(&mut Maker<'_>, Id, &dyn Fn(Id) -> Id) -> Option<Id>,
) -> Vec<Id> {
    let nodes: Vec<(Id, Node)> = live_nodes(graph, &live(graph, sinks, Path::Slow)).collect();
    let (mut maker, mut moved) = (Maker { graph, rules }, Map::default());
    for (id, node) in nodes {
        let to = |id: Id| moved.get(&id).copied().unwrap_or(id);
        let new = replacement(&mut maker, id, &to);
        let new = new.unwrap_or_else(|| maker.remake(id, node, &to));
        if new != id {
            moved.insert(id, new);
        }
    }
    sinks.iter().map(|sink| moved.get(sink).copied().unwrap_or(*sink)).collect()
}

/// Where the nodes of the old program are in the new one.
pub(crate) struct Moved(Vec<Option<Id>>);

impl Moved {
    pub(crate) fn of(&self, old: Id) -> Id {
        self.0[old.index()].expect("operands come first")
    }
}

fn move_node(old: &Graph, maker: &mut Maker<'_>, node: Node, moved: &Moved) -> Node {
    match node {
        Node::Constant(constant) => Node::Constant(maker.graph.intern_from(old, constant)),
        Node::Low(constant) => Node::Low(maker.graph.intern_from(old, constant)),
        Node::Guard(value, guard) => {
            let guard = old.condition(guard).on(&|id| moved.of(id));
            Node::Guard(moved.of(value), maker.graph.intern_guard(guard))
        }
        Node::Solved(solve, output, on) => {
            let solve = old.implicit(solve).on(&|id| moved.of(id));
            Node::Solved(maker.graph.intern_implicit(solve), output, on.map(|on| moved.of(on)))
        }
        other => other.map_operands(&mut |id| moved.of(id)),
    }
}
