//! The distances of groups from their limits in the drawing.

use super::cutting::{Dyad, Found, Pair};
use super::machine::Machine;
use super::plane::Complex;

/// The signed measure of a dyad in the drawing: the sine of the angle between what its links are
/// held by. Its sign is the assembly mode where the dyad has one, and zero is the limit.
pub fn sine(machine: &Machine, dyad: &Dyad) -> f64 {
    let pin = |index: usize| machine.pins[index];
    let slide = |index: usize| machine.slides[index];
    match (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer) {
        (Pair::Pin(u), Pair::Pin(v), Pair::Pin(w)) => {
            let [first, second] = dyad.tips(v);
            let (a, b) = (pin(first) - pin(u), pin(second) - pin(w));
            ratio(a.cross(b), a.length() * b.length())
        }
        (Pair::Pin(u), Pair::Pin(v), Pair::Slide(s)) => along(slide(s).along, pin(v) - pin(u)),
        (Pair::Pin(u), Pair::Slide(s), Pair::Pin(w)) => along(slide(s).along, pin(u) - pin(w)),
        (Pair::Slide(s), _, Pair::Slide(t)) | (Pair::Pin(_), Pair::Slide(s), Pair::Slide(t)) => {
            slide(t).along.cross(slide(s).along)
        }
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
pub(crate) fn at_limit<'s>(machine: &Machine, steps: &'s [Found], least: f64) -> Option<&'s Dyad> {
    steps.iter().find_map(|step| match step {
        Found::Search(search) => at_limit(machine, &search.steps, least),
        Found::Dyad(dyad) if sine(machine, dyad).abs() < least => Some(dyad),
        _ => None,
    })
}
