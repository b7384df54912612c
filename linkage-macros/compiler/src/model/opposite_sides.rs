//! Parallelograms: the fourth corner of an rrr, and whether the sides there are as long as the bars opposite to them.
//!
//! The bars BC and DC make a parallelogram with a point A that is on one body with B and on another with D, where
//! |AB| = |DC| and |AD| = |BC|. Lengths are equal by the same expression, or exactly by their numbers.

use std::collections::HashSet;

use crate::exact::Exact;

use crate::model::assembly::span_of;
use crate::model::expr::Scalar;
use crate::model::folding::shown;
use crate::model::mechanism::{
    Carrier, Length, Mechanism, Opposite, PartOf, Placement, PointId, Step,
};
use crate::model::parts_of_groups::Parts;
use crate::model::same_expression::{difference, hypotenuse, is_same};
use crate::model::scope::Scope;
use crate::syntax::tree::Expr;

/// The corner of `mode: parallel`, which is refused where there is none.
pub(super) fn opposite_sides(
    scope: &mut Scope<'_>,
    parts: &Parts,
    lengths: &[Option<Length>],
    at: &Expr,
) -> Option<Opposite> {
    let outer = [parts.point(0)?, parts.point(1)?];
    let lengths = [lengths.first()?.as_ref()?, lengths.get(1)?.as_ref()?];
    let corners = corners(scope, outer);
    let equal =
        corners.iter().find(|corner| unequal_side(scope, **corner, outer, lengths).is_none());
    if let Some(corner) = equal {
        return Some(*corner);
    }
    if scope.diagnostics.count() > 0 {
        // A corner may be missing because of another mistake.
        return None;
    }
    let (message, reason) = match corners.first() {
        Some(corner) => sides_differ(scope, parts, *corner, outer, lengths),
        None => no_corner(scope, parts, outer),
    };
    scope.diagnostics.error_because(at.span, message, reason);
    None
}

/// The points that are on one body with the first joint and on another one with the second.
fn corners(scope: &Scope<'_>, [b, d]: [PointId; 2]) -> Vec<Opposite> {
    let facts = &scope.facts;
    let mut found = Vec::new();
    for of_b in facts.carriers(b) {
        let beside: HashSet<PointId> = facts.points_of(of_b).filter(|point| *point != b).collect();
        for of_d in facts.carriers(d).filter(|of_d| *of_d != of_b) {
            let common =
                facts.points_of(of_d).filter(|point| *point != d && beside.contains(point));
            found.extend(common.map(|corner| Opposite { corner, carriers: [of_d, of_b] }));
        }
    }
    found
}

/// The first bar whose opposite side is not known to be as long.
fn unequal_side(
    scope: &Scope<'_>,
    Opposite { corner, carriers }: Opposite,
    outer: [PointId; 2],
    lengths: [&Length; 2],
) -> Option<usize> {
    [0, 1].into_iter().find(|&bar| {
        let ends = [corner, outer[1 - bar]];
        !is_as_long(scope, carriers[bar], ends, &lengths[bar].value)
    })
}

/// True if the two points of a body are known to be that far apart.
fn is_as_long(scope: &Scope<'_>, carrier: Carrier, ends: [PointId; 2], length: &Scalar) -> bool {
    if let (Some(length), Some(square)) = (length.constant(), square_of_side(scope, carrier, ends))
    {
        return length.mul(length).cmp_value(&square).is_eq();
    }
    let mechanism = &scope.mechanism;
    side(scope, carrier, ends).is_some_and(|side| is_same(mechanism, &side, length))
}

/// The square of the distance, which is rational where the coordinates are.
fn square_of_side(scope: &Scope<'_>, carrier: Carrier, ends: [PointId; 2]) -> Option<Exact> {
    let [[x0, y0], [x1, y1]] =
        [scope.facts.place(ends[0], carrier)?, scope.facts.place(ends[1], carrier)?];
    let (dx, dy) = (x1.sub(x0), y1.sub(y0));
    Some(dx.mul(&dx).add(&dy.mul(&dy)))
}

/// The distance between two points of a body, as an expression.
fn side(scope: &Scope<'_>, carrier: Carrier, [from, to]: [PointId; 2]) -> Option<Scalar> {
    let given = |point, other| given_distance(scope, carrier, point, other);
    if let Some(distance) = given(from, to).or_else(|| given(to, from)) {
        return Some(distance);
    }
    let [[x0, y0], [x1, y1]] =
        [coordinates(scope, carrier, from)?, coordinates(scope, carrier, to)?];
    let mechanism = &scope.mechanism;
    hypotenuse(difference(mechanism, x1, x0)?, difference(mechanism, y1, y0)?)
}

/// The distance of a point from a joint of its link, where its place is given by it.
fn given_distance(
    scope: &Scope<'_>,
    carrier: Carrier,
    point: PointId,
    joint: PointId,
) -> Option<Scalar> {
    let is_origin = coordinates(scope, carrier, joint)?.iter().all(Scalar::is_zero);
    match place(&scope.mechanism, carrier, point)? {
        Placement::Cartesian(_) => None,
        Placement::Polar(radius, _) => is_origin.then(|| radius.clone()),
        Placement::Distances { distances, .. } => {
            Some(distances[usize::from(!is_origin)].value.clone())
        }
    }
}

fn place(mechanism: &Mechanism, of: Carrier, asked: PointId) -> Option<&Placement> {
    mechanism.steps.iter().find_map(|step| match step {
        Step::Point { point, carrier, place, .. } if (*point, *carrier) == (asked, of) => {
            Some(place)
        }
        _ => None,
    })
}

/// The coordinates of a point of a body, in its frame.
fn coordinates(scope: &Scope<'_>, carrier: Carrier, asked: PointId) -> Option<[Scalar; 2]> {
    if let Some([x, y]) = scope.facts.place(asked, carrier) {
        return Some([Scalar::Constant(x.clone()), Scalar::Constant(y.clone())]);
    }
    if let Some(Placement::Cartesian(at)) = place(&scope.mechanism, carrier, asked) {
        return Some(at.clone());
    }
    let Carrier::Link(link) = carrier else {
        return scope.mechanism.steps.iter().find_map(|step| match step {
            Step::Ground { point, at } if *point == asked => Some(at.clone()),
            _ => None,
        });
    };
    // The other point of a bar is its joint, at the origin.
    let facts = &scope.facts.links[link.index()];
    let is_pin = facts.is_bar && scope.facts.belongs_to(asked, carrier);
    let made_by = scope.mechanism.links[link.index()].made_by;
    let is_pin = is_pin && scope.mechanism.points[asked.index()].part_of == PartOf::Pin(made_by);
    is_pin.then(|| facts.length.clone()).flatten().map(|length| [length, Scalar::zero()])
}

fn sides_differ(
    scope: &Scope<'_>,
    parts: &Parts,
    corner: Opposite,
    outer: [PointId; 2],
    lengths: [&Length; 2],
) -> (String, String) {
    let bar = unequal_side(scope, corner, outer, lengths).unwrap_or_default();
    let (ends, carrier) = ([corner.corner, outer[1 - bar]], corner.carriers[bar]);
    let (name, side) = (&parts.group.legs[bar].link, span_of(scope, ends));
    let numbers = lengths[bar].value.constant().zip(square_of_side(scope, carrier, ends));
    let message = match numbers.and_then(|(length, square)| Some((length, square.sqrt()?))) {
        Some((length, of_side)) => format!(
            "`parallel` needs opposite sides of one length: `{name}` is {} m, and {side} is {} m",
            shown(length),
            shown(&of_side)
        ),
        None => format!(
            "`parallel` needs opposite sides of one length, and that of `{name}` is not known to be {side}"
        ),
    };
    let reason = "give both the same expression or the same number, or write `left` or `right`";
    (message, reason.to_string())
}

fn no_corner(scope: &Scope<'_>, parts: &Parts, outer: [PointId; 2]) -> (String, String) {
    let [b, d] = outer.map(|point| &scope.mechanism.points[point.index()].name);
    let pin = parts.group.pin.as_ref().map_or("the pin".to_string(), |pin| format!("`{pin}`"));
    let message =
        format!("`{b}` and `{d}` make no parallelogram with {pin}; write `left` or `right`");
    let reason = format!(
        "`parallel` needs a fourth corner: a point that is on one body with `{b}` and on another with `{d}`"
    );
    (message, reason)
}
