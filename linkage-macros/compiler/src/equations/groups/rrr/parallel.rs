//! Two bars that stay opposite sides of a parallelogram.
//!
//! # Position
//! A is on one body with B and on another with D, and the sides there are as long as the bars opposite to them. So
//!
//! ```text
//! r₂ = C − B = D − A        r₃ = C − D = B − A        C = D + (B − A)
//! ```
//!
//! is where both bars reach, in every pose: one of the two places where the circles about B and D meet. There is no root,
//! no limit, and no change point: the other place, where the bars cross, is never taken.
//!
//! # Velocity and acceleration
//! Each bar keeps the direction of its opposite side, and turns with the body that this is on, by its ω and α. A side that
//! changes in its body, as where both are driven by one expression, turns by what it turns there as well.
//!
//! # Reactions
//! Those of any two bars: J = r₂ × r₃ = l₂ l₃ sin μ. Where all four joints are in one line the bars can still move, and
//! their forces follow from nothing: `Singular`, where the sine is within what rounding makes of two directions.
//!
//! # Sign
//! None.
//!
//! # Source
//! The parallelogram law.
//!
//! # Error
//! That of a crank on the body of the opposite side, and one rounding more. The bar BC closes the loop: it ends at the pin by
//! so many last places of what A, B and D are made of.

use super::{RrrLevers, carrier};
use crate::equations::groups::Formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame, RelativeAngle};
use crate::equations::parts::{GroupScope, LimitMeasures, LinkMotion, Solved};
use crate::equations::symbol::{Sym, Vector};
use crate::exact::Exact;
use crate::ir::graph::Check;
use crate::model::mechanism::{Carrier, Group, Opposite};

pub(super) struct ParallelBars(pub Opposite);

impl Formulas for ParallelBars {
    fn solve<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Solved<'s> {
        let (scope, joints, lengths) =
            (known.scope(group), known.both_joints(group), known.lengths(group));
        let directions = [0, 1].map(|bar| self.direction(known, group, bar, lengths[bar]));
        let frames = [0, 1].map(|bar| Frame { origin: joints[bar], direction: directions[bar] });
        let zero = Jet::zero(scope.builder);
        let r = [0, 1].map(|bar| frames[bar].vector(lengths[bar].value, zero.value));
        scope.call_vector("r2", r[0]);
        scope.call_vector("r3", r[1]);
        let carrier = carrier(joints, lengths);
        let values = lengths.map(|length| length.value);
        let inverse = inverse(&scope, directions, values);
        Solved {
            links: frames.map(|frame| LinkMotion { frame, slide: None }).into(),
            pin: Some(frames[carrier].place(lengths[carrier], zero)),
            bars: r.into(),
            levers: Some(Box::new(RrrLevers { r, lengths: values, inverse })),
        }
    }

    /// The angle between the bars. It has no limit.
    fn measures<'s>(&self, known: &Kinematics<'s>, group: &'s Group) -> Option<LimitMeasures<'s>> {
        let [a, b] = [0, 1].map(|bar| known.link(group.links[bar]).frame.direction);
        Some(LimitMeasures::of_directions(a, b, a.sin_cos_to(b)))
    }
}

impl ParallelBars {
    /// The direction of a bar, that of the side opposite to it.
    fn direction<'s>(
        &self,
        known: &Kinematics<'s>,
        group: &Group,
        bar: usize,
        length: Jet<'s>,
    ) -> Direction<'s> {
        let Opposite { corner, carriers } = self.0;
        let at = |point| known.coordinates(carriers[bar], point);
        let (from, to) = (at(corner), at(group.stands_on(1 - bar)));
        let (x, y) = (to[0] - from[0], to[1] - from[1]);
        let body = known.carrier(carriers[bar]).direction;
        if y.is_zero() {
            // As long as the bar, and so its length or the opposite of it.
            let is_opposite = x.value.constant_value().map_or(x.value.is_negated(), |x| x < 0.0);
            return if is_opposite { half_turn(body) } else { body };
        }
        let unit = Vector { x: x.value / length.value, y: y.value / length.value };
        let start = RelativeAngle::start(Carrier::Link(group.links[bar]), known.builder);
        // The value of the angle would need an arc tangent; its rates do without.
        Direction { turned: Some(start), ..body.turned_by(y.atan2(x), unit) }
    }
}

fn half_turn(direction: Direction<'_>) -> Direction<'_> {
    let builder = direction.omega.builder();
    let (unit, pi) = (Vector { x: builder.integer(-1), y: builder.zero() }, Exact::pi());
    direction.turned_by(Jet::constant(builder.constant(pi)), unit)
}

/// 1/J
fn inverse<'s>(
    scope: &GroupScope<'s>,
    [second, third]: [Direction<'s>; 2],
    [l2, l3]: [Sym<'s>; 2],
) -> Sym<'s> {
    let (sine, one) = (second.sin_cos_to(third).0, scope.builder.integer(1));
    let size = sine.magnitude().guarded_by(Check::Moving, scope.group, &[one]);
    scope.label("inverse j", sine.sign_or(one) / (l2 * l3 * size))
}
