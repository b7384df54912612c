//! The names and numbers that a group's statement gives, in its order. Nothing here says what a joint
//! connects, where a point belongs or what moves: the oracle has its own opinion of that.

use crate::model::mechanism::{
    AngleSum, Drive, Group, GuideId, JointKind, LinkId, PointId, Scalar, Slideway,
};

pub(super) struct Declared<'k> {
    pub links: &'k [LinkId],
    /// Points and guides in parentheses.
    pub points: Vec<PointId>,
    pub guides: Vec<GuideId>,
    pub pin: Option<PointId>,
    pub lengths: Vec<&'k Scalar>,
    pub offsets: Vec<&'k Scalar>,
    pub slot: Option<&'k AngleSum>,
    pub drive: Option<&'k Drive>,
}

impl<'k> Declared<'k> {
    pub(super) fn of(group: &'k Group) -> Self {
        let lengths = group.lengths.iter().flatten().map(|length| &length.value);
        let mut declared = Self {
            links: &group.links,
            points: Vec::new(),
            guides: Vec::new(),
            pin: group.pin,
            lengths: lengths.collect(),
            offsets: Vec::new(),
            slot: None,
            drive: group.outer[0].drive.as_ref(),
        };
        for joint in &group.outer {
            match &joint.kind {
                JointKind::Revolute(point) => declared.points.push(*point),
                JointKind::Prismatic { along, offset } => {
                    declared.offsets.extend(offset);
                    if let Slideway::Guide(guide) = along {
                        declared.guides.push(*guide);
                    }
                }
            }
        }
        for joint in &group.inner {
            if let JointKind::Prismatic { along, offset } = &joint.kind {
                if let Slideway::Slot { across, angle, .. } = along {
                    declared.offsets.push(across);
                    declared.slot = Some(angle);
                }
                declared.offsets.extend(offset);
            }
        }
        declared
    }
}
