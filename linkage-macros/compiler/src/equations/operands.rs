//! Placement of each step: this file gathers the operands, the group's file computes.

use crate::equations::groups::formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Frame, PointMotion};
use crate::equations::parts::GroupScope;
use crate::equations::symbol::Vector;
use crate::equations::{guide, point};
use crate::model::mechanism::{
    Carrier, Group, GroupId, GuideDirection, GuideId, Joint, OutputKind, Placement, PointId,
    Scalar, Step, Through,
};

impl<'s> Kinematics<'s> {
    /// The steps in front of this one that have not been taken.
    pub(super) fn take_until(&mut self, end: usize) {
        let mechanism = self.mechanism;
        for step in &mechanism.steps[self.taken..end] {
            self.take(step);
        }
        self.taken = end;
    }

    /// True if an output requests the group's margin or transmission.
    fn wants_measures(&self, group: GroupId) -> bool {
        self.mechanism.outputs.iter().any(|output| {
            matches!(output.kind,
                OutputKind::Margin(asked) | OutputKind::Transmission(asked) if asked == group)
        })
    }

    pub(super) fn scope(&self, group: &'s Group) -> GroupScope<'s> {
        let title = &self.mechanism.groups[group.id.index()].title;
        let numerics = self.mechanism.numerics;
        GroupScope {
            group: group.id.0,
            title,
            links: &group.links,
            numerics,
            builder: self.builder,
        }
    }

    fn take(&mut self, step: &'s Step) {
        self.name_lets();
        match step {
            Step::Ground { point, at } => self.take_ground(*point, at),
            Step::Guide { guide, carrier, through, course } => {
                self.take_guide(*guide, *carrier, through, course);
            }
            Step::Point { point, carrier, place, group } => {
                self.take_point(*point, *carrier, place, *group);
            }
            Step::Group(group) => self.take_group(group),
        }
    }

    fn take_ground(&mut self, id: PointId, at: &[Scalar; 2]) {
        let at = self.jets(at);
        self.coordinates.insert((Carrier::Ground, id), at);
        self.set_point(id, PointMotion::fixed(Vector { x: at[0].value, y: at[1].value }));
    }

    fn take_guide(
        &mut self,
        id: GuideId,
        carrier: Carrier,
        through: &Through,
        course: &GuideDirection,
    ) {
        let frame = self.carrier(carrier);
        let (origin, from) = match through {
            Through::At(at) => {
                let at = self.jets(at);
                (self.spot(frame, carrier, at), at)
            }
            Through::Point(point) => (self.point(*point), self.coordinates[&(carrier, *point)]),
        };
        let guide = match course {
            GuideDirection::Along(turn) => {
                Frame { origin, direction: self.turned(frame.direction, turn) }
            }
            GuideDirection::Towards(to) => {
                guide::towards(frame, origin, from, self.coordinates[&(carrier, *to)])
            }
        };
        self.guides[id.index()] = Some(guide);
    }

    /// A place of the ground is a base to measure from; a place of a link is carried by it.
    fn spot(&self, frame: Frame<'s>, carrier: Carrier, at: [Jet<'s>; 2]) -> PointMotion<'s> {
        if carrier == Carrier::Ground && at.iter().all(|x| x.is_fixed()) {
            PointMotion::fixed(Vector { x: at[0].value, y: at[1].value })
        } else {
            frame.place(at[0], at[1])
        }
    }

    fn take_point(&mut self, id: PointId, carrier: Carrier, place: &Placement, group: GroupId) {
        let at = match place {
            Placement::Cartesian(at) => self.jets(at),
            Placement::Polar(radius, angle) => point::polar(self.jet(radius), self.jet(angle)),
            Placement::Distances { distances, length, side } => point::at_distances(
                group.0,
                [&distances[0], &distances[1]].map(|distance| self.length(distance, group.0)),
                self.jet(length),
                self.sign(*side),
            ),
        };
        self.coordinates.insert((carrier, id), at);
        let motion = match carrier {
            Carrier::Ground => PointMotion::driven(at[0], at[1]),
            Carrier::Link(link) => self.link(link).frame.place(at[0], at[1]),
        };
        self.set_point(id, motion);
    }

    fn take_group(&mut self, group: &'s Group) {
        let formulas = formulas(group.kind);
        let solved = formulas.solve(self, group);
        self.set_group(group, solved);
        if self.wants_measures(group.id) {
            let measures = formulas.measures(self, group);
            self.measures.extend(measures.map(|measures| (group.id, measures)));
        }
    }

    /// The point that the link with this index stands on.
    pub(super) fn stands_on(&self, group: &Group, index: usize) -> PointMotion<'s> {
        self.point(group.stands_on(index))
    }

    pub(super) fn both_joints(&self, group: &Group) -> [PointMotion<'s>; 2] {
        [0, 1].map(|index| self.stands_on(group, index))
    }

    /// The guide that the link with this index slides on.
    pub(super) fn slides_on(&self, group: &Group, index: usize) -> Frame<'s> {
        self.guide(group.slides_on(index))
    }

    pub(super) fn bar_length(&self, group: &Group, index: usize) -> Jet<'s> {
        self.length(group.length(index), group.id.0)
    }

    pub(super) fn lengths(&self, group: &Group) -> [Jet<'s>; 2] {
        [0, 1].map(|index| self.bar_length(group, index))
    }

    /// The offset of what slides, zero where it has none.
    pub(super) fn offset_in(&self, joint: &Joint) -> Jet<'s> {
        joint.offset().map_or_else(|| Jet::zero(self.builder), |offset| self.jet(offset))
    }
}
