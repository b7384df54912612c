//! What the solver offers: which functions, what each is given, what it returns, and what every
//! number in that is called.
//!
//! It is known before any formula is, and said once: the equations fill it in, and the generated
//! code, its documentation and the C header read it. Nothing here computes and nothing prints.

mod catalogue;
pub(crate) mod entries;
pub(crate) mod forces;
pub(crate) mod labels;
pub(crate) mod quantity;
pub(crate) mod records;
pub(crate) mod units_in_words;

use crate::interface::catalogue::Records;
use crate::interface::entries::Entry;
use crate::interface::quantity::Quantity;
use crate::interface::records::{Record, RecordId, Shape};
use crate::model::mechanism::Mechanism;

/// See the module's documentation.
pub(crate) struct Interface {
    pub records: Vec<Record>,
    pub entries: Vec<Entry>,
    /// The record of several inputs, if there are several.
    pub inputs: Option<RecordId>,
    /// The record of several loads, if there are several.
    pub loads: Option<RecordId>,
    /// The number of scalar rows of the outputs.
    pub rows: usize,
    /// The number of inputs.
    pub columns: usize,
}

/// An index into [`Interface::entries`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EntryId(usize);

impl Interface {
    /// Everything that a solver of the mechanism could offer.
    pub(crate) fn of(mechanism: &Mechanism) -> Self {
        let rows = mechanism.outputs.iter().map(|output| Quantity::of(&output.kind).rows().len());
        let (rows, columns) = (rows.sum(), mechanism.inputs.len());
        let Records {
            list: records,
            input: inputs,
            orders,
            motion,
            margins,
            loads,
            forces,
            energy,
            equations,
        } = Records::of(mechanism);
        let mut entries = entries::all(rows, columns, orders, motion, margins);
        let has_loads = !mechanism.dynamics.loads.is_empty();
        if let Some(forces) = forces {
            entries.extend(entries::of_forces(columns, has_loads, forces));
        }
        if let Some(energy) = energy {
            entries.extend(entries::of_energy(columns, energy));
        }
        if let Some(equations) = equations {
            entries.extend(entries::of_dynamics(columns, has_loads, equations));
        }
        Self { records, entries, inputs, loads, rows, columns }
    }

    /// The same with these entry points alone, in this order.
    pub(crate) fn limited_to<'n>(mut self, names: impl Iterator<Item = &'n str>) -> Self {
        let known = self.entries;
        let entry = |name: &str| known.iter().find(|entry| entry.name == name).cloned();
        self.entries = names.filter_map(entry).collect();
        self
    }

    /// The entry point that gives the same from the only input's cosine and sine.
    pub(crate) fn of_cosine(&self, own: &Entry) -> Option<EntryId> {
        self.ids().find(|&other| {
            let other = self.entry(other);
            let is_same = other.result == own.result && other.rates() == own.rates();
            is_same && other.takes_cosine() && !own.takes_cosine()
        })
    }

    pub(crate) fn entry(&self, id: EntryId) -> &Entry {
        &self.entries[id.0]
    }

    pub(crate) fn ids(&self) -> impl Iterator<Item = EntryId> + use<> {
        (0..self.entries.len()).map(EntryId)
    }

    /// The entry point of this name, if it is offered.
    pub(crate) fn find(&self, name: &str) -> Option<EntryId> {
        self.entries.iter().position(|entry| entry.name == name).map(EntryId)
    }

    pub(crate) fn record_ids(&self) -> impl Iterator<Item = RecordId> + use<> {
        RecordId::first(self.records.len())
    }

    pub(crate) fn record(&self, id: RecordId) -> &Record {
        &self.records[id.index()]
    }

    /// How many numbers a result of this shape has.
    pub(crate) fn numbers(&self, shape: Shape) -> usize {
        match shape {
            Shape::Number => 1,
            Shape::List(count) => count,
            Shape::Quantity(quantity, order) => quantity.layout(order).parts.len(),
            Shape::Matrix { rows, columns } => rows * columns,
            Shape::Record(id) => {
                self.record(id).fields.iter().map(|field| self.numbers(field.shape)).sum()
            }
        }
    }
}

impl EntryId {
    pub(crate) fn index(self) -> usize {
        self.0
    }
}
