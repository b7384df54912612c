//! The numbers of a compiled machine beside those of the truth.

use std::collections::HashMap;

use super::compiled::Results;
use super::drawing::Read;
use super::jet::Jet;
use super::truth::{Pose, Truth};

/// Operations of a group's closed form and of the equations that the truth evaluates, each of which rounds.
const OPERATIONS: f64 = 200.0;

/// A pose is off by what closes its joints to rounding, times κ, the condition of all equations. Its rates solve a
/// system whose slopes are off by as much: κ² of them. Second rates add the products of rates, once more κ of the
/// square of the largest rate.
pub(super) struct Off {
    pub of_order: [f64; 3],
    pub condition: f64,
}

impl Off {
    pub(super) fn of(pose: &Pose) -> Self {
        let unit = OPERATIONS * f64::EPSILON;
        let condition = pose.condition();
        let largest = |order: usize| {
            let all = pose.coordinates.iter().chain(&pose.inputs).map(|part| part.0[order].abs());
            all.fold(1.0, f64::max)
        };
        let [rate, second] = [1, 2].map(largest);
        let of_order = [
            unit * condition,
            unit * condition.powi(2) * rate,
            unit * condition.powi(2) * (second + condition * rate * rate),
        ];
        Self { of_order, condition }
    }
}

/// Every number that is known, by name, and by how much it may be off.
pub(super) type Expected = HashMap<String, (Vec<f64>, f64)>;

/// The motion of all pins and links.
pub(super) fn motion(truth: &Truth<'_>, pose: &Pose, off: &Off) -> Expected {
    let mut known = Expected::new();
    let drawing = truth.drawing;
    let moment = truth.moment(&pose.inputs, &pose.coordinates);
    let words = ["", "velocity of ", "acceleration of "];
    let mut add = |row: String, jet: Jet| {
        for order in 0..3 {
            known.insert(
                format!("{}{row}", words[order]),
                (vec![jet.0[order]], off.of_order[order]),
            );
        }
    };
    for (pin, named) in drawing.pins.iter().enumerate() {
        for (part, jet) in ["x", "y"].into_iter().zip(moment.pin(pin)) {
            add(format!("{}.{part}", named.name), jet);
        }
    }
    for (link, named) in drawing.links.iter().enumerate() {
        if !named.on.is_empty() {
            add(format!("{}.slide", named.name), moment.read(Read::Slide(link)));
        }
    }
    for (link, named) in drawing.links.iter().enumerate() {
        let Jet([angle, omega, alpha]) = moment.angle(link);
        let (sin, cos) = angle.sin_cos();
        let name = &named.name;
        known.insert(format!("{name}.angle"), (vec![cos, sin], off.of_order[0]));
        known.insert(format!("{name}.omega"), (vec![omega], off.of_order[1]));
        known.insert(format!("{name}.alpha"), (vec![alpha], off.of_order[2]));
    }
    known
}

/// The count of numbers that agree, and what does not.
pub(super) fn compared(found: &Results, known: &Expected) -> (usize, Vec<String>) {
    let (mut count, mut wrong) = (0, Vec::new());
    for (name, values) in found {
        let Some((expected, off)) = known.get(name) else {
            wrong.push(format!("`{name}` is not known"));
            continue;
        };
        if expected.len() != values.len() {
            wrong.push(format!("{name}: {values:?} in place of {expected:?}"));
            continue;
        }
        for (value, expected) in values.iter().zip(expected) {
            count += 1;
            // What is no number is off, too.
            let is_near = (value - expected).abs() <= *off;
            if !is_near {
                wrong.push(format!("{name}: {value} in place of {expected}, to {off:.1e}"));
            }
        }
    }
    wrong.sort();
    (count, wrong)
}
