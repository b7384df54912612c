//! Parallelograms: the fourth corner of an rrr, and whether the sides there are as long as the bars opposite to them.
//!
//! The bars BC and DC make a parallelogram with a point A that is on one body with B and on another with D, where
//! |AB| = |DC| and |AD| = |BC|. Lengths are equal by the same expression, or exactly by their numbers.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::exact::Exact;

use crate::model::assembly::span_of;
use crate::model::expr::Scalar;
use crate::model::folding::shown_f64;
use crate::model::mechanism::{
    Carrier, Group, Length, Mechanism, Mode, Opposite, PartOf, Placement, PointId, Step,
};
use crate::model::parts_of_groups::Parts;
use crate::model::same_expression::{difference, hypotenuse, is_same};
use crate::model::scope::Scope;
use crate::syntax::tree::Expr;

/// The most by which sides may differ that are meant to be as long, in parts of the bar.
const NEARLY: f64 = 1e-3;

/// The corner of `mode: parallel`, which is refused where there is none.
pub(super) fn declared(
    scope: &mut Scope<'_>,
    parts: &Parts,
    lengths: &[Option<Length>],
    at: &Expr,
) -> Option<Opposite> {
    let bars = Bars::of(parts, lengths)?;
    let corners = corners(scope, bars.outer);
    if let Some(corner) = corners.iter().find(|corner| bars.unequal_side(scope, **corner).is_none())
    {
        return Some(*corner);
    }
    if scope.diagnostics.count() > 0 {
        // A corner may be missing because of another mistake.
        return None;
    }
    let (message, reason) = match corners.first() {
        Some(corner) => (
            format!(
                "`parallel` needs opposite sides of one length: {}",
                bars.difference(scope, parts, *corner)
            ),
            "give both the same expression or the same number, or write `left` or `right`"
                .to_string(),
        ),
        None => no_corner(scope, parts, bars.outer),
    };
    scope.diagnostics.error_because(at.span, message, reason);
    None
}

/// The corner of what is drawn as a parallelogram. Where its sides are not known to be equal, and where those of bars
/// with a constant mode nearly are, it is noted.
pub(super) fn drawn(
    scope: &mut Scope<'_>,
    parts: &Parts,
    lengths: &[Option<Length>],
    mode: Mode,
) -> Option<Opposite> {
    let (pin, bars) = (parts.pin_name.as_ref()?, Bars::of(parts, lengths)?);
    let named = scope.drawn.and_then(|drawn| drawn.parallels.get(pin));
    let is_named = |opposite: &Opposite| {
        let corner = &scope.mechanism.points[opposite.corner.index()].name;
        named.is_none_or(|named| named.contains(corner))
    };
    let corners: Vec<_> = corners(scope, bars.outer).into_iter().filter(is_named).collect();
    let is_drawn = named.is_some();
    let equal = corners.iter().find(|corner| bars.unequal_side(scope, **corner).is_none());
    if let Some(corner) = equal {
        return is_drawn.then_some(*corner);
    }
    let is_near = |corner: &&Opposite| is_drawn || bars.are_nearly_equal(scope, **corner);
    if let (Mode::Fixed(_), Some(corner)) = (mode, corners.iter().find(is_near)) {
        note_unequal_sides(scope, parts, &bars, *corner, is_drawn);
    }
    None
}

fn note_unequal_sides(
    scope: &mut Scope<'_>,
    parts: &Parts,
    bars: &Bars<'_>,
    corner: Opposite,
    is_drawn: bool,
) {
    let title = scope.mechanism.groups[parts.id.index()].title.clone();
    let sides = bars.difference(scope, parts, corner);
    let message = match is_drawn {
        true => format!("`{title}` is drawn as a parallelogram, but does not stay one: {sides}"),
        false => format!("`{title}` is nearly a parallelogram: {sides}"),
    };
    let reason = match is_drawn {
        true => {
            "near one line its bars jam or cross; draw opposite sides with the same numbers, or give them the same length"
        }
        false => {
            "near one line its bars jam or cross; with equal sides `mode: parallel` keeps it a parallelogram"
        }
    };
    scope.diagnostics.note_because(parts.at, message, reason);
}

/// Two bars: their outer joints and lengths.
struct Bars<'l> {
    outer: [PointId; 2],
    lengths: [&'l Length; 2],
}

/// The points that are on one body with the first joint and on another one with the second.
pub(super) fn corners(scope: &Scope<'_>, [b, d]: [PointId; 2]) -> Vec<Opposite> {
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

impl<'l> Bars<'l> {
    fn of(parts: &Parts, lengths: &'l [Option<Length>]) -> Option<Self> {
        let outer = [parts.point(0)?, parts.point(1)?];
        Some(Self { outer, lengths: [lengths.first()?.as_ref()?, lengths.get(1)?.as_ref()?] })
    }

    /// The body of the side opposite to a bar, and the ends of the side.
    fn opposite_side(&self, corner: Opposite, bar: usize) -> (Carrier, [PointId; 2]) {
        (corner.carriers[bar], [corner.corner, self.outer[1 - bar]])
    }

    /// The first bar whose opposite side is not known to be as long.
    fn unequal_side(&self, scope: &Scope<'_>, corner: Opposite) -> Option<usize> {
        [0, 1].into_iter().find(|&bar| {
            let (carrier, ends) = self.opposite_side(corner, bar);
            !is_as_long(scope, carrier, ends, &self.lengths[bar].value)
        })
    }

    /// The number of a bar, and how much longer its opposite side is, where both are constant.
    fn excess(&self, scope: &Scope<'_>, corner: Opposite, bar: usize) -> Option<[f64; 2]> {
        let (carrier, ends) = self.opposite_side(corner, bar);
        let length = self.lengths[bar].value.constant()?;
        let square = square_of_side(scope, carrier, ends)?;
        // (s² − l²)/(s + l): exact where they are nearly equal.
        let (wide, sum) =
            (square.sub(&length.mul(length)).to_f64(), square.to_f64().sqrt() + length.to_f64());
        Some([length.to_f64(), wide / sum])
    }

    fn are_nearly_equal(&self, scope: &Scope<'_>, corner: Opposite) -> bool {
        [0, 1].into_iter().all(|bar| {
            let excess = self.excess(scope, corner, bar);
            excess.is_some_and(|[length, excess]| excess.abs() <= NEARLY * length)
        })
    }

    /// The difference of sides that are not known to be equal, in words.
    fn difference(&self, scope: &Scope<'_>, parts: &Parts, corner: Opposite) -> String {
        let bar = self.unequal_side(scope, corner).unwrap_or_default();
        let (_, ends) = self.opposite_side(corner, bar);
        let (name, side) = (link_name(scope, parts, bar), span_of(&scope.mechanism, ends));
        match self.excess(scope, corner, bar) {
            Some([length, excess]) => {
                let than = if excess > 0.0 { "longer" } else { "shorter" };
                let [length, excess] = [length, excess.abs()].map(shown_f64);
                format!("`{name}` is {length} m, and {side} is {excess} m {than}")
            }
            None => format!("that of `{name}` is not known to be {side}"),
        }
    }
}

fn link_name(scope: &Scope<'_>, parts: &Parts, bar: usize) -> String {
    let link = parts.link(bar).map(|link| &scope.mechanism.links[link.index()].name);
    link.map_or(String::new(), Ident::to_string)
}

/// True if the sides of a corner are known to be as long as the bars of a group.
pub(super) fn sides_are_equal(scope: &Scope<'_>, group: &Group, corner: Opposite) -> bool {
    let outer = |bar: usize| group.outer[bar].point();
    let ([Some(first), Some(second)], [Some(a), Some(b)]) =
        ([outer(0), outer(1)], [&group.lengths[0], &group.lengths[1]])
    else {
        return false;
    };
    let bars = Bars { outer: [first, second], lengths: [a, b] };
    bars.unequal_side(scope, corner).is_none()
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
        return scope.mechanism.ground_place(asked).cloned();
    };
    // The other point of a bar is its joint, at the origin.
    let facts = &scope.facts.links[link.index()];
    let is_pin = facts.is_bar && scope.facts.belongs_to(asked, carrier);
    let made_by = scope.mechanism.links[link.index()].made_by;
    let is_pin = is_pin && scope.mechanism.points[asked.index()].part_of == PartOf::Pin(made_by);
    is_pin.then(|| facts.length.clone()).flatten().map(|length| [length, Scalar::zero()])
}

fn no_corner(scope: &Scope<'_>, parts: &Parts, outer: [PointId; 2]) -> (String, String) {
    let [b, d] = outer.map(|point| &scope.mechanism.points[point.index()].name);
    let pin = parts.pin_name.as_ref().map_or("the pin".to_string(), |pin| format!("`{pin}`"));
    let message =
        format!("`{b}` and `{d}` make no parallelogram with {pin}; write `left` or `right`");
    let reason = format!(
        "`parallel` needs a fourth corner: a point that is on one body with `{b}` and on another with `{d}`"
    );
    (message, reason)
}
