//! The table of entry points and their properties.
//!
//! A new one is a row here, its numbers in `equations`, a field of the four costs and a condition of `unavailable` in the
//! run-time crate; with a sweep it is a type of that crate, too.

use crate::interface::quantity::Order;
use crate::interface::records::{RecordKind, Shape};

/// The meaning of an argument for the inputs: each is a number, or a record of several inputs' numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArgumentKind {
    Value,
    Rate,
    Acceleration,
    /// The cosine of the only input, in place of its value; the sine follows.
    Cosine,
    Sine,
    /// The loads, a number or a record of several.
    Loads,
    /// The efforts of the inputs' drives, a number or a list.
    Drives,
}

/// A question about a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Analysis {
    Position,
    Velocity,
    Motion,
    Coefficients,
    Margins,
    Forces,
    Statics,
    Holding,
    Energy,
    ForwardDynamics,
    EquationsOfMotion,
}

/// The field that an analysis belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Topic {
    Kinematics,
    /// Forces and energy.
    Forces,
    /// Accelerations under forces: every input has to move some mass.
    Dynamics,
}

/// The result of an analysis.
#[derive(Clone, Copy, Debug)]
pub(super) enum Returns {
    /// A record of this kind: where a mechanism has none, the analysis is not offered.
    Record(RecordKind),
    /// A row an output, a column an input.
    Matrix,
    /// A number for every input, and its name in errors.
    OfInputs(&'static str),
    /// The drives of the only input at impending motion backwards and forwards, where something rubs.
    Band,
}

/// The properties of an analysis.
#[derive(Debug)]
pub(crate) struct EntryRow {
    analysis: Analysis,
    /// The function that returns a `Result`; `solve_` in front is that of the fast path.
    name: &'static str,
    /// The same function of the only input's cosine and sine, if there is one.
    name_at: Option<&'static str>,
    /// The result, in words.
    pub subject: &'static str,
    pub topic: Topic,
    /// True if rates are given where there is friction: at rest they say which way it acts.
    creeps: bool,
    /// The arguments; loads only where there are any.
    given: &'static [ArgumentKind],
    pub(super) returns: Returns,
    /// True if it has a `sweep_` over slices.
    pub sweeps: bool,
    /// True if `COST` has a field of its name.
    pub has_cost: bool,
    /// True if some of its numbers are known where a group has no pose: those behind it are NaN then.
    pub is_known_in_part: bool,
    /// The documentation of its particular errors: with one input, and with several.
    pub errors: [&'static str; 2],
}

/// A name of the interface: an analysis, by the inputs or by the only input's cosine and sine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntryPoint {
    pub analysis: Analysis,
    pub by_cosine: bool,
}

/// An entry point of a mechanism.
#[derive(Clone, Debug)]
pub struct Entry {
    pub point: EntryPoint,
    pub given: Vec<ArgumentKind>,
    pub result: Shape,
}

impl Analysis {
    /// The analyses of a page, beside where everything stands.
    pub(crate) const ON_PAGES: [Self; 4] =
        [Self::Motion, Self::Forces, Self::Holding, Self::ForwardDynamics];

    /// Each computes what the one before it does, and one order more: they share their formulas, and
    /// are what the run-time crate's trait `Solver` asks for.
    pub(crate) const STAGES: [Self; 3] = [Self::Position, Self::Velocity, Self::Motion];

    /// All of them, in the order of the rows.
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().copied().flatten().map(|row| row.analysis)
    }

    pub(crate) fn row(self) -> &'static EntryRow {
        let mut rows = ROWS.iter().copied().flatten();
        rows.find(|row| row.analysis == self).expect("every analysis has a row")
    }

    /// The entry point that is given the inputs themselves.
    pub fn by_value(self) -> EntryPoint {
        EntryPoint { analysis: self, by_cosine: false }
    }
}

impl EntryPoint {
    pub fn named(name: &str) -> Self {
        let points = Analysis::all()
            .flat_map(|analysis| [false, true].map(|by_cosine| Self { analysis, by_cosine }));
        points.into_iter().find(|point| point.name() == name).expect("an entry point has the name")
    }

    pub(crate) fn row(self) -> &'static EntryRow {
        self.analysis.row()
    }

    pub fn name(self) -> &'static str {
        let row = self.row();
        row.name_at.filter(|_| self.by_cosine).unwrap_or(row.name)
    }

    /// The name of its answer, however the input is given.
    pub(crate) fn answer(self) -> &'static str {
        self.row().name
    }

    /// True if it is about forces or energy.
    pub(crate) fn is_about_forces(self) -> bool {
        self.row().topic != Topic::Kinematics
    }

    /// True if it is about accelerations under forces.
    pub(crate) fn is_about_dynamics(self) -> bool {
        self.row().topic == Topic::Dynamics
    }
}

impl Entry {
    pub fn name(&self) -> &'static str {
        self.point.name()
    }

    /// True if the only input is given by its cosine and sine.
    pub(crate) fn takes_cosine(&self) -> bool {
        self.point.by_cosine
    }

    /// True if it is position, velocity or motion at given inputs.
    pub(crate) fn is_a_stage(&self) -> bool {
        !self.takes_cosine() && Analysis::STAGES.contains(&self.point.analysis)
    }
}

/// Every entry point of a mechanism with so many inputs, in the order in which they are computed and
/// documented. Those that are given a cosine exist only where the formulas need the value nowhere else.
pub(super) fn all(
    columns: usize,
    [has_loads, has_friction]: [bool; 2],
    result: impl Fn(&EntryRow) -> Option<Shape>,
) -> Vec<Entry> {
    let points = ROWS.iter().flat_map(|&rows| {
        let forms = if columns == 1 { &[false, true][..] } else { &[false] };
        let of_form = move |&by_cosine: &bool| {
            let rows = rows.iter().filter(move |row| !by_cosine || row.name_at.is_some());
            rows.map(move |row| EntryPoint { analysis: row.analysis, by_cosine })
        };
        forms.iter().flat_map(of_form)
    });
    let entry = |point: EntryPoint| {
        let form = if point.by_cosine {
            &[ArgumentKind::Cosine, ArgumentKind::Sine][..]
        } else {
            &[ArgumentKind::Value]
        };
        let creep: &[_] =
            if point.row().creeps && has_friction { &[ArgumentKind::Rate] } else { &[] };
        let beside =
            point.row().given.iter().filter(|&&given| has_loads || given != ArgumentKind::Loads);
        let given = form.iter().chain(creep).chain(beside).copied().collect();
        Some(Entry { point, given, result: result(point.row())? })
    };
    points.filter_map(entry).collect()
}

/// All rows. The forms by cosine and sine of a group follow the others of that.
const ROWS: [&[EntryRow]; 5] = [
    &[POSITION, VELOCITY, MOTION, COEFFICIENTS],
    &[MARGINS],
    &[FORCES, STATICS, HOLDING],
    &[ENERGY],
    &[FORWARD_DYNAMICS, EQUATIONS_OF_MOTION],
];

const POSITION: EntryRow = EntryRow {
    analysis: Analysis::Position,
    name: "position",
    name_at: Some("position_at"),
    subject: "Positions of the outputs",
    topic: Topic::Kinematics,
    creeps: false,
    given: &[],
    returns: Returns::Record(RecordKind::Outputs(Order::Position)),
    sweeps: true,
    has_cost: true,
    is_known_in_part: false,
    errors: [""; 2],
};

const VELOCITY: EntryRow = EntryRow {
    analysis: Analysis::Velocity,
    name: "velocity",
    name_at: Some("velocity_at"),
    subject: "Velocities of the outputs",
    given: &[ArgumentKind::Rate],
    returns: Returns::Record(RecordKind::Outputs(Order::Velocity)),
    has_cost: false,
    ..POSITION
};

const MOTION: EntryRow = EntryRow {
    analysis: Analysis::Motion,
    name: "motion",
    name_at: Some("motion_at"),
    subject: "Positions, velocities and accelerations of the outputs",
    given: &[ArgumentKind::Rate, ArgumentKind::Acceleration],
    returns: Returns::Record(RecordKind::Motion),
    ..POSITION
};

const COEFFICIENTS: EntryRow = EntryRow {
    analysis: Analysis::Coefficients,
    name: "coefficients",
    name_at: None,
    subject: "Kinematic coefficients ∂outputs/∂inputs",
    returns: Returns::Matrix,
    sweeps: false,
    errors: [" An input that no coefficient depends on is not looked at."; 2],
    ..POSITION
};

const MARGINS: EntryRow = EntryRow {
    analysis: Analysis::Margins,
    name: "margins",
    name_at: None,
    subject: "Distances of the groups from their limits",
    returns: Returns::Record(RecordKind::Margins),
    sweeps: false,
    has_cost: false,
    is_known_in_part: true,
    errors: [" A margin is there also beyond its own group's limit. Behind another group that has no pose it \
              is NaN; where no margin is known, the error names that group, and by how much it is out of \
              reach."; 2],
    ..POSITION
};

const FORCES: EntryRow = EntryRow {
    analysis: Analysis::Forces,
    name: "forces",
    name_at: Some("forces_at"),
    subject: "Efforts of drives and reactions of joints in motion",
    topic: Topic::Forces,
    given: &[ArgumentKind::Rate, ArgumentKind::Acceleration, ArgumentKind::Loads],
    returns: Returns::Record(RecordKind::Forces),
    ..POSITION
};

const STATICS: EntryRow = EntryRow {
    analysis: Analysis::Statics,
    name: "statics",
    name_at: Some("statics_at"),
    subject: "Efforts of drives and reactions of joints at rest",
    creeps: true,
    given: &[ArgumentKind::Loads],
    ..FORCES
};

const HOLDING: EntryRow = EntryRow {
    analysis: Analysis::Holding,
    name: "holding",
    name_at: None,
    subject: "Drives at impending motion backwards and forwards; between them friction holds the mechanism",
    creeps: false,
    returns: Returns::Band,
    sweeps: false,
    has_cost: false,
    ..STATICS
};

const ENERGY: EntryRow = EntryRow {
    analysis: Analysis::Energy,
    name: "energy",
    name_at: Some("energy_at"),
    subject: "Kinetic and potential energy",
    given: &[ArgumentKind::Rate],
    returns: Returns::Record(RecordKind::Energy),
    ..FORCES
};

const FORWARD_DYNAMICS: EntryRow = EntryRow {
    analysis: Analysis::ForwardDynamics,
    name: "forward_dynamics",
    name_at: None,
    subject: "Accelerations of the inputs under given drives",
    topic: Topic::Dynamics,
    given: &[ArgumentKind::Rate, ArgumentKind::Drives, ArgumentKind::Loads],
    returns: Returns::OfInputs("acceleration"),
    errors: [
        " `Singular` names an input that moves no mass in this pose; at a dead point of the inputs \
         the group is: choose the crank that turns fully as input.",
        " `Singular` names an input that moves no mass in this pose, or moves it as earlier inputs do as \
         far as rounding can tell. Next to such a pose digits are lost: of two equal bars \
         that enclose a small angle b, an error of some 10 ε/b² of the largest acceleration is left. \
         At a dead point of the inputs the group is named: choose the cranks that turn fully as \
         inputs.",
    ],
    ..POSITION
};

const EQUATIONS_OF_MOTION: EntryRow = EntryRow {
    analysis: Analysis::EquationsOfMotion,
    name: "equations_of_motion",
    subject: "Equations of motion, mass times accelerations = force + drives",
    given: &[ArgumentKind::Rate, ArgumentKind::Loads],
    returns: Returns::Record(RecordKind::Equations),
    has_cost: false,
    errors: [""; 2],
    ..FORWARD_DYNAMICS
};
