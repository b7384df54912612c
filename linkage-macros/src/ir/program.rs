//! What the equations make of a mechanism: one graph and the values each entry point asks of it.

use crate::ir::graph::{Graph, Id};

#[derive(Clone, Debug)]
pub(crate) struct Program {
    pub graph: Graph,
    pub entries: Vec<Entry>,
    /// The titles of the groups, by the numbers that guards carry.
    pub groups: Vec<String>,
}

impl Program {
    /// The sinks of all entries.
    pub(crate) fn sinks(&self) -> Vec<Id> {
        self.entries.iter().flat_map(|entry| &entry.sinks).copied().collect()
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
