//! The traced unknown over the first drive as a curve, and fits of it: sums of Chebyshev polynomials by
//! interpolation in the nodes of a higher one, cut off.
//!
//! At a dead point the unknown turns back: φ = φₑ + c √(E − x) + …, and a polynomial comes near such
//! an end by 1/degree only. The slope of the equation falls to zero as √(E − x) as well, which
//! says where the end is. Once c √(E − x) is taken off, what is left is fitted to a part
//! 1/degree³.

use std::f64::consts::PI;

use super::fit::{DeadEnds, Following, Terms};
use super::near_dead;
use super::plane::root;
use super::trace::Sample;

/// The count of nodes of a Chebyshev sum, well above the degrees.
const NODES: usize = 48;
/// The count of points that a value between them is taken from.
const NEIGHBOURS: usize = 6;
/// The share of a stretch by which square roots go beyond an end that is no dead point.
const BEYOND: f64 = 0.02;

/// A motion over a stretch: the points of a curve in the order of the drive.
pub struct Curve {
    pub points: Vec<[f64; 2]>,
    pub turns: Option<i32>,
    pub is_angle: bool,
    pub dead: [Option<DeadPoint>; 2],
    /// The places next to dead points, with their distances from these.
    pub near: Vec<[f64; 2]>,
}

/// The terms of a fit beside those of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    Nothing,
    /// Square roots towards dead points at the ends.
    DeadEnds,
    /// Bends next to dead points as well.
    NearDead,
}

/// A dead point beside an end of the stretch, and the factor c of the root.
#[derive(Clone, Copy)]
pub struct DeadPoint {
    pub at: f64,
    pub factor: f64,
}

impl DeadPoint {
    /// From the poses at an end, the last one first.
    fn beside(poses: [&Sample<'_>; 3]) -> Option<Self> {
        let [x, y] = [poses.map(|pose| pose.drive), poses.map(|pose| pose.unknown)];
        Self::through(x, y, poses.map(|pose| pose.slope))
    }

    /// From drives, unknowns and slopes.
    pub fn through(x: [f64; 3], y: [f64; 3], slopes: [f64; 3]) -> Option<Self> {
        let [last, before, _] = slopes.map(|slope| slope * slope);
        let at = x[0] + (x[0] - x[1]) * last / (before - last);
        let is_beside = before > last && (at - x[0]).abs() < 2.0 * (x[0] - x[1]).abs();
        // The curve c r + b r² through three poses.
        let r = x.map(|x| root((at - x).abs()));
        let chord = |i: usize| (y[i] - y[i + 1]) / (r[i] - r[i + 1]);
        let bend = (chord(1) - chord(0)) / (r[2] - r[0]);
        let factor = chord(0) - bend * (r[0] + r[1]);
        (is_beside && factor.is_finite()).then_some(Self { at, factor })
    }
}

impl Curve {
    /// `None` where there are too few poses.
    pub(super) fn of(poses: &[Sample<'_>], turns: Option<i32>, is_angle: bool) -> Option<Self> {
        let [a, b, c, .., z, y, x] = poses else { return None };
        let points = poses.iter().map(|pose| [pose.drive, pose.unknown]).collect();
        let dead = match turns {
            None => [[a, b, c], [x, y, z]].map(DeadPoint::beside),
            Some(_) => [None; 2],
        };
        let near = if is_angle { near_dead::places(poses, turns.is_some()) } else { Vec::new() };
        Some(Self { points, turns, is_angle, dead, near })
    }

    /// The largest distance of a fit from the points.
    pub fn off(&self, fit: &Following) -> f64 {
        self.points.iter().map(|[at, value]| (fit.at(*at) - value).abs()).fold(0.0, f64::max)
    }

    /// The fit of a degree with these terms beside: `None` where there is no place for them.
    pub fn fitted(&self, (degree, beside): (usize, Beside)) -> Option<Following> {
        let has_dead_ends = self.dead.iter().any(Option::is_some);
        let has_roots = match beside {
            Beside::Nothing => false,
            Beside::DeadEnds if !has_dead_ends => return None,
            Beside::NearDead if self.near.is_empty() => return None,
            Beside::DeadEnds | Beside::NearDead => has_dead_ends,
        };
        let ends = [self.points[0][0], self.points[self.points.len() - 1][0]];
        let beyond = BEYOND * (ends[1] - ends[0]);
        let edge = |i: usize, outside: f64| match self.dead[i] {
            _ if !has_roots => ends[i],
            Some(dead) => dead.at,
            None => ends[i] + outside,
        };
        let (first, last) = (edge(0, -beyond), edge(1, beyond));
        let (middle, half) = ((first + last) / 2.0, (last - first) / 2.0);
        let least = half.cos();
        let mut terms = match self.is_angle {
            true => Terms::Turning {
                center: (1.0 + least) / 2.0,
                reach: (1.0 - least) / 2.0,
                even: Vec::new(),
                odd: Vec::new(),
                turns: self.turns.unwrap_or(0),
            },
            false => Terms::Sliding { reach: half, powers: Vec::new() },
        };
        let dead_ends = has_roots.then(|| self.dead_ends(&terms, half));
        let smooth = self.points.iter().map(|[at, value]| {
            let x = at - middle;
            [x, value - dead_ends.map_or(0.0, |ends| ends.at(terms.end(x)))]
        });
        let mut smooth: Vec<_> = smooth.collect();
        let mut near = Vec::new();
        if beside == Beside::NearDead {
            let places: Vec<_> =
                self.near.iter().map(|[at, width]| [at - middle, *width]).collect();
            near = near_dead::fitted(&smooth, &places, |x| sums(&terms, x, degree));
            for [x, value] in &mut smooth {
                *value -= near.iter().map(|near| near.at(*x)).sum::<f64>();
            }
        }
        terms = fitted(&terms, |x| between(&smooth, x), half, degree);
        Some(Following { middle, terms, ends: dead_ends, near })
    }

    /// The roots whose factors at both edges are those of the dead points.
    fn dead_ends(&self, terms: &Terms, half: f64) -> DeadEnds {
        let [_, odd] = terms.end(half);
        // The slope of z at an edge.
        let fall = match terms {
            Terms::Turning { reach, .. } => odd / reach,
            Terms::Sliding { reach, .. } => 2.0 / reach,
        };
        let [behind, ahead] =
            self.dead.map(|dead| dead.map_or(0.0, |dead| dead.factor) / root(fall));
        DeadEnds { mean: (ahead + behind) / 2.0, skew: (ahead - behind) / (2.0 * odd) }
    }
}

/// The functions whose sum a fit of an angle is, at a distance from the middle.
fn sums(terms: &Terms, x: f64, degree: usize) -> Vec<f64> {
    let Terms::Turning { center, reach, turns, .. } = *terms else { return Vec::new() };
    let angle = ((x.cos() - center) / reach).clamp(-1.0, 1.0).acos();
    let even = (0..=degree.div_ceil(2)).map(|k| (k as f64 * angle).cos());
    let odd = (0..=(degree - 1) / 2).map(|k| x.sin() * (k as f64 * angle).cos());
    let turning = (turns != 0).then_some(x);
    even.chain(odd).chain(turning).collect()
}

/// The terms that fit a smooth function of the distance from the middle.
fn fitted(terms: &Terms, left: impl Fn(f64) -> f64, half: f64, degree: usize) -> Terms {
    let (center, reach, turns) = match *terms {
        Terms::Turning { center, reach, turns, .. } => (center, reach, turns),
        Terms::Sliding { reach, .. } => {
            return Terms::Sliding { reach, powers: powers(|node| left(reach * node), degree) };
        }
    };
    // Both sides of the middle at once.
    let sides = |node: f64| {
        let x = (center + reach * node).clamp(-1.0, 1.0).acos().min(half);
        let beyond = |x: f64| left(x) - f64::from(turns) * x;
        [beyond(x), beyond(-x), x.sin()]
    };
    let even = |node: f64| {
        let [ahead, behind, _] = sides(node);
        (ahead + behind) / 2.0
    };
    let odd = |node: f64| {
        let [ahead, behind, sine] = sides(node);
        (ahead - behind) / (2.0 * sine)
    };
    let (even, odd) = (powers(even, degree.div_ceil(2)), powers(odd, (degree - 1) / 2));
    Terms::Turning { center, reach, even, odd, turns }
}

/// The value between the points: Lagrange's polynomial through the nearest.
pub fn between(points: &[[f64; 2]], x: f64) -> f64 {
    let above = points.partition_point(|[at, _]| *at < x);
    let first = above.saturating_sub(NEIGHBOURS / 2).min(points.len() - NEIGHBOURS);
    let near = &points[first..first + NEIGHBOURS];
    let term = |i: usize| {
        let others = near.iter().enumerate().filter(|(j, _)| *j != i);
        others.fold(near[i][1], |term, (_, [at, _])| term * ((x - at) / (near[i][0] - at)))
    };
    (0..NEIGHBOURS).map(term).sum()
}

/// The powers of the Chebyshev sum of a function on −1…1.
pub fn powers(of: impl Fn(f64) -> f64, degree: usize) -> Vec<f64> {
    let values: Vec<_> = (0..NODES).map(|node| of(node_angle(node, NODES).cos())).collect();
    powers_through(&values, degree)
}

/// The angle whose cosine is one of so many nodes of Chebyshev's.
pub(super) fn node_angle(node: usize, count: usize) -> f64 {
    PI * (node as f64 + 0.5) / count as f64
}

/// The powers of the Chebyshev sum with these values at his nodes, up to a degree below their count.
pub(super) fn powers_through(values: &[f64], degree: usize) -> Vec<f64> {
    let count = values.len();
    let mut sum = vec![0.0; degree + 1];
    // The Chebyshev polynomials Tₖ₋₁ and Tₖ in powers.
    let (mut before, mut now) = (vec![0.0, 1.0], vec![1.0]);
    for k in 0..=degree {
        let term: f64 = values
            .iter()
            .enumerate()
            .map(|(node, value)| value * (k as f64 * node_angle(node, count)).cos())
            .sum();
        let term = term * if k == 0 { 1.0 } else { 2.0 } / count as f64;
        now.iter().enumerate().for_each(|(power, factor)| sum[power] += term * factor);
        // Tₖ₊₁ = 2 u Tₖ − Tₖ₋₁, with T₋₁ = T₁.
        let mut next = vec![0.0; k + 2];
        now.iter().enumerate().for_each(|(power, factor)| next[power + 1] += 2.0 * factor);
        before.iter().enumerate().for_each(|(power, factor)| next[power] -= factor);
        (before, now) = (now, next);
    }
    sum
}
