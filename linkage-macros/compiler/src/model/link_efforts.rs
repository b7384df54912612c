//! The efforts of a link: its drive, its push, and the reactions at its joints.

use proc_macro2::Ident;
use quote::format_ident;

use crate::model::acting::Effort;
use crate::model::drawn_sliding;
use crate::model::driven_through::driven_through;
use crate::model::mechanism::{
    Body, Group, JointKind, LinkId, Mechanism, PointId, Slideway, StandsFor,
};
use crate::model::scope::Scope;

/// Parts of a link that are outputs.
pub(in crate::model) const MEMBERS: [&str; 4] = ["angle", "slide", "margin", "transmission"];

/// The efforts of a link: each field with its effort.
pub(super) type Efforts = Vec<(Ident, Effort)>;

/// The efforts of a link but for that of an unknown or a load that drives it, which is none.
pub(super) fn exerted<'s>(
    scope: &'s Scope<'_>,
    link: LinkId,
) -> impl Iterator<Item = (Ident, Effort)> + 's {
    efforts_of(scope, link).into_iter().filter(|(_, effort)| match effort {
        Effort::Drive(link) => {
            !scope.mechanism.is_driven_by_an_unknown(*link)
                && driven_through(&scope.mechanism, *link).is_none()
        }
        _ => true,
    })
}

/// Drive, push, joints and guides of a link; none of a block that stands for one at a joint, whose force is that of the link.
pub(super) fn efforts_of(scope: &Scope<'_>, link: LinkId) -> Efforts {
    let mechanism = &scope.mechanism;
    let of_group = |link: LinkId| {
        let group = mechanism.group_with(link);
        group.map_or(Vec::new(), |group| of_group(scope, group, link))
    };
    let own = &mechanism.links[link.index()];
    let stands_for = |other: LinkId| &mechanism.links[other.index()].stands_for;
    let is_end = |of: LinkId| matches!(stands_for(of), StandsFor::EndOf(link) if *link == own.name);
    if let StandsFor::EndOf(_) = own.stands_for {
        return Vec::new();
    }
    let ends = mechanism.link_ids().filter(|&other| is_end(other)).flat_map(of_group);
    let mut efforts: Efforts = ends.filter(|(_, of)| matches!(of, Effort::Pin(..))).collect();
    efforts.extend(of_group(link));
    // Points of its own that others stand on.
    let mut own: Vec<PointId> = Vec::new();
    for (point, _) in scope.mechanism.standing() {
        let is_own = scope.mechanism.owner(point) == Some(Body::Link(link));
        if is_own && !own.contains(&point) {
            own.push(point);
        }
    }
    let bearing = |point: PointId| (point_name(scope, point), Effort::Bearing(link, point));
    efforts.extend(own.into_iter().map(bearing));
    efforts
}

/// The drive of a link of a group, and the reactions of its joints.
fn of_group(scope: &Scope<'_>, group: &Group, link: LinkId) -> Efforts {
    let Mechanism { links, guides, .. } = &scope.mechanism;
    let (mut efforts, mut by_slideways) = (Vec::new(), Vec::new());
    let name = &links[link.index()].name;
    let own = || group.joints().filter(|joint| joint.link() == link);
    let is_driven = own().any(|joint| joint.drive.is_some());
    let is_as_drawn = scope.mechanism.driven_as_drawn(link) == link;
    let own_drive = (is_driven && is_as_drawn).then_some(link);
    if let Some(by) = own_drive.or(scope.mechanism.driven_by_another(link)) {
        efforts.push((format_ident!("drive"), Effort::Drive(by)));
    }
    let mut bars = group.links.iter().zip(&group.lengths);
    let length = bars.find_map(|(own, length)| length.as_ref().filter(|_| *own == link));
    if length.is_some_and(|length| scope.mechanism.moves(&length.value)) {
        efforts.push((format_ident!("push"), Effort::Push(link)));
    }
    for joint in own() {
        match &joint.kind {
            JointKind::Revolute(point) => {
                efforts.push((point_name(scope, *point), Effort::Pin(link, *point)));
            }
            // A slide of a drawing is named by its guide.
            JointKind::Prismatic { .. } if drawn_sliding::is_drawn(scope, name) => {}
            JointKind::Prismatic { along, .. } => {
                let by = match along {
                    Slideway::Guide(guide) => &guides[guide.index()].name,
                    Slideway::Bar(by) | Slideway::Slot { link: by, .. } => &links[by.index()].name,
                };
                by_slideways.push((by.clone(), Effort::Guide(link)));
            }
        }
    }
    let drawn = scope.mechanism.slides_of(link);
    efforts.extend(by_slideways);
    efforts.extend(drawn.map(|slide| (slide.guide.clone(), Effort::Guide(slide.by))));
    efforts
}

fn point_name(scope: &Scope<'_>, point: PointId) -> Ident {
    scope.mechanism.points[point.index()].name.clone()
}
