//! The dyad RRR: two bars pinned to B and D and to each other at C.
//!
//! # Position
//! With d = D − B, the joint C of the bars l₂ (from B) and l₃ (from D) lies at
//! r₂ = C − B = a d + h d⊥, where
//!
//! ```text
//! i = d² − (l₂ − l₃)²                  a = (i + 2 l₂ (l₂ − l₃)) / 2d²
//! 4 J² = i (4 l₂ l₃ − i)               b = (i + 2 l₃ (l₃ − l₂)) / 2d² = 1 − a
//! h = 2 J/2d²                          J = r₂ × r₃, above zero where C is left of B → D
//! ```
//!
//! and r₃ = C − D = −b d + h d⊥. This is Heron's formula with the two factors that can vanish,
//! (d − |l₂ − l₃|)(d + |l₂ − l₃|) at the inner toggle and (l₂ + l₃ − d)(l₂ + l₃ + d) at the outer
//! one, made from the same i: its rounding acts like one of d alone, so that the bars keep their
//! lengths even where a short bar stands across a long one.
//!
//! Where it is known which bar is the shorter one, that one alone is computed so; the longer one is it and
//! d, which loses nothing. J² is in m⁴, for which f32 has room where constant lengths say so
//! (`triangle.rs`). Elsewhere (J/l₂l₃)² stands in its place, in which no power is above the second, and
//! 1/l₂l₃ gives 1/l₂ and 1/l₃.
//!
//! # Velocity and acceleration
//! Both bars give the joint the same velocity: v_B + l̇₂ u₂ + ω₂ r₂⊥ = v_D + l̇₃ u₃ + ω₃ r₃⊥.
//! With w = (v_D + l̇₃ u₃) − (v_B + l̇₂ u₂), taking the product with r₃ and r₂:
//!
//! ```text
//! ω₂ = (w · r₃)/J        ω₃ = (w · r₂)/J
//! ```
//!
//! The same with accelerations, w replaced by g + ω₂² r₂ − ω₃² r₃ with
//! g = a_D + l̈₃ u₃ + 2 ω₃ l̇₃ u₃⊥ − (a_B + l̈₂ u₂ + 2 ω₂ l̇₂ u₂⊥).
//!
//! A group whose outer joints stand on one link, as a hydraulic cylinder's do, is solved in that link's frame,
//! in which they are at rest and d² is constant. The bars' vectors are turned with the link then, and ω and α
//! added to its own.
//!
//! Behind a crank (`crank_pin.rs`) w and g are made of its arm: `turning.rs`.
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
//! where the outer joints of equal bars meet. On random poses 2.5 times for positions, 9.4 for
//! velocities, 4.2 for accelerations; in the hill-climbed worst case 3.2, 23 and 15, where a long
//! bar's end moves fast and the pin at its other end hardly: the velocity of a pin between moving
//! joints is that of the first joint and its bar's.
//!
//! With `numerics compensated;` i is right to a few last places however near the toggle, if lengths
//! and joints are exact: constants count with all their digits, and the rounding errors of sums,
//! of squares, and of the difference of two joints that are given by inputs and constants are put
//! back. Directions are then within 5.5 ε, and ω and α lose no more than their own formulas do
//! (`tests/limits/compensated.rs`). A crank's pin is rounded before the group sees it, by as much as
//! the difference D − B is rounded after; neither is put back.
//!
//! # Numbers
//! Two divisions and one root for everything; a third division where the bars' lengths are not
//! constants. Bars equal in pairs pass through change points, where `left` or `right` turns a parallelogram into
//! an antiparallelogram; `parallel` keeps it one (`parallel.rs`).

mod parallel;
mod triangle;
mod turning;

use crate::equations::crank_pin::CrankPin;
use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{
    Bar, ClearanceTerms, GroupScope, LimitMeasures, Solved, root_in_reach, size,
};
use crate::equations::reactions::{Inner, JacobianFactors, Loads, Reaction, Reactions};
use crate::equations::symbol::{Sym, Vector};
use crate::model::mechanism::{Carrier, Group, LinkId};
use parallel::ParallelBars;

pub(super) struct Rrr;

impl Formulas for Rrr {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        if let Some(opposite) = group.opposite() {
            return ParallelBars(opposite).solve(known, group);
        }
        let (outer, lengths) = (Outer::of(known, group), known.lengths(group));
        rrr(&known.scope(group), outer, lengths, known.mode_of(group))
    }

    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        if let Some(opposite) = group.opposite() {
            return ParallelBars(opposite).measures(known, group);
        }
        Some(measures(Outer::of(known, group).seen, known.lengths(group)))
    }

    fn clearance<'s>(
        &self,
        known: &Kinematics<'s>,
        group: &'s Group,
    ) -> Option<ClearanceTerms<'s>> {
        let lengths = [0, 1].map(|bar| known.jet(&group.length(bar).value));
        Some(clearance(Outer::of(known, group).seen, lengths))
    }
}

/// The outer joints, and as they are seen from the frame in which the group is solved.
#[derive(Clone, Copy)]
struct Outer<'s> {
    joints: [PointMotion<'s>; 2],
    frame: Frame<'s>,
    seen: [PointMotion<'s>; 2],
}

impl<'s> Outer<'s> {
    /// Seen from the link on which both of them stand, or from the ground.
    fn of(known: &Kinematics<'s>, group: &Group) -> Self {
        let outer = [0, 1].map(|bar| group.stands_on(bar));
        let joints = outer.map(|joint| known.point(joint));
        let place = |link, joint| known.coordinates.get(&(Carrier::Link(link), joint)).copied();
        let common = (0..known.links.len()).find_map(|link| {
            let link = LinkId(link as u32);
            Some((link, [place(link, outer[0])?, place(link, outer[1])?]))
        });
        match common {
            Some((link, places)) => {
                let frame = known.link(link).frame;
                Self { joints, frame, seen: places.map(|[x, y]| PointMotion::placed(x, y)) }
            }
            None => Self { joints, frame: Frame::ground(known.builder), seen: joints },
        }
    }
}

fn rrr<'s>(
    scope: &GroupScope<'s>,
    Outer { joints, frame, seen }: Outer<'s>,
    lengths: [Jet<'s>; 2],
    mode: Sym<'s>,
) -> Solved<'s> {
    let triangle = triangle::triangle(scope, seen, lengths.map(|length| length.value), mode);
    let bars = |joints: [PointMotion<'s>; 2], r: [Vector<'s>; 2]| {
        [0, 1].map(|k| Bar::new(joints[k], r[k], lengths[k], triangle.over_length(k)))
    };
    let r = triangle.bars(scope);
    let turning = triangle.turning(scope, bars(seen, r), lengths);
    let r = r.map(|r| frame.vector(r.x, r.y));
    scope.call_vector("r2", r[0]);
    scope.call_vector("r3", r[1]);
    let Direction { omega, alpha, .. } = frame.direction;
    let bars = bars(joints, r);
    let bars = [0, 1].map(|k| bars[k].turning(omega + turning[k].0, alpha + turning[k].1));
    let pin = bars[carrier(joints, lengths)].pin();
    let links = bars.iter().zip(scope.links).map(|(bar, &link)| bar.link(link));
    Solved {
        links: links.collect(),
        pin: Some(pin),
        bars: r.into(),
        levers: Some(Box::new(RrrLevers {
            r,
            lengths: triangle.lengths,
            inverse: triangle.inverse,
        })),
    }
}

/// The bar that carries the pin: the one that stands on the ground, if one does, which is one sum less;
/// else the one whose length does not change, if one does.
fn carrier<'s>([b, d]: [PointMotion<'s>; 2], [l2, l3]: [Jet<'s>; 2]) -> usize {
    let is_cylinder = !l2.is_fixed() && l3.is_fixed();
    usize::from(d.is_fixed() || is_cylinder && !b.is_fixed())
}

/// The vectors of the bars, their lengths and 1/J.
struct RrrLevers<'s> {
    r: [Vector<'s>; 2],
    lengths: [Sym<'s>; 2],
    inverse: Sym<'s>,
}

impl<'s> JacobianFactors<'s> for RrrLevers<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s> {
        let (&Self { r: [r2, r3], inverse, .. }, [first, second]) = (self, loads.links);
        let from_second = (second.moment + r3.cross(loads.pin)) * inverse;
        let from_first = first.moment * inverse;
        let on_first = -(from_second * r2 + from_first * r3);
        let on_second = loads.pin - on_first;
        let outer = [-(first.force + on_first), -(second.force + on_second)];
        Reactions { outer: outer.map(Reaction::Force), inner: Inner::Pin([on_first, on_second]) }
    }

    fn gains(&self) -> [Sym<'s>; 2] {
        let &Self { lengths: [l2, l3], inverse, .. } = self;
        [l3 * inverse, l2 * inverse]
    }
}

/// S = sin² μ/4 of the angle μ between the bars, which is smooth, vanishes at both toggles and is negative
/// out of reach. i is 2 l₂ l₃ (1 − cos μ).
struct HalfSine<'s> {
    /// 1/4l₂l₃
    scale: Jet<'s>,
    /// S
    square: Jet<'s>,
    /// cos μ
    cosine: Jet<'s>,
}

fn half_sine<'s>(joints: [PointMotion<'s>; 2], [l2, l3]: [Jet<'s>; 2]) -> HalfSine<'s> {
    let d = joints[0].to(joints[1]);
    let [rate, accel] = half_rates(joints).map(Sym::twice);
    let (difference, product) = (l2 - l3, (l2 * l3).twice().twice());
    let near = Jet { value: d.dot(d), rate, accel } - difference * difference;
    let scale = Jet::constant(d.x.builder().integer(1)) / product;
    // The difference of lengths, not 1 − i/4l₂l₃: that would be the rounding of 1/4l₂l₃ where a fused
    // operation takes it, and no zero at a toggle that the data hit.
    let far = product - near;
    let [near, far] = [near * scale, far * scale];
    HalfSine { scale, square: near * far, cosine: far - near }
}

/// Half of the rate and of the acceleration of d².
fn half_rates<'s>(joints: [PointMotion<'s>; 2]) -> [Sym<'s>; 2] {
    if let Some(crank) = CrankPin::of(joints) {
        return crank.half_rates();
    }
    let [x, y] = joints[0].jets_to(joints[1]);
    let squares = x.rate.squared() + y.rate.squared();
    let along = x.value * x.accel + y.value * y.accel;
    [x.value * x.rate + y.value * y.rate, along + squares]
}

/// Signed distance from the limit in metres, 2 l₂ l₃ S/d with slope one against d at both toggles,
/// and transmission angle μ between the bars at their pin, from sin μ = 2 √S and cos μ.
fn measures<'s>(joints: [PointMotion<'s>; 2], lengths: [Jet<'s>; 2]) -> LimitMeasures<'s> {
    let (HalfSine { square, cosine, .. }, d) =
        (half_sine(joints, lengths), joints[0].to(joints[1]));
    let over_distance = Jet::inverse_distance(d.x.hypot(d.y), half_rates(joints));
    let margin = square * ((lengths[0] * lengths[1]).twice() * over_distance);
    LimitMeasures {
        margin: Some(margin),
        transmission: root_in_reach(square).twice().atan2(cosine),
    }
}

/// S. Where one bar is long or the joints are far away, so is the rounding of i against l₂ l₃.
fn clearance<'s>(joints: [PointMotion<'s>; 2], lengths: [Jet<'s>; 2]) -> ClearanceTerms<'s> {
    let HalfSine { scale, square, .. } = half_sine(joints, lengths);
    let [l2, l3] = lengths.map(|length| length.value.squared());
    let squares = l2 + l3 + size(joints[0], joints[1]);
    ClearanceTerms { value: square, scale: squares * scale.value.half() }
}
