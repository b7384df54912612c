//! One step of the walk: what the reactions of a driver or a group, a guide or a driven point leave on
//! what carries them.

use super::Walk;
use crate::equations::reactions::{Acting, GuideReaction, Inner, Loads, Reaction, Reactions};
use crate::equations::symbol::{Sym, Vector};
use crate::model::acting::Effort;
use crate::model::mechanism::{
    Carrier, Drive, Group, GuideDirection, GuideId, Joint, LinkId, Placement, PointId, Scalar,
    Slideway, Step, Through,
};

impl<'k, 's> Walk<'k, 's> {
    pub(super) fn backward(&mut self, step: &Step) {
        match step {
            Step::Ground { .. } => {}
            Step::Guide { guide, carrier, through, course } => {
                self.leave_guide(*guide, *carrier, through, course);
            }
            Step::Point { point, carrier, place, .. } => {
                if *carrier == Carrier::Ground {
                    let Vector { x, y } = self.points[point.index()];
                    self.push_ground(self.kinematics.point(*point).position(), Vector { x, y });
                    self.drive_coordinates(*carrier, *point, [-x, -y]);
                }
                let efforts = self.driven(*carrier, *point);
                let is_on_rod = self.kinematics.mechanism.coordinates_move(*carrier, *point)[0];
                let has_struts = matches!(place, Placement::Distances { .. });
                if let (Carrier::Link(link), true) = (carrier, is_on_rod && !has_struts) {
                    self.note_rod(*link, efforts[0]);
                }
                self.transmit_place((*carrier, *point), place, efforts);
            }
            Step::Group(group) => {
                self.rub(group);
                match &group.outer[0] {
                    Joint { drive: Some(drive), .. } => self.leave_driver(group, drive),
                    _ => self.leave_dyad(group),
                }
            }
        }
    }

    /// All that stands on a guide is on its carrier; what turns it there takes the moment.
    fn leave_guide(
        &mut self,
        id: GuideId,
        carrier: Carrier,
        through: &Through,
        course: &GuideDirection,
    ) {
        let Acting { force, moment } = self.guides[id.index()];
        let origin = self.kinematics.guide(id).origin;
        let body = self.kinematics.carrier(carrier);
        match (through, carrier) {
            (Through::Point(point), _) => self.push_on(carrier, *point, force),
            (Through::At(_), Carrier::Ground) => self.push_ground(origin.position(), force),
            (Through::At(at), Carrier::Link(link)) => {
                let place = self.kinematics.jets(at);
                self.push_at(link, place, force);
            }
        }
        self.turn(carrier, moment);
        if let Through::At(at) = through {
            self.transmit(&at[0], -force.dot(body.direction.u));
            self.transmit(&at[1], -force.dot(body.direction.n()));
        }
        match course {
            GuideDirection::Along(turn) => self.transmit_turn(turn, -moment),
            GuideDirection::Towards(to) => self.leave_course(carrier, through, *to, -moment),
        }
    }

    /// The direction (x, y)/r from one place to another turns by (x δy − y δx)/r².
    fn leave_course(&mut self, carrier: Carrier, through: &Through, to: PointId, effort: Sym<'s>) {
        let mechanism = self.kinematics.mechanism;
        let [x1, y1] = self.kinematics.coordinates(carrier, to);
        let ([x0, y0], moves) = match through {
            Through::Point(point) => (
                self.kinematics.coordinates(carrier, *point),
                mechanism.coordinates_move(carrier, *point) != [false; 2],
            ),
            Through::At(at) => (self.kinematics.jets(at), at.iter().any(|x| mechanism.moves(x))),
        };
        if !moves && mechanism.coordinates_move(carrier, to) == [false; 2] {
            return;
        }
        let (x, y) = (x1.value - x0.value, y1.value - y0.value);
        let share = effort / (x.squared() + y.squared());
        let efforts = [-(share * y), share * x];
        self.drive_coordinates(carrier, to, efforts);
        let opposite = efforts.map(|effort| -effort);
        match through {
            Through::Point(point) => self.drive_coordinates(carrier, *point, opposite),
            Through::At(at) => {
                self.transmit(&at[0], opposite[0]);
                self.transmit(&at[1], opposite[1]);
            }
        }
    }

    /// A crank's drive takes all moment about the pivot, the pivot all force; a slider's drive takes
    /// what is along the guide, the guide the rest.
    fn leave_driver(&mut self, group: &Group, drive: &Drive) {
        let (joint, link) = (&group.outer[0], group.links[0]);
        let Acting { force, moment } = self.links[link.index()];
        match drive {
            Drive::Angle { angle, relative_to } => {
                self.found.insert(Effort::Drive(link), vec![-moment]);
                self.react_on_joint(joint, -force);
                self.turn(*relative_to, moment);
                self.transmit_turn(angle, -moment);
                self.drive_bar(group, 0, self.builder().zero_vector());
            }
            Drive::Slide(slide) => {
                let frame = self.kinematics.guide(group.slides_on(0));
                let along = -force.dot(frame.direction.u);
                let drive = along - self.slide(link);
                self.found.insert(Effort::Drive(link), vec![drive]);
                let normal = -force.dot(frame.direction.n());
                let reaction = GuideReaction { normal, couple: -moment };
                let slide_value = self.kinematics.jet(slide).value;
                self.on_guide(joint, reaction, [slide_value, along]);
                self.transmit(slide, drive);
                self.transmit_offset(joint, normal);
            }
        }
    }

    /// The force of a driven length, but for what moves with the rod by coordinates of its own.
    fn drive_length(&mut self, link: LinkId, length: &Scalar, push: Sym<'s>) {
        let with_rod = self.rods(link) + push;
        self.found.insert(Effort::Push(link), vec![with_rod]);
        self.transmit(length, push);
    }

    /// Loads on a group but for those of its own joints. A driver has one link.
    pub(in crate::equations::forces) fn loads_on(&self, group: &Group) -> Loads<'s> {
        let links = [group.links[0], group.links[group.links.len() - 1]];
        let nothing = self.builder().zero_vector();
        let pin = group.pin.map_or(nothing, |pin| self.points[pin.index()]);
        Loads { links: self.acting(links), pin, along: self.slide(links[0]) }
    }

    /// The force of a crank's pivot, or what its guide exerts on a slider.
    pub(in crate::equations::forces) fn by_driver(
        &self,
        joint: &Joint,
        Acting { force, moment }: Acting<'s>,
    ) -> Reaction<'s> {
        match joint.guide() {
            None => Reaction::Force(-force),
            Some(guide) => {
                let normal = -force.dot(self.kinematics.guide(guide).direction.n());
                Reaction::Guide(GuideReaction { normal, couple: -moment })
            }
        }
    }

    /// The joints of a dyad exert their reactions, and the opposites of them are on what carries it.
    fn leave_dyad(&mut self, group: &Group) {
        let links = [group.links[0], group.links[1]];
        let nothing = self.builder().zero_vector();
        let loads = self.loads_on(group);
        let Reactions { outer, inner } = self.kinematics.levers(group.id).reactions(&loads);
        for (joint, reaction) in group.outer.iter().zip(&outer) {
            if let Reaction::Guide(reaction) = *reaction {
                self.slide_on(joint, reaction);
            }
        }
        let by_pin = match inner {
            Inner::Pin(forces) => forces,
            Inner::Slide(reaction) => {
                self.slide_in(group, reaction);
                [nothing; 2]
            }
        };
        for (index, reaction) in outer.into_iter().enumerate() {
            if let Some(pin) = group.pin {
                self.note_pin(links[index], pin, by_pin[index]);
            }
            self.drive_bar(group, index, by_pin[index]);
            if let Reaction::Force(force) = reaction {
                self.react_on_joint(&group.outer[index], force);
            }
        }
    }

    /// Records the drive of a bar's length, which pushes against the pin and against the loads on the rod.
    fn drive_bar(&mut self, group: &Group, index: usize, by_pin: Vector<'s>) {
        let (Some(length), Some(pin)) = (&group.lengths[index], group.pin) else { return };
        let (length, link) = (&length.value, group.links[index]);
        if self.kinematics.mechanism.moves(length) {
            let u = self.kinematics.link(link).frame.direction.u;
            let [along, _] = self.driven(Carrier::Link(link), pin);
            self.drive_length(link, length, along - by_pin.dot(u));
        }
    }

    /// A block at its slide on a guide.
    fn slide_on(&mut self, joint: &Joint, reaction: GuideReaction<'s>) {
        let link = joint.link();
        let slide = self.kinematics.link(link).slide.expect("a block slides").value;
        self.on_guide(joint, reaction, [slide, self.slide(link)]);
        self.transmit_offset(joint, reaction.normal);
    }

    /// A block in another link: the group's formulas put its opposite on that.
    fn slide_in(&mut self, group: &Group, reaction: GuideReaction<'s>) {
        let joint = &group.inner[0];
        let along = self.slide(joint.link());
        self.note_guide(joint.link(), reaction, along);
        let Some(Slideway::Slot { across, angle, .. }) = joint.slideway() else {
            return self.transmit_offset(joint, reaction.normal);
        };
        let efforts = self.kinematics.levers(group.id).efforts_of_slot(reaction, along);
        self.transmit(across, efforts[0]);
        self.transmit_offset(joint, reaction.normal);
        self.transmit_turn(angle, efforts[1]);
    }

    fn transmit_offset(&mut self, joint: &Joint, effort: Sym<'s>) {
        if let Some(offset) = joint.offset() {
            self.transmit(offset, effort);
        }
    }
}
