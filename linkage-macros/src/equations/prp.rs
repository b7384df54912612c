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
//! Each product is one difference of products; Δ of two guides on one carrier is the sine of the
//! difference of their angles.
//!
//! # Velocity and acceleration
//! With v_k the velocity of guide k's point under the pin and of its changing offset, and
//! w = v₂ − v₁: ṡ₁ = (w × u₂)/Δ, ṡ₂ = (w × u₁)/Δ; the same with accelerations, w replaced by the
//! difference of the transport, Coriolis and offset accelerations.
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
//! Cramer's rule; W. Kahan for the 2×2 determinants.

use crate::equations::jet::Jet;
use crate::equations::motion::{Frame, PointMotion};
use crate::equations::parts::{Block, GroupScope, LimitMeasures, LinkMotion, Solved};
use crate::equations::symbol::Vector;
use crate::ir::graph::Check;

pub(super) fn prp<'s>(
    scope: &GroupScope<'s>,
    guides: [Frame<'s>; 2],
    offsets: [Jet<'s>; 2],
) -> Solved<'s> {
    let [u1, u2] = guides.map(|guide| guide.direction.u);
    let (sine, _) = guides[0].direction.sin_cos_to(guides[1].direction);
    let inverse = sine.provided(Check::Nonzero, scope.group, &[]).recip();
    scope.call("inverse sin", inverse);
    let cross = |a: Vector<'s>, b: Vector<'s>| scope.sheet.det(a.x, b.y, a.y, b.x);
    let slides = |w: Vector<'s>| [cross(w, u2) * inverse, cross(w, u1) * inverse];

    let shift = |k: usize| offsets[k].value * guides[k].direction.n();
    let apart = guides[0].origin.to(guides[1].origin) + (shift(1) - shift(0));
    scope.call_vector("delta", apart);
    let value = slides(apart);
    scope.call("s1", value[0]);
    scope.call("s2", value[1]);

    let blocks: [Block<'s>; 2] =
        core::array::from_fn(|k| Block::new(guides[k], value[k], offsets[k]));
    let rate = slides(blocks[1].carried_velocity() - blocks[0].carried_velocity());
    let transport: [Vector<'s>; 2] =
        core::array::from_fn(|k| blocks[k].carried_acceleration(rate[k]));
    let accel = slides(transport[1] - transport[0]);

    // From the guide on the ground, if there is one, and with an exact coordinate, if it has one.
    let fixed = |k: usize| guides[k].origin.is_fixed() && guides[k].direction.omega.is_zero();
    let carrier = usize::from(fixed(1) && !fixed(0));
    let pin = blocks[carrier].pin(rate[carrier], accel[carrier], transport[carrier]);
    let pin = PointMotion { offset: exact_coordinates(pin, &blocks), ..pin };
    let block = |k: usize| LinkMotion {
        frame: Frame { origin: pin, direction: guides[k].direction },
        slide: Some(Jet { value: value[k], rate: rate[k], accel: accel[k] }),
    };
    Solved { links: vec![block(0), block(1)], pin: Some(pin) }
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

/// The sine of the angle between the guides, not negative.
pub(super) fn quality<'s>(guides: [Frame<'s>; 2]) -> LimitMeasures<'s> {
    let [a, b] = guides.map(|guide| guide.direction);
    LimitMeasures::of_directions(a, b, a.sin_cos_to(b).0)
}
