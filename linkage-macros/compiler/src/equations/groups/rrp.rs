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
//! The factors keep full accuracy at the limit |t| = l. A guide whose origin is far away costs last places of
//! that distance in y, as rounding the guide's direction does; along an axis it costs nothing.
//!
//! # Velocity and acceleration
//! As seen from the guide, which may turn with ω_g and α_g: with ρ = B − K the pivot moves with
//!
//! ```text
//! v = v_B − (v_K + ω_g ρ⊥)        a = a_B − (a_K + α_g ρ⊥ − ω_g² ρ + 2 ω_g v⊥)
//! ```
//!
//! and the bar turns with ω against the guide. The pin goes along u with ṡ and along n with ė, so
//! by v + l̇ r/l + ω r⊥ = ṡ u + ė n and its derivative, with r⊥ = X n − t u,
//!
//! ```text
//! ω = (ė − v·n − l̇ t/l)/X                            ṡ = v·u − ω t + l̇ X/l
//! α = (ë − a·n + ω² t − l̈ t/l − 2 ω l̇ X/l)/X        s̈ = a·u − α t − ω² X + l̈ X/l − 2 ω l̇ t/l
//! ```
//!
//! Seen from the ground the bar turns with ω_g + ω. What guide and bar have in common never enters
//! and need not cancel.
//!
//! # Reactions
//! With L all that acts on the pin from outside the group, F and M what acts on bar (2) and block (3)
//! but for their own joints, M about B and about C: the forces along the guide on block and pin
//! are the bar's, and the bar's moment gives what is across,
//!
//! ```text
//! p_u = (L + F₃)·u               p_n = (t p_u − M₂)/X
//! P₂ = p_u u + p_n n             P₃ = L − P₂
//! N = p_n − (F₃ + L)·n           T = −M₃
//! R_B = −F₂ − P₂
//! ```
//!
//! with the velocities' 1/X. N and T are the guide's on the block, at the pin.
//!
//! # Sign
//! `ahead` (+1): C ahead of the foot of B on the guide, along its direction.
//!
//! # Error
//! At most 4 times what the data allow next to the limit. On random poses 2.2 times for
//! positions, 10.5 for velocities, 7.1 for accelerations; in the hill-climbed worst case 2.8, 32
//! and 41, with guides nearly along an axis through the origin. The pin is as right as its slide or
//! its bar is long, whichever carries it. With `numerics compensated;` X is within 2.5 ε of itself
//! however near the limit, if length, offset and y are exact (`tests/limits/compensated.rs`).
//!
//! # Source
//! Norton, Design of Machinery, ch. 4 (slider-crank) in the axes of the guide.

use crate::equations::double_word::DoubleWord;
use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{
    Bar, Block, ClearanceTerms, GroupScope, LimitMeasures, LinkMotion, Solved, root_in_reach, size,
};
use crate::equations::reactions::{
    GuideReaction, Inner, JacobianFactors, Loads, Reaction, Reactions,
};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::{Group, Numerics};

pub(super) struct Rrp;

impl Formulas for Rrp {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let (b, guide) = (known.stands_on(group, 0), known.slides_on(group, 1));
        let (length, offset) = (known.bar_length(group, 0), known.offset_in(&group.outer[1]));
        rrp(&known.scope(group), b, guide, length, offset, known.mode_of(group))
    }

    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        let (b, guide) = (known.stands_on(group, 0), known.slides_on(group, 1));
        let (length, offset) = (known.bar_length(group, 0), known.offset_in(&group.outer[1]));
        Some(measures(b, guide, length, offset))
    }

    fn clearance<'s>(
        &self,
        known: &Kinematics<'s>,
        group: &'s Group,
    ) -> Option<ClearanceTerms<'s>> {
        let (b, guide) = (known.stands_on(group, 0), known.slides_on(group, 1));
        let length = known.jet(&group.length(0).value);
        Some(clearance(b, guide, length, known.offset_in(&group.outer[1])))
    }
}

fn rrp<'s>(
    scope: &GroupScope<'s>,
    b: PointMotion<'s>,
    guide: Frame<'s>,
    length: Jet<'s>,
    offset: Jet<'s>,
    mode: Sym<'s>,
) -> Solved<'s> {
    let (u, n) = (guide.direction.u, guide.direction.n());
    let from = scope.call_vector("rho", guide.origin.to(b));
    let foot = scope.label("x", from.dot(u));
    let l = length.value;
    let (t, square) = match scope.numerics {
        Numerics::Plain => (across(b, guide, offset).value, legs(b, guide, length, offset).value),
        Numerics::Compensated => {
            let y = exact_distance(b, guide);
            (offset.value - y, carried(l, offset.value, y))
        }
    };
    scope.label("t", t);
    let square = square.guarded_by(Check::ReachLine, scope.group, &[t, l]);
    let magnitude = square.sqrt();
    let reach = scope.label("reach", mode * magnitude);
    let slide = scope.label("slide", foot + reach);
    let r = scope.call_vector("r", reach * u + t * n);
    let bar = Bar::new(b, r, length, l.recip());

    let inverse = mode * scope.over_root(scope.builder.integer(1), magnitude);
    scope.label("inverse reach", inverse);
    let v = b.velocity - guide.transport_at(b, scope.builder.zero_vector()).0;
    let a = b.acceleration - guide.transport_at(b, v).1;
    scope.call_vector("v", v);
    scope.call_vector("a", a);
    // The bar's direction in the guide's axes; of a bar of constant length nothing of it remains.
    let (along, across) = (reach * l.recip(), t * l.recip());
    let omega = (offset.rate - v.dot(n) - length.rate * across) * inverse;
    let slide_rate = v.dot(u) - omega * t + length.rate * along;
    scope.label("omega", omega);
    let coriolis = (omega * length.rate).twice();
    let pushed_across = length.accel * across + coriolis * along;
    let pushed_along = length.accel * along - coriolis * across;
    let alpha = (offset.accel - a.dot(n) + omega.squared() * t - pushed_across) * inverse;
    let slide_accel = a.dot(u) - alpha * t - omega.squared() * reach + pushed_along;

    scope.label("alpha", alpha);
    let Direction { omega: guide_omega, alpha: guide_alpha, .. } = guide.direction;
    let bar = bar.turning(guide_omega + omega, guide_alpha + alpha);
    let pin = pin(guide, bar, Block::new(guide, slide, offset), slide_rate, slide_accel);
    let slide = Jet { value: slide, rate: slide_rate, accel: slide_accel };
    let block =
        LinkMotion { frame: Frame { origin: pin, direction: guide.direction }, slide: Some(slide) };
    Solved {
        links: vec![bar.link(scope.links[0]), block],
        pin: Some(pin),
        bars: vec![bar.vector()],
        levers: Some(Box::new(RrpLevers { u, n, length: l, across: t, inverse })),
    }
}

/// The pin as the bar's end and as the block's. A guide that stands still carries it, along an axis
/// without touching the guide's own coordinate; elsewhere the pin is nearer to B than to the guide's
/// origin.
fn pin<'s>(
    guide: Frame<'s>,
    bar: Bar<'s>,
    block: Block<'s>,
    slide_rate: Sym<'s>,
    slide_accel: Sym<'s>,
) -> PointMotion<'s> {
    let on_guide = block.pin(slide_rate, slide_accel, block.carried_acceleration(slide_rate));
    let on_bar = bar.pin();
    let u = guide.direction.u;
    if !guide.is_fixed() {
        on_bar
    } else if u.x.is_zero() || u.y.is_zero() {
        on_guide
    } else {
        PointMotion { base: on_bar.base, offset: on_bar.offset, ..on_guide }
    }
}

/// The guide's axes, the bar's length, t of it in them, and 1/X.
struct RrpLevers<'s> {
    u: Vector<'s>,
    n: Vector<'s>,
    length: Sym<'s>,
    across: Sym<'s>,
    inverse: Sym<'s>,
}

impl<'s> JacobianFactors<'s> for RrpLevers<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s> {
        let (&Self { u, n, across, inverse, .. }, [bar, block]) = (self, loads.links);
        let outside = loads.pin + block.force;
        let along = outside.dot(u);
        let normal = (across * along - bar.moment) * inverse;
        let on_bar = along * u + normal * n;
        let guide = GuideReaction { normal: normal - outside.dot(n), couple: -block.moment };
        let inner = Inner::Pin([on_bar, loads.pin - on_bar]);
        let outer = Reaction::Force(-(bar.force + on_bar));
        Reactions { outer: [outer, Reaction::Guide(guide)], inner }
    }

    fn gains(&self) -> [Sym<'s>; 2] {
        [self.inverse, self.length * self.inverse]
    }
}

/// The distance y of B from the guide, within rounding of itself.
fn exact_distance<'s>(b: PointMotion<'s>, guide: Frame<'s>) -> Sym<'s> {
    let (from, u) = (guide.origin.to(b), guide.direction.u);
    u.x.builder().det(u.x, from.y, u.y, from.x)
}

/// t = e − y.
fn across<'s>(b: PointMotion<'s>, guide: Frame<'s>, offset: Jet<'s>) -> Jet<'s> {
    let [x, y] = guide.origin.jets_to(b);
    let [ux, uy] = guide.direction.jets();
    offset - (ux * y - uy * x)
}

/// X² = (l − t)(l + t), which is smooth, vanishes at the limit and is negative out of reach.
fn legs<'s>(b: PointMotion<'s>, guide: Frame<'s>, l: Jet<'s>, offset: Jet<'s>) -> Jet<'s> {
    let t = across(b, guide, offset);
    (l - t) * (l + t)
}

/// (l − t)(l + t) with t's rounding error put back: next to the limit nothing is lost of y.
fn carried<'s>(l: Sym<'s>, offset: Sym<'s>, y: Sym<'s>) -> Sym<'s> {
    let t = DoubleWord::of_sum(offset) - DoubleWord::of_coordinate(y);
    let l = DoubleWord::of_sum(l);
    l.difference(t) * l.difference(-t)
}

/// Signed distance from the limit in metres, X²/(2 l), and the transmission angle between the bar from B to C and
/// the guide's normal, of sine |X|/l and cosine t/l.
fn measures<'s>(
    b: PointMotion<'s>,
    guide: Frame<'s>,
    l: Jet<'s>,
    offset: Jet<'s>,
) -> LimitMeasures<'s> {
    let (square, t) = (legs(b, guide, l, offset), across(b, guide, offset));
    let transmission = root_in_reach(square).atan2(t);
    LimitMeasures { margin: Some(square / l.twice()), transmission }
}

/// X².
fn clearance<'s>(
    b: PointMotion<'s>,
    guide: Frame<'s>,
    l: Jet<'s>,
    offset: Jet<'s>,
) -> ClearanceTerms<'s> {
    let squares = l.value.squared() + offset.value.squared();
    ClearanceTerms { value: legs(b, guide, l, offset), scale: squares + size(guide.origin, b) }
}
