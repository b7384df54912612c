//! Driven dimensions: the effort of a dimension goes to the inputs in it, and to what it reads of
//! earlier links.
//!
//! A dimension d(x) driven with the effort E does the work E ∂d/∂x δx. So it counts E ∂d/∂q in the
//! effort of an input q; and what it contains of an earlier link, an angle, a slide, a coordinate,
//! is pushed back with −E ∂d/∂x: a couple, a force along the guide, a force on the point. That is how
//! gears and racks transmit. The derivatives are taken backwards through the expression.

use crate::equations::forces::walk::Walk;
use crate::equations::functions::slopes;
use crate::equations::symbol::{Sym, Vector};
use crate::function::Function;
use crate::model::mechanism::{
    AngleSum, Axis, Carrier, GuideId, Operator, Placement, PointId, Scalar,
};

impl<'s> Walk<'_, 's> {
    /// An angle driven with a couple.
    pub(super) fn transmit_turn(&mut self, turn: &AngleSum, effort: Sym<'s>) {
        for &(link, times) in &turn.links {
            let factor = self.builder().integer(i64::from(times));
            // The supports of the gear train are not modelled: the ground takes the rest.
            self.turn_against_ground(Carrier::Link(link), -(factor * effort));
        }
        self.transmit(&turn.rest, effort);
    }

    /// A dimension driven with an effort.
    pub(super) fn transmit(&mut self, expr: &Scalar, effort: Sym<'s>) {
        if effort.is_zero() || !self.kinematics.mechanism.moves(expr) {
            return;
        }
        match expr {
            Scalar::Constant(_) | Scalar::Param(_) | Scalar::Load(_) | Scalar::Pull => {}
            Scalar::Input(input) => self.add_effort(*input, effort),
            Scalar::Let(id) => {
                let mechanism = self.kinematics.mechanism;
                self.transmit(&mechanism.lets[id.index()].rest, effort);
            }
            Scalar::Slide(by) => self.push_drawn_slide(*by, -effort),
            Scalar::Coordinate(point, axis) => {
                let zero = self.builder().zero();
                let force = match axis {
                    Axis::X => Vector { x: -effort, y: zero },
                    Axis::Y => Vector { x: zero, y: -effort },
                };
                self.push_against_ground(*point, force);
            }
            Scalar::Distance([p, q]) => {
                let line = self.kinematics.point(*p).to(self.kinematics.point(*q));
                let force = (effort / line.x.hypot(line.y)) * line;
                self.push(*p, force);
                self.push(*q, -force);
            }
            Scalar::Offset(point, guide) => self.press(*point, *guide, effort),
            Scalar::Unknown(unknown) => self.add_sought(*unknown, effort),
            // No force is asked for in what such a group moves.
            Scalar::Tracked(..) => {}
            Scalar::Twist(_) | Scalar::Rate(_) | Scalar::Law(_) | Scalar::Effort(..) => {
                unreachable!("none of these is part of a dimension")
            }
            Scalar::Negate(value) => self.transmit(value, -effort),
            Scalar::AboveZero(inner) => self.transmit(&inner.value, effort),
            Scalar::Chain(first, rest) => self.transmit_chain(first, rest, effort),
            Scalar::Call(function, arguments) => self.transmit_call(*function, arguments, effort),
        }
    }

    /// The offset (P − K)·n of a point from a guide, driven with an effort: the point is pushed back
    /// along n, and what carries the guide forth at the same place.
    fn press(&mut self, point: PointId, guide: GuideId, effort: Sym<'s>) {
        let frame = self.kinematics.guide(guide);
        let arm = frame.origin.to(self.kinematics.point(point));
        let force = effort * frame.direction.n();
        self.push(point, -force);
        self.push_guide(guide, force, arm.cross(force));
    }

    /// One operation after the other, from the last back to the first.
    fn transmit_chain(&mut self, first: &Scalar, rest: &[(Operator, Scalar)], effort: Sym<'s>) {
        let value = |expr: &Scalar| self.kinematics.jet(expr).value;
        let mut left = vec![value(first)];
        for (operator, operand) in rest {
            let (a, b) = (left[left.len() - 1], value(operand));
            left.push(match operator {
                Operator::Add => a + b,
                Operator::Sub => a - b,
                Operator::Mul => a * b,
                Operator::Div => a / b,
            });
        }
        let mut effort = effort;
        for (nth, (operator, operand)) in rest.iter().enumerate().rev() {
            let (a, b) = (left[nth], self.kinematics.jet(operand).value);
            let (on_left, on_right) = match operator {
                Operator::Add => (effort, effort),
                Operator::Sub => (effort, -effort),
                Operator::Mul => (effort * b, effort * a),
                Operator::Div => (effort / b, -(effort * left[nth + 1] / b)),
            };
            self.transmit(operand, on_right);
            effort = on_left;
        }
        self.transmit(first, effort);
    }

    fn transmit_call(&mut self, function: Function, arguments: &[Scalar], effort: Sym<'s>) {
        let values: Vec<_> = arguments.iter().map(|a| self.kinematics.jet(a).value).collect();
        for (argument, slope) in arguments.iter().zip(slopes(function, &values)) {
            self.transmit(argument, effort * slope);
        }
    }

    /// A place in a frame, its coordinates driven with these efforts.
    pub(super) fn transmit_place(
        &mut self,
        (carrier, point): (Carrier, PointId),
        place: &Placement,
        [along, across]: [Sym<'s>; 2],
    ) {
        let [x, y] = self.kinematics.coordinates(carrier, point).map(|jet| jet.value);
        match place {
            Placement::Cartesian(at) => {
                self.transmit(&at[0], along);
                self.transmit(&at[1], across);
            }
            Placement::Polar(radius, angle) => {
                let phi = self.kinematics.jet(angle).value;
                self.transmit(radius, along * phi.cos() + across * phi.sin());
                self.transmit(angle, across * x - along * y);
            }
            // From x = (r₁² − r₂² + l²)/2l and y² = r₁² − x².
            Placement::Distances { distances: [first, second], length, .. } => {
                let (first, second) = (&first.value, &second.value);
                if !self.kinematics.mechanism.moves(first)
                    && !self.kinematics.mechanism.moves(second)
                    && !self.kinematics.mechanism.moves(length)
                {
                    return;
                }
                let value = |expr: &Scalar| self.kinematics.jet(expr).value;
                let (r1, r2, l) = (value(first), value(second), value(length));
                let on_x = along - across * x / y;
                self.transmit(first, (on_x * r1) / l + across * r1 / y);
                self.transmit(second, -((on_x * r2) / l));
                let by_length = on_x * (l - x) / l;
                // The second strut stands on the rod, which takes no more of the load than that.
                if let (Carrier::Link(link), true) =
                    (carrier, self.kinematics.mechanism.moves(length))
                {
                    self.note_rod(link, by_length);
                }
                self.transmit(length, by_length);
            }
        }
    }
}
