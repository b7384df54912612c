//! The dyad RRP: a bar pinned to B, a block that slides on a guide, and the pin C between them.
//!
//! # Position
//! The guide has the origin K, the direction u and the normal n; the pin keeps the offset e from
//! it. With B in the guide's axes, x = (B − K)·u and y = (B − K)·n,
//!
//! ```text
//! t = e − y      X = ± √((l − t)(l + t)),  + where C is ahead of the foot of B
//! r = C − B = X u + t n      slide = x + X
//! ```
//!
//! The factors keep full accuracy at the limit |t| = l; y is one difference of products, so that
//! a guide whose origin is far away costs nothing.
//!
//! # Velocity and acceleration
//! The bar and the guide give the pin the same velocity, v_B + l̇ u_b + ω r⊥ = v_g + ṡ u, with
//! v_g that of the guide's point under the pin and of the changing offset. With
//! w = v_g − v_B − l̇ u_b, and r⊥·n = X, r⊥·u = −t:
//!
//! ```text
//! ω = w·n / X        ṡ = −w·u − ω t
//! ```
//!
//! The same with accelerations, w replaced by the guide's transport, Coriolis and offset
//! acceleration less that of the bar but for α r⊥.
//!
//! # Sign
//! `ahead` (+1): C ahead of the foot of B on the guide, along its direction.
//!
//! # Source
//! Norton, Design of Machinery, ch. 4 (slider-crank) in the axes of the guide.

use crate::equations::clearance::{Clearance, size};
use crate::equations::groups::{Bar, Block, Place, Quality, SlidingDyad};
use crate::equations::jet::Jet;
use crate::equations::motion::{Frame, PointMotion};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;

pub(super) fn rrp<'s>(
    place: &Place<'s>,
    b: PointMotion<'s>,
    guide: Frame<'s>,
    length: Jet<'s>,
    offset: Jet<'s>,
    mode: Sym<'s>,
) -> SlidingDyad<'s> {
    let (u, n) = (guide.direction.u, guide.direction.n());
    let (foot, t) = foot(b, guide, offset.value);
    let l = length.value;
    let square = ((l - t) * (l + t)).provided(Check::ReachLine, place.group, &[t, l]);
    let reach = mode * square.sqrt();
    let slide = foot + reach;
    let r = reach * u + t * n;
    let bar = Bar::new(b, r, length);

    // 1/X = X/X²: the division runs beside the root.
    let inverse = reach * square.provided(Check::Nonzero, place.group, &[]).recip();
    let block = Block::new(guide, slide, offset);
    let turn = |w: Vector<'s>| {
        let omega = w.dot(n) * inverse;
        (omega, -w.dot(u) - omega * t)
    };
    let (omega, slide_rate) = turn(block.carried_velocity() - bar.pushed_velocity());
    let carried = block.carried_acceleration(slide_rate);
    let (alpha, slide_accel) = turn(carried - bar.pushed_acceleration(omega));

    let bar = bar.turning(omega, alpha);
    let pin = block.pin(slide_rate, slide_accel, carried);
    // On a guide along an axis the pin keeps the guide's own coordinate to the last digit;
    // elsewhere it is nearer to B than to the guide's origin.
    let pin = if u.x.is_zero() || u.y.is_zero() {
        pin
    } else {
        PointMotion { base: b.base, offset: b.offset + r, ..pin }
    };
    let slide = Jet { value: slide, rate: slide_rate, accel: slide_accel };
    SlidingDyad { pin, bar, slide }
}

/// The foot x of B on the guide and the distance t = e − y still to go across it.
fn foot<'s>(b: PointMotion<'s>, guide: Frame<'s>, offset: Sym<'s>) -> (Sym<'s>, Sym<'s>) {
    let from = guide.origin.to(b);
    let u = guide.direction.u;
    let y = u.x.sheet().det(u.x, from.y, u.y, from.x);
    (from.dot(u), offset - y)
}

/// Signed distance from the limit in metres, (l − t)(l + t)/(2 l), and the sine of the
/// transmission angle between bar and guide's normal, √((l − t)(l + t))/l.
pub(super) fn quality<'s>(
    b: PointMotion<'s>,
    guide: Frame<'s>,
    l: Jet<'s>,
    offset: Jet<'s>,
) -> Quality<'s> {
    let [x, y] = guide.origin.jets_to(b);
    let [ux, uy] = guide.direction.jets();
    let t = offset - (ux * y - uy * x);
    let square = (l - t) * (l + t);
    Quality { margin: Some(square / l.twice()), transmission: square.sqrt() / l }
}

/// (l − t)(l + t).
pub(super) fn clearance<'s>(
    b: PointMotion<'s>,
    guide: Frame<'s>,
    l: Jet<'s>,
    offset: Jet<'s>,
) -> Clearance<'s> {
    let [x, y] = guide.origin.jets_to(b);
    let [ux, uy] = guide.direction.jets();
    let t = offset - (ux * y - uy * x);
    let squares = l.value.squared() + offset.value.squared();
    Clearance { value: (l - t) * (l + t), scale: squares + size(guide.origin, b) }
}
