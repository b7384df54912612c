//! Owners, carriers and motion, read from steps and joints.

use super::mechanism::{
    AngleSum, Body, Carrier, Drive, Group, GroupId, GuideDirection, GuideId, Joint, LinkId,
    Mechanism, PartOf, Placement, PointId, Scalar, Slideway, Step, UnknownId,
};

impl Mechanism {
    pub fn group_steps(&self) -> impl Iterator<Item = &Group> {
        self.steps.iter().filter_map(|step| match step {
            Step::Group(group) => Some(group),
            Step::Ground { .. } | Step::Guide { .. } | Step::Point { .. } => None,
        })
    }

    /// The place of a point of the ground, as it was declared.
    pub(crate) fn ground_place(&self, point: PointId) -> Option<&[Scalar; 2]> {
        self.steps.iter().find_map(|step| match step {
            Step::Ground { point: made, at } if *made == point => Some(at),
            _ => None,
        })
    }

    /// The group that makes the link; none where its step is missing.
    pub(crate) fn group_with(&self, link: LinkId) -> Option<&Group> {
        self.group_steps().find(|group| group.links.contains(&link))
    }

    /// True if the bars of the group stay opposite sides of a parallelogram.
    pub(crate) fn is_parallel(&self, id: GroupId) -> bool {
        let mut groups = self.group_steps().filter(|group| group.id == id);
        groups.any(|group| group.opposite().is_some())
    }

    /// The joints of all groups.
    pub fn joints(&self) -> impl Iterator<Item = &Joint> {
        self.group_steps().flat_map(Group::joints)
    }

    /// The group that makes the pin or the driven point.
    pub(crate) fn group_of(&self, point: PointId) -> u32 {
        match self.points[point.index()].part_of {
            PartOf::Pin(group) | PartOf::Driven(group) => group.0,
            PartOf::Link(link) => self.links[link.index()].made_by.0,
            PartOf::Ground => 0,
        }
    }

    /// The body that the point belongs to; none where the step that makes it is missing.
    pub fn owner(&self, point: PointId) -> Option<Body> {
        self.steps.iter().find_map(|step| match step {
            Step::Ground { point: made, .. } if *made == point => Some(Body::Ground),
            Step::Point { point: made, carrier, .. } if *made == point => Some(match carrier {
                Carrier::Ground => Body::Pin(point),
                Carrier::Link(link) => Body::Link(*link),
            }),
            Step::Group(group) if group.pin == Some(point) => Some(match group.links[..] {
                [link] => Body::Link(link),
                _ => Body::Pin(point),
            }),
            _ => None,
        })
    }

    /// The carrier of the guide, and its direction there.
    pub(crate) fn course(&self, guide: GuideId) -> Option<(Carrier, &GuideDirection)> {
        self.steps.iter().find_map(|step| match step {
            Step::Guide { guide: made, carrier, course, .. } if *made == guide => {
                Some((*carrier, course))
            }
            _ => None,
        })
    }

    /// The points that links stand on, and the links: every revolute outer joint.
    pub fn standing(&self) -> Vec<(PointId, LinkId)> {
        let outer = self.group_steps().flat_map(|group| &group.outer);
        outer.filter_map(|joint| Some((joint.point()?, joint.link()))).collect()
    }

    /// The carrier of a link's angle, and the turn against it; none where the joints leave the link
    /// an angle of its own.
    pub fn carried_angle(&self, link: LinkId) -> Option<(Carrier, Option<&AngleSum>)> {
        let mut joints = self.joints().filter(|joint| joint.link() == link);
        joints.find_map(|joint| match (&joint.drive, joint.slideway()) {
            (Some(Drive::Angle { angle, relative_to }), _) => Some((*relative_to, Some(angle))),
            (_, Some(Slideway::Guide(guide))) => match self.course(*guide)? {
                (carrier, GuideDirection::Along(turn)) => Some((carrier, Some(turn))),
                (_, GuideDirection::Towards(_)) => None,
            },
            (_, Some(Slideway::Bar(bar))) => Some((Carrier::Link(*bar), None)),
            (_, Some(Slideway::Slot { link, angle, .. })) => {
                Some((Carrier::Link(*link), Some(angle)))
            }
            (_, None) => None,
        })
    }

    /// True if the group stands in front of the equation of an unknown, which may depend on it.
    pub(crate) fn is_tried(&self, group: GroupId, unknown: UnknownId) -> bool {
        let steps = &self.steps[..self.unknowns[unknown.index()].steps[1]];
        steps.iter().any(|step| matches!(step, Step::Group(made) if made.id == group))
    }

    /// True if a crank's angle turns the link.
    pub(crate) fn is_crank(&self, link: LinkId) -> bool {
        let mut joints = self.joints().filter(|joint| joint.link() == link);
        joints.any(|joint| matches!(joint.drive, Some(Drive::Angle { .. })))
    }

    /// Tells whether a point's coordinates in the frame of its carrier change with an input.
    pub fn coordinates_move(&self, carrier: Carrier, point: PointId) -> [bool; 2] {
        let moves = |values: &[&Scalar]| values.iter().any(|value| self.moves(value));
        let found = self.steps.iter().find_map(|step| match step {
            Step::Point { point: made, carrier: own, place, .. }
                if *made == point && *own == carrier =>
            {
                Some(match place {
                    Placement::Cartesian([x, y]) => [self.moves(x), self.moves(y)],
                    Placement::Polar(radius, angle) => [moves(&[radius, angle]); 2],
                    Placement::Distances { distances: [first, second], length, .. } => {
                        [moves(&[&first.value, &second.value, length]); 2]
                    }
                })
            }
            Step::Group(group) if group.pin == Some(point) => {
                let mut bars = group.links.iter().zip(&group.lengths);
                let (_, length) = bars.find(|(link, _)| carrier == Carrier::Link(**link))?;
                length.as_ref().map(|length| [self.moves(&length.value), false])
            }
            _ => None,
        });
        found.unwrap_or([false; 2])
    }

    /// Tells whether the expression changes with an input.
    pub fn moves(&self, expr: &Scalar) -> bool {
        expr.any_leaf(&|leaf| match leaf {
            Scalar::Param(_) | Scalar::Load(_) | Scalar::Pull => false,
            Scalar::Let(id) => self.turns(&self.lets[id.index()]),
            _ => true,
        })
    }

    /// Tells whether the angle changes with an input.
    pub(crate) fn turns(&self, angle: &AngleSum) -> bool {
        !angle.links.is_empty() || self.moves(&angle.rest)
    }
}
