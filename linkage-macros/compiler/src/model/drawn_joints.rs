//! The joints of a drawing in the mechanism of its groups: what slides, what is driven, and the directions of frames, each
//! as its statement says, whatever group has it.

use proc_macro2::Ident;

use crate::model::as_drawn::{DrawnDrive, DrawnSlide};
use crate::model::drawn_links::TurnedFrame;
use crate::model::names::Entity;
use crate::model::numbers;
use crate::model::parts_of_groups::Parts;
use crate::model::scope::Scope;

/// The slides whose joints a group has made, once it is made.
pub(in crate::model) fn joints_are_as_drawn(scope: &mut Scope<'_>, parts: &Parts) {
    let Some(drawn) = scope.drawn else { return };
    for slide in &drawn.slides {
        let made = parts.group.legs.iter().position(|leg| leg.link == slide.by);
        let by = made.and_then(|leg| parts.link(leg));
        let (Some(by), Some(Entity::Link(link))) = (by, scope.names.made(&slide.link)) else {
            continue;
        };
        let (shift, arm) =
            (numbers::length(scope, &slide.shift), numbers::lengths(scope, &slide.arm));
        if let (Some(shift), Some(arm)) = (shift, arm) {
            let (guide, carrier) = (slide.guide.clone(), slide.carrier.clone());
            let (is_reversed, is_first) = (slide.is_reversed, slide.is_first);
            let slide = DrawnSlide { link, guide, carrier, by, is_reversed, shift, arm, is_first };
            scope.mechanism.as_drawn.slides.push(slide);
        }
    }
}

/// The drives and the directions of frames, once all links are made.
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
    for TurnedFrame { link: name, angle, .. } in &drawn.turned {
        let Some(link) = link(name, scope) else { continue };
        if let Some(turn) = numbers::plain_angle(scope, angle) {
            scope.mechanism.as_drawn.turns.push((link, turn));
        }
    }
}
