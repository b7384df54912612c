//! The joints of a group from its dimensions, and these from the fields of its statement as its row has them.

use proc_macro2::Ident;

use crate::exact::Exact;
use crate::syntax::anatomy::JointRule;
use crate::syntax::tree;

use crate::model::figures::Figure;
use crate::model::mechanism::{
    Assembly, Body, Carrier, Dimension, Drive, Group, Joint, JointKind, Length, LinkId, PointId,
    Scalar, Slideway,
};
use crate::model::parts_of_groups::{Dimensions, Fields, GroupNumbers, OuterJoint, Parts};
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::{assembly, fits, modes, opposite_sides, uses};

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
    let number = |value: &tree::Expr, of| Figure::written(value.clone(), Some(of));
    let one = |name: &str, of| fields.one(name).map(|value| number(value, of));
    let lengths = |one_name: &str, pair_name: &str| match fields.pair(pair_name) {
        Some(pair) => pair.iter().map(|length| number(length, Dimension::LENGTH)).collect(),
        None => one(one_name, Dimension::LENGTH).into_iter().collect(),
    };
    let numbers = GroupNumbers {
        lengths: lengths("length", "lengths"),
        angle: one("angle", Dimension::ANGLE),
        slide: one("slide", Dimension::LENGTH),
        slot: one("slot", Dimension::ANGLE),
        offsets: lengths("offset", "offsets"),
        ..GroupNumbers::default()
    };
    let relative_to = match fields.one("relative_to") {
        Some(value) => relative_to_is_a_body(scope, value),
        None => fields.is_left_out("relative_to").then_some(Carrier::Ground),
    };
    let links = group.legs.iter().map(|leg| &leg.link);
    let mut dimensions = resolved(scope, parts, links, (&numbers, relative_to));
    let is_given = |name: &&str| parts.has_field(name) && !fields.is_left_out(name);
    if numbers.offsets.is_empty() && ["offset", "offsets"].iter().any(is_given) {
        dimensions.offsets = None;
    }
    dimensions.assembly = assembled(scope, parts, (group, fields), &dimensions.lengths);
    dimensions
}

/// The dimensions of a group, but for the way in which it is assembled. Offsets that are not given are zero.
pub(super) fn resolved<'n>(
    scope: &mut Scope<'_>,
    parts: &Parts,
    links: impl Iterator<Item = &'n Ident>,
    (numbers, relative_to): (&GroupNumbers, Option<Carrier>),
) -> Dimensions {
    let GroupNumbers { lengths, angle, slide, slot, offsets, .. } = numbers;
    let at = parts.at;
    let lengths = links.enumerate().map(|(index, link)| {
        let length = lengths.get(index)?;
        let (at, value) = (length.at(link.span()), length.length(scope, link.span())?);
        fits::length_is_positive(scope, at, &value, &format!("the length of `{link}`"))?;
        let name = length.name().map_or(format!("length of {link}"), Ident::to_string);
        Some(Length { value, name })
    });
    let lengths = lengths.collect();
    let angle = angle.as_ref().and_then(|angle| angle.turn(scope));
    let angle = angle.map(|angle| match relative_to {
        Some(body) => scope.mechanism.turned(body, angle),
        None => angle,
    });
    let slide = slide.as_ref().and_then(|slide| slide.length(scope, at));
    let slot_at = slot.as_ref().map(|slot| slot.at(at));
    let slot = slot.as_ref().and_then(|slot| slot.turn(scope));
    let count = match parts.has_field("offsets") {
        true => 2,
        false => usize::from(parts.has_field("offset")),
    };
    let offsets = (0..count).map(|index| match offsets.get(index) {
        Some(offset) => offset.length(scope, at),
        None => Some(Scalar::zero()),
    });
    let (offsets, assembly) = (offsets.collect(), None);
    Dimensions { lengths, angle, relative_to, slide, slot, slot_at, offsets, assembly }
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
