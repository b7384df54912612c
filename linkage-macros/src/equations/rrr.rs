//! The dyad RRR: two bars pinned to B and D and to each other at C.
//!
//! # Position
//! With d = D − B, the joint C of the bars l₂ (from B) and l₃ (from D) lies at
//! r₂ = C − B = a d + h d⊥, where
//!
//! ```text
//! i = d² − (l₂ − l₃)²               a = (i/2 + l₂ (l₂ − l₃)) / d²
//! S = i/4l₂l₃ · (4l₂l₃ − i)/4l₂l₃   b = (i/2 + l₃ (l₃ − l₂)) / d² = 1 − a
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
//! The same with accelerations, w replaced by g + ω₂² r₂ − ω₃² r₃ with
//! g = a_D + l̈₃ u₃ + 2 ω₃ l̇₃ u₃⊥ − (a_B + l̈₂ u₂ + 2 ω₂ l̇₂ u₂⊥).
//!
//! The centripetal terms cancel where both bars turn alike, as bars of one length do whose outer
//! joints almost meet: what is left is as short as the line between the joints. So they are taken
//! along it and across it, with k = ω₂² − ω₃² = −(w · d)/J (ω₂ + ω₃) and any weights p + q = 1, as
//!
//! ```text
//! ω₂² r₂ − ω₃² r₃ = (p ω₃² + q ω₂²) d + k (p r₂ + q r₃)
//! ```
//!
//! Nothing cancels in that if the shorter bar has the larger weight: p = l₃/(l₂ + l₃). The products
//! with r₂ and r₃ are those of d and of the angle between the bars, r₂·r₃ = l₂ l₃ − i/2.
//!
//! # Reactions
//! With L all that acts on the pin from outside the group, F and M what acts on a bar but for its own
//! joints, M about its outer joint, the moments of both bars give the pin's force P₂ on the first:
//!
//! ```text
//! M₃' = M₃ + r₃ × L
//! P₂ = −(M₃' r₂ + M₂ r₃)/J       P₃ = L − P₂
//! R_B = −F₂ − P₂                 R_D = −F₃ − P₃
//! ```
//!
//! from M₂ + r₂ × P₂ = 0 and M₃ + r₃ × P₃ = 0: two products with the velocities' 1/J. They hold with
//! driven lengths, too: r₂ × P₂ is the moment of tube and rod together.
//!
//! # Sign
//! `left` (+1): C on the left of the directed line B → D.
//!
//! # Source
//! Norton, Design of Machinery, ch. 4 (vector loop) in the coordinates of the line of centres;
//! W. Kahan, Miscalculating Area and Angles of a Needle-like Triangle, for the product form.
//!
//! # Error
//! At most 4 times what the data allow next to the stretched bars, to the folded ones, and
//! where the outer joints of equal bars meet. On random poses 2.5 times for positions, 11.2 for
//! velocities, 5.9 for accelerations; in the hill-climbed worst case 3.3, 25 and 16, where a long
//! bar's end moves fast and the pin at its other end hardly: the velocity of a pin between moving
//! joints is that of the first joint and its bar's.
//!
//! With `numerics compensated;` S is right to a few last places however near the toggle, if lengths
//! and joints are exact: constants count with all their digits, and the rounding errors of sums,
//! of squares, and of the difference of two joints that are given by inputs and constants are put
//! back. Directions are then within 5.5 ε, and ω and α lose no more than their own formulas do
//! (`tests/limits/compensated.rs`). A crank's pin is rounded before the group sees it, by as much as
//! the difference D − B is rounded after; neither is put back.
//!
//! # Numbers
//! Two divisions and one root for everything; a third division where the bars' lengths are not
//! constants and accelerations are asked for. A parallelogram (l₂ = |AB|, l₃ … equal in pairs)
//! passes through change points where a constant mode turns it into an antiparallelogram.

mod fast;

use crate::equations::double_word::DoubleWord;
use crate::equations::jet::Jet;
use crate::equations::levers::{self, Levers};
use crate::equations::motion::PointMotion;
use crate::equations::parts::{
    Acting, Bar, Clearance, GroupScope, LimitMeasures, Solved, root_in_reach, size,
};
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
    /// d·r₂ = a d² and −d·r₃ = b d²
    shares: [Sym<'s>; 2],
    /// i/2 = l₂ l₃ (1 − cos μ)
    half: Sym<'s>,
    /// a and b
    along: [Sym<'s>; 2],
}

pub(super) fn rrr<'s>(
    scope: &GroupScope<'s>,
    [b, d]: [PointMotion<'s>; 2],
    lengths: [Jet<'s>; 2],
    mode: Sym<'s>,
) -> Solved<'s> {
    let values = lengths.map(|length| length.value);
    if scope.numerics == Numerics::Fast && fast::is_for(values) {
        return fast::rrr(scope, [b, d], values, mode);
    }
    let line = scope.call_vector("d", b.to(d));
    let triangle = triangle(scope, [b, d], lengths, mode);
    let across = scope.call_vector("h d", triangle.height * line.normal());
    let r2 = scope.call_vector("r2", triangle.along[0] * line + across);
    let r3 = scope.call_vector("r3", across - triangle.along[1] * line);

    // 1/J = 1/(h d²) = 1/(2 l₂ l₃ √S) = √S/(2 l₂ l₃) · 1/S: the division runs beside the root.
    let regular = triangle.square.provided(Check::Nonzero, scope.group, &[]);
    let inverse = triangle.scale.twice() * triangle.root * regular.recip();
    scope.call("inverse j", inverse);
    let bars = [Bar::new(b, r2, lengths[0]), Bar::new(d, r3, lengths[1])];

    let w = scope.call_vector("w", bars[1].pushed_velocity() - bars[0].pushed_velocity());
    let omega = [(r3, "w r3"), (r2, "w r2")].map(|(r, name)| scope.call(name, w.dot(r)) * inverse);
    scope.call("omega2", omega[0]);
    scope.call("omega3", omega[1]);
    let [near, far] = [0, 1].map(|k| bars[k].lengthening_acceleration(omega[k]));
    let g = scope.call_vector("g", far - near);
    let folding = -w.dot(line) * inverse;
    let [from_second, from_first] = centripetal(scope, &triangle, lengths, omega, folding);
    let alpha = [(g.dot(r3) + from_second) * inverse, (g.dot(r2) + from_first) * inverse];

    let bars = [bars[0].turning(omega[0], alpha[0]), bars[1].turning(omega[1], alpha[1])];
    // The pin is carried by the bar that stands on the ground, if one does: one sum less.
    let carrier = usize::from(d.is_fixed());
    let pin = bars[carrier].pin();
    let links = bars.iter().zip(scope.links).map(|(bar, &link)| bar.link(link));
    Solved {
        links: links.collect(),
        pin: Some(pin),
        levers: Some(Levers::Rrr(levers::Rrr { r: [r2, r3], inverse })),
    }
}

/// The pin's forces on the bars, and those of the outer joints.
pub(super) struct Reactions<'s> {
    pub inner: [Vector<'s>; 2],
    pub outer: [Vector<'s>; 2],
}

pub(super) fn reactions<'s>(
    levers::Rrr { r: [r2, r3], inverse }: levers::Rrr<'s>,
    [first, second]: [Acting<'s>; 2],
    on_pin: Vector<'s>,
) -> Reactions<'s> {
    let from_second = (second.moment + r3.cross(on_pin)) * inverse;
    let from_first = first.moment * inverse;
    let on_first = -(from_second * r2 + from_first * r3);
    let on_second = on_pin - on_first;
    let outer = [-(first.force + on_first), -(second.force + on_second)];
    Reactions { inner: [on_first, on_second], outer }
}

fn triangle<'s>(
    scope: &GroupScope<'s>,
    joints: [PointMotion<'s>; 2],
    lengths: [Jet<'s>; 2],
    mode: Sym<'s>,
) -> Triangle<'s> {
    let (d, [l2, l3]) = (joints[0].to(joints[1]), lengths.map(|length| length.value));
    let operands = [d.x, d.y, l2, l3];
    let square = d.dot(d).provided(Check::Square, scope.group, &operands);
    let inverse = scope.call("inverse d2", scope.call("d2", square).recip());
    let plain = half_sine(joints, lengths);
    let scale = plain.scale.value;
    let (near, rounded, spread) = match scope.numerics {
        Numerics::Plain | Numerics::Fast => {
            (plain.near.value, plain.square.value, spread(d, [l2, l3], scale))
        }
        Numerics::Compensated => {
            let [near, far] = carried(d, [l2, l3]);
            (near, (near * scale) * (far * scale), d.x.sheet().zero())
        }
    };
    scope.call("i", near);
    let circles = [d.x, d.y, l2, l3, spread];
    let square = scope.call("s", rounded.provided(Check::ReachCircles, scope.group, &circles));
    let root = scope.call("root s", mode * square.sqrt());
    let height = scope.call("h", (l2 * l3).twice() * inverse * root);
    // With equal bars a = b = d²/(2 d²) is one half: an identity wherever 1/d² exists.
    let (difference, half) = (l2 - l3, near.half());
    let shares = [half + l2 * difference, half - l3 * difference];
    scope.call("a d2", shares[0]);
    scope.call("b d2", shares[1]);
    let along = if difference.is_zero() {
        [d.x.sheet().integer(1).half(); 2]
    } else {
        let decided = |name, share: Sym<'s>, [near, far]: [Sym<'s>; 2]| {
            let operands = [rounded, d.x, d.y, near, far, spread];
            let along = (share * inverse).provided(Check::ShareOfCentres, scope.group, &operands);
            scope.call(name, along)
        };
        [decided("a", shares[0], [l2, l3]), decided("b", shares[1], [l3, l2])]
    };
    Triangle { scale, square, root, height, shares, half, along }
}

/// What S is rounded in the last places of. With i made of d² and (l₂ − l₃)², which its roundings are
/// shares of, and d² the larger of the two where S is rounded up from below zero, S is wrong by up to
/// 2.5 ε of d²/4l₂l₃; with d² affine in the crank's cosine and sine by up to 9 ε against the rounded
/// joints that the limit is decided on (`passes/affine.rs`: 26 ε l²/2 for the form and as much for the
/// joints at a shortest distance of 2 l). That is (l₂ + l₃)²/4l₂l₃ at most where there is a limit to
/// pass, known before run time if the lengths are.
fn spread<'s>(d: Vector<'s>, [l2, l3]: [Sym<'s>; 2], scale: Sym<'s>) -> Sym<'s> {
    let square = if scale.is_constant() { (l2 + l3).squared() } else { d.dot(d) };
    square * scale
}

/// (ω₂² r₂ − ω₃² r₃)·r₃ and ·r₂, with `folding` = ω₂ − ω₃.
fn centripetal<'s>(
    scope: &GroupScope<'s>,
    triangle: &Triangle<'s>,
    lengths: [Jet<'s>; 2],
    [omega2, omega3]: [Sym<'s>; 2],
    folding: Sym<'s>,
) -> [Sym<'s>; 2] {
    let [l2, l3] = lengths.map(|length| length.value);
    let [to_second, to_third] = triangle.shares;
    let square2 = scope.call("omega2 squared", omega2.squared());
    let square3 = scope.call("omega3 squared", omega3.squared());
    if differ(l2, l3) {
        let cosine = scope.call("r2 r3", l2 * l3 - triangle.half);
        return [
            square2 * cosine - square3 * l3.squared(),
            square2 * l2.squared() - square3 * cosine,
        ];
    }
    let p = weight_of_second(l2, l3);
    let q = p.sheet().integer(1) - p;
    let (mean, length) = (p * square3 + q * square2, p * l2 + q * l3);
    let difference = folding * (omega2 + omega3);
    [
        difference * (l3 * length - p * triangle.half) - mean * to_third,
        difference * (l2 * length - q * triangle.half) + mean * to_second,
    ]
}

/// Whether the bars are known to differ by a seventh of their sum, which is a quarter of the longer:
/// then no more than two bits cancel in ω₂² r₂ − ω₃² r₃.
fn differ<'s>(l2: Sym<'s>, l3: Sym<'s>) -> bool {
    let share = (l2 - l3) / (l2 + l3);
    share.squared().constant_value().is_some_and(|square| square >= 1.0 / 49.0)
}

/// p: between bars that are known to be nearly of one length any weight will do.
fn weight_of_second<'s>(l2: Sym<'s>, l3: Sym<'s>) -> Sym<'s> {
    if (l2 - l3).is_constant() { l2.sheet().integer(1) } else { l3 / (l2 + l3) }
}

/// What the angle μ between the bars follows from: i = 2 l₂ l₃ (1 − cos μ), and S = sin² μ/4, which
/// is smooth, vanishes at both toggles and is negative out of reach.
struct HalfSine<'s> {
    /// i
    near: Jet<'s>,
    /// 1/4l₂l₃
    scale: Jet<'s>,
    /// S
    square: Jet<'s>,
}

fn half_sine<'s>(joints: [PointMotion<'s>; 2], [l2, l3]: [Jet<'s>; 2]) -> HalfSine<'s> {
    let [x, y] = joints[0].jets_to(joints[1]);
    let (difference, product) = (l2 - l3, (l2 * l3).twice().twice());
    let near = x * x + y * y - difference * difference;
    let scale = Jet::constant(x.value.sheet().integer(1)) / product;
    // The difference of lengths, not 1 − i/4l₂l₃: that would be the rounding of 1/4l₂l₃ where a fused
    // operation takes it, and no zero at a toggle that the data hit.
    let far = product - near;
    HalfSine { near, scale, square: (near * scale) * (far * scale) }
}

/// i and 4 l₂ l₃ − i with the rounding errors of every sum and square put back.
fn carried<'s>(d: Vector<'s>, lengths: [Sym<'s>; 2]) -> [Sym<'s>; 2] {
    let square = DoubleWord::square_of(d, DoubleWord::of_coordinate);
    let [l2, l3] = lengths.map(DoubleWord::of_sum);
    [square.difference((l2 - l3).squared()), (l2 + l3).squared().difference(square)]
}

/// Signed distance from the limit in metres, 2 l₂ l₃ S/d with slope one against d at both toggles,
/// and sine of the transmission angle, 2 √S.
pub(super) fn quality<'s>(
    joints: [PointMotion<'s>; 2],
    lengths: [Jet<'s>; 2],
) -> LimitMeasures<'s> {
    let (square, [x, y]) = (half_sine(joints, lengths).square, joints[0].jets_to(joints[1]));
    let margin = square * ((lengths[0] * lengths[1]).twice() / x.hypot(y));
    LimitMeasures { margin: Some(margin), transmission: root_in_reach(square).twice() }
}

/// S. Where one bar is long or the joints are far away, so is the rounding of i against l₂ l₃.
pub(super) fn clearance<'s>(joints: [PointMotion<'s>; 2], lengths: [Jet<'s>; 2]) -> Clearance<'s> {
    let HalfSine { scale, square, .. } = half_sine(joints, lengths);
    let [l2, l3] = lengths.map(|length| length.value.squared());
    let squares = l2 + l3 + size(joints[0], joints[1]);
    Clearance { value: square, scale: squares * scale.value.half() }
}
