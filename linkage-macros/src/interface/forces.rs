//! The records of forces: a field for every input and link that is asked about, and in it a field for
//! every drive, joint and guide of it that is.

use std::ops::Range;

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{Field, Kind, Record, RecordId, Shape, Subject, record};
use crate::model::dynamics::{Asked, Effort};
use crate::model::mechanism::Mechanism;

/// What an effort is made of.
pub(crate) fn shape(effort: Effort) -> Shape {
    match effort {
        Effort::Input(_) | Effort::Drive(_) | Effort::Push(_) | Effort::Spring(_) => Shape::Number,
        Effort::Pin(..) | Effort::Bearing(..) => Shape::Quantity(Quantity::Force, Order::Position),
        Effort::Guide(_) => Shape::Quantity(Quantity::GuideForce, Order::Position),
    }
}

/// The scalar rows of an effort: `BC.B.x`, `theta.drive`.
pub(crate) fn rows(asked: &Asked) -> Vec<String> {
    let path = format!("{}.{}", asked.owner.unraw(), asked.field.unraw());
    match shape(asked.effort) {
        Shape::Quantity(quantity, _) => {
            quantity.rows().iter().map(|row| format!("{path}.{row}")).collect()
        }
        _ => vec![path],
    }
}

/// What is asked of each owner: the model keeps it together.
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
    let fields = owned.map(|index| Field {
        name: asked[index].field.clone(),
        shape: shape(asked[index].effort),
        subject: Subject::Effort(index),
    });
    record(mechanism, &suffix, Kind::ForcesOf(first), fields.collect())
}

pub(super) fn field_of_owner(mechanism: &Mechanism, first: usize, record: RecordId) -> Field {
    let name: Ident = mechanism.dynamics.asked[first].owner.clone();
    Field { name, shape: Shape::Record(record), subject: Subject::Efforts(first) }
}

pub(super) fn loads(mechanism: &Mechanism) -> Record {
    let loads = mechanism.dynamics.loads.iter().enumerate();
    let fields = loads.map(|(index, load)| Field {
        name: load.name.clone(),
        shape: Shape::Number,
        subject: Subject::Load(index),
    });
    record(mechanism, "Loads", Kind::Loads, fields.collect())
}
