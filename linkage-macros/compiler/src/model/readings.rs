//! Readings of points and links that are placed already: coordinates, distances, angles and slides.

use proc_macro2::Ident;

use crate::syntax::expression::{FRICTION, RATES};
use crate::syntax::tree;

use crate::model::dimension::Measure;
use crate::model::mechanism::{Axis, Carrier, GuideId, LinkId, PointId, Scalar};
use crate::model::names::{Entity, Kind};
use crate::model::reads::{Allowed, Reads};
use crate::model::resolved_expr::{ResolvedExpr, bare_name, counted};
use crate::model::scope::Scope;
use crate::model::{drawn_sliding, dynamics_outputs, effort_formulas, uses};

/// True if links or inputs have an output of this name about forces.
fn is_of_forces(word: &str) -> bool {
    ["drive", "push", "normal", "couple"].contains(&word)
}

/// The value of a member of a point or a link in an expression.
pub(super) fn member(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    match scope.names.kind(owner) {
        Some(Kind::Point) => {
            let point = uses::point(scope, owner);
            let axis = axis(scope, owner, member);
            let value = coordinate(scope, point?, axis?);
            Some(ResolvedExpr::plain(Measure::LENGTH, value))
        }
        Some(Kind::Input) if is_of_forces(&member.to_string()) => {
            friction_is_implicit(scope, member);
            None
        }
        None if member == "x" || member == "y" => {
            uses::point(scope, owner);
            None
        }
        _ => member_of_link(scope, owner, member, allowed),
    }
}

/// A point has two coordinates.
fn axis(scope: &mut Scope<'_>, owner: &Ident, member: &Ident) -> Option<Axis> {
    let part = member.to_string();
    let (message, reason) = match part.as_str() {
        "x" => return Some(Axis::X),
        "y" => return Some(Axis::Y),
        rate if RATES.contains(&rate) => (
            format!("rates need no output of their own; write `output {owner}`"),
            format!("`velocity` gives that of `{owner}`, and `motion` its acceleration too"),
        ),
        "force" | "reaction" => {
            let of = match dynamics_outputs::link_that_touches(scope, owner) {
                Some(link) => format!("write `{link}.{owner}`"),
                None => format!("the forces at `{owner}` are those on its links"),
            };
            (of, format!("a reaction at `{owner}` acts on a link, which is named in front"))
        }
        _ if scope.names.kind(member) == Some(Kind::Link) => (
            format!("write `{member}.{owner}`"),
            format!("a reaction at `{owner}` acts on a link, which is named in front"),
        ),
        _ => (
            format!("a point has no `{part}`; it has `x` and `y`"),
            format!("write `{owner}.x` or `{owner}.y`; `output {owner}` gives both"),
        ),
    };
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}

/// A coordinate in ground axes: a number where the point stands still at a known place, the
/// expression it was declared with where it is a point of the ground.
fn coordinate(scope: &Scope<'_>, point: PointId, axis: Axis) -> Scalar {
    let of = |[x, y]: &[Scalar; 2]| if axis == Axis::X { x.clone() } else { y.clone() };
    if let Some(at) = scope.facts.place(point, Carrier::Ground) {
        return of(&at.clone().map(Scalar::Constant));
    }
    scope.mechanism.ground_place(point).map_or(Scalar::Coordinate(point, axis), of)
}

/// `distance(P, Q)`: a number where both points are fixed to one body.
pub(super) fn distance(
    scope: &mut Scope<'_>,
    name: &Ident,
    arguments: &[tree::Expr],
) -> Option<ResolvedExpr> {
    let points: Vec<_> = arguments.iter().map(|argument| end(scope, argument)).collect();
    let [p, q] = points[..] else {
        let message = format!("`{name}` takes two points, and {} given", counted(arguments.len()));
        scope.diagnostics.error(name.span(), message);
        return None;
    };
    let (p, q) = (p?, q?);
    if p == q {
        let message = "the distance of a point from itself is zero; name two points";
        scope.diagnostics.error(arguments[1].span, message);
        return None;
    }
    let value = match scope.facts.between(p, q) {
        Some([x, y]) => Scalar::Constant(x.hypot(&y)),
        None => Scalar::Distance([p, q]),
    };
    Some(ResolvedExpr::plain(Measure::LENGTH, value))
}

/// `offset(P, guide)`: a number where both are fixed to one body.
pub(super) fn offset_from_guide(
    scope: &mut Scope<'_>,
    name: &Ident,
    arguments: &[tree::Expr],
) -> Option<ResolvedExpr> {
    let [point, line] = arguments else {
        let given = counted(arguments.len());
        let message = format!("`{name}` takes a point and a guide, and {given} given");
        scope.diagnostics.error(name.span(), message);
        return None;
    };
    let (point, line) = (offset_of_a_point(scope, point), offset_from_a_line(scope, line));
    let (point, guide) = (point?, line?);
    let value = match scope.facts.line_and_place(guide, point) {
        Some((line, at)) => Scalar::Constant(line.distance(at)),
        None => Scalar::Offset(point, guide),
    };
    Some(ResolvedExpr::plain(Measure::LENGTH, value))
}

fn offset_of_a_point(scope: &mut Scope<'_>, argument: &tree::Expr) -> Option<PointId> {
    match bare_name(argument) {
        Some(name) if scope.names.kind(name) == Some(Kind::Guide) => {
            let message = format!("`{name}` is a guide; the point comes first");
            let reason = "write `offset(P, guide)`: how far P lies on the left of the guide";
            scope.diagnostics.error_because(argument.span, message, reason);
            None
        }
        Some(name) => uses::point(scope, name),
        None => no_bare_name(scope, argument, "an offset is that of a point; write its name"),
    }
}

fn offset_from_a_line(scope: &mut Scope<'_>, argument: &tree::Expr) -> Option<GuideId> {
    match bare_name(argument) {
        // A mistake in the first argument was reported there.
        Some(name) if scope.names.kind(name) == Some(Kind::Point) => {
            let message = format!("`{name}` is a point, and an offset is measured from a guide");
            let reason = "between two points there is `distance(P, Q)`";
            scope.diagnostics.error_because(argument.span, message, reason);
            None
        }
        Some(name) => uses::guide(scope, name),
        None => no_bare_name(scope, argument, "an offset is measured from a guide; write its name"),
    }
}

/// Reports an argument that should be a name.
fn no_bare_name<T>(scope: &mut Scope<'_>, argument: &tree::Expr, message: &str) -> Option<T> {
    if !argument.is_mistake() {
        let reason = "as in `offset(C, rail)`; points and guides are declared by themselves";
        scope.diagnostics.error_because(argument.span, message, reason);
    }
    None
}

/// True for the bare name of a point or a guide.
pub(super) fn is_a_place(scope: &Scope<'_>, expr: &tree::Expr) -> bool {
    let is_place = |kind| matches!(kind, Some(Kind::Point | Kind::Guide));
    bare_name(expr).is_some_and(|name| is_place(scope.names.kind(name)))
}

/// An end of a distance is a point, by its name.
fn end(scope: &mut Scope<'_>, argument: &tree::Expr) -> Option<PointId> {
    match bare_name(argument) {
        Some(name) => uses::point(scope, name),
        None if argument.is_mistake() => None,
        None => {
            let message = "a distance is between two points; write a point's name";
            let reason = "as in `distance(B, C)`; a point of a link is declared with `point`";
            scope.diagnostics.error_because(argument.span, message, reason);
            None
        }
    }
}

/// The value of a link's member: its angle, or its slide if it slides.
fn member_of_link(
    scope: &mut Scope<'_>,
    owner: &Ident,
    member: &Ident,
    allowed: Allowed,
) -> Option<ResolvedExpr> {
    let link = uses::link(scope, owner);
    match member.to_string().as_str() {
        "angle" => {
            let turn = scope.mechanism.turn_of(link?).cloned();
            Some(ResolvedExpr {
                measure: Measure::ANGLE,
                links: vec![(link?, 1)],
                rest: turn.unwrap_or_else(Scalar::zero),
                reads: Reads::default(),
            })
        }
        "slide" => {
            link_slides(scope, owner, link?, member)?;
            let by = drawn_sliding::slides_by(scope, owner, link?)?;
            Some(ResolvedExpr::plain(Measure::LENGTH, Scalar::Slide(by)))
        }
        "friction" if allowed.efforts => {
            effort_formulas::friction_is_at_a_joint(scope, owner, member);
            None
        }
        other if is_of_forces(other) || scope.names.kind(member).is_some() => {
            friction_is_implicit(scope, member);
            None
        }
        other => {
            let message = format!("`{owner}.{other}` stands in no expression");
            let reason = match other {
                "x" | "y" => {
                    "a link has `angle`, and `slide` if it slides; a point has `x` and `y`"
                }
                _ => "a link has `angle`, and `slide` if it slides",
            };
            scope.diagnostics.error_because(member.span(), message, reason);
            None
        }
    }
}

/// A reaction follows from all that acts: what acts cannot follow from it, too.
fn friction_is_implicit(scope: &mut Scope<'_>, member: &Ident) {
    let message = "only an output reads a reaction or an effort";
    scope.diagnostics.error_because(member.span(), message, FRICTION);
}

/// True if a link slides.
pub(super) fn slides(scope: &Scope<'_>, name: &Ident) -> bool {
    matches!(scope.names.entity(name), Some(Entity::Link(link)) if scope.mechanism.links[link.index()].slides)
}

/// Only a link that slides has a slide.
pub(super) fn link_slides(
    scope: &mut Scope<'_>,
    name: &Ident,
    link: LinkId,
    at: &Ident,
) -> Option<()> {
    let link = &scope.mechanism.links[link.index()];
    if link.slides {
        return Some(());
    }
    let (group, statement) = (link.made_by, scope.mechanism.statement(link.made_by));
    let is_drawn = drawn_sliding::is_drawn(scope, name);
    let sliding = scope.mechanism.links.iter().find(|l| l.made_by == group && l.slides);
    let reason = match sliding {
        _ if is_drawn => {
            format!("what slides is declared on a guide: `link {name}(…) on GUIDE;`")
        }
        Some(sliding) => format!("of `{statement}`, `{}` slides", sliding.name),
        None => format!("no link of `{statement}` slides on a guide"),
    };
    let message = format!("`{name}` does not slide");
    scope.diagnostics.error_because(at.span(), message, reason);
    None
}
