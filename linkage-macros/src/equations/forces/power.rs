//! The effort of an input alone, from the power of all that acts, without any reaction.
//!
//! With c = ∂r/∂q and k = ∂φ/∂q, the velocities at a unit rate of the input:
//!
//! ```text
//! τ = −Σ (F·c + M k)      F, M: applied, weight and inertia
//! ```
//!
//! Of a single input everything about the motion is in c and c′ = dc/dq, of q alone, so that every
//! constant rate folds (Eksergian's equation):
//!
//! ```text
//! τ = M q̈ + ½M′ q̇² − Q      M = Σ m c·c + J k²      ½M′ = Σ m c·c′ + J k k′
//! ```
//!
//! About the origin O of a link, with S = Σm r of its masses fixed in it:
//!
//! ```text
//! M   ∋ m c_O·c_O + J_O k² + 2 k (c_O·S⊥)
//! ½M′ ∋ m c_O·c′_O + J_O k k′ + k′ (c_O·S⊥) − k² (c_O·S) + k (S × c′_O)
//! ```
//!
//! and where O swings about a fixed pivot at the distance ρ, c_O·c_O = ρ² κ² and c_O·c′_O = ρ² κ κ′ of the
//! link that carries it, which join its own inertia in one constant.

use std::collections::HashMap;

use crate::equations::forces::at_unit_rate;
use crate::equations::forces::loads::{
    Centre, Inertia, Masses, applied, gravity, of_masses, torques,
};
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Id;
use crate::model::dynamics::Owner;
use crate::model::mechanism::{Carrier, InputId, LinkId, Mechanism, PointId, Step};

/// The efforts of these inputs.
pub(super) fn efforts(kinematics: &Kinematics<'_>, inputs: &[InputId]) -> Vec<Id> {
    let effort = |input: &InputId| {
        let unit = at_unit_rate(kinematics, input.index());
        match kinematics.inputs.len() {
            1 => of_the_only_input(kinematics, &unit).id,
            _ => of_one_among_several(kinematics, &unit).id,
        }
    };
    inputs.iter().map(effort).collect()
}

/// −(the power of all that acts), at the unit rate.
fn of_one_among_several<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let (masses, g) = (Masses::of(kinematics), gravity(kinematics));
    let mut power = applied_power(kinematics, unit);
    for (link, inertia) in masses.by_link() {
        let own = of_masses(kinematics, link, inertia);
        let frame = unit.link(link).frame;
        power = power + own.force.dot(frame.origin.velocity) + own.moment * frame.direction.omega;
    }
    for &(point, mass) in &masses.points {
        let force = mass * (g - kinematics.point(point).acceleration);
        power = power + force.dot(unit.point(point).velocity);
    }
    for (moving, at_unit) in masses.moving.iter().zip(Masses::of(unit).moving) {
        let force = moving.mass * (g - moving.motion.acceleration);
        let alpha = kinematics.link(moving.link).frame.direction.alpha;
        let k = unit.link(moving.link).frame.direction.omega;
        power = power + force.dot(at_unit.motion.velocity) - (moving.inertia * alpha) * k;
    }
    -power
}

/// The power of forces and torques, at the unit rate.
fn applied_power<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let mut power = kinematics.sheet.zero();
    for (point, force) in applied(kinematics) {
        power = power + force.dot(unit.point(point).velocity);
    }
    for (carrier, couple) in torques(kinematics) {
        power = power + couple * unit.carrier(carrier).direction.omega;
    }
    power
}

/// M, ½M′ and Q in the making.
struct Sum<'s> {
    mass: Sym<'s>,
    slope: Sym<'s>,
    force: Sym<'s>,
}

fn of_the_only_input<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let (masses, g) = (Masses::of(unit), gravity(unit));
    let zero = unit.sheet.zero();
    let mut sum = Sum { mass: zero, slope: zero, force: applied_power(unit, unit) };
    let pivots = Pivots::of(unit);
    let mut swinging: HashMap<LinkId, Sym<'s>> = HashMap::new();
    let mut swing = |link: LinkId, inertia: Sym<'s>| {
        let known = swinging.get(&link).copied().unwrap_or(zero);
        swinging.insert(link, known + inertia);
    };
    for &(point, mass) in &masses.points {
        let c = unit.point(point).velocity;
        sum.force = sum.force + (mass * g).dot(c);
        match pivots.swing(unit, point) {
            Some((link, square)) => swing(link, mass * square),
            None => sum.add_point(mass, c, unit.point(point).acceleration),
        }
    }
    for (link, inertia) in masses.by_link() {
        swing(link, inertia.second);
        match pivots.origins.get(&link).and_then(|&origin| pivots.swing(unit, origin)) {
            Some((carrier, square)) => swing(carrier, inertia.mass * square),
            None => {
                let origin = unit.link(link).frame.origin;
                sum.add_point(inertia.mass, origin.velocity, origin.acceleration);
            }
        }
        sum.add_link(unit, link, inertia, g);
    }
    for moving in &masses.moving {
        let direction = unit.link(moving.link).frame.direction;
        sum.force = sum.force + (moving.mass * g).dot(moving.motion.velocity);
        sum.add_point(moving.mass, moving.motion.velocity, moving.motion.acceleration);
        sum.add_turning(moving.inertia, direction.omega, direction.alpha);
    }
    let mut swinging: Vec<_> = swinging.into_iter().collect();
    swinging.sort_by_key(|(link, _)| *link);
    for (link, inertia) in swinging {
        let direction = unit.link(link).frame.direction;
        sum.add_turning(inertia, direction.omega, direction.alpha);
    }
    let jet = kinematics.inputs[0].jet;
    sum.mass * jet.accel + sum.slope * jet.rate.squared() - sum.force
}

impl<'s> Sum<'s> {
    /// m c·c and m c·c′
    fn add_point(&mut self, mass: Sym<'s>, c: Vector<'s>, slope: Vector<'s>) {
        self.mass = self.mass + mass * c.dot(c);
        self.slope = self.slope + mass * c.dot(slope);
    }

    /// J k² and J k k′
    fn add_turning(&mut self, inertia: Sym<'s>, k: Sym<'s>, slope: Sym<'s>) {
        self.mass = self.mass + inertia * k.squared();
        self.slope = self.slope + inertia * (slope * k);
    }

    /// Weight, and what the centre of a link's masses adds to that of its origin.
    fn add_link(
        &mut self,
        unit: &Kinematics<'s>,
        link: LinkId,
        inertia: Inertia<'s>,
        g: Vector<'s>,
    ) {
        let frame = unit.link(link).frame;
        let (c, slope) = (frame.origin.velocity, frame.origin.acceleration);
        let (k, k_slope) = (frame.direction.omega, frame.direction.alpha);
        let centre = Centre::of(unit, link, inertia);
        self.force = self.force + (inertia.mass * g).dot(c) + centre.cross(g) * k;
        // c·S⊥ = S × c, with S = along·r + across·r⊥.
        let Centre { vector: r, along, across, .. } = centre;
        let parts = [(along, r), (across, r.normal())];
        for (weight, r) in parts.into_iter().filter(|(weight, _)| !weight.is_zero()) {
            let moment = c.dot(r.normal());
            self.mass = self.mass + (weight * (k * moment)).twice();
            let slope = k_slope * moment - k.squared() * r.dot(c) + k * r.cross(slope);
            self.slope = self.slope + weight * slope;
        }
    }
}

/// Which points swing about a point of the ground.
struct Pivots {
    /// By link, the point at its origin.
    origins: HashMap<LinkId, PointId>,
    /// By inner pin, the links between whose joints it is.
    bars: HashMap<PointId, Vec<LinkId>>,
}

impl Pivots {
    fn of(unit: &Kinematics<'_>) -> Self {
        let mut pivots = Self { origins: HashMap::new(), bars: HashMap::new() };
        for step in &unit.mechanism.steps {
            pivots.add(step);
        }
        pivots
    }

    fn add(&mut self, step: &Step) {
        match step {
            Step::Crank { link, pivot, .. } => {
                self.origins.insert(*link, *pivot);
            }
            Step::Rrr { links, outer, pin, .. } => {
                self.origins.extend([(links[0], outer[0]), (links[1], outer[1])]);
                self.bars.insert(*pin, links.to_vec());
            }
            Step::Rrp { links, outer, pin, .. } => {
                self.origins.extend([(links[0], *outer), (links[1], *pin)]);
                self.bars.insert(*pin, vec![links[0]]);
            }
            Step::Rpr { links, outer, .. } => {
                self.origins.extend([(links[0], outer[0]), (links[1], outer[1])]);
            }
            Step::Prp { links, pin, .. } => {
                self.origins.extend(links.map(|link| (link, *pin)));
            }
            Step::Rpp { links, outer, .. } => {
                self.origins.insert(links[0], *outer);
            }
            Step::Ground { .. } | Step::Guide { .. } | Step::Point { .. } | Step::Slider { .. } => {
            }
        }
    }

    /// The link with a fixed origin that carries the point, and the square of the distance.
    fn swing<'s>(&self, unit: &Kinematics<'s>, point: PointId) -> Option<(LinkId, Sym<'s>)> {
        let mechanism: &Mechanism = unit.mechanism;
        let carriers = match mechanism.owner(point)? {
            Owner::Link(link) => vec![link],
            Owner::Point(pin) => self.bars.get(&pin)?.clone(),
            Owner::Ground => return None,
        };
        carriers.into_iter().find_map(|link| {
            let frame = unit.link(link).frame;
            let at = unit.coordinates(Carrier::Link(link), point);
            let swings = frame.origin.is_fixed() && at.iter().all(|x| x.is_fixed());
            swings.then(|| (link, at[0].value.squared() + at[1].value.squared()))
        })
    }
}
