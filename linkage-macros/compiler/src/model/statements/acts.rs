//! Loads, gravity, forces and torques, and the check that they have an effect.

use proc_macro2::Ident;

use crate::syntax::tree::{self, Action, Declaration, ExprKind, OutputStatement, StatementKind};

use crate::model::acting::Dynamics;
use crate::model::mechanism::{Body, Carrier, Dimension, PointId, Scalar};
use crate::model::reads::Allowed;
use crate::model::references::{expressions, names_in};
use crate::model::scope::Scope;
use crate::model::{numbers, uses};

use super::input::{add_names, follow_lets};
use super::spring::is_rate;
use super::{drive_by, named};

const INSIDE: &str = "what acts inside a body moves nothing";

/// A number of the machine itself: constants and parameters.
pub(in crate::model) fn changes_with_no_input(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    what: &str,
) -> Option<()> {
    // Rates have a message of their own.
    let of_a_rate = numbers::first(scope, expr, &|scope, part| {
        is_rate(part) || named::is_law(scope, part, |_| true)
    })
    .is_some();
    let Some(span) = numbers::moving_part(scope, expr).filter(|_| !of_a_rate) else {
        return Some(());
    };
    let message = format!("{what} cannot depend on an input");
    let reason = "it is made of constants and parameters";
    scope.diagnostics.error_because(span, message, reason);
    None
}

pub(in crate::model) fn ground_moves_nothing<T>(
    scope: &mut Scope<'_>,
    point: &Ident,
    what: &str,
) -> Option<T> {
    let message = format!("`{point}` is a point of the ground, and a {what} there does nothing");
    let reason = "name a point of a link, a pin or a driven point";
    scope.diagnostics.error_because(point.span(), message, reason);
    None
}

/// The value of a force or a torque: loads may stand in it.
pub(in crate::model) fn acting(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    dimension: Dimension,
) -> Option<Scalar> {
    let value = numbers::scalar_where(scope, expr, dimension, Allowed::IN_FORCES)?;
    drive_by::is_linear_in_pull(scope, expr, &value)?;
    Some(value)
}

/// A load stands in the value of a force or a torque, and nowhere else.
pub(in crate::model) fn load_stands_in_a_force(
    scope: &mut Scope<'_>,
    name: &Ident,
    allowed: Allowed,
) -> Option<()> {
    if allowed.forces {
        return Some(());
    }
    let message = format!("`{name}` is a load, and stands in forces, torques and outputs alone");
    let reason = "what the mechanism is made of and how it moves depends on no load";
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// Points that can move against each other: of two bodies, or of one where an input drives a coordinate.
pub(in crate::model) fn two_points(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    what: &str,
) -> Option<[PointId; 2]> {
    let points = [0, 1].map(|k| uses::point(scope, &names[k]));
    let [p, q] = [points[0]?, points[1]?];
    if p == q {
        let message = format!("{what} between two points");
        scope.diagnostics.error_because(names[1].span(), message, INSIDE);
        return None;
    }
    let owners = [p, q].map(|point| scope.mechanism.owner(point));
    if owners[0]? == owners[1]? && !is_driven_in(scope, owners[0]?, [p, q]) {
        let message = format!("`{}` and `{}` are fixed to one body", names[0], names[1]);
        let reason = "what acts between them moves nothing; it does where an input drives a \
                      coordinate of one, as in `at (0.2m + s, 0)`";
        scope.diagnostics.error_because(names[1].span(), message, reason);
        return None;
    }
    Some([p, q])
}

/// True if one of the points moves in the body that both belong to.
fn is_driven_in(scope: &Scope<'_>, owner: Body, points: [PointId; 2]) -> bool {
    let Body::Link(link) = owner else { return false };
    let moves = |point| scope.mechanism.coordinates_move(Carrier::Link(link), point);
    points.into_iter().any(|point| moves(point) != [false; 2])
}

/// Links, or the ground and a link.
pub(in crate::model) fn two_bodies(
    scope: &mut Scope<'_>,
    names: &[Ident; 2],
    what: &str,
) -> Option<[Carrier; 2]> {
    let bodies = [0, 1].map(|k| match names[k] == "ground" {
        true => Some(Carrier::Ground),
        false => uses::link(scope, &names[k]).map(Carrier::Link),
    });
    let [first, second] = [bodies[0]?, bodies[1]?];
    if first == second {
        let message = format!("{what} between two bodies");
        scope.diagnostics.error_because(names[1].span(), message, INSIDE);
        return None;
    }
    Some([first, second])
}

/// Every load is used, and gravity has a mass to pull.
pub(in crate::model) fn actions_have_an_effect(scope: &mut Scope<'_>, tree: &Declaration) {
    let (mut acting, mut named) = (Vec::new(), Vec::new());
    let mut masses = tree.unread.may_hold("mass");
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Action(action) => {
                masses |= matches!(action, Action::Mass(_));
                expressions(statement, &mut |expr| add_names(expr, &mut acting));
            }
            StatementKind::Output(OutputStatement { items }) => {
                items.iter().for_each(|item| add_names(&item.value, &mut named));
            }
            _ => {}
        }
    }
    follow_lets(tree, &mut acting);
    follow_lets(tree, &mut named);
    let Dynamics { loads, pull, .. } = &scope.mechanism.dynamics;
    for load in loads.iter().chain(pull) {
        let name = load.name.to_string();
        // A load that drives has to act.
        let is_given = scope.facts.driving.as_deref() != Some(&name);
        let is_used = acting.contains(&name) || is_given && named.contains(&name);
        // Where it stands in error, that was said.
        let is_mentioned = || scope.diagnostics.count() > 0 && is_mentioned(tree, &name);
        if is_used || tree.unread.may_hold(&name) || is_mentioned() {
            continue;
        }
        let message = format!("nothing uses the load `{name}`; use it or remove it");
        let reason = match load.dimension {
            Dimension::TORQUE => format!("as in `torque {name} on BC`"),
            _ => format!("as in `force (0, -{name}) on P`"),
        };
        scope.diagnostics.error_because(load.name.span(), message, reason);
    }
    if let Some(at) = scope.facts.gravity_at.filter(|_| !masses) {
        let message = "gravity without a mass does nothing; declare one or remove it";
        scope.diagnostics.error_because(at, message, "as in `mass 2kg on BC uniform`");
    }
}

/// True if any expression of the declaration holds the name, be it that of a function.
fn is_mentioned(tree: &Declaration, name: &str) -> bool {
    let mut is_mentioned = false;
    for statement in &tree.statements {
        expressions(statement, &mut |expr| {
            expr.each_part(&mut |part| {
                let called = matches!(&part.kind, ExprKind::Call(function, _) if function == name);
                is_mentioned |= called;
            });
            names_in(expr, &mut |used| is_mentioned |= used == name);
        });
    }
    is_mentioned
}
