//! Points, directions and frames that move, and the one formula by which a frame carries a point.

use crate::equations::jet::Jet;
use crate::equations::symbol::{GraphBuilder, Sym, Vector};
use crate::model::mechanism::Carrier;

/// Position, velocity and acceleration of a point.
///
/// The position is held as base + offset: the base is a point of the ground, the offset is built
/// from link vectors. Differences of points are formed base from base and offset from offset, so
/// a mechanism far from the origin loses nothing but the last digits of its coordinates.
#[derive(Clone, Copy)]
pub struct PointMotion<'s> {
    pub base: Vector<'s>,
    pub offset: Vector<'s>,
    pub velocity: Vector<'s>,
    pub acceleration: Vector<'s>,
    /// Where the point is known to turn about a point of the ground, its base.
    pub swing: Option<Swing<'s>>,
    /// A bound of the offset's length, where constants give one.
    pub radius: Option<f64>,
}

/// Rotation about a point of the ground: the velocity is ω r⊥, the acceleration α r⊥ − ω² r.
#[derive(Clone, Copy)]
pub struct Swing<'s> {
    pub omega: Sym<'s>,
    pub alpha: Sym<'s>,
    /// r, from that point.
    pub arm: Vector<'s>,
    /// Where it is in the frame that turns.
    coordinates: Vector<'s>,
}

impl<'s> Swing<'s> {
    /// r², from what does not turn.
    pub(crate) fn square(self) -> Sym<'s> {
        self.coordinates.dot(self.coordinates)
    }

    /// Velocity and acceleration along u and along u⊥, from p = r·u and q = r·u⊥. They are
    /// (−ω q, −α q − ω² p) and (ω p, α p − ω² q): two products with u in place of four.
    pub(crate) fn rates_along(self, [p, q]: [Sym<'s>; 2]) -> [Rates<'s>; 2] {
        let (Self { omega, alpha, .. }, square) = (self, self.omega.squared());
        [
            Rates { velocity: -(omega * q), acceleration: -(alpha * q + square * p) },
            Rates { velocity: omega * p, acceleration: alpha * p - square * q },
        ]
    }
}

/// Velocity and acceleration along a direction.
#[derive(Clone, Copy)]
pub(crate) struct Rates<'s> {
    pub velocity: Sym<'s>,
    pub acceleration: Sym<'s>,
}

/// A unit vector, its angular velocity and angular acceleration.
#[derive(Clone, Copy)]
pub struct Direction<'s> {
    pub u: Vector<'s>,
    pub omega: Sym<'s>,
    pub alpha: Sym<'s>,
    /// Where the direction was made by turning another's.
    pub turned: Option<RelativeAngle<'s>>,
}

/// Whose x a direction is turned from, and by which angle: two directions on one carrier enclose
/// the difference of their angles, however small it is. Constant turns are kept apart, so that
/// the angle between two directions of one moving link is a constant.
#[derive(Clone, Copy)]
pub struct RelativeAngle<'s> {
    carrier: Carrier,
    moving: Sym<'s>,
    constant: Sym<'s>,
}

impl<'s> RelativeAngle<'s> {
    /// The carrier's own x.
    pub(crate) fn start(carrier: Carrier, builder: &'s GraphBuilder<'s>) -> Self {
        Self { carrier, moving: builder.zero(), constant: builder.zero() }
    }

    fn by(self, angle: Sym<'s>) -> Self {
        if angle.is_constant() {
            Self { constant: self.constant + angle, ..self }
        } else {
            Self { moving: self.moving + angle, ..self }
        }
    }

    /// The angle to the other, where both are turned from one direction.
    fn angle_to(self, other: Self) -> Option<Sym<'s>> {
        (self.carrier == other.carrier)
            .then(|| (other.moving - self.moving) + (other.constant - self.constant))
    }
}

/// An origin and an x direction: a link, a guide, or the ground.
#[derive(Clone, Copy)]
pub struct Frame<'s> {
    pub origin: PointMotion<'s>,
    pub direction: Direction<'s>,
}

impl<'s> PointMotion<'s> {
    pub(crate) fn fixed(base: Vector<'s>) -> Self {
        let zero = base.x.builder().zero_vector();
        Self {
            base,
            offset: zero,
            velocity: zero,
            acceleration: zero,
            swing: None,
            radius: Some(0.0),
        }
    }

    /// A point of a frame that counts as the ground.
    pub(crate) fn placed(x: Jet<'s>, y: Jet<'s>) -> Self {
        if x.is_fixed() && y.is_fixed() {
            Self::fixed(Vector { x: x.value, y: y.value })
        } else {
            Self::driven(x, y)
        }
    }

    /// A point whose coordinates in ground axes are given.
    pub(crate) fn driven(x: Jet<'s>, y: Jet<'s>) -> Self {
        Self {
            base: x.value.builder().zero_vector(),
            offset: Vector { x: x.value, y: y.value },
            velocity: Vector { x: x.rate, y: y.rate },
            acceleration: Vector { x: x.accel, y: y.accel },
            swing: None,
            radius: None,
        }
    }

    pub fn position(self) -> Vector<'s> {
        self.base + self.offset
    }

    /// The coordinates in ground axes, with their rates.
    pub(crate) fn coordinates(self) -> [Jet<'s>; 2] {
        let (value, rate, accel) = (self.position(), self.velocity, self.acceleration);
        [
            Jet { value: value.x, rate: rate.x, accel: accel.x },
            Jet { value: value.y, rate: rate.y, accel: accel.y },
        ]
    }

    /// The vector from this point to the other.
    pub(crate) fn to(self, other: Self) -> Vector<'s> {
        (other.base - self.base) + (other.offset - self.offset)
    }

    /// The vector from this point to the other with its rates, coordinate by coordinate.
    pub(crate) fn jets_to(self, other: Self) -> [Jet<'s>; 2] {
        let value = self.to(other);
        let rate = other.velocity - self.velocity;
        let accel = other.acceleration - self.acceleration;
        [
            Jet { value: value.x, rate: rate.x, accel: accel.x },
            Jet { value: value.y, rate: rate.y, accel: accel.y },
        ]
    }

    /// Velocity and acceleration against the other point, along u and along u⊥.
    pub(crate) fn rates_against(self, other: Self, u: Vector<'s>) -> [Rates<'s>; 2] {
        match self.swing {
            Some(swing) if other.is_fixed() => {
                swing.rates_along([swing.arm.dot(u), swing.arm.dot(u.normal())])
            }
            _ => {
                let velocity = self.velocity - other.velocity;
                let acceleration = self.acceleration - other.acceleration;
                [u, u.normal()]
                    .map(|u| Rates { velocity: velocity.dot(u), acceleration: acceleration.dot(u) })
            }
        }
    }

    /// A bound from below of the distance to the other point, where constants give one.
    pub(crate) fn least_distance(self, other: Self) -> Option<f64> {
        let between = other.base - self.base;
        let apart = between.dot(between).constant_value()?.sqrt();
        Some(apart - self.radius? - other.radius?)
    }

    /// True if the point belongs to the ground.
    pub(crate) fn is_fixed(self) -> bool {
        self.offset.is_zero() && self.velocity.is_zero() && self.acceleration.is_zero()
    }
}

impl<'s> Direction<'s> {
    /// The ground's x.
    pub(crate) fn ground(builder: &'s GraphBuilder<'s>) -> Self {
        let (zero, one) = (builder.zero(), builder.integer(1));
        Self {
            u: Vector { x: one, y: zero },
            omega: zero,
            alpha: zero,
            turned: Some(RelativeAngle::start(Carrier::Ground, builder)),
        }
    }

    /// The direction at an angle to this one, whose cosine and sine are given with it.
    pub(crate) fn turned_by(self, angle: Jet<'s>, unit: Vector<'s>) -> Self {
        Self {
            u: self.u.turned(unit),
            omega: self.omega + angle.rate,
            alpha: self.alpha + angle.accel,
            turned: self.turned.map(|turned| turned.by(angle.value)),
        }
    }

    pub(crate) fn n(self) -> Vector<'s> {
        self.u.normal()
    }

    /// The unit vector with its rates: u̇ = ω n, ü = α n − ω² u.
    pub(crate) fn jets(self) -> [Jet<'s>; 2] {
        let rate = self.omega * self.n();
        let accel = self.alpha * self.n() - self.omega.squared() * self.u;
        [
            Jet { value: self.u.x, rate: rate.x, accel: accel.x },
            Jet { value: self.u.y, rate: rate.y, accel: accel.y },
        ]
    }

    /// Sine and cosine of the angle from this direction to the other. On a common carrier they
    /// come from the difference of the angles: the cross product of two rounded unit vectors
    /// would lose every digit that the angle between them is small by.
    pub(crate) fn sin_cos_to(self, other: Self) -> (Sym<'s>, Sym<'s>) {
        let angle = self.turned.zip(other.turned).and_then(|(mine, its)| mine.angle_to(its));
        match angle {
            Some(angle) => (angle.sin(), angle.cos()),
            None => (self.u.cross(other.u), self.u.dot(other.u)),
        }
    }
}

impl<'s> Frame<'s> {
    pub(crate) fn ground(builder: &'s GraphBuilder<'s>) -> Self {
        Self {
            origin: PointMotion::fixed(builder.zero_vector()),
            direction: Direction::ground(builder),
        }
    }

    /// True if the frame stands still.
    pub(crate) fn is_fixed(self) -> bool {
        let Direction { omega, alpha, .. } = self.direction;
        self.origin.is_fixed() && omega.is_zero() && alpha.is_zero()
    }

    /// The vector of the frame with the given coordinates.
    pub(crate) fn vector(self, x: Sym<'s>, y: Sym<'s>) -> Vector<'s> {
        x * self.direction.u + y * self.direction.n()
    }

    /// Transport terms of a point at ρ from the frame's origin that moves in the frame with the relative
    /// velocity σ: the transport velocity v + ω ρ⊥ and the transport and Coriolis acceleration a + α ρ⊥ −
    /// ω² ρ + 2 ω σ⊥ (any text on kinematics in moving frames, e.g. Norton, Design of Machinery, ch. 6 and
    /// 7). Both terms of ρ are added first: term by term takes up to a fifteenth more instructions where
    /// operations are not fused.
    pub(crate) fn transport(self, rho: Vector<'s>, sigma: Vector<'s>) -> (Vector<'s>, Vector<'s>) {
        let Direction { omega, alpha, .. } = self.direction;
        if let Some(swing) = self.swing() {
            return self.about_pivot(swing.arm + rho, sigma);
        }
        let velocity = self.origin.velocity + omega * rho.normal();
        let acceleration = self.origin.acceleration
            + (alpha * rho.normal() - omega.squared() * rho)
            + omega.twice() * sigma.normal();
        (velocity, acceleration)
    }

    /// The same of a place of the frame where a point is.
    pub(crate) fn transport_at(
        self,
        point: PointMotion<'s>,
        sigma: Vector<'s>,
    ) -> (Vector<'s>, Vector<'s>) {
        match self.swing() {
            Some(_) => self.about_pivot((point.base - self.origin.base) + point.offset, sigma),
            None => self.transport(self.origin.to(point), sigma),
        }
    }

    /// The swing of the origin, where the frame turns with it about one pivot.
    pub(crate) fn swing(self) -> Option<Swing<'s>> {
        let Direction { omega, alpha, .. } = self.direction;
        self.origin.swing.filter(|swing| swing.omega.id == omega.id && swing.alpha.id == alpha.id)
    }

    /// The transport at r from the pivot of a frame that swings: ω r⊥ and α r⊥ − ω² r + 2 ω σ⊥.
    fn about_pivot(self, r: Vector<'s>, sigma: Vector<'s>) -> (Vector<'s>, Vector<'s>) {
        let Direction { omega, alpha, .. } = self.direction;
        let acceleration = alpha * r.normal() - omega.squared() * r;
        (omega * r.normal(), acceleration + omega.twice() * sigma.normal())
    }

    /// The point at the coordinates (x, y) of the frame: P = O + x u + y n; its velocity and
    /// acceleration are the transport's plus the relative ones.
    pub fn place(self, x: Jet<'s>, y: Jet<'s>) -> PointMotion<'s> {
        let rho = self.vector(x.value, y.value);
        let sigma = self.vector(x.rate, y.rate);
        let (velocity, acceleration) = self.transport(rho, sigma);
        let Direction { omega, alpha, .. } = self.direction;
        let swings = self.origin.is_fixed() && [x, y].into_iter().all(Jet::is_fixed);
        PointMotion {
            base: self.origin.base,
            offset: self.origin.offset + rho,
            velocity: velocity + sigma,
            acceleration: acceleration + self.vector(x.accel, y.accel),
            swing: swings.then_some(Swing {
                omega,
                alpha,
                arm: rho,
                coordinates: Vector { x: x.value, y: y.value },
            }),
            radius: self.origin.radius.zip(length_of(x.value, y.value)).map(|(r, l)| r + l),
        }
    }
}

/// The length of a constant vector.
fn length_of(x: Sym<'_>, y: Sym<'_>) -> Option<f64> {
    Some(x.constant_value()?.hypot(y.constant_value()?))
}
