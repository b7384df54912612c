//! How each step places what it declares: operands are gathered, the group's file computes.

use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::levers::Levers;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::GroupScope;
use crate::equations::symbol::Vector;
use crate::equations::{crank, guide, point, prp, rpp, rpr, rrp, rrr, slider};
use crate::model::mechanism::{
    Carrier, Expr, Group, GroupId, GuideDirection, GuideId, LinkId, OutputKind, Placement, PointId,
    Step, Through,
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

    /// Whether an output asks how far the group is from its limit.
    fn wants_quality(&self, group: GroupId) -> bool {
        self.mechanism.outputs.iter().any(|output| {
            matches!(output.kind,
                OutputKind::Margin(asked) | OutputKind::Transmission(asked) if asked == group)
        })
    }

    fn scope(&self, group: GroupId) -> GroupScope<'s> {
        let Group { title, links, .. } = &self.mechanism.groups[group.index()];
        let numerics = self.mechanism.numerics;
        GroupScope { group: group.0, title, links, numerics, sheet: self.sheet }
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
            Step::Crank { .. } | Step::Slider { .. } => self.take_driver(step),
            Step::Rrr { .. } => self.take_rrr(step),
            Step::Rrp { .. } => self.take_rrp(step),
            Step::Rpr { .. } => self.take_rpr(step),
            Step::Prp { .. } => self.take_prp(step),
            Step::Rpp { .. } => self.take_rpp(step),
        }
    }

    fn take_ground(&mut self, id: PointId, at: &[Expr; 2]) {
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

    fn take_driver(&mut self, step: &'s Step) {
        match step {
            Step::Crank { group, link, pivot, pin, angle, relative_to } => {
                let direction = self.turned(self.carrier(*relative_to).direction, angle);
                let length = pin.as_ref().map(|(_, length)| self.length(length, group.0));
                let solved =
                    crank::crank(&self.scope(*group), self.point(*pivot), direction, length);
                self.set_group(*group, &solved);
                self.set_origin(*link, *pivot);
                if let (Some((pin, _)), Some(length)) = (pin, length) {
                    self.set_joint(*link, *pin, length);
                    let vector = solved.links[0].frame.vector(length.value, self.sheet.zero());
                    self.bars.insert(*link, (vector, length, *pin));
                }
            }
            Step::Slider { group, link, guide, pin, slide, offset } => {
                let (slide, offset) = (self.jet(slide), self.jet(offset));
                let solved = slider::slider(&self.scope(*group), self.guide(*guide), slide, offset);
                self.set_group(*group, &solved);
                if let Some(pin) = pin {
                    self.set_origin(*link, *pin);
                }
            }
            _ => unreachable!("only drivers come here"),
        }
    }

    /// The outer joints of an rrr, seen from the link on which both of them stand, or from the ground.
    pub(super) fn outer_joints(&self, outer: [PointId; 2]) -> rrr::Outer<'s> {
        let joints = outer.map(|joint| self.point(joint));
        let place = |link, joint| self.coordinates.get(&(Carrier::Link(link), joint)).copied();
        let common = (0..self.links.len()).find_map(|link| {
            let link = LinkId(link as u32);
            Some((link, [place(link, outer[0])?, place(link, outer[1])?]))
        });
        match common {
            Some((link, places)) => {
                let frame = self.link(link).frame;
                let seen = places.map(|[x, y]| PointMotion::placed(x, y));
                rrr::Outer { joints, frame, seen }
            }
            None => rrr::Outer { joints, frame: Frame::ground(self.sheet), seen: joints },
        }
    }

    fn take_rrr(&mut self, step: &'s Step) {
        let Step::Rrr { group, links, outer, pin, lengths, mode } = step else { return };
        let joints = self.outer_joints(*outer);
        let [first, second] = lengths;
        let lengths = [self.length(first, group.0), self.length(second, group.0)];
        let solved = rrr::rrr(&self.scope(*group), joints, lengths, self.mode(*mode));
        self.set_group(*group, &solved);
        for k in 0..2 {
            if let Some(Levers::Rrr(levers)) = solved.levers {
                self.set_bar(links[k], levers.r[k], [outer[k], *pin], lengths[k]);
            }
        }
        if self.wants_quality(*group) {
            self.qualities.insert(*group, rrr::quality(joints.seen, lengths));
        }
    }

    fn take_rrp(&mut self, step: &'s Step) {
        let Step::Rrp { group, links, outer, guide, pin, length, offset, mode } = step else {
            return;
        };
        let (b, guide) = (self.point(*outer), self.guide(*guide));
        let (length, offset) = (self.length(length, group.0), self.jet(offset));
        let scope = self.scope(*group);
        let solved = rrp::rrp(&scope, b, guide, length, offset, self.mode(*mode));
        self.set_group(*group, &solved);
        if let Some(Levers::Rrp(levers)) = solved.levers {
            self.set_bar(links[0], levers.r, [*outer, *pin], length);
        }
        self.set_origin(links[1], *pin);
        if self.wants_quality(*group) {
            self.qualities.insert(*group, rrp::quality(b, guide, length, offset));
        }
    }

    fn take_rpr(&mut self, step: &'s Step) {
        let Step::Rpr { group, links, outer, offset, mode } = step else { return };
        let joints = outer.map(|joint| self.point(joint));
        let offset = self.jet(offset);
        let solved = rpr::rpr(&self.scope(*group), joints, offset, self.mode(*mode));
        self.set_group(*group, &solved);
        for k in 0..2 {
            self.set_origin(links[k], outer[k]);
        }
        if self.wants_quality(*group) {
            self.qualities.insert(*group, rpr::quality(self.mechanism.numerics, joints, offset));
        }
    }

    fn take_prp(&mut self, step: &'s Step) {
        let Step::Prp { group, links, guides, pin, offsets } = step else { return };
        let guides = guides.map(|guide| self.guide(guide));
        let solved = prp::prp(&self.scope(*group), guides, self.jets(offsets));
        self.set_group(*group, &solved);
        for &link in links {
            self.set_origin(link, *pin);
        }
        if self.wants_quality(*group) {
            self.qualities.insert(*group, prp::quality(guides));
        }
    }

    fn take_rpp(&mut self, step: &'s Step) {
        let Step::Rpp { group, links, outer, guide, slot, offsets } = step else { return };
        let (b, rail) = (self.point(*outer), self.guide(*guide));
        let relative = self.turned(Direction::ground(self.sheet), slot);
        let slot = rpp::Slot { direction: self.turned(rail.direction, slot), relative };
        let solved = rpp::rpp(&self.scope(*group), b, rail, slot, self.jets(offsets));
        self.set_group(*group, &solved);
        self.set_origin(links[0], *outer);
        if self.wants_quality(*group) {
            self.qualities.insert(*group, rpp::quality(rail, slot));
        }
    }
}
