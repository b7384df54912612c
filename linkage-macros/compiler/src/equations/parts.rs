//! Parts shared by the groups: the place of a group, its solution, and the bar and the block of a dyad.

use crate::equations::jet::Jet;
use crate::equations::motion::{Direction, Frame, PointMotion, RelativeAngle};
use crate::equations::reactions::JacobianFactors;
use crate::equations::symbol::{GraphBuilder, Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::{Carrier, LinkId, Numerics};

/// Distance of a group from its limit.
#[derive(Clone, Copy)]
pub(super) struct LimitMeasures<'s> {
    /// Signed distance from the limit in metres; `None` for groups that have no reach to run
    /// out of.
    pub margin: Option<Jet<'s>>,
    /// Transmission angle, from 0 to π.
    pub transmission: Jet<'s>,
}

impl<'s> LimitMeasures<'s> {
    /// Measures of two slides: the angle between their directions, from its sine and cosine. Its rates are those
    /// of the angle from one to the other, times the sign of that.
    pub(super) fn of_directions(
        a: Direction<'s>,
        b: Direction<'s>,
        (sine, cosine): (Sym<'s>, Sym<'s>),
    ) -> Self {
        let ([ax, ay], [bx, by]) = (a.jets(), b.jets());
        let cross = Jet { value: sine, ..ax * by - ay * bx };
        let dot = Jet { value: cosine, ..ax * bx + ay * by };
        let size = cross.hypot(Jet::zero(sine.builder()));
        Self { margin: None, transmission: size.atan2(dot) }
    }
}

/// The root of what is negative out of reach; zero there, where it does not change. At the limit, zero itself,
/// it is a root, whose derivative is infinite. NaN stays NaN.
pub(super) fn root_in_reach(square: Jet<'_>) -> Jet<'_> {
    let (root, zero) = (square.sqrt(), square.value.builder().zero());
    let beyond = zero.at_least(square.value, zero, square.value);
    Jet { value: square.value.at_least(zero, root.value, beyond), ..root }
}

/// Discriminant of a group with an assembly mode and its error scale, for following a motion.
#[derive(Clone, Copy)]
pub(super) struct ClearanceTerms<'s> {
    pub value: Jet<'s>,
    pub scale: Sym<'s>,
}

/// The sum of the squares that the vector from one point to the other is made of: its rounding is
/// measured by them, not by its own length.
pub(super) fn size<'s>(from: PointMotion<'s>, to: PointMotion<'s>) -> Sym<'s> {
    let base = to.base - from.base;
    base.dot(base) + (from.offset.dot(from.offset) + to.offset.dot(to.offset))
}

/// The group whose failure a guard reports, its links, and how it is to compute.
pub(super) struct GroupScope<'s> {
    pub group: u32,
    pub title: &'s str,
    pub links: &'s [LinkId],
    pub numerics: Numerics,
    pub builder: &'s GraphBuilder<'s>,
}

impl<'s> GroupScope<'s> {
    /// A quotient of a root that may not vanish. As a product of the root and the inverse of its square it would be
    /// rounded once more, and so would every rate.
    pub(super) fn over_root(&self, numerator: Sym<'s>, root: Sym<'s>) -> Sym<'s> {
        numerator / root.guarded_by(Check::Nonzero, self.group, &[])
    }

    /// The symbol under the letter that the derivation calls it by: in the generated code `h` of
    /// the group `BC, DC` is `bc_dc_h_`.
    pub(super) fn label(&self, letter: &str, symbol: Sym<'s>) -> Sym<'s> {
        self.builder.name(symbol, format!("{} {letter}", self.title));
        symbol
    }

    /// The same where the symbol is no local for the sake of its name.
    pub(super) fn note(&self, letter: &str, symbol: Sym<'s>) -> Sym<'s> {
        self.builder.note(symbol, format!("{} {letter}", self.title));
        symbol
    }

    pub(super) fn call_vector(&self, letter: &str, vector: Vector<'s>) -> Vector<'s> {
        self.label(&format!("{letter} x"), vector.x);
        self.label(&format!("{letter} y"), vector.y);
        vector
    }
}

/// A link's frame, and its slide where it slides.
#[derive(Clone, Copy)]
pub struct LinkMotion<'s> {
    pub frame: Frame<'s>,
    pub slide: Option<Jet<'s>>,
}

/// Placement by a driver or a dyad: its links in the order of the statement, and its pin.
pub(super) struct Solved<'s> {
    pub links: Vec<LinkMotion<'s>>,
    pub pin: Option<PointMotion<'s>>,
    /// By bar, from its outer joint to the pin.
    pub bars: Vec<Vector<'s>>,
    /// Factors of a dyad's Jacobian; none for a driver.
    pub levers: Option<Box<dyn JacobianFactors<'s> + 's>>,
}

/// A bar from its outer joint to the pin.
#[derive(Clone, Copy)]
pub(super) struct Bar<'s> {
    outer: PointMotion<'s>,
    /// From the outer joint to the pin.
    r: Vector<'s>,
    length: Jet<'s>,
    /// 1/l
    over_length: Sym<'s>,
    omega: Sym<'s>,
    alpha: Sym<'s>,
}

impl<'s> Bar<'s> {
    pub(super) fn new(
        outer: PointMotion<'s>,
        r: Vector<'s>,
        length: Jet<'s>,
        over_length: Sym<'s>,
    ) -> Self {
        let zero = r.x.builder().zero();
        Self { outer, r, length, over_length, omega: zero, alpha: zero }
    }

    /// From the outer joint to the pin.
    pub(super) fn vector(self) -> Vector<'s> {
        self.r
    }

    /// True if the outer joint stands still.
    pub(super) fn stands(self) -> bool {
        self.outer.is_fixed()
    }

    pub(super) fn turning(self, omega: Sym<'s>, alpha: Sym<'s>) -> Self {
        Self { omega, alpha, ..self }
    }

    /// The unit vector from the outer joint to the pin.
    fn u(self) -> Vector<'s> {
        self.over_length * self.r
    }

    /// The pin's velocity but for the bar's turning: v + l̇ u.
    pub(super) fn pushed_velocity(self) -> Vector<'s> {
        self.outer.velocity + self.length.rate * self.u()
    }

    /// The pin's acceleration but for the bar's turning: a + l̈ u + 2 ω l̇ u⊥.
    pub(super) fn lengthening_acceleration(self, omega: Sym<'s>) -> Vector<'s> {
        let coriolis = (omega * self.length.rate).twice() * self.u().normal();
        self.outer.acceleration + (self.length.accel * self.u() + coriolis)
    }

    /// The pin's acceleration but for the angular one: a + l̈ u + 2 ω l̇ u⊥ − ω² r.
    pub(super) fn pushed_acceleration(self, omega: Sym<'s>) -> Vector<'s> {
        self.lengthening_acceleration(omega) - omega.squared() * self.r
    }

    /// The pin at the bar's end.
    pub(super) fn pin(self) -> PointMotion<'s> {
        PointMotion {
            base: self.outer.base,
            offset: self.outer.offset + self.r,
            velocity: self.pushed_velocity() + self.omega * self.r.normal(),
            acceleration: self.pushed_acceleration(self.omega) + self.alpha * self.r.normal(),
            swing: None,
            radius: self.outer.radius.zip(self.length.value.constant_value()).map(|(r, l)| r + l),
        }
    }

    /// The bar as a link: origin at its outer joint, x towards the pin.
    pub(super) fn link(self, link: LinkId) -> LinkMotion<'s> {
        let direction = Direction {
            u: self.u(),
            omega: self.omega,
            alpha: self.alpha,
            turned: Some(RelativeAngle::start(Carrier::Link(link), self.r.x.builder())),
        };
        LinkMotion { frame: Frame { origin: self.outer, direction }, slide: None }
    }
}

/// A block on a guide, at a known slide.
#[derive(Clone, Copy)]
pub(super) struct Block<'s> {
    guide: Frame<'s>,
    /// From the guide's origin to the block's pin.
    rho: Vector<'s>,
    offset: Jet<'s>,
}

impl<'s> Block<'s> {
    pub(super) fn new(guide: Frame<'s>, slide: Sym<'s>, offset: Jet<'s>) -> Self {
        Self { guide, rho: guide.vector(slide, offset.value), offset }
    }

    pub(super) fn direction(self) -> Vector<'s> {
        self.guide.direction.u
    }

    /// The pin's velocity but for the slide's: transport and changing offset.
    pub(super) fn carried_velocity(self) -> Vector<'s> {
        let zero = self.rho.x.builder().zero();
        let sigma = self.guide.vector(zero, self.offset.rate);
        self.guide.transport(self.rho, sigma).0 + sigma
    }

    /// The pin's acceleration but for the slide's own: transport, Coriolis and changing offset.
    pub(super) fn carried_acceleration(self, slide_rate: Sym<'s>) -> Vector<'s> {
        let sigma = self.guide.vector(slide_rate, self.offset.rate);
        let zero = self.rho.x.builder().zero();
        self.guide.transport(self.rho, sigma).1 + self.guide.vector(zero, self.offset.accel)
    }

    /// The pin, its slide's rates and its carried acceleration being known.
    pub(super) fn pin(
        self,
        slide_rate: Sym<'s>,
        slide_accel: Sym<'s>,
        carried: Vector<'s>,
    ) -> PointMotion<'s> {
        let u = self.direction();
        PointMotion {
            base: self.guide.origin.base,
            offset: self.guide.origin.offset + self.rho,
            velocity: self.carried_velocity() + slide_rate * u,
            acceleration: carried + slide_accel * u,
            swing: None,
            radius: None,
        }
    }

    /// The pin's position against a point of the ground.
    pub(super) fn offset_from(self, base: Vector<'s>) -> Vector<'s> {
        (self.guide.origin.base - base) + (self.guide.origin.offset + self.rho)
    }
}
