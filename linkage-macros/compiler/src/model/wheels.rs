//! Cranks that are coupled by a ratio: gears, and what turns as gears do.
//!
//! Two wheels on one carrier touch at the pole of one against the other. It lies on the line of their centres, and the
//! ratio of their rates against the carrier says where.

use crate::exact::Exact;
use crate::model::expr::{Operator, Scalar};
use crate::model::mechanism::{
    AngleSum, Body, Carrier, Drive, Group, InputId, LinkId, Mechanism, PointId,
};

/// Two wheels that roll on each other.
pub struct Wheels {
    /// The body of each; the ground stands for a ring or a sun that does not turn.
    pub bodies: [Carrier; 2],
    pub centres: [PointId; 2],
    /// The rate of the second wheel over that of the first, against what carries both, which does not move: a number
    /// that is neither zero nor one, or an expression of parameters.
    pub ratio: Scalar,
}

/// A crank: its link, where it turns, the angle that is given and the body against which it is.
struct TurnedLink<'m> {
    link: LinkId,
    centre: PointId,
    angle: &'m AngleSum,
    relative_to: Carrier,
}

/// A number as a function of the inputs.
enum ByInputs {
    /// A multiple of one input, but for what does not move.
    Multiple(InputId, Scalar),
    /// It does not move.
    Still(Scalar),
}

/// The wheels of a mechanism.
struct Gearing<'m>(&'m Mechanism);

/// The pairs of wheels, in the order of their second ones.
pub fn wheels(mechanism: &Mechanism) -> Vec<Wheels> {
    Gearing(mechanism).pairs()
}

impl Gearing<'_> {
    /// The pairs of wheels, in the order of their second ones.
    fn pairs(&self) -> Vec<Wheels> {
        let cranks: Vec<TurnedLink<'_>> = self.0.group_steps().flat_map(cranks_of).collect();
        let pairs = cranks.iter().enumerate().filter_map(|(nth, crank)| {
            let before = &cranks[..nth];
            match crank.relative_to {
                Carrier::Ground => self.on_the_ground(crank, before),
                Carrier::Link(carrier) => self.planet(crank, carrier, before),
            }
        });
        let is_rolling = |wheels: &Wheels| {
            let is_none = match &wheels.ratio {
                Scalar::Constant(ratio) => ratio.is_zero() || ratio.is_one(),
                _ => false,
            };
            !is_none && wheels.centres[0] != wheels.centres[1]
        };
        pairs.filter(is_rolling).collect()
    }

    /// Two cranks that turn on the ground.
    fn on_the_ground(&self, crank: &TurnedLink<'_>, before: &[TurnedLink<'_>]) -> Option<Wheels> {
        let (first, ratio) = match crank.angle.links[..] {
            [(first, times)] => {
                self.is_still(&crank.angle.rest).then_some(())?;
                (first, whole(times.into()))
            }
            [] => before.iter().find_map(|first| {
                let is_alike = first.relative_to == Carrier::Ground;
                Some((first.link, self.ratio(first, crank).filter(|_| is_alike)?))
            })?,
            _ => return None,
        };
        let centre = self.centre_of(first)?;
        let stand = [centre, crank.centre].iter().all(|&at| self.0.owner(at) == Some(Body::Ground));
        stand.then_some(Wheels {
            bodies: [Carrier::Link(first), Carrier::Link(crank.link)],
            centres: [centre, crank.centre],
            ratio,
        })
    }

    /// A crank on another that turns on the ground: it rolls on a wheel that stands, and that the carrier sees turn back.
    fn planet(
        &self,
        crank: &TurnedLink<'_>,
        carrier: LinkId,
        before: &[TurnedLink<'_>],
    ) -> Option<Wheels> {
        let ratio = match crank.angle.links[..] {
            [(of, times)] if of == carrier && self.is_still(&crank.angle.rest) => {
                whole(times.into())
            }
            [] => {
                let arm = before.iter().find(|arm| arm.link == carrier)?;
                self.ratio(arm, crank).filter(|_| arm.relative_to == Carrier::Ground)?
            }
            _ => return None,
        };
        let centre = self.centre_of(carrier)?;
        (self.0.owner(centre) == Some(Body::Ground)).then(|| Wheels {
            bodies: [Carrier::Ground, Carrier::Link(crank.link)],
            centres: [centre, crank.centre],
            ratio: ratio.negated(),
        })
    }

    /// The point that a link turns about.
    fn centre_of(&self, link: LinkId) -> Option<PointId> {
        let group = self.0.group_with(link)?;
        group.outer.iter().find(|joint| joint.link() == link)?.point()
    }

    /// The rate of the second over that of the first, where both are multiples of one input.
    fn ratio(&self, first: &TurnedLink<'_>, second: &TurnedLink<'_>) -> Option<Scalar> {
        match [first, second].map(|crank| self.turned_by_an_input(crank)) {
            [Some((input, by)), Some((other, times))] if input == other => {
                times.combined(Operator::Div, by)
            }
            _ => None,
        }
    }

    fn turned_by_an_input(&self, crank: &TurnedLink<'_>) -> Option<(InputId, Scalar)> {
        match self.line(&crank.angle.rest)? {
            ByInputs::Multiple(input, times) if crank.angle.links.is_empty() => {
                Some((input, times))
            }
            _ => None,
        }
    }

    fn is_still(&self, number: &Scalar) -> bool {
        !self.0.moves(number)
    }

    fn line(&self, number: &Scalar) -> Option<ByInputs> {
        match number {
            Scalar::Input(input) => Some(ByInputs::Multiple(*input, whole(1))),
            Scalar::Let(id) if self.0.lets[id.index()].links.is_empty() => {
                self.line(&self.0.lets[id.index()].rest)
            }
            Scalar::Negate(value) => Some(match self.line(value)? {
                ByInputs::Multiple(input, times) => ByInputs::Multiple(input, times.negated()),
                ByInputs::Still(value) => ByInputs::Still(value.negated()),
            }),
            Scalar::Chain(first, rest) => {
                rest.iter().try_fold(self.line(first)?, |a, (operator, b)| {
                    combined(a, *operator, self.line(b)?)
                })
            }
            _ => self.is_still(number).then(|| ByInputs::Still(number.clone())),
        }
    }
}

fn whole(number: i64) -> Scalar {
    Scalar::Constant(Exact::integer(number))
}

fn combined(a: ByInputs, operator: Operator, b: ByInputs) -> Option<ByInputs> {
    use ByInputs::{Multiple, Still};
    use Operator::{Add, Div, Mul, Sub};
    Some(match (a, operator, b) {
        (Multiple(input, times), Add | Sub, Still(_)) | (Still(_), Add, Multiple(input, times)) => {
            Multiple(input, times)
        }
        (Still(_), Sub, Multiple(input, times)) => Multiple(input, times.negated()),
        (Multiple(input, a), Add | Sub, Multiple(other, b)) if input == other => {
            Multiple(input, a.combined(operator, b)?)
        }
        (Multiple(input, times), Mul | Div, Still(by))
        | (Still(by), Mul, Multiple(input, times)) => {
            Multiple(input, times.combined(operator, by)?)
        }
        (Still(a), operator, Still(b)) => Still(a.combined(operator, b)?),
        _ => return None,
    })
}

fn cranks_of(group: &Group) -> impl Iterator<Item = TurnedLink<'_>> {
    group.outer.iter().filter_map(|joint| match &joint.drive {
        Some(Drive::Angle { angle, relative_to }) => Some(TurnedLink {
            link: joint.link(),
            centre: joint.point()?,
            angle,
            relative_to: *relative_to,
        }),
        _ => None,
    })
}
