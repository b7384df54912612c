//! Only the position by hand, velocity and acceleration by num-dual: θ(t) with its first two
//! rates goes in, and comes out of every output.

use num_dual::{Dual2, DualNum, DualNumFloat};

use crate::mechanisms::{CHAIN_DYADS, Dyad, ROCKER, STEPHENSON_DYADS};
use crate::number::Number;

/// Numbers whose derivatives num-dual can carry.
pub(crate) trait Base: Number + DualNumFloat + DualNum<Primitive = Self> {}
impl Base for f32 {}
impl Base for f64 {}

type Pair<F> = [Dual2<F>; 2];

/// The crank's pin at θ + ω t + α t²/2.
fn crank<F: Base>([angle, omega, alpha]: [F; 3], length: f64) -> Pair<F> {
    let (sin, cos) = Dual2::new(angle, omega, alpha).sin_cos();
    [cos * F::of(length), sin * F::of(length)]
}

fn squared<F: Base>([x, y]: Pair<F>) -> Dual2<F> {
    x * x + y * y
}

/// The unit vectors of both bars.
fn dyad<F: Base>(b: Pair<F>, Dyad { pivot, lengths }: Dyad) -> Option<[Pair<F>; 2]> {
    let (l2, l3) = lengths;
    let d = [-b[0] + F::of(pivot.0), -b[1] + F::of(pivot.1)];
    let inverse = DualNum::recip(&squared(d));
    let along = inverse * F::of((l2 * l2 - l3 * l3) / 2.0) + F::of(0.5);
    let across = inverse * F::of(l2 * l2) - along * along;
    if across.re <= F::of(0.0) {
        return None;
    }
    let across = DualNum::sqrt(&across);
    let r2 = [d[0] * along - d[1] * across, d[1] * along + d[0] * across];
    let r3 = [r2[0] - d[0], r2[1] - d[1]];
    Some([r2.map(|x| x * F::of(1.0 / l2)), r3.map(|x| x * F::of(1.0 / l3))])
}

/// The vector with the components (x, y) in a link's axes.
fn vector<F: Base>(u: Pair<F>, x: f64, y: f64) -> Pair<F> {
    let (x, y) = (F::of(x), F::of(y));
    [u[0] * x - u[1] * y, u[1] * x + u[0] * y]
}

fn about<F: Base>(pivot: (f64, f64), r: Pair<F>) -> Pair<F> {
    [r[0] + F::of(pivot.0), r[1] + F::of(pivot.1)]
}

/// ω from u × u̇, α from u × ü.
fn turning<F: Base>(u: Pair<F>) -> [F; 2] {
    [u[0].re * u[1].v1 - u[1].re * u[0].v1, u[0].re * u[1].v2 - u[1].re * u[0].v2]
}

#[inline(always)]
pub(crate) fn four_bar<F: Base>(input: [F; 3]) -> Option<[F; 14]> {
    let b = crank(input, 0.1016);
    let [bc, dc] = dyad(b, ROCKER)?;
    let r = vector(bc, 0.15, 0.05);
    let [x, y] = [b[0] + r[0], b[1] + r[1]];
    let ([w2, a2], [w3, a3]) = (turning(bc), turning(dc));
    #[rustfmt::skip]
    let out = [
        x.re, y.re, bc[0].re, bc[1].re, dc[0].re, dc[1].re,
        x.v1, y.v1, w2, w3, x.v2, y.v2, a2, a3,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn six_bar<F: Base>(input: [F; 3]) -> Option<[F; 13]> {
    let b = crank(input, 0.4);
    let from = about((0.0, 1.0), b);
    let square = squared(from);
    if square.re <= F::of(0.0) {
        return None;
    }
    let slide = DualNum::sqrt(&square);
    let inverse = DualNum::recip(&slide);
    let u = from.map(|x| x * inverse);
    let [x, y] = about((0.0, -1.8), u.map(|x| x * F::of(1.6)));
    let [w, a] = turning(u);
    #[rustfmt::skip]
    let out = [
        u[0].re, u[1].re, slide.re, x.re, y.re,
        w, slide.v1, x.v1, y.v1, a, slide.v2, x.v2, y.v2,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn stephenson<F: Base>(input: [F; 3]) -> Option<[F; 16]> {
    let b = crank(input, 0.04);
    let [bc, _] = dyad(b, STEPHENSON_DYADS[0])?;
    let r = vector(bc, 0.07, 0.05);
    let p = [b[0] + r[0], b[1] + r[1]];
    let [_, fe] = dyad(p, STEPHENSON_DYADS[1])?;
    let e = about(STEPHENSON_DYADS[1].pivot, fe.map(|x| x * F::of(0.1)));
    let [w, a] = turning(fe);
    #[rustfmt::skip]
    let out = [
        p[0].re, p[1].re, e[0].re, e[1].re, fe[0].re, fe[1].re,
        p[0].v1, p[1].v1, e[0].v1, e[1].v1, w, p[0].v2, p[1].v2, e[0].v2, e[1].v2, a,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn chain<F: Base>(input: [F; 3]) -> Option<[F; 10]> {
    let [d1, d2, d3, d4] = CHAIN_DYADS;
    let [_, rocker] = dyad(crank(input, 0.04), d1)?;
    let [_, rocker] = dyad(about(d1.pivot, vector(rocker, 0.06, 0.02)), d2)?;
    let [_, rocker] = dyad(about(d2.pivot, vector(rocker, 0.06, 0.02)), d3)?;
    let [_, u] = dyad(about(d3.pivot, vector(rocker, 0.06, 0.02)), d4)?;
    let [x, y] = about(d4.pivot, u.map(|x| x * F::of(0.09)));
    let [w, a] = turning(u);
    Some([x.re, y.re, u[0].re, u[1].re, x.v1, y.v1, w, x.v2, y.v2, a])
}
