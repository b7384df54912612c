//! Masses reduced to what moves alike, and the forms that they make of motions.
//!
//! With c = ∂r/∂q and k = ∂φ/∂q of two states, the mass matrix is the bilinear form Σ m c·c + J k k; of
//! a state and itself it is M, or at the true rates twice the kinetic energy, and half its slope is
//! Σ m c·c′ + J k k′. About the origin O of a link, with S = Σm r of its masses fixed in it:
//!
//! ```text
//! M   ∋ m c_O·c_O + J_O k² + 2 k (c_O·S⊥)
//! ½M′ ∋ m c_O·c′_O + J_O k k′ + k′ (c_O·S⊥) − k² (c_O·S) + k (S × c′_O)
//! ```
//!
//! and where O swings about a fixed pivot at the distance ρ, c_O·c_O = ρ² κ² and c_O·c′_O = ρ² κ κ′ of the
//! link that carries it, which join its own inertia in one constant.

use std::collections::HashMap;

use crate::equations::forces::loads::{Centre, Inertia, Masses, gravity};
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::PointMotion;
use crate::equations::symbol::{Sym, Vector};
use crate::model::mechanism::{Body, Carrier, LinkId, Mechanism, PointId};

/// See the module's documentation.
pub(super) struct Reduced<'s> {
    /// Inertia that turns with each link: J_O, and m ρ² of the masses that swing on it.
    turning: Vec<(LinkId, Sym<'s>)>,
    /// Mass that moves with each point.
    moving: Vec<(CarriedPoint, Sym<'s>)>,
    /// Masses on pins, for their weight.
    points: Vec<(PointId, Sym<'s>)>,
    /// Masses fixed in links, for their centres.
    links: Vec<(LinkId, Inertia<'s>)>,
    /// The number of masses that move in their links.
    driven: usize,
}

#[derive(Clone, Copy)]
enum CarriedPoint {
    Point(PointId),
    Origin(LinkId),
}

impl CarriedPoint {
    fn motion<'s>(self, state: &Kinematics<'s>) -> PointMotion<'s> {
        match self {
            Self::Point(point) => state.point(point),
            Self::Origin(link) => state.link(link).frame.origin,
        }
    }
}

impl<'s> Reduced<'s> {
    pub(super) fn of(state: &Kinematics<'s>) -> Self {
        let (masses, pivots) = (Masses::of(state), Pivots::of(state));
        let mut moving = Vec::new();
        let mut turning: HashMap<LinkId, Sym<'s>> = HashMap::new();
        let mut turn = |link: LinkId, inertia: Sym<'s>| {
            let known = turning.get(&link).copied().unwrap_or(state.builder.zero());
            turning.insert(link, known + inertia);
        };
        for &(point, mass) in &masses.points {
            match pivots.swing(state, point) {
                Some((link, square)) => turn(link, mass * square),
                None => moving.push((CarriedPoint::Point(point), mass)),
            }
        }
        let links = masses.by_link();
        for &(link, inertia) in &links {
            turn(link, inertia.second);
            match pivots.origins.get(&link).and_then(|&origin| pivots.swing(state, origin)) {
                Some((carrier, square)) => turn(carrier, inertia.mass * square),
                None => moving.push((CarriedPoint::Origin(link), inertia.mass)),
            }
        }
        let mut turning: Vec<_> = turning.into_iter().collect();
        turning.sort_by_key(|(link, _)| *link);
        Self { turning, moving, points: masses.points, links, driven: masses.moving.len() }
    }

    /// Σ m c·c + J k k of two states.
    pub(super) fn inertia(&self, a: &Kinematics<'s>, b: &Kinematics<'s>) -> Sym<'s> {
        let of_points = self.at_points(a, b);
        self.turning_too(self.about_origins_too(of_points, a, b), a, b)
    }

    /// M of a state and itself, and its squares alone: without the terms about moving origins, which may
    /// take back what squares bring. M is at most 1 + √2 of them.
    pub(super) fn mass_and_size(&self, unit: &Kinematics<'s>) -> [Sym<'s>; 2] {
        let size = self.turning_too(self.at_points(unit, unit), unit, unit);
        [self.about_origins_too(size, unit, unit), size]
    }

    /// The number of terms of an entry of the mass matrix, at most.
    pub(super) fn terms(&self) -> usize {
        self.turning.len() + self.moving.len() + 2 * self.links.len() + 2 * self.driven
    }

    fn at_points(&self, a: &Kinematics<'s>, b: &Kinematics<'s>) -> Sym<'s> {
        let mut sum = a.builder.zero();
        for &(place, mass) in &self.moving {
            sum = sum + mass * place.motion(a).velocity.dot(place.motion(b).velocity);
        }
        sum
    }

    fn about_origins_too(
        &self,
        mut sum: Sym<'s>,
        a: &Kinematics<'s>,
        b: &Kinematics<'s>,
    ) -> Sym<'s> {
        for &(link, inertia) in &self.links {
            let [ka, kb] = [a, b].map(|state| state.link(link).frame.direction.omega);
            let [ca, cb] = [a, b].map(|state| state.link(link).frame.origin.velocity);
            for (weight, r) in parts(Centre::of(a, link, inertia)) {
                let [first, second] = [ka * cb.dot(r.normal()), kb * ca.dot(r.normal())];
                let both = match first.id == second.id {
                    true => (weight * first).twice(),
                    false => weight * (first + second),
                };
                sum = sum + both;
            }
        }
        sum
    }

    /// Adds the inertia that turns with each link and the masses that move in it.
    fn turning_too(&self, mut sum: Sym<'s>, a: &Kinematics<'s>, b: &Kinematics<'s>) -> Sym<'s> {
        let omegas = |link| [a, b].map(|state| state.link(link).frame.direction.omega);
        for (one, other) in Masses::of(a).moving.iter().zip(Masses::of(b).moving) {
            let [ka, kb] = omegas(one.link);
            sum = sum + one.mass * one.motion.velocity.dot(other.motion.velocity);
            sum = sum + one.inertia * (ka * kb);
        }
        for &(link, inertia) in &self.turning {
            let [ka, kb] = omegas(link);
            sum = sum + inertia * (ka * kb);
        }
        sum
    }

    /// Σ m c·c′ + J k k′ of a state at unit rate.
    pub(super) fn slope(&self, unit: &Kinematics<'s>) -> Sym<'s> {
        let mut sum = unit.builder.zero();
        for &(place, mass) in &self.moving {
            let motion = place.motion(unit);
            sum = sum + mass * motion.velocity.dot(motion.acceleration);
        }
        for &(link, inertia) in &self.links {
            let frame = unit.link(link).frame;
            let (c, slope) = (frame.origin.velocity, frame.origin.acceleration);
            let (k, k_slope) = (frame.direction.omega, frame.direction.alpha);
            for (weight, r) in parts(Centre::of(unit, link, inertia)) {
                let turned = k_slope * c.dot(r.normal()) - k.squared() * r.dot(c);
                sum = sum + weight * (turned + k * r.cross(slope));
            }
        }
        for moving in Masses::of(unit).moving {
            let direction = unit.link(moving.link).frame.direction;
            sum = sum + moving.mass * moving.motion.velocity.dot(moving.motion.acceleration);
            sum = sum + moving.inertia * (direction.alpha * direction.omega);
        }
        for &(link, inertia) in &self.turning {
            let direction = unit.link(link).frame.direction;
            sum = sum + inertia * (direction.alpha * direction.omega);
        }
        sum
    }

    /// The power of all weight.
    pub(super) fn power_of_weight(&self, unit: &Kinematics<'s>) -> Sym<'s> {
        let (g, mut sum) = (gravity(unit), unit.builder.zero());
        for &(point, mass) in &self.points {
            sum = sum + (mass * g).dot(unit.point(point).velocity);
        }
        for &(link, inertia) in &self.links {
            let frame = unit.link(link).frame;
            let turning = Centre::of(unit, link, inertia).cross(g) * frame.direction.omega;
            sum = sum + (inertia.mass * g).dot(frame.origin.velocity) + turning;
        }
        for moving in Masses::of(unit).moving {
            sum = sum + (moving.mass * g).dot(moving.motion.velocity);
        }
        sum
    }
}

/// Σm r as weights of two vectors across each other.
fn parts<'s>(centre: Centre<'s>) -> impl Iterator<Item = (Sym<'s>, Vector<'s>)> {
    let Centre { vector: r, along, across, .. } = centre;
    [(along, r), (across, r.normal())].into_iter().filter(|(weight, _)| !weight.is_zero())
}

/// Links and pins by which a point may swing about a point of the ground.
struct Pivots {
    /// By link, the point at its origin.
    origins: HashMap<LinkId, PointId>,
    /// By inner pin, the links between whose joints it is.
    bars: HashMap<PointId, Vec<LinkId>>,
}

impl Pivots {
    fn of(unit: &Kinematics<'_>) -> Self {
        let mut pivots = Self { origins: HashMap::new(), bars: HashMap::new() };
        for group in unit.mechanism.group_steps() {
            let origins = group.links.iter().filter_map(|&link| Some((link, group.origin(link)?)));
            pivots.origins.extend(origins);
            let bars = group.links.iter().zip(&group.lengths).filter(|(_, bar)| bar.is_some());
            pivots.bars.extend(group.pin.map(|pin| (pin, bars.map(|(&link, _)| link).collect())));
        }
        pivots
    }

    /// The link with a fixed origin that carries the point, and the square of the distance.
    fn swing<'s>(&self, unit: &Kinematics<'s>, point: PointId) -> Option<(LinkId, Sym<'s>)> {
        let mechanism: &Mechanism = unit.mechanism;
        let carriers = match mechanism.owner(point)? {
            Body::Link(link) => vec![link],
            Body::Pin(pin) => self.bars.get(&pin)?.clone(),
            Body::Ground => return None,
        };
        carriers.into_iter().find_map(|link| {
            let frame = unit.link(link).frame;
            let at = unit.coordinates(Carrier::Link(link), point);
            let swings = frame.origin.is_fixed() && at.iter().all(|x| x.is_fixed());
            swings.then(|| (link, at[0].value.squared() + at[1].value.squared()))
        })
    }
}
