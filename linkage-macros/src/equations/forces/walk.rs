//! The walk backwards over the steps: every reaction and the effort of every drive.

use std::collections::HashMap;

use crate::equations::forces::loads::{
    self, Masses, MovingPlace, applied, gravity, of_masses, torques,
};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::Frame;
use crate::equations::parts::{Acting, GuideReaction, Levers};
use crate::equations::symbol::{Sheet, Sym, Vector};
use crate::equations::{prp, rpp, rpr, rrp, rrr};
use crate::model::dynamics::{Effort, Owner};
use crate::model::mechanism::{
    Carrier, Expr, GroupId, GuideDirection, GuideId, InputId, LinkId, PointId, Step, Through,
};

/// What has been gathered on the way, and what was found.
pub(in crate::equations) struct Walk<'k, 's> {
    pub(super) kinematics: &'k Kinematics<'s>,
    /// By link, about its origin.
    links: Vec<Acting<'s>>,
    /// By point, on pins and driven points.
    points: Vec<Vector<'s>>,
    /// By guide, about its origin: what the links on it put on it.
    guides: Vec<Acting<'s>>,
    /// About the ground's origin; nothing asks for it but tests.
    pub(in crate::equations) ground: Acting<'s>,
    /// The forces along their guides that transmission puts on links that slide.
    slides: HashMap<LinkId, Sym<'s>>,
    /// The efforts of coordinates of points in their carriers.
    coordinates: HashMap<(Carrier, PointId), [Sym<'s>; 2]>,
    efforts: Vec<Sym<'s>>,
    found: HashMap<Effort, Vec<Sym<'s>>>,
    /// By point, the sum of what the links that stand on it put on it.
    standing: HashMap<PointId, Vector<'s>>,
}

impl<'k, 's> Walk<'k, 's> {
    pub(in crate::equations) fn of(kinematics: &'k Kinematics<'s>) -> Self {
        let (sheet, mechanism) = (kinematics.sheet, kinematics.mechanism);
        let nothing = Acting { force: sheet.zero_vector(), moment: sheet.zero() };
        let mut walk = Self {
            kinematics,
            links: vec![nothing; mechanism.links.len()],
            points: vec![sheet.zero_vector(); mechanism.points.len()],
            guides: vec![nothing; mechanism.guides.len()],
            ground: nothing,
            slides: HashMap::new(),
            coordinates: HashMap::new(),
            efforts: vec![sheet.zero(); mechanism.inputs.len()],
            found: HashMap::new(),
            standing: HashMap::new(),
        };
        walk.load();
        for step in mechanism.steps.iter().rev() {
            walk.go_back(step);
        }
        walk
    }

    pub(super) fn sheet(&self) -> &'s Sheet<'s> {
        self.kinematics.sheet
    }

    /// What was found, number by number.
    pub(in crate::equations) fn components(&self, effort: Effort) -> Vec<Sym<'s>> {
        let zero = self.sheet().zero_vector();
        match effort {
            Effort::Input(input) => vec![self.efforts[input.index()]],
            Effort::Bearing(_, point) => {
                let Vector { x, y } = self.standing.get(&point).copied().unwrap_or(zero);
                vec![x, y]
            }
            other => self.found[&other].clone(),
        }
    }

    /// Everything that was found but for sums over several links.
    #[cfg(test)]
    pub(in crate::equations) fn found(&self) -> impl Iterator<Item = (Effort, &[Sym<'s>])> {
        self.found.iter().map(|(&effort, numbers)| (effort, &numbers[..]))
    }

    #[cfg(test)]
    pub(in crate::equations) fn input_efforts(&self) -> &[Sym<'s>] {
        &self.efforts
    }

    /// Weight, inertia, and what is applied.
    fn load(&mut self) {
        let kinematics = self.kinematics;
        let (masses, g) = (Masses::of(kinematics), gravity(kinematics));
        for (link, inertia) in masses.by_link() {
            let own = of_masses(kinematics, link, inertia);
            self.add(link, own);
        }
        for &(point, mass) in &masses.points {
            self.push(point, mass * (g - kinematics.point(point).acceleration));
        }
        for moving in &masses.moving {
            let force = moving.mass * (g - moving.motion.acceleration);
            let Frame { direction, .. } = kinematics.link(moving.link).frame;
            self.turn(Carrier::Link(moving.link), -(moving.inertia * direction.alpha));
            match &moving.place {
                MovingPlace::Point(point) => {
                    self.push_on(Carrier::Link(moving.link), *point, force);
                }
                MovingPlace::At(place) => {
                    self.push_at(moving.link, moving.at, force);
                    self.transmit(&place[0], -force.dot(direction.u));
                    self.transmit(&place[1], -force.dot(direction.n()));
                    if kinematics.mechanism.moves(&place[0]) {
                        self.note_rod(moving.link, -force.dot(direction.u));
                    }
                }
            }
        }
        for (point, force) in applied(kinematics) {
            self.push(point, force);
        }
        for (carrier, couple) in torques(kinematics) {
            self.turn(carrier, couple);
        }
    }

    /// What moves with the rod of a bar of driven length counts in its push.
    fn note_rod(&mut self, link: LinkId, effort: Sym<'s>) {
        let rod = self.rods(link) + effort;
        self.found.insert(Effort::Push(link), vec![rod]);
    }

    fn rods(&self, link: LinkId) -> Sym<'s> {
        self.found.get(&Effort::Push(link)).map_or(self.sheet().zero(), |known| known[0])
    }

    fn add(&mut self, link: LinkId, own: Acting<'s>) {
        let sum = &mut self.links[link.index()];
        sum.force = sum.force + own.force;
        sum.moment = sum.moment + own.moment;
    }

    /// A couple on a body.
    pub(super) fn turn(&mut self, carrier: Carrier, couple: Sym<'s>) {
        match carrier {
            Carrier::Ground => self.ground.moment = self.ground.moment + couple,
            Carrier::Link(link) => {
                let moment = &mut self.links[link.index()].moment;
                *moment = *moment + couple;
            }
        }
    }

    pub(super) fn turn_against_ground(&mut self, carrier: Carrier, couple: Sym<'s>) {
        self.turn(carrier, couple);
        self.turn(Carrier::Ground, -couple);
    }

    /// A force on a point, and so on what the point belongs to.
    pub(super) fn push(&mut self, point: PointId, force: Vector<'s>) {
        match loads::owner(self.kinematics, point) {
            Owner::Ground => self.push_ground(self.kinematics.point(point).position(), force),
            Owner::Link(link) => self.push_on(Carrier::Link(link), point, force),
            Owner::Point(point) => {
                let sum = &mut self.points[point.index()];
                *sum = *sum + force;
            }
        }
    }

    pub(super) fn push_against_ground(&mut self, point: PointId, force: Vector<'s>) {
        self.push(point, force);
        self.push_ground(self.kinematics.point(point).position(), -force);
    }

    fn push_ground(&mut self, at: Vector<'s>, force: Vector<'s>) {
        self.ground.force = self.ground.force + force;
        self.ground.moment = self.ground.moment + at.cross(force);
    }

    /// A force on a body at a point of it, whose coordinates may be driven.
    fn push_on(&mut self, carrier: Carrier, point: PointId, force: Vector<'s>) {
        let Carrier::Link(link) = carrier else {
            return self.push_ground(self.kinematics.point(point).position(), force);
        };
        let at = self.kinematics.coordinates(carrier, point);
        match self.kinematics.bar(link).filter(|(_, _, pin)| *pin == point) {
            Some((vector, ..)) => self.add(link, Acting { force, moment: vector.cross(force) }),
            None => self.push_at(link, at, force),
        }
        if self.kinematics.mechanism.coordinates_move(carrier, point) != [false; 2] {
            let direction = self.kinematics.link(link).frame.direction;
            let efforts = [-force.dot(direction.u), -force.dot(direction.n())];
            self.drive_coordinates(carrier, point, efforts);
        }
    }

    fn push_at(&mut self, link: LinkId, [x, y]: [Jet<'s>; 2], force: Vector<'s>) {
        let arm = self.kinematics.link(link).frame.vector(x.value, y.value);
        self.add(link, Acting { force, moment: arm.cross(force) });
    }

    fn drive_coordinates(&mut self, carrier: Carrier, point: PointId, [x, y]: [Sym<'s>; 2]) {
        let zero = self.sheet().zero();
        let known = self.coordinates.entry((carrier, point)).or_insert([zero; 2]);
        *known = [known[0] + x, known[1] + y];
    }

    /// The efforts of a point's coordinates, all of them being known.
    fn driven(&self, carrier: Carrier, point: PointId) -> [Sym<'s>; 2] {
        let zero = self.sheet().zero();
        self.coordinates.get(&(carrier, point)).copied().unwrap_or([zero; 2])
    }

    pub(super) fn add_effort(&mut self, input: InputId, effort: Sym<'s>) {
        let sum = &mut self.efforts[input.index()];
        *sum = *sum + effort;
    }

    /// A force on a link along its slide, and its opposite on what it slides on.
    pub(super) fn push_slide(&mut self, link: LinkId, force: Sym<'s>) {
        let sum = self.slide(link) + force;
        self.slides.insert(link, sum);
    }

    fn slide(&self, link: LinkId) -> Sym<'s> {
        self.slides.get(&link).copied().unwrap_or(self.sheet().zero())
    }

    fn note_pin(&mut self, link: LinkId, point: PointId, force: Vector<'s>) {
        self.found.insert(Effort::Pin(link, point), vec![force.x, force.y]);
    }

    /// The outer joint's force on a link is known: its opposite is on what the joint belongs to.
    fn stand(&mut self, link: LinkId, joint: PointId, force: Vector<'s>) {
        self.note_pin(link, joint, force);
        self.push(joint, -force);
        let zero = self.sheet().zero_vector();
        let sum = self.standing.entry(joint).or_insert(zero);
        *sum = *sum - force;
    }

    fn note_guide(&mut self, link: LinkId, GuideReaction { normal, couple }: GuideReaction<'s>) {
        self.found.insert(Effort::Guide(link), vec![normal, couple]);
    }

    /// The guide's force on a link at (slide, offset): n along its normal, s along it.
    fn on_guide(
        &mut self,
        (link, guide): (LinkId, GuideId),
        reaction: GuideReaction<'s>,
        along: Sym<'s>,
        [slide, offset]: [Sym<'s>; 2],
    ) {
        self.note_guide(link, reaction);
        let frame = self.kinematics.guide(guide);
        let sum = &mut self.guides[guide.index()];
        sum.force = sum.force - frame.vector(along, reaction.normal);
        // (s u + e n) × (S u + N n) = s N − e S
        let arm = slide * reaction.normal - offset * along;
        sum.moment = sum.moment - (arm + reaction.couple);
    }

    /// What acts on the links of a group, with what is transmitted to those that slide on guides
    /// of other bodies.
    fn acting<const N: usize>(&self, links: [LinkId; N]) -> [Acting<'s>; N] {
        links.map(|link| {
            let own = self.links[link.index()];
            let along = self.slide(link);
            let u = self.kinematics.link(link).frame.direction.u;
            Acting { force: own.force + along * u, ..own }
        })
    }

    fn go_back(&mut self, step: &Step) {
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
