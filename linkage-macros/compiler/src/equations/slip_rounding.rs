//! Bounds of the rounding of rates: a joint that turns by less than this is not known to turn.
//!
//! # Derivation
//! To first order. A number's bound is counted in units of u = 8 ε. Every file of a group states its errors against what
//! half a unit in the last place of every datum changes: on ten million random poses rates and accelerations
//! are within 15.1 such halves, 7.6 ε. So a group adds u of the size of each of its terms, and passes on the bounds of what
//! it stands on. Where more halves were climbed to, data matter little because their effects cancel; here
//! sizes are added.
//!
//! A body turns by the bounds (t, w, k) of its angle, ω and α. At a distance ρ on it a point gains
//!
//! ```text
//! ρ (t + 1)      ρ (w + |ω| (t + 1))      ρ (k + (|α| + ω²)(t + 1) + 2 |ω| w)
//! ```
//!
//! in place, velocity and acceleration: every factor's own bound, and one for the rounding of the product. So does what moves
//! on it at the rate σ: nothing, |σ| (t + 1) and |σ̇| (t + 1) + 2 |σ| (w + |ω| (t + 1)).
//!
//! The links of a dyad close a loop, J x = v, whose unknown x are turnings and slides. What the terms of the
//! loop, added up, fail to close by is f; J (x + δ) = v + f leaves |δ| at most |J⁻¹| f, so that each unknown has its gain:
//! a row of |J⁻¹|, which the dyad's file states. Place, rate and acceleration have one J.
//!
//! Inputs and dimensions are given. A multiple of an input is right to its own last place; the rate of any other expression
//! counts by its size, as if what it reads were exact.
//!
//! # Source
//! J. H. Wilkinson, Rounding Errors in Algebraic Processes, ch. 1 (running errors); R. D. Skeel, Scaling for numerical
//! stability in Gaussian elimination, J. ACM 26 (|J⁻¹| |J| |x|).

mod loops;

use std::collections::HashMap;

use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, PointMotion};
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::exact::Exact;
use crate::model::acting::Contact;
use crate::model::mechanism::{
    AngleSum, Carrier, Drive, Group, GuideDirection, GuideId, Joint, JointKind, LinkId, PointId,
    Slideway, Step, Through,
};

/// Bounds of a number, of its rate and of its acceleration.
type ErrorBounds<'s> = [Sym<'s>; 3];

/// Bounds of an angle, of ω and of α, and the sizes of ω and α.
#[derive(Clone, Copy)]
struct Turning<'s> {
    bounds: ErrorBounds<'s>,
    sizes: [Sym<'s>; 2],
}

/// A link or a guide.
#[derive(Clone, Copy)]
struct Rounded<'s> {
    origin: ErrorBounds<'s>,
    turning: Turning<'s>,
}

/// The bounds of everything that a state has placed.
pub struct SlipRounding<'s> {
    ground: Rounded<'s>,
    points: HashMap<PointId, ErrorBounds<'s>>,
    guides: HashMap<GuideId, Rounded<'s>>,
    links: HashMap<LinkId, Rounded<'s>>,
    slides: HashMap<LinkId, ErrorBounds<'s>>,
}

/// u, 8 ε of the working width: what rounding 2⁵ (1 + 2⁻²⁵ + 2⁻⁵⁴) leaves, 2⁻⁴⁹ in f64 and 2⁻²⁰ in f32.
fn unit<'s>(builder: &'s GraphBuilder<'s>) -> Sym<'s> {
    let power = |exponent: i32| Exact::float(2.0_f64.powi(exponent)).expect("finite");
    builder.constant(power(5).add(&power(-20)).add(&power(-49))).low()
}

impl<'s> Turning<'s> {
    fn of(direction: Direction<'s>, bounds: ErrorBounds<'s>) -> Self {
        Self { bounds, sizes: [direction.omega, direction.alpha].map(Sym::magnitude) }
    }

    /// t + 1
    fn angle(&self) -> Sym<'s> {
        self.bounds[0] + self.bounds[0].builder().integer(1)
    }

    /// w + |ω| (t + 1)
    fn rate(&self) -> Sym<'s> {
        self.bounds[1] + self.sizes[0] * self.angle()
    }

    /// The bound of a point at a unit distance.
    fn swing(&self, order: usize) -> Sym<'s> {
        let [omega, alpha] = self.sizes;
        match order {
            0 => self.angle(),
            1 => self.rate(),
            _ => {
                let turned = (alpha + omega.squared()) * self.angle();
                self.bounds[2] + (turned + (omega * self.bounds[1]).twice())
            }
        }
    }

    /// The bound of what moves on it.
    fn relative(&self, order: usize, by: Jet<'s>) -> Sym<'s> {
        let [rate, accel] = [by.rate, by.accel].map(Sym::magnitude);
        match order {
            0 => rate.builder().zero(),
            1 => rate * self.angle(),
            _ => accel * self.angle() + (rate * self.rate()).twice(),
        }
    }

    /// The bound of what slides on it, whose slide has bounds of its own.
    fn slid(&self, order: usize, by: Jet<'s>, own: ErrorBounds<'s>) -> Sym<'s> {
        let [omega, alpha] = self.sizes;
        let carried = match order {
            0 => own[0],
            1 => own[1] + omega * own[0],
            _ => own[2] + ((alpha + omega.squared()) * own[0] + (omega * own[1]).twice()),
        };
        carried + self.relative(order, by)
    }

    /// The same, turned by an angle.
    fn turned(&self, links: &[(Turning<'s>, i32)], direction: Direction<'s>) -> Self {
        let builder = direction.omega.builder();
        let sums = [0, 1, 2].map(|order| {
            links.iter().fold(self.bounds[order], |sum, (link, times)| {
                sum + builder.integer(i64::from(times.abs())) * link.bounds[order]
            })
        });
        let own = Self::of(direction, sums);
        let bounds =
            [own.angle(), rounded(sums[1], direction.omega), rounded(sums[2], direction.alpha)];
        Self { bounds, ..own }
    }
}

/// The bound of a rate that is made of numbers of this bound.
fn rounded<'s>(bound: Sym<'s>, rate: Sym<'s>) -> Sym<'s> {
    if bound.is_zero() && rate.is_multiple_of_input() { bound } else { bound + rate.magnitude() }
}

impl<'s> SlipRounding<'s> {
    pub fn of(state: &Kinematics<'s>) -> Self {
        let none = [state.builder.zero(); 3];
        let turning = Turning::of(Direction::ground(state.builder), none);
        let ground = Rounded { origin: none, turning };
        let mut rounding = Self {
            ground,
            points: HashMap::new(),
            guides: HashMap::new(),
            links: HashMap::new(),
            slides: HashMap::new(),
        };
        for step in &state.mechanism.steps {
            rounding.take(state, step);
        }
        rounding
    }

    /// Bounds of a slip and of its rate.
    pub(super) fn of_slip(&self, contact: Contact) -> [Sym<'s>; 2] {
        self.units_of_slip(contact).map(|bound| unit(bound.builder()) * bound)
    }

    /// The same in units of u.
    pub fn units_of_slip(&self, contact: Contact) -> [Sym<'s>; 2] {
        [1, 2].map(|order| match contact {
            Contact::Guide(link) => self.slides[&link][order],
            Contact::Pin { link, against, .. } => {
                let [own, other] = [Carrier::Link(link), against].map(|body| self.body(body));
                own.turning.bounds[order] + other.turning.bounds[order]
            }
        })
    }

    fn body(&self, carrier: Carrier) -> Rounded<'s> {
        match carrier {
            Carrier::Ground => self.ground,
            Carrier::Link(link) => self.links[&link],
        }
    }

    fn take(&mut self, state: &Kinematics<'s>, step: &Step) {
        match step {
            Step::Ground { point, .. } => {
                self.points.insert(*point, self.ground.origin);
            }
            Step::Guide { guide, carrier, through, course } => {
                let origin = match through {
                    Through::Point(point) => self.points[point],
                    Through::At(at) => self.placed(state, *carrier, state.jets(at)),
                };
                let links = match course {
                    GuideDirection::Along(angle) => self.summed(angle),
                    GuideDirection::Towards(_) => Vec::new(),
                };
                let direction = state.guide(*guide).direction;
                let turning = self.body(*carrier).turning.turned(&links, direction);
                self.guides.insert(*guide, Rounded { origin, turning });
            }
            Step::Point { point, carrier, .. } => {
                let at = state.coordinates(*carrier, *point);
                self.points.insert(*point, self.placed(state, *carrier, at));
            }
            Step::Group(group) if group.links.len() == 1 => self.take_driver(state, group),
            Step::Group(group) => self.take_dyad(state, group),
        }
    }

    /// The turnings of a sum of angles.
    fn summed(&self, angle: &AngleSum) -> Vec<(Turning<'s>, i32)> {
        angle.links.iter().map(|&(link, times)| (self.links[&link].turning, times)).collect()
    }

    /// A place of a body.
    fn placed(
        &self,
        state: &Kinematics<'s>,
        carrier: Carrier,
        at: [Jet<'s>; 2],
    ) -> ErrorBounds<'s> {
        let body = self.body(carrier);
        let is_fixed = PointMotion::placed(at[0], at[1]).is_fixed();
        if carrier == Carrier::Ground && is_fixed {
            return body.origin;
        }
        let distance = size(at.map(|x| x.value));
        [0, 1, 2].map(|order| {
            let moved = at
                .iter()
                .fold(state.builder.zero(), |sum, x| sum + body.turning.relative(order, *x));
            body.origin[order] + distance * body.turning.swing(order) + moved
        })
    }

    fn take_driver(&mut self, state: &Kinematics<'s>, group: &Group) {
        let (link, joint) = (group.links[0], &group.outer[0]);
        let direction = state.link(link).frame.direction;
        let none = self.ground.origin;
        let slide = state.link(link).slide.map_or(none, |slide| {
            let zero = state.builder.zero();
            [slide.value.magnitude(), rounded(zero, slide.rate), rounded(zero, slide.accel)]
        });
        let body = match (&joint.drive, &joint.kind) {
            (Some(Drive::Angle { angle, relative_to }), JointKind::Revolute(point)) => {
                let carrier = self.body(*relative_to).turning;
                let turning = carrier.turned(&self.summed(angle), direction);
                Rounded { origin: self.points[point], turning }
            }
            _ => {
                let turning = self.way(state, joint, &[]);
                let origin = [0, 1, 2].map(|k| self.along(state, joint, (turning, slide), k));
                Rounded { origin, turning }
            }
        };
        self.links.insert(link, body);
        self.slides.insert(link, slide);
        if let Some(pin) = group.pin {
            let at = match &group.lengths[0] {
                Some(length) => state.jet(&length.value),
                None => Jet::zero(state.builder),
            };
            let pinned = self.placed(state, Carrier::Link(link), [at, Jet::zero(state.builder)]);
            self.points.insert(pin, pinned);
        }
    }

    /// The turning of what a joint's link slides along. `own` are those of the joint's group.
    fn way(
        &self,
        state: &Kinematics<'s>,
        joint: &Joint,
        own: &[(LinkId, Turning<'s>)],
    ) -> Turning<'s> {
        let turning = |link: LinkId| {
            let known = own.iter().find(|(known, _)| *known == link);
            known.map_or_else(|| self.links[&link].turning, |(_, turning)| *turning)
        };
        match joint.slideway().expect("its link slides") {
            Slideway::Guide(guide) => self.guides[guide].turning,
            Slideway::Bar(link) => turning(*link),
            Slideway::Slot { link, angle, .. } => {
                let direction = state.link(joint.link()).frame.direction;
                turning(*link).turned(&self.summed(angle), direction)
            }
        }
    }

    /// The bound of the place to which a link slides, from what is known of the slide.
    fn along(
        &self,
        state: &Kinematics<'s>,
        joint: &Joint,
        (way, slide): (Turning<'s>, ErrorBounds<'s>),
        order: usize,
    ) -> Sym<'s> {
        let zero = state.builder.zero();
        let jet = state.link(joint.link()).slide.expect("its link slides");
        let (mut offsets, mut start) = (vec![state.offset_in(joint)], zero);
        match joint.slideway() {
            Some(Slideway::Guide(guide)) => start = self.guides[guide].origin[order],
            Some(Slideway::Slot { across, .. }) => offsets.push(state.jet(across)),
            _ => {}
        }
        let distance =
            offsets.iter().fold(jet.value.magnitude(), |sum, e| sum + e.value.magnitude());
        let moved = offsets.iter().fold(zero, |sum, e| sum + way.relative(order, *e));
        let swung = distance * way.swing(order) + moved;
        start + swung + way.slid(order, jet, slide)
    }
}

/// At least the length of a vector.
fn size<'s>([x, y]: [Sym<'s>; 2]) -> Sym<'s> {
    x.magnitude() + y.magnitude()
}
