//! The interface of the solver: its functions, their arguments, their results, and the name of every number
//! in a result.
//!
//! It is known before any formula is, and said once: the equations fill it in, and the generated
//! code, its documentation and the C header read it. Nothing here computes and nothing prints.

pub(crate) mod carried_over;
mod catalogue;
pub mod components;
pub mod dimensions;
pub mod entries;
pub(crate) mod force_records;
pub mod labels;
pub mod quantity;
pub mod records;
pub mod units_in_words;

use proc_macro2::Ident;

use crate::interface::entries::{Analysis, Entry, EntryPoint, EntryRow, Returns, Topic};
use crate::interface::quantity::Quantity;
use crate::interface::records::{Record, RecordId, RecordKind, Shape};
use crate::model::mechanism::Mechanism;

/// See the module's documentation.
pub struct Interface {
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
pub struct EntryId(usize);

impl Interface {
    /// Everything that a solver of the mechanism could offer.
    pub fn of(mechanism: &Mechanism) -> Self {
        let rows = mechanism.outputs.iter().map(|output| Quantity::of(&output.kind).rows().len());
        let (rows, columns) = (rows.sum(), mechanism.inputs.len());
        let records = catalogue::records(mechanism);
        let of_kind =
            |kind| records.iter().position(|record| record.kind == kind).map(RecordId::of);
        let (inputs, loads) = (of_kind(RecordKind::Inputs), of_kind(RecordKind::Loads));
        let has_mass = !mechanism.dynamics.masses.is_empty();
        let result = |row: &EntryRow| match row.returns {
            _ if row.topic == Topic::Dynamics && !has_mass => None,
            Returns::Record(kind) => of_kind(kind).map(Shape::Record),
            Returns::Matrix => Some(Shape::Matrix { rows, columns }),
            Returns::OfInputs(_) if columns == 1 => Some(Shape::Number),
            Returns::OfInputs(_) => Some(Shape::List(columns)),
            Returns::Band => {
                (columns == 1 && !mechanism.dynamics.frictions.is_empty()).then_some(Shape::List(2))
            }
        };
        let has = [!mechanism.dynamics.loads.is_empty(), !mechanism.dynamics.frictions.is_empty()];
        let entries = entries::all(columns, has, result);
        Self { records, entries, inputs, loads, rows, columns }
    }

    /// The same with these entry points alone, in this order.
    pub fn limited_to(mut self, points: impl Iterator<Item = EntryPoint>) -> Self {
        let known = self.entries;
        let entry = |point| known.iter().find(|entry| entry.point == point).cloned();
        self.entries = points.filter_map(entry).collect();
        self
    }

    /// The entry point that gives the same from the only input's cosine and sine.
    pub(crate) fn of_cosine(&self, own: &Entry) -> Option<EntryId> {
        let other = self.find(EntryPoint { by_cosine: true, ..own.point });
        other.filter(|_| !own.takes_cosine())
    }

    pub fn entry(&self, id: EntryId) -> &Entry {
        &self.entries[id.0]
    }

    pub(crate) fn ids(&self) -> impl Iterator<Item = EntryId> + use<> {
        (0..self.entries.len()).map(EntryId)
    }

    /// An entry point, if it is offered.
    pub fn find(&self, point: EntryPoint) -> Option<EntryId> {
        self.entries.iter().position(|entry| entry.point == point).map(EntryId)
    }

    /// True if an analysis is offered at given inputs.
    pub(crate) fn has(&self, analysis: Analysis) -> bool {
        self.find(analysis.by_value()).is_some()
    }

    /// True unless only analyses return the record that are not offered: margins may be outputs without an entry
    /// point, and masses may be such that there are no dynamics. The stages are always offered.
    pub fn is_used(&self, record: &Record) -> bool {
        // Forces of one link are a field of all forces.
        let kind = match record.kind {
            RecordKind::ForcesOf(_) => RecordKind::Forces,
            kind => kind,
        };
        let returns_it =
            |row: &EntryRow| matches!(row.returns, Returns::Record(returned) if returned == kind);
        let is_offered = |analysis: Analysis| {
            let is_of_dynamics = analysis.row().topic == Topic::Dynamics;
            Analysis::STAGES.contains(&analysis)
                || self.entries.iter().any(|entry| {
                    entry.point.analysis == analysis
                        || is_of_dynamics && entry.point.is_about_dynamics()
                })
        };
        let mut returning = Analysis::all().filter(|of| returns_it(of.row())).peekable();
        returning.peek().is_none() || returning.any(is_offered)
    }

    pub(crate) fn record_ids(&self) -> impl Iterator<Item = RecordId> + use<> {
        (0..self.records.len()).map(RecordId::of)
    }

    pub(crate) fn record(&self, id: RecordId) -> &Record {
        &self.records[id.index()]
    }

    /// The name of the record of several inputs.
    pub(crate) fn input_record(&self) -> Option<&Ident> {
        self.inputs.map(|id| &self.record(id).name)
    }

    /// The name of the record of several loads.
    pub(crate) fn load_record(&self) -> Option<&Ident> {
        self.loads.map(|id| &self.record(id).name)
    }

    /// The count of numbers in a result of this shape.
    pub fn numbers(&self, shape: Shape) -> usize {
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
    pub fn index(self) -> usize {
        self.0
    }
}
