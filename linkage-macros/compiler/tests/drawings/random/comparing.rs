//! The numbers of a compiled machine beside those of the truth.

use std::collections::HashMap;

use super::acting::{Acting, Ends, Friction};
use super::compiled::Results;
use super::drawing::{Drive, Read};
use super::efforts::Efforts;
use super::jet::Jet;
use super::truth::{Equation, Pose, Truth};

/// Operations of a group's closed form and of the equations that the truth evaluates, each of which rounds.
const OPERATIONS: f64 = 200.0;

/// A pose is off by what closes its joints to rounding, times κ, the condition of all equations. Its rates solve a
/// system whose slopes are off by as much: κ² of them. Accelerations add the products of rates, once more κ of the
/// square of the largest rate.
pub(super) struct Off {
    pub of_order: [f64; 3],
    pub condition: f64,
    /// The size of the equations' inverse, which takes forces to multipliers.
    pub inverse: f64,
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
        Self { of_order, condition, inverse: pose.inverse.norm() }
    }
}

/// Every number that is known, by name, and by how much it may be off.
pub(super) type Expected = HashMap<String, (Vec<f64>, f64)>;

/// The reaction where the link carries all that is put on its pin.
const CARRIED: &str = " if the link carries what is put on the pin";

/// The motion of all pins and links.
pub(super) fn motion(truth: &Truth<'_>, pose: &Pose, off: &Off) -> Expected {
    let mut known = Expected::new();
    let drawing = truth.drawing;
    let moment = truth.moment(&pose.inputs, &pose.coordinates);
    let words = ["", "velocity of ", "acceleration of "];
    let mut add = |row: String, jet: Jet| {
        let rows = words.iter().zip(jet.0).zip(off.of_order);
        known.extend(rows.map(|((word, part), off)| (format!("{word}{row}"), (vec![part], off))));
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

/// All efforts and reactions. Multipliers solve the system of the rates, whose right side has the accelerations, each
/// times a mass, and friction adds to what is off.
pub(super) fn efforts(
    truth: &Truth<'_>,
    acting: &Acting,
    efforts: &Efforts,
    off: &Off,
) -> Expected {
    let unit = off.of_order[0] * off.condition;
    let by_masses = off.of_order[2] * efforts.mass.max(1.0);
    let off_force = efforts.magnified * off.inverse * (by_masses + unit * efforts.largest);
    let known = [
        reactions(truth, efforts),
        of_drives(truth, efforts),
        of_statements(acting, efforts),
        of_friction(truth, acting, efforts),
    ];
    known.into_iter().flatten().map(|(name, value)| (name, (vec![value], off_force))).collect()
}

type Named = Vec<(String, f64)>;

fn reactions(truth: &Truth<'_>, efforts: &Efforts) -> Named {
    let drawing = truth.drawing;
    let all = || truth.equations.iter().zip(&efforts.multipliers);
    let others = |at: usize, besides: usize, along: usize| -> f64 {
        let is_other = |equation: &Equation| matches!(*equation, Equation::Pin { link, pin, axis } if (pin, axis) == (at, along) && link != besides);
        all().filter(|(equation, _)| is_other(equation)).map(|(_, value)| value).sum()
    };
    let mut known = Named::new();
    for (equation, value) in all() {
        match *equation {
            Equation::Pin { link, pin, axis } => {
                let names = [&drawing.links[link].name, &drawing.pins[pin].name];
                let name = format!("{}.{}.{}", names[0], names[1], ["x", "y"][axis]);
                known.push((format!("{name}{CARRIED}"), -others(pin, link, axis)));
                known.push((name, *value));
            }
            Equation::Beside { link, guide, .. } | Equation::Parallel { link, guide, .. } => {
                let names = [&drawing.links[link].name, &drawing.guides[guide].name];
                let is_force = matches!(equation, Equation::Beside { .. });
                let part = if is_force { "normal" } else { "couple" };
                known.push((format!("{}.{}.{part}", names[0], names[1]), *value));
            }
            Equation::Drive(drive) => {
                let Drive { driven, value: read, .. } = &drawing.drives[drive];
                if let Read::Angle(link) | Read::Slide(link) = *driven {
                    known.push((format!("{}.drive", drawing.links[link].name), *value));
                }
                // A gear that is read the other way round drives what its statement reads: both do no work together.
                let drives = |link: usize| {
                    let mut of = drawing.drives.iter();
                    of.any(|drive| matches!(drive.driven, Read::Angle(own) | Read::Slide(own) if own == link))
                };
                if let Read::Angle(link) = read.of
                    && !drives(link)
                {
                    let value = -read.factor * value;
                    known.push((format!("{}.drive", drawing.links[link].name), value));
                }
            }
        }
    }
    known
}

fn of_drives(truth: &Truth<'_>, efforts: &Efforts) -> Named {
    let drawing = truth.drawing;
    let inputs = drawing.inputs.iter().zip(&efforts.inputs);
    let mut known: Named =
        inputs.map(|(input, value)| (format!("{}.drive", input.name), *value)).collect();
    for link in &drawing.links {
        let Some(length) = link.length.filter(|length| length.factor != 0.0) else { continue };
        let Read::Input(input) = length.of else { continue };
        known.push((format!("{}.push", link.name), efforts.inputs[input] / length.factor));
    }
    known
}

fn of_statements(acting: &Acting, efforts: &Efforts) -> Named {
    let mut known = vec![
        ("losses".to_string(), efforts.losses),
        ("kinetic energy".to_string(), efforts.energy[0]),
        ("potential energy".to_string(), efforts.energy[1]),
    ];
    for (nth, value) in efforts.springs.iter().enumerate() {
        let is_force = matches!(acting.springs[nth].ends, Ends::Pins(_));
        let kind = if is_force { "force" } else { "torque" };
        known.push((format!("spring{nth}.{kind}"), *value));
    }
    for (nth, [value, gap]) in efforts.stops.iter().enumerate() {
        known.push((format!("stop{nth}.force"), *value));
        known.push((format!("stop{nth}.gap"), *gap));
    }
    known
}

fn of_friction(truth: &Truth<'_>, acting: &Acting, efforts: &Efforts) -> Named {
    let drawing = truth.drawing;
    let mut known = Named::new();
    for (friction, value) in acting.frictions.iter().zip(&efforts.frictions) {
        match *friction {
            Friction::Pin { pin, .. } => {
                for (link, sign) in truth.rubbing_links(pin).into_iter().zip([1.0, -1.0]) {
                    let Some(link) = link else { continue };
                    let names = [&drawing.links[link].name, &drawing.pins[pin].name];
                    known.push((format!("{}.{}.friction", names[0], names[1]), sign * value));
                }
            }
            Friction::Guide { link, .. } => {
                let of = &drawing.links[link];
                let guide = &drawing.guides[of.on[0]].name;
                known.push((format!("{}.{guide}.friction", of.name), *value));
            }
        }
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
            // A value that is no number is off, too.
            let is_near = |expected: &f64| (value - expected).abs() <= *off;
            // A load on a pin that joins links is carried by one of them, which statements do not name.
            let carried = known.get(&format!("{name}{CARRIED}"));
            if !is_near(expected) && !carried.is_some_and(|(carried, _)| is_near(&carried[0])) {
                wrong.push(format!("{name}: {value} in place of {expected}, to {off:.1e}"));
            }
        }
    }
    wrong.sort();
    (count, wrong)
}
