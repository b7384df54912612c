//! The walk backwards over the steps: every reaction and the effort of every drive.

mod closing;
mod steps;

use std::cell::OnceCell;
use std::collections::HashMap;

use crate::equations::forces::elastic::{springs, stops};
use crate::equations::forces::loads::{
    self, Masses, MovingPlace, applied, gravity, of_masses, torques,
};
use crate::equations::forces::together;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::Frame;
use crate::equations::reactions::{Acting, GuideReaction};
use crate::equations::slip_rounding::SlipRounding;
use crate::equations::symbol::{GraphBuilder, Sym, Vector};
use crate::model::acting::Effort;
use crate::model::mechanism::{Body, Carrier, GuideId, InputId, Joint, LinkId, PointId, UnknownId};

/// Loads gathered on the way, and efforts found so far.
pub struct Walk<'k, 's> {
    pub(super) kinematics: &'k Kinematics<'s>,
    /// By link, about its origin.
    pub(super) links: Vec<Acting<'s>>,
    /// By point, on pins and driven points.
    points: Vec<Vector<'s>>,
    /// By guide, about its origin: what the links on it put on it.
    guides: Vec<Acting<'s>>,
    /// About the ground's origin; nothing asks for it but tests.
    pub ground: Acting<'s>,
    /// The forces along their guides that transmission puts on links that slide.
    slides: HashMap<LinkId, Sym<'s>>,
    /// The forces along their guides that slides of groups transmit, all of them together.
    pub(super) along: HashMap<LinkId, Sym<'s>>,
    /// The efforts of coordinates of points in their carriers.
    coordinates: HashMap<(Carrier, PointId), [Sym<'s>; 2]>,
    efforts: Vec<Sym<'s>>,
    /// By unknown, what a drive there would have to exert: in the end nothing.
    sought: Vec<Sym<'s>>,
    pub(super) found: HashMap<Effort, Vec<Sym<'s>>>,
    /// By point, the sum of what the links that stand on it put on it.
    standing: HashMap<PointId, Vector<'s>>,
    /// By point, the sum of what is put on it but for joints.
    put: HashMap<PointId, Vector<'s>>,
    pub(super) rubs: Rubs<'k, 's>,
    /// That of the state whose slips count, as soon as a joint asks for it.
    pub(super) rounding: OnceCell<SlipRounding<'s>>,
    /// The power that friction takes.
    pub losses: Sym<'s>,
    /// The amount of friction, by its index.
    pub amounts: HashMap<usize, Sym<'s>>,
    /// The same in the direction of the slip.
    pub(super) braking: HashMap<usize, Sym<'s>>,
}

/// Friction that a walk meets.
#[derive(Clone, Copy)]
pub(super) enum Rubs<'k, 's> {
    /// Against the slips of the motion.
    Slipping,
    /// At rest, against the slips of a creep.
    Creeping(&'k Kinematics<'s>),
    /// The same of joints whose sign is not smooth, so many times.
    Sticking(&'k Kinematics<'s>, Sym<'s>),
    /// None but what is put on.
    Never,
}

impl<'k, 's> Walk<'k, 's> {
    pub fn of(kinematics: &'k Kinematics<'s>) -> Self {
        Self::against(kinematics, Rubs::Slipping)
    }

    /// At rest, with friction against the slips of a creep.
    pub fn creeping(resting: &'k Kinematics<'s>, creeping: &'k Kinematics<'s>) -> Self {
        Self::against(resting, Rubs::Creeping(creeping))
    }

    /// Under all that acts.
    pub(super) fn against(kinematics: &'k Kinematics<'s>, rubs: Rubs<'k, 's>) -> Self {
        let mut walk = Self::start(kinematics, rubs);
        walk.load();
        walk.back();
        walk
    }

    /// Before anything acts.
    pub(super) fn start(kinematics: &'k Kinematics<'s>, rubs: Rubs<'k, 's>) -> Self {
        let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
        let nothing = Acting { force: builder.zero_vector(), moment: builder.zero() };
        Self {
            kinematics,
            links: vec![nothing; mechanism.links.len()],
            points: vec![builder.zero_vector(); mechanism.points.len()],
            guides: vec![nothing; mechanism.guides.len()],
            ground: nothing,
            slides: HashMap::new(),
            along: HashMap::new(),
            coordinates: HashMap::new(),
            efforts: vec![builder.zero(); mechanism.inputs.len()],
            sought: vec![builder.zero(); mechanism.unknowns.len()],
            found: HashMap::new(),
            standing: HashMap::new(),
            put: HashMap::new(),
            rubs,
            rounding: OnceCell::new(),
            losses: builder.zero(),
            amounts: HashMap::new(),
            braking: HashMap::new(),
        }
    }

    /// From the last step to the first, with what acts by then.
    pub(super) fn back(&mut self) {
        let mechanism = self.kinematics.mechanism;
        let closing = |behind: usize| {
            let ids = (0..mechanism.unknowns.len() as u32).rev().map(UnknownId);
            ids.filter(move |id| mechanism.unknowns[id.index()].steps[1] == behind)
        };
        closing(mechanism.steps.len()).for_each(|id| self.close(id));
        for (index, step) in mechanism.steps.iter().enumerate().rev() {
            self.backward(step);
            closing(index).for_each(|id| self.close(id));
        }
    }

    pub(super) fn builder(&self) -> &'s GraphBuilder<'s> {
        self.kinematics.builder
    }

    /// Components of an effort that the walk has found.
    pub fn components(&self, effort: Effort) -> Vec<Sym<'s>> {
        let zero = self.builder().zero_vector();
        match effort {
            Effort::Input(input) => vec![self.efforts[input.index()]],
            Effort::Pull => vec![self.kinematics.value_of_pull()],
            Effort::Bearing(_, point) => {
                let standing = self.standing.get(&point).copied().unwrap_or(zero);
                let Vector { x, y } = match self.kinematics.mechanism.is_drawn_joint(point) {
                    true => standing + self.put.get(&point).copied().unwrap_or(zero),
                    false => standing,
                };
                vec![x, y]
            }
            Effort::Losses => vec![self.losses],
            Effort::Shaking => together::shaking(self.kinematics).into(),
            Effort::Spring(spring) => vec![springs::effort(self.kinematics, spring.index())],
            Effort::Stop(stop) => vec![stops::effort(self.kinematics, stop.index())],
            Effort::Gap(stop) => vec![stops::gap(self.kinematics, stop.index())],
            Effort::PinFriction(..) | Effort::GuideFriction(_) => vec![self.friction_on(effort)],
            Effort::Formula(id) => {
                let formula = &self.kinematics.mechanism.dynamics.formulas[id.index()];
                let part = |effort, part: usize| self.components(effort)[part];
                vec![self.kinematics.jet_of(&formula.value, &part).value]
            }
            Effort::Guide(by) => self.guide_as_drawn(by),
            Effort::Drive(by) if self.kinematics.mechanism.driven_as_drawn(by) != by => {
                self.found[&effort].iter().map(|&number| -number).collect()
            }
            other => self.found[&other].clone(),
        }
    }

    /// Everything that was found but for sums over several links.
    pub fn found(&self) -> impl Iterator<Item = (Effort, &[Sym<'s>])> {
        self.found.iter().map(|(&effort, numbers)| (effort, &numbers[..]))
    }

    /// By input.
    pub fn input_efforts(&self) -> &[Sym<'s>] {
        &self.efforts
    }

    /// Weight, inertia, and what is applied.
    pub(super) fn load(&mut self) {
        self.load_masses(gravity(self.kinematics));
        for (point, force) in applied(self.kinematics) {
            self.push(point, force);
        }
        for (carrier, couple) in torques(self.kinematics) {
            self.turn(carrier, couple);
        }
        for (link, force) in stops::slides(self.kinematics) {
            self.push_drawn_slide(link, force);
        }
    }

    /// Inertia, and weight in this gravity.
    pub(super) fn load_masses(&mut self, g: Vector<'s>) {
        let kinematics = self.kinematics;
        let masses = Masses::of(kinematics);
        for (link, inertia) in masses.by_link() {
            let own = of_masses(kinematics, link, inertia, g);
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
    }

    /// Records the push of a bar of driven length, which includes the loads on its rod.
    pub(super) fn note_rod(&mut self, link: LinkId, effort: Sym<'s>) {
        let rod = self.rods(link) + effort;
        self.found.insert(Effort::Push(link), vec![rod]);
    }

    fn rods(&self, link: LinkId) -> Sym<'s> {
        self.found.get(&Effort::Push(link)).map_or(self.builder().zero(), |known| known[0])
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
        let zero = self.builder().zero_vector();
        let sum = self.put.entry(point).or_insert(zero);
        *sum = *sum + force;
        self.push_body(loads::owner(self.kinematics, point), point, force);
    }

    fn push_body(&mut self, body: Body, point: PointId, force: Vector<'s>) {
        match body {
            Body::Ground => self.push_ground(self.kinematics.point(point).position(), force),
            Body::Link(link) => self.push_on(Carrier::Link(link), point, force),
            Body::Pin(point) => {
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
        let zero = self.builder().zero();
        let known = self.coordinates.entry((carrier, point)).or_insert([zero; 2]);
        *known = [known[0] + x, known[1] + y];
    }

    /// The efforts of a point's coordinates, all of them being known.
    fn driven(&self, carrier: Carrier, point: PointId) -> [Sym<'s>; 2] {
        let zero = self.builder().zero();
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

    pub(super) fn slide(&self, link: LinkId) -> Sym<'s> {
        self.slides.get(&link).copied().unwrap_or(self.builder().zero())
    }

    fn note_pin(&mut self, link: LinkId, point: PointId, force: Vector<'s>) {
        self.found.insert(Effort::Pin(link, point), vec![force.x, force.y]);
    }

    /// An outer joint's force on its link is known: the opposite is on the other body.
    fn react_on_joint(&mut self, joint: &Joint, force: Vector<'s>) {
        let point = joint.point().expect("a force at a point is a revolute joint's");
        self.note_pin(joint.link(), point, force);
        self.push_body(joint.bodies[0], point, -force);
        let zero = self.builder().zero_vector();
        let sum = self.standing.entry(point).or_insert(zero);
        *sum = *sum - force;
    }

    /// Records what a guide exerts on a link: normal force and couple, and the force along it.
    fn note_guide(
        &mut self,
        link: LinkId,
        GuideReaction { normal, couple }: GuideReaction<'s>,
        along: Sym<'s>,
    ) {
        self.found.insert(Effort::Guide(link), vec![normal, couple]);
        self.along.insert(link, along);
    }

    /// A guide's force on the link of a joint, at its slide: along the guide and along its normal.
    fn on_guide(
        &mut self,
        joint: &Joint,
        reaction: GuideReaction<'s>,
        [slide, along]: [Sym<'s>; 2],
    ) {
        self.note_guide(joint.link(), reaction, along);
        let guide = joint.guide().expect("it slides on a guide");
        let offset = self.kinematics.offset_in(joint).value;
        let frame = self.kinematics.guide(guide);
        let sum = &mut self.guides[guide.index()];
        sum.force = sum.force - frame.vector(along, reaction.normal);
        // (s u + e n) × (S u + N n) = s N − e S
        let arm = slide * reaction.normal - offset * along;
        sum.moment = sum.moment - (arm + reaction.couple);
    }

    /// A force and a moment about its origin, on a guide and so on what carries it.
    pub(super) fn push_guide(&mut self, guide: GuideId, force: Vector<'s>, moment: Sym<'s>) {
        let sum = &mut self.guides[guide.index()];
        sum.force = sum.force + force;
        sum.moment = sum.moment + moment;
    }

    /// Loads on the links of a group, with the forces transmitted to links that slide on guides of other
    /// bodies.
    fn acting<const N: usize>(&self, links: [LinkId; N]) -> [Acting<'s>; N] {
        links.map(|link| {
            let own = self.links[link.index()];
            let along = self.slide(link);
            let u = self.kinematics.link(link).frame.direction.u;
            Acting { force: own.force + along * u, ..own }
        })
    }
}
