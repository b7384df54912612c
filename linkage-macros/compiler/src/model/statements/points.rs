//! `point P on BC at …;`: points of a link, and driven points.

use proc_macro2::Ident;
use syn::Attribute;

use crate::exact::Exact;
use crate::function::Function;
use crate::reach::{absolute, apex};
use crate::syntax::tree::{self, Expr, Expr as Written, PointStatement};

use crate::model::assembly::{constants, polar};
use crate::model::figures::Figure;
use crate::model::folding::shown;
use crate::model::mechanism::{
    Carrier, GroupName, Length, LinkId, Operator, PartOf, Placement, PointId, Scalar, Sign, Step,
};
use crate::model::names::{Entity, Kind};
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::statements::made::MadeItem;
use crate::model::statements::{Rules, guides};
use crate::model::{declared, fits, modes, numbers, told_numbers, uses};

impl Rules for PointStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        vec![(&self.name, Kind::Point)]
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.on.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        match &self.place {
            tree::PointPlace::Cartesian(values)
            | tree::PointPlace::Polar(values)
            | tree::PointPlace::Distances(values, _) => values.iter().for_each(f),
            tree::PointPlace::Mistake => {}
        }
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        let (name, carrier) = (&self.name, guides::carrier(scope, self.on.as_ref()));
        let is_known = !matches!(self.place, tree::PointPlace::Mistake);
        let place = place(scope, name, carrier, &self.place)
            .map(|place| in_the_frame_of_its_group(scope, carrier, place));
        let carrier = carrier.filter(|_| is_known);
        let is_by_itself = self.on.is_none() && matches!(place, Some(Placement::Cartesian(_)));
        let moves = self.moves(scope);
        let point = placed_point(scope, docs, name, (carrier, place), moves);
        if point.is_some() && is_by_itself && !moves {
            fixed_point_is_ground(scope, name);
        }
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let by_itself = declared::group_by_itself(scope, "point", name);
        Some(Entity::Point(declared::new_point(scope, docs, name, PartOf::Pin(by_itself))))
    }
}

/// A point that a drawing became: one of a link, at a place in the frame that its group gave that.
pub(in crate::model) fn made_point(name: Ident, on: Ident, at: [Figure; 2]) -> MadeItem {
    let (makes, builds_on) = (vec![(name.clone(), Kind::Point)], vec![on.clone()]);
    MadeItem::new(makes, builds_on, at.to_vec(), move |scope, moves| {
        let carrier = uses::link(scope, &on).map(Carrier::Link);
        let place = told_numbers::lengths(scope, &at, name.span()).map(Placement::Cartesian);
        placed_point(scope, &[], &name, (carrier, place), moves);
    })
}

fn placed_point(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    (carrier, place): (Option<Carrier>, Option<Placement>),
    moves: bool,
) -> Option<PointId> {
    // Where its link is not known, neither is the point.
    let Some(carrier) = carrier else {
        uses::name_is_new(scope, name);
        return None;
    };
    let (part_of, group) = match carrier {
        Carrier::Ground => {
            (PartOf::Driven(declared::next_group(scope)), declared::next_group(scope))
        }
        Carrier::Link(link) => (PartOf::Link(link), scope.mechanism.links[link.index()].made_by),
    };
    let point = declared::add_point(scope, docs, name, part_of)?;
    if carrier == Carrier::Ground {
        scope
            .mechanism
            .groups
            .push(GroupName { keyword: Ident::new("point", name.span()), title: name.to_string() });
    }
    scope.facts.points[point.index()] = moves;
    if carrier != Carrier::Ground || !moves {
        let at = place.as_ref().and_then(constant_place);
        scope.facts.fix(point, carrier, at);
    }
    if let Some(place) = place {
        scope.mechanism.steps.push(Step::Point { point, carrier, place, group });
    }
    Some(point)
}

fn place(
    scope: &mut Scope<'_>,
    name: &Ident,
    carrier: Option<Carrier>,
    place: &tree::PointPlace,
) -> Option<Placement> {
    match place {
        tree::PointPlace::Mistake => None,
        tree::PointPlace::Cartesian(place) => {
            place_is_not_polar(scope, place)?;
            numbers::lengths(scope, place).map(Placement::Cartesian)
        }
        tree::PointPlace::Polar([radius, angle]) => {
            let (radius, angle) =
                (numbers::length(scope, radius), numbers::plain_angle(scope, angle));
            Some(Placement::Polar(radius?, angle?))
        }
        tree::PointPlace::Distances(distances, side) => {
            let which = ["first", "second"];
            let values = [0, 1].map(|i| {
                let value = numbers::length(scope, &distances[i])?;
                let what = format!("the {} distance of `{name}`", which[i]);
                fits::length_is_positive(scope, distances[i].span, &value, &what)?;
                let name = match bare_name(&distances[i]) {
                    Some(name) => name.to_string(),
                    None => format!("{} distance of {name}", which[i]),
                };
                Some(Length { value, name })
            });
            let side = modes::side_is_left_or_right(scope, side, name);
            if let Some(length) = length_as_drawn(scope, carrier?) {
                let [first, second] = values;
                let distances = [first?, second?];
                distances_meet(scope, name, carrier?, &distances, &length)?;
                return by_coordinates(distances, length, side?).map(Placement::Cartesian);
            }
            let length = distances_have_a_bar(scope, name, carrier?)?;
            let [first, second] = values;
            let distances = [first?, second?];
            distances_meet(scope, name, carrier?, &distances, &length)?;
            Some(Placement::Distances { distances, length, side: side? })
        }
    }
}

/// The place that is written in the frame of a drawn link, in that of the link's group.
fn in_the_frame_of_its_group(
    scope: &Scope<'_>,
    carrier: Option<Carrier>,
    place: Placement,
) -> Placement {
    let shift = carrier.and_then(|carrier| scope.mechanism.frame_shift(carrier));
    let Some(shift) = shift else { return place };
    match place {
        Placement::Cartesian(at) => Placement::Cartesian(shift.place(at)),
        Placement::Polar(radius, angle) => {
            let part = |function| match Scalar::call(function, vec![angle.clone()]) {
                Some(part) => radius.clone().times(part),
                None => Scalar::zero(),
            };
            let along = [part(Function::Cos), part(Function::Sin)];
            Placement::Cartesian(shift.place(along))
        }
        Placement::Distances { distances: [first, second], length, side } if shift.is_reversed => {
            let side = if side == Sign::Plus { Sign::Minus } else { Sign::Plus };
            Placement::Distances { distances: [second, first], length, side }
        }
        Placement::Distances { .. } => place,
    }
}

/// The length between the first two pins of a drawn link, where no group has it as a bar between them.
fn length_as_drawn(scope: &mut Scope<'_>, carrier: Carrier) -> Option<Scalar> {
    let (Some(drawn), Carrier::Link(link)) = (scope.drawn, carrier) else { return None };
    let name = &scope.mechanism.links[link.index()].name;
    let bar = drawn.bars.iter().find(|bar| bar.link == *name)?;
    bar.length.length(scope, name.span())
}

/// Distances from both ends of a bar as coordinates from its first. With a, b from both and l between them,
/// x = (l + (a − b)(a + b)/l)/2 and y² = (a − x)(a + x). `None` where constants do not meet.
fn by_coordinates(distances: [Length; 2], length: Scalar, side: Sign) -> Option<[Scalar; 2]> {
    let [a, b] = distances.map(|distance| distance.value);
    let square = a.clone().minus(b.clone()).times(a.clone().plus(b));
    let two = Scalar::Constant(Exact::integer(2));
    let along = square.combined(Operator::Div, length.clone())?;
    let x = length.plus(along).combined(Operator::Div, two)?;
    let square = a.clone().minus(x.clone()).times(a.plus(x.clone()));
    let y = Scalar::call(Function::Sqrt, vec![square])?;
    Some([x, if side == Sign::Plus { y } else { y.negated() }])
}

/// Reports a point in ground axes that no input moves: its link was forgotten.
fn fixed_point_is_ground(scope: &mut Scope<'_>, name: &Ident) {
    let message = match scope.mechanism.links.last() {
        Some(link) => format!(
            "`{name}` does not move; name its link, as in `point {name} on {} at …`",
            link.name
        ),
        None => format!("`{name}` does not move; write `ground {name}(x, y);`"),
    };
    let reason = format!("a fixed point is declared by `ground {name}(x, y);`");
    uses::report(
        scope,
        name.span(),
        message,
        (!scope.mechanism.links.is_empty()).then_some(reason),
    );
}

/// A distance and an angle are no coordinates `(x, y)`.
fn place_is_not_polar(scope: &mut Scope<'_>, [_, second]: &[Written; 2]) -> Option<()> {
    let is_angle = matches!(&second.kind, tree::ExprKind::Number { units, .. }
        if matches!(&units[..], [(unit, 1)] if ["deg", "rad", "turn"].contains(&unit.as_str())));
    if is_angle {
        let message = "an angle where a length belongs";
        let reason = "a distance and an angle are written `at polar (r, 20deg)`";
        scope.diagnostics.error_because(second.span, message, reason);
    }
    (!is_angle).then_some(())
}

/// Distances are measured from the two joints of a bar. Gives the bar's length.
fn distances_have_a_bar(scope: &mut Scope<'_>, name: &Ident, carrier: Carrier) -> Option<Scalar> {
    let Carrier::Link(link) = carrier else {
        let message = "distances need a bar; write `point … on BC at distances …`";
        let reason = "they are measured from the bar's outer joint and from its pin";
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    };
    let facts = &scope.facts.links[link.index()];
    if facts.is_bar {
        return facts.length.clone();
    }
    let link = &scope.mechanism.links[link.index()].name;
    let message = format!("`{link}` is no bar with two joints; give coordinates instead");
    let reason = format!("write `point {name} on {link} at (x, y);`");
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// Constant distances from the joints of a bar of constant length meet.
fn distances_meet(
    scope: &mut Scope<'_>,
    name: &Ident,
    carrier: Carrier,
    distances: &[Length; 2],
    length: &Scalar,
) -> Option<()> {
    let [first, second] = distances.each_ref().map(|distance| distance.value.constant());
    let (Some(a), Some(b), Some(l)) = (first, second, length.constant()) else {
        return Some(());
    };
    let difference = absolute(&a.sub(b));
    let (sum, link) = (a.add(b), link_name(scope, carrier));
    let (long, a, b) = (shown(l), shown(a), shown(b));
    let reason = if l.cmp_value(&sum).is_gt() {
        format!("`{link}` is {long} m, distances {a} m + {b} m reach {} m", shown(&sum))
    } else if l.cmp_value(&difference).is_lt() {
        let difference = shown(&difference);
        format!("`{link}` is {long} m, distances {a} m and {b} m stay {difference} m apart")
    } else {
        return Some(());
    };
    let message = format!("no point has the distances of `{name}`; change them");
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

fn link_name(scope: &Scope<'_>, carrier: Carrier) -> String {
    match carrier {
        Carrier::Ground => "ground".to_string(),
        Carrier::Link(LinkId(id)) => scope.mechanism.links[id as usize].name.to_string(),
    }
}

/// The coordinates of a place of constants.
fn constant_place(place: &Placement) -> Option<[Exact; 2]> {
    match place {
        Placement::Cartesian(place) => constants(place),
        Placement::Polar(radius, angle) => polar(radius, angle),
        Placement::Distances { distances, length, side } => {
            let [first, second] = distances;
            let distances = [first.value.constant()?, second.value.constant()?];
            let [x, y] = apex::apex(distances, length.constant()?)?;
            Some([x, if *side == Sign::Plus { y } else { y.neg() }])
        }
    }
}
