//! Joints that are welded: the links through one are one link.

use super::super::drawing::Drawing;
use super::records::{Joint, Member, Records};

/// Makes one link of the links at each welded joint: a block takes the name of its rod. A prismatic joint without a piston is
/// welded to its link. Where parts of one compound link meet, earlier versions meant these alone: a piston is pinned there.
pub(super) fn weld(drawing: &mut Drawing, records: &Records<'_>) {
    let is_one = |joint: &&Joint<'_>| !joint.is_prismatic || records.is_slider(joint);
    for joint in records.joints.iter().filter(|joint| joint.is_welded).filter(is_one) {
        let is_rod = |id: &String| {
            let mut members = records.members.iter();
            members.any(|member| member.id == *id && !member.is_piston)
        };
        let has_pinned_block =
            !joint.is_prismatic && !records.welds_blocks && is_within_a_link(records, joint.id);
        let all = drawing.at(joint.id).map(|link| link.id.clone());
        let (all, pinned): (Vec<_>, Vec<_>) = all.partition(|id| !has_pinned_block || is_rod(id));
        let Some(first) = all.iter().find(|id| is_rod(id)).or(all.first()) else { continue };
        for other in all.iter().filter(|other| *other != first) {
            drawing.merge(first, other);
            let remark =
                format!("`{other}` is welded to `{first}` at `{}`: both are `{first}`", joint.id);
            drawing.remarks.push(remark);
        }
        let remark = |block| {
            format!(
                "`{block}` stays pinned to `{first}` at `{}`, where parts of `{first}` are welded",
                joint.id
            )
        };
        drawing.remarks.extend(pinned.iter().map(remark));
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
