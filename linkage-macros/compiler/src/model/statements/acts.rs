//! Rules that masses, forces, torques, springs, stops and frictions share.

use proc_macro2::Ident;

use crate::syntax::tree;

use crate::model::mechanism::{Body, Carrier, Dimension, PointId, Scalar};
use crate::model::rates::is_rate;
use crate::model::reads::Allowed;
use crate::model::scope::Scope;
use crate::model::{fits, laws, loads_in_forces, numbers, uses};

const INSIDE: &str = "what acts inside a body moves nothing";

/// A number of the machine itself: constants and parameters.
pub(in crate::model) fn changes_with_no_input(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    what: &str,
) -> Option<()> {
    // Rates have a message of their own.
    let of_a_rate = fits::first(scope, expr, &|scope, part| {
        is_rate(part) || laws::is_law(scope, part, |_| true)
    })
    .is_some();
    let Some(span) = fits::moving_part(scope, expr).filter(|_| !of_a_rate) else {
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
    loads_in_forces::is_linear_in_pull(scope, expr, &value)?;
    Some(value)
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
