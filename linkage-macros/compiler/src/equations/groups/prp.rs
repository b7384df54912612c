//! The dyad PRP: two blocks on two guides, pinned to each other at C.
//!
//! # Position
//! C = K₁ + s₁ u₁ + e₁ n₁ = K₂ + s₂ u₂ + e₂ n₂. With k = (K₂ + e₂ n₂) − (K₁ + e₁ n₁) and
//! Δ = u₁ × u₂, Cramer's rule gives
//!
//! ```text
//! s₁ = (k × u₂)/Δ        s₂ = (k × u₁)/Δ
//! ```
//!
//! Δ of two guides on one carrier is the sine of the difference of their angles.
//!
//! # Velocity and acceleration
//! With v_k the velocity of guide k's point under the pin and of its changing offset, and
//! w = v₂ − v₁: ṡ₁ = (w × u₂)/Δ, ṡ₂ = (w × u₁)/Δ; the same with accelerations, w replaced by the
//! difference of the transport, Coriolis and offset accelerations.
//!
//! Where guide 2 stands still and guide 1 swings about a point of the ground, by ω and α, these are made of the
//! vector r from there to C:
//!
//! ```text
//! ṡ₁ = ω r·u₂/Δ    s̈₁ = (α r·u₂ + ω² r × u₂ + 2 ω ṡ₁ u₁·u₂)/Δ
//! ṡ₂ = ω r·u₁/Δ    s̈₂ = (α r·u₁ + ω² r × u₁ + 2 ω ṡ₁)/Δ
//! ```
//!
//! in which r × u₂ is a constant and r·u₂ is s₂ and a constant. With the guides in the other order Δ has the
//! other sign.
//!
//! # Reactions
//! With L all that acts on the pin from outside the group, F and M what acts on the blocks but for
//! their own joints, M about C: each block is free along its guide,
//!
//! ```text
//! P₂ = ((F₂·u₁) n₂ + ((F₃ + L)·u₂) n₁)/Δ      P₃ = L − P₂
//! N₁ = −(F₂ + P₂)·n₁      T₁ = −M₂            N₂ = −(F₃ + P₃)·n₂      T₂ = −M₃
//! ```
//!
//! from P₂·u₁ = −F₂·u₁ and P₂·u₂ = (F₃ + L)·u₂, with n₂·u₁ = −Δ and n₁·u₂ = Δ. N and T are the guide's
//! on its block, at C.
//!
//! # Error
//! At most 4 times what the data allow between nearly parallel guides of one carrier,
//! however near. On random poses 20 times for positions, 10.1 for velocities, 15.1 for
//! accelerations; in the hill-climbed worst case 87, 37 and 37. The pin is carried by the first
//! guide, or by the second if that alone stands still, and is as right as the slide along it is
//! long: of two guides that stand alike, name the one first whose origin is nearer. Between guides
//! of two carriers Δ is made of rounded directions, and its error is ε over the sine between them.
//!
//! # Source
//! Cramer's rule.

use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{Block, GroupScope, LimitMeasures, LinkMotion, Solved};
use crate::equations::reactions::{
    Acting, GuideReaction, Inner, JacobianFactors, Loads, Reaction, Reactions,
};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::Group;

pub(super) struct Prp;

impl Formulas for Prp {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let guides = [0, 1].map(|block| known.slides_on(group, block));
        let offsets = [0, 1].map(|block| known.offset_in(&group.outer[block]));
        prp(&known.scope(group), guides, offsets)
    }

    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        Some(measures([0, 1].map(|block| known.slides_on(group, block))))
    }
}

fn prp<'s>(scope: &GroupScope<'s>, guides: [Frame<'s>; 2], offsets: [Jet<'s>; 2]) -> Solved<'s> {
    let [u1, u2] = guides.map(|guide| guide.direction.u);
    let (sine, _) = guides[0].direction.sin_cos_to(guides[1].direction);
    let inverse = sine.guarded_by(Check::Nonzero, scope.group, &[]).recip();
    scope.label("inverse sin", inverse);
    let slides = |w: Vector<'s>| [w.cross(u2) * inverse, w.cross(u1) * inverse];

    let shift = |k: usize| offsets[k].value * guides[k].direction.n();
    let apart = guides[0].origin.to(guides[1].origin) + (shift(1) - shift(0));
    scope.call_vector("delta", apart);
    let value = slides(apart);
    scope.label("s1", value[0]);
    scope.label("s2", value[1]);

    let blocks: [Block<'s>; 2] =
        core::array::from_fn(|k| Block::new(guides[k], value[k], offsets[k]));
    let (rate, accel) = crossing(guides, offsets, value, inverse).unwrap_or_else(|| {
        let rate = slides(blocks[1].carried_velocity() - blocks[0].carried_velocity());
        let [first, second] = [0, 1].map(|k| blocks[k].carried_acceleration(rate[k]));
        (rate, slides(second - first))
    });
    let transport = [0, 1].map(|k| blocks[k].carried_acceleration(rate[k]));

    // From the guide on the ground, if there is one, and with an exact coordinate, if it has one.
    let fixed = |k: usize| guides[k].origin.is_fixed() && guides[k].direction.omega.is_zero();
    let carrier = usize::from(fixed(1) && !fixed(0));
    let pin = blocks[carrier].pin(rate[carrier], accel[carrier], transport[carrier]);
    let pin = PointMotion { offset: exact_coordinates(pin, &blocks), ..pin };
    let block = |k: usize| LinkMotion {
        frame: Frame { origin: pin, direction: guides[k].direction },
        slide: Some(Jet { value: value[k], rate: rate[k], accel: accel[k] }),
    };
    Solved {
        links: vec![block(0), block(1)],
        pin: Some(pin),
        bars: Vec::new(),
        levers: Some(Box::new(PrpLevers { u: [u1, u2], inverse })),
    }
}

/// Rates and accelerations of the slides where one guide, of any offset, stands still and the other one
/// swings about a point of the ground.
fn crossing<'s>(
    guides: [Frame<'s>; 2],
    offsets: [Jet<'s>; 2],
    slides: [Sym<'s>; 2],
    inverse: Sym<'s>,
) -> Option<([Sym<'s>; 2], [Sym<'s>; 2])> {
    let still = guides.iter().position(|guide| guide.is_fixed())?;
    let (moving, rail) = (guides[1 - still], guides[still]);
    let Direction { u: u1, omega, alpha, .. } = moving
        .swing()
        .map(|_| moving.direction)
        .filter(|_| offsets.iter().all(|e| e.is_fixed()))?;
    let (u2, offset) = (rail.direction.u, offsets[still].value * rail.direction.n());
    let start = rail.origin.base - moving.origin.base + offset;
    let r = start + slides[still] * u2;
    let along = [r.dot(u1), start.dot(u2) + slides[still]];
    let across = [r.cross(u1), start.cross(u2)];
    // The sign of Δ is that of the order of the guides.
    let over_sine = if still == 1 { inverse } else { -inverse };
    let [of_rail, of_moving] = along.map(|along| omega * along * over_sine);
    let coriolis = (omega * of_moving).twice();
    let turning = |k: usize| alpha * along[k] + omega.squared() * across[k];
    let rail_accel = (turning(0) + coriolis) * over_sine;
    let moving_accel = (turning(1) + coriolis * u1.dot(u2)) * over_sine;
    let ordered = |of_moving, of_rail| {
        if still == 1 { [of_moving, of_rail] } else { [of_rail, of_moving] }
    };
    Some((ordered(of_moving, of_rail), ordered(moving_accel, rail_accel)))
}

/// The guides' directions and 1/Δ.
struct PrpLevers<'s> {
    u: [Vector<'s>; 2],
    inverse: Sym<'s>,
}

impl<'s> JacobianFactors<'s> for PrpLevers<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s> {
        let (&Self { u: [u1, u2], inverse }, [first, second]) = (self, loads.links);
        let [along_first, along_second] =
            [first.force.dot(u1) * inverse, (second.force + loads.pin).dot(u2) * inverse];
        let on_first = along_first * u2.normal() + along_second * u1.normal();
        let on_second = loads.pin - on_first;
        let guide = |link: Acting<'s>, by_pin: Vector<'s>, u: Vector<'s>| GuideReaction {
            normal: -(link.force + by_pin).dot(u.normal()),
            couple: -link.moment,
        };
        let guides = [guide(first, on_first, u1), guide(second, on_second, u2)];
        Reactions { outer: guides.map(Reaction::Guide), inner: Inner::Pin([on_first, on_second]) }
    }

    fn gains(&self) -> [Sym<'s>; 2] {
        [self.inverse; 2]
    }
}

/// Two guides along the axes cross where one gives x and the other gives y, without arithmetic.
fn exact_coordinates<'s>(pin: PointMotion<'s>, blocks: &[Block<'s>; 2]) -> Vector<'s> {
    let mut offset = pin.offset;
    for block in blocks {
        let from_block = block.offset_from(pin.base);
        let u = block.direction();
        if u.x.is_zero() {
            offset.x = from_block.x;
        }
        if u.y.is_zero() {
            offset.y = from_block.y;
        }
    }
    offset
}

/// The angle between the directions of both guides.
fn measures<'s>(guides: [Frame<'s>; 2]) -> LimitMeasures<'s> {
    let [a, b] = guides.map(|guide| guide.direction);
    LimitMeasures::of_directions(a, b, a.sin_cos_to(b))
}
