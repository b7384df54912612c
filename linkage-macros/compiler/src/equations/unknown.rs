//! The unknown that an equation fixes: f(θ, q) = left − right = 0.
//!
//! The root is searched ([`Implicit::Root`]); its rates follow from the equation, which holds at all
//! times. With ḟ(θ̇) = f_θ θ̇ + ḟ(0) and f̈(θ̇, θ̈) = f_θ θ̈ + f̈(θ̇, 0),
//!
//! - f_θ = ḟ at θ̇ = 1 while the inputs stand still,
//! - θ̇ = −ḟ(0)/f_θ,
//! - θ̈ = −f̈(θ̇, 0)/f_θ.
//!
//! All of them come from the rates that groups have anyway: the steps between `unknown` and `solve`
//! are taken once for each, and what several of them compute is one node. f_θ is zero at a dead
//! point of the equation, and where rounding hides its sign there are no rates.
//!
//! # Equations
//! - A difference of lengths or numbers is itself.
//! - Of angles it is the angle of the vector (cos, sin) of the difference, in (−π, π], and its rate
//!   that of the difference.
//! - The distance d of two points is the length l where d²/2l − l/2 = (d − l)(d + l)/2l is zero,
//!   which needs no root and has the slope of d there.

use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::motion::Direction;
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::function::Function;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::graph::{Check, Node, RootSearch, Target, Trend};
use crate::ir::implicit::Implicit;
use crate::ir::program::Closure;
use crate::model::mechanism::{Equation, Mechanism, Mode, Sign, Unknown, UnknownId};

impl<'s> Kinematics<'s> {
    /// Everything placed, what equations fix included.
    pub fn of(
        builder: &'s GraphBuilder<'s>,
        mechanism: &'s Mechanism,
        inputs: Vec<InputMotion<'s>>,
    ) -> Self {
        Self::with_unknowns(builder, mechanism, inputs, |_, _| {})
    }

    /// The same, which tells of each unknown before it is known.
    pub(super) fn with_unknowns(
        builder: &'s GraphBuilder<'s>,
        mechanism: &'s Mechanism,
        inputs: Vec<InputMotion<'s>>,
        mut meet: impl FnMut(&Self, UnknownId),
    ) -> Self {
        let mut kinematics = Self::before(builder, mechanism, inputs);
        for index in 0..mechanism.unknowns.len() {
            kinematics.solve_tracked_until(mechanism.unknowns[index].steps[0]);
            kinematics.take_until(mechanism.unknowns[index].steps[0]);
            meet(&kinematics, UnknownId(index as u32));
            let Root { jet, closure, slope } = solve(&kinematics, UnknownId(index as u32));
            kinematics.unknowns.push(jet);
            kinematics.closures.push(closure);
            kinematics.slopes.push(slope);
        }
        kinematics.solve_tracked_until(mechanism.steps.len());
        kinematics.take_until(mechanism.steps.len());
        kinematics.name_lets();
        kinematics
    }

    /// The equation of an unknown that has this trial, the earlier ones being known. Its own steps
    /// refuse nothing where it is open.
    pub(super) fn of_trial(
        inputs: Vec<InputMotion<'s>>,
        known: &Self,
        id: UnknownId,
        trial: Jet<'s>,
        is_open: bool,
    ) -> Self {
        let (builder, mechanism) = (known.builder, known.mechanism);
        let mut kinematics = Self::before(builder, mechanism, inputs);
        kinematics.take_over_tracked(known);
        let [first, last] = mechanism.unknowns[id.index()].steps;
        let at_rest = |jet: &Jet<'s>| Jet::constant(jet.value);
        let stands_still = kinematics.inputs.iter().all(|source| source.jet.is_fixed());
        for (index, jet) in known.unknowns[..id.index()].iter().enumerate() {
            kinematics.take_until(mechanism.unknowns[index].steps[0]);
            kinematics.unknowns.push(if stands_still { at_rest(jet) } else { *jet });
        }
        kinematics.take_until(first);
        kinematics.name_lets();
        kinematics.unknowns.push(trial);
        builder.set_guards_ignored(is_open);
        kinematics.take_until(last);
        kinematics.name_lets();
        kinematics
    }

    /// All that stands in front of an equation and for it, while its unknown moves at a unit rate and everything else
    /// stands still.
    pub(super) fn while_one_is_sought(&self, id: UnknownId) -> Self {
        let (zero, one) = (self.builder.zero(), self.builder.integer(1));
        let root = Jet { value: self.unknowns[id.index()].value, rate: one, accel: zero };
        let inputs = InputMotion::at_rest(&self.inputs, self.builder);
        let at = Self::of_trial(inputs, self, id, root, false);
        at.builder.set_guards_ignored(false);
        at
    }
}

/// A root with its rates.
struct Root<'s> {
    jet: Jet<'s>,
    /// The condition that the equation is closed there.
    closure: Closure,
    /// That of left − right, which is not zero.
    slope: Sym<'s>,
}

/// Left and right of an equation.
pub(super) type Sides<'s> = [Jet<'s>; 2];

/// The root of an unknown's equation, everything in front of it being known.
fn solve<'s>(known: &Kinematics<'s>, id: UnknownId) -> Root<'s> {
    let (builder, unknown) = (known.builder, &known.mechanism.unknowns[id.index()]);
    let (zero, one) = (builder.zero(), builder.integer(1));
    let at_rest = || InputMotion::at_rest(&known.inputs, builder);
    let slope = |[left, right]: Sides<'s>| left.rate - right.rate;
    let jet = |value, rate, accel| Jet { value, rate, accel };
    let trial = builder.node(Node::Trial(id.0));
    let tried = sides(known, jet(trial, one, zero), at_rest(), true);
    let between = unknown.between.each_ref().map(|end| known.jet(end).value);
    let search = builder.implicit(Implicit::Root(RootSearch {
        unknown: id.0,
        wanted: Target::Root,
        trend: trend(unknown),
        between: between.map(|end| end.id),
        near: unknown.near.as_ref().map(|near| known.jet(near).value.id),
        sides: [tried[0].value.id, tried[1].value.id, slope(tried).id],
    }));
    let root = builder.node(Node::Solved(search, 0, None));
    builder.name(root, unknown.name.to_string());
    let size = builder.node(Node::Solved(search, 1, Some(root.id)));
    builder.name(size, format!("{} size", unknown.name));

    let turned = sides(known, jet(root, one, zero), at_rest(), false);
    let sign = known.mode(unknown.mode);
    // The size over the width is the slope that rounding alone may make.
    let spread = size * (between[1] - between[0]).recip();
    let f_theta = (sign * slope(turned)).guarded_by(Check::Moving, unknown.group.0, &[spread]);
    builder.name(f_theta, format!("{} slope", unknown.name));
    let inputs = || known.inputs.clone();
    let over = |value: Sym<'s>| if value.is_zero() { value } else { -(sign * value) / f_theta };
    let resting = sides(known, jet(root, zero, zero), inputs(), false);
    let rate = over(slope(resting));
    let [left, right] = sides(known, jet(root, rate, zero), inputs(), false);
    let closed = Check::Closed(unit(unknown.measure, Order::Position));
    let open_by = (left.value - right.value).guarded_by(closed, unknown.group.0, &[size]);
    let closure = Closure { root: root.id, condition: open_by.id };
    let jet = jet(root, rate, over(left.accel - right.accel));
    Root { jet, closure, slope: sign * f_theta }
}

/// The sign of the slope at the root.
pub(super) fn trend(unknown: &Unknown) -> Trend {
    match unknown.mode {
        Mode::Fixed(Sign::Plus) => Trend::Rising,
        Mode::Fixed(Sign::Minus) => Trend::Falling,
        Mode::Param(param) => Trend::Param(param.0),
    }
}

/// Both sides of the equation where the unknown has this value and these rates.
pub(super) fn sides<'s>(
    known: &Kinematics<'s>,
    trial: Jet<'s>,
    inputs: Vec<InputMotion<'s>>,
    is_open: bool,
) -> Sides<'s> {
    let id = UnknownId(known.unknowns.len() as u32);
    let at = Kinematics::of_trial(inputs, known, id, trial, is_open);
    let unknown = &known.mechanism.unknowns[id.index()];
    let sides = match &unknown.equation {
        Equation::Difference(sides) => at.jets(sides),
        Equation::Turn(turn) => {
            let Direction { u, omega, alpha, .. } = at.turned(Direction::ground(at.builder), turn);
            let angle = Jet { value: u.y.apply2(Function::Atan2, u.x), rate: omega, accel: alpha };
            [angle, Jet::zero(at.builder)]
        }
        Equation::Distance { points, length, is_left } => {
            let [p, q] = points.map(|point| at.point(point));
            let [x, y] = p.jets_to(q);
            let length = at.length(length, unknown.group.0);
            let one = Jet::constant(at.builder.integer(1));
            let half = one / length.twice();
            let sides = [(x * x + y * y) * half, length.times(at.builder.integer(1).half())];
            if *is_left { sides } else { [sides[1], sides[0]] }
        }
    };
    at.builder.set_guards_ignored(false);
    sides
}
