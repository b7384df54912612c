//! The efforts of a link: its drive, its push, and the reactions at its joints.

use proc_macro2::Ident;
use quote::format_ident;

use super::acting::Effort;
use super::mechanism::{Body, Group, JointKind, LinkId, Mechanism, PointId, Slideway};

/// The efforts of a link: each field with its effort.
pub(super) type Efforts = Vec<(Ident, Effort)>;

/// The efforts of a link but for that of an unknown or a load that drives it, which is none.
pub(super) fn exerted(
    mechanism: &Mechanism,
    link: LinkId,
) -> impl Iterator<Item = (Ident, Effort)> {
    efforts_of(mechanism, link).into_iter().filter(|(_, effort)| match effort {
        Effort::Drive(link) => {
            !mechanism.is_driven_by_an_unknown(*link) && mechanism.driven_through(*link).is_none()
        }
        _ => true,
    })
}

/// Drive, push, joints and guides of a link.
pub(super) fn efforts_of(mechanism: &Mechanism, link: LinkId) -> Efforts {
    let group = mechanism.group_with(link);
    let mut efforts = group.map_or(Vec::new(), |group| of_group(mechanism, group, link));
    // Points of its own that others stand on.
    let mut own: Vec<PointId> = Vec::new();
    for (point, _) in mechanism.standing() {
        let is_own = mechanism.owner(point) == Some(Body::Link(link));
        if is_own && !own.contains(&point) {
            own.push(point);
        }
    }
    let bearing = |point: PointId| (point_name(mechanism, point), Effort::Bearing(link, point));
    efforts.extend(own.into_iter().map(bearing));
    efforts
}

/// The drive of a link of a group, and the reactions of its joints.
fn of_group(mechanism: &Mechanism, group: &Group, link: LinkId) -> Efforts {
    let Mechanism { links, guides, .. } = mechanism;
    let (mut efforts, mut by_slideways) = (Vec::new(), Vec::new());
    let own = || group.joints().filter(|joint| joint.link() == link);
    if own().any(|joint| joint.drive.is_some()) {
        efforts.push((format_ident!("drive"), Effort::Drive(link)));
    }
    let mut bars = group.links.iter().zip(&group.lengths);
    let length = bars.find_map(|(own, length)| length.as_ref().filter(|_| *own == link));
    if length.is_some_and(|length| mechanism.moves(&length.value)) {
        efforts.push((format_ident!("push"), Effort::Push(link)));
    }
    for joint in own() {
        match &joint.kind {
            JointKind::Revolute(point) => {
                efforts.push((point_name(mechanism, *point), Effort::Pin(link, *point)));
            }
            JointKind::Prismatic { along, .. } => {
                let by = match along {
                    Slideway::Guide(guide) => &guides[guide.index()].name,
                    Slideway::Bar(by) | Slideway::Slot { link: by, .. } => &links[by.index()].name,
                };
                by_slideways.push((by.clone(), Effort::Guide(link)));
            }
        }
    }
    efforts.extend(by_slideways);
    efforts
}

fn point_name(mechanism: &Mechanism, point: PointId) -> Ident {
    mechanism.points[point.index()].name.clone()
}
