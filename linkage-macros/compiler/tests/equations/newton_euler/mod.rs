//! The full matrix: Newton's and Euler's equations of every rigid part, with every joint force and
//! every drive unknown, in a hundred digits. It knows nothing of groups, of the order in which they
//! are solved, or of moments about joints; what it shares with the formulas is the motion.

pub(crate) mod acting;
pub(crate) mod carried;
pub(crate) mod declared;
pub(crate) mod friction;
pub(crate) mod joints;
pub(crate) mod matrix;
pub(crate) mod readings;
pub(crate) mod stops;
pub(crate) mod transmission;

use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::Vector;
use crate::exact::Exact;
use crate::ir::graph::Id;
use crate::ir::interpret::Number;
use crate::model::mechanism::{
    Body, Carrier, GuideId, LinkId, Mechanism, PointId, Scalar, Step, UnknownId,
};
use crate::oracle::Digits;
pub(super) use matrix::Matrix;
use readings::readings;

/// A vector of two nodes, or of their values.
pub(super) type Pair<T> = [T; 2];

/// A rigid part: a link, the rod of a link whose length is driven, a pin; or what another body carries
/// and a dimension moves there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Part {
    Ground,
    Link(LinkId),
    Rod(LinkId),
    Pin(PointId),
    Guide(GuideId),
    /// The slot of this block.
    Slot(LinkId),
    /// A point that moves in its link.
    Held(PointId),
    /// A mass at a place that moves in its link, by its index.
    Mass(usize),
    /// No part: where an unknown stands, nothing drives.
    Sought(UnknownId),
}

/// External load on a part: a force at a point and a couple.
pub(super) struct Applied<T> {
    part: Part,
    pub at: Pair<T>,
    pub force: Pair<T>,
    pub couple: T,
    /// For virtual power: how the point moves, and the body.
    pub velocity: Pair<T>,
    pub omega: T,
}

impl Applied<Digits> {
    /// The power of the load where its part moves as in the other.
    pub(super) fn power_at(&self, unit: &Self) -> Digits {
        let [x, y] = [0, 1].map(|axis| self.force[axis].mul(&unit.velocity[axis]));
        x.add(&y).add(&self.couple.mul(&unit.omega))
    }
}

/// The motion, as nodes of the graph or as numbers.
pub(super) struct Motion<T> {
    points: Vec<Pair<T>>,
    origins: Vec<Pair<T>>,
    directions: Vec<Pair<T>>,
    slides: Vec<Option<T>>,
    guides: Vec<(Pair<T>, Pair<T>)>,
    pub applied: Vec<Applied<T>>,
}

fn ids(vector: Vector<'_>) -> Pair<Id> {
    [vector.x.id, vector.y.id]
}

impl Motion<Id> {
    /// The state's nodes, and all that acts on it, each mass for itself at its own centre.
    pub(super) fn of(kinematics: &Kinematics<'_>) -> Self {
        let mechanism = kinematics.mechanism;
        let points = (0..mechanism.points.len() as u32).map(PointId);
        let links: Vec<_> = (0..mechanism.links.len() as u32).map(LinkId).collect();
        let guides = (0..mechanism.guides.len() as u32).map(GuideId);
        let frame = |link: &LinkId| kinematics.link(*link).frame;
        Self {
            points: points.map(|point| ids(kinematics.point(point).position())).collect(),
            origins: links.iter().map(|link| ids(frame(link).origin.position())).collect(),
            directions: links.iter().map(|link| ids(frame(link).direction.u)).collect(),
            slides: links
                .iter()
                .map(|link| kinematics.link(*link).slide.map(|slide| slide.value.id))
                .collect(),
            guides: guides
                .map(|guide| kinematics.guide(guide))
                .map(|frame| (ids(frame.origin.position()), ids(frame.direction.u)))
                .collect(),
            applied: acting::acting(kinematics),
        }
    }

    pub(super) fn values(&self, values: &[Digits]) -> Motion<Digits> {
        let one = |id: &Id| values[id.index()].clone();
        let two = |pair: &Pair<Id>| [one(&pair[0]), one(&pair[1])];
        Motion {
            points: self.points.iter().map(two).collect(),
            origins: self.origins.iter().map(two).collect(),
            directions: self.directions.iter().map(two).collect(),
            slides: self.slides.iter().map(|slide| slide.as_ref().map(one)).collect(),
            guides: self.guides.iter().map(|(k, u)| (two(k), two(u))).collect(),
            applied: (self.applied.iter())
                .map(|applied| Applied {
                    part: applied.part,
                    at: two(&applied.at),
                    force: two(&applied.force),
                    couple: one(&applied.couple),
                    velocity: two(&applied.velocity),
                    omega: one(&applied.omega),
                })
                .collect(),
        }
    }
}

/// Part that carries a load: the rod if the load moves along a link of driven length. The link carries it
/// if the length depends on other links: the load then moves another way than the pin.
fn part(mechanism: &Mechanism, link: LinkId, moves: bool) -> Part {
    match moves && driven_length(mechanism, link).is_some_and(|l| !has_readings(mechanism, l)) {
        true => Part::Rod(link),
        false => Part::Link(link),
    }
}

fn driven_length(mechanism: &Mechanism, link: LinkId) -> Option<&Scalar> {
    let length = mechanism.group_steps().find_map(|group| {
        let place = group.links.iter().position(|own| *own == link)?;
        group.lengths[place].as_ref()
    });
    length.map(|length| &length.value).filter(|length| mechanism.moves(length))
}

fn has_readings(mechanism: &Mechanism, length: &Scalar) -> bool {
    let mut leaves = Vec::new();
    readings(mechanism, length, &mut leaves);
    !leaves.is_empty()
}

/// The part that a point of a link is fixed to.
fn part_of_point(kinematics: &Kinematics<'_>, carrier: Carrier, point: PointId) -> Part {
    match carrier {
        Carrier::Ground => Part::Ground,
        Carrier::Link(_) if held_point(kinematics.mechanism, point) => Part::Held(point),
        Carrier::Link(link) => {
            let moves = kinematics.mechanism.coordinates_move(carrier, point)[0];
            let is_pin = kinematics.bar(link).is_some_and(|(_, _, pin)| pin == point);
            match is_pin && moves {
                true => Part::Rod(link),
                false => part(kinematics.mechanism, link, moves),
            }
        }
    }
}

/// True if the point is a place in its link, and moves there.
fn held_point(mechanism: &Mechanism, point: PointId) -> bool {
    mechanism.steps.iter().any(|step| match step {
        Step::Point { point: made, carrier: carrier @ Carrier::Link(_), .. } => {
            *made == point && mechanism.coordinates_move(*carrier, point) != [false; 2]
        }
        _ => false,
    })
}

fn is_moving(mechanism: &Mechanism, place: &[Scalar; 2]) -> bool {
    place.iter().any(|coordinate| mechanism.moves(coordinate))
}

fn part_of(kinematics: &Kinematics<'_>, point: PointId) -> Part {
    match kinematics.mechanism.owner(point).expect("every point has a step") {
        Body::Ground => Part::Ground,
        Body::Link(link) => part_of_point(kinematics, Carrier::Link(link), point),
        Body::Pin(point) => Part::Pin(point),
    }
}

fn part_of_carrier(carrier: Carrier) -> Part {
    match carrier {
        Carrier::Ground => Part::Ground,
        Carrier::Link(link) => Part::Link(link),
    }
}

fn whole(n: i64) -> Digits {
    Digits::exact(&Exact::integer(n))
}

fn cross(a: &Pair<Digits>, b: &Pair<Digits>) -> Digits {
    a[0].mul(&b[1]).sub(&a[1].mul(&b[0]))
}

fn negative(a: &Pair<Digits>) -> Pair<Digits> {
    [a[0].neg(), a[1].neg()]
}

fn normal(u: &Pair<Digits>) -> Pair<Digits> {
    [u[1].neg(), u[0].clone()]
}
