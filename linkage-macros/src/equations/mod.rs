//! The equations of motion of a mechanism's points, as an expression graph.
//!
//! One file per driver and group states position, velocity and acceleration on symbolic vectors,
//! under its derivation, its signs and its source. Velocity and acceleration come from the
//! group's own linear equations, not from differentiating the position. Formulas live here and
//! nowhere else; nothing here knows how code is written.
//!
//! # Errors
//! A file states its group's error against what the data allow: what half a unit in the last place
//! of every input, rate and dimension would change, added up, and half a unit of the result. It was
//! measured in f64 and in f32 between joints and guides that inputs put anywhere, the truth being
//! the same code on numbers of twice the width:
//!
//! - next to each limit, at 1e-1 to 1e-15 of the lengths from it, with and without fused
//!   operations (`tests/limits/near_limits.rs` holds these bounds);
//! - on ten million random poses a group and width, of lengths up to 100 : 1, of any place and size,
//!   half of them next to a limit, without fused operations, and from the worst of them uphill
//!   (`worst_poses` of the laboratory, seed 1).
//!
//! Uphill leads to poses whose data happen to matter little: joints on one axis, guides along
//! another, results whose terms cancel. They fix a direction better than a unit vector of the
//! width can hold, so a large factor there stands before a small error.

mod clearance;
mod crank;
mod double_word;
mod expressions;
mod groups;
mod guide;
mod jet;
mod kinematics;
mod motion;
mod point;
mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
mod slider;
mod symbol;
#[cfg(test)]
pub(crate) mod tests;

use crate::equations::jet::Jet;
use crate::equations::kinematics::{Kinematics, Source};
use crate::equations::motion::Direction;
use crate::equations::symbol::{Sheet, Vector};
use crate::ir::construct::Rule;
use crate::ir::graph::{Id, Node};
use crate::ir::liveness::{Course, live};
use crate::ir::program::{Entry, EntryKind, Program};
use crate::model::mechanism::{Mechanism, Output, OutputKind};

/// The mechanism's program: one graph with every entry point's values, made under the rules.
pub(crate) fn derive(mechanism: &Mechanism, rules: &[Rule]) -> Program {
    let sheet = Sheet::new(rules);
    let entries = entries(mechanism, &sheet, rules);
    let clearances = clearance::clearances(mechanism, &sheet);
    Program {
        graph: sheet.into_graph(),
        entries,
        clearances,
        groups: mechanism.groups.iter().map(|group| group.title.clone()).collect(),
    }
}

fn entries<'s>(mechanism: &'s Mechanism, sheet: &'s Sheet<'s>, rules: &[Rule]) -> Vec<Entry> {
    let given = Kinematics::of(sheet, mechanism, free_inputs(mechanism, sheet));
    let full = [EntryKind::Position, EntryKind::Velocity, EntryKind::Motion];
    let mut entries = Vec::from(motion_entries(&given, full));
    entries.push(coefficients(mechanism, sheet));
    if has_bare_angle(mechanism, rules) {
        let at = Kinematics::of(sheet, mechanism, vec![on_the_circle(sheet)]);
        entries.extend(motion_entries(
            &at,
            [EntryKind::PositionAt, EntryKind::VelocityAt, EntryKind::MotionAt],
        ));
    }
    if mechanism.outputs.iter().any(|output| is_quality(&output.kind)) {
        entries.push(margins(&given));
    }
    entries
}

/// Inputs whose value, rate and second rate are given.
fn free_inputs<'s>(mechanism: &Mechanism, sheet: &'s Sheet<'s>) -> Vec<Source<'s>> {
    (0..mechanism.inputs.len() as u32)
        .map(|input| {
            let order = |order| sheet.node(Node::Input { input, order });
            Source { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: None }
        })
        .collect()
}

/// The only input, its cosine and sine given in place of its value.
fn on_the_circle<'s>(sheet: &'s Sheet<'s>) -> Source<'s> {
    let order = |order| sheet.node(Node::Input { input: 0, order });
    let unit = Vector { x: sheet.node(Node::InputCos(0)), y: sheet.node(Node::InputSin(0)) };
    Source { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: Some(unit) }
}

/// Whether the only input occurs bare as an angle and nowhere else, so that its cosine and sine
/// can be given in its place: whether, given them, its value is needed nowhere.
fn has_bare_angle(mechanism: &Mechanism, rules: &[Rule]) -> bool {
    let [input] = &mechanism.inputs[..] else { return false };
    if !input.dimension.angle {
        return false;
    }
    let trial = Sheet::new(rules);
    let at = Kinematics::of(&trial, mechanism, vec![on_the_circle(&trial)]);
    let sinks: Vec<Id> = positions(&at).into_iter().chain(rates(&at, Order::Second)).collect();
    let graph = trial.into_graph();
    let live = live(&graph, &sinks, Course::Careful);
    !graph.iter().any(|(id, node)| live[id.index()] && matches!(node, Node::Input { order: 0, .. }))
}

fn motion_entries(kinematics: &Kinematics<'_>, kinds: [EntryKind; 3]) -> [Entry; 3] {
    let position = positions(kinematics);
    let velocity = rates(kinematics, Order::First);
    let acceleration = rates(kinematics, Order::Second);
    let motion = [&position[..], &velocity, &acceleration].concat();
    let [first, second, third] = kinds;
    [
        Entry { kind: first, sinks: position },
        Entry { kind: second, sinks: velocity },
        Entry { kind: third, sinks: motion },
    ]
}

/// The velocities at a unit rate of each input in turn, the others at rest.
fn coefficients<'s>(mechanism: &'s Mechanism, sheet: &'s Sheet<'s>) -> Entry {
    let zero = sheet.zero();
    let sinks = (0..mechanism.inputs.len()).flat_map(|moving| {
        let mut inputs = free_inputs(mechanism, sheet);
        for (index, source) in inputs.iter_mut().enumerate() {
            source.jet.rate = sheet.integer(i64::from(index == moving));
            source.jet.accel = zero;
        }
        rates(&Kinematics::of(sheet, mechanism, inputs), Order::First)
    });
    Entry { kind: EntryKind::Coefficients, sinks: sinks.collect() }
}

fn margins(kinematics: &Kinematics<'_>) -> Entry {
    let outputs = &kinematics.mechanism.outputs;
    let sinks = outputs
        .iter()
        .filter(|output| is_quality(&output.kind))
        .map(|output| value(kinematics, output).value.id)
        .collect();
    Entry { kind: EntryKind::Margins, sinks }
}

fn is_quality(kind: &OutputKind) -> bool {
    matches!(kind, OutputKind::Margin(_) | OutputKind::Transmission(_))
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    First,
    Second,
}

/// The components of every output's position.
fn positions(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let mut sinks = Vec::new();
    for output in &kinematics.mechanism.outputs {
        match &output.kind {
            OutputKind::Point(point) => {
                let position = kinematics.point(*point).position();
                sinks.extend([position.x.id, position.y.id]);
            }
            OutputKind::Link { link, direction, slide } => {
                let link = kinematics.link(*link);
                if *direction {
                    let u = link.frame.direction.u;
                    sinks.extend([u.x.id, u.y.id]);
                }
                if *slide {
                    sinks.extend(link.slide.map(|slide| slide.value.id));
                }
            }
            OutputKind::Turn(_) => {
                let u = turn(kinematics, output).u;
                sinks.extend([u.x.id, u.y.id]);
            }
            _ => sinks.push(value(kinematics, output).value.id),
        }
    }
    sinks
}

/// The components of every output's velocity or acceleration.
fn rates(kinematics: &Kinematics<'_>, order: Order) -> Vec<Id> {
    let of_direction = |direction: Direction<'_>| match order {
        Order::First => direction.omega.id,
        Order::Second => direction.alpha.id,
    };
    let of_jet = |jet: Jet<'_>| match order {
        Order::First => jet.rate.id,
        Order::Second => jet.accel.id,
    };
    let mut sinks = Vec::new();
    for output in &kinematics.mechanism.outputs {
        match &output.kind {
            OutputKind::Point(point) => {
                let point = kinematics.point(*point);
                let rate = match order {
                    Order::First => point.velocity,
                    Order::Second => point.acceleration,
                };
                sinks.extend([rate.x.id, rate.y.id]);
            }
            OutputKind::Link { link, direction, slide } => {
                let link = kinematics.link(*link);
                if *direction {
                    sinks.push(of_direction(link.frame.direction));
                }
                if *slide {
                    sinks.extend(link.slide.map(of_jet));
                }
            }
            OutputKind::Turn(_) => sinks.push(of_direction(turn(kinematics, output))),
            _ => sinks.push(of_jet(value(kinematics, output))),
        }
    }
    sinks
}

/// A named angle as a direction.
fn turn<'s>(kinematics: &Kinematics<'s>, output: &Output) -> Direction<'s> {
    let OutputKind::Turn(turn) = &output.kind else { unreachable!("only named angles come here") };
    kinematics.turned(Direction::ground(kinematics.sheet), turn)
}

/// A numeric output.
fn value<'s>(kinematics: &Kinematics<'s>, output: &Output) -> Jet<'s> {
    let quality = |group| kinematics.quality(group).expect("the step saw that it is wanted");
    match &output.kind {
        OutputKind::Value { value, .. } => kinematics.jet(value),
        OutputKind::Margin(group) => {
            quality(*group).margin.expect("the model checked that the group has a reach")
        }
        OutputKind::Transmission(group) => quality(*group).transmission,
        _ => unreachable!("points and links have components of their own"),
    }
}
