//! The state from which a coefficient is read.

use crate::equations::kinematics::{Kinematics, Source};

/// The state at a unit rate of one input, the others at rest, without second rates.
pub(super) fn at_unit_rate<'s>(kinematics: &Kinematics<'s>, moving: usize) -> Kinematics<'s> {
    let (sheet, mechanism) = (kinematics.sheet, kinematics.mechanism);
    let inputs = Source::one_moving(&kinematics.inputs, sheet, moving);
    let mut unit = Kinematics::of(sheet, mechanism, inputs);
    if let [only] = &kinematics.inputs[..] {
        unit.tempo = Some(only.jet.rate);
    }
    unit
}
