//! Guides: lines with a direction, fixed in the ground or in a link.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::exact::Exact;
use crate::reach::line::BodyLine;
use crate::syntax::tree::{Course, Expr, GuideAnchor, GuideStatement};

use crate::model::assembly::constants;
use crate::model::facts::GuideFacts;
use crate::model::figures::Figure;
use crate::model::mechanism::{
    Carrier, Dimension, Guide, GuideDirection, GuideId, LinkId, PointId, Step, Through,
};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::statements::made::MadeItem;
use crate::model::{told_numbers, uses};

impl Rules for GuideStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        vec![(&self.name, Kind::Guide)]
    }

    fn builds_on(&self) -> Vec<&Ident> {
        let [through, towards] = guide_points(self);
        self.on.iter().chain(through).chain(towards).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        if let GuideAnchor::At(place) = &self.through {
            place.iter().for_each(&mut *f);
        }
        if let Course::Along(angle) = &self.course {
            f(angle);
        }
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let line = (&anchor_in_figures(&self.through), &course_in_figures(&self.course));
        guide_line(scope, (&self.name, self.on.as_ref()), line, (false, self.moves(scope)));
    }

    fn stand_in(&self, scope: &mut Scope<'_>, _docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let guides = &mut scope.mechanism.guides;
        guides.push(Guide { name: name.clone() });
        let carrier = Carrier::Ground;
        let facts = GuideFacts { moves: false, carrier, line: None, angle: None };
        scope.facts.guides.push(facts);
        Some(Entity::Guide(GuideId(guides.len() as u32 - 1)))
    }
}

/// The points that a guide runs through and towards, where it names them.
pub(in crate::model) fn guide_points(guide: &GuideStatement) -> [Option<&Ident>; 2] {
    [anchor_point(&guide.through), course_point(&guide.course)]
}

fn anchor_point<N>(anchor: &GuideAnchor<N>) -> Option<&Ident> {
    match anchor {
        GuideAnchor::Point(point) => Some(point),
        GuideAnchor::At(_) | GuideAnchor::Mistake => None,
    }
}

fn course_point<N>(course: &Course<N>) -> Option<&Ident> {
    match course {
        Course::Towards(point) => Some(point),
        Course::Along(_) | Course::Mistake => None,
    }
}

pub(in crate::model) fn anchor_in_figures(anchor: &GuideAnchor) -> GuideAnchor<Figure> {
    match anchor {
        GuideAnchor::At(place) => GuideAnchor::At(
            place.clone().map(|part| Figure::written(part, Some(Dimension::LENGTH))),
        ),
        GuideAnchor::Point(point) => GuideAnchor::Point(point.clone()),
        GuideAnchor::Mistake => GuideAnchor::Mistake,
    }
}

pub(in crate::model) fn course_in_figures(course: &Course) -> Course<Figure> {
    match course {
        Course::Along(angle) => {
            Course::Along(Figure::written(angle.clone(), Some(Dimension::ANGLE)))
        }
        Course::Towards(point) => Course::Towards(point.clone()),
        Course::Mistake => Course::Mistake,
    }
}

/// A guide that a drawing became or places. Numbers are in the frame that a group gave its link, or in the written one.
pub(in crate::model) fn made_guide(
    name: Ident,
    on: Option<Ident>,
    (through, course): (GuideAnchor<Figure>, Course<Figure>),
    is_in_its_group: bool,
) -> MadeItem {
    let points = anchor_point(&through).into_iter().chain(course_point(&course));
    let builds_on = on.iter().chain(points).cloned().collect();
    let mut numbers = Vec::new();
    if let GuideAnchor::At(place) = &through {
        numbers.extend(place.iter().cloned());
    }
    if let Course::Along(angle) = &course {
        numbers.push(angle.clone());
    }
    MadeItem::new(vec![(name.clone(), Kind::Guide)], builds_on, numbers, move |scope, moves| {
        guide_line(scope, (&name, on.as_ref()), (&through, &course), (is_in_its_group, moves));
    })
}

/// Where a guide goes through or towards, and its place if that is constant.
type Anchored<T> = Option<(T, Option<[Exact; 2]>)>;

fn guide_line(
    scope: &mut Scope<'_>,
    (name, on): (&Ident, Option<&Ident>),
    (through, course): (&GuideAnchor<Figure>, &Course<Figure>),
    (is_in_its_group, moves): (bool, bool),
) {
    let is_new = uses::name_is_new(scope, name).is_some();
    let carrier = carrier(scope, on);
    let frame = carrier.filter(|_| !is_in_its_group).unwrap_or(Carrier::Ground);
    let through = spot(scope, (through, name.span()), carrier, frame);
    let course = self::course(scope, (course, name.span()), carrier, frame);
    let course = guide_has_a_direction(scope, name, carrier, &through, course);
    let Some(carrier) = carrier.filter(|_| is_new) else { return };
    let id = GuideId(scope.mechanism.guides.len() as u32);
    scope.mechanism.guides.push(Guide { name: name.clone() });
    scope.names.bind(name, Entity::Guide(id));
    let place = through.as_ref().and_then(|(_, place)| place.clone());
    let angle = match (&course, &place) {
        (Some((GuideDirection::Along(turn), _)), _) => turn.constant().cloned(),
        (Some((GuideDirection::Towards(_), Some(to))), Some(from)) => {
            to[1].sub(&from[1]).atan2(&to[0].sub(&from[0]))
        }
        _ => None,
    };
    let line = place.zip(angle.clone()).map(|(through, angle)| BodyLine { through, angle });
    scope.facts.guides.push(GuideFacts { moves, carrier, line, angle });
    if let (Some((through, _)), Some((course, _))) = (through, course) {
        scope.mechanism.steps.push(Step::Guide { guide: id, carrier, through, course });
    }
}

/// The body that something is declared on; the ground where none is named.
pub(in crate::model) fn carrier(scope: &mut Scope<'_>, on: Option<&Ident>) -> Option<Carrier> {
    match on {
        None => Some(Carrier::Ground),
        Some(name) if name == "ground" => Some(Carrier::Ground),
        Some(name) => uses::link(scope, name).map(Carrier::Link),
    }
}

/// The point a guide goes through, and its place if that is constant. Coordinates are in the written frame of the body.
fn spot(
    scope: &mut Scope<'_>,
    (spot, at): (&GuideAnchor<Figure>, Span),
    carrier: Option<Carrier>,
    body: Carrier,
) -> Anchored<Through> {
    match spot {
        GuideAnchor::At(place) => {
            let place = told_numbers::lengths(scope, place, at)?;
            let place = scope.mechanism.placed(body, place);
            let at = constants(&place);
            Some((Through::At(place), at))
        }
        GuideAnchor::Point(name) => {
            let (point, at) = point_lies_on_carrier(scope, name, carrier)?;
            Some((Through::Point(point), at))
        }
        GuideAnchor::Mistake => None,
    }
}

/// Where a guide goes, and where that lies if it is a point at a constant place. An angle is against the written frame
/// of the body.
fn course(
    scope: &mut Scope<'_>,
    (course, at): (&Course<Figure>, Span),
    carrier: Option<Carrier>,
    body: Carrier,
) -> Anchored<GuideDirection> {
    match course {
        Course::Along(angle) => {
            axis_is_an_angle(scope, (angle, at))?;
            let angle = angle.turn(scope)?;
            Some((GuideDirection::Along(scope.mechanism.turned(body, angle)), None))
        }
        Course::Towards(name) => {
            let (point, at) = point_lies_on_carrier(scope, name, carrier)?;
            Some((GuideDirection::Towards(point), at))
        }
        Course::Mistake => None,
    }
}

/// An axis, by its name, is no angle.
fn axis_is_an_angle(scope: &mut Scope<'_>, (angle, at): (&Figure, Span)) -> Option<()> {
    let name = angle.name().filter(|name| scope.names.kind(name).is_none());
    let degrees = match name.map(ToString::to_string).as_deref() {
        Some("x" | "X" | "horizontal") => "0deg",
        Some("y" | "Y" | "vertical") => "90deg",
        _ => return Some(()),
    };
    let message = format!("write `along {degrees}`");
    scope.diagnostics.error_because(angle.at(at), message, "a direction is an angle from +x");
    None
}

/// A guide goes through points of the body it is fixed in.
fn point_lies_on_carrier(
    scope: &mut Scope<'_>,
    name: &Ident,
    carrier: Option<Carrier>,
) -> Option<(PointId, Option<[Exact; 2]>)> {
    let point = uses::point(scope, name)?;
    let carrier = carrier?;
    if scope.facts.belongs_to(point, carrier) {
        return Some((point, scope.facts.place(point, carrier).cloned()));
    }
    match carrier {
        Carrier::Ground => {
            let message =
                format!("`{name}` is no ground point, and the guide is fixed in the ground");
            let reason = match links_through(scope, point).as_slice() {
                [] => "use a ground point, or declare the guide on a link".to_string(),
                [link, ..] => format!("declare the guide on a link: `guide … on {link} …`"),
            };
            scope.diagnostics.error_because(name.span(), message, reason);
        }
        // A joint of the link may have been in error, and the name may be meant for it.
        Carrier::Link(link) if !scope.facts.links[link.index()].has_its_joints => {}
        Carrier::Link(link) => no_point_of(scope, name, link),
    }
    None
}

/// Says so, and which are.
pub(in crate::model) fn no_point_of(scope: &mut Scope<'_>, name: &Ident, link: LinkId) {
    let points = scope.facts.points_of(Carrier::Link(link));
    let points: Vec<_> =
        points.map(|point| format!("`{}`", scope.mechanism.points[point.index()].name)).collect();
    let link = &scope.mechanism.links[link.index()].name;
    let message = format!("`{name}` is no point of `{link}`");
    let reason = match points.as_slice() {
        [] => format!("declare one: `point {name}1 on {link} at (…, …);`"),
        _ => format!("its points are {}", points.join(", ")),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
}

fn links_through<'s>(scope: &'s Scope<'_>, point: PointId) -> Vec<&'s Ident> {
    let links = scope.mechanism.links.iter().enumerate();
    links
        .filter(|&(i, _)| scope.facts.belongs_to(point, Carrier::Link(LinkId(i as u32))))
        .map(|(_, link)| &link.name)
        .collect()
}

/// The course of a guide; none where its two points are the same, or at the same constant place, which is reported.
fn guide_has_a_direction(
    scope: &mut Scope<'_>,
    name: &Ident,
    carrier: Option<Carrier>,
    through: &Anchored<Through>,
    course: Anchored<GuideDirection>,
) -> Anchored<GuideDirection> {
    let (Some((through, from)), Some((GuideDirection::Towards(to), _))) = (through, &course) else {
        return course;
    };
    let same = matches!(through, Through::Point(point) if point == to);
    let place = carrier.and_then(|carrier| scope.facts.place(*to, carrier));
    let coincide = from
        .as_ref()
        .zip(place)
        .is_some_and(|(from, to)| from.iter().zip(to).all(|(from, to)| from.sub(to).is_zero()));
    if !same && !coincide {
        return course;
    }
    let message = format!("`{name}` has no direction; choose two points that differ");
    let to = &scope.mechanism.points[to.index()].name;
    let reason = match through {
        Through::Point(from) if scope.mechanism.points[from.index()].name == *to => {
            format!("it goes through `{to}` and towards `{to}`")
        }
        Through::Point(from) => {
            format!("`{}` and `{to}` coincide", scope.mechanism.points[from.index()].name)
        }
        Through::At(_) => format!("it already goes through `{to}`"),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}
