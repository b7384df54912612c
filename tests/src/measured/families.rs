//! Poses at a given distance from a limit, of any proportion and direction, at any place.

use core::f64::consts::TAU;

use super::Pose;
use super::poses::Source;
use crate::mechanisms::near_limits::{ChainedBars, ChainedPress};

/// A pose `gap` from the limit, as a share of the longest length or in radians.
pub type Family<const I: usize, const P: usize> = fn(&mut Source, f64) -> Pose<I, P>;

fn moving<const I: usize, const P: usize>(
    source: &mut Source,
    q: [f64; I],
    params: [f64; P],
) -> Pose<I, P> {
    let rates = |source: &mut Source| q.map(|_| source.between(-1.0, 1.0));
    Pose { q, rate: rates(source), second: rates(source), params, plus: source.coin() }
}

fn apart(source: &mut Source, d: f64) -> [f64; 4] {
    let (x, y) = (source.between(-1.0, 1.0), source.between(-1.0, 1.0));
    let turn = source.angle();
    [x, y, x + d * turn.cos(), y + d * turn.sin()]
}

pub fn stretched(source: &mut Source, gap: f64) -> Pose<4, 2> {
    let l = [source.between(0.3, 3.0), source.between(0.3, 3.0)];
    let q = apart(source, (l[0] + l[1]) * (1.0 - gap));
    moving(source, q, l)
}

/// With the first joint at the origin, so that the line of centres is exact.
pub fn stretched_from_origin(source: &mut Source, gap: f64) -> Pose<4, 2> {
    from_origin(stretched(source, gap))
}

/// The same of [`folded`].
pub fn folded_from_origin(source: &mut Source, gap: f64) -> Pose<4, 2> {
    from_origin(folded(source, gap))
}

fn from_origin<const P: usize>(pose: Pose<4, P>) -> Pose<4, P> {
    let [x, y, dx, dy] = pose.q;
    Pose { q: [0.0, 0.0, dx - x, dy - y], ..pose }
}

pub fn folded(source: &mut Source, gap: f64) -> Pose<4, 2> {
    let l = [source.between(1.5, 3.0), source.between(0.3, 1.2)];
    let q = apart(source, (l[0] - l[1]) * (1.0 + gap));
    moving(source, q, l)
}

/// Bars of one length whose outer joints come together.
pub fn collapsed(source: &mut Source, gap: f64) -> Pose<4, 2> {
    let l = source.between(0.3, 3.0);
    let turn = source.angle();
    let q = [0.0, 0.0, gap * turn.cos(), gap * turn.sin()];
    moving(source, q, [l, l])
}

pub fn square_to_guide(source: &mut Source, gap: f64) -> Pose<5, 2> {
    let (l, e) = (source.between(0.5, 3.0), source.between(-1.0, 1.0));
    let (kx, ky, phi) = (source.between(-1.0, 1.0), source.between(-1.0, 1.0), source.angle());
    let side = if source.coin() { 1.0 } else { -1.0 };
    let (x, y) = (source.between(-2.0, 2.0), e - side * l * (1.0 - gap));
    let (sin, cos) = phi.sin_cos();
    moving(source, [kx + x * cos - y * sin, ky + x * sin + y * cos, kx, ky, phi], [l, e])
}

pub fn at_offset(source: &mut Source, gap: f64) -> Pose<4, 1> {
    let e = source.between(0.3, 2.0);
    let [x, y, bx, by] = apart(source, e * (1.0 + gap));
    moving(source, [bx, by, x, y], [e])
}

pub fn over_pivot(source: &mut Source, gap: f64) -> Pose<4, 1> {
    let turn = source.angle();
    moving(source, [gap * turn.cos(), gap * turn.sin(), 0.0, 0.0], [0.0])
}

pub fn parallel_guides(source: &mut Source, gap: f64) -> Pose<6, 2> {
    let phi = source.between(-TAU / 4.0, TAU / 4.0);
    let at = [0; 4].map(|_| source.between(-1.0, 1.0));
    let e = [source.between(-0.5, 0.5), source.between(-0.5, 0.5)];
    moving(source, [at[0], at[1], phi, at[2], at[3], phi + gap], e)
}

pub fn slot_along_rail(source: &mut Source, gap: f64) -> Pose<5, 3> {
    let at = [0; 4].map(|_| source.between(-1.0, 1.0));
    let phi = source.angle();
    let e = [source.between(-0.5, 0.5), source.between(-0.5, 0.5)];
    moving(source, [at[0], at[1], at[2], at[3], phi], [gap, e[0], e[1]])
}

/// The rod is as long as its outer joint is far from the guide, but for the gap.
pub fn chained_rod(source: &mut Source, gap: f64) -> Pose<1, 12> {
    let (theta, long) = (source.angle(), ChainedPress { rod: 10.0, ..ChainedPress::new() });
    let joint = long.position(theta).expect("a long rod reaches").E;
    let (sin, cos) = long.slope.sin_cos();
    let distance = long.e - (cos * (joint.y - long.ky) - sin * (joint.x - long.kx));
    let ChainedPress { dx, dy, kx, ky, slope, crank_length, coupler, rocker, ex, ey, e, .. } = long;
    let rod = distance.abs() * (1.0 + gap);
    moving(source, [theta], [rod, dx, dy, kx, ky, slope, crank_length, coupler, rocker, ex, ey, e])
}

/// The bars span the distance of their outer joints, but for the gap.
pub fn chained_stretched(source: &mut Source, gap: f64) -> Pose<1, 9> {
    let (theta, long) = (source.angle(), ChainedBars { l1: 9.0, l2: 9.0, ..ChainedBars::new() });
    let joint = long.position(theta).expect("long bars reach").C;
    let ChainedBars { dx, dy, gx, gy, crank_length, coupler, rocker, .. } = long;
    let span = (gx - joint.x).hypot(gy - joint.y) * (1.0 + gap);
    let l1 = span * source.between(0.3, 0.7);
    moving(source, [theta], [l1, span - l1, dx, dy, gx, gy, crank_length, coupler, rocker])
}
