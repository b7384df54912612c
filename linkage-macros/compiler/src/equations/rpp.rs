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

use crate::equations::jet::Jet;
use crate::equations::levers::{self, Levers};
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{
    Acting, GroupScope, GuideReaction, LimitMeasures, LinkMotion, Solved,
};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;

/// The slot's direction, and the same in the rail's axes.
#[derive(Clone, Copy)]
pub(super) struct Slot<'s> {
    pub direction: Direction<'s>,
    pub relative: Direction<'s>,
}

pub(super) fn rpp<'s>(
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
    let inverse = sine.provided(Check::Nonzero, scope.group, &[]).recip();
    scope.call("inverse sin", inverse);
    let [e1, e2] = offsets;

    let from = rail.origin.to(b);
    let y = scope.sheet.det(u1.x, from.y, u1.y, from.x);
    let s2 = (y - e1.value - e2.value * cosine) * inverse;
    let s1 = from.dot(u1) + e2.value * sine - s2 * cosine;

    scope.call("y", y);
    scope.call("s2", s2);
    scope.call("s1", s1);
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
    let levers = levers::Rpp { rail: u1, slot: u2, cosine, inverse, arm: s2 + e1.value * sine };
    let on_rail = Jet { value: s1, rate: rate[0], accel: accel[0] };
    let in_slot = Jet { value: s2, rate: rate[1], accel: accel[1] };
    let foot = rail.place(on_rail, Jet::zero(scope.sheet));
    let link = |origin, direction, slide| LinkMotion {
        frame: Frame { origin, direction },
        slide: Some(slide),
    };
    let links = vec![link(b, slot.direction, in_slot), link(foot, rail.direction, on_rail)];
    Solved { links, pin: None, levers: Some(Levers::Rpp(levers)) }
}

/// The outer joint's force on the block, what the slot exerts on the block and the rail on the yoke.
pub(super) struct Reactions<'s> {
    pub outer: Vector<'s>,
    pub slot: GuideReaction<'s>,
    pub rail: GuideReaction<'s>,
    /// N₂ c, the effort of the offset e₁.
    pub offset_effort: Sym<'s>,
}

pub(super) fn reactions<'s>(
    levers::Rpp { rail, slot, cosine, inverse, arm }: levers::Rpp<'s>,
    [block, yoke]: [Acting<'s>; 2],
) -> Reactions<'s> {
    let normal = -(yoke.force.dot(rail) * inverse);
    let by_slot = GuideReaction { normal, couple: -block.moment };
    let offset_effort = normal * cosine;
    let by_rail = GuideReaction {
        normal: offset_effort - yoke.force.dot(rail.normal()),
        couple: by_slot.couple - yoke.moment + normal * arm,
    };
    let outer = -(block.force + normal * slot.normal());
    Reactions { outer, slot: by_slot, rail: by_rail, offset_effort }
}

/// The sine of the angle between rail and slot, not negative.
pub(super) fn quality<'s>(rail: Frame<'s>, slot: Slot<'s>) -> LimitMeasures<'s> {
    LimitMeasures::of_directions(rail.direction, slot.direction, slot.relative.u.y)
}
