//! Joints that are welded: the links through one are one link.

use super::records::{Joint, Member, Records};
use crate::import::drawing::Drawing;

/// Makes one link of the links at each welded joint: a block takes the name of its rod. Parts of one compound link are
/// welded to one another, and to nothing else that goes through their joint: a piston is pinned there. A prismatic joint
/// without a piston is welded to its link.
pub(super) fn weld(drawing: &mut Drawing, records: &Records<'_>) {
    let is_one = |joint: &&Joint<'_>| match joint.is_prismatic {
        true => records.is_slider(joint),
        false => !is_within_a_link(records, joint.id),
    };
    for joint in records.joints.iter().filter(|joint| joint.is_welded).filter(is_one) {
        let all: Vec<String> = drawing.at(joint.id).map(|link| link.id.clone()).collect();
        let is_rod = |id: &&String| {
            let mut members = records.members.iter();
            members.any(|member| member.id == **id && !member.is_piston)
        };
        let Some(first) = all.iter().find(is_rod).or(all.first()) else { continue };
        for other in all.iter().filter(|other| *other != first) {
            drawing.merge(first, other);
            let remark =
                format!("`{other}` is welded to `{first}` at `{}`: both are `{first}`", joint.id);
            drawing.remarks.push(remark);
        }
    }
}

/// True if several parts of one link meet at the joint.
fn is_within_a_link(records: &Records<'_>, joint: &str) -> bool {
    let is_through = |member: &Member<'_>| member.joints.contains(&joint);
    records.members.iter().filter(|member| is_through(member)).any(|member| {
        let parts = member.parts.iter().filter(|part| {
            let part = records.parts.iter().find(|own| own.id == **part);
            part.is_none_or(is_through)
        });
        parts.count() > 1
    })
}
