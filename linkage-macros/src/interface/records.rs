//! The records that entry points take and return, and the shapes of results that are made of them.

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::interface::forces;
use crate::interface::quantity::{Order, Quantity};
use crate::model::mechanism::{Mechanism, Output, OutputKind};

/// An index into [`Interface::records`](super::Interface::records).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RecordId(usize);

impl RecordId {
    /// The ids of so many records.
    pub(super) fn first(count: usize) -> impl Iterator<Item = Self> {
        (0..count).map(Self)
    }

    pub(super) fn index(self) -> usize {
        self.0
    }
}

/// What a result or a part of it is, and so the order of the numbers in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    Number,
    /// So many numbers.
    List(usize),
    /// The components of an output.
    Quantity(Quantity, Order),
    /// A row an output, a column an input; its numbers come column by column.
    Matrix {
        rows: usize,
        columns: usize,
    },
    Record(RecordId),
}

/// A struct of the generated code.
#[derive(Debug)]
pub(crate) struct Record {
    pub name: Ident,
    pub kind: Kind,
    pub fields: Vec<Field>,
}

/// What a record is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Several inputs, or their first or second rates.
    Inputs,
    /// Every output at one order.
    Outputs(Order),
    /// The outputs at all orders.
    Motion,
    /// The outputs that exist also where the pose does not.
    Margins,
    /// Several loads.
    Loads,
    /// What is asked about forces, by what it belongs to.
    Forces,
    /// The same of one input or link: an index into the mechanism's asked-for forces, its first.
    ForcesOf(usize),
    Energy,
}

#[derive(Debug)]
pub(crate) struct Field {
    pub name: Ident,
    pub shape: Shape,
    pub subject: Subject,
}

/// What a field holds, for its documentation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    /// An index into the mechanism's inputs.
    Input(usize),
    /// An index into the mechanism's outputs.
    Output(usize, Order),
    /// All outputs.
    Outputs(Order),
    /// An index into the mechanism's loads.
    Load(usize),
    /// An index into the mechanism's asked-for forces.
    Effort(usize),
    /// Those of one input or link, of which this is the first.
    Efforts(usize),
    /// Kinetic or potential.
    Energy(&'static str),
}

/// Whether an output exists also where the pose does not.
pub(crate) fn is_margin(output: &Output) -> bool {
    matches!(output.kind, OutputKind::Margin(_) | OutputKind::Transmission(_))
}

/// The field of a motion that holds the record of one order.
pub(crate) fn field_of_motion(order: Order) -> &'static str {
    match order {
        Order::Position => "position",
        Order::Velocity => "velocity",
        Order::Acceleration => "acceleration",
    }
}

/// All records of a mechanism, in the order in which they are defined.
pub(super) struct Records {
    pub list: Vec<Record>,
    pub input: Option<RecordId>,
    pub orders: [RecordId; 3],
    pub motion: RecordId,
    pub margins: Option<RecordId>,
    pub loads: Option<RecordId>,
    pub forces: Option<RecordId>,
    pub energy: Option<RecordId>,
}

impl Records {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut list = Vec::new();
        let mut add = |record: Record| {
            list.push(record);
            RecordId(list.len() - 1)
        };
        let input = (mechanism.inputs.len() > 1).then(|| add(inputs(mechanism)));
        let orders = Order::ALL.map(|order| add(outputs(mechanism, order)));
        let motion = add(motion(mechanism, orders));
        let has_margins = mechanism.outputs.iter().any(is_margin);
        let margins = has_margins.then(|| add(margins(mechanism)));
        let loads = (mechanism.dynamics.loads.len() > 1).then(|| add(forces::loads(mechanism)));
        let owners = forces::owners(mechanism);
        let fields: Vec<_> = owners
            .iter()
            .map(|owned| {
                forces::field_of_the_whole(mechanism, owned.start).unwrap_or_else(|| {
                    let record = forces::of_owner(mechanism, owned.clone());
                    forces::field_of_owner(mechanism, owned.start, add(record))
                })
            })
            .collect();
        let forces =
            (!fields.is_empty()).then(|| add(record(mechanism, "Forces", Kind::Forces, fields)));
        let energy = mechanism.dynamics.energy.then(|| add(forces::energy(mechanism)));
        Self { list, input, orders, motion, margins, loads, forces, energy }
    }
}

pub(super) fn record(
    mechanism: &Mechanism,
    suffix: &str,
    kind: Kind,
    fields: Vec<Field>,
) -> Record {
    let name = format!("{}{suffix}", mechanism.name.unraw());
    Record { name: Ident::new(&name, mechanism.name.span()), kind, fields }
}

fn inputs(mechanism: &Mechanism) -> Record {
    let fields = mechanism.inputs.iter().enumerate().map(|(index, input)| Field {
        name: input.name.clone(),
        shape: Shape::Number,
        subject: Subject::Input(index),
    });
    record(mechanism, "Input", Kind::Inputs, fields.collect())
}

fn outputs(mechanism: &Mechanism, order: Order) -> Record {
    let fields = mechanism.outputs.iter().enumerate().map(|(index, output)| Field {
        name: output.field.clone(),
        shape: Shape::Quantity(Quantity::of(&output.kind), order),
        subject: Subject::Output(index, order),
    });
    let suffix = match order {
        Order::Position => "Position",
        Order::Velocity => "Velocity",
        Order::Acceleration => "Acceleration",
    };
    record(mechanism, suffix, Kind::Outputs(order), fields.collect())
}

fn motion(mechanism: &Mechanism, orders: [RecordId; 3]) -> Record {
    let fields = Order::ALL.into_iter().zip(orders).map(|(order, record)| Field {
        name: Ident::new(field_of_motion(order), proc_macro2::Span::call_site()),
        shape: Shape::Record(record),
        subject: Subject::Outputs(order),
    });
    record(mechanism, "Motion", Kind::Motion, fields.collect())
}

fn margins(mechanism: &Mechanism) -> Record {
    let outputs = mechanism.outputs.iter().enumerate().filter(|(_, output)| is_margin(output));
    let fields = outputs.map(|(index, output)| Field {
        name: output.field.clone(),
        shape: Shape::Number,
        subject: Subject::Output(index, Order::Position),
    });
    record(mechanism, "Margins", Kind::Margins, fields.collect())
}
