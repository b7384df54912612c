//! How far groups are from their limits in the drawing.

use super::groups::{Dyad, Joint, Step};
use super::machine::Machine;
use super::plane::Complex;

/// The signed measure of a dyad in the drawing: the sine of the angle between what its links are
/// held by. Its sign is the assembly mode where the dyad has one, and zero is the limit.
pub(crate) fn sine(machine: &Machine, dyad: &Dyad) -> f64 {
    let pin = |index: usize| machine.pins[index];
    let slide = |index: usize| machine.slides[index];
    match (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer) {
        (Joint::Pin(u), Joint::Pin(v), Joint::Pin(w)) => {
            let (a, b) = (pin(v) - pin(u), pin(v) - pin(w));
            ratio(a.cross(b), a.length() * b.length())
        }
        (Joint::Pin(u), Joint::Pin(v), Joint::Slide(s)) => along(slide(s).along, pin(v) - pin(u)),
        (Joint::Pin(u), Joint::Slide(s), Joint::Pin(w)) => along(slide(s).along, pin(u) - pin(w)),
        (Joint::Slide(s), _, Joint::Slide(t))
        | (Joint::Pin(_), Joint::Slide(s), Joint::Slide(t)) => slide(t).along.cross(slide(s).along),
        _ => 0.0,
    }
}

/// The cosine of the angle between a direction and a vector.
fn along(direction: Complex, vector: Complex) -> f64 {
    ratio(direction.dot(vector), vector.length())
}

/// Zero where nothing has a length.
fn ratio(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.0 }
}

/// The step whose dyad is within `least` of its limit in the drawing.
pub(crate) fn at_limit<'s>(machine: &Machine, steps: &'s [Step], least: f64) -> Option<&'s Dyad> {
    steps.iter().find_map(|step| match step {
        Step::Dyad(dyad) if sine(machine, dyad).abs() < least => Some(dyad),
        _ => None,
    })
}
