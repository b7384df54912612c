//! The joints of a group from its dimensions, and these from the fields of its statement as its row has them.

use crate::exact::Exact;
use crate::syntax::anatomy::JointRule;
use crate::syntax::tree;

use crate::model::mechanism::{
    Assembly, Body, Carrier, Drive, Group, Joint, JointKind, Length, LinkId, PointId, Scalar,
    Slideway,
};
use crate::model::parts_of_groups::{Dimensions, Fields, OuterJoint, Parts};
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::{assembly, fits, modes, numbers, opposite_sides, uses};

impl Parts {
    /// Tells whether the link has its outer joint at one end and the pin at the other.
    pub(super) fn is_bar(&self, index: usize) -> bool {
        !self.slides(index) && !self.anatomy.has_inner_slide()
    }

    /// Tells whether the outer joint of the link is prismatic.
    pub(super) fn slides(&self, index: usize) -> bool {
        matches!(self.anatomy.joints[index], JointRule::Prismatic(_))
    }

    fn has_field(&self, name: &str) -> bool {
        self.anatomy.fields.iter().any(|rule| rule.name == name)
    }

    /// The point at the origin of the link: its outer joint, or the pin where that slides.
    fn origin(&self, index: usize) -> Option<PointId> {
        if self.slides(index) { self.pin } else { self.point(index) }
    }
}

/// The group with its joints, where everything that it is given is known: the rules of all groups, whether fields give
/// the dimensions or a drawing does.
pub(super) fn place_group(
    scope: &mut Scope<'_>,
    parts: &Parts,
    mut dimensions: Dimensions,
) -> Option<Group> {
    points_of_links(scope, parts, &dimensions);
    assembly::constants_can_be_assembled(scope, parts, &dimensions)?;
    let pin = if parts.has_pin() { Some(parts.pin?) } else { None };
    let links: Vec<LinkId> = parts.links.iter().copied().collect::<Option<_>>()?;
    let mut lengths = Vec::new();
    for (index, length) in dimensions.lengths.drain(..).enumerate() {
        let is_bar = parts.is_bar(index) && pin.is_some();
        lengths.push(if is_bar { Some(length?) } else { None });
    }
    let mut offsets = dimensions.offsets.take()?.into_iter();
    let has_slot = parts.has_field("slot");
    let mut outer = Vec::new();
    for (&joint, &link) in parts.outer.iter().zip(&links) {
        // A link that a slot lies in is on its rail, and the slot beside it.
        let mut offset = || if has_slot { None } else { offsets.next() };
        outer.push(outer_joint(scope, joint?, link, &mut offset));
    }
    if let Some(first) = outer.first_mut() {
        first.drive = dimensions.drive(parts)?;
    }
    let inner = match pin {
        Some(pin) if links.len() > 1 => on_pin(&links, pin),
        None if links.len() > 1 => vec![dimensions.between(&links, has_slot, &mut offsets)?],
        _ => Vec::new(),
    };
    let (id, kind, assembly) = (parts.id, parts.anatomy.class?, dimensions.assembly?);
    Some(Group { id, kind, links, outer, inner, pin, lengths, assembly })
}

/// The dimensions that the fields of a statement give.
pub(super) fn dimensions(
    scope: &mut Scope<'_>,
    parts: &Parts,
    group: &tree::GroupStatement,
    fields: &Fields<'_>,
) -> Dimensions {
    let lengths = lengths_of_bars(scope, group, fields);
    let angle = fields.one("angle").and_then(|angle| numbers::turn(scope, angle));
    let relative_to = match fields.one("relative_to") {
        Some(value) => relative_to_is_a_body(scope, value),
        None => fields.is_left_out("relative_to").then_some(Carrier::Ground),
    };
    Dimensions {
        angle: angle.map(|angle| match relative_to {
            Some(body) => scope.mechanism.turned(body, angle),
            None => angle,
        }),
        relative_to,
        slide: fields.one("slide").and_then(|slide| numbers::length(scope, slide)),
        slot: fields.one("slot").and_then(|slot| numbers::turn(scope, slot)),
        slot_at: fields.one("slot").map(|slot| slot.span),
        offsets: offsets(scope, parts, fields),
        assembly: assembled(scope, parts, (group, fields), &lengths),
        lengths,
    }
}

/// The way in which the group is assembled.
fn assembled(
    scope: &mut Scope<'_>,
    parts: &Parts,
    (group, fields): (&tree::GroupStatement, &Fields<'_>),
    lengths: &[Option<Length>],
) -> Option<Assembly> {
    if parts.anatomy.modes.is_none() {
        return Some(Assembly::Unique);
    }
    if let Some(at) = modes::parallel(scope, parts.anatomy, fields) {
        return opposite_sides::declared(scope, parts, lengths, at).map(Assembly::Parallel);
    }
    let mode = modes::mode(scope, group, parts.anatomy, fields)?;
    let drawn = opposite_sides::drawn(scope, parts, lengths, mode);
    Some(drawn.map_or(Assembly::Signed(mode), Assembly::Parallel))
}

/// The field `length` is the first link's, `lengths` are both links'.
fn lengths_of_bars(
    scope: &mut Scope<'_>,
    group: &tree::GroupStatement,
    fields: &Fields<'_>,
) -> Vec<Option<Length>> {
    let legs = group.legs.iter().enumerate();
    let lengths = legs.map(|(index, leg)| {
        let length = match fields.pair("lengths") {
            Some(lengths) => lengths.get(index),
            None => fields.one("length").filter(|_| index == 0),
        };
        length.and_then(|length| bar_length(scope, length, &leg.link.to_string()))
    });
    lengths.collect()
}

/// The length of a bar, positive as far as that is known.
fn bar_length(scope: &mut Scope<'_>, expr: &tree::Expr, link: &str) -> Option<Length> {
    let value = numbers::length(scope, expr)?;
    fits::length_is_positive(scope, expr, &value, &format!("the length of `{link}`"))?;
    let name = match bare_name(expr) {
        Some(name) => name.to_string(),
        None => format!("length of {link}"),
    };
    Some(Length { value, name })
}

/// The field `offset` or `offsets`, zero where it is not given.
fn offsets(scope: &mut Scope<'_>, parts: &Parts, fields: &Fields<'_>) -> Option<Vec<Scalar>> {
    if parts.has_field("offset") {
        return match fields.one("offset") {
            Some(offset) => Some(vec![numbers::length(scope, offset)?]),
            None => fields.is_left_out("offset").then(|| vec![Scalar::zero()]),
        };
    }
    if !parts.has_field("offsets") {
        return Some(Vec::new());
    }
    match fields.pair("offsets") {
        Some(offsets) => numbers::lengths(scope, offsets).map(Vec::from),
        None => fields.is_left_out("offsets").then(|| vec![Scalar::zero(), Scalar::zero()]),
    }
}

/// A crank's angle is relative to the ground or to a link.
fn relative_to_is_a_body(scope: &mut Scope<'_>, value: &tree::Expr) -> Option<Carrier> {
    match bare_name(value) {
        Some(name) if name == "ground" => Some(Carrier::Ground),
        Some(name) => uses::link(scope, name).map(Carrier::Link),
        None => {
            let message = "`relative_to` takes `ground` or the name of a link";
            scope.diagnostics.error(value.span, message);
            None
        }
    }
}

/// The points of the group's links: their origins, the ends of bars, and a pin that stands
/// still.
fn points_of_links(scope: &mut Scope<'_>, parts: &Parts, dimensions: &Dimensions) {
    for (index, length) in dimensions.lengths.iter().enumerate() {
        if parts.is_bar(index) {
            assembly::bar_is_made(scope, parts, index, length.as_ref());
        } else if let (Some(link), Some(origin)) = (parts.link(index), parts.origin(index)) {
            assembly::block_is_made(scope, link, origin);
        }
    }
    let Some(pin) = parts.pin else { return };
    let Dimensions { lengths, angle, relative_to, slide, offsets, .. } = dimensions;
    if let (Some(OuterJoint::Point(pivot)), Some(Carrier::Ground), Some(angle), [Some(length)]) =
        (parts.outer[0], relative_to, angle, &lengths[..])
    {
        assembly::pin_of_a_fixed_crank(scope, pivot, pin, angle, &length.value);
    }
    if let (Some(OuterJoint::Guide(guide)), Some(slide), Some([offset])) =
        (parts.outer[0], slide, offsets.as_deref())
    {
        assembly::pin_of_a_fixed_slider(scope, guide, pin, slide, offset);
    }
}

fn outer_joint(
    scope: &Scope<'_>,
    joint: OuterJoint,
    link: LinkId,
    offset: &mut impl FnMut() -> Option<Scalar>,
) -> Joint {
    // After a mistake a missing body counts as the ground.
    let mechanism = &scope.mechanism;
    let (kind, on) = match joint {
        OuterJoint::Point(point) => {
            (JointKind::Revolute(point), mechanism.owner(point).unwrap_or(Body::Ground))
        }
        OuterJoint::Guide(guide) => {
            let on = mechanism.course(guide).map_or(Carrier::Ground, |(carrier, _)| carrier);
            let along = Slideway::Guide(guide);
            (JointKind::Prismatic { along, offset: offset() }, on.into())
        }
    };
    Joint { kind, bodies: [on, Body::Link(link)], drive: None }
}

/// Both links turn on the pin.
fn on_pin(links: &[LinkId], pin: PointId) -> Vec<Joint> {
    let joint = |&link| Joint {
        kind: JointKind::Revolute(pin),
        bodies: [Body::Pin(pin), Body::Link(link)],
        drive: None,
    };
    links.iter().map(joint).collect()
}

impl Dimensions {
    /// A driver's; none of a dyad.
    fn drive(&mut self, parts: &Parts) -> Option<Option<Drive>> {
        if parts.has_field("angle") {
            let (angle, relative_to) = (self.angle.take()?, self.relative_to?);
            return Some(Some(Drive::Angle { angle, relative_to }));
        }
        if parts.has_field("slide") {
            return Some(Some(Drive::Slide(self.slide.take()?)));
        }
        Some(None)
    }

    /// The first link slides in the second.
    fn between(
        &mut self,
        links: &[LinkId],
        has_slot: bool,
        offsets: &mut impl Iterator<Item = Scalar>,
    ) -> Option<Joint> {
        let along = match has_slot {
            true => {
                let (across, angle) = (offsets.next()?, self.slot.take()?);
                Slideway::Slot { link: links[1], across, angle }
            }
            false => Slideway::Bar(links[1]),
        };
        Some(Joint {
            kind: JointKind::Prismatic { along, offset: Some(offsets.next()?) },
            bodies: [Body::Link(links[1]), Body::Link(links[0])],
            drive: None,
        })
    }

    /// The angle of a slot that lies along its rail.
    pub(super) fn slot_along_the_rail(&self) -> Option<&Exact> {
        self.slot.as_ref()?.constant().filter(|slot| slot.sin().is_zero())
    }
}
