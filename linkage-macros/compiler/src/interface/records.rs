//! The records that entry points take and return, and the shapes of results that are made of them.

use proc_macro2::{Ident, Span};
use syn::ext::IdentExt;

use crate::interface::quantity::{Order, Quantity};
use crate::model::mechanism::{DeclaredOutput, Mechanism, OutputKind};

/// An index into `Interface::records`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RecordId(usize);

impl RecordId {
    /// The id of the record at this place of the list.
    pub(super) fn of(index: usize) -> Self {
        Self(index)
    }

    pub(super) fn index(self) -> usize {
        self.0
    }
}

/// The shape of a result or a part of it, which determines the order of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
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
pub struct Record {
    pub name: Ident,
    pub kind: RecordKind,
    pub fields: Vec<Field>,
}

/// The purpose of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecordKind {
    /// Several inputs, or their velocities or accelerations.
    Inputs,
    /// Every output at one order.
    Outputs(Order),
    /// The outputs at all orders.
    Motion,
    /// The outputs that exist also where the pose does not.
    Margins,
    /// Several loads.
    Loads,
    /// The requested forces, by the part that they belong to.
    Forces,
    /// The same of one input or link: an index into the mechanism's asked-for forces, its first.
    ForcesOf(usize),
    Energy,
    /// Mass matrix, and what acts along the inputs.
    Equations,
}

/// The sentences about a record in the documentation of Rust and of C. `@` stands for the solver.
pub(crate) struct KindInWords {
    pub in_rust: String,
    pub in_c: String,
}

impl RecordKind {
    pub(crate) fn in_words(self, mechanism: &Mechanism) -> KindInWords {
        let owned;
        let [in_rust, in_c] = match self {
            Self::Inputs => ["The inputs of @, or their velocities or accelerations."; 2],
            Self::Outputs(Order::Position) => [
                "Positions of the outputs of @, in metres and radians.",
                "Positions of the outputs.",
            ],
            Self::Outputs(Order::Velocity) => {
                ["Velocities of the outputs of @, in m/s and rad/s.", "Velocities of the outputs."]
            }
            Self::Outputs(Order::Acceleration) => [
                "Accelerations of the outputs of @, in m/s² and rad/s².",
                "Accelerations of the outputs.",
            ],
            Self::Motion => [
                "Position, velocity and acceleration of the outputs of @.",
                "Position, velocity and acceleration of the outputs.",
            ],
            Self::Margins => [
                "How far the groups of @ are from their limits, also where the pose does not exist.",
                "Distances of the groups from their limits.",
            ],
            Self::Loads => ["The loads of @."; 2],
            Self::Forces => [
                "Efforts of the drives of @ and reactions of its joints.",
                "Efforts of the drives and reactions of the joints.",
            ],
            Self::ForcesOf(first) => {
                let owner = mechanism.dynamics.asked[first].owner.unraw();
                owned = [
                    format!("What was asked about the forces of `{owner}`, of @."),
                    format!("Forces of {owner}."),
                ];
                owned.each_ref().map(String::as_str)
            }
            Self::Energy => ["The energy of @.", "Kinetic and potential energy."],
            Self::Equations => [
                "The equations of motion of @: Σ `mass[row][column]` times the acceleration of input \
                 `column` = `force[row]` + drive of input `row`.",
                "The equations of motion: mass times accelerations = force + drives.",
            ],
        };
        KindInWords { in_rust: in_rust.to_string(), in_c: in_c.to_string() }
    }
}

#[derive(Debug)]
pub struct Field {
    pub name: Ident,
    pub shape: Shape,
    pub subject: Subject,
}

/// The content of a field, for its documentation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
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
    KineticEnergy,
    PotentialEnergy,
    /// The mass matrix of the equations of motion.
    Mass,
    /// Their right-hand side without drives.
    GeneralizedForce,
}

/// True if an output exists even where the mechanism has no pose.
pub(crate) fn is_margin(output: &DeclaredOutput) -> bool {
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

pub(super) fn field(name: &Ident, shape: Shape, subject: Subject) -> Field {
    Field { name: name.clone(), shape, subject }
}

/// A field that no declaration names.
pub(super) fn own_field(name: &str, shape: Shape, subject: Subject) -> Field {
    Field { name: Ident::new(name, Span::call_site()), shape, subject }
}

pub(super) fn record(
    mechanism: &Mechanism,
    suffix: &str,
    kind: RecordKind,
    fields: Vec<Field>,
) -> Record {
    let name = format!("{}{suffix}", mechanism.name.unraw());
    // With the span of the declared name, an editor would show every record there, and rename them all.
    Record { name: Ident::new(&name, Span::call_site()), kind, fields }
}
