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
//! The yoke turns with the rail (ω₁), the slot with ω₂ = ω₁ + β̇. With the yoke's point
//! Q = K + s₁ u₁ + e₁ n₁ and the block's ρ₂ = s₂ u₂ + e₂ n₂, what is left of v_B after the
//! transport by both turnings and the changing offsets is w = ṡ₁ u₁ + ṡ₂ u₂, so
//!
//! ```text
//! ṡ₂ = (w·n₁)/σ        ṡ₁ = w·u₁ − ṡ₂ c
//! ```
//!
//! The same with accelerations, the Coriolis terms of both slides among what is taken off.
//!
//! # Source
//! As for PRP; the two directions enclose the slot's angle, whose sine and cosine are exact where
//! it is a multiple of 90° or 30°. They are taken from β itself: the difference of the rounded
//! angles of slot and rail would lose every digit that β is small by.

use crate::equations::groups::{Place, Quality, Slides};
use crate::equations::jet::Jet;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::symbol::Vector;
use crate::ir::graph::Check;

/// The slot's direction, and its unit vector in the rail's axes.
#[derive(Clone, Copy)]
pub(super) struct Slot<'s> {
    pub direction: Direction<'s>,
    pub unit: Vector<'s>,
}

pub(super) fn rpp<'s>(
    place: &Place<'s>,
    b: PointMotion<'s>,
    rail: Frame<'s>,
    slot: Slot<'s>,
    offsets: [Jet<'s>; 2],
) -> Slides<'s> {
    let (u1, n1) = (rail.direction.u, rail.direction.n());
    let Vector { x: cosine, y: sine } = slot.unit;
    let slot = slot.direction;
    let inverse = sine.provided(Check::Nonzero, place.group, &[]).recip();
    let [e1, e2] = offsets;

    let from = rail.origin.to(b);
    let y = place.sheet.det(u1.x, from.y, u1.y, from.x);
    let s2 = (y - e1.value - e2.value * cosine) * inverse;
    let s1 = from.dot(u1) + e2.value * sine - s2 * cosine;

    // The slot's frame for relative motion: no transport of its own origin.
    let turning = Frame { origin: PointMotion::fixed(place.sheet.zero_vector()), direction: slot };
    let zero = place.sheet.zero();
    let slides = |w: Vector<'s>| {
        let second = w.dot(n1) * inverse;
        [w.dot(u1) - second * cosine, second]
    };
    let (rho1, rho2) = (rail.vector(s1, e1.value), turning.vector(s2, e2.value));
    let (v1, _) = rail.transport(rho1, rail.vector(zero, e1.rate));
    let (v2, _) = turning.transport(rho2, turning.vector(zero, e2.rate));
    let pushed = e1.rate * n1 + e2.rate * slot.n();
    let rate = slides(b.velocity - (v1 + v2 + pushed));

    let (_, a1) = rail.transport(rho1, rail.vector(rate[0], e1.rate));
    let (_, a2) = turning.transport(rho2, turning.vector(rate[1], e2.rate));
    let pushed = e1.accel * n1 + e2.accel * slot.n();
    let accel = slides(b.acceleration - (a1 + a2 + pushed));
    Slides {
        rail: Jet { value: s1, rate: rate[0], accel: accel[0] },
        slot: Jet { value: s2, rate: rate[1], accel: accel[1] },
    }
}

/// The sine of the angle between rail and slot, not negative.
pub(super) fn quality<'s>(rail: Frame<'s>, slot: Slot<'s>) -> Quality<'s> {
    Quality::of_directions(rail.direction, slot.direction, slot.unit.y)
}
