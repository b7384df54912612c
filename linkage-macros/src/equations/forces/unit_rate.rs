//! The state from which a coefficient is read.

use crate::equations::kinematics::Kinematics;

/// The state at a unit rate of one input, the others at rest, without second rates.
pub(super) fn at_unit_rate<'s>(kinematics: &Kinematics<'s>, moving: usize) -> Kinematics<'s> {
    let (sheet, mechanism) = (kinematics.sheet, kinematics.mechanism);
    let inputs = kinematics.inputs.iter().enumerate().map(|(index, source)| {
        let mut source = *source;
        source.jet.rate = sheet.integer(i64::from(index == moving));
        source.jet.accel = sheet.zero();
        source
    });
    let mut unit = Kinematics::of(sheet, mechanism, inputs.collect());
    if let [only] = &kinematics.inputs[..] {
        unit.tempo = Some(only.jet.rate);
    }
    unit
}
