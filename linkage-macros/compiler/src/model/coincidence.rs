//! Facts that constants fix about an rrr, for its docs: the distance between its outer joints, and a
//! mode that puts the pin onto a point that is there already.

use crate::exact::Exact;

use crate::model::mechanism::{GroupId, Known, Length, PointId};
use crate::model::scope::Scope;

/// Remembers it for the group.
pub(super) fn constants_say(
    scope: &mut Scope<'_>,
    group: GroupId,
    outer: [PointId; 2],
    lengths: [&Length; 2],
) {
    let span = scope.facts.between(outer[0], outer[1]).map(|[dx, dy]| dx.hypot(&dy));
    let coincides_with = point_at(scope, outer, lengths);
    if span.is_some() || coincides_with.is_some() {
        scope.mechanism.known.push(Known { group, span, coincides_with });
    }
}

/// The point whose distances from both outer joints are constant and are the group's lengths:
/// kites and inversors have one. One mode of the group gives the machine, the other this point.
fn point_at(scope: &Scope<'_>, outer: [PointId; 2], lengths: [&Length; 2]) -> Option<PointId> {
    let lengths = [lengths[0].value.constant()?, lengths[1].value.constant()?];
    let is_at = |point: PointId| {
        outer.into_iter().zip(lengths).all(|(joint, length)| {
            let between = scope.facts.between(joint, point);
            between.is_some_and(|[dx, dy]| is_as_long(length, &dx, &dy))
        })
    };
    // The group's own pin is the last point there is, and is made.
    let earlier = 0..scope.mechanism.points.len().saturating_sub(1);
    earlier.map(|index| PointId(index as u32)).find(|&point| is_at(point))
}

/// True if the vector has this length. The squares are compared: they are rational where the
/// coordinates are.
fn is_as_long(length: &Exact, dx: &Exact, dy: &Exact) -> bool {
    length.mul(length).cmp_value(&dx.mul(dx).add(&dy.mul(dy))).is_eq()
}
