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
//!   half of them next to a limit, without fused operations, and climbing from the worst of them
//!   to one worse still: the hill-climbed worst case (`worst_poses` of the laboratory, seed 1).
//!
//! The climb leads to poses whose data happen to matter little: joints on one axis, guides along
//! another, results whose terms cancel. They fix a direction better than a unit vector of the
//! width can hold, so a large factor there stands before a small error.

pub(crate) mod assembling;
pub mod by_input;
mod certified_steps;
mod clearance;
mod crank_pin;
mod dead_points;
mod double_word;
mod expressed;
pub mod forces;
pub mod functions;
mod groups;
mod guide;
pub mod jet;
pub mod kinematics;
pub(crate) mod marks;
mod motion;
mod operands;
mod parts;
pub(crate) mod placing;
mod point;
mod reactions;
pub mod slip_rounding;
pub mod symbol;
mod unknown;

use std::cell::OnceCell;

use proc_macro2::Ident;

use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::motion::Direction;
use crate::equations::symbol::GraphBuilder;
use crate::interface::Interface;
use crate::interface::entries::{Analysis, Entry};
use crate::interface::quantity::Order;
use crate::interface::records::is_margin;
use crate::ir::construct::Rule;
use crate::ir::graph::Id;
use crate::ir::program::{Clearance, Closure, EntryOutputs, Program};
use crate::model::mechanism::{DeclaredOutput, LinkId, Mechanism, OutputKind};

/// The mechanism's program: one graph with every entry point's values, made under the rules.
pub fn derive(mechanism: &Mechanism, rules: &[Rule]) -> Program {
    let builder = GraphBuilder::new(rules);
    let Collected { answers, clearances, closures } = asked(mechanism, &builder);
    Program {
        graph: builder.into_graph(),
        answers,
        clearances,
        closures,
        groups: mechanism.titles(),
    }
}

/// False if the load that drives an input is known to do no work on it in any pose, so that its value follows
/// from nothing.
pub fn load_does_work(mechanism: &Mechanism, rules: &[Rule]) -> bool {
    let Some((input, _)) = mechanism.dynamics.driven() else { return true };
    let builder = GraphBuilder::new(rules);
    let inputs = InputMotion::free(mechanism, &builder);
    let kinematics = Kinematics::of(&builder, mechanism, inputs);
    !forces::work_of_the_load(&kinematics, input).is_zero()
}

/// Answers, clearances and conditions requested of a mechanism's equations.
struct Collected {
    /// Values requested by each possible entry point of the mechanism, in order.
    answers: Vec<EntryOutputs>,
    clearances: Vec<Clearance>,
    /// The conditions of what is searched.
    closures: Vec<Closure>,
}

fn asked<'s>(mechanism: &'s Mechanism, builder: &'s GraphBuilder<'s>) -> Collected {
    let interface = Interface::of(mechanism);
    let bare = Bare::of(mechanism, builder, &interface);
    let made = OnceCell::new();
    let free = || {
        made.get_or_init(|| {
            Kinematics::of(builder, mechanism, InputMotion::free(mechanism, builder))
        })
    };
    let mut answers = Vec::new();
    for entry in &interface.entries {
        let at_cosine = bare.kinematics(entry);
        if entry.takes_cosine() && at_cosine.is_none() {
            continue;
        }
        // Where an angle's cosine and sine are enough, nobody asks for formulas of the angle itself; but
        // how clear of its limits a search is, is followed by the angle.
        let analysis = entry.point.analysis;
        let goes_by_cosine = entry.takes_cosine()
            || mechanism.unknowns.is_empty()
                && (analysis == Analysis::Coefficients || interface.of_cosine(entry).is_some());
        let kinematics = at_cosine.filter(|_| goes_by_cosine).unwrap_or_else(free);
        let needs_mass = entry.point.is_about_dynamics();
        let forward = analysis == Analysis::ForwardDynamics;
        let is_plain =
            mechanism.dynamics.frictions.is_empty() && mechanism.dynamics.driven().is_none();
        let is_known = is_plain || forward && forces::is_known_beside_friction(mechanism);
        if needs_mass && !(is_known && forces::every_input_moves_mass(kinematics)) {
            continue;
        }
        answers.push(EntryOutputs { entry: Some(entry.point), sinks: sinks(analysis, kinematics) });
    }
    let clearances = match mechanism.unknowns.is_empty() {
        true => clearance::of_pose(bare.motion().unwrap_or_else(free)),
        false => clearance::beside_unknowns(mechanism, builder),
    };
    let made = made.get().into_iter().chain(&bare.on_circle);
    let closures = made.flat_map(|kinematics| &kinematics.closures).copied().collect();
    Collected { answers, clearances, closures }
}

/// The numbers of a result, in the order of its shape.
fn sinks(analysis: Analysis, kinematics: &Kinematics<'_>) -> Vec<Id> {
    match analysis {
        Analysis::Position => components(kinematics, Order::Position),
        Analysis::Velocity => components(kinematics, Order::Velocity),
        Analysis::Motion => {
            Order::ALL.into_iter().flat_map(|order| components(kinematics, order)).collect()
        }
        Analysis::Coefficients => coefficients(kinematics),
        Analysis::Margins => margins(kinematics),
        Analysis::Forces => forces::in_motion(kinematics),
        Analysis::Statics => forces::at_rest(kinematics),
        Analysis::Holding => forces::holding(kinematics),
        Analysis::Energy => forces::energy(kinematics),
        Analysis::ForwardDynamics => forces::accelerations(kinematics),
        Analysis::EquationsOfMotion => forces::equations(kinematics),
    }
}

/// Results computable from the cosine and sine of the only input in place of its value.
struct Bare<'s> {
    on_circle: Option<Kinematics<'s>>,
    moves: bool,
    acts: bool,
}

impl<'s> Bare<'s> {
    fn of(mechanism: &'s Mechanism, builder: &'s GraphBuilder<'s>, interface: &Interface) -> Self {
        let is_one_angle = matches!(&mechanism.inputs[..], [only] if only.dimension.angle);
        let on_circle = is_one_angle
            .then(|| Kinematics::of(builder, mechanism, vec![InputMotion::on_the_circle(builder)]));
        let is_bare = |sinks: fn(&Kinematics<'_>) -> Vec<Id>| {
            on_circle.as_ref().is_some_and(|kinematics| !builder.reads_input(&sinks(kinematics)))
        };
        let asks_forces = interface.entries.iter().any(|entry| entry.point.is_about_forces());
        let moves = is_bare(motion_sinks);
        let acts = moves && asks_forces && is_bare(force_sinks);
        Self { on_circle, moves, acts }
    }

    /// Everything placed by a given cosine and sine, if motions have no other use for the input.
    fn motion(&self) -> Option<&Kinematics<'s>> {
        self.on_circle.as_ref().filter(|_| self.moves)
    }

    /// The same if the entry point's answer has no other use for the input: it occurs bare as an angle
    /// and nowhere else on the way there.
    fn kinematics(&self, entry: &Entry) -> Option<&Kinematics<'s>> {
        let is_bare = if entry.point.is_about_forces() { self.acts } else { self.moves };
        self.on_circle.as_ref().filter(|_| is_bare)
    }
}

fn motion_sinks(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let orders = [Order::Position, Order::Acceleration].into_iter();
    orders.flat_map(|order| components(kinematics, order)).collect()
}

fn force_sinks(kinematics: &Kinematics<'_>) -> Vec<Id> {
    [forces::in_motion(kinematics), forces::at_rest(kinematics), forces::energy(kinematics)]
        .concat()
}

/// The velocities at a unit rate of each input in turn, the others at rest.
fn coefficients(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let velocities = components(kinematics, Order::Velocity);
    let inputs = 0..kinematics.inputs.len() as u32;
    inputs.flat_map(|moving| kinematics.builder.at_unit_rate(&velocities, moving)).collect()
}

/// Margins, which exist also where the pose does not.
fn margins(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let outputs = kinematics.mechanism.outputs.iter().filter(|output| is_margin(output));
    outputs.map(|output| value(kinematics, output).value.id).collect()
}

/// The components of every output at one order, each output's in the order of its quantity's.
fn components(kinematics: &Kinematics<'_>, order: Order) -> Vec<Id> {
    let outputs = kinematics.mechanism.outputs.iter();
    outputs.flat_map(|output| components_of(kinematics, output, order)).collect()
}

fn components_of(kinematics: &Kinematics<'_>, output: &DeclaredOutput, order: Order) -> Vec<Id> {
    match &output.kind {
        OutputKind::Point(point) => {
            let point = kinematics.point(*point);
            let at = match order {
                Order::Position => point.position(),
                Order::Velocity => point.velocity,
                Order::Acceleration => point.acceleration,
            };
            vec![at.x.id, at.y.id]
        }
        OutputKind::Link { link, direction, slide } => {
            let turned = direction.then(|| of_direction(kinematics.direction(*link), order));
            let by = kinematics.mechanism.slides_by(*link);
            let slid = slide.then(|| of_jet(kinematics.slide(by), order));
            turned.into_iter().flatten().chain(slid).collect()
        }
        OutputKind::Angle(_) => of_direction(turn(kinematics, output), order),
        OutputKind::CentreOfMass => {
            let centre = forces::centre_of_mass(kinematics)[order as usize];
            vec![centre.x.id, centre.y.id]
        }
        OutputKind::Pole(links) => pole(kinematics, links).map(|along| of_jet(along, order)).into(),
        _ => vec![of_jet(value(kinematics, output), order)],
    }
}

/// A position is a unit vector, a rate the angle's.
fn of_direction(direction: Direction<'_>, order: Order) -> Vec<Id> {
    match order {
        Order::Position => vec![direction.u.x.id, direction.u.y.id],
        Order::Velocity => vec![direction.omega.id],
        Order::Acceleration => vec![direction.alpha.id],
    }
}

fn of_jet(jet: Jet<'_>, order: Order) -> Id {
    match order {
        Order::Position => jet.value.id,
        Order::Velocity => jet.rate.id,
        Order::Acceleration => jet.accel.id,
    }
}

/// The coordinates of a pole.
fn pole<'s>(kinematics: &Kinematics<'s>, links: &[(LinkId, Ident)]) -> [Jet<'s>; 2] {
    let mechanism = kinematics.mechanism;
    let ids: Vec<_> = links.iter().map(|&(link, _)| link).collect();
    kinematics.pole(&ids, mechanism.title_of_pole(links))
}

/// The links of the first pole that exists in no pose, because they never turn against each other.
pub(crate) fn pole_of_what_never_turns<'m>(
    mechanism: &'m Mechanism,
    rules: &[Rule],
) -> Option<&'m [(LinkId, Ident)]> {
    let mut poles = mechanism.poles().peekable();
    poles.peek()?;
    let builder = GraphBuilder::new(rules);
    let kinematics = Kinematics::of(&builder, mechanism, InputMotion::free(mechanism, &builder));
    let turning = |&(link, _): &(LinkId, Ident)| kinematics.link(link).frame.direction.omega;
    let never_turns = |links: &&[(LinkId, Ident)]| {
        let relative = match links.get(1) {
            Some(other) => turning(&links[0]) - turning(other),
            None => turning(&links[0]),
        };
        relative.is_zero()
    };
    poles.find(never_turns)
}

/// A named angle as a direction.
fn turn<'s>(kinematics: &Kinematics<'s>, output: &DeclaredOutput) -> Direction<'s> {
    let OutputKind::Angle(turn) = &output.kind else { unreachable!("only named angles come here") };
    kinematics.turned(Direction::ground(kinematics.builder), turn)
}

/// A numeric output.
fn value<'s>(kinematics: &Kinematics<'s>, output: &DeclaredOutput) -> Jet<'s> {
    let measures = |group| kinematics.measures_of(group).expect("the step saw that it is wanted");
    match &output.kind {
        OutputKind::Value { value, .. } => kinematics.jet(value),
        OutputKind::Ratio { value, .. } => kinematics.steady(value),
        OutputKind::Margin(group) => {
            measures(*group).margin.expect("the model checked that the group has a reach")
        }
        OutputKind::Transmission(group) => measures(*group).transmission,
        _ => unreachable!("points and links have components of their own"),
    }
}
