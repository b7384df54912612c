//! The load that drives an input in place of a drive of its own.
//!
//! The effort of the input is affine in the load p, as all that acts is a multiple of p and what is free of it:
//!
//! ```text
//! τ = τ⁰ − B p      B = Σ (∂F/∂p·c + ∂M/∂p k)
//! ```
//!
//! with c and k at the unit rate of the input, as in [`power`]. No drive is at the input, so that
//! τ = 0 and p = τ⁰/B. Under this p everything else is found as under any other load.
//!
//! Where joints rub, the load and all amounts follow from each other: see [`friction`](super::friction).
//!
//! B is zero where the load does no work on the input: a dead point, which is `Singular`.

use crate::equations::forces::loads::{declared_by, torques_by};
use crate::equations::forces::power;
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::forces::walk::Walk;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::Sym;
use crate::ir::graph::Check;
use crate::model::mechanism::{InputId, Mechanism, Operator, Scalar};

/// The same state under the load that drives; none where no load drives.
pub(super) fn driven<'s>(kinematics: &Kinematics<'s>) -> Option<Kinematics<'s>> {
    let mechanism = kinematics.mechanism;
    let (input, _) = mechanism.dynamics.driven()?;
    let free = under(kinematics, kinematics.builder.zero());
    let work = work(&free, input);
    Some(under(kinematics, power::effort(&free, input) / provided(mechanism, work)))
}

/// The work of a unit of the load on the input, the same under every load.
pub(in crate::equations) fn work<'s>(kinematics: &Kinematics<'s>, input: InputId) -> Sym<'s> {
    let unit = at_unit_rate(kinematics, input.index());
    match kinematics.inputs.len() {
        1 => power_of_pull(&unit, &unit),
        _ => power_of_pull(kinematics, &unit),
    }
}

/// The work of the load on the input, provided that it does some.
pub(super) fn provided<'s>(mechanism: &Mechanism, work: Sym<'s>) -> Sym<'s> {
    work.guarded_by(Check::Nonzero, mechanism.title_of_pull(), &[])
}

/// Puts a unit of the load on a walk.
pub(super) fn put_unit_on<'s>(walk: &mut Walk<'_, 's>) {
    let slopes = Slopes::of(walk.kinematics);
    let slope = |value: &Scalar| slopes.slope(value);
    for (point, force) in declared_by(walk.kinematics, &slope) {
        walk.push(point, force);
    }
    for (carrier, couple) in torques_by(walk.kinematics.mechanism, &slope) {
        walk.turn(carrier, couple);
    }
}

/// The same state under this load.
pub(super) fn under<'s>(kinematics: &Kinematics<'s>, pull: Sym<'s>) -> Kinematics<'s> {
    let Kinematics { builder, mechanism, inputs, .. } = kinematics;
    Kinematics { pull: Some(pull), ..Kinematics::of(builder, mechanism, inputs.clone()) }
}

/// The power of a unit of the load, at the unit rate.
fn power_of_pull<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let slopes = Slopes::of(kinematics);
    let slope = |value: &Scalar| slopes.slope(value);
    let mut power = kinematics.builder.zero();
    for (point, force) in declared_by(kinematics, &slope) {
        power = power + force.dot(unit.point(point).velocity);
    }
    for (carrier, couple) in torques_by(kinematics.mechanism, &slope) {
        power = power + couple * unit.carrier(carrier).direction.omega;
    }
    power
}

/// Slopes of numbers by the load.
struct Slopes<'k, 's> {
    kinematics: &'k Kinematics<'s>,
    /// By law: later ones stand on earlier ones.
    laws: Vec<Sym<'s>>,
}

impl<'k, 's> Slopes<'k, 's> {
    fn of(kinematics: &'k Kinematics<'s>) -> Self {
        let mut slopes = Self { kinematics, laws: Vec::new() };
        for law in &kinematics.mechanism.dynamics.laws {
            let slope = slopes.slope(&law.rest);
            slopes.laws.push(slope);
        }
        slopes
    }

    fn slope(&self, expr: &Scalar) -> Sym<'s> {
        match expr {
            Scalar::Pull => self.kinematics.builder.integer(1),
            Scalar::Law(law) => self.laws[law.index()],
            Scalar::Negate(value) => -self.slope(value),
            Scalar::Chain(first, rest) => self.slope_of_chain(first, rest),
            // A function of the load stands in outputs alone.
            _ => self.kinematics.builder.zero(),
        }
    }

    fn slope_of_chain(&self, first: &Scalar, rest: &[(Operator, Scalar)]) -> Sym<'s> {
        let value = |expr: &Scalar| self.kinematics.jet(expr).value;
        let (mut left, mut slope) = (value(first), self.slope(first));
        for (operator, operand) in rest {
            let (right, by) = (value(operand), self.slope(operand));
            (left, slope) = match operator {
                Operator::Add => (left + right, slope + by),
                Operator::Sub => (left - right, slope - by),
                Operator::Mul => (left * right, slope * right + left * by),
                // The divisor is free of the load.
                Operator::Div => (left / right, slope / right),
            };
        }
        slope
    }
}
