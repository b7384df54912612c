//! From a curve of the grid to the best one near it, by exact derivatives.
//!
//! The square of the [distance](crate::shape) is a sum of squares, Σ|tₖ − e^{i(ψ+kτ)}cₖ|², so that Levenberg and
//! Marquardt's method suits it. The numbers that are varied are the five dimensions, ψ and τ. The
//! derivatives of cₖ by the dimensions are those of the solver on dual numbers, through the sides of the polygon
//! and their lengths; those by ψ and τ are written down.
//!
//! # Dimensions that stay possible
//! A crank-rocker's crank turns where x = A + C − B − 1, y = B + C − A − 1 and z = A + B − C − 1 are above zero (the
//! crank being 1 and the shortest). These three are varied in place of A, B and C, and each is kept within its
//! limits as the sine of a free number: no step leads to a linkage that cannot be assembled. The limits are
//! those of the grid with room on both sides.

use std::f64::consts::TAU;

use linkage_core::nalgebra::{DMatrix, DVector};
use linkage_core::{LengthMismatch, Real, Side, SolveError, differentiate};
use linkage_design::{Evaluation, Goal, Kernel, LeastSquares, Rows};
use rayon::prelude::*;

use crate::four_bar::{Dimensions, FourBar, Tracer};
use crate::grid::Grid;
use crate::progress::Progress;
use crate::search::{self, Found};
use crate::shape::{Alignment, Complex, Describer, Descriptor, HARMONICS};

/// Poses of a curve while it is refined: the coefficients of a polygon of so many sides are those of one of
/// [`search::FINE_POSES`] to some 10⁻⁵ of the distance, and cost half.
const POSES: u32 = search::FINE_POSES / 2;

/// Real and imaginary parts of the coefficients on both sides of 0.
const RESIDUALS: usize = 4 * HARMONICS;

/// The five dimensions.
const DIMENSIONS: usize = 5;

/// The dimensions, ψ and τ.
const VARIED: usize = DIMENSIONS + 2;

/// The most steps: from the grid a refinement takes ten to forty.
const STEPS: usize = 100;

/// The least and the most of x, y and z, of the coupler point along the coupler and across it; the point in
/// lengths of the coupler. x, y and z are from half of the grid's slack to twice what the grid has.
const LIMITS: [[f64; 2]; DIMENSIONS] = [
    [Grid::SLACK / 2.0, 16.0],
    [Grid::SLACK / 2.0, 16.0],
    [Grid::SLACK / 2.0, 16.0],
    [-1.0, 2.0],
    [-1.0, 1.0],
];

/// The four-bar of free numbers.
fn four_bar<T: Real>(free: [T; DIMENSIONS]) -> FourBar<T> {
    let mut within = free;
    for (value, [least, most]) in within.iter_mut().zip(LIMITS) {
        let half = T::num((most - least) / 2.0);
        *value = T::num((most + least) / 2.0) + half * value.sin_cos().0;
    }
    let [x, y, z, along, across] = within;
    let (one, half) = (T::num(1.0), T::num(0.5));
    let coupler = one + half * (x + z);
    FourBar {
        coupler,
        follower: one + half * (y + z),
        base: one + half * (x + y),
        p_x: along * coupler,
        p_y: across * coupler,
        branch: Side::Left,
    }
}

/// The free numbers of a four-bar; none where it is beyond the limits.
fn free(dimensions: &Dimensions) -> Option<[f64; DIMENSIONS]> {
    let Dimensions { coupler, follower, base, along, across, .. } = *dimensions;
    let x = coupler + base - follower - 1.0;
    let y = follower + base - coupler - 1.0;
    let z = coupler + follower - base - 1.0;
    let mut free = [x, y, z, along / coupler, across / coupler];
    for (value, [least, most]) in free.iter_mut().zip(LIMITS) {
        *value = (2.0 * *value - most - least) / (most - least);
    }
    free.iter().all(|sine| sine.abs() < 1.0).then(|| free.map(f64::asin))
}

/// The coefficients c₁ …, c₋₁ … of a polygon, of square sum 1, real and imaginary part of each in turn: the
/// [`Describer`]'s on one number at a time, with its derivatives.
fn coefficients<T: Real>(corners: &[[T; 2]]) -> [T; RESIDUALS] {
    let zero = T::num(0.0);
    let sides: Vec<([T; 2], T)> = (0..corners.len())
        .map(|k| {
            let ([x0, y0], [x1, y1]) = (corners[k], corners[(k + 1) % corners.len()]);
            let (dx, dy) = (x1 - x0, y1 - y0);
            let length = (dx * dx + dy * dy).sqrt();
            let inverse = if length.value() > 0.0 { T::num(1.0) / length } else { zero };
            ([dx * inverse, dy * inverse], length)
        })
        .collect();
    let perimeter = sides.iter().fold(zero, |sum, side| sum + side.1);
    let (mut run, mut sums) = (zero, [[zero; 4]; HARMONICS]);
    let mut last = sides.last().map_or([zero; 2], |side| side.0);
    for (direction, length) in sides {
        let (sin, cos) = (run * T::num(TAU) / perimeter).sin_cos();
        let (x, y) = (direction[0] - last[0], direction[1] - last[1]);
        let mut power = [cos, sin];
        for [cx, sy, cy, sx] in &mut sums {
            let [c, s] = power;
            (*cx, *sy, *cy, *sx) = (*cx + c * x, *sy + s * y, *cy + c * y, *sx + s * x);
            power = [c * cos - s * sin, c * sin + s * cos];
        }
        run = run + length;
        last = direction;
    }
    let mut coefficients = [zero; RESIDUALS];
    for (k, [cx, sy, cy, sx]) in sums.into_iter().enumerate() {
        let factor = -perimeter * T::num((TAU * (k + 1) as f64).powi(-2));
        let (ahead, back) = ([cx + sy, cy - sx], [cx - sy, cy + sx]);
        for part in 0..2 {
            coefficients[2 * k + part] = factor * ahead[part];
            coefficients[2 * (HARMONICS + k) + part] = factor * back[part];
        }
    }
    let square = coefficients.iter().fold(zero, |sum, &part| sum + part * part);
    let inverse = T::num(1.0) / square.sqrt();
    coefficients.map(|part| part * inverse)
}

/// The coefficients of the four-bar's curve.
fn of_curve<T: Real>(free: [T; DIMENSIONS]) -> Result<[T; RESIDUALS], SolveError> {
    let four_bar = four_bar(free);
    let angles = (0..POSES).map(|k| TAU * f64::from(k) / f64::from(POSES));
    let corner = |angle| four_bar.position(T::num(angle)).map(|pose| [pose.P.x, pose.P.y]);
    let corners: Result<Vec<[T; 2]>, SolveError> = angles.map(corner).collect();
    Ok(coefficients(&corners?))
}

/// The difference between the path's coefficients and the curve's.
struct Remainder<'a> {
    path: &'a Descriptor,
    alignment: Alignment,
}

impl Remainder<'_> {
    /// For each coefficient of the path, ahead and back: which numbers of the curve's it takes, the sign of
    /// their imaginary part, and the harmonic with its sign.
    fn pairs(&self) -> impl Iterator<Item = (Complex, usize, f64, f64)> {
        let Alignment { swapped, mirrored, .. } = self.alignment;
        let sign = if mirrored { -1.0 } else { 1.0 };
        let sides = self.path.sides();
        (0..2 * HARMONICS).map(move |nth| {
            let (side, k) = (nth / HARMONICS, nth % HARMONICS);
            let from = if swapped { 1 - side } else { side } * HARMONICS + k;
            let harmonic = (k + 1) as f64;
            (sides[side][k], 2 * from, sign, if side == 0 { harmonic } else { -harmonic })
        })
    }

    fn residuals(&self, curve: &[f64; RESIDUALS], psi: f64, tau: f64) -> Vec<f64> {
        let mut residuals = Vec::with_capacity(RESIDUALS);
        for (wanted, at, sign, k) in self.pairs() {
            let c = Complex { re: curve[at], im: sign * curve[at + 1] };
            let left = wanted - Complex::turn(psi + k * tau) * c;
            residuals.extend([left.re, left.im]);
        }
        residuals
    }
}

fn split(varied: &[f64]) -> ([f64; DIMENSIONS], f64, f64) {
    (core::array::from_fn(|i| varied[i]), varied[DIMENSIONS], varied[DIMENSIONS + 1])
}

impl Remainder<'_> {
    /// The slopes of the residuals, row after row.
    fn slopes(
        &self,
        free: [f64; DIMENSIONS],
        curve: &[f64; RESIDUALS],
        psi: f64,
        tau: f64,
    ) -> Result<Vec<f64>, SolveError> {
        let slopes = differentiate(free, of_curve)?;
        let mut rows = Vec::with_capacity(RESIDUALS * VARIED);
        for (_, at, sign, k) in self.pairs() {
            let turn = Complex::turn(psi + k * tau);
            let turned = |re: f64, im: f64| turn * Complex { re, im: sign * im };
            let by_dimension: [Complex; DIMENSIONS] =
                core::array::from_fn(|i| turned(slopes[(at, i)], slopes[(at + 1, i)]));
            // i times the coefficient, and k times that.
            let Complex { re, im } = turned(curve[at], curve[at + 1]);
            rows.extend(by_dimension.iter().map(|slope| -slope.re));
            rows.extend([im, k * im]);
            rows.extend(by_dimension.iter().map(|slope| -slope.im));
            rows.extend([-re, -k * re]);
        }
        Ok(rows)
    }

    fn evaluated(
        &self,
        varied: [f64; VARIED],
        with_slopes: bool,
    ) -> Result<Evaluation, SolveError> {
        let (free, psi, tau) = split(&varied);
        let curve = of_curve(free)?;
        let values = DVector::from_vec(self.residuals(&curve, psi, tau));
        let slopes = if with_slopes {
            DMatrix::from_row_slice(RESIDUALS, VARIED, &self.slopes(free, &curve, psi, tau)?)
                * RANGE
        } else {
            DMatrix::zeros(RESIDUALS, VARIED)
        };
        let none = Rows { values: DVector::zeros(0), slopes: DMatrix::zeros(0, VARIED) };
        Ok(Evaluation { aims: Rows { values, slopes }, keeps: none })
    }
}

/// The numbers from 0 to 1 of a search stand for two turns: all of them are angles.
const RANGE: f64 = 2.0 * TAU;

/// The search about a start, which is in the middle of the ranges.
struct About<'a> {
    remainder: Remainder<'a>,
    start: [f64; VARIED],
}

impl About<'_> {
    fn varied(&self, x: &[f64]) -> [f64; VARIED] {
        core::array::from_fn(|i| self.start[i] + RANGE * (x[i] - 0.5))
    }
}

impl Goal for About<'_> {
    fn evaluate(&self, x: &[f64], with_slopes: bool) -> Option<Evaluation> {
        self.remainder.evaluated(self.varied(x), with_slopes).ok()
    }
}

/// The best curve near one that was found: that one itself where none near it is better.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn refined(path: &Descriptor, found: &Found) -> Result<Found, LengthMismatch> {
    let mut tracer = Tracer::new(POSES);
    let is_whole = tracer.trace(&found.dimensions)?;
    let curve = Describer::default().describe(&tracer.x, &tracer.y);
    let (true, Some(curve), Some(start)) = (is_whole, curve, free(&found.dimensions)) else {
        return Ok(*found);
    };
    let (_, alignment) = path.aligned(&curve);
    let psi = alignment.turn.im.atan2(alignment.turn.re);
    let [a, b, c, d, e] = start;
    let start = [a, b, c, d, e, psi, alignment.shift];
    let about = About { remainder: Remainder { path, alignment }, start };
    let method = LeastSquares { steps: STEPS, reduction: 1e-8 };
    let ended = about.varied(&method.search(&about, &[0.5; VARIED]));
    let FourBar { coupler, follower, base, p_x: along, p_y: across, branch } =
        four_bar(split(&ended).0);
    let dimensions = Dimensions { coupler, follower, base, along, across, branch };
    let refined = search::compared(path, found.candidate, dimensions)?;
    Ok(refined.filter(|refined| refined.distance < found.distance).unwrap_or(*found))
}

/// All of these refined, nearest first.
///
/// # Errors
/// Never: all slices of a sweep are of one length.
pub fn refine(
    path: &Descriptor,
    found: &[Found],
    progress: &Progress,
) -> Result<Vec<Found>, LengthMismatch> {
    let one = |found: &Found| {
        let refined = refined(path, found);
        progress.advance(1);
        refined
    };
    let refined: Result<Vec<Found>, LengthMismatch> = found.par_iter().map(one).collect();
    let mut refined = refined?;
    search::sort(&mut refined);
    Ok(refined)
}

#[cfg(test)]
mod tests;
