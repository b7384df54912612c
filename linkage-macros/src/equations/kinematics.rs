//! A mechanism's state on a sheet: every point, link and guide, step by step.

use std::collections::HashMap;

use crate::equations::jet::Jet;
use crate::equations::levers::Levers;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{GroupScope, LimitMeasures, LinkMotion, Solved};
use crate::equations::symbol::{Sheet, Sym, Vector};
use crate::equations::{crank, guide, point, prp, rpp, rpr, rrp, rrr, slider, unknown};
use crate::ir::graph::Node;
use crate::ir::program::Closure;
use crate::model::mechanism::{
    Carrier, Expr, Group, GroupId, GuideDirection, GuideId, LinkId, Mechanism, Mode, OutputKind,
    Placement, PointId, Sign, Step, Through, UnknownId,
};

/// An input as the sheet knows it.
#[derive(Clone, Copy)]
pub(super) struct Source<'s> {
    pub jet: Jet<'s>,
    /// Its cosine and sine, where they are given in its place.
    pub unit: Option<Vector<'s>>,
}

impl<'s> Source<'s> {
    /// Inputs whose value, rate and second rate are given.
    pub(super) fn free(mechanism: &Mechanism, sheet: &'s Sheet<'s>) -> Vec<Self> {
        (0..mechanism.inputs.len() as u32)
            .map(|input| {
                let order = |order| sheet.node(Node::Input { input, order });
                Self { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: None }
            })
            .collect()
    }

    /// The only input, its cosine and sine given in place of its value.
    pub(super) fn on_the_circle(sheet: &'s Sheet<'s>) -> Self {
        let order = |order| sheet.node(Node::Input { input: 0, order });
        let unit = Vector { x: sheet.node(Node::InputCos(0)), y: sheet.node(Node::InputSin(0)) };
        Self { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: Some(unit) }
    }

    /// The same input at these rates.
    pub(super) fn with_rates(self, rate: Sym<'s>, accel: Sym<'s>) -> Self {
        Self { jet: Jet { rate, accel, ..self.jet }, ..self }
    }

    /// One input at a unit rate, the others at rest, none with a second rate.
    pub(super) fn one_moving(inputs: &[Self], sheet: &'s Sheet<'s>, moving: usize) -> Vec<Self> {
        let rate = |index| sheet.integer(i64::from(index == moving));
        let inputs = inputs.iter().enumerate();
        inputs.map(|(index, source)| source.with_rates(rate(index), sheet.zero())).collect()
    }

    /// The inputs as they move, without second rates.
    pub(super) fn without_second_rates(inputs: &[Self], sheet: &'s Sheet<'s>) -> Vec<Self> {
        inputs.iter().map(|source| source.with_rates(source.jet.rate, sheet.zero())).collect()
    }
}

/// Everything that the steps have placed so far.
pub(super) struct Kinematics<'s> {
    pub sheet: &'s Sheet<'s>,
    pub mechanism: &'s Mechanism,
    pub inputs: Vec<Source<'s>>,
    pub lets: Vec<Jet<'s>>,
    /// What equations fix, as far as it is known.
    pub unknowns: Vec<Jet<'s>>,
    pub closures: Vec<Closure>,
    /// What rates are multiplied by where forces ask for them: the only input's rate, in the state
    /// at its unit rate.
    pub tempo: Option<Sym<'s>>,
    points: Vec<Option<PointMotion<'s>>>,
    links: Vec<Option<LinkMotion<'s>>>,
    guides: Vec<Option<Frame<'s>>>,
    /// Where a point lies in the frame of what carries it.
    coordinates: HashMap<(Carrier, PointId), [Jet<'s>; 2]>,
    qualities: HashMap<GroupId, LimitMeasures<'s>>,
    levers: HashMap<GroupId, Levers<'s>>,
    /// Of links between an outer joint and a pin: the vector from one to the other, its length, and
    /// the pin.
    bars: HashMap<LinkId, (Vector<'s>, Jet<'s>, PointId)>,
    /// How many steps were taken.
    taken: usize,
}

impl<'s> Kinematics<'s> {
    pub(super) fn of(
        sheet: &'s Sheet<'s>,
        mechanism: &'s Mechanism,
        inputs: Vec<Source<'s>>,
    ) -> Self {
        let mut kinematics = Self::before(sheet, mechanism, inputs);
        for index in 0..mechanism.unknowns.len() {
            kinematics.take_until(mechanism.unknowns[index].steps[0]);
            let (found, closure) = unknown::solve(&kinematics, UnknownId(index as u32));
            kinematics.unknowns.push(found);
            kinematics.closures.push(closure);
        }
        kinematics.take_until(mechanism.steps.len());
        kinematics.name_lets();
        kinematics
    }

    /// The equation of an unknown that has this trial, the earlier ones being known. Its own steps
    /// refuse nothing where it is open.
    pub(super) fn of_trial(
        inputs: Vec<Source<'s>>,
        known: &Self,
        trial: Jet<'s>,
        is_open: bool,
    ) -> Self {
        let (sheet, mechanism) = (known.sheet, known.mechanism);
        let mut kinematics = Self::before(sheet, mechanism, inputs);
        let [first, last] = mechanism.unknowns[known.unknowns.len()].steps;
        let at_rest = |jet: &Jet<'s>| Jet::constant(jet.value);
        let stands_still = kinematics.inputs.iter().all(|source| source.jet.is_fixed());
        for (index, jet) in known.unknowns.iter().enumerate() {
            kinematics.take_until(mechanism.unknowns[index].steps[0]);
            kinematics.unknowns.push(if stands_still { at_rest(jet) } else { *jet });
        }
        kinematics.take_until(first);
        kinematics.name_lets();
        kinematics.unknowns.push(trial);
        sheet.open(is_open);
        kinematics.take_until(last);
        kinematics.name_lets();
        kinematics
    }

    fn before(sheet: &'s Sheet<'s>, mechanism: &'s Mechanism, inputs: Vec<Source<'s>>) -> Self {
        Self {
            sheet,
            mechanism,
            inputs,
            lets: Vec::new(),
            unknowns: Vec::new(),
            closures: Vec::new(),
            taken: 0,
            tempo: None,
            points: vec![None; mechanism.points.len()],
            links: vec![None; mechanism.links.len()],
            guides: vec![None; mechanism.guides.len()],
            coordinates: HashMap::new(),
            qualities: HashMap::new(),
            levers: HashMap::new(),
            bars: HashMap::new(),
        }
    }

    /// The steps in front of this one that have not been taken.
    fn take_until(&mut self, end: usize) {
        let mechanism = self.mechanism;
        for step in &mechanism.steps[self.taken..end] {
            self.take(step);
        }
        self.taken = end;
    }

    /// A rate of this state as that of the motion.
    pub(super) fn in_tempo(&self, rate: Sym<'s>) -> Sym<'s> {
        self.tempo.map_or(rate, |tempo| tempo * rate)
    }

    pub(super) fn point(&self, id: PointId) -> PointMotion<'s> {
        self.points[id.index()].expect("a step uses only what earlier steps have made")
    }

    pub(super) fn link(&self, id: LinkId) -> LinkMotion<'s> {
        self.links[id.index()].expect("a step uses only what earlier steps have made")
    }

    pub(super) fn quality(&self, group: GroupId) -> Option<LimitMeasures<'s>> {
        self.qualities.get(&group).copied()
    }

    pub(super) fn guide(&self, id: GuideId) -> Frame<'s> {
        self.guides[id.index()].expect("a step uses only what earlier steps have made")
    }

    /// Of a link between an outer joint and a pin: the vector, its length, and the pin.
    pub(super) fn bar(&self, link: LinkId) -> Option<(Vector<'s>, Jet<'s>, PointId)> {
        self.bars.get(&link).copied()
    }

    pub(super) fn levers(&self, group: GroupId) -> &Levers<'s> {
        &self.levers[&group]
    }

    /// Where a point lies in the frame of what carries it.
    pub(super) fn coordinates(&self, carrier: Carrier, point: PointId) -> [Jet<'s>; 2] {
        self.coordinates[&(carrier, point)]
    }

    pub(super) fn carrier(&self, carrier: Carrier) -> Frame<'s> {
        match carrier {
            Carrier::Ground => Frame::ground(self.sheet),
            Carrier::Link(link) => self.link(link).frame,
        }
    }

    fn mode(&self, mode: Mode) -> Sym<'s> {
        match mode {
            Mode::Fixed(sign) => self.sign(sign),
            Mode::Param(param) => self.sheet.node(Node::Mode(param.0)),
        }
    }

    pub(super) fn sign(&self, sign: Sign) -> Sym<'s> {
        self.sheet.integer(if sign == Sign::Plus { 1 } else { -1 })
    }

    fn set_point(&mut self, id: PointId, motion: PointMotion<'s>) {
        self.points[id.index()] = Some(motion);
    }

    /// Takes over what a group has placed.
    fn set_group(&mut self, group: GroupId, solved: &Solved<'s>) {
        let Group { links, pin, .. } = &self.mechanism.groups[group.index()];
        for (link, &motion) in links.iter().zip(&solved.links) {
            self.links[link.index()] = Some(motion);
        }
        if let (&Some(pin), Some(motion)) = (pin, solved.pin) {
            self.set_point(pin, motion);
        }
        self.levers.extend(solved.levers.map(|levers| (group, levers)));
    }

    /// Notes where a joint lies on the x axis of a link.
    fn set_joint(&mut self, link: LinkId, joint: PointId, x: Jet<'s>) {
        let zero = Jet::zero(self.sheet);
        self.coordinates.insert((Carrier::Link(link), joint), [x, zero]);
    }

    fn set_origin(&mut self, link: LinkId, joint: PointId) {
        self.set_joint(link, joint, Jet::zero(self.sheet));
    }

    /// Notes where a bar's joints lie on it.
    fn set_bar(&mut self, link: LinkId, vector: Vector<'s>, joints: [PointId; 2], length: Jet<'s>) {
        self.set_origin(link, joints[0]);
        self.set_joint(link, joints[1], length);
        self.bars.insert(link, (vector, length, joints[1]));
    }

    /// Named expressions become known as soon as what they contain is.
    fn name_lets(&mut self) {
        while let Some(turn) = self.mechanism.lets.get(self.lets.len()) {
            if !self.is_known(&turn.rest) {
                break;
            }
            let jet = self.jet(&turn.rest);
            self.lets.push(jet);
        }
    }

    /// Whether everything in the expression has been placed.
    fn is_known(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Constant(_) | Expr::Input(_) | Expr::Param(_) | Expr::Load(_) => true,
            Expr::Unknown(unknown) => unknown.index() < self.unknowns.len(),
            Expr::Let(name) => name.index() < self.lets.len(),
            Expr::Slide(link) => self.links[link.index()].is_some(),
            Expr::Coordinate(point, _) => self.points[point.index()].is_some(),
            Expr::Distance(points) => points.iter().all(|p| self.points[p.index()].is_some()),
            Expr::Offset(point, guide) => {
                self.points[point.index()].is_some() && self.guides[guide.index()].is_some()
            }
            // Neither stands in what places anything.
            Expr::Twist(_) | Expr::Rate(_) => true,
            Expr::Negate(value) => self.is_known(value),
            Expr::Chain(first, rest) => {
                self.is_known(first) && rest.iter().all(|(_, operand)| self.is_known(operand))
            }
            Expr::Call(_, arguments) => arguments.iter().all(|a| self.is_known(a)),
        }
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

    fn take_rrr(&mut self, step: &'s Step) {
        let Step::Rrr { group, links, outer, pin, lengths, mode } = step else { return };
        let joints = outer.map(|joint| self.point(joint));
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
            self.qualities.insert(*group, rrr::quality(joints, lengths));
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
