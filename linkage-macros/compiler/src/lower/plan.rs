//! Plan of the entry points: some have formulas of their own, some share formulas, and some go by way
//! of another.

use super::routine::ArgumentAdapter;
use crate::interface::entries::{Analysis, EntryPoint};
use crate::interface::{EntryId, Interface};

/// Source of every entry point's numbers.
pub(super) struct Plan {
    /// Formulas that are written down together: of one entry point, or of several, each of which
    /// goes on where the one before it stops.
    pub routines: Vec<Vec<EntryId>>,
    pub strategies: Vec<Strategy>,
}

/// Source of an entry point's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Strategy {
    /// By formulas of its own, as a stage of a routine.
    Own { routine: usize, stage: usize },
    /// By those of another entry point.
    Delegate { entry: EntryId, given: ArgumentAdapter },
}

impl Plan {
    pub(super) fn of(interface: &Interface) -> Self {
        let ids: Vec<EntryId> = interface.ids().collect();
        let vias: Vec<_> = ids.iter().map(|&id| via(interface, id)).collect();
        let mut routines: Vec<Vec<EntryId>> = Vec::new();
        for &id in ids.iter().filter(|id| vias[id.index()].is_none()) {
            match family(interface, id) {
                // The last of a family leads it.
                Some(family) if family[2] == id => routines.push(family.to_vec()),
                Some(_) => {}
                None => routines.push(vec![id]),
            }
        }
        let own = |id: EntryId| {
            routines.iter().enumerate().find_map(|(routine, stages)| {
                let stage = stages.iter().position(|&stage| stage == id)?;
                Some(Strategy::Own { routine, stage })
            })
        };
        let way = |&id: &EntryId| {
            vias[id.index()].or_else(|| own(id)).expect("what goes no way has formulas")
        };
        let strategies = ids.iter().map(way).collect();
        Self { routines, strategies }
    }
}

/// The way by another entry point, if there is one.
fn via(interface: &Interface, id: EntryId) -> Option<Strategy> {
    let own = interface.entry(id);
    let (entry, given) = match own.point.analysis {
        Analysis::Coefficients if interface.columns == 1 => {
            (interface.find(Analysis::Velocity.by_value())?, ArgumentAdapter::UnitRate)
        }
        _ => (interface.of_cosine(own)?, ArgumentAdapter::CosineAndSine),
    };
    Some(Strategy::Delegate { entry, given })
}

/// The entry point whose formulas another one uses, if it has none of its own.
pub(crate) fn stands_on(interface: &Interface, id: EntryId) -> Option<EntryId> {
    match via(interface, id)? {
        Strategy::Delegate { entry, .. } => Some(entry),
        Strategy::Own { .. } => None,
    }
}

/// Position, velocity and motion of one kind of input, of which the entry point is one: what each
/// computes is part of what the next does.
fn family(interface: &Interface, id: EntryId) -> Option<[EntryId; 3]> {
    let by_cosine = interface.entry(id).takes_cosine();
    let find = |analysis| interface.find(EntryPoint { analysis, by_cosine });
    let [position, velocity, motion] = Analysis::STAGES.map(find);
    let family = [position?, velocity?, motion?];
    family.contains(&id).then_some(family)
}
