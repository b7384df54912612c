//! The names of the scalar rows in `OUTPUTS`, and the names of a result's numbers in errors.

use syn::ext::IdentExt;

use crate::interface::entries::{Entry, Returns};
use crate::interface::quantity::{Order, Quantity};
use crate::interface::records::{Field, RecordId, Shape, Subject};
use crate::interface::{Interface, force_records};
use crate::model::mechanism::{DeclaredOutput, Mechanism, OutputKind, Scalar};

/// The rows of one output, `blade.x` and `blade.y`: called as the declaration writes them, also
/// where their field has another name, `blade_x`.
pub(crate) fn rows(mechanism: &Mechanism, output: &DeclaredOutput) -> Vec<String> {
    let field = output.field.unraw().to_string();
    let ending = |ending: &str| match field.strip_suffix(&format!("_{ending}")) {
        Some(link) => format!("{link}.{ending}"),
        None => field.clone(),
    };
    match &output.kind {
        OutputKind::Margin(_) => vec![ending("margin")],
        OutputKind::Transmission(_) => vec![ending("transmission")],
        OutputKind::Value { value: Scalar::Coordinate(point, _), .. } => {
            let point = mechanism.points[point.index()].name.unraw().to_string();
            let part = [("_x", ".x"), ("_y", ".y")].into_iter().find_map(|(ending, part)| {
                (field == format!("{point}{ending}")).then(|| format!("{point}{part}"))
            });
            vec![part.unwrap_or(field)]
        }
        OutputKind::Angle(_) | OutputKind::Value { .. } | OutputKind::Ratio { .. } => vec![field],
        kind => Quantity::of(kind).rows().iter().map(|row| format!("{field}.{row}")).collect(),
    }
}

/// All rows.
pub(crate) fn all_rows(mechanism: &Mechanism) -> Vec<String> {
    mechanism.outputs.iter().flat_map(|output| rows(mechanism, output)).collect()
}

/// The name of each number of an entry point's result in errors, in the order of the sinks.
pub fn of_result(interface: &Interface, mechanism: &Mechanism, entry: &Entry) -> Vec<String> {
    match entry.point.row().returns {
        Returns::Record(_) => of_shape(interface, mechanism, entry.result),
        Returns::Matrix => {
            let inputs = mechanism.inputs.iter().map(|input| input.name.unraw().to_string());
            let rows = all_rows(mechanism);
            let column =
                |input| rows.iter().map(move |row| format!("coefficient of {input} of {row}"));
            inputs.flat_map(|input| column(input).collect::<Vec<_>>()).collect()
        }
        Returns::OfInputs(what) => of_inputs(mechanism, what),
        Returns::Band => ["drive backwards", "drive forwards"]
            .into_iter()
            .flat_map(|what| of_inputs(mechanism, what))
            .collect(),
    }
}

/// The name of each number of a record in errors.
pub(crate) fn of_record(interface: &Interface, mechanism: &Mechanism, id: RecordId) -> Vec<String> {
    let fields = interface.record(id).fields.iter();
    fields.flat_map(|field| of_field(interface, mechanism, field)).collect()
}

/// The same of a record in another; what is none has names of its own.
fn of_shape(interface: &Interface, mechanism: &Mechanism, shape: Shape) -> Vec<String> {
    match shape {
        Shape::Record(id) => of_record(interface, mechanism, id),
        _ => Vec::new(),
    }
}

/// `acceleration of theta`
fn of_inputs(mechanism: &Mechanism, what: &str) -> Vec<String> {
    let inputs = mechanism.inputs.iter();
    inputs.map(|input| format!("{what} of {}", input.name.unraw())).collect()
}

fn of_field(interface: &Interface, mechanism: &Mechanism, field: &Field) -> Vec<String> {
    match field.subject {
        Subject::Output(index, order) => of_output(mechanism, &mechanism.outputs[index], order),
        Subject::Outputs(_) | Subject::Efforts(_) => of_shape(interface, mechanism, field.shape),
        Subject::Input(index) => vec![mechanism.inputs[index].name.unraw().to_string()],
        Subject::Load(index) => vec![mechanism.dynamics.loads[index].name.unraw().to_string()],
        Subject::Effort(index) => force_records::rows(&mechanism.dynamics.asked[index]),
        Subject::Mass => vec![of_inputs(mechanism, "mass"); mechanism.inputs.len()].concat(),
        Subject::GeneralizedForce => of_inputs(mechanism, "force"),
        Subject::KineticEnergy => vec!["kinetic energy".to_string()],
        Subject::PotentialEnergy => vec!["potential energy".to_string()],
    }
}

/// The components of an output: a direction has two of them for its one row.
fn of_output(mechanism: &Mechanism, output: &DeclaredOutput, order: Order) -> Vec<String> {
    let mut rows = rows(mechanism, output);
    let parts = Quantity::of(&output.kind).layout(order).parts;
    if parts.len() > rows.len() {
        rows.insert(0, rows[0].clone());
    }
    let (derivative, of_angle) = match order {
        Order::Position => return rows,
        Order::Velocity => ("velocity of ", "omega"),
        Order::Acceleration => ("acceleration of ", "alpha"),
    };
    let rate = |row: String| match row.strip_suffix(".angle") {
        Some(link) => format!("{link}.{of_angle}"),
        None => format!("{derivative}{row}"),
    };
    rows.into_iter().map(rate).collect()
}
