//! The joints of a drawing in the mechanism of its groups: what slides, what is driven, and the frames of links, each
//! as its statement says, whatever group has it.

use proc_macro2::Ident;

use crate::model::as_drawn::{DrawnDrive, DrawnSlide, FrameShift};
use crate::model::drawn_links::FrameFound;
use crate::model::mechanism::LinkId;
use crate::model::names::Entity;
use crate::model::parts_of_groups::Parts;
use crate::model::scope::Scope;
use crate::model::told_numbers;

/// The frames of links that a group has made, and the slides whose joints it has, once it is made.
pub(in crate::model) fn joints_are_as_drawn(scope: &mut Scope<'_>, parts: &Parts) {
    let Some(drawn) = scope.drawn else { return };
    for found in &drawn.frames {
        let shift = made(scope, parts, &found.link).and_then(|link| shift(scope, link, found));
        scope.mechanism.as_drawn.frames.extend(shift);
    }
    for slide in &drawn.slides {
        let by = made(scope, parts, &slide.by);
        let (Some(by), Some(Entity::Link(link))) = (by, scope.names.made(&slide.link)) else {
            continue;
        };
        let at = slide.link.span();
        let (shift, arm) =
            (slide.shift.length(scope, at), told_numbers::lengths(scope, &slide.arm, at));
        if let (Some(shift), Some(arm)) = (shift, arm) {
            let (guide, carrier) = (slide.guide.clone(), slide.carrier.clone());
            let (is_reversed, is_first) = (slide.is_reversed, slide.is_first);
            let slide = DrawnSlide { link, guide, carrier, by, is_reversed, shift, arm, is_first };
            scope.mechanism.as_drawn.slides.push(slide);
        }
    }
}

/// The link of this name among those that a group has made.
fn made(scope: &Scope<'_>, parts: &Parts, name: &Ident) -> Option<LinkId> {
    let mut links = parts.links.iter().copied().flatten();
    links.find(|link| scope.mechanism.links[link.index()].name == *name)
}

/// The written frame of a link in that of its group.
fn shift(scope: &mut Scope<'_>, link: LinkId, found: &FrameFound) -> Option<FrameShift> {
    let angle = match &found.angle {
        Some(angle) => Some(angle.number(scope)?),
        None => None,
    };
    let [cos, sin] = found.axis.each_ref().map(|part| part.number(scope));
    let origin = told_numbers::lengths(scope, &found.origin, found.link.span())?;
    Some(FrameShift { link, angle, axis: [cos?, sin?], origin, is_reversed: found.is_reversed })
}

/// The drives, once all links are made.
pub(in crate::model) fn links_are_as_drawn(scope: &mut Scope<'_>) {
    let Some(drawn) = scope.drawn else { return };
    let joints = drawn.joints.iter().filter_map(|name| match scope.names.entity(name) {
        Some(Entity::Point(point)) => Some(point),
        _ => None,
    });
    scope.mechanism.as_drawn.joints = joints.collect();
    let link = |name: &Ident, scope: &Scope<'_>| match scope.names.entity(name) {
        Some(Entity::Link(link)) => Some(link),
        _ => None,
    };
    let searched = drawn.searched.iter().filter_map(|name| link(name, scope)).collect();
    scope.mechanism.as_drawn.searched = searched;
    let angles = drawn.angles.iter().filter_map(|(name, angle)| Some((link(name, scope)?, *angle)));
    scope.mechanism.as_drawn.angles = angles.collect();
    for [driven, by] in &drawn.drives {
        if let (Some(driven), Some(by)) = (link(driven, scope), link(by, scope)) {
            scope.mechanism.as_drawn.drives.push(DrawnDrive { link: driven, by });
        }
    }
}
