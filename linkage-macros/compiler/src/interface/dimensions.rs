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
pub(crate) fn of_result(
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::labels;
    use crate::interface::units_in_words::unit;
    use crate::oracle::mechanism;

    /// The units of a result by the names of its numbers.
    fn units(mechanism: &Mechanism, method: &str) -> Vec<String> {
        let interface = Interface::of(mechanism);
        let entries = interface.entries.iter();
        let entry = entries.into_iter().find(|entry| entry.name() == method);
        let entry = entry.expect("it is offered");
        let found = of_result(&interface, mechanism, entry);
        assert_eq!(found.len(), interface.numbers(entry.result), "{method}");
        let names = labels::of_result(&interface, mechanism, entry);
        let named = names.iter().zip(&found);
        named
            .map(|(name, (dimension, order))| format!("{name} {}", unit(*dimension, *order)))
            .collect()
    }

    #[test]
    fn every_number_of_a_result_has_the_unit_of_what_it_is() {
        let press = mechanism(
            "struct Press { input theta: angle; load work: force;
             ground A(0, 0); guide way through (0, 0) along -90deg;
             crank AB(A) -> B { length: 100mm, angle: theta }
             rrp BC(B), ram(way) -> C { length: 400mm, mode: ahead }
             spring buffer between A and C { stiffness: 100(N/m), free_length: 300mm }
             mass 8kg on ram at (0, 0); force (0, work) on C;
             let area = C.y * C.x;
             output C, BC, ram.slide, BC.margin, area;
             output theta.drive, BC.C, ram.way, buffer.force, shaking, energy; }",
        );
        assert_eq!(
            units(&press, "position"),
            ["C.x m", "C.y m", "BC.angle 1", "BC.angle 1", "ram.slide m", "BC.margin m", "area m²"]
        );
        assert_eq!(
            units(&press, "motion")[7..13],
            [
                "velocity of C.x m/s",
                "velocity of C.y m/s",
                "BC.omega rad/s",
                "velocity of ram.slide m/s",
                "velocity of BC.margin m/s",
                "velocity of area m²/s"
            ]
        );
        assert_eq!(
            units(&press, "forces"),
            [
                "theta.drive N·m",
                "BC.C.x N",
                "BC.C.y N",
                "ram.way.normal N",
                "ram.way.couple N·m",
                "buffer.force N",
                "shaking.x N",
                "shaking.y N",
                "shaking.couple N·m"
            ]
        );
        assert_eq!(units(&press, "energy"), ["kinetic energy N·m", "potential energy N·m"]);
    }

    /// A crank and a slider: a mass matrix has as many units as inputs' pairs.
    #[test]
    fn equations_of_motion_have_units_of_efforts_and_inertias() {
        let arm = mechanism(
            "struct Arm { input theta: angle; input s: length; ground A(0, 0);
             crank AB(A) -> B { length: 1, angle: theta }
             guide rail on AB through (0, 0) along 0deg;
             slider block(rail) -> C { slide: s }
             mass 2kg on AB uniform; mass 3kg on block at (0, 0); output C, theta.drive; }",
        );
        let found = units(&arm, "equations_of_motion");
        let units: Vec<_> = found.iter().map(|line| line.rsplit(' ').next()).collect();
        assert_eq!(units, ["kg·m²", "kg·m", "kg·m", "kg", "N·m", "N"].map(Some));
    }
}
