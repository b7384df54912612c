//! Expressions of the declaration as jets and angles.

use crate::equations::forces::elastic::springs;
use crate::equations::functions::by_squaring;
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::{Direction, Frame};
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::{Check, Node};
use crate::model::acting::Effort;
use crate::model::mechanism::{
    AboveZero, AngleSum, Axis, GuideId, LawId, Length, Operator, PointId, Scalar,
};

/// The components of efforts.
pub(super) type EffortParts<'e, 's> = dyn Fn(Effort, usize) -> Sym<'s> + 'e;

impl<'s> Kinematics<'s> {
    pub fn jet(&self, expr: &Scalar) -> Jet<'s> {
        self.jet_of(expr, &|_, _| unreachable!("only outputs read efforts"))
    }

    /// A number that may read efforts.
    pub(super) fn jet_of(&self, expr: &Scalar, efforts: &EffortParts<'_, 's>) -> Jet<'s> {
        match expr {
            Scalar::Constant(value) => Jet::constant(self.builder.constant(value.clone())),
            Scalar::Input(input) => self.inputs[input.index()].jet,
            Scalar::Param(param) => Jet::constant(self.builder.node(Node::Param(param.0))),
            Scalar::Load(load) => Jet::constant(self.builder.node(Node::Load(load.0))),
            Scalar::Pull => Jet::constant(self.value_of_pull()),
            Scalar::Unknown(unknown) => self.unknowns[unknown.index()],
            Scalar::Tracked(group, index) => self.tracked[group.index()][*index],
            Scalar::Let(name) => self.lets[name.index()],
            Scalar::Law(law) => self.law(*law),
            Scalar::Slide(by) => self.slide(*by),
            Scalar::Coordinate(point, axis) => {
                let [x, y] = self.point(*point).coordinates();
                if *axis == Axis::X { x } else { y }
            }
            Scalar::Distance(points) => {
                let [p, q] = points.map(|point| self.point(point));
                let [x, y] = p.jets_to(q);
                x.hypot(y)
            }
            Scalar::Offset(point, guide) => self.offset(*point, *guide),
            Scalar::Twist(spring) => springs::twist(self, *spring),
            Scalar::Rate(turn) if self.is_by_input => self.derivative(turn),
            // A force's value has no use for its own rates.
            Scalar::Rate(turn) => Jet::constant(self.at_rate_scale(self.rate(turn))),
            Scalar::Effort(effort, part) => Jet::constant(efforts(*effort, *part)),
            Scalar::AboveZero(inner) => self.above_zero(inner, efforts),
            Scalar::Negate(value) => -self.jet_of(value, efforts),
            Scalar::Chain(first, rest) => {
                rest.iter().fold(self.jet_of(first, efforts), |a, (operator, b)| {
                    let b = self.jet_of(b, efforts);
                    match operator {
                        Operator::Add => a + b,
                        Operator::Sub => a - b,
                        Operator::Mul => a * b,
                        Operator::Div => a / b,
                    }
                })
            }
            Scalar::Call(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|a| self.jet_of(a, efforts)).collect();
                Jet::of(*function, &arguments)
            }
        }
    }

    /// A law stands on earlier ones, which come first: laws are never walked one inside the other.
    fn law(&self, law: LawId) -> Jet<'s> {
        if let Some(known) = self.laws[law.index()].get() {
            return *known;
        }
        let laws = &self.mechanism.dynamics.laws;
        let mut last = Jet::zero(self.builder);
        for (jet, law) in self.laws[..=law.index()].iter().zip(laws) {
            last = *jet.get_or_init(|| self.jet(&law.rest));
        }
        last
    }

    /// The offset of a point from a guide's line. A function of its own: what it holds does not stand
    /// on the stack of a deep expression.
    fn offset(&self, point: PointId, guide: GuideId) -> Jet<'s> {
        let Frame { origin, direction } = self.guide(guide);
        let ([x, y], [ux, uy]) = (origin.jets_to(self.point(point)), direction.jets());
        ux * y - uy * x
    }

    /// The argument of a function that has none at zero and below.
    fn above_zero(
        &self,
        AboveZero { value, name, function }: &AboveZero,
        efforts: &EffortParts<'_, 's>,
    ) -> Jet<'s> {
        let (jet, title) =
            (self.jet_of(value, efforts), self.mechanism.title_of_function(*function));
        let check = Check::Positive(name.clone());
        Jet { value: jet.value.guarded_by(check, title, &[]), ..jet }
    }

    fn rate(&self, turn: &AngleSum) -> Sym<'s> {
        turn.links.iter().fold(self.jet(&turn.rest).rate, |sum, &(link, times)| {
            let omega = self.link(link).frame.direction.omega;
            sum + self.builder.integer(i64::from(times)) * omega
        })
    }

    pub fn jets(&self, pair: &[Scalar; 2]) -> [Jet<'s>; 2] {
        [self.jet(&pair[0]), self.jet(&pair[1])]
    }

    /// A length, provided that it is positive.
    pub(super) fn length(&self, length: &Length, group: u32) -> Jet<'s> {
        let jet = self.jet(&length.value);
        let check = Check::Positive(length.name.clone());
        Jet { value: jet.value.guarded_by(check, group, &[]), ..jet }
    }

    /// The direction at an angle to another. Multiples of link angles are powers of the links'
    /// unit vectors, so no arc tangent is needed and nothing jumps.
    pub(super) fn turned(&self, from: Direction<'s>, turn: &AngleSum) -> Direction<'s> {
        let mut direction = from;
        for &(link, times) in &turn.links {
            let of_link = self.link(link).frame.direction;
            let factor = self.builder.integer(i64::from(times));
            direction = Direction {
                u: direction.u.turned(power(of_link.u, times)),
                omega: direction.omega + factor * of_link.omega,
                alpha: direction.alpha + factor * of_link.alpha,
                turned: None,
            };
        }
        let rest = self.jet(&turn.rest);
        if rest.is_zero() {
            return direction;
        }
        if let Scalar::Input(input) = turn.rest
            && let Some(unit) = self.inputs[input.index()].unit
        {
            return Direction { turned: None, ..direction.turned_by(rest, unit) };
        }
        direction.turned_by(rest, Vector { x: rest.value.cos(), y: rest.value.sin() })
    }
}

/// The direction at `times` its angle, by repeated squaring.
fn power<'s>(u: Vector<'s>, times: i32) -> Vector<'s> {
    let base = if times < 0 { u.conjugate() } else { u };
    let builder = u.x.builder();
    by_squaring(base, u64::from(times.unsigned_abs()), Vector::turned)
        .unwrap_or_else(|| Vector { x: builder.integer(1), y: builder.zero() })
}
