//! Loads on links, pins and driven points except for those of joints: weight, inertia, applied forces.

use std::collections::HashMap;

use crate::equations::forces::elastic;
use crate::equations::forces::provided::{Line, not_negative};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Frame, PointMotion};
use crate::equations::reactions::Acting;
use crate::equations::symbol::{Sym, Vector};
use crate::model::acting::{Axes, Force, MassPlace};
use crate::model::mechanism::{Body, Carrier, LinkId, Mechanism, PointId, Scalar};

/// The masses of a link that are fixed in it, summed up: Σm, Σm x, Σm y, Σ(J + m r²) about its origin.
#[derive(Clone, Copy)]
pub(super) struct Inertia<'s> {
    pub mass: Sym<'s>,
    pub first: [Sym<'s>; 2],
    pub second: Sym<'s>,
}

/// A mass that moves in its link: where it is, and how far along the link's axes.
pub(super) struct Moving<'s> {
    pub link: LinkId,
    pub mass: Sym<'s>,
    pub inertia: Sym<'s>,
    pub at: [Jet<'s>; 2],
    pub motion: PointMotion<'s>,
    /// The point it is on, or the coordinates it was given.
    pub place: MovingPlace,
}

pub(super) enum MovingPlace {
    Point(PointId),
    At([Scalar; 2]),
}

/// All masses, by what they belong to.
pub(super) struct Masses<'s> {
    pub links: HashMap<LinkId, Inertia<'s>>,
    pub points: Vec<(PointId, Sym<'s>)>,
    pub moving: Vec<Moving<'s>>,
}

impl<'s> Masses<'s> {
    pub(super) fn of(kinematics: &Kinematics<'s>) -> Self {
        let mut masses = Self { links: HashMap::new(), points: Vec::new(), moving: Vec::new() };
        let zero = kinematics.builder.zero();
        for declared in &kinematics.mechanism.dynamics.masses {
            let mechanism = kinematics.mechanism;
            let group = match &declared.place {
                MassPlace::Pin(point) => mechanism.group_of(*point),
                MassPlace::Point(link, _)
                | MassPlace::At(link, _)
                | MassPlace::Uniform(link, _) => mechanism.links[link.index()].made_by.0,
            };
            let mass = not_negative(kinematics, &declared.mass, group);
            let mut inertia = not_negative(kinematics, &declared.inertia, group);
            // Not their rates, which are zero at rest, tell whether coordinates are driven.
            let (link, at, place) = match &declared.place {
                MassPlace::Pin(point) => {
                    masses.points.push((*point, mass));
                    continue;
                }
                MassPlace::Point(link, point) => (
                    *link,
                    kinematics.coordinates(Carrier::Link(*link), *point),
                    (mechanism.coordinates_move(Carrier::Link(*link), *point) != [false; 2])
                        .then_some(MovingPlace::Point(*point)),
                ),
                MassPlace::At(link, at) => {
                    let moves = at.iter().any(|x| mechanism.moves(x));
                    (*link, kinematics.jets(at), moves.then(|| MovingPlace::At(at.clone())))
                }
                MassPlace::Uniform(link, length) => {
                    // J = m l²/12 about the centre.
                    let length = kinematics.jet(length).value;
                    let twelve = kinematics.builder.integer(12);
                    inertia = mass * length.squared() / twelve;
                    (*link, [length.half(), zero].map(Jet::constant), None)
                }
            };
            match place {
                Some(place) => {
                    let motion = kinematics.link(link).frame.place(at[0], at[1]);
                    masses.moving.push(Moving { link, mass, inertia, at, motion, place });
                }
                None => masses.add(link, mass, inertia, at.map(|x| x.value)),
            }
        }
        masses
    }

    fn add(&mut self, link: LinkId, mass: Sym<'s>, inertia: Sym<'s>, [x, y]: [Sym<'s>; 2]) {
        let zero = mass.builder().zero();
        let empty = Inertia { mass: zero, first: [zero; 2], second: zero };
        let sum = self.links.entry(link).or_insert(empty);
        sum.mass = sum.mass + mass;
        sum.first = [sum.first[0] + mass * x, sum.first[1] + mass * y];
        sum.second = sum.second + (inertia + mass * (x.squared() + y.squared()));
    }

    /// The links that have mass, in the order of declaration.
    pub(super) fn by_link(&self) -> Vec<(LinkId, Inertia<'s>)> {
        let mut links: Vec<_> =
            self.links.iter().map(|(&link, &inertia)| (link, inertia)).collect();
        links.sort_by_key(|(link, _)| *link);
        links
    }
}

/// The centre of a link's masses against a vector of the link: Σm r = along·vector + across·vector⊥.
#[derive(Clone, Copy)]
pub(super) struct Centre<'s> {
    pub vector: Vector<'s>,
    pub along: Sym<'s>,
    pub across: Sym<'s>,
    /// The pin at the end of the vector, of a bar of constant length.
    pub pin: Option<PointId>,
}

impl<'s> Centre<'s> {
    /// A bar of constant length is measured by its own vector, everything else by its direction.
    pub(super) fn of(kinematics: &Kinematics<'s>, link: LinkId, inertia: Inertia<'s>) -> Self {
        let [x, y] = inertia.first;
        match kinematics.bar(link).filter(|(_, length, _)| length.is_fixed()) {
            Some((vector, length, pin)) => {
                let (along, across) = (x / length.value, y / length.value);
                Self { vector, along, across, pin: Some(pin) }
            }
            None => {
                let vector = kinematics.link(link).frame.direction.u;
                Self { vector, along: x, across: y, pin: None }
            }
        }
    }

    /// Σm r
    pub(super) fn first_moment(self) -> Vector<'s> {
        self.along * self.vector + self.across * self.vector.normal()
    }

    /// Σm r × w
    pub(super) fn cross(self, w: Vector<'s>) -> Sym<'s> {
        let r = self.vector;
        match w.x.is_constant() && w.y.is_constant() {
            // Constants are multiplied while compiling.
            true => r.cross(self.along * w) - r.dot(self.across * w),
            false => self.along * r.cross(w) - self.across * r.dot(w),
        }
    }
}

/// Gravity in ground axes.
pub(super) fn gravity<'s>(kinematics: &Kinematics<'s>) -> Vector<'s> {
    match &kinematics.mechanism.dynamics.gravity {
        Some(at) => {
            let [x, y] = kinematics.jets(at);
            Vector { x: x.value, y: y.value }
        }
        None => kinematics.builder.zero_vector(),
    }
}

/// Weight and inertia of a link's fixed masses, about its origin.
pub(super) fn of_masses<'s>(
    kinematics: &Kinematics<'s>,
    link: LinkId,
    inertia: Inertia<'s>,
    g: Vector<'s>,
) -> Acting<'s> {
    let Frame { origin, direction } = kinematics.link(link).frame;
    let centre = Centre::of(kinematics, link, inertia);
    let moment = centre.cross(g - origin.acceleration) - inertia.second * direction.alpha;
    let pulled = match centre.pin.filter(|_| centre.across.is_zero()) {
        Some(pin) => between(
            inertia.mass,
            centre.along,
            [origin.acceleration, kinematics.point(pin).acceleration],
        ),
        None => {
            let first = centre.first_moment();
            inertia.mass * origin.acceleration
                + (direction.alpha * first.normal() - direction.omega.squared() * first)
        }
    };
    Acting { force: inertia.mass * g - pulled, moment }
}

/// Σm a_G of a centre on the line of two joints: a_G = a_O + z (a_C − a_O), z the share of the pin.
fn between<'s>(mass: Sym<'s>, at_pin: Sym<'s>, [a_o, a_c]: [Vector<'s>; 2]) -> Vector<'s> {
    let at_origin = mass - at_pin;
    if at_origin.id == at_pin.id {
        return at_pin * (a_o + a_c);
    }
    at_origin * a_o + at_pin * a_c
}

/// A force that the declaration puts on a point, and the point.
pub(super) fn applied<'s>(kinematics: &Kinematics<'s>) -> Vec<(PointId, Vector<'s>)> {
    let mut elastic = elastic::EVERY.iter().map(|kind| (kind.forces)(kinematics));
    // Springs come first on the builder, and behind these in the list.
    let springs = elastic.next();
    let declared = declared(kinematics).into_iter();
    declared.chain(springs.into_iter().chain(elastic).flatten()).collect()
}

/// The same of the statements `force` alone.
pub(super) fn declared<'s>(kinematics: &Kinematics<'s>) -> Vec<(PointId, Vector<'s>)> {
    declared_by(kinematics, &|value| kinematics.jet(value).value)
}

/// The same with these numbers for their values.
pub(super) fn declared_by<'s>(
    kinematics: &Kinematics<'s>,
    number: &dyn Fn(&Scalar) -> Sym<'s>,
) -> Vec<(PointId, Vector<'s>)> {
    let forces = kinematics.mechanism.dynamics.forces.iter().enumerate();
    let forces = forces.flat_map(|(index, force)| match force {
        Force::At { point, value, axes } => {
            let [x, y] = value.each_ref().map(number);
            let force = match axes {
                Axes::Body(Carrier::Ground) => Vector { x, y },
                Axes::Body(carrier) => kinematics.carrier(*carrier).vector(x, y),
                Axes::Guide(guide) => kinematics.guide(*guide).vector(x, y),
            };
            vec![(*point, force)]
        }
        Force::Between { points, value } => {
            let value = number(value);
            let line =
                Line::between(kinematics, *points, kinematics.mechanism.title_of_force(index));
            let push = (value * line.inverse) * line.vector;
            vec![(points[0], -push), (points[1], push)]
        }
    });
    forces.collect()
}

/// A couple that the declaration puts on a body, and the body.
pub(super) fn torques<'s>(kinematics: &Kinematics<'s>) -> Vec<(Carrier, Sym<'s>)> {
    // As of forces.
    let elastic = elastic::EVERY.map(|kind| (kind.couples)(kinematics)).concat();
    let torques = torques_by(kinematics.mechanism, &|value| kinematics.jet(value).value);
    torques.into_iter().chain(elastic).collect()
}

/// The couples of the statements `torque` alone, with these numbers for their values.
pub(super) fn torques_by<'s>(
    mechanism: &Mechanism,
    number: &dyn Fn(&Scalar) -> Sym<'s>,
) -> Vec<(Carrier, Sym<'s>)> {
    let torques = mechanism.dynamics.torques.iter().flat_map(|torque| {
        let value = number(&torque.value);
        [Some((torque.on, value)), torque.against.map(|against| (against, -value))]
    });
    torques.flatten().collect()
}

/// Body of a point. A point without a step belongs to the ground.
pub(super) fn owner(kinematics: &Kinematics<'_>, point: PointId) -> Body {
    kinematics.mechanism.owner(point).unwrap_or(Body::Ground)
}
