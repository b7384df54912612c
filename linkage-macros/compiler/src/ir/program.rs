//! Result of the equations: one graph, and the values each entry point requests of it.

use crate::exact::Exact;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Graph, Id};
use crate::ir::liveness::{Path, live, spread};

#[derive(Clone, Debug)]
pub struct Program {
    pub graph: Graph,
    pub answers: Vec<EntryOutputs>,
    /// Clearances for following a motion through changes of mode, group by group in solving order.
    pub clearances: Vec<Clearance>,
    /// Roots, and the condition each stands under: that its equation is closed in the final pose.
    pub closures: Vec<Closure>,
    /// The titles of the groups, by the numbers that guards carry.
    pub groups: Vec<String>,
}

impl Program {
    /// A program in which every number of every result is zero, given how many each has.
    pub fn of_zeros(answers: impl Iterator<Item = (Option<EntryPoint>, usize)>) -> Self {
        let mut graph = Graph::new();
        let zero = graph.constant(Exact::integer(0));
        let answers =
            answers.map(|(entry, count)| EntryOutputs { entry, sinks: vec![zero; count] });
        let answers = answers.collect();
        Self { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups: Vec::new() }
    }

    /// Answer of the entry point with this name, if there is one.
    pub fn answer(&self, entry: &str) -> Option<&EntryOutputs> {
        let point = Some(EntryPoint::named(entry));
        self.answers.iter().find(|answer| answer.entry == point)
    }

    /// The sinks of all entry points and clearances.
    pub fn sinks(&self) -> Vec<Id> {
        let answers = self.answers.iter().flat_map(|answer| &answer.sinks);
        let clearances = self.clearances.iter().flat_map(Clearance::sinks);
        let closures = self.closures.iter().map(|closure| closure.condition);
        answers.copied().chain(clearances).chain(closures).collect()
    }
}

/// A root and its condition.
#[derive(Clone, Copy, Debug)]
pub struct Closure {
    pub root: Id,
    /// A guarded left − right.
    pub condition: Id,
}

/// The nodes that some results need: found once, and handed to all that asks.
pub(crate) struct Liveness {
    /// On the slow path, the conditions of the roots that the results stand on included.
    pub slow: Vec<bool>,
    /// On the fast path, without these conditions.
    pub fast: Vec<bool>,
    /// On the fast path, with them.
    pub counted: Vec<bool>,
}

impl Liveness {
    pub(crate) fn of(Program { graph, closures, .. }: &Program, sinks: &[Id]) -> Self {
        let [mut slow, fast] = [Path::Slow, Path::Fast].map(|path| live(graph, sinks, path));
        let mut counted = fast.clone();
        // A root's equation may stand on earlier roots.
        for Closure { root, condition } in closures.iter().rev() {
            if slow[root.index()] {
                for (live, path) in [(&mut slow, Path::Slow), (&mut counted, Path::Fast)] {
                    live[condition.index()] = true;
                    spread(graph, live, path);
                }
            }
        }
        Self { slow, fast, counted }
    }
}

/// Values that one entry point requests of the graph.
#[derive(Clone, Debug)]
pub struct EntryOutputs {
    /// The entry point; none in the program by which a mechanism is drawn.
    pub entry: Option<EntryPoint>,
    /// The numbers of its result, in the order of the result's shape.
    pub sinks: Vec<Id>,
}

/// Clearance of a group with an assembly mode from its limit.
#[derive(Clone, Debug)]
pub struct Clearance {
    /// An index into [`Program::groups`].
    pub group: u32,
    /// The parameter that holds the mode; none where it is a constant.
    pub param: Option<u32>,
    /// Zero at the limit and negative beyond.
    pub value: Id,
    /// Scale that the value is measured by.
    pub scale: Id,
    /// Rate and acceleration of the value, at constant rates of the inputs: only beside an unknown, whose
    /// ends are no function of the pose. Elsewhere the formulas of the value say enough.
    pub rates: Option<[Id; 2]>,
}

impl Clearance {
    pub(crate) fn sinks(&self) -> impl Iterator<Item = Id> {
        [self.value, self.scale].into_iter().chain(self.rates.into_iter().flatten())
    }

    pub(crate) fn sinks_mut(&mut self) -> impl Iterator<Item = &mut Id> {
        let Self { value, scale, rates, .. } = self;
        [value, scale].into_iter().chain(rates.iter_mut().flatten())
    }
}
