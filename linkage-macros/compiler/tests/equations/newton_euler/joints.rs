//! Efforts that joints and drives can exert: one column of the matrix per unknown.

use super::declared::Declared;
use super::matrix::Matrix;
use super::readings::evaluate;
use super::{Pair, Part, has_readings, normal, part_of, part_of_carrier, whole};
use crate::ir::interpret::Number;
use crate::model::acting::Effort;
use crate::model::mechanism::{Carrier, Drive, GuideId, LinkId, Placement, PointId, Scalar, Step};
use crate::oracle::Digits;
use crate::syntax::anatomy::Class;

impl<'k> Matrix<'k, '_> {
    fn revolute(&mut self, link: LinkId, on: Part, by: Part, point: PointId) {
        let at = &self.motion.points[point.index()];
        self.names.push((Effort::Pin(link, point), self.columns.len()));
        for axis in Self::axes() {
            let column = self.pair([on, by], at, &axis, 0);
            self.columns.push(column);
        }
    }

    /// A normal force at a point, and a couple. What the offset does is the normal force's.
    fn prismatic(
        &mut self,
        name: Option<LinkId>,
        parts: [Part; 2],
        at: &Pair<Digits>,
        n: &Pair<Digits>,
    ) -> [usize; 2] {
        let zero = [whole(0), whole(0)];
        let first = self.columns.len();
        self.names.extend(name.map(|link| (Effort::Guide(link), first)));
        let columns = [self.pair(parts, at, n, 0), self.pair(parts, at, &zero, 1)];
        self.columns.extend(columns);
        [first, first + 1]
    }

    /// A bar, and its rod where its length is driven.
    fn bar(&mut self, link: LinkId, outer: PointId, pin: PointId, length: &Scalar) {
        self.revolute(link, Part::Link(link), part_of(self.kinematics, outer), outer);
        let part = match self.kinematics.mechanism.moves(length) {
            true => Part::Rod(link),
            false => Part::Link(link),
        };
        self.revolute(link, part, Part::Pin(pin), pin);
        self.rod(link, pin, length);
    }

    /// The rod slides in the bar at the pin.
    fn rod(&mut self, link: LinkId, pin: PointId, length: &Scalar) {
        if !self.kinematics.mechanism.moves(length) {
            return;
        }
        let (u, at) = (&self.motion.directions[link.index()], &self.motion.points[pin.index()]);
        let parts = [Part::Rod(link), Part::Link(link)];
        self.prismatic(None, parts, at, &normal(u));
        let column = self.pair(parts, at, u, 0);
        let drive = self.columns.len();
        self.columns.push(column);
        if !has_readings(self.kinematics.mechanism, length) {
            self.names.push((Effort::Push(link), drive));
        }
        self.transmit(length, &[(drive, whole(1))]);
    }

    /// A link on a guide.
    fn on_guide(&mut self, link: LinkId, guide: GuideId) -> [usize; 2] {
        let at = self.motion.origins[link.index()].clone();
        let u = &self.motion.guides[guide.index()].1;
        let parts = [Part::Link(link), Part::Guide(guide)];
        self.prismatic(Some(link), parts, &at, &normal(u))
    }

    pub(super) fn joints(&mut self, step: &'k Step) {
        match step {
            Step::Ground { .. } | Step::Guide { .. } => {}
            Step::Point { point, carrier: Carrier::Ground, place, .. } => {
                // Held by the ground: two unknowns that no output requests.
                let at = &self.motion.points[point.index()];
                let first = self.columns.len();
                for axis in Self::axes() {
                    let column = self.pair([Part::Pin(*point), Part::Ground], at, &axis, 0);
                    self.columns.push(column);
                }
                if let Placement::Cartesian(place) = place {
                    self.transmit(&place[0], &[(first, whole(1))]);
                    self.transmit(&place[1], &[(first + 1, whole(1))]);
                }
            }
            Step::Point { .. } => {}
            Step::Group(group) => match Declared::of(group) {
                Declared { drive: Some(drive), .. } => self.driver(drive, Declared::of(group)),
                declared => self.dyad(group.kind, declared),
            },
        }
    }

    fn driver(&mut self, drive: &'k Drive, declared: Declared<'k>) {
        let (link, own) = (declared.links[0], Part::Link(declared.links[0]));
        match drive {
            Drive::Angle { angle, relative_to } => {
                let pivot = declared.points[0];
                self.revolute(link, own, part_of(self.kinematics, pivot), pivot);
                let zero = [whole(0), whole(0)];
                let column = self.pair([own, part_of_carrier(*relative_to)], &zero, &zero, 1);
                let drive = self.drive(Effort::Drive(link), column);
                self.transmit_turn(angle, &[(drive, whole(1))]);
                if let (Some(pin), Some(length)) = (declared.pin, declared.lengths.first()) {
                    self.rod(link, pin, length);
                }
            }
            Drive::Slide(slide) => {
                let guide = declared.guides[0];
                let parts = [own, Part::Guide(guide)];
                let (at, u) =
                    (&self.motion.origins[link.index()], &self.motion.guides[guide.index()].1);
                let column = self.pair(parts, at, u, 0);
                let drive = self.drive(Effort::Drive(link), column);
                let [normal, _] = self.on_guide(link, guide);
                self.transmit(slide, &[(drive, whole(1))]);
                self.transmit(declared.offsets[0], &[(normal, whole(1))]);
            }
        }
    }

    fn dyad(&mut self, kind: Class, declared: Declared<'k>) {
        let Declared { links, points, guides, pin, lengths, offsets, slot, .. } = declared;
        match kind {
            Class::Rrr => {
                for k in 0..2 {
                    self.bar(links[k], points[k], pin.unwrap(), lengths[k]);
                }
            }
            Class::Rrp => {
                let (pin, guide) = (pin.unwrap(), guides[0]);
                self.bar(links[0], points[0], pin, lengths[0]);
                self.revolute(links[1], Part::Link(links[1]), Part::Pin(pin), pin);
                let [normal, _] = self.on_guide(links[1], guide);
                self.transmit(offsets[0], &[(normal, whole(1))]);
            }
            Class::Rpr => {
                for k in 0..2 {
                    let by = part_of(self.kinematics, points[k]);
                    self.revolute(links[k], Part::Link(links[k]), by, points[k]);
                }
                let (at, u) = (
                    &self.motion.points[points[0].index()],
                    &self.motion.directions[links[1].index()],
                );
                let parts = [0, 1].map(|k| Part::Link(links[k]));
                let [normal, _] = self.prismatic(Some(links[0]), parts, at, &normal(u));
                self.transmit(offsets[0], &[(normal, whole(1))]);
            }
            Class::Prp => {
                for k in 0..2 {
                    let own = Part::Link(links[k]);
                    self.revolute(links[k], own, Part::Pin(pin.unwrap()), pin.unwrap());
                    let [normal, _] = self.on_guide(links[k], guides[k]);
                    self.transmit(offsets[k], &[(normal, whole(1))]);
                }
            }
            Class::Rpp => {
                let by = part_of(self.kinematics, points[0]);
                self.revolute(links[0], Part::Link(links[0]), by, points[0]);
                self.on_guide(links[1], guides[0]);
                let at = self.motion.points[points[0].index()].clone();
                let u = self.motion.directions[links[0].index()].clone();
                let n = normal(&u);
                let parts = [Part::Link(links[0]), Part::Slot(links[0])];
                let [across, _] = self.prismatic(Some(links[0]), parts, &at, &n);
                self.transmit(offsets[1], &[(across, whole(1))]);
                let slide = self.motion.slides[links[0].index()].clone().expect("it slides");
                let offset = evaluate(self.kinematics.mechanism, offsets[1], self.given);
                let along = |axis: usize| u[axis].mul(&slide).add(&n[axis].mul(&offset));
                let origin = [0, 1].map(|axis| at[axis].sub(&along(axis)));
                let turn = slot.expect("its row has a slot");
                self.carry_slot([links[0], links[1]], &origin, offsets[0], turn);
            }
            Class::Crank | Class::Slider => unreachable!("drivers are no dyads"),
        }
    }
}
