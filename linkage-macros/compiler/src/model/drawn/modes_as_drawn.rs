//! Modes that a drawing gives: those of groups that are declared by hand, where it says where their pins are, and the
//! corners of what is drawn as a parallelogram.

use proc_macro2::Ident;

use crate::chain::plane::Complex;
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::{
    Expr, ExprKind, GroupField, GroupFieldValue, GroupStatement, Statement, StatementKind,
};

use crate::model::drawn::bodies::Bodies;
use crate::model::drawn::messages::LEAST_SINE;

/// The statement with the mode of the drawing, where it leaves out one that it needs and all its pins are drawn off its
/// limit.
pub(super) fn with_mode(bodies: &Bodies<'_>, statement: &Statement) -> Option<Statement> {
    let StatementKind::Group(group) = &statement.kind else { return None };
    let anatomy =
        GroupSpec::of(&group.keyword.to_string()).filter(|anatomy| anatomy.mode_is_needed())?;
    if group.fields.iter().any(|field| field.name == "mode") {
        return None;
    }
    let sine = sine(bodies, group)?;
    let [plus, minus] = anatomy.modes?.words();
    if sine.abs() < LEAST_SINE {
        return None;
    }
    let span = group.keyword.span();
    let word = Ident::new(if sine > 0.0 { plus } else { minus }, span);
    let value = Expr { kind: ExprKind::Name(word), span: span.into() };
    let mut group = group.clone();
    let name = Ident::new("mode", span);
    group.fields.push(GroupField { name, value: GroupFieldValue::One(value) });
    Some(Statement { docs: statement.docs.clone(), kind: StatementKind::Group(group) })
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
pub(super) fn parallel(bodies: &Bodies<'_>, pins: [usize; 3]) -> Option<(Ident, Vec<Ident>)> {
    let name = |pin: usize| bodies.pins[pin].name.clone();
    let corners: Vec<_> = corners_as_drawn(bodies, pins).into_iter().map(name).collect();
    (!corners.is_empty()).then(|| (name(pins[1]), corners))
}

/// The parallelograms among the statements that take their mode from the drawing: those that are restated with it.
pub(super) fn parallels(
    bodies: &Bodies<'_>,
    others: &[(usize, &Statement)],
    restated: &[Option<Statement>],
) -> Vec<(Ident, Vec<Ident>)> {
    let with_drawn_mode = others.iter().zip(restated).filter(|(_, restated)| restated.is_some());
    with_drawn_mode.filter_map(|((_, other), _)| corners_of_statement(bodies, other)).collect()
}

/// The pin of a statement with the mode of the drawing, and its corners where it is drawn as a parallelogram.
fn corners_of_statement(bodies: &Bodies<'_>, statement: &Statement) -> Option<(Ident, Vec<Ident>)> {
    let StatementKind::Group(group) = &statement.kind else { return None };
    GroupSpec::of(&group.keyword.to_string()).filter(|anatomy| anatomy.can_be_parallel())?;
    let place = |name: &Ident| bodies.pins.iter().position(|pin| pin.name == *name);
    let [first, second] = &group.legs[..] else { return None };
    let pin = group.pin.as_ref()?;
    let pins = [place(first.joint.as_ref()?)?, place(pin)?, place(second.joint.as_ref()?)?];
    parallel(bodies, pins)
}
