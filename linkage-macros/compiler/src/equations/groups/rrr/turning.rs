//! Angular velocities and accelerations of the bars of the dyad RRR.
//!
//! # Behind a crank
//! Where B swings about a point of the ground with the arm a, and D is a point of the ground, the velocity
//! ω a⊥ and the acceleration α a⊥ − ω² a of B lead to two products with a bar r, which serve both of its
//! rates:
//!
//! ```text
//! w·r = ω (r × a)       g·r = α (r × a) + ω² a·r
//! ```
//!
//! # A cylinder and a bar between joints that stand still
//! Where l₂ alone is driven, l₂² is d² + l₃² + 2 d·r₃, of which d and l₃ stay, so that the bar turns with
//!
//! ```text
//! ω₃ = −l₂ l̇₂/J                  α₃ = −(l̇₂² + l₂ l̈₂ + ω₃² d·r₃)/J
//! ω₂ = −(l̇₂/l₂) r₂·r₃/J          α₂ = (α₃ r₂·r₃ − ω₃² J)/l₂² − 2 ω₂ l̇₂/l₂
//! ```
//!
//! the cylinder's by the pin's velocity and acceleration across it. Where l₃ alone is, the other signs hold, with
//! d·r₂ for d·r₃.
//!
//! # Two cylinders between joints that stand still
//! What pushes the pin acts along the bars alone, w = l̇₃ u₃ − l̇₂ u₂, and its products are those of the bars:
//!
//! ```text
//! w·r₃ = l̇₃ l₃ − l̇₂ r₂·r₃/l₂      g·r₃ = l̈₃ l₃ − l̈₂ r₂·r₃/l₂ − 2 ω₂ l̇₂ J/l₂
//! w·r₂ = l̇₃ r₂·r₃/l₃ − l̇₂ l₂      g·r₂ = l̈₃ r₂·r₃/l₃ − l̈₂ l₂ − 2 ω₃ l̇₃ J/l₃
//! w·d  = −l̇₂ d·r₂/l₂ + l̇₃ d·r₃/l₃
//! ```
//!
//! # Centripetal terms
//! ω₂² r₂ − ω₃² r₃ cancels where both bars turn alike, as bars of one length do whose outer joints
//! almost meet: what is left is as short as the line between the joints. So it is taken along that line
//! and along the shorter bar, with k = ω₂² − ω₃² = −(w · d)/J (ω₂ + ω₃),
//!
//! ```text
//! ω₂² r₂ − ω₃² r₃ = ω₃² d + k r₂     if bar 2 is the shorter one
//!                 = ω₂² d + k r₃     if bar 3 is
//! ```
//!
//! in which nothing cancels. Where one bar is known to be longer by a quarter, no more than two bits cancel
//! in the first form. The products with r₂ and r₃ are those of d and of the angle between the bars,
//! r₂·r₃ = l₂ l₃ − i/2.

use super::triangle::Triangle;
use crate::equations::crank_pin::CrankPin;
use crate::equations::jet::Jet;
use crate::equations::motion::Swing;
use crate::equations::parts::{Bar, GroupScope};
use crate::equations::symbol::Sym;

impl<'s> Triangle<'s> {
    /// ω and α of each bar.
    pub(super) fn turning(
        &self,
        scope: &GroupScope<'s>,
        bars: [Bar<'s>; 2],
        lengths: [Jet<'s>; 2],
    ) -> [(Sym<'s>, Sym<'s>); 2] {
        let are_driven = lengths.map(|length| !length.is_fixed());
        if let (Some(crank), [false, false]) = (self.crank, are_driven) {
            return self.swinging(scope, crank, bars);
        }
        match are_driven {
            _ if !bars.iter().all(|bar| bar.stands()) => self.moving(scope, bars),
            [true, false] => self.pushed(scope, 0, lengths[0]),
            [false, true] => self.pushed(scope, 1, lengths[1]),
            _ => self.telescoping(scope, lengths),
        }
    }

    /// Between joints that stand still, where only the bar at `driven` changes its length.
    fn pushed(
        &self,
        scope: &GroupScope<'s>,
        driven: usize,
        length: Jet<'s>,
    ) -> [(Sym<'s>, Sym<'s>); 2] {
        let (cosine, over_length) = (self.cosine(), self.over_length(driven));
        let signed = |value: Sym<'s>| if driven == 0 { -value } else { value };
        let omega = signed(length.value * length.rate) * self.inverse;
        let square = omega.squared();
        let growth = length.rate.squared() + length.value * length.accel;
        let alpha = signed(growth - square.half() * self.shares[1 - driven]) * self.inverse;
        let rate = length.rate * over_length;
        let own_omega = signed(rate * cosine) * self.inverse;
        let across = alpha * cosine + signed(square * self.cross);
        let own_alpha = across * over_length.squared() - (rate * own_omega).twice();
        let rates = if driven == 0 {
            [(own_omega, own_alpha), (omega, alpha)]
        } else {
            [(omega, alpha), (own_omega, own_alpha)]
        };
        scope.label("omega2", rates[0].0);
        scope.label("omega3", rates[1].0);
        rates
    }

    /// Between joints that stand still, both lengths driven.
    fn telescoping(
        &self,
        scope: &GroupScope<'s>,
        lengths: [Jet<'s>; 2],
    ) -> [(Sym<'s>, Sym<'s>); 2] {
        let ([l2, l3], cosine) = (self.lengths, self.cosine());
        // l̇/l and l̈/l
        let [rate2, rate3] = [0, 1].map(|k| lengths[k].rate * self.over_length(k));
        let [accel2, accel3] = [0, 1].map(|k| lengths[k].accel * self.over_length(k));
        let with3 = lengths[1].rate * l3 - rate2 * cosine;
        let with2 = rate3 * cosine - lengths[0].rate * l2;
        let omega = [with3 * self.inverse, with2 * self.inverse];
        let coriolis = [rate2 * omega[0], rate3 * omega[1]].map(|rate| rate.twice() * self.cross);
        let g = [
            lengths[1].accel * l3 - accel2 * cosine - coriolis[0],
            accel3 * cosine - lengths[0].accel * l2 - coriolis[1],
        ];
        let [to_second, to_third] = self.shares;
        let folding = (rate2 * to_second + rate3 * to_third) * self.inverse.half();
        self.rates(scope, omega, g, folding)
    }

    /// r₂·r₃
    fn cosine(&self) -> Sym<'s> {
        self.lengths[0] * self.lengths[1] - self.half
    }

    /// Behind a crank.
    fn swinging(
        &self,
        scope: &GroupScope<'s>,
        crank: CrankPin<'s>,
        bars: [Bar<'s>; 2],
    ) -> [(Sym<'s>, Sym<'s>); 2] {
        let Swing { omega, alpha, arm, .. } = crank.swing;
        let r = bars.map(Bar::vector);
        let across = scope.note("d cross a", crank.across);
        // The bars are there when accelerations ask for their products.
        let [dot2, dot3] = r.map(|r| r.dot(arm));
        let [cross2, cross3] = self.crosses(self.line.dot(arm), across);
        let turning = scope.note("omega1 j", omega * self.inverse);
        let rates = [turning * cross3, turning * cross2];
        let square = scope.note("omega1 squared", omega.squared());
        let g = [(dot3, cross3), (dot2, cross2)];
        let g = g.map(|(dot, cross)| square * dot + alpha * cross);
        let own = [("r2 dot a", dot2), ("r3 dot a", dot3), ("r2 cross a", cross2)];
        let own = own.into_iter().chain([("r3 cross a", cross3), ("g r3", g[0]), ("g r2", g[1])]);
        for (letter, symbol) in own {
            scope.note(letter, symbol);
        }
        self.rates(scope, rates, g, -(turning * across))
    }

    /// Between joints that move otherwise.
    fn moving(&self, scope: &GroupScope<'s>, bars: [Bar<'s>; 2]) -> [(Sym<'s>, Sym<'s>); 2] {
        let [r2, r3] = bars.map(Bar::vector);
        let w = scope.call_vector("w", bars[1].pushed_velocity() - bars[0].pushed_velocity());
        let with = [(r3, "w r3"), (r2, "w r2")].map(|(r, name)| scope.label(name, w.dot(r)));
        let rates = with.map(|product| product * self.inverse);
        let [near, far] = [0, 1].map(|k| bars[k].lengthening_acceleration(rates[k]));
        let g = scope.call_vector("g", far - near);
        self.rates(scope, rates, [g.dot(r3), g.dot(r2)], -w.dot(self.line) * self.inverse)
    }

    /// ω and α from g·r₃ and g·r₂; `folding` = ω₂ − ω₃.
    fn rates(
        &self,
        scope: &GroupScope<'s>,
        omega: [Sym<'s>; 2],
        with: [Sym<'s>; 2],
        folding: Sym<'s>,
    ) -> [(Sym<'s>, Sym<'s>); 2] {
        scope.label("omega2", omega[0]);
        scope.label("omega3", omega[1]);
        let [alpha2, alpha3] = self.second_rates(scope, omega, with, folding);
        [(omega[0], alpha2), (omega[1], alpha3)]
    }

    fn second_rates(
        &self,
        scope: &GroupScope<'s>,
        [omega2, omega3]: [Sym<'s>; 2],
        [with3, with2]: [Sym<'s>; 2],
        folding: Sym<'s>,
    ) -> [Sym<'s>; 2] {
        let ([l2, l3], [to_second, to_third]) = (self.lengths, self.shares);
        let cosine = scope.label("r2 r3", self.cosine());
        let square2 = scope.label("omega2 squared", omega2.squared());
        let square3 = scope.label("omega3 squared", omega3.squared());
        if differ(l2, l3) {
            return [
                ((with3 + square2 * cosine) - square3 * l3.squared()) * self.inverse,
                ((with2 + square2 * l2.squared()) - square3 * cosine) * self.inverse,
            ];
        }
        let difference = folding * (omega2 + omega3);
        // Each pair of what stands where bar 2 is the shorter one, and where bar 3 is. A product with 0 or 1
        // rounds nothing, and no branch comes of it.
        let (zero, one) = (l2.builder().zero(), l2.builder().integer(1));
        let is_second = l3.at_least(l2, one, zero);
        let chosen =
            |second: Sym<'s>, third: Sym<'s>| is_second * second + (one - is_second) * third;
        let square = chosen(square3, square2).half();
        let [short3, short2] = [chosen(cosine, l3.squared()), chosen(l2.squared(), cosine)];
        [
            ((with3 + difference * short3) - square * to_third) * self.inverse,
            ((with2 + difference * short2) + square * to_second) * self.inverse,
        ]
    }
}

/// True if the bars are known to differ by a seventh of their sum, which is a quarter of the longer: then
/// at most two bits cancel in ω₂² r₂ − ω₃² r₃.
fn differ<'s>(l2: Sym<'s>, l3: Sym<'s>) -> bool {
    let share = (l2 - l3) / (l2 + l3);
    share.squared().constant_value().is_some_and(|square| square >= 1.0 / 49.0)
}
