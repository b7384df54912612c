//! Forces: what acts on every link, and what that asks of the drives and joints.
//!
//! # What acts
//! [`loads`] puts masses, weights, inertia and applied forces on the links, and [`elastic`] springs between their points
//! and between themselves, and what ends their motion. About a link's own outer joint O, at r = G − O fixed in the
//! link,
//!
//! ```text
//! M_O = r × m (g − a_O) − J_O α      J_O = J + m r²
//! F   = m (g − a_G)                  a_G = a_O + α r⊥ − ω² r
//! ```
//!
//! with neither ω² nor a_G in a moment. All masses of a link add up in Σm, Σm r and ΣJ_O.
//!
//! # Reactions
//! [`walk`] goes backwards over the steps: later groups stand only on earlier links, so each group is
//! complete when it is reached, states its reactions (its own file does), and puts their
//! opposites on what carries it. [`transmit`] does the same for a driven dimension that contains the
//! angle or slide of an earlier link: a gear, a rack. Where the walk comes to the equation of an unknown, it puts the push of
//! the bar or the block on it that holds the equation.
//!
//! # Slides of a drawing
//! [`drawn_slides`] tells what a group's guide exerts of the link that is drawn as sliding on it.
//!
//! # Friction
//! [`friction`] takes a share of each reaction, group by group on the way.
//!
//! # A load that drives
//! [`pull`] finds the load that puts in the effort of an input, before anything else is asked.
//!
//! # An effort alone
//! [`power`] takes it from the power of all that acts, without any reaction, on masses [`reduced`] to
//! what moves alike. [`together`] is what all masses do as one: energy, shaking, centre of mass.
//!
//! # From forces to motion
//! [`dynamics`] puts the same powers and the mass matrix into the equations of motion, and solves them.
//!
//! # Signs
//! Moments are counter-clockwise positive. A reaction acts on the link it is named after. A guide
//! exerts its normal force at the origin of the link's frame, and a couple. An effort is what the drive
//! exerts on the link; of an input, power put in over its rate.
//!
//! # Source
//! Norton, Design of Machinery, ch. 11 (dynamic force analysis, dyad by dyad) and ch. 10 (Eksergian's
//! equation); J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms.

mod drawn_slides;
mod dynamics;
pub(super) mod elastic;
mod friction;
mod loads;
mod power;
mod provided;
mod pull;
mod reduced;
mod together;
mod transmit;
mod unit_rate;
mod walk;

use std::collections::HashMap;

pub use crate::equations::forces::elastic::{springs, stops};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Id;
use crate::model::acting::Effort;
use crate::model::mechanism::{Carrier, LinkId, PointId, Scalar};

pub use dynamics::share_of_a_pivot;
pub use dynamics::{equations, every_input_moves_mass};
pub(super) use friction::is_offered as is_known_beside_friction;
pub use friction::{amounts_of, slip};
pub(super) use pull::work as work_of_the_load;
pub(super) use together::centre_of_mass;
use walk::Rubs;
pub use walk::Walk;

/// The forces that statements put on points.
pub(super) fn declared<'s>(kinematics: &Kinematics<'s>) -> Vec<(PointId, Vector<'s>)> {
    loads::declared(kinematics)
}

/// The couples that statements put on links.
pub(super) fn couples_on_links<'s>(kinematics: &Kinematics<'s>) -> Vec<(LinkId, Sym<'s>)> {
    let value = |value: &Scalar| kinematics.jet(value).value;
    let couples = loads::torques_by(kinematics.mechanism, &value).into_iter();
    let on_links = couples.filter_map(|(on, couple)| match on {
        Carrier::Link(link) => Some((link, couple)),
        Carrier::Ground => None,
    });
    on_links.collect()
}

/// Values of the entry point `forces`, in the order of the requests.
pub fn in_motion(kinematics: &Kinematics<'_>) -> Vec<Id> {
    if rubs_under_a_load(kinematics) {
        return friction::walked_by_load(kinematics, Rubs::Slipping, |walk, _| by_walk(walk));
    }
    match pull::driven(kinematics) {
        Some(driven) => efforts(&driven),
        None => efforts(kinematics),
    }
}

/// True if a load drives an input and joints rub, so that the load and friction follow from each other.
fn rubs_under_a_load(kinematics: &Kinematics<'_>) -> bool {
    let dynamics = &kinematics.mechanism.dynamics;
    dynamics.driven().is_some() && !dynamics.frictions.is_empty()
}

fn efforts(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let asked = || kinematics.mechanism.dynamics.asked.iter();
    if asked().next().is_none() {
        return Vec::new();
    }
    // The power of friction follows from reactions.
    if !kinematics.mechanism.dynamics.frictions.is_empty() {
        return by_walk(&Walk::of(kinematics));
    }
    let alone: Option<Vec<_>> = asked().map(|asked| alone(kinematics, asked.effort)).collect();
    match alone {
        Some(numbers) => numbers.concat().into_iter().map(|number: Sym<'_>| number.id).collect(),
        None => by_walk(&Walk::of(kinematics)),
    }
}

/// Values of an effort that needs no joint reaction; none for any other effort.
fn alone<'s>(kinematics: &Kinematics<'s>, effort: Effort) -> Option<Vec<Sym<'s>>> {
    let is_of_power = kinematics.mechanism.dynamics.is_of_power(effort);
    is_of_power.then(|| of_power(kinematics, effort))
}

fn of_power<'s>(kinematics: &Kinematics<'s>, effort: Effort) -> Vec<Sym<'s>> {
    match effort {
        Effort::Input(input) => vec![power::effort(kinematics, input)],
        Effort::Pull => vec![kinematics.value_of_pull()],
        Effort::Unknown(unknown) => vec![power::effort_at(kinematics, unknown)],
        Effort::Spring(spring) => vec![springs::effort(kinematics, spring.index())],
        Effort::Stop(stop) => vec![stops::effort(kinematics, stop.index())],
        Effort::Gap(stop) => vec![stops::gap(kinematics, stop.index())],
        Effort::Shaking => together::shaking(kinematics).into(),
        Effort::Formula(id) => {
            let formula = &kinematics.mechanism.dynamics.formulas[id.index()];
            let read = formula.reads.iter().map(|read| (*read, of_power(kinematics, *read)));
            let read: HashMap<_, _> = read.collect();
            let part = |effort, part: usize| read[&effort][part];
            vec![kinematics.jet_of(&formula.value, &part).value]
        }
        _ => unreachable!("a walk finds every other effort"),
    }
}

/// Kinetic and potential energy, where they are given.
pub fn energy(kinematics: &Kinematics<'_>) -> Vec<Id> {
    match kinematics.mechanism.dynamics.energy {
        true => together::energy(kinematics).map(|part| part.id).into(),
        false => Vec::new(),
    }
}

/// Values of the entry point `statics`: the same at rest, and friction against a creep.
pub(super) fn at_rest(kinematics: &Kinematics<'_>) -> Vec<Id> {
    if kinematics.mechanism.dynamics.asked.is_empty() {
        return Vec::new();
    }
    let inputs = InputMotion::at_rest(&kinematics.inputs, kinematics.builder);
    let resting = Kinematics::of(kinematics.builder, kinematics.mechanism, inputs);
    if !kinematics.mechanism.dynamics.frictions.is_empty() {
        let creep = InputMotion::without_second_rates(&kinematics.inputs, kinematics.builder);
        let creeping = Kinematics::of(kinematics.builder, kinematics.mechanism, creep);
        if rubs_under_a_load(kinematics) {
            let rubs = Rubs::Creeping(&creeping);
            return friction::walked_by_load(&resting, rubs, |walk, _| by_walk(walk));
        }
        return by_walk(&Walk::creeping(&resting, &creeping));
    }
    let resting = pull::driven(&resting).unwrap_or(resting);
    match kinematics.mechanism.unknowns.is_empty() {
        true => by_walk(&Walk::of(&resting)),
        // By power alone what holds an equation need not be known.
        false => efforts(&resting),
    }
}

/// The accelerations of the inputs under given drives.
pub fn accelerations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    match kinematics.mechanism.dynamics.frictions.is_empty() {
        true => dynamics::accelerations(kinematics),
        false => friction::accelerations(kinematics),
    }
}

/// The drives of the only input that creep backwards and forwards.
pub(super) fn holding(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let inputs = InputMotion::at_rest(&kinematics.inputs, builder);
    let resting = Kinematics::of(builder, mechanism, inputs);
    let drive = |way| {
        let creep = kinematics.inputs[0].with_rates(builder.integer(way), builder.zero());
        let creeping = Kinematics::of(builder, mechanism, vec![creep]);
        if rubs_under_a_load(kinematics) {
            let rubs = Rubs::Creeping(&creeping);
            return friction::walked_by_load(&resting, rubs, |_, load| load.id);
        }
        Walk::creeping(&resting, &creeping).input_efforts()[0].id
    };
    [-1, 1].map(drive).into()
}

fn by_walk(walk: &Walk<'_, '_>) -> Vec<Id> {
    let asked = walk.kinematics.mechanism.dynamics.asked.iter();
    asked.flat_map(|asked| walk.components(asked.effort)).map(|sym| sym.id).collect()
}
