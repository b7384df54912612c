//! What the equations make of a mechanism: one graph and the values each entry point asks of it.

use crate::ir::graph::{Graph, Id};

#[derive(Clone, Debug)]
pub(crate) struct Program {
    pub graph: Graph,
    pub entries: Vec<Entry>,
    /// What following a motion through changes of mode looks at, group by group in solving order.
    pub clearances: Vec<Clearance>,
    /// The titles of the groups, by the numbers that guards carry.
    pub groups: Vec<String>,
}

impl Program {
    /// The sinks of all entries and clearances.
    pub(crate) fn sinks(&self) -> Vec<Id> {
        let entries = self.entries.iter().flat_map(|entry| &entry.sinks);
        let clearances = self.clearances.iter().flat_map(|clearance| &clearance.sinks);
        entries.chain(clearances).copied().collect()
    }
}

/// An entry point of the generated solver.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub kind: EntryKind,
    /// The components of the result, in the order of the outputs and of each output's shape;
    /// `motion`: positions, then velocities, then accelerations; `coefficients`: the velocities
    /// for the first input's unit rate, then for the second's, ….
    pub sinks: Vec<Id>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum EntryKind {
    Position,
    Velocity,
    Motion,
    /// Velocities at unit rates: ∂outputs/∂inputs.
    Coefficients,
    /// The same three with the only input's cosine and sine given.
    PositionAt,
    VelocityAt,
    MotionAt,
    /// Margins and transmission alone, which exist also where the pose does not.
    Margins,
}

/// How clear of its limit a group with an assembly mode is.
#[derive(Clone, Debug)]
pub(crate) struct Clearance {
    /// An index into [`Program::groups`].
    pub group: u32,
    /// The parameter that holds the mode; none where it is a constant.
    pub param: Option<u32>,
    /// Value, rate and second rate, of the inputs' values and constant rates, and the scale to
    /// measure them by.
    pub sinks: [Id; 4],
}
