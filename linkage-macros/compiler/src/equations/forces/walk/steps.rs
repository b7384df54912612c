//! One step of the walk: what the reactions of a driver or a group, a guide or a driven point leave on
//! what carries them.

use super::Walk;
use crate::equations::levers::Levers;
use crate::equations::parts::{Acting, GuideReaction};
use crate::equations::symbol::{Sym, Vector};
use crate::equations::{prp, rpp, rpr, rrp, rrr};
use crate::model::dynamics::Effort;
use crate::model::mechanism::{
    Carrier, Expr, GroupId, GuideDirection, GuideId, LinkId, PointId, Step, Through,
};

impl<'k, 's> Walk<'k, 's> {
    pub(super) fn go_back(&mut self, step: &Step) {
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
                if let (Carrier::Link(link), true) = (carrier, is_on_rod) {
                    self.note_rod(*link, efforts[0]);
                }
                self.transmit_place((*carrier, *point), place, efforts);
            }
            Step::Crank { .. } => self.leave_crank(step),
            Step::Slider { .. } => self.leave_slider(step),
            Step::Rrr { .. } => self.leave_rrr(step),
            Step::Rrp { .. } => self.leave_rrp(step),
            Step::Rpr { .. } => self.leave_rpr(step),
            Step::Prp { .. } => self.leave_prp(step),
            Step::Rpp { .. } => self.leave_rpp(step),
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

    /// A crank's drive takes all moment about the pivot, the pivot all force.
    fn leave_crank(&mut self, step: &Step) {
        let Step::Crank { link, pivot, pin, angle, relative_to, .. } = step else { return };
        let Acting { force, moment } = self.links[link.index()];
        self.found.insert(Effort::Drive(*link), vec![-moment]);
        self.stand(*link, *pivot, -force);
        self.turn(*relative_to, moment);
        self.transmit_turn(angle, -moment);
        if let Some((pin, length)) = pin {
            let [along, _] = self.driven(Carrier::Link(*link), *pin);
            self.drive_length(*link, &length.value, along);
        }
    }

    /// The force of a driven length, but for what moves with the rod by coordinates of its own.
    fn drive_length(&mut self, link: LinkId, length: &Expr, push: Sym<'s>) {
        let with_rod = self.rods(link) + push;
        self.found.insert(Effort::Push(link), vec![with_rod]);
        self.transmit(length, push);
    }

    /// A slider's drive takes what is along the guide, the guide the rest.
    fn leave_slider(&mut self, step: &Step) {
        let Step::Slider { link, guide, slide, offset, .. } = step else { return };
        let Acting { force, moment } = self.links[link.index()];
        let frame = self.kinematics.guide(*guide);
        let along = -force.dot(frame.direction.u);
        let drive = along - self.slide(*link);
        let normal = -force.dot(frame.direction.n());
        let place = [slide, offset].map(|expr| self.kinematics.jet(expr).value);
        self.found.insert(Effort::Drive(*link), vec![drive]);
        let reaction = GuideReaction { normal, couple: -moment };
        self.on_guide((*link, *guide), reaction, along, place);
        self.transmit(slide, drive);
        self.transmit(offset, normal);
    }

    fn leave_rrr(&mut self, step: &Step) {
        let Step::Rrr { group, links, outer, pin, lengths, .. } = step else { return };
        let Levers::Rrr(levers) = self.levers(*group) else { return };
        let on_pin = self.points[pin.index()];
        let found = rrr::reactions(*levers, self.acting(*links), on_pin);
        for k in 0..2 {
            self.note_pin(links[k], *pin, found.inner[k]);
            self.drive_bar(links[k], *pin, &lengths[k].value, found.inner[k]);
            self.stand(links[k], outer[k], found.outer[k]);
        }
    }

    /// What drives a bar's length pushes against the pin, and against what lies on the rod.
    fn drive_bar(&mut self, link: LinkId, pin: PointId, length: &Expr, by_pin: Vector<'s>) {
        if self.kinematics.mechanism.moves(length) {
            let u = self.kinematics.link(link).frame.direction.u;
            let [along, _] = self.driven(Carrier::Link(link), pin);
            self.drive_length(link, length, along - by_pin.dot(u));
        }
    }

    fn levers(&self, group: GroupId) -> &'k Levers<'s> {
        self.kinematics.levers(group)
    }

    fn leave_rrp(&mut self, step: &Step) {
        let Step::Rrp { group, links, outer, guide, pin, length, offset, .. } = step else {
            return;
        };
        let Levers::Rrp(levers) = self.levers(*group) else { return };
        let on_pin = self.points[pin.index()];
        let found = rrp::reactions(*levers, self.acting(*links), on_pin);
        for (&link, force) in links.iter().zip(found.inner) {
            self.note_pin(link, *pin, force);
        }
        self.drive_bar(links[0], *pin, &length.value, found.inner[0]);
        self.slide_on((links[1], *guide), found.guide, offset);
        self.transmit(offset, found.guide.normal);
        self.stand(links[0], *outer, found.outer);
    }

    /// A block at its slide on a guide.
    fn slide_on(
        &mut self,
        (link, guide): (LinkId, GuideId),
        reaction: GuideReaction<'s>,
        offset: &Expr,
    ) {
        let slide = self.kinematics.link(link).slide.expect("a block slides").value;
        let offset = self.kinematics.jet(offset).value;
        let along = self.slide(link);
        self.on_guide((link, guide), reaction, along, [slide, offset]);
    }

    fn leave_rpr(&mut self, step: &Step) {
        let Step::Rpr { group, links, outer, offset, .. } = step else { return };
        let Levers::Rpr(levers) = self.levers(*group) else { return };
        // What is transmitted along the bar acts between the two: (s u + e n) × −S u = e S.
        let along = self.slide(links[0]);
        let u = self.kinematics.link(links[1]).frame.direction.u;
        let e = self.kinematics.jet(offset).value;
        let [block, _] = self.acting(*links);
        let bar = self.links[links[1].index()];
        let force = bar.force - along * u;
        let bar = Acting { force, moment: bar.moment + e * along };
        let found = rpr::reactions(*levers, [block, bar]);
        self.note_guide(links[0], found.guide);
        self.transmit(offset, found.guide.normal);
        for k in 0..2 {
            self.stand(links[k], outer[k], found.outer[k]);
        }
    }

    fn leave_prp(&mut self, step: &Step) {
        let Step::Prp { group, links, guides, pin, offsets } = step else { return };
        let Levers::Prp(levers) = self.levers(*group) else { return };
        let on_pin = self.points[pin.index()];
        let found = prp::reactions(*levers, self.acting(*links), on_pin);
        for k in 0..2 {
            self.note_pin(links[k], *pin, found.inner[k]);
            self.slide_on((links[k], guides[k]), found.guides[k], &offsets[k]);
            self.transmit(&offsets[k], found.guides[k].normal);
        }
    }

    fn leave_rpp(&mut self, step: &Step) {
        let Step::Rpp { group, links, outer, guide, slot, offsets } = step else { return };
        let Levers::Rpp(levers) = self.levers(*group) else { return };
        let [e1, e2] = self.kinematics.jets(offsets).map(|jet| jet.value);
        let [block, yoke] = links.map(|link| self.kinematics.link(link));
        let s2 = block.slide.expect("the block slides in its slot").value;
        // What is transmitted along the slot acts between block and slot, at B.
        let along = self.slide(links[0]);
        let (u2, rail) = (block.frame.direction.u, yoke.frame.direction);
        let [on_block, on_yoke] = self.acting(*links);
        let back = along * u2;
        let arm = e1 * rail.n() + (s2 * u2 + e2 * u2.normal());
        let on_yoke =
            Acting { force: on_yoke.force - back, moment: on_yoke.moment - arm.cross(back) };
        let found = rpp::reactions(*levers, [on_block, on_yoke]);
        self.note_guide(links[0], found.slot);
        self.slide_on((links[1], *guide), found.rail, &Expr::zero());
        self.transmit(&offsets[0], found.offset_effort + along * u2.dot(rail.n()));
        self.transmit(&offsets[1], found.slot.normal);
        let turning = s2 * found.slot.normal + found.slot.couple - e2 * along;
        self.transmit_turn(slot, turning);
        self.stand(links[0], *outer, found.outer);
    }
}
