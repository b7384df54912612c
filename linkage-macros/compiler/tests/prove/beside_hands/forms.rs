//! The two ways by which a hand writes closed forms.

use super::plane::{Crank, Dyad, Link, Moving, Rail, Slide, Vector};
use crate::prove::computed::Float;

/// A way to write formulas. All groups are asked within their reach.
pub(super) trait Form<T: Float> {
    /// The pin of a crank.
    fn pin(&self, crank: Crank<T>) -> Moving<T>;

    /// Two bars from a pin and a pivot.
    fn dyad(&self, pin: Moving<T>, dyad: Dyad) -> [Link<T>; 2];

    /// A crank's pin and two bars behind it.
    fn crank_dyad(&self, crank: Crank<T>, dyad: Dyad) -> (Moving<T>, [Link<T>; 2]) {
        let pin = self.pin(crank);
        (pin, self.dyad(pin, dyad))
    }

    /// The bar about a pivot on which a block slides that is pinned to a crank, at this offset.
    fn block(&self, crank: Crank<T>, pivot: [f64; 2], offset: f64) -> (Link<T>, Slide<T>);

    /// The bar from a crank's pin to a block ahead on a rail, at this offset.
    fn rod(
        &self,
        crank: Crank<T>,
        rail: Rail,
        dimensions: [f64; 2],
    ) -> (Moving<T>, Link<T>, Slide<T>);

    /// The point at (x, y) of a link's axes.
    fn point(&self, origin: Moving<T>, link: Link<T>, at: [f64; 2]) -> Moving<T>;

    /// The unit vector along a link's x.
    fn direction(&self, link: Link<T>) -> Vector<T>;
}

/// As a textbook has it: circles intersected, velocities and accelerations by Cramer's rule, nothing fused.
pub(super) struct Straightforward;

impl Straightforward {
    fn dot<T: Float>(a: Vector<T>, b: Vector<T>) -> T {
        a.x * b.x + a.y * b.y
    }

    fn cross<T: Float>(a: Vector<T>, b: Vector<T>) -> T {
        a.x * b.y - a.y * b.x
    }

    fn carried<T: Float>(origin: Moving<T>, r: Vector<T>, link: Link<T>) -> Moving<T> {
        Moving {
            position: origin.position + r,
            velocity: origin.velocity + r.normal() * link.omega,
            acceleration: origin.acceleration
                + (r.normal() * link.alpha - r * (link.omega * link.omega)),
        }
    }
}

impl<T: Float> Form<T> for Straightforward {
    fn pin(&self, Crank { length, input: [angle, omega, alpha] }: Crank<T>) -> Moving<T> {
        let (sin, cos) = T::library_sin_cos(angle);
        let r = Vector { x: cos, y: sin } * T::of(length);
        Self::carried(Moving::still([0.0; 2]), r, Link { r, length, omega, alpha })
    }

    fn dyad(&self, pin: Moving<T>, Dyad { pivot, lengths: [l2, l3], side }: Dyad) -> [Link<T>; 2] {
        let of = T::of;
        let d = Vector::of(pivot) - pin.position;
        let square = Self::dot(d, d);
        let along = (square + of(l2 * l2 - l3 * l3)) / (of(2.0) * square);
        let across = of(l2 * l2) / square - along * along;
        let r2 = d * along + d.normal() * (of(side) * across.sqrt());
        let r3 = r2 - d;
        let inverse = of(1.0) / Self::cross(r2, r3);
        let (v, a) = (pin.velocity, pin.acceleration);
        let [omega2, omega3] = [-Self::dot(v, r3) * inverse, -Self::dot(v, r2) * inverse];
        let g = r2 * (omega2 * omega2) - r3 * (omega3 * omega3) - a;
        let [alpha2, alpha3] = [Self::dot(g, r3) * inverse, Self::dot(g, r2) * inverse];
        [
            Link { r: r2, length: l2, omega: omega2, alpha: alpha2 },
            Link { r: r3, length: l3, omega: omega3, alpha: alpha3 },
        ]
    }

    fn block(&self, crank: Crank<T>, pivot: [f64; 2], e: f64) -> (Link<T>, Slide<T>) {
        let (of, pin) = (T::of, self.pin(crank));
        let b = pin.position - Vector::of(pivot);
        let square = Self::dot(b, b);
        let slide = (square - of(e * e)).sqrt();
        let u = match e == 0.0 {
            true => b * (of(1.0) / slide),
            false => (b * slide - b.normal() * of(e)) * (of(1.0) / square),
        };
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = Self::dot(v, u.normal()) / slide;
        let turn = omega * omega;
        let [mut rate, mut second] = [Self::dot(v, u), Self::dot(a, u) + turn * slide];
        let mut across = Self::dot(a, u.normal());
        if e != 0.0 {
            rate = rate + omega * of(e);
            across = across + turn * of(e);
        }
        let alpha = (across - of(2.0) * omega * rate) / slide;
        if e != 0.0 {
            second = second + alpha * of(e);
        }
        (Link { r: u, length: 1.0, omega, alpha }, [slide, rate, second])
    }

    fn rod(
        &self,
        crank: Crank<T>,
        Rail { origin, direction }: Rail,
        [l, e]: [f64; 2],
    ) -> (Moving<T>, Link<T>, Slide<T>) {
        let (of, pin) = (T::of, self.pin(crank));
        let (u, rho) = (Vector::of(direction), pin.position - Vector::of(origin));
        let t = of(e) - Self::dot(rho, u.normal());
        let x = (of(l * l) - t * t).sqrt();
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = -Self::dot(v, u.normal()) / x;
        let turn = omega * omega;
        let alpha = (turn * t - Self::dot(a, u.normal())) / x;
        let slide = [
            Self::dot(rho, u) + x,
            Self::dot(v, u) - omega * t,
            Self::dot(a, u) - alpha * t - turn * x,
        ];
        (pin, Link { r: u * x + u.normal() * t, length: l, omega, alpha }, slide)
    }

    fn point(&self, origin: Moving<T>, link: Link<T>, [x, y]: [f64; 2]) -> Moving<T> {
        let u = Form::<T>::direction(self, link);
        let along = u * T::of(x);
        let r = if y == 0.0 { along } else { along + u.normal() * T::of(y) };
        Self::carried(origin, r, link)
    }

    fn direction(&self, link: Link<T>) -> Vector<T> {
        link.r * (T::of(1.0) / T::of(link.length))
    }
}
