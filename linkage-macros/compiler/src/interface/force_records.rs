//! The records of forces: a field for every input and link that is asked about, and in it a field for
//! every drive, joint and guide of it that is.

use std::ops::Range;

use syn::ext::IdentExt;

use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{
    Field, Record, RecordId, RecordKind, Shape, Subject, field, own_field, record,
};
use crate::model::acting::{Effort, RequestedEffort};
use crate::model::mechanism::Mechanism;

/// The shape of an effort in the result.
pub(crate) fn shape(effort: Effort) -> Shape {
    match effort {
        Effort::Input(_)
        | Effort::Pull
        | Effort::Unknown(_)
        | Effort::Drive(_)
        | Effort::Push(_)
        | Effort::Spring(_)
        | Effort::Stop(_)
        | Effort::Gap(_)
        | Effort::PinFriction(..)
        | Effort::GuideFriction(_)
        | Effort::Formula(_)
        | Effort::Losses => Shape::Number,
        Effort::Pin(..) | Effort::Bearing(..) => Shape::Quantity(Quantity::Force, Order::Position),
        Effort::Guide(_) => Shape::Quantity(Quantity::GuideForce, Order::Position),
        Effort::Shaking => Shape::Quantity(Quantity::Shaking, Order::Position),
    }
}

/// The path of an effort in the result.
pub(crate) fn path(asked: &RequestedEffort) -> String {
    asked.path()
}

/// The scalar rows of an effort: `BC.B.x`, `theta.drive`.
pub(crate) fn rows(asked: &RequestedEffort) -> Vec<String> {
    let path = path(asked);
    match shape(asked.effort) {
        Shape::Quantity(quantity, _) => {
            quantity.rows().iter().map(|row| format!("{path}.{row}")).collect()
        }
        _ => vec![path],
    }
}

/// The range of each owner's efforts in the list of requested ones: the model keeps an owner's efforts
/// together.
pub(super) fn owners(mechanism: &Mechanism) -> Vec<Range<usize>> {
    let mut owners: Vec<Range<usize>> = Vec::new();
    let asked = &mechanism.dynamics.asked;
    for (index, effort) in asked.iter().enumerate() {
        match owners.last_mut() {
            Some(last) if asked[last.start].owner == effort.owner => last.end = index + 1,
            _ => owners.push(index..index + 1),
        }
    }
    owners
}

pub(super) fn of_owner(mechanism: &Mechanism, owned: Range<usize>) -> Record {
    let (first, asked) = (owned.start, &mechanism.dynamics.asked);
    let suffix = format!("ForcesOf{}", asked[first].owner.unraw());
    let fields = owned.map(|index| {
        field(&asked[index].field, shape(asked[index].effort), Subject::Effort(index))
    });
    record(mechanism, &suffix, RecordKind::ForcesOf(first), fields.collect())
}

/// The field of an effort that belongs to the whole mechanism.
pub(super) fn field_of_the_whole(mechanism: &Mechanism, index: usize) -> Option<Field> {
    let asked = &mechanism.dynamics.asked[index];
    asked
        .effort
        .is_of_the_whole()
        .then(|| field(&asked.owner, shape(asked.effort), Subject::Effort(index)))
}

/// The two parts of the energy.
pub(super) fn energy(mechanism: &Mechanism) -> Record {
    let kinetic = own_field("kinetic", Shape::Number, Subject::KineticEnergy);
    let potential = own_field("potential", Shape::Number, Subject::PotentialEnergy);
    record(mechanism, "Energy", RecordKind::Energy, vec![kinetic, potential])
}

/// The mass matrix, and what acts along the inputs.
pub(super) fn equations(mechanism: &Mechanism) -> Record {
    let count = mechanism.inputs.len();
    let mass = own_field("mass", Shape::Matrix { rows: count, columns: count }, Subject::Mass);
    let force = own_field("force", Shape::List(count), Subject::GeneralizedForce);
    record(mechanism, "Equations", RecordKind::Equations, vec![mass, force])
}

pub(super) fn field_of_owner(mechanism: &Mechanism, first: usize, record: RecordId) -> Field {
    let owner = &mechanism.dynamics.asked[first].owner;
    field(owner, Shape::Record(record), Subject::Efforts(first))
}

pub(super) fn loads(mechanism: &Mechanism) -> Record {
    let loads = mechanism.dynamics.loads.iter().enumerate();
    let fields = loads.map(|(at, load)| field(&load.name, Shape::Number, Subject::Load(at)));
    record(mechanism, "Loads", RecordKind::Loads, fields.collect())
}
