//! The entry points: what each is called, given and returns.

use crate::interface::records::{RecordId, Shape};

/// What an argument says of the inputs: each is a number, or a record of several inputs' numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Given {
    Value,
    Rate,
    Acceleration,
    /// Of the only input, in place of its value; a sine follows.
    Cosine,
    Sine,
    /// The loads, a number or a record of several.
    Loads,
    /// The efforts of the inputs' drives, a number or a list.
    Drives,
}

/// An entry point.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// The function that returns a `Result`; `solve_` in front is that of the fast path.
    pub name: &'static str,
    pub given: &'static [Given],
    pub result: Shape,
    /// What it computes, in words.
    pub subject: &'static str,
    /// Whether it has a `sweep_` over slices.
    pub sweeps: bool,
}

impl Entry {
    /// Whether the only input is given by its cosine and sine.
    pub(crate) fn takes_cosine(&self) -> bool {
        self.given.first() == Some(&Given::Cosine)
    }

    /// Whether it is about forces or energy.
    pub(crate) fn is_about_forces(&self) -> bool {
        is_about_forces(self.name)
    }

    /// Whether it needs every input to move some mass.
    pub(crate) fn needs_mass(&self) -> bool {
        [FORWARD, EQUATIONS].contains(&self.name)
    }

    /// What is given beside the inputs' values.
    pub(crate) fn rates(&self) -> &'static [Given] {
        &self.given[if self.takes_cosine() { 2 } else { 1 }..]
    }
}

/// Whether the entry point of this name is about forces or energy.
pub(crate) fn is_about_forces(name: &str) -> bool {
    ["forces", "statics", "energy", FORWARD, EQUATIONS].iter().any(|known| name.starts_with(known))
}

const POSITIONS: &str = "Positions of the outputs";
const VELOCITIES: &str = "Velocities of the outputs";
const MOTIONS: &str = "Positions, velocities and accelerations of the outputs";
const COEFFICIENTS: &str = "Kinematic coefficients ∂outputs/∂inputs";
const MARGINS: &str = "Distances of the groups from their limits";

/// Every entry point that there may be, in the order in which they are computed and documented.
/// Those that are given a cosine exist only where the formulas need the value nowhere else.
pub(super) fn all(
    rows: usize,
    columns: usize,
    [position, velocity, _]: [RecordId; 3],
    motion: RecordId,
    margins: Option<RecordId>,
) -> Vec<Entry> {
    use Given::{Acceleration, Cosine, Rate, Sine, Value};
    let entry =
        |name, given, result, subject| Entry { name, given, result, subject, sweeps: false };
    let sweeping = |name, given, result, subject| Entry {
        sweeps: true,
        ..entry(name, given, Shape::Record(result), subject)
    };
    let at = |name, given, result, subject| entry(name, given, Shape::Record(result), subject);
    let mut entries = vec![
        sweeping("position", &[Value], position, POSITIONS),
        sweeping("velocity", &[Value, Rate], velocity, VELOCITIES),
        sweeping("motion", &[Value, Rate, Acceleration], motion, MOTIONS),
        entry("coefficients", &[Value], Shape::Matrix { rows, columns }, COEFFICIENTS),
    ];
    if columns == 1 {
        entries.extend([
            at("position_at", &[Cosine, Sine], position, POSITIONS),
            at("velocity_at", &[Cosine, Sine, Rate], velocity, VELOCITIES),
            at("motion_at", &[Cosine, Sine, Rate, Acceleration], motion, MOTIONS),
        ]);
    }
    entries.extend(margins.map(|margins| at("margins", &[Value], margins, MARGINS)));
    entries
}

const FORCES: &str = "Efforts of drives and reactions of joints in motion";
const STATICS: &str = "Efforts of drives and reactions of joints at rest";

/// The entry points about forces: in motion, and at rest.
pub(super) fn of_forces(columns: usize, has_loads: bool, forces: RecordId) -> Vec<Entry> {
    use Given::{Acceleration, Cosine, Loads, Rate, Sine, Value};
    type Lists = [&'static [Given]; 4];
    let [moving, resting, moving_at, resting_at]: Lists = match has_loads {
        false => [
            &[Value, Rate, Acceleration],
            &[Value],
            &[Cosine, Sine, Rate, Acceleration],
            &[Cosine, Sine],
        ],
        true => [
            &[Value, Rate, Acceleration, Loads],
            &[Value, Loads],
            &[Cosine, Sine, Rate, Acceleration, Loads],
            &[Cosine, Sine, Loads],
        ],
    };
    let result = Shape::Record(forces);
    let entry = |name, given, subject, sweeps| Entry { name, given, result, subject, sweeps };
    let mut entries =
        vec![entry("forces", moving, FORCES, true), entry("statics", resting, STATICS, true)];
    if columns == 1 {
        entries.extend([
            entry("forces_at", moving_at, FORCES, false),
            entry("statics_at", resting_at, STATICS, false),
        ]);
    }
    entries
}

/// From forces to motion.
pub(crate) const FORWARD: &str = "forward_dynamics";
pub(crate) const EQUATIONS: &str = "equations_of_motion";

/// The entry points that give accelerations, or the equations for them.
pub(super) fn of_dynamics(columns: usize, has_loads: bool, equations: RecordId) -> Vec<Entry> {
    use Given::{Drives, Loads, Rate, Value};
    let [forward, moving]: [&'static [Given]; 2] = match has_loads {
        false => [&[Value, Rate, Drives], &[Value, Rate]],
        true => [&[Value, Rate, Drives, Loads], &[Value, Rate, Loads]],
    };
    let accelerations = if columns == 1 { Shape::Number } else { Shape::List(columns) };
    let entry = |name, given, result, subject| Entry { name, given, result, subject, sweeps: true };
    vec![
        entry(FORWARD, forward, accelerations, "Second rates of the inputs under given drives"),
        entry(
            EQUATIONS,
            moving,
            Shape::Record(equations),
            "Equations of motion, mass times second rates = force + drives",
        ),
    ]
}

/// Of what moves, and of what is lifted or sprung.
pub(super) fn of_energy(columns: usize, energy: RecordId) -> Vec<Entry> {
    use Given::{Cosine, Rate, Sine, Value};
    let (result, subject) = (Shape::Record(energy), "Kinetic and potential energy");
    let entry = |name, given, sweeps| Entry { name, given, result, subject, sweeps };
    let mut entries = vec![entry("energy", &[Value, Rate][..], true)];
    if columns == 1 {
        entries.push(entry("energy_at", &[Cosine, Sine, Rate], false));
    }
    entries
}
