//! The dyad RRR under `numerics fast;`, for bars of constant lengths.
//!
//! # Position
//! With d = D − B and J = r₂ × r₃, everything about the pin is affine in J, and its coefficients are there
//! before the root is:
//!
//! ```text
//! i/2 = (d² − (l₂ − l₃)²)/2     J² = i/2 (2 l₂ l₃ − i/2)     r = ± a d + (J/d²) d⊥
//! ```
//!
//! That is of the shorter bar, with l its own length and l' the other's a d² = i/2 + l (l − l');
//! the longer one is it and d, which loses nothing. Behind a crank 2 l₂ l₃ − i/2 is affine in the same product
//! as i/2 and does not wait for it. Its own rounding makes the bars longer or shorter by last places of the
//! longer one, so that none may be more than four times as long as the other. J² is a product in m⁴, where the
//! parent has one of sines: J itself is what d⊥ and the rates take. [`is_for`] says for which lengths f32 has
//! room for it.
//!
//! # Velocity and acceleration
//! As in the parent, but where B is a pin that swings about a point A of the ground with the arm a, and D
//! a point of the ground (`crank_pin.rs`). The velocity ω a⊥ and the acceleration α a⊥ − ω² a of B lead to
//! two products with a bar r, which serve both of its rates, and are affine in J like r:
//!
//! ```text
//! a·r = ± (a/d²) a·d + (J/d²) d × a    r × a = ± (a/d²) d × a − (J/d²) a·d
//! ω₂ = ω (r₃ × a)/J       α₂ = (α (r₃ × a) + ω² a·r₃ + ω₂² r₂·r₃ − ω₃² l₃²)/J
//! ω₃ = ω (r₂ × a)/J       α₃ = (α (r₂ × a) + ω² a·r₂ + ω₂² l₂² − ω₃² r₂·r₃)/J
//! ```
//!
//! # Error
//! Some last places more than without `fast`: what a limit magnifies are two roundings of i in place of
//! one; a d² that is affine where B comes as near to D as a quarter of its farthest distance has up to four
//! times the error of the sum of squares (`crank_pin.rs`); and bars of nearly one length lose digits of their
//! accelerations where their outer joints meet, or where, nearly stretched, both turn as a crank
//! does that is much longer than the base. What is out of reach is decided as without `fast`,
//! and `tests/limits/fast.rs` holds the bounds.

use std::ops::{Add, Sub};

use super::{Solved, spread};
use crate::equations::crank_pin::CrankPin;
use crate::equations::jet::Jet;
use crate::equations::levers::{self, Levers};
use crate::equations::motion::{PointMotion, Swing};
use crate::equations::parts::{Bar, GroupScope};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;

/// The bars, the shorter of which is found first.
struct Bars<'s> {
    lengths: [Sym<'s>; 2],
    /// r₂·r₃
    cosine: Sym<'s>,
    /// Of the shorter bar: its place in the statement, ± a and 1/d².
    short: usize,
    along: Sym<'s>,
    lift: Sym<'s>,
    /// J, which has the mode's sign.
    root: Sym<'s>,
    /// 1/J
    inverse: Sym<'s>,
}

/// Whether the lengths are constant and far enough within the range of f32 for their fourth power: J² is
/// looked at down to 16 ε of its largest value.
pub(super) fn is_for([l2, l3]: [Sym<'_>; 2]) -> bool {
    (l2 * l3).constant_value().is_some_and(|product| (1e-12..1e12).contains(&product.abs()))
}

pub(super) fn rrr<'s>(
    scope: &GroupScope<'s>,
    [b, d]: [PointMotion<'s>; 2],
    lengths: [Sym<'s>; 2],
    mode: Sym<'s>,
) -> Solved<'s> {
    let line = scope.call_vector("d", b.to(d));
    let crank = CrankPin::of([b, d]);
    let bars = bars(scope, line, crank, lengths, mode);
    let [r2, r3] = bars.both(bars.of_line(line), line);
    scope.call_vector("r2", r2);
    scope.call_vector("r3", r3);
    let (omega, alpha) = match crank {
        Some(crank) => bars.swinging(scope, crank),
        None => bars.moving(scope, [b, d], [r2, r3]),
    };
    let jets = lengths.map(Jet::constant);
    let [first, second] = [Bar::new(b, r2, jets[0]), Bar::new(d, r3, jets[1])];
    let turning = [first.turning(omega[0], alpha[0]), second.turning(omega[1], alpha[1])];
    let pin = turning[usize::from(d.is_fixed())].pin();
    let links = turning.iter().zip(scope.links).map(|(bar, &link)| bar.link(link));
    Solved {
        links: links.collect(),
        pin: Some(pin),
        levers: Some(Levers::Rrr(levers::Rrr { r: [r2, r3], inverse: bars.inverse })),
    }
}

fn bars<'s>(
    scope: &GroupScope<'s>,
    line: Vector<'s>,
    crank: Option<CrankPin<'s>>,
    [l2, l3]: [Sym<'s>; 2],
    mode: Sym<'s>,
) -> Bars<'s> {
    let operands = [line.x, line.y, l2, l3];
    let square = crank.map_or_else(|| line.dot(line), CrankPin::square);
    let (product, difference) = (l2 * l3, l2 - l3);
    let (half, at_once) = match crank {
        Some(crank) => {
            let [sum, along] = crank.square_parts();
            let mean = (sum - difference.squared()).half();
            (mean - along, are_comparable(l2, l3).then(|| product.twice() - mean + along))
        }
        None => (square.half() - difference.squared().half(), None),
    };
    let rest = at_once.unwrap_or_else(|| product.twice() - half);
    scope.call("i half", half);
    let rounded = half * rest;
    let spread = spread(line, [l2, l3], product);
    let circles = [line.x, line.y, l2, l3, spread];
    let square_j = rounded.provided(Check::ReachCross, scope.group, &circles);
    scope.call("j2", square_j);
    let root = scope.call("j", mode * square_j.sqrt());
    let guarded = square.provided(Check::Square, scope.group, &operands);
    let lift = scope.call("inverse d2", scope.call("d2", guarded).recip());

    let is_first = l2.constant_value() <= l3.constant_value();
    let (short, [own, other]) = if is_first { (0, [l2, l3]) } else { (1, [l3, l2]) };
    // From i like J²: its rounding acts like one of d, and the bars keep their lengths.
    let share = half + own * (own - other);
    let operands = [rounded, line.x, line.y, own, other, spread];
    let along = (share * lift).provided(Check::ShareOfCentres, scope.group, &operands);
    scope.call(if is_first { "a" } else { "b" }, along);
    let regular = square_j.provided(Check::Nonzero, scope.group, &[]);
    let inverse = scope.call("inverse j", root * regular.recip());
    let cosine = product - half;
    let along = if is_first { along } else { -along };
    Bars { lengths: [l2, l3], cosine, short, along, lift, root, inverse }
}

/// Whether no bar is more than four times as long as the other.
fn are_comparable<'s>(l2: Sym<'s>, l3: Sym<'s>) -> bool {
    (l2 / l3).constant_value().is_some_and(|ratio| (0.25..=4.0).contains(&ratio.abs()))
}

impl<'s> Bars<'s> {
    /// The shorter bar.
    fn of_line(&self, line: Vector<'s>) -> Vector<'s> {
        self.along * line + self.root * (self.lift * line).normal()
    }

    /// Both bars, or their products with a vector, from the shorter bar's and that of d: r₃ = r₂ − d.
    fn both<V>(&self, short: V, line: V) -> [V; 2]
    where
        V: Copy + Add<Output = V> + Sub<Output = V>,
    {
        if self.short == 0 { [short, short - line] } else { [short + line, short] }
    }

    /// ω and α behind a crank.
    fn swinging(
        &self,
        scope: &GroupScope<'s>,
        crank: CrankPin<'s>,
    ) -> ([Sym<'s>; 2], [Sym<'s>; 2]) {
        let Swing { omega, alpha, .. } = crank.swing;
        let (f, e) = (crank.along(), crank.across);
        let dot = self.along * f + self.root * (self.lift * e);
        let cross = self.along * e - self.root * (self.lift * f);
        let [dot2, dot3] = self.both(dot, f);
        let [cross2, cross3] = self.both(cross, e);
        let turning = omega * self.inverse;
        let rates = [turning * cross3, turning * cross2];
        let square = omega.squared();
        let g = [[cross3, dot3], [cross2, dot2]].map(|[cross, dot]| square * dot + alpha * cross);
        self.rates(scope, rates, g)
    }

    /// ω and α between joints that move otherwise.
    fn moving(
        &self,
        scope: &GroupScope<'s>,
        [b, d]: [PointMotion<'s>; 2],
        [r2, r3]: [Vector<'s>; 2],
    ) -> ([Sym<'s>; 2], [Sym<'s>; 2]) {
        let w = d.velocity - b.velocity;
        let rates = [w.dot(r3) * self.inverse, w.dot(r2) * self.inverse];
        let g = d.acceleration - b.acceleration;
        self.rates(scope, rates, [g.dot(r3), g.dot(r2)])
    }

    /// ω, and α from g·r₃ and g·r₂.
    fn rates(
        &self,
        scope: &GroupScope<'s>,
        [omega2, omega3]: [Sym<'s>; 2],
        [with3, with2]: [Sym<'s>; 2],
    ) -> ([Sym<'s>; 2], [Sym<'s>; 2]) {
        let ([l2, l3], cosine) = (self.lengths, self.cosine);
        scope.call("r2 r3", cosine);
        scope.call("omega2", omega2);
        scope.call("omega3", omega3);
        let (p, q) = (omega2.squared(), omega3.squared());
        let alpha2 = ((with3 + p * cosine) - q * l3.squared()) * self.inverse;
        let alpha3 = ((with2 + p * l2.squared()) - q * cosine) * self.inverse;
        ([omega2, omega3], [alpha2, alpha3])
    }
}
