//! Modes that a drawing gives: those of groups that are declared by hand, where it says where their pins are, and the
//! corners of what is drawn as a parallelogram.

use proc_macro2::Ident;

use crate::chain::cutting::Dyad;
use crate::chain::limits;
use crate::chain::machine::Machine;
use crate::chain::plane::Complex;
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::GroupStatement;

use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::messages::LEAST_SINE;
use crate::model::mechanism::Sign;

/// The mode of a group that is declared by hand, where it leaves out one that it needs and all its pins are drawn off its
/// limit.
pub(in crate::model::drawn) fn mode_as_drawn(
    bodies: &Bodies<'_>,
    group: &GroupStatement,
) -> Option<Sign> {
    let anatomy = GroupSpec::of(&group.keyword.to_string());
    anatomy.filter(|anatomy| anatomy.mode_is_needed())?;
    let sine = sine(bodies, group)?;
    if group.fields.iter().any(|field| field.name == "mode") || sine.abs() < LEAST_SINE {
        return None;
    }
    Some(if sine > 0.0 { Sign::Plus } else { Sign::Minus })
}

/// The measure of the group in the drawing, whose sign is the mode: the sine between two bars, or the cosine between a
/// bar and a guide.
fn sine(bodies: &Bodies<'_>, group: &GroupStatement) -> Option<f64> {
    let place = |name: &Ident| Some(bodies.machine.pins[bodies.pin(name)?]);
    let [first, second] = &group.legs[..] else { return None };
    let (tip, from) = (place(group.pin.as_ref()?)?, place(first.joint.as_ref()?)?);
    let other = second.joint.as_ref()?;
    let bar = (tip - from).unit();
    if let Some(to) = place(other) {
        return Some(bar.cross((tip - to).unit()));
    }
    let guide = bodies.guides.iter().find(|guide| guide.name == other)?;
    let [x, y] = &guide.line.along;
    Some(Complex::new(x.value, y.value).unit().dot(bar))
}

/// The most by which a side of a parallelogram may differ from its opposite one, in parts of the shortest side: what is
/// off by more is not meant as one.
const ALIKE: f64 = 1e-3;

/// The pins with which the pin `c` between bars from `b` and `d` is drawn as a parallelogram: each is on one body with `b`
/// and on another with `d`.
fn corners_as_drawn(bodies: &Bodies<'_>, [b, c, d]: [usize; 3]) -> Vec<usize> {
    let machine = &bodies.machine;
    let at = |pin: usize| machine.pins[pin];
    let (along, beside) = (at(c) - at(b), at(c) - at(d));
    let shortest = along.length().min(beside.length());
    let is_opposite = |corner: usize| {
        (at(d) - at(corner) - along).length() <= ALIKE * shortest && corner != b && corner != d
    };
    let joins = |first: usize, second: usize| {
        move |body: &usize| {
            let pins = &machine.bodies[*body].pins;
            pins.contains(&first) && pins.contains(&second)
        }
    };
    let is_corner = |corner: &usize| {
        is_opposite(*corner)
            && machine
                .at(b)
                .filter(joins(b, *corner))
                .any(|of_b| machine.at(d).filter(joins(d, *corner)).any(|of_d| of_d != of_b))
    };
    (0..machine.pins.len()).filter(is_corner).collect()
}

/// The pin between two bars that are drawn as a parallelogram, and its corners.
pub(in crate::model::drawn) fn parallel(
    bodies: &Bodies<'_>,
    pins: [usize; 3],
) -> Option<(Ident, Vec<Ident>)> {
    let name = |pin: usize| bodies.pins[pin].name.clone();
    let corners: Vec<_> = corners_as_drawn(bodies, pins).into_iter().map(name).collect();
    (!corners.is_empty()).then(|| (name(pins[1]), corners))
}

/// The pin of a group with the mode of the drawing, and its corners where it is drawn as a parallelogram.
pub(in crate::model::drawn) fn corners_of_group(
    bodies: &Bodies<'_>,
    group: &GroupStatement,
) -> Option<(Ident, Vec<Ident>)> {
    GroupSpec::of(&group.keyword.to_string()).filter(|anatomy| anatomy.can_be_parallel())?;
    let [first, second] = &group.legs[..] else { return None };
    let pin = group.pin.as_ref()?;
    let [from, to] = [first, second].map(|leg| bodies.pin(leg.joint.as_ref()?));
    parallel(bodies, [from?, bodies.pin(pin)?, to?])
}

/// The mode in which a dyad is drawn.
pub(in crate::model::drawn) fn mode_of(machine: &Machine, dyad: &Dyad) -> Sign {
    if limits::sine(machine, dyad) > 0.0 { Sign::Plus } else { Sign::Minus }
}
