//! Links that a load drives through an input, so that they have no effort of their own.

use crate::model::acting::Load;
use crate::model::mechanism::{
    Drive, Group, GuideDirection, InputId, LinkId, Mechanism, Placement, Scalar, Slideway, Step,
    Through,
};

/// The input and the load that leave a crank or a slider without an effort of its own: no other dimension moves
/// with the input.
pub(in crate::model) fn driven_through(
    mechanism: &Mechanism,
    link: LinkId,
) -> Option<(InputId, &Load)> {
    let (input, load) = mechanism.dynamics.driven()?;
    let is_input = |expr: &Scalar| matches!(expr, Scalar::Input(id) if *id == input);
    let drive = mechanism.group_with(link)?.outer.first()?.drive.as_ref()?;
    let is_alone = match drive {
        Drive::Angle { angle, .. } => angle.links.is_empty() && is_input(&angle.rest),
        Drive::Slide(slide) => is_input(slide),
    };
    let count =
        dimensions(mechanism).into_iter().filter(|expr| holds(mechanism, expr, input)).count();
    (is_alone && count == 1).then_some((input, load))
}

/// All dimensions by which something is placed.
fn dimensions(mechanism: &Mechanism) -> Vec<&Scalar> {
    let mut all = Vec::new();
    for step in &mechanism.steps {
        match step {
            // No input moves the ground.
            Step::Ground { .. } => {}
            Step::Guide { through, course, .. } => {
                if let Through::At(at) = through {
                    all.extend(at);
                }
                if let GuideDirection::Along(angle) = course {
                    all.push(&angle.rest);
                }
            }
            Step::Point { place, .. } => match place {
                Placement::Cartesian(at) => all.extend(at),
                Placement::Polar(radius, angle) => all.extend([radius, angle]),
                Placement::Distances { distances: [first, second], length, .. } => {
                    all.extend([&first.value, &second.value, length]);
                }
            },
            Step::Group(group) => all.extend(group.dimensions()),
        }
    }
    all
}

/// True if the input is written in the expression, or in a name that stands in it.
fn holds(mechanism: &Mechanism, expr: &Scalar, input: InputId) -> bool {
    expr.any_leaf(&|leaf| match leaf {
        Scalar::Input(id) => *id == input,
        Scalar::Let(id) => holds(mechanism, &mechanism.lets[id.index()].rest, input),
        _ => false,
    })
}

impl Group {
    fn dimensions(&self) -> Vec<&Scalar> {
        let lengths = self.lengths.iter().flatten().map(|length| &length.value);
        let drives = self.outer.iter().filter_map(|joint| match joint.drive.as_ref()? {
            Drive::Angle { angle, .. } => Some(&angle.rest),
            Drive::Slide(slide) => Some(slide),
        });
        let slots = self.joints().filter_map(|joint| match joint.slideway()? {
            Slideway::Slot { angle, .. } => Some(&angle.rest),
            Slideway::Guide(_) | Slideway::Bar(_) => None,
        });
        lengths.chain(drives).chain(slots).chain(self.offsets()).collect()
    }
}
