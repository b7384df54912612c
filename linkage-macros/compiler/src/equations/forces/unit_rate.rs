//! The state from which a coefficient is read.

use crate::equations::kinematics::{InputMotion, Kinematics};

/// The state at a unit rate of one input, the others at rest, without accelerations.
pub(super) fn at_unit_rate<'s>(kinematics: &Kinematics<'s>, moving: usize) -> Kinematics<'s> {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let inputs = InputMotion::one_moving(&kinematics.inputs, builder, moving);
    let mut unit =
        Kinematics { pull: kinematics.pull, ..Kinematics::of(builder, mechanism, inputs) };
    if let [only] = &kinematics.inputs[..] {
        unit.rate_scale = Some(only.jet.rate);
    }
    unit
}
