//! The effort of an input alone, from the power of all that acts, without any reaction.
//!
//! With c = ∂r/∂q and k = ∂φ/∂q, the velocities at a unit rate of the input:
//!
//! ```text
//! τ = −Σ (F·c + M k)      F, M: applied, weight and inertia
//! ```
//!
//! With a single input, everything about the motion is in c and c′ = dc/dq, functions of q alone, so that
//! every constant rate folds (Eksergian's equation):
//!
//! ```text
//! τ = M q̈ + ½M′ q̇² − Q      M = Σ m c·c + J k²      ½M′ = Σ m c·c′ + J k k′
//! ```
//!
//! Where an equation fixes an unknown θ(q), what holds the equation does no work, and all of this
//! stands. A drive at θ in place of one at q puts in the same power: it exerts τ/θ′.

use crate::equations::forces::elastic::stops;
use crate::equations::forces::loads::{Masses, applied, gravity, of_masses, torques};
use crate::equations::forces::reduced::Reduced;
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::Sym;
use crate::ir::graph::Check;
use crate::model::mechanism::{InputId, UnknownId};

/// The effort of the input.
pub(super) fn effort<'s>(kinematics: &Kinematics<'s>, input: InputId) -> Sym<'s> {
    let unit = at_unit_rate(kinematics, input.index());
    match kinematics.inputs.len() {
        1 => of_the_only_input(kinematics, &unit),
        _ => of_one_among_several(kinematics, &unit),
    }
}

/// The effort of a drive at an unknown, in place of the only input's.
pub(super) fn effort_at<'s>(kinematics: &Kinematics<'s>, unknown: UnknownId) -> Sym<'s> {
    let unit = at_unit_rate(kinematics, 0);
    let group = kinematics.mechanism.unknowns[unknown.index()].group;
    let rate = unit.unknowns[unknown.index()].rate.guarded_by(Check::Nonzero, group.0, &[]);
    of_the_only_input(kinematics, &unit) / rate
}

/// −(the power of all that acts), at the unit rate.
pub(super) fn of_one_among_several<'s>(
    kinematics: &Kinematics<'s>,
    unit: &Kinematics<'s>,
) -> Sym<'s> {
    let (masses, g) = (Masses::of(kinematics), gravity(kinematics));
    let mut power = applied_power(kinematics, unit);
    for (link, inertia) in masses.by_link() {
        let own = of_masses(kinematics, link, inertia, g);
        let frame = unit.link(link).frame;
        power = power + own.force.dot(frame.origin.velocity) + own.moment * frame.direction.omega;
    }
    for &(point, mass) in &masses.points {
        let force = mass * (g - kinematics.point(point).acceleration);
        power = power + force.dot(unit.point(point).velocity);
    }
    for (moving, at_unit) in masses.moving.iter().zip(Masses::of(unit).moving) {
        let force = moving.mass * (g - moving.motion.acceleration);
        let alpha = kinematics.link(moving.link).frame.direction.alpha;
        let k = unit.link(moving.link).frame.direction.omega;
        power = power + force.dot(at_unit.motion.velocity) - (moving.inertia * alpha) * k;
    }
    -power
}

/// The power of forces and torques, at the unit rate.
pub(super) fn applied_power<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let mut power = kinematics.builder.zero();
    for (point, force) in applied(kinematics) {
        power = power + force.dot(unit.point(point).velocity);
    }
    for (carrier, couple) in torques(kinematics) {
        power = power + couple * unit.carrier(carrier).direction.omega;
    }
    for (link, force) in stops::slides(kinematics) {
        power = power + force * unit.slide(link).rate;
    }
    power
}

fn of_the_only_input<'s>(kinematics: &Kinematics<'s>, unit: &Kinematics<'s>) -> Sym<'s> {
    let masses = Reduced::of(unit);
    let force = applied_power(unit, unit) + masses.power_of_weight(unit);
    let jet = kinematics.inputs[0].jet;
    masses.inertia(unit, unit) * jet.accel + masses.slope(unit) * jet.rate.squared() - force
}
