//! The dyad RRR: two bars pinned to B and D and to each other at C.
//!
//! # Position
//! With d = D − B, the joint C of the bars l₂ (from B) and l₃ (from D) lies at
//! r₂ = C − B = a d + h d⊥, where
//!
//! ```text
//! i = d² − (l₂ − l₃)²               a = (i/2 + l₂ (l₂ − l₃)) / d²
//! S = i/4l₂l₃ · (1 − i/4l₂l₃)       b = (i/2 + l₃ (l₃ − l₂)) / d² = 1 − a
//!                                   h = ± 2 l₂ l₃ √S / d²,  + where C is left of B → D
//! ```
//!
//! and r₃ = C − D = −b d + h d⊥. This is Heron's formula with the two factors that can vanish,
//! (d − |l₂ − l₃|)(d + |l₂ − l₃|) at the inner toggle and (l₂ + l₃ − d)(l₂ + l₃ + d) at the outer
//! one, made from the same i: its rounding acts like one of d alone, so that the bars keep their
//! lengths even where a short bar stands across a long one. No power above the second occurs.
//!
//! # Velocity and acceleration
//! Both bars give the joint the same velocity: v_B + l̇₂ u₂ + ω₂ r₂⊥ = v_D + l̇₃ u₃ + ω₃ r₃⊥.
//! With w = (v_D + l̇₃ u₃) − (v_B + l̇₂ u₂) and J = r₂ × r₃, taking the product with r₃ and r₂:
//!
//! ```text
//! ω₂ = (w · r₃)/J        ω₃ = (w · r₂)/J        J = h d²
//! ```
//!
//! The same with accelerations, w replaced by
//! g = a_D + l̈₃ u₃ + 2 ω₃ l̇₃ u₃⊥ − ω₃² r₃ − (a_B + l̈₂ u₂ + 2 ω₂ l̇₂ u₂⊥ − ω₂² r₂).
//!
//! Where the outer joints almost meet, both bars turn alike and the centripetal terms cancel but
//! for the short line between the joints. `numerics compensated;` has them as
//! ω₂² r₂ − ω₃² r₃ = ω₂² d + (ω₂ − ω₃)(ω₂ + ω₃) r₃ with ω₂ − ω₃ = −(w · d)/J.
//!
//! # Sign
//! `left` (+1): C on the left of the directed line B → D.
//!
//! # Source
//! Norton, Design of Machinery, ch. 4 (vector loop) in the coordinates of the line of centres;
//! W. Kahan, Miscalculating Area and Angles of a Needle-like Triangle, for the product form.
//!
//! # Numbers
//! Two divisions and one root for everything. A parallelogram (l₂ = |AB|, l₃ … equal in pairs)
//! passes through change points where a constant mode turns it into an antiparallelogram.

use crate::equations::clearance::{Clearance, size};
use crate::equations::groups::{Bar, Dyad, Place, Quality, root_in_reach};
use crate::equations::jet::Jet;
use crate::equations::motion::PointMotion;
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::Numerics;

/// The triangle of the group: what is affine in the height h.
struct Triangle<'s> {
    /// 1/4l₂l₃
    scale: Sym<'s>,
    /// S, not negative where the circles meet.
    square: Sym<'s>,
    /// √S with the mode's sign: half the sine of the angle between the bars.
    root: Sym<'s>,
    /// h
    height: Sym<'s>,
    /// a and b
    along: [Sym<'s>; 2],
}

pub(super) fn rrr<'s>(
    place: &Place<'s>,
    [b, d]: [PointMotion<'s>; 2],
    lengths: [Jet<'s>; 2],
    mode: Sym<'s>,
) -> Dyad<'s> {
    let line = b.to(d);
    let [l2, l3] = lengths.map(|length| length.value);
    let triangle = triangle(place, line, l2, l3, mode);
    let across = triangle.height * line.normal();
    let r2 = triangle.along[0] * line + across;
    let r3 = across - triangle.along[1] * line;

    // 1/J = 1/(h d²) = 1/(2 l₂ l₃ √S) = √S/(2 l₂ l₃) · 1/S: the division runs beside the root.
    let regular = triangle.square.provided(Check::Nonzero, place.group, &[]);
    let inverse = triangle.scale.twice() * triangle.root * regular.recip();
    let bars = [Bar::new(b, r2, lengths[0]), Bar::new(d, r3, lengths[1])];

    let w = bars[1].pushed_velocity() - bars[0].pushed_velocity();
    let omega = [w.dot(r3) * inverse, w.dot(r2) * inverse];
    let g = match place.numerics {
        Numerics::Plain => {
            bars[1].pushed_acceleration(omega[1]) - bars[0].pushed_acceleration(omega[0])
        }
        Numerics::Compensated => {
            let [near, far] = [0, 1].map(|k| bars[k].lengthening_acceleration(omega[k]));
            let folding = -w.dot(line) * inverse;
            (far - near) + (omega[0].squared() * line + (folding * (omega[0] + omega[1])) * r3)
        }
    };
    let alpha = [g.dot(r3) * inverse, g.dot(r2) * inverse];

    let bars = [bars[0].turning(omega[0], alpha[0]), bars[1].turning(omega[1], alpha[1])];
    // The pin is carried by the bar that stands on the ground, if one does: one sum less.
    let carrier = usize::from(d.is_fixed());
    let pin = bars[carrier].pin();
    Dyad { pin, bars }
}

fn triangle<'s>(
    place: &Place<'s>,
    d: Vector<'s>,
    l2: Sym<'s>,
    l3: Sym<'s>,
    mode: Sym<'s>,
) -> Triangle<'s> {
    let operands = [d.x, d.y, l2, l3];
    let inverse = d.dot(d).provided(Check::Square, place.group, &operands).recip();
    let difference = l2 - l3;
    let scale = (l2 * l3).twice().twice().recip();
    let (near, square) = match place.numerics {
        Numerics::Plain => {
            let near = d.dot(d) - difference.squared();
            let part = near * scale;
            (near, part * (d.x.sheet().integer(1) - part))
        }
        Numerics::Compensated => {
            let (near, far) = compensated(d, l2, l3);
            (near, (near * scale) * (far * scale))
        }
    };
    let square = square.provided(Check::ReachCircles, place.group, &operands);
    let root = mode * square.sqrt();
    let height = (l2 * l3).twice() * inverse * root;
    // With equal bars a = b = d²/(2 d²) is one half: an identity wherever 1/d² exists.
    let along = if difference.is_zero() {
        [d.x.sheet().integer(1).half(); 2]
    } else {
        [near.half() + l2 * difference, near.half() - l3 * difference].map(|x| x * inverse)
    };
    Triangle { scale, square, root, height, along }
}

/// i and 4 l₂ l₃ − i with the rounding errors of every square and product put back: where the
/// pivots are exact numbers, the toggle costs nothing.
fn compensated<'s>(d: Vector<'s>, l2: Sym<'s>, l3: Sym<'s>) -> (Sym<'s>, Sym<'s>) {
    let (xx, yy) = (d.x.squared(), d.y.squared());
    let square = xx + yy;
    let square_low = xx.add_err(yy) + (d.x.mul_err(d.x) + d.y.mul_err(d.y));
    let less = |limit: Sym<'s>, limit_low: Sym<'s>, sign: bool| {
        let high = if sign { limit - square } else { square - limit };
        let low = if sign { limit_low - square_low } else { square_low - limit_low };
        high + low
    };
    let squared = |sum: Sym<'s>, sum_low: Sym<'s>| {
        let high = sum.squared();
        // A constant's square is known exactly; a parameter's is put together.
        let low = high.low() + (sum.mul_err(sum) + (sum * sum_low).twice());
        (high, low)
    };
    let (difference, sum) = (l2 - l3, l2 + l3);
    let (m, m_low) = squared(difference, l2.add_err(-l3));
    let (big, big_low) = squared(sum, l2.add_err(l3));
    (less(m, m_low, false), less(big, big_low, true))
}

/// Signed distance from the limit in metres, and sine of the transmission angle.
///
/// With I = d² − (l₂ − l₃)² = 2 l₂ l₃ (1 − cos μ), μ the angle between the bars, sin² μ is smooth,
/// vanishes at both toggles and is negative out of reach; so is the margin l₂ l₃ sin² μ/(2 d), with
/// slope one against d at both toggles.
pub(super) fn quality<'s>([b, d]: [PointMotion<'s>; 2], lengths: [Jet<'s>; 2]) -> Quality<'s> {
    let (near, product) = near_and_product([b, d], lengths);
    let (one, [x, y]) = (Jet::constant(product.value.sheet().integer(1)), b.jets_to(d));
    let versine = near / product;
    let square = versine * (one + one - versine);
    let reach = product / x.hypot(y);
    let margin = (square * reach).times(square.value.sheet().integer(1).half().half());
    Quality { margin: Some(margin), transmission: root_in_reach(square) }
}

/// I and 2 l₂ l₃.
fn near_and_product<'s>(
    [b, d]: [PointMotion<'s>; 2],
    [l2, l3]: [Jet<'s>; 2],
) -> (Jet<'s>, Jet<'s>) {
    let [x, y] = b.jets_to(d);
    let difference = l2 - l3;
    (x * x + y * y - difference * difference, (l2 * l3).twice())
}

/// sin² μ. Where one bar is long or the joints are far away, so is the rounding of I against l₂ l₃.
pub(super) fn clearance<'s>(joints: [PointMotion<'s>; 2], lengths: [Jet<'s>; 2]) -> Clearance<'s> {
    let (near, product) = near_and_product(joints, lengths);
    let one = Jet::constant(product.value.sheet().integer(1));
    let versine = near / product;
    let [l2, l3] = lengths.map(|length| length.value.squared());
    let scale = (l2 + l3 + size(joints[0], joints[1])) / product.value;
    Clearance { value: versine * (one + one - versine), scale }
}
