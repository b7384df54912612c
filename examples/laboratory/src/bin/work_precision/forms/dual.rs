//! Only the position by hand, velocity and acceleration by num-dual: θ(t) with its first two
//! rates goes in, and comes out of every output.

use laboratory::hand::Dyad;
use laboratory::number::Number;
use num_dual::{Dual2, DualNum, DualNumFloat};

use super::{Block, Form, Link, Point};

/// Numbers whose derivatives num-dual can carry.
pub(crate) trait Base: Number + DualNumFloat + DualNum<Primitive = Self> {}
impl Base for f32 {}
impl Base for f64 {}

#[derive(Clone, Copy)]
pub(crate) struct Dual;

/// A point, or the unit vector of a link.
#[derive(Clone, Copy)]
pub(crate) struct Pair<F: Base>([Dual2<F>; 2]);

#[inline(always)]
fn squared<F: Base>([x, y]: [Dual2<F>; 2]) -> Dual2<F> {
    x * x + y * y
}

/// The vector at (x, y) of a link's axes.
#[inline(always)]
fn vector<F: Base>(Pair([ux, uy]): Pair<F>, [x, y]: [f64; 2]) -> [Dual2<F>; 2] {
    let along = [ux * F::of(x), uy * F::of(x)];
    if y == 0.0 { along } else { [along[0] - uy * F::of(y), along[1] + ux * F::of(y)] }
}

impl<F: Base> Form<F> for Dual {
    type Link = Pair<F>;

    /// The crank's pin at θ + ω t + α t²/2.
    #[inline(always)]
    fn crank(&self, [angle, omega, alpha]: [F; 3], length: f64) -> Pair<F> {
        let (sin, cos) = Dual2::new(angle, omega, alpha).sin_cos();
        Pair([cos * F::of(length), sin * F::of(length)])
    }

    #[inline(always)]
    fn dyad(&mut self, _: usize, Pair(b): Pair<F>, dyad: Dyad) -> Option<[Pair<F>; 2]> {
        let ([l2, l3], [x, y]) = (dyad.lengths, dyad.pivot);
        let d = [-b[0] + F::of(x), -b[1] + F::of(y)];
        let inverse = DualNum::recip(&squared(d));
        let along = inverse * F::of((l2 * l2 - l3 * l3) / 2.0) + F::of(0.5);
        let across = inverse * F::of(l2 * l2) - along * along;
        if across.re <= F::of(0.0) {
            return None;
        }
        let across = DualNum::sqrt(&across);
        let r2 = [d[0] * along - d[1] * across, d[1] * along + d[0] * across];
        let r3 = [r2[0] - d[0], r2[1] - d[1]];
        Some([(r2, l2), (r3, l3)].map(|(r, length)| Pair(r.map(|x| x * F::of(1.0 / length)))))
    }
}

impl<F: Base> Block<F> for Dual {
    #[inline(always)]
    fn block(&mut self, Pair(b): Pair<F>, [x, y]: [f64; 2]) -> Option<(Pair<F>, [F; 3])> {
        let from = [b[0] - F::of(x), b[1] - F::of(y)];
        let square = squared(from);
        if square.re <= F::of(0.0) {
            return None;
        }
        let slide = DualNum::sqrt(&square);
        let inverse = DualNum::recip(&slide);
        Some((Pair(from.map(|x| x * inverse)), [slide.re, slide.v1, slide.v2]))
    }
}

impl<F: Base> Link<F> for Pair<F> {
    type Point = Self;

    #[inline(always)]
    fn on(self, Self([x, y]): Self, at: [f64; 2]) -> Self {
        let r = vector(self, at);
        Self([x + r[0], y + r[1]])
    }

    #[inline(always)]
    fn about(self, [x, y]: [f64; 2], at: [f64; 2]) -> Self {
        let r = vector(self, at);
        Self([r[0] + F::of(x), r[1] + F::of(y)])
    }

    /// ω from u × u̇, α from u × ü.
    #[inline(always)]
    fn direction(self) -> ([F; 2], F, F) {
        let [x, y] = self.0;
        ([x.re, y.re], x.re * y.v1 - y.re * x.v1, x.re * y.v2 - y.re * x.v2)
    }
}

impl<F: Base> Point<F> for Pair<F> {
    #[inline(always)]
    fn orders(self) -> [[F; 2]; 3] {
        let [x, y] = self.0;
        [[x.re, y.re], [x.v1, y.v1], [x.v2, y.v2]]
    }
}
