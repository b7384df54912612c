//! The dimension of every number of a result, and the order of its derivative by time.

use crate::interface::Interface;
use crate::interface::entries::{Entry, Returns};
use crate::interface::force_records::shape;
use crate::interface::quantity::{Order, Quantity, QuantityPart};
use crate::interface::records::{Field, RecordId, Shape, Subject};
use crate::model::acting::Effort;
use crate::model::effort_dimensions::{effort_along, of_effort};
use crate::model::mechanism::{Dimension, Mechanism, OutputKind};

/// The dimension of each number of an entry point's result, in the order of the sinks. Of a matrix or list that is
/// no record nothing is said.
pub fn of_result(
    interface: &Interface,
    mechanism: &Mechanism,
    entry: &Entry,
) -> Vec<(Dimension, Order)> {
    match (entry.point.row().returns, entry.result) {
        (Returns::Record(_), Shape::Record(id)) => of_record(interface, mechanism, id),
        _ => Vec::new(),
    }
}

fn of_record(
    interface: &Interface,
    mechanism: &Mechanism,
    id: RecordId,
) -> Vec<(Dimension, Order)> {
    let fields = interface.record(id).fields.iter();
    fields.flat_map(|field| of_field(interface, mechanism, field)).collect()
}

fn of_field(
    interface: &Interface,
    mechanism: &Mechanism,
    field: &Field,
) -> Vec<(Dimension, Order)> {
    let at_rest = |dimension: Dimension| vec![(dimension, Order::Position)];
    let inputs = || mechanism.inputs.iter().map(|input| input.dimension);
    match field.subject {
        Subject::Output(index, order) => {
            let kind = &mechanism.outputs[index].kind;
            let whole = match kind {
                OutputKind::Value { dimension, .. } | OutputKind::Ratio { dimension, .. } => {
                    *dimension
                }
                OutputKind::Margin(_) => Dimension::LENGTH,
                OutputKind::Transmission(_) => Dimension::ANGLE,
                _ => Dimension::NUMBER,
            };
            let parts = Quantity::of(kind).layout(order).parts;
            parts.iter().map(|part| (of_part(part, whole), order)).collect()
        }
        Subject::Outputs(_) | Subject::Efforts(_) => match field.shape {
            Shape::Record(id) => of_record(interface, mechanism, id),
            _ => Vec::new(),
        },
        Subject::Input(index) => at_rest(mechanism.inputs[index].dimension),
        Subject::Load(index) => at_rest(mechanism.dynamics.loads[index].dimension),
        Subject::Effort(index) => efforts(mechanism, mechanism.dynamics.asked[index].effort),
        Subject::KineticEnergy | Subject::PotentialEnergy => at_rest(Dimension::TORQUE),
        Subject::Mass => {
            let row = |row| inputs().map(move |column| of_inertia(row, column));
            inputs().flat_map(row).map(|dimension| (dimension, Order::Position)).collect()
        }
        Subject::GeneralizedForce => {
            inputs().map(|input| (effort_along(input), Order::Position)).collect()
        }
    }
}

/// The dimension of a part of a position or one of its rates; a number has that of the whole.
fn of_part(part: &QuantityPart, whole: Dimension) -> Dimension {
    match part.field {
        "omega" | "alpha" => Dimension::ANGLE,
        "x" | "y" | "slide" => Dimension::LENGTH,
        _ => whole,
    }
}

/// The dimensions of the numbers of an effort.
fn efforts(mechanism: &Mechanism, effort: Effort) -> Vec<(Dimension, Order)> {
    let of_part = |part: &QuantityPart| match part.field {
        "couple" => (Dimension::TORQUE, Order::Position),
        _ => (Dimension::FORCE, Order::Position),
    };
    match shape(effort) {
        Shape::Quantity(quantity, order) => {
            quantity.layout(order).parts.iter().map(of_part).collect()
        }
        _ => vec![(of_effort(mechanism, effort), Order::Position)],
    }
}

/// The dimension whose product with the acceleration of the column is an effort along the row.
fn of_inertia(row: Dimension, column: Dimension) -> Dimension {
    effort_along(row).times(column, -1).times(Dimension::TIME, 2)
}
