//! The dyad RPR: a block pinned to B slides on a bar that turns about D.
//!
//! # Position
//! The bar's direction is u, its normal n, and the block keeps the offset e from the pivot:
//! b = B − D = s u + e n. So
//!
//! ```text
//! s = ± √(b² − e²),  + where B is on the bar's positive side
//! u = (s b − e b⊥) / b²      n = u⊥
//! ```
//!
//! b² − e² is made with the rounding errors of its squares put back, so that it keeps its digits
//! where the block comes to the foot of the pivot; without an offset nothing of that remains, nor where
//! constants keep |b| above 2 |e|, so that b² − e² is at least three quarters of b².
//!
//! # Velocity and acceleration
//! Differentiating b = s u + e n, with Δv = v_B − v_D, Δa = a_B − a_D:
//!
//! ```text
//! ω = (Δv·n − ė)/s                      ṡ = (Δv·b − e ė)/s
//! α = (Δa·n + ω² e − 2 ω ṡ − ë)/s       s̈ = Δa·u + α e + ω² s + 2 ω ė
//! ```
//!
//! where ṡ is Δv·u + ω e without what cancels in it; without an offset it is Δv·u.
//!
//! # Behind a crank
//! Where B swings with the arm a about the point A of the ground, at Ω, and D is a point of the ground, G = D − A,
//! b is a − G. Without an offset the angles of crank and bar are then related by
//!
//! ```text
//! ω = Ω a·b/b²      α = (Ω̇ a·b + Ω² (a⊥·b)(G² − a²)/b²)/b²
//! ṡ = Ω a⊥·b/s      s̈ = (Ω̇ a⊥·b + Ω² (a·b)(G·b)/b²)/s
//! ```
//!
//! in which Δa·n − 2 ω ṡ and Δa·u + ω² s, which cancel where G and a are of nearly one length, are products.
//!
//! # Reactions
//! With F and M what acts on block (2) and bar (3) but for their own joints, M about B and about D:
//!
//! ```text
//! N = (M₃ + M₂)/s      T = −M₂
//! R_B = −F₂ − N n      R_D = −F₃ + N n
//! ```
//!
//! N and T are the bar's on the block, at B: the bar's own moment about D is M₃ − T − s N = 0.
//!
//! # Sign
//! `ahead` (+1): s positive.
//!
//! # Error
//! At most 4 times what the data allow next to the limit, and without an offset at the
//! pivot. On random poses 1.9 times for positions, 2.6 for velocities, 12.2 for accelerations of joints that move anyhow; in
//! the hill-climbed worst case 2.3, 3.4 and 46. Where the joints' difference is exact, so is s,
//! within ε of itself; `numerics compensated;` puts the rounding of that difference back where both
//! joints are given by inputs and constants (`tests/limits/compensated.rs`).
//!
//! # Source
//! Norton, Design of Machinery, ch. 4 (inverted slider-crank) with the bar's own axes.

use crate::equations::double_word::DoubleWord;
use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, PointMotion, RelativeAngle, Swing};
use crate::equations::parts::{
    ClearanceTerms, GroupScope, LimitMeasures, LinkMotion, Solved, root_in_reach, size,
};
use crate::equations::reactions::{
    Acting, GuideReaction, Inner, JacobianFactors, Loads, Reaction, Reactions,
};
use crate::equations::symbol::{Sym, Vector};
use crate::exact::Exact;
use crate::ir::graph::Check;
use crate::model::mechanism::{Carrier, Group, Numerics};

pub(super) struct Rpr;

impl Formulas for Rpr {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let (joints, offset) = (known.both_joints(group), known.offset_in(&group.inner[0]));
        rpr(&known.scope(group), joints, offset, known.mode_of(group))
    }

    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        let (joints, offset) = (known.both_joints(group), known.offset_in(&group.inner[0]));
        Some(measures(known.mechanism.numerics, joints, offset))
    }

    fn clearance<'s>(
        &self,
        known: &Kinematics<'s>,
        group: &'s Group,
    ) -> Option<ClearanceTerms<'s>> {
        let (joints, offset) = (known.both_joints(group), known.offset_in(&group.inner[0]));
        Some(clearance(known.mechanism.numerics, joints, offset))
    }
}

fn rpr<'s>(
    scope: &GroupScope<'s>,
    [b, d]: [PointMotion<'s>; 2],
    offset: Jet<'s>,
    mode: Sym<'s>,
) -> Solved<'s> {
    let from = scope.call_vector("b", d.to(b));
    let e = offset.value;
    let square = from.dot(from);
    let sound = scope.label("b2", square.guarded_by(Check::Square, scope.group, &[]));
    let (s, u, inverse) = if e.is_zero() {
        // s² = b² and u = b/s.
        let magnitude = sound.sqrt();
        let inverse = mode * magnitude.recip();
        (mode * magnitude, inverse * from, inverse)
    } else {
        let left = left_of_offset(scope.numerics, [b, d], offset).value;
        let operands = [from.x, from.y, e];
        let left = scope.label("s2", left.guarded_by(Check::ReachOffset, scope.group, &operands));
        let magnitude = left.sqrt();
        let s = mode * magnitude;
        let u = sound.recip() * (s * from - e * from.normal());
        (s, u, mode * scope.over_root(scope.builder.integer(1), magnitude))
    };
    scope.label("s", s);
    scope.label("inverse s", inverse);
    scope.call_vector("u", u);
    let swinging = (e.is_zero() && d.is_fixed()).then_some(b.swing).flatten();
    let rates = match swinging {
        Some(swing) => {
            let arm = Arm::of(swing, d.base - b.base, from, sound);
            behind_crank(swing, arm, sound.recip(), inverse)
        }
        None => sliding([b, d], from, offset, [s, inverse], u),
    };
    let [(omega, alpha), (slide_rate, slide_accel)] = rates;
    let slide = Jet { value: s, rate: slide_rate, accel: slide_accel };
    let turned = Some(RelativeAngle::start(Carrier::Link(scope.links[1]), scope.builder));
    let direction = Direction { u, omega, alpha, turned };
    let link = |origin, slide| LinkMotion { frame: Frame { origin, direction }, slide };
    Solved {
        links: vec![link(b, Some(slide)), link(d, None)],
        pin: None,
        bars: Vec::new(),
        levers: Some(Box::new(RprLevers { u, e, inverse })),
    }
}

/// ω and α, ṡ and s̈ of joints that move anyhow.
fn sliding<'s>(
    [b, d]: [PointMotion<'s>; 2],
    from: Vector<'s>,
    offset: Jet<'s>,
    [s, inverse]: [Sym<'s>; 2],
    u: Vector<'s>,
) -> [(Sym<'s>, Sym<'s>); 2] {
    let ([along, across], e) = (b.rates_against(d, u), offset.value);
    let omega = (across.velocity - offset.rate) * inverse;
    let slide_rate = if e.is_zero() {
        along.velocity
    } else {
        ((b.velocity - d.velocity).dot(from) - e * offset.rate) * inverse
    };
    let turning = omega.squared() * e - (omega * slide_rate).twice() - offset.accel;
    let alpha = (across.acceleration + turning) * inverse;
    let slide_accel =
        along.acceleration + alpha * e + omega.squared() * s + (omega * offset.rate).twice();
    [(omega, alpha), (slide_rate, slide_accel)]
}

/// ω and α, ṡ and s̈ behind a crank, without an offset.
fn behind_crank<'s>(
    swing: Swing<'s>,
    arm: Arm<'s>,
    over_square: Sym<'s>,
    inverse: Sym<'s>,
) -> [(Sym<'s>, Sym<'s>); 2] {
    let square = swing.omega.squared();
    let (along, aside) = (arm.along * over_square, arm.aside * over_square);
    let omega = swing.omega * along;
    let alpha = (swing.alpha * arm.along + square * (aside * arm.difference)) * over_square;
    let slide_rate = swing.omega * (arm.aside * inverse);
    let slide_accel = (swing.alpha * arm.aside + square * (along * arm.pivot)) * inverse;
    [(omega, alpha), (slide_rate, slide_accel)]
}

/// Products of a crank's arm a and of G = D − A with b, the line from D to the crank's pin.
struct Arm<'s> {
    /// a·b
    along: Sym<'s>,
    /// a⊥·b
    aside: Sym<'s>,
    /// G·b
    pivot: Sym<'s>,
    /// G² − a²
    difference: Sym<'s>,
}

impl<'s> Arm<'s> {
    /// The products of a and G with b, of which a·b − G·b is b²: the smaller vector's product is the one that is
    /// computed of its coordinates. And a⊥·b is G × a.
    fn of(swing: Swing<'s>, pivot: Vector<'s>, line: Vector<'s>, square: Sym<'s>) -> Self {
        let difference = pivot.dot(pivot) - swing.square();
        let (of_arm, of_pivot) = (|| swing.arm.dot(line), || pivot.dot(line));
        let (along, of_pivot) = match difference.constant_value() {
            Some(difference) if difference >= 0.0 => (of_arm(), of_arm() - square),
            Some(_) => (of_pivot() + square, of_pivot()),
            None => (of_arm(), of_pivot()),
        };
        Self { along, aside: pivot.cross(swing.arm), pivot: of_pivot, difference }
    }
}

/// The bar's direction, e and 1/s.
struct RprLevers<'s> {
    u: Vector<'s>,
    e: Sym<'s>,
    inverse: Sym<'s>,
}

impl<'s> JacobianFactors<'s> for RprLevers<'s> {
    fn reactions(&self, loads: &Loads<'s>) -> Reactions<'s> {
        let (&Self { u, e, inverse }, [block, bar]) = (self, loads.links);
        // The force S transmitted along the bar acts between the two: (s u + e n) × −S u = e S.
        let force = bar.force - loads.along * u;
        let bar = Acting { force, moment: bar.moment + e * loads.along };
        let normal = (bar.moment + block.moment) * inverse;
        let push = normal * u.normal();
        let inner = Inner::Slide(GuideReaction { normal, couple: -block.moment });
        let outer = [-(block.force + push), push - bar.force].map(Reaction::Force);
        Reactions { outer, inner }
    }

    fn gains(&self) -> [Sym<'s>; 2] {
        // The block's is |b|/s, of which s and e are the sides.
        let one = self.inverse.builder().integer(1);
        [one + (self.e * self.inverse).magnitude(), self.inverse]
    }
}

/// s² = b² − e², which is smooth, vanishes at the limit and is negative out of reach; its value
/// with the rounding errors of the squares and of their sum put back.
fn left_of_offset<'s>(numerics: Numerics, [b, d]: [PointMotion<'s>; 2], e: Jet<'s>) -> Jet<'s> {
    let [x, y] = d.jets_to(b);
    let plain = x * x + y * y - e * e;
    if e.is_zero() || numerics == Numerics::Plain && stays_beyond([b, d], e) {
        return plain;
    }
    let coordinate = match numerics {
        Numerics::Plain => DoubleWord::of,
        Numerics::Compensated => DoubleWord::of_coordinate,
    };
    let square = DoubleWord::square_of(d.to(b), coordinate);
    let value = square.difference(coordinate(e.value).squared());
    Jet { value, ..plain }
}

/// True if the joints are known to stay at least twice the offset apart.
fn stays_beyond<'s>([b, d]: [PointMotion<'s>; 2], e: Jet<'s>) -> bool {
    let offset = e.value.constant_value().filter(|_| e.is_fixed());
    let least = d.least_distance(b).zip(offset);
    least.is_some_and(|(distance, offset)| distance >= 2.0 * offset.abs())
}

/// Signed distance from the limit in metres, (b² − e²)/(|b| + |e|) = |b| − |e|, and the transmission angle between the
/// bar's normal and the line from D to B, of sine √(b² − e²)/|b| and cosine e/|b|.
fn measures<'s>(numerics: Numerics, [b, d]: [PointMotion<'s>; 2], e: Jet<'s>) -> LimitMeasures<'s> {
    let [x, y] = d.jets_to(b);
    let reach = x.hypot(y);
    if e.is_zero() {
        let right = Jet::constant(e.value.builder().constant(Exact::pi()).half());
        return LimitMeasures { margin: Some(reach), transmission: right };
    }
    let left = left_of_offset(numerics, [b, d], e);
    let zero = Jet::zero(e.value.builder());
    let transmission = root_in_reach(left).atan2(e);
    LimitMeasures { margin: Some(left / (reach + e.hypot(zero))), transmission }
}

/// b² − e².
fn clearance<'s>(
    numerics: Numerics,
    [b, d]: [PointMotion<'s>; 2],
    e: Jet<'s>,
) -> ClearanceTerms<'s> {
    let scale = e.value.squared() + size(d, b);
    ClearanceTerms { value: left_of_offset(numerics, [b, d], e), scale }
}
