//! Modes of groups that are declared by hand, where the drawing says where their pins are.

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
