//! Modes that a drawing gives: those of groups that are declared by hand, where it says where their pins are, and the
//! corners of what is drawn as a parallelogram.

use proc_macro2::Ident;

use crate::chain::plane::Complex;
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::{GroupStatement, StatementKind};

use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::messages::LEAST_SINE;
use crate::model::mechanism::Sign;

/// The mode of a group that is declared by hand, where it leaves out one that it needs and all its pins are drawn off its
/// limit.
pub(in crate::model::drawn) struct DrawnMode {
    /// The first link of the group.
    pub link: Ident,
    pub mode: Sign,
    /// Its pin, and its corners where it is drawn as a parallelogram.
    pub parallel: Option<(Ident, Vec<Ident>)>,
}

/// The modes that the drawing gives.
pub(in crate::model::drawn) fn modes(bodies: &Bodies<'_>) -> Vec<DrawnMode> {
    let groups = bodies.other_statements().filter_map(|(_, statement)| match &statement.kind {
        StatementKind::Group(group) => Some(group),
        _ => None,
    });
    groups.filter_map(|group| mode(bodies, group)).collect()
}

fn mode(bodies: &Bodies<'_>, group: &GroupStatement) -> Option<DrawnMode> {
    GroupSpec::of(&group.keyword.to_string()).filter(|anatomy| anatomy.mode_is_needed())?;
    let sine = sine(bodies, group)?;
    if group.fields.iter().any(|field| field.name == "mode") || sine.abs() < LEAST_SINE {
        return None;
    }
    let mode = if sine > 0.0 { Sign::Plus } else { Sign::Minus };
    let link = group.legs.first()?.link.clone();
    Some(DrawnMode { link, mode, parallel: corners_of_group(bodies, group) })
}

/// The measure of the group in the drawing, whose sign is the mode: the sine between two bars, or the cosine between a
/// bar and a guide.
fn sine(bodies: &Bodies<'_>, group: &GroupStatement) -> Option<f64> {
    let place = |name: &Ident| {
        let pin = bodies.pins.iter().position(|pin| pin.name == *name)?;
        Some(bodies.machine.pins[pin])
    };
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
fn corners_of_group(bodies: &Bodies<'_>, group: &GroupStatement) -> Option<(Ident, Vec<Ident>)> {
    GroupSpec::of(&group.keyword.to_string()).filter(|anatomy| anatomy.can_be_parallel())?;
    let place = |name: &Ident| bodies.pins.iter().position(|pin| pin.name == *name);
    let [first, second] = &group.legs[..] else { return None };
    let pin = group.pin.as_ref()?;
    let pins = [place(first.joint.as_ref()?)?, place(pin)?, place(second.joint.as_ref()?)?];
    parallel(bodies, pins)
}
