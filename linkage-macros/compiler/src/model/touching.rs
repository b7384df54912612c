//! Groups that constants bring to their limit exactly, between two bodies with a common joint: where a rocker, a coupler
//! or a geared crank passes, and not a crank on the ground alone.
//!
//! The distance of the outer joints then depends on the angle between both bodies alone, as that of a crank's pin from a
//! point of the ground: the same formulas say at which angle of that kind the modes are one. At which inputs the machine
//! comes there is found by its poses, where there are any.

use std::collections::HashSet;

use crate::exact::Exact;
use crate::model::findings::Touching;
use crate::model::mechanism::{
    Carrier, Group, GroupId, GroupName, Mechanism, Mode, Opposite, PointId,
};
use crate::model::opposite_sides::{corners, sides_are_equal};
use crate::model::scope::Scope;
use crate::reach::turn::Turn;

/// The part by which lengths may differ for which it is worth to compare them exactly.
const NEAR: f64 = 1e-9;

/// Those of groups of a constant mode that do not stand on a crank of the ground.
pub(super) fn touchings(scope: &Scope<'_>) -> Vec<Touching> {
    let known: HashSet<GroupId> =
        scope.mechanism.rotatabilities.iter().map(|found| found.group).collect();
    let groups = scope.mechanism.group_steps();
    let constant = groups
        .filter(|group| matches!(group.mode(), Some(Mode::Fixed(_))) && !known.contains(&group.id));
    constant.filter_map(|group| touching(scope, group)).collect()
}

fn touching(scope: &Scope<'_>, group: &Group) -> Option<Touching> {
    let constant = |index: usize| group.lengths.get(index)?.as_ref()?.value.constant();
    let [first, second] = &group.outer[..] else { return None };
    group.pin?;
    let on = first.point()?;
    match second.point() {
        Some(far) => {
            let lengths = [constant(0)?, constant(1)?];
            let is_own = |body: Carrier| is_of(group, body);
            let corners = corners(scope, [on, far]).into_iter();
            corners
                .filter(|corner| !corner.carriers.into_iter().any(is_own))
                .find_map(|corner| two_bars(scope, group, (corner, [on, far]), lengths))
        }
        None => {
            let lengths = [constant(0)?, second.offset()?.constant()?];
            let guide = group.slides_on(1);
            let carrier = scope.facts.guides[guide.index()].carrier;
            let is_other = |body: &Carrier| *body != carrier && !is_of(group, *body);
            let bodies = scope.facts.carriers(on).filter(is_other);
            bodies.into_iter().find_map(|body| {
                let common = |point: &PointId| scope.facts.belongs_to(*point, carrier);
                let mut hinges = scope.facts.points_of(body).filter(|p| *p != on).filter(common);
                hinges.find_map(|hinge| bar_and_block(scope, group, (hinge, on, body), lengths))
            })
        }
    }
}

/// The limits of two bars between joints on bodies that are pinned to each other at the corner.
fn two_bars(
    scope: &Scope<'_>,
    group: &Group,
    (opposite, [on, far]): (Opposite, [PointId; 2]),
    lengths: [&Exact; 2],
) -> Option<Touching> {
    let Opposite { corner: hinge, carriers: [of_far, of_on] } = opposite;
    let [[x, y], at] = [between(scope, of_on, hinge, on)?, between(scope, of_far, hinge, far)?];
    let [radius, base] = [[&x, &y], [&at[0], &at[1]]].map(|[x, y]| x.to_f64().hypot(y.to_f64()));
    let [a, b] = lengths.map(Exact::to_f64);
    let is_near = |x: f64, y: f64| (x - y).abs() <= NEAR * (a + b);
    if !(is_near(radius + base, a + b) || is_near((radius - base).abs(), (a - b).abs())) {
        return None;
    }
    let turn = Turn::of_two_bars(&radius_of(&x, &y)?, &at, lengths);
    found(group, (hinge, on, of_far), turn, sides_are_equal(scope, group, opposite))
}

/// Those of a bar to a block, between a joint on a body and a guide of another one, which are pinned to each other.
fn bar_and_block(
    scope: &Scope<'_>,
    group: &Group,
    (hinge, on, body): (PointId, PointId, Carrier),
    [length, offset]: [&Exact; 2],
) -> Option<Touching> {
    let guide = &scope.facts.guides[group.slides_on(1).index()];
    let line = guide.line.as_ref()?;
    let [x, y] = between(scope, body, hinge, on)?;
    let pivot = line.distance(scope.facts.place(hinge, guide.carrier)?).sub(offset);
    let (radius, off, long) = (x.to_f64().hypot(y.to_f64()), pivot.to_f64().abs(), length.to_f64());
    // Farthest off the line, or nearest to it on the other side of the hinge.
    if ![off + radius, off - radius].iter().any(|off| (off.abs() - long).abs() <= NEAR * long) {
        return None;
    }
    let turn = Turn::of_bar_and_block(&radius_of(&x, &y)?, &pivot, &line.angle, length);
    found(group, (hinge, on, guide.carrier), turn, false)
}

fn found(
    group: &Group,
    (hinge, on, against): (PointId, PointId, Carrier),
    turn: Turn,
    is_parallelogram: bool,
) -> Option<Touching> {
    let angles = turn.change_points;
    (!angles.is_empty()).then(|| Touching {
        group: group.id,
        hinge,
        on,
        against,
        angles,
        is_parallelogram,
        inputs: Vec::new(),
    })
}

/// True of the links of a group itself, whose joint is its pin.
fn is_of(group: &Group, body: Carrier) -> bool {
    matches!(body, Carrier::Link(link) if group.links.contains(&link))
}

/// The vector between two points of a body, where it is constant.
fn between(scope: &Scope<'_>, body: Carrier, from: PointId, to: PointId) -> Option<[Exact; 2]> {
    let [from, to] = [scope.facts.place(from, body)?, scope.facts.place(to, body)?];
    Some([to[0].sub(&from[0]), to[1].sub(&from[1])])
}

/// Its length, where it has one.
fn radius_of(x: &Exact, y: &Exact) -> Option<Exact> {
    let radius = x.hypot(y);
    (!radius.is_zero()).then_some(radius)
}

/// The message of a change point and what to do, given the quantity that has these values there, in words.
pub(crate) fn in_words(
    mechanism: &Mechanism,
    group: GroupId,
    at: &str,
    is_parallelogram: bool,
    is_drawn: bool,
) -> [String; 2] {
    let GroupName { title, .. } = &mechanism.groups[group.index()];
    let message = format!("`{title}` can be assembled in one way alone at {at}: a change point");
    let follow = "a parameter, `param side: mode = …;`, and a `Tracker` follow the motion through";
    let reason = match (is_drawn, is_parallelogram) {
        (true, _) => format!(
            "behind it the solver may be in another assembly than the machine; change a length, or declare the group by \
             hand: {follow}"
        ),
        (false, true) => format!("`mode: parallel` keeps it a parallelogram; {follow}"),
        (false, false) => format!("behind it the mode stands for another motion; {follow}"),
    };
    [message, reason]
}
