//! Every record of a mechanism, with its fields.

use proc_macro2::Ident;

use crate::interface::forces;
use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{
    Field, Kind, Record, RecordId, Shape, Subject, field_of_motion, is_margin, record,
};
use crate::model::mechanism::Mechanism;

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
    pub equations: Option<RecordId>,
}

impl Records {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut list = Vec::new();
        let mut add = |record: Record| {
            list.push(record);
            RecordId::of(list.len() - 1)
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
        let has_mass = !mechanism.dynamics.masses.is_empty();
        let equations = has_mass.then(|| add(forces::equations(mechanism)));
        Self { list, input, orders, motion, margins, loads, forces, energy, equations }
    }
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
