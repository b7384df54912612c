//! Blocks on links that turn: on a swinging bar, and on guides of a bar or a crank.

use super::dyads::Joint;
use super::fused;
use super::plane::{Bar, Moving, Vector};
use super::rails::{Rail, Rod, Seen, Slide};

/// A direction that turns.
#[derive(Clone, Copy, Debug)]
pub struct Turning<F = f64> {
    /// A unit vector.
    pub u: Vector<F>,
    /// In rad/s.
    pub omega: F,
    /// In rad/s².
    pub alpha: F,
}

impl Turning {
    /// The unit vector, as of a bar.
    #[inline(always)]
    #[must_use]
    pub fn direction(self) -> Vector {
        self.u
    }

    /// The point (x, y) of its axes about a point of the ground.
    #[inline(always)]
    #[must_use]
    pub fn point_about(self, pivot: [f64; 2], [x, y]: [f64; 2]) -> Moving {
        let Vector { x: c, y: s } = self.u;
        let r = Vector { x: fused(x, c, -(y * s)), y: fused(x, s, y * c) };
        Moving::about(pivot, r, self.omega, self.alpha)
    }
}

/// A bar through a point of the ground and the pin of a crank on the origin, where a block slides on it.
///
/// With the arm a of the crank and the pivot G, b = a − G: b² = G² + a² − 2 G·a, a·b = a² − G·a and
/// a × b = G × a are affine in two products, and do not wait for a sum of squares.
#[inline(always)]
#[must_use]
pub fn crank_block(
    crank: f64,
    [gx, gy]: [f64; 2],
    [cos, sin]: [f64; 2],
    [omega, alpha]: [f64; 2],
    sense: f64,
) -> Option<(Turning, Slide)> {
    let arm = Vector { x: crank * cos, y: crank * sin };
    let along = if gy == 0.0 { gx * arm.x } else { fused(gx, arm.x, gy * arm.y) };
    let square = fused(-2.0, along, gx * gx + gy * gy + crank * crank);
    if !(square > 0.0) {
        return None;
    }
    let value = sense * square.sqrt();
    let inverse = value * (1.0 / square);
    let dy = if gy == 0.0 { arm.y } else { arm.y - gy };
    let u = Vector { x: (arm.x - gx) * inverse, y: dy * inverse };
    let aside = if gy == 0.0 { gx * arm.y } else { fused(gx, arm.y, -(gy * arm.x)) };
    let [dot, cross] = [(crank * crank - along) * inverse, aside * inverse];
    let turning = omega * dot * inverse;
    let rate = omega * cross;
    let square_rate = omega * omega;
    let accel = [fused(alpha, cross, -(square_rate * dot)), fused(alpha, dot, square_rate * cross)];
    let turning_rate = fused(-(turning + turning), rate, accel[1]) * inverse;
    let second = fused(turning * turning, value, accel[0]);
    Some((Turning { u, omega: turning, alpha: turning_rate }, Slide { value, rate, second }))
}

/// A bar about a point of the ground through a block on any pin, which keeps an offset from it; none
/// where the offset is too large.
#[inline(always)]
#[must_use]
pub fn block(pin: Moving, [gx, gy]: [f64; 2], e: f64, sense: f64) -> Option<(Turning, Slide)> {
    let b = Vector { x: pin.position.x - gx, y: pin.position.y - gy };
    let square = b.dot(b);
    let left = fused(-e, e, square);
    if !(left > 0.0) {
        return None;
    }
    let value = sense * left.sqrt();
    let (inverse, share) = (value * (1.0 / left), 1.0 / square);
    let (s, e_share) = (value * share, e * share);
    let u = Vector { x: fused(s, b.x, e_share * b.y), y: fused(s, b.y, -(e_share * b.x)) };
    let (v, a) = (pin.velocity, pin.acceleration);
    let omega = u.cross(v) * inverse;
    let rate = v.dot(b) * inverse;
    let p = omega * omega;
    let alpha = fused(-(omega + omega), rate, fused(p, e, u.cross(a))) * inverse;
    let second = fused(alpha, e, fused(p, value, a.dot(u)));
    Some((Turning { u, omega, alpha }, Slide { value, rate, second }))
}

/// A guide of a bar: its origin and its direction, which turns as the bar does.
#[derive(Clone, Copy, Debug)]
pub struct Guide {
    /// A point of the bar.
    pub origin: Moving,
    /// The direction.
    pub turning: Turning,
}

impl Guide {
    /// At the cosine and sine of its angle to a bar.
    #[inline(always)]
    #[must_use]
    pub fn on_bar(bar: Bar, origin: Moving, [cos, sin]: [f64; 2]) -> Self {
        let (c, s) = (cos / bar.length, sin / bar.length);
        let u = Vector { x: fused(c, bar.r.x, -(s * bar.r.y)), y: fused(c, bar.r.y, s * bar.r.x) };
        Self { origin, turning: Turning { u, omega: bar.omega, alpha: bar.alpha } }
    }

    /// A joint seen from a guide that turns: what both have in common never enters.
    #[inline(always)]
    fn sees(self, joint: Joint) -> Seen {
        let (k, Turning { u, omega, alpha }) = (self.origin, self.turning);
        let (rho, w, g) = match joint {
            Joint::Ground([x, y]) => {
                let rho = Vector { x: x - k.position.x, y: y - k.position.y };
                (rho, -k.velocity, -k.acceleration)
            }
            Joint::Link(b) => {
                (b.position - k.position, b.velocity - k.velocity, b.acceleration - k.acceleration)
            }
        };
        let (x, y) = (rho.dot(u), u.cross(rho));
        let velocity = [fused(omega, y, w.dot(u)), fused(-omega, x, u.cross(w))];
        let (square, twice) = (omega * omega, omega + omega);
        let acceleration = [
            fused(twice, velocity[1], fused(square, x, fused(alpha, y, g.dot(u)))),
            fused(-twice, velocity[0], fused(square, y, fused(-alpha, x, u.cross(g)))),
        ];
        Seen { place: [x, y], velocity, acceleration }
    }

    /// A bar from a joint to a block on the guide; none out of reach.
    #[inline(always)]
    #[must_use]
    pub fn rod(self, joint: Joint, rod: Rod) -> Option<(Bar, Slide)> {
        let ([x, t], [omega, alpha], slide) = rod.solve(self.sees(joint))?;
        let Turning { u, omega: turning, alpha: turning_rate } = self.turning;
        let r = Vector { x: fused(x, u.x, -(t * u.y)), y: fused(x, u.y, t * u.x) };
        let (omega, alpha) = (turning + omega, turning_rate + alpha);
        Some((Bar { r, length: rod.length, omega, alpha }, slide))
    }
}

/// Two blocks with one pin C, on a guide of a crank, through the crank's pin and at the angle with this
/// cosine and sine to it, and on a rail of the ground: the slides on both, and C.
///
/// With the crank on the origin the point of its guide under C moves with ω C⊥, of which C·u₂ is a slide
/// and C × u₂ a constant.
#[inline(always)]
#[must_use]
pub fn crossed(
    crank: f64,
    [cos, sin]: [f64; 2],
    [omega, alpha]: [f64; 2],
    [cos_guide, sin_guide]: [f64; 2],
    rail: Rail,
    [e1, e2]: [f64; 2],
) -> Option<([Slide; 2], Moving)> {
    let u1 = Vector {
        x: fused(cos_guide, cos, -(sin_guide * sin)),
        y: fused(cos_guide, sin, sin_guide * cos),
    };
    let u2 = Vector { x: rail.direction[0], y: rail.direction[1] };
    let sine = u1.cross(u2);
    if !(sine.abs() > 0.0) {
        return None;
    }
    let inverse = 1.0 / sine;
    let start = Vector { x: fused(-e2, u2.y, rail.origin[0]), y: fused(e2, u2.x, rail.origin[1]) };
    let k = Vector {
        x: start.x - fused(crank, cos, -(e1 * u1.y)),
        y: start.y - fused(crank, sin, e1 * u1.x),
    };
    let (s1, s2) = (k.cross(u2) * inverse, k.cross(u1) * inverse);
    let c = Vector { x: fused(s2, u2.x, start.x), y: fused(s2, u2.y, start.y) };
    let (with2, across2) = (s2 + start.dot(u2), start.cross(u2));
    let (with1, across1) = (c.dot(u1), c.cross(u1));
    let turning = omega * inverse;
    let (rate1, rate2) = (turning * with2, turning * with1);
    let (square, coriolis) = (omega * omega, (omega + omega) * rate1);
    let second1 = fused(coriolis, u1.dot(u2), fused(square, across2, alpha * with2)) * inverse;
    let second2 = (coriolis + fused(square, across1, alpha * with1)) * inverse;
    let pin = Moving { position: c, velocity: u2 * rate2, acceleration: u2 * second2 };
    let slides = [
        Slide { value: s1, rate: rate1, second: second1 },
        Slide { value: s2, rate: rate2, second: second2 },
    ];
    Some((slides, pin))
}
