//! A mechanism's state on a builder: every point, link and guide, step by step.

use std::cell::OnceCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::equations::jet::Jet;
use crate::equations::motion::{Direction, Frame, PointMotion};
use crate::equations::parts::{LimitMeasures, LinkMotion, Solved};
use crate::equations::reactions::JacobianFactors;
use crate::equations::symbol::{GraphBuilder, Sym, Vector};
use crate::ir::graph::Node;
use crate::ir::program::Closure;
use crate::model::mechanism::{
    AngleSum, Assembly, Carrier, Group, GroupId, GuideId, LinkId, Mechanism, Mode, PointId, Scalar,
    Sign,
};

/// An input as the builder knows it.
#[derive(Clone, Copy)]
pub struct InputMotion<'s> {
    pub jet: Jet<'s>,
    /// Its cosine and sine, where they are given in its place.
    pub unit: Option<Vector<'s>>,
}

impl<'s> InputMotion<'s> {
    /// Inputs whose value, rate and acceleration are given.
    pub fn free(mechanism: &Mechanism, builder: &'s GraphBuilder<'s>) -> Vec<Self> {
        (0..mechanism.inputs.len() as u32)
            .map(|input| {
                let order = |order| builder.node(Node::Input { input, order });
                Self { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: None }
            })
            .collect()
    }

    /// The only input, its cosine and sine given in place of its value.
    pub(super) fn on_the_circle(builder: &'s GraphBuilder<'s>) -> Self {
        let order = |order| builder.node(Node::Input { input: 0, order });
        let unit =
            Vector { x: builder.node(Node::InputCos(0)), y: builder.node(Node::InputSin(0)) };
        Self { jet: Jet { value: order(0), rate: order(1), accel: order(2) }, unit: Some(unit) }
    }

    /// The same input at these rates.
    pub(super) fn with_rates(self, rate: Sym<'s>, accel: Sym<'s>) -> Self {
        Self { jet: Jet { rate, accel, ..self.jet }, ..self }
    }

    /// One input at a unit rate, the others at rest, none with an acceleration.
    pub fn one_moving(inputs: &[Self], builder: &'s GraphBuilder<'s>, moving: usize) -> Vec<Self> {
        let mut moved = Self::at_rest(inputs, builder);
        moved[moving].jet.rate = builder.integer(1);
        moved
    }

    /// One input at a unit acceleration, all at rest.
    pub(super) fn one_starting(
        inputs: &[Self],
        builder: &'s GraphBuilder<'s>,
        moving: usize,
    ) -> Vec<Self> {
        let mut moved = Self::at_rest(inputs, builder);
        moved[moving].jet.accel = builder.integer(1);
        moved
    }

    /// The inputs, standing still.
    pub fn at_rest(inputs: &[Self], builder: &'s GraphBuilder<'s>) -> Vec<Self> {
        let zero = builder.zero();
        inputs.iter().map(|source| source.with_rates(zero, zero)).collect()
    }

    /// The inputs as they move, without accelerations.
    pub(super) fn without_second_rates(
        inputs: &[Self],
        builder: &'s GraphBuilder<'s>,
    ) -> Vec<Self> {
        inputs.iter().map(|source| source.with_rates(source.jet.rate, builder.zero())).collect()
    }
}

/// Everything that the steps have placed so far.
#[derive(Clone)]
pub struct Kinematics<'s> {
    pub builder: &'s GraphBuilder<'s>,
    pub mechanism: &'s Mechanism,
    pub inputs: Vec<InputMotion<'s>>,
    pub lets: Vec<Jet<'s>>,
    /// Laws, each as soon as a force asks for it.
    pub(super) laws: Vec<OnceCell<Jet<'s>>>,
    /// Unknowns that equations fix, as far as they are known.
    pub unknowns: Vec<Jet<'s>>,
    /// By group that is solved by all its unknowns at once, these, as far as they are known.
    pub tracked: Vec<Vec<Jet<'s>>>,
    pub closures: Vec<Closure>,
    /// Slopes of left − right of the equations of unknowns.
    pub slopes: Vec<Sym<'s>>,
    /// Scale from the unit-rate state to the actual rates, for forces: the only input's rate. None in other
    /// states.
    pub rate_scale: Option<Sym<'s>>,
    /// The load that drives an input, where it is known. None in states in which a call is given it.
    pub pull: Option<Sym<'s>>,
    pub(super) points: Vec<Option<PointMotion<'s>>>,
    pub(super) links: Vec<Option<LinkMotion<'s>>>,
    pub(super) guides: Vec<Option<Frame<'s>>>,
    /// Where a point lies in the frame of what carries it.
    pub(super) coordinates: HashMap<(Carrier, PointId), [Jet<'s>; 2]>,
    pub(super) measures: HashMap<GroupId, LimitMeasures<'s>>,
    pub(super) levers: HashMap<GroupId, Rc<dyn JacobianFactors<'s> + 's>>,
    /// Links between an outer joint and a pin: the vector from one to the other, its length, and the pin.
    pub(super) bars: HashMap<LinkId, (Vector<'s>, Jet<'s>, PointId)>,
    /// Number of steps taken.
    pub(super) taken: usize,
    /// The state in which rates are derivatives by the only input, as soon as a number asks for it.
    pub(super) by_input: OnceCell<Box<Self>>,
    /// True for that state.
    pub(super) is_by_input: bool,
}

impl<'s> Kinematics<'s> {
    /// Nothing placed yet.
    pub(super) fn before(
        builder: &'s GraphBuilder<'s>,
        mechanism: &'s Mechanism,
        inputs: Vec<InputMotion<'s>>,
    ) -> Self {
        Self {
            builder,
            mechanism,
            inputs,
            lets: Vec::new(),
            laws: vec![OnceCell::new(); mechanism.dynamics.laws.len()],
            unknowns: Vec::new(),
            tracked: Vec::new(),
            closures: Vec::new(),
            slopes: Vec::new(),
            taken: 0,
            rate_scale: None,
            pull: None,
            points: vec![None; mechanism.points.len()],
            links: vec![None; mechanism.links.len()],
            guides: vec![None; mechanism.guides.len()],
            coordinates: HashMap::new(),
            measures: HashMap::new(),
            levers: HashMap::new(),
            bars: HashMap::new(),
            by_input: OnceCell::new(),
            is_by_input: false,
        }
    }

    /// A rate of this state as that of the motion.
    pub(super) fn at_rate_scale(&self, rate: Sym<'s>) -> Sym<'s> {
        self.rate_scale.map_or(rate, |rate_scale| rate_scale * rate)
    }

    /// The load that drives an input.
    pub(super) fn value_of_pull(&self) -> Sym<'s> {
        let given = || {
            let (input, _) = self.mechanism.dynamics.driven().expect("a load drives an input");
            self.builder.node(Node::Drive(input.0))
        };
        self.pull.unwrap_or_else(given)
    }

    pub fn point(&self, id: PointId) -> PointMotion<'s> {
        self.points[id.index()].expect("a step uses only what earlier steps have made")
    }

    pub fn link(&self, id: LinkId) -> LinkMotion<'s> {
        self.links[id.index()].expect("a step uses only what earlier steps have made")
    }

    /// The slide at the joint of a link, as it is declared or drawn.
    pub(super) fn slide(&self, by: LinkId) -> Jet<'s> {
        let slide = self.link(by).slide.expect("the model checked that it slides");
        match self.mechanism.slide_as_drawn(by) {
            Some(drawn) if drawn.is_reversed => self.jet(&drawn.shift) + -slide,
            Some(drawn) => slide + self.jet(&drawn.shift),
            None => slide,
        }
    }

    /// The direction of a link's frame, as it is declared or drawn.
    pub(super) fn direction(&self, link: LinkId) -> Direction<'s> {
        let Some(turn) = self.mechanism.turn_of(link) else {
            return self.link(link).frame.direction;
        };
        let turn = AngleSum { links: vec![(link, 1)], rest: turn.clone() };
        self.turned(Direction::ground(self.builder), &turn)
    }

    pub(super) fn measures_of(&self, group: GroupId) -> Option<LimitMeasures<'s>> {
        self.measures.get(&group).copied()
    }

    pub fn guide(&self, id: GuideId) -> Frame<'s> {
        self.guides[id.index()].expect("a step uses only what earlier steps have made")
    }

    /// Link between an outer joint and a pin: the vector, its length, and the pin.
    pub fn bar(&self, link: LinkId) -> Option<(Vector<'s>, Jet<'s>, PointId)> {
        self.bars.get(&link).copied()
    }

    pub(super) fn levers(&self, group: GroupId) -> &dyn JacobianFactors<'s> {
        &*self.levers[&group]
    }

    /// Where a point lies in the frame of what carries it.
    pub fn coordinates(&self, carrier: Carrier, point: PointId) -> [Jet<'s>; 2] {
        self.coordinates[&(carrier, point)]
    }

    pub fn carrier(&self, carrier: Carrier) -> Frame<'s> {
        match carrier {
            Carrier::Ground => Frame::ground(self.builder),
            Carrier::Link(link) => self.link(link).frame,
        }
    }

    pub(super) fn mode(&self, mode: Mode) -> Sym<'s> {
        match mode {
            Mode::Fixed(sign) => self.sign(sign),
            Mode::Param(param) => self.builder.node(Node::Mode(param.0)),
        }
    }

    /// The root that a group with two ways of assembly is to take.
    pub(super) fn mode_of(&self, group: &Group) -> Sym<'s> {
        match group.assembly {
            Assembly::Unique | Assembly::Parallel(_) => self.builder.integer(1),
            Assembly::Signed(mode) => self.mode(mode),
        }
    }

    pub(super) fn sign(&self, sign: Sign) -> Sym<'s> {
        self.builder.integer(if sign == Sign::Plus { 1 } else { -1 })
    }

    pub(super) fn set_point(&mut self, id: PointId, motion: PointMotion<'s>) {
        self.points[id.index()] = Some(motion);
    }

    /// Takes over what a group has placed.
    pub(super) fn set_group(&mut self, group: &Group, solved: Solved<'s>) {
        let mut bars = solved.bars.into_iter();
        if let (Some(pin), Some(motion)) = (group.pin, solved.pin) {
            self.set_point(pin, motion);
        }
        for (index, (&link, motion)) in group.links.iter().zip(solved.links).enumerate() {
            self.links[link.index()] = Some(motion);
            let origin = group.origin(link).or(group.pin);
            let bar = group.lengths[index].as_ref().zip(group.pin);
            match (origin, bar.and_then(|bar| Some((bar, bars.next()?)))) {
                (Some(outer), Some(((length, pin), vector))) => {
                    let length = self.length(length, group.id.0);
                    self.set_bar(link, vector, [outer, pin], length);
                }
                (Some(origin), None) => self.set_origin(link, origin),
                (None, _) => {}
            }
        }
        self.levers.extend(solved.levers.map(|levers| (group.id, Rc::from(levers))));
    }

    /// Notes where a joint lies on the x axis of a link.
    pub(super) fn set_joint(&mut self, link: LinkId, joint: PointId, x: Jet<'s>) {
        let zero = Jet::zero(self.builder);
        self.coordinates.insert((Carrier::Link(link), joint), [x, zero]);
    }

    pub(super) fn set_origin(&mut self, link: LinkId, joint: PointId) {
        self.set_joint(link, joint, Jet::zero(self.builder));
    }

    /// Notes where a bar's joints lie on it.
    pub(super) fn set_bar(
        &mut self,
        link: LinkId,
        vector: Vector<'s>,
        joints: [PointId; 2],
        length: Jet<'s>,
    ) {
        self.set_origin(link, joints[0]);
        self.set_joint(link, joints[1], length);
        self.bars.insert(link, (vector, length, joints[1]));
    }

    /// Named expressions become known as soon as what they contain is.
    pub(super) fn name_lets(&mut self) {
        while let Some(turn) = self.mechanism.lets.get(self.lets.len()) {
            if !self.is_known(&turn.rest) {
                break;
            }
            let jet = self.jet(&turn.rest);
            self.lets.push(jet);
        }
    }

    /// True if everything in the expression has been placed.
    pub(super) fn is_known(&self, expr: &Scalar) -> bool {
        match expr {
            Scalar::Constant(_)
            | Scalar::Input(_)
            | Scalar::Param(_)
            | Scalar::Load(_)
            | Scalar::Pull => true,
            Scalar::Unknown(unknown) => unknown.index() < self.unknowns.len(),
            Scalar::Tracked(group, _) => group.index() < self.tracked.len(),
            Scalar::Let(name) => name.index() < self.lets.len(),
            Scalar::Slide(link) => self.links[link.index()].is_some(),
            Scalar::Coordinate(point, _) => self.points[point.index()].is_some(),
            Scalar::Distance(points) => points.iter().all(|p| self.points[p.index()].is_some()),
            Scalar::Offset(point, guide) => {
                self.points[point.index()].is_some() && self.guides[guide.index()].is_some()
            }
            // Neither stands in what places anything.
            Scalar::Twist(_) | Scalar::Rate(_) | Scalar::Law(_) | Scalar::Effort(..) => true,
            Scalar::Negate(value) => self.is_known(value),
            Scalar::AboveZero(inner) => self.is_known(&inner.value),
            Scalar::Chain(first, rest) => {
                self.is_known(first) && rest.iter().all(|(_, operand)| self.is_known(operand))
            }
            Scalar::Call(_, arguments) => arguments.iter().all(|a| self.is_known(a)),
        }
    }
}
