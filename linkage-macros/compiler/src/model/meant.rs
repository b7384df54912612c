//! The text that is meant by a number of another dimension, or by a name of another kind.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, ExprKind};

use crate::model::dimension::Dimension;
use crate::model::mechanism::{Carrier, LinkId};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;

/// A literal with a unit of the dimension that belongs there: `5(N*m)` for `5N`. A weight is made a mass.
pub(in crate::model) fn literal_of(
    expr: &Expr,
    found: Dimension,
    wanted: Dimension,
) -> Option<String> {
    let (sign, digits, units) = match &expr.kind {
        ExprKind::Number { digits, units } => ("", digits, units),
        ExprKind::Negate(inner) => match &inner.kind {
            ExprKind::Number { digits, units } => ("-", digits, units),
            _ => return None,
        },
        _ => return None,
    };
    if let ([(unit, 1)], Dimension::FORCE, Dimension::MASS) = (&units[..], found, wanted) {
        return Some(format!(
            "a weight is divided by the acceleration of gravity: `{sign}{digits}{unit} / 9.81(m/s^2)`"
        ));
    }
    let unit = match (found, wanted) {
        (Dimension::LENGTH, Dimension::ANGLE) => "deg",
        (Dimension::ANGLE, Dimension::LENGTH) => "mm",
        _ if [Dimension::LENGTH, Dimension::ANGLE].contains(&wanted) => return None,
        _ => wanted.unit()?,
    };
    Some(format!("write `{sign}{digits}{unit}`"))
}

/// The link that slides on a guide.
pub(in crate::model) fn slider_on(scope: &Scope<'_>, guide: &Ident) -> Option<String> {
    let Entity::Guide(guide) = scope.names.entity(guide)? else { return None };
    let sliding = scope.mechanism.group_steps().find_map(|group| {
        let joint = group.outer.iter().position(|joint| joint.guide() == Some(guide))?;
        group.links.get(joint).copied()
    })?;
    Some(scope.mechanism.links[sliding.index()].name.to_string())
}

/// A point of a link that somebody has named.
pub(in crate::model) fn point_on(scope: &Scope<'_>, link: LinkId) -> Option<String> {
    let names = scope.facts.points_of(Carrier::Link(link));
    let mut names = names.map(|point| scope.mechanism.points[point.index()].name.to_string());
    names.find(|name| scope.names.of_kinds(&[Kind::Point]).any(|known| known == name))
}
