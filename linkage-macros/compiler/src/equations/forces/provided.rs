//! Numbers under the conditions on which forces are made of them.

use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::acting::{Friction, Magnitude};
use crate::model::mechanism::PointId;

/// A mass that a parameter makes is asked for its sign where it is used.
pub(super) fn not_negative<'s>(
    kinematics: &Kinematics<'s>,
    quantity: &Magnitude,
    group: u32,
) -> Sym<'s> {
    let value = kinematics.jet(&quantity.value).value;
    if value.is_constant() || quantity.name.is_empty() {
        return value;
    }
    value.guarded_by(Check::NotNegative(quantity.name.clone()), group, &[])
}

/// The coefficient of a guide, or of a pin the coefficient times its radius.
pub(super) fn share<'s>(kinematics: &Kinematics<'s>, friction: &Friction, group: u32) -> Sym<'s> {
    let coefficient = not_negative(kinematics, &friction.coefficient, group);
    match &friction.radius {
        Some(radius) => coefficient * not_negative(kinematics, radius, group),
        None => coefficient,
    }
}

/// The vector from the first point to the second.
pub(super) fn vector<'s>(kinematics: &Kinematics<'s>, points: [PointId; 2]) -> Vector<'s> {
    let [first, second] = points.map(|point| kinematics.point(point));
    first.to(second)
}

/// The line between two points, which must not meet.
pub(super) struct Line<'s> {
    pub vector: Vector<'s>,
    pub length: Sym<'s>,
    /// One over the length.
    pub inverse: Sym<'s>,
}

impl<'s> Line<'s> {
    pub(super) fn between(kinematics: &Kinematics<'s>, points: [PointId; 2], title: u32) -> Self {
        let vector = vector(kinematics, points);
        let square = vector.dot(vector).guarded_by(Check::Square, title, &[]);
        // 1/L = L/L²: the division runs beside the root.
        let length = square.sqrt();
        Self { vector, length, inverse: length * square.recip() }
    }
}
