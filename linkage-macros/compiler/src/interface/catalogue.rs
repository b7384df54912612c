//! Every record of a mechanism, with its fields.

use crate::interface::force_records;
use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{
    Record, RecordId, RecordKind, Shape, Subject, field, field_of_motion, is_margin, own_field,
    record,
};
use crate::model::mechanism::Mechanism;

/// All records of a mechanism, in the order in which they are defined.
pub(super) fn records(mechanism: &Mechanism) -> Vec<Record> {
    let mut list = Vec::new();
    if mechanism.inputs.len() > 1 {
        list.push(inputs(mechanism));
    }
    let first = list.len();
    list.extend(Order::ALL.map(|order| outputs(mechanism, order)));
    list.push(motion(mechanism, [0, 1, 2].map(|order| RecordId::of(first + order))));
    if mechanism.outputs.iter().any(is_margin) {
        list.push(margins(mechanism));
    }
    if mechanism.dynamics.loads.len() > 1 {
        list.push(force_records::loads(mechanism));
    }
    let mut fields = Vec::new();
    for owned in force_records::owners(mechanism) {
        let of_the_whole = force_records::field_of_the_whole(mechanism, owned.start);
        fields.push(of_the_whole.unwrap_or_else(|| {
            list.push(force_records::of_owner(mechanism, owned.clone()));
            force_records::field_of_owner(mechanism, owned.start, RecordId::of(list.len() - 1))
        }));
    }
    if !fields.is_empty() {
        list.push(record(mechanism, "Forces", RecordKind::Forces, fields));
    }
    if mechanism.dynamics.energy {
        list.push(force_records::energy(mechanism));
    }
    if !mechanism.dynamics.masses.is_empty() {
        list.push(force_records::equations(mechanism));
    }
    list
}

fn inputs(mechanism: &Mechanism) -> Record {
    let fields = mechanism.inputs.iter().enumerate();
    let fields = fields.map(|(at, input)| field(&input.name, Shape::Number, Subject::Input(at)));
    record(mechanism, "Input", RecordKind::Inputs, fields.collect())
}

fn outputs(mechanism: &Mechanism, order: Order) -> Record {
    let fields = mechanism.outputs.iter().enumerate().map(|(index, output)| {
        let shape = Shape::Quantity(Quantity::of(&output.kind), order);
        field(&output.field, shape, Subject::Output(index, order))
    });
    let suffix = match order {
        Order::Position => "Position",
        Order::Velocity => "Velocity",
        Order::Acceleration => "Acceleration",
    };
    record(mechanism, suffix, RecordKind::Outputs(order), fields.collect())
}

fn motion(mechanism: &Mechanism, orders: [RecordId; 3]) -> Record {
    let fields = Order::ALL.into_iter().zip(orders).map(|(order, record)| {
        own_field(field_of_motion(order), Shape::Record(record), Subject::Outputs(order))
    });
    record(mechanism, "Motion", RecordKind::Motion, fields.collect())
}

fn margins(mechanism: &Mechanism) -> Record {
    let outputs = mechanism.outputs.iter().enumerate().filter(|(_, output)| is_margin(output));
    let fields = outputs.map(|(index, output)| {
        field(&output.field, Shape::Number, Subject::Output(index, Order::Position))
    });
    record(mechanism, "Margins", RecordKind::Margins, fields.collect())
}
