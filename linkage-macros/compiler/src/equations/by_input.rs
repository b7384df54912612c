//! Derivatives by the only input: numbers of the pose that are made of rates.
//!
//! Where the input has the rate 1 and no acceleration, the velocity and the acceleration of everything are its first and
//! second derivative by q: x′ = ẋ and x″ = ẍ. The third follows from the graph of the second by the chain rule, node by
//! node; of a root the slope by q is its own rate. A number z that no rate changes, as ẋ/ẏ = x′/y′, then has
//! ż = z′ q̇ and z̈ = z″ q̇² + z′ q̈.
//!
//! # Poles
//! At rest in a link's plane is the point at I = O + ẑ × v_O/ω, that is (x_O − y_O′/φ′, y_O + x_O′/φ′). Against a
//! second link it is the same with the velocity of O in that link's plane and the difference of both ω: there both
//! links have one velocity. O is the origin of the link's frame, so that a link on a pin of the ground has its pole there
//! also where it stands still.
//!
//! # Source
//! Uicker, Pennock, Shigley, Theory of Machines and Mechanisms, ch. 3 (instant centres) and ch. 4 (kinematic
//! coefficients).
//!
//! # Error
//! A pole is refused as `Singular` where ω is no larger than the rounding of the velocities at the link's ends makes
//! it: at 1/ε times the link's length and beyond it is at infinity.

use std::collections::HashMap;

use crate::equations::functions::slopes;
use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::{Check, Id, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::model::mechanism::{AngleSum, LinkId, Scalar};

impl<'s> Kinematics<'s> {
    /// A number of rates that none changes, with its rates in time.
    pub(super) fn steady(&self, number: &Scalar) -> Jet<'s> {
        self.in_time(self.by_input().jet(number))
    }

    /// The pole of a link against the ground or a second link, with its rates in time. `title` is what `Singular` names.
    pub(super) fn pole(&self, links: &[LinkId], title: u32) -> [Jet<'s>; 2] {
        self.by_input().pole_by_input(links, title).map(|place| self.in_time(place))
    }

    /// The state in which rates are derivatives by the only input.
    fn by_input(&self) -> &Self {
        self.by_input.get_or_init(|| {
            let inputs = InputMotion::one_moving(&self.inputs, self.builder, 0);
            let state = Self::of(self.builder, self.mechanism, inputs);
            Box::new(Self { is_by_input: true, ..state })
        })
    }

    /// A number with derivatives by the input, with rates in time.
    fn in_time(&self, by_input: Jet<'s>) -> Jet<'s> {
        let Jet { rate, accel, .. } = self.inputs[0].jet;
        Jet {
            value: by_input.value,
            rate: by_input.rate * rate,
            accel: by_input.accel * rate.squared() + by_input.rate * accel,
        }
    }

    /// The derivative of a sum of angles, or of any other number, with its own two derivatives; where this is the state by
    /// the input.
    pub(super) fn derivative(&self, turn: &AngleSum) -> Jet<'s> {
        let rest = self.jet(&turn.rest);
        turn.links.iter().fold(self.derived(rest.rate, rest.accel), |sum, &(link, times)| {
            let direction = self.link(link).frame.direction;
            let turning = self.derived(direction.omega, direction.alpha);
            sum + turning.times(self.builder.integer(i64::from(times)))
        })
    }

    /// A first derivative, from it and the second.
    fn derived(&self, first: Sym<'s>, second: Sym<'s>) -> Jet<'s> {
        Jet { value: first, rate: second, accel: self.slope(second) }
    }

    fn pole_by_input(&self, links: &[LinkId], title: u32) -> [Jet<'s>; 2] {
        let frame = self.link(links[0]).frame;
        let ([x, y], turning) = (frame.origin.coordinates(), frame.direction);
        let mut velocity = [x, y].map(|along| self.derived(along.rate, along.accel));
        let mut omega = self.derived(turning.omega, turning.alpha);
        let mut spread = self.turning_by_rounding(links[0]);
        if let Some(&other) = links.get(1) {
            let frame = self.link(other).frame;
            let ([qx, qy], turning) = (frame.origin.coordinates(), frame.direction);
            let carried = self.derived(turning.omega, turning.alpha);
            let [vx, vy] = [qx, qy].map(|along| self.derived(along.rate, along.accel));
            let [rx, ry] = frame.origin.jets_to(self.link(links[0]).frame.origin);
            velocity = [velocity[0] - (vx - carried * ry), velocity[1] - (vy + carried * rx)];
            spread = spread
                + self.turning_by_rounding(other)
                + omega.value.magnitude()
                + carried.value.magnitude();
            omega = omega - carried;
        }
        let one = self.builder.integer(1);
        let size = omega.value.magnitude().guarded_by(Check::Moving, title, &[spread]);
        let omega = Jet { value: omega.value.sign_or(one) * size, ..omega };
        [x - velocity[1] / omega, y + velocity[0] / omega]
    }

    /// The turning of a bar that rounding could make: the velocity of its outer joint over its length. The turning of
    /// anything else is that of what it stands on.
    fn turning_by_rounding(&self, link: LinkId) -> Sym<'s> {
        let Some((_, length, _)) = self.bar(link) else { return self.builder.zero() };
        let Vector { x, y } = self.link(link).frame.origin.velocity;
        (x.magnitude() + y.magnitude()) / length.value
    }

    /// The derivative of a number by the only input, in the state in which it is made of no rates.
    fn slope(&self, of: Sym<'s>) -> Sym<'s> {
        let roots = self
            .unknowns
            .iter()
            .chain(self.tracked.iter().flatten())
            .map(|unknown| (unknown.value.id, unknown.rate));
        let mut known: HashMap<Id, Sym<'s>> = roots.collect();
        for (id, node) in nodes_beneath(of) {
            if !known.contains_key(&id) {
                let slope = slope_of(self.builder.known(id), node, &known);
                known.insert(id, slope);
            }
        }
        known[&of.id]
    }
}

/// The nodes that a symbol is made of but for conditions, operands before users, itself the last.
fn nodes_beneath(of: Sym<'_>) -> Vec<(Id, Node)> {
    let graph = of.builder().graph.borrow();
    let live = live(&graph, &[of.id], Path::Unchecked);
    live_nodes(&graph, &live).collect()
}

/// The derivative of a node by the only input, those of its operands being known.
fn slope_of<'s>(own: Sym<'s>, node: Node, known: &HashMap<Id, Sym<'s>>) -> Sym<'s> {
    let builder = own.builder();
    let (at, slope) = (|id: Id| builder.known(id), |id: Id| known[&id]);
    let product = |a: Id, b: Id| slope(a) * at(b) + at(a) * slope(b);
    let of_call = |function, operands: &[Id]| {
        let values: Vec<_> = operands.iter().map(|&operand| at(operand)).collect();
        let changes = operands.iter().map(|&operand| slope(operand));
        let moving = changes.enumerate().filter(|(_, change)| !change.is_zero());
        let moving: Vec<_> = moving.collect();
        if moving.is_empty() {
            return builder.zero();
        }
        let partial = slopes(function, &values);
        moving
            .into_iter()
            .fold(builder.zero(), |sum, (index, change)| sum + partial[index] * change)
    };
    match node {
        Node::Input { order: 0, .. } => builder.integer(1),
        Node::InputCos(input) => -builder.node(Node::InputSin(input)),
        Node::InputSin(input) => builder.node(Node::InputCos(input)),
        Node::Constant(_)
        | Node::Input { .. }
        | Node::Param(_)
        | Node::Load(_)
        | Node::Drive(_)
        | Node::Mode(_)
        | Node::Trial(_)
        // Rounding errors are zero in real arithmetic. Roots are known; beside one there is its size, which conditions alone read.
        | Node::Low(_)
        | Node::MulErr(..)
        | Node::AddErr(..)
        | Node::Solved(..) => builder.zero(),
        Node::Neg(a) => -slope(a),
        Node::Add(a, b) => slope(a) + slope(b),
        Node::Sub(a, b) => slope(a) - slope(b),
        Node::Mul(a, b) => product(a, b),
        Node::Div(a, b) => (slope(a) - own * slope(b)) / at(b),
        Node::Apply(function, a) => of_call(function, &[a]),
        Node::Apply2(function, a, b) => of_call(function, &[a, b]),
        Node::Det([a, b, c, d]) => product(a, b) - product(c, d),
        Node::Fused(a, b, c) => product(a, b) + slope(c),
        Node::Select([a, b, x, y]) => at(a).at_least(at(b), slope(x), slope(y)),
        Node::Guard(a, _) => slope(a),
    }
}
