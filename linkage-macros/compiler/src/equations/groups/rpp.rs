//! The dyad RPP: a yoke slides on a rail and carries a slot in which a block pinned to B slides.
//!
//! # Position
//! The slot stands at the angle β to the rail. With c = cos β and σ = sin β, the rail's direction
//! u₁ and normal n₁ and the slot's u₂ = c u₁ + σ n₁, n₂ = −σ u₁ + c n₁,
//! B = K + s₁ u₁ + e₁ n₁ + s₂ u₂ + e₂ n₂. In the rail's axes, (x, y) = (B − K):
//!
//! ```text
//! s₂ = (y − e₁ − e₂ c)/σ        s₁ = x + e₂ σ − s₂ c
//! ```
//!
//! # Velocity and acceleration
//! The yoke turns with the rail (ω₁), the slot with ω₁ + β̇. With ρ = B − K and the block's
//! ρ₂ = s₂ u₂ + e₂ n₂, what is left of v_B after the transport by both turnings and the changing
//! offsets is w = ṡ₁ u₁ + ṡ₂ u₂, so
//!
//! ```text
//! w = v_B − (v_K + ω₁ ρ⊥ + β̇ ρ₂⊥ + ė₁ n₁ + ė₂ n₂)
//! ṡ₂ = (w·n₁)/σ        ṡ₁ = w·u₁ − ṡ₂ c
//! ```
//!
//! The rail carries B as a whole: where the slot is nearly along the rail both slides are long and
//! their sum is not. The same with accelerations; with σ = w + ė₁ n₁ + ė₂ n₂ the velocity of both
//! slides together and σ₂ = ṡ₂ u₂ + ė₂ n₂ the block's in the slot,
//!
//! ```text
//! g = a_B − (a_K + α₁ ρ⊥ − ω₁² ρ + 2 ω₁ σ⊥ + ë₁ n₁ + ë₂ n₂
//!            + β̈ ρ₂⊥ − β̇ (2 ω₁ + β̇) ρ₂ + 2 β̇ σ₂⊥)
//! ```
//!
//! # Reactions
//! With F and M what acts on block (2) and yoke (3) but for their own joints, M about B and about the
//! yoke's point Q on the rail, from which B lies at e₁ n₁ + s₂ u₂ + e₂ n₂:
//!
//! ```text
//! N₂ = −F₃·u₁/σ              T₂ = −M₂
//! N₁ = N₂ c − F₃·n₁          T₁ = T₂ − M₃ + N₂ (s₂ + e₁ σ)
//! R_B = −F₂ − N₂ n₂
//! ```
//!
//! N₂ and T₂ are the slot's on the block, at B; N₁ and T₁ the rail's on the yoke, at Q: the slot's
//! opposite −N₂ n₂ at B has the moment −N₂ (B − Q)·u₂ about it. A driven offset e₁ moves the slot
//! against the yoke, which stays on its rail: its effort is N₂ c, not N₁.
//!
//! # Error
//! At most 4 times what the data allow next to a slot along its rail, however near. On
//! random poses 2.5 times for positions, 2.3 for velocities, 2.6 for accelerations; in the
//! hill-climbed worst case 3.3, 3.2 and 5.9.
//!
//! # Source
//! As for PRP; the two directions enclose the slot's angle, whose sine and cosine are exact where
//! it is a multiple of 90° or 30°. They are taken from β itself: the difference of the rounded
//! angles of slot and rail would lose every digit that β is small by.

use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{GroupScope, LimitMeasures, LinkMotion, Solved};
use crate::equations::reactions::{
    Acting, GuideReaction, Inner, JacobianFactors, Loads, Reaction, Reactions,
};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::{Group, JointKind, Slideway};

pub(super) struct Rpp;

impl Formulas for Rpp {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let (b, rail) = (known.stands_on(group, 0), known.slides_on(group, 1));
        let slot = Slot::of(known, group, rail);
        let offsets = group.offsets();
        let offsets = [0, 1].map(|index| known.jet(offsets[index]));
        rpp(&known.scope(group), b, rail, slot, offsets)
    }

    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        let rail = known.slides_on(group, 1);
        Some(measures(rail, Slot::of(known, group, rail)))
    }
}

/// The slot's direction, and the same in the rail's axes.
#[derive(Clone, Copy)]
struct Slot<'s> {
    direction: Direction<'s>,
    relative: Direction<'s>,
}

impl<'s> Slot<'s> {
    fn of(known: &Kinematics<'s>, group: &Group, rail: Frame<'s>) -> Self {
        let JointKind::Prismatic { along: Slideway::Slot { angle, .. }, .. } = &group.inner[0].kind
        else {
            unreachable!("the block slides in a slot")
        };
        let relative = known.turned(Direction::ground(known.builder), angle);
        Self { direction: known.turned(rail.direction, angle), relative }
    }
}

fn rpp<'s>(
    scope: &GroupScope<'s>,
    b: PointMotion<'s>,
    rail: Frame<'s>,
    slot: Slot<'s>,
    offsets: [Jet<'s>; 2],
) -> Solved<'s> {
    let (u1, n1) = (rail.direction.u, rail.direction.n());
    let (u2, n2) = (slot.direction.u, slot.direction.n());
    let Direction { u: Vector { x: cosine, y: sine }, omega: beta_rate, alpha: beta_accel, .. } =
        slot.relative;
    let inverse = sine.guarded_by(Check::Nonzero, scope.group, &[]).recip();
    scope.label("inverse sin", inverse);
    let [e1, e2] = offsets;

    let from = rail.origin.to(b);
    let y = scope.builder.det(u1.x, from.y, u1.y, from.x);
    let s2 = (y - e1.value - e2.value * cosine) * inverse;
    let s1 = from.dot(u1) + e2.value * sine - s2 * cosine;
    scope.label("y", y);
    scope.label("s2", s2);
    scope.label("s1", s1);
    let slides = |w: Vector<'s>| {
        let second = w.dot(n1) * inverse;
        [w.dot(u1) - second * cosine, second]
    };
    let rho2 = s2 * u2 + e2.value * n2;

    let pushed = e1.rate * n1 + e2.rate * n2;
    let (carried, _) = rail.transport(from, pushed);
    let w = b.velocity - (carried + beta_rate * rho2.normal() + pushed);
    scope.call_vector("rho2", rho2);
    scope.call_vector("w", w);
    let rate = slides(w);

    let (_, carried) = rail.transport(from, w + pushed);
    let sigma2 = rate[1] * u2 + e2.rate * n2;
    let turned = beta_accel * rho2.normal()
        - (beta_rate * (rail.direction.omega.twice() + beta_rate)) * rho2
        + beta_rate.twice() * sigma2.normal();
    let accel = slides(b.acceleration - (carried + turned + e1.accel * n1 + e2.accel * n2));
    let levers = RppLevers {
        rail: u1,
        slot: u2,
        cosine,
        inverse,
        arm: s2 + e1.value * sine,
        offsets: [e1.value, e2.value],
        slide: s2,
    };
    let on_rail = Jet { value: s1, rate: rate[0], accel: accel[0] };
    let in_slot = Jet { value: s2, rate: rate[1], accel: accel[1] };
    let foot = rail.place(on_rail, Jet::zero(scope.builder));
    let link = |origin, direction, slide| LinkMotion {
        frame: Frame { origin, direction },
        slide: Some(slide),
    };
    let links = vec![link(b, slot.direction, in_slot), link(foot, rail.direction, on_rail)];
    Solved { links, pin: None, bars: Vec::new(), levers: Some(Box::new(levers)) }
}

/// The directions of rail and slot, c and 1/σ, s₂ + e₁ σ, both offsets and s₂.
struct RppLevers<'s> {
    rail: Vector<'s>,
    slot: Vector<'s>,
    cosine: Sym<'s>,
    inverse: Sym<'s>,
    arm: Sym<'s>,
    offsets: [Sym<'s>; 2],
    slide: Sym<'s>,
}

impl<'s> JacobianFactors<'s> for RppLevers<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s> {
        let &Self { rail, slot, cosine, inverse, arm, offsets: [e1, e2], slide } = self;
        let [block, yoke] = loads.links;
        // The force transmitted along the slot acts between block and slot, at B.
        let back = loads.along * slot;
        let to_block = e1 * rail.normal() + (slide * slot + e2 * slot.normal());
        let moment = yoke.moment - to_block.cross(back);
        let yoke = Acting { force: yoke.force - back, moment };
        let normal = -(yoke.force.dot(rail) * inverse);
        let reaction = GuideReaction { normal, couple: -block.moment };
        let across = normal * cosine;
        let by_rail = GuideReaction {
            normal: across - yoke.force.dot(rail.normal()),
            couple: reaction.couple - yoke.moment + normal * arm,
        };
        let on_block = -(block.force + normal * slot.normal());
        Reactions {
            outer: [Reaction::Force(on_block), Reaction::Guide(by_rail)],
            inner: Inner::Slide(reaction),
        }
    }

    fn gains(&self) -> [Sym<'s>; 2] {
        [self.inverse; 2]
    }

    /// A driven offset e₁ moves the slot against the yoke.
    fn efforts_of_slot(&self, reaction: GuideReaction<'s>, along: Sym<'s>) -> [Sym<'s>; 2] {
        let &Self { rail, slot, cosine, offsets: [_, e2], slide, .. } = self;
        let GuideReaction { normal, couple } = reaction;
        let across = normal * cosine + along * slot.dot(rail.normal());
        [across, slide * normal + couple - e2 * along]
    }
}

/// The angle between the directions of rail and slot.
fn measures<'s>(rail: Frame<'s>, slot: Slot<'s>) -> LimitMeasures<'s> {
    let Vector { x: cosine, y: sine } = slot.relative.u;
    LimitMeasures::of_directions(rail.direction, slot.direction, (sine, cosine))
}
