//! Where things lie that are constant, and the rule that a group of constants can be assembled.
//!
//! Everything here is exact: a group that just reaches is not refused.

use crate::exact::Exact;
use crate::reach::absolute;

use crate::model::coincidence;
use crate::model::folding::{shown, shown_in_degrees};
use crate::model::mechanism::{
    AngleSum, Carrier, GuideId, Length, LinkId, Mechanism, PointId, Scalar,
};
use crate::model::parts_of_groups::{Dimensions, Parts};
use crate::model::scope::Scope;

impl AngleSum {
    /// The angle, where it is known when the mechanism is declared.
    pub(crate) fn constant(&self) -> Option<&Exact> {
        self.links.is_empty().then(|| self.rest.constant()).flatten()
    }
}

/// Both values, where both are constant.
pub(super) fn constants([x, y]: &[Scalar; 2]) -> Option<[Exact; 2]> {
    Some([x.constant()?.clone(), y.constant()?.clone()])
}

/// A length and an angle as coordinates, where both are constant.
pub(super) fn polar(radius: &Scalar, angle: &Scalar) -> Option<[Exact; 2]> {
    let (radius, angle) = (radius.constant()?, angle.constant()?);
    Some([radius.mul(&angle.cos()), radius.mul(&angle.sin())])
}

/// A bar, the group's first or second link, has its outer joint at its origin and its pin on
/// its x axis.
pub(super) fn bar_is_made(scope: &mut Scope<'_>, parts: &Parts, i: usize, length: Option<&Length>) {
    let Some(link) = parts.link(i) else {
        return;
    };
    let zero = || Exact::integer(0);
    let carrier = Carrier::Link(link);
    if let Some(joint) = parts.point(i) {
        scope.facts.fix(joint, carrier, Some([zero(), zero()]));
    }
    if let Some(pin) = parts.pin {
        let length = length.and_then(|length| length.value.constant());
        scope.facts.fix(pin, carrier, length.map(|length| [length.clone(), zero()]));
    }
    let facts = &mut scope.facts.links[link.index()];
    facts.is_bar = parts.has_pin();
    facts.length = length.map(|length| length.value.clone());
}

/// A link with one point, its joint or its pin, has it at its origin.
pub(super) fn block_is_made(scope: &mut Scope<'_>, link: LinkId, point: PointId) {
    let origin = [Exact::integer(0), Exact::integer(0)];
    scope.facts.fix(point, Carrier::Link(link), Some(origin));
}

/// The pin of a crank that stands still in the ground lies at a constant place.
pub(super) fn pin_of_a_fixed_crank(
    scope: &mut Scope<'_>,
    pivot: PointId,
    pin: PointId,
    angle: &AngleSum,
    length: &Scalar,
) {
    let place = scope.facts.place(pivot, Carrier::Ground).zip(angle.constant());
    if let (Some(([x, y], angle)), Some(length)) = (place, length.constant()) {
        let at = [x.add(&length.mul(&angle.cos())), y.add(&length.mul(&angle.sin()))];
        scope.facts.stands_still(pin, Carrier::Ground, at);
    }
}

/// The pin of a slider that stands still lies at a constant place of its guide's carrier.
pub(super) fn pin_of_a_fixed_slider(
    scope: &mut Scope<'_>,
    guide: GuideId,
    pin: PointId,
    slide: &Scalar,
    offset: &Scalar,
) {
    let guide = &scope.facts.guides[guide.index()];
    if let (Some(line), Some(slide), Some(offset)) =
        (&guide.line, slide.constant(), offset.constant())
    {
        let (carrier, at) = (guide.carrier, line.at(slide, offset));
        scope.facts.stands_still(pin, carrier, at);
    }
}

fn group_cannot_be_assembled(scope: &mut Scope<'_>, parts: &Parts, reason: String) -> Option<()> {
    let title = &scope.mechanism.groups[parts.id.index()].title;
    let message = format!("`{title}` cannot be assembled; change its dimensions");
    scope.diagnostics.error_because(parts.at, message, reason);
    None
}

/// The names of two points as a distance: |BD|.
pub(super) fn span_of(mechanism: &Mechanism, ends: [PointId; 2]) -> String {
    let [from, to] = ends.map(|point| &mechanism.points[point.index()].name);
    format!("|{from}{to}|")
}

/// A dyad of constants can be assembled. The rule follows from the outer joints and the pin: a bar
/// keeps the pin on a circle, a guide keeps it on a line.
pub(super) fn constants_can_be_assembled(
    scope: &mut Scope<'_>,
    parts: &Parts,
    dimensions: &Dimensions,
) -> Option<()> {
    let Dimensions { lengths, offsets, slot, .. } = dimensions;
    let [first, second] = &lengths[..] else { return Some(()) };
    match ([0, 1].map(|index| parts.slides(index)), parts.has_pin()) {
        ([false, false], true) => {
            let outer = [parts.point(0)?, parts.point(1)?];
            let lengths = [first.as_ref()?, second.as_ref()?];
            bars_meet(scope, parts, outer, lengths)?;
            coincidence::constants_say(scope, parts.id, outer, lengths);
            Some(())
        }
        ([false, true], true) => {
            let (outer, guide) = (parts.point(0)?, parts.guide(1)?);
            bar_reaches_the_guide(
                scope,
                parts,
                (outer, guide),
                first.as_ref()?,
                offsets.as_ref()?.first()?,
            )
        }
        ([true, true], true) => guides_cross(scope, parts, [parts.guide(0)?, parts.guide(1)?]),
        ([false, false], false) => {
            let outer = [parts.point(0)?, parts.point(1)?];
            offset_is_within_reach(scope, parts, outer, offsets.as_ref()?.first()?)
        }
        ([false, true], false) => {
            slot.as_ref()?;
            slot_crosses_the_rail(scope, dimensions)
        }
        _ => Some(()),
    }
}

/// A slot along the rail fixes nothing across it.
fn slot_crosses_the_rail(scope: &mut Scope<'_>, dimensions: &Dimensions) -> Option<()> {
    let Some(angle) = dimensions.slot_along_the_rail() else { return Some(()) };
    let message =
        format!("a slot at {}° lies along the rail; turn it away", shown_in_degrees(angle));
    let reason = "slot and rail must cross for the group to be determined";
    scope.diagnostics.error_because(dimensions.slot_at?, message, reason);
    None
}

/// The bars of an rrr of constants reach each other.
fn bars_meet(
    scope: &mut Scope<'_>,
    parts: &Parts,
    outer: [PointId; 2],
    lengths: [&Length; 2],
) -> Option<()> {
    let Some([dx, dy]) = scope.facts.between(outer[0], outer[1]) else {
        return Some(());
    };
    let (Some(a), Some(b)) = (lengths[0].value.constant(), lengths[1].value.constant()) else {
        return Some(());
    };
    let distance = dx.hypot(&dy);
    let (sum, difference) = (a.add(b), absolute(&a.sub(b)));
    let name = span_of(&scope.mechanism, outer);
    let (a, b, d) = (shown(a), shown(b), shown(&distance));
    if distance.is_zero() {
        let reason =
            format!("{name} = 0 m: between two links on one place the pin is undetermined");
        return group_cannot_be_assembled(scope, parts, reason);
    }
    if distance.cmp_value(&sum).is_gt() {
        let sum = shown(&sum);
        let reason = format!("{name} = {d} m, lengths {a} m + {b} m reach {sum} m");
        return group_cannot_be_assembled(scope, parts, reason);
    }
    if distance.cmp_value(&difference).is_lt() {
        let difference = shown(&difference);
        let reason = format!("{name} = {d} m, lengths {a} m and {b} m stay {difference} m apart");
        return group_cannot_be_assembled(scope, parts, reason);
    }
    Some(())
}

/// The bar of an rrp of constants reaches the line its pin slides on.
fn bar_reaches_the_guide(
    scope: &mut Scope<'_>,
    parts: &Parts,
    (outer, guide): (PointId, GuideId),
    length: &Length,
    offset: &Scalar,
) -> Option<()> {
    let Some((line, place)) = scope.facts.line_and_place(guide, outer) else {
        return Some(());
    };
    let (Some(length), Some(offset)) = (length.value.constant(), offset.constant()) else {
        return Some(());
    };
    let distance = absolute(&line.distance(place).sub(offset));
    if distance.cmp_value(length).is_le() {
        return Some(());
    }
    let reason = format!(
        "`{}` is {} m from the line its pin slides on, length {} m",
        scope.mechanism.points[outer.index()].name,
        shown(&distance),
        shown(length)
    );
    group_cannot_be_assembled(scope, parts, reason)
}

/// The joints of an rpr of constants are at least its offset apart.
fn offset_is_within_reach(
    scope: &mut Scope<'_>,
    parts: &Parts,
    outer: [PointId; 2],
    offset: &Scalar,
) -> Option<()> {
    let Some([dx, dy]) = scope.facts.between(outer[0], outer[1]) else {
        return Some(());
    };
    let distance = dx.hypot(&dy);
    let name = span_of(&scope.mechanism, outer);
    if distance.is_zero() {
        let reason = format!("{name} = 0 m: the bar has no direction");
        return group_cannot_be_assembled(scope, parts, reason);
    }
    match offset.constant() {
        Some(offset) if distance.cmp_value(&absolute(offset)).is_lt() => {
            let (d, e) = (shown(&distance), shown(offset));
            let reason = format!("{name} = {d} m, less than the offset of {e} m");
            group_cannot_be_assembled(scope, parts, reason)
        }
        _ => Some(()),
    }
}

/// The guides of a prp of constants are not parallel.
fn guides_cross(scope: &mut Scope<'_>, parts: &Parts, guides: [GuideId; 2]) -> Option<()> {
    let [first, second] = guides.map(|guide| &scope.facts.guides[guide.index()]);
    let (Some(a), Some(b)) = (&first.angle, &second.angle) else {
        return Some(());
    };
    if first.carrier != second.carrier || !a.sub(b).sin().is_zero() {
        return Some(());
    }
    let [first, second] = guides.map(|guide| &scope.mechanism.guides[guide.index()].name);
    let reason = format!("`{first}` and `{second}` are parallel and never cross");
    group_cannot_be_assembled(scope, parts, reason)
}
