//! Distances of given points and poses from a curve, along its normals.
//!
//! The input at which the curve is nearest is sought for each target. There the residual r is square to the
//! tangent t, so that the slope of the distance by a parameter is that of r with the input held (the envelope
//! theorem); the part of r along t, which is zero, has a slope of zero.

use linkage_core::num_dual::Derivative;
use linkage_core::{Direction, SolveError};

use crate::follows::{Follows, Pose};
use crate::rows::{Cause, Dual, Machines, finite};

/// Something to pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Frame {
    Point([f64; 2]),
    Pose { pose: Pose, arm: f64 },
}

impl Frame {
    /// Residuals.
    pub(crate) fn width(&self) -> usize {
        match self {
            Self::Point(_) => 2,
            Self::Pose { .. } => 3,
        }
    }

    /// The residual of a place of the curve; the third number is zero for points.
    fn miss<const N: usize>(&self, [x, y, cos, sin]: [Dual<N>; 4]) -> [Dual<N>; 3] {
        match self {
            Self::Point([to_x, to_y]) => [x - *to_x, y - *to_y, Dual::from_re(0.0)],
            Self::Pose { pose, arm } => {
                let turned = Direction { cos, sin }.ahead_of(pose.angle);
                [x - pose.x, y - pose.y, turned * *arm]
            }
        }
    }
}

/// Samples of a range: one in some five degrees of a turn.
const SAMPLES: usize = 72;

/// The most steps of one search for the nearest place.
const STEPS: usize = 60;

/// A curve, and the targets that it shall pass.
pub(crate) struct Nearest<C> {
    pub(crate) between: [f64; 2],
    pub(crate) targets: Vec<Frame>,
    pub(crate) curve: C,
}

/// A place of the curve next to a target: the input, half the slope of the squared distance, and the
/// tangent, of which the third number is an angle times the arm.
#[derive(Clone, Copy)]
struct Near {
    input: f64,
    slope: f64,
    tangent: [f64; 3],
}

impl<C> Nearest<C> {
    /// Adds the residuals of all targets.
    pub(crate) fn rows<M, const N: usize>(
        &self,
        machines: &Machines<M>,
        to: &mut Vec<Dual<N>>,
    ) -> Result<(), (usize, Cause)>
    where
        C: Fn(&M, Dual<N>) -> Result<[Dual<N>; 4], SolveError>,
    {
        let [from, end] = self.between;
        let step = (end - from) / SAMPLES as f64;
        let mut refusal = None;
        let samples: Vec<Option<[Dual<N>; 4]>> = (0..=SAMPLES)
            .map(|k| {
                let at = (self.curve)(&machines.plain, Dual::from_re(from + step * k as f64));
                at.map_err(|error| refusal = Some(error)).ok()
            })
            .collect();
        for (place, target) in self.targets.iter().enumerate() {
            let square = |at: &Option<[Dual<N>; 4]>| {
                at.map_or(f64::INFINITY, |at| {
                    target.miss(at).iter().map(|row| row.re * row.re).sum::<f64>()
                })
            };
            let squares: Vec<f64> = samples.iter().map(square).collect();
            let best = (0..=SAMPLES).min_by(|&a, &b| squares[a].total_cmp(&squares[b]));
            let best = best.filter(|&best| squares[best] < f64::INFINITY);
            let refused = refusal.unwrap_or(SolveError::NotFinite { name: "the curve" });
            let best = best.ok_or((place, Cause::Refused(refused)))?;
            let near = self.refined(&machines.plain, target, best, step);
            let near = near.ok_or((place, Cause::Refused(refused)))?;
            let at = (self.curve)(&machines.sloped, Dual::from_re(near.input))
                .map_err(|error| (place, Cause::Refused(error)))?;
            let rows = across(target.miss(at), &near);
            finite(&rows).map_err(|cause| (place, cause))?;
            to.extend(&rows[..target.width()]);
        }
        Ok(())
    }

    /// The slope at an input, whose derivative takes the place of that by the first parameter.
    fn near<M, const N: usize>(&self, machine: &M, target: &Frame, input: f64) -> Option<Near>
    where
        C: Fn(&M, Dual<N>) -> Result<[Dual<N>; 4], SolveError>,
    {
        let seeded = Dual::<N>::from_re(input).derivative(0);
        let miss = target.miss((self.curve)(machine, seeded).ok()?);
        let tangent = miss.map(|row| match row.eps {
            Derivative(Some(slopes)) => slopes[0],
            _ => 0.0,
        });
        let slope = miss.iter().zip(&tangent).map(|(row, t)| row.re * t).sum();
        Some(Near { input, slope, tangent })
    }

    /// The nearest place next to a sample: steps by the secant of the slopes, or by Gauss and Newton's
    /// estimate of it, and halves where these leave what is known to hold it.
    fn refined<M, const N: usize>(
        &self,
        machine: &M,
        target: &Frame,
        sample: usize,
        step: f64,
    ) -> Option<Near>
    where
        C: Fn(&M, Dual<N>) -> Result<[Dual<N>; 4], SolveError>,
    {
        let [from, end] = self.between;
        let is_closed = (end - from - core::f64::consts::TAU).abs() < 1e-9;
        let middle = from + step * sample as f64;
        let (mut low, mut high) = (middle - step, middle + step);
        if !is_closed {
            (low, high) = (low.max(from), high.min(end));
        }
        let mut now = self.near(machine, target, middle)?;
        let mut before: Option<Near> = None;
        for _ in 0..STEPS {
            let square: f64 = now.tangent.iter().map(|t| t * t).sum();
            let secant = before.map_or(square, |b| (now.slope - b.slope) / (now.input - b.input));
            let rate = if secant > 0.0 { secant } else { square };
            if now.slope > 0.0 {
                high = now.input
            } else {
                low = now.input
            }
            let step = now.slope / rate;
            if step == 0.0 || !step.is_finite() {
                break;
            }
            let mut next = now.input - step;
            if next < low || next > high {
                next = 0.5 * (low + high);
            }
            if (next - now.input).abs() <= f64::EPSILON * (1.0 + next.abs()) {
                break;
            }
            let Some(at) = self.near(machine, target, next) else {
                // The curve ends before: the refused place is beyond.
                if next > now.input {
                    high = next
                } else {
                    low = next
                }
                before = None;
                continue;
            };
            before = Some(now);
            now = at;
        }
        Some(now)
    }
}

/// The residual without its part along the tangent, where these are square to each other; at an end of the
/// curve they are not, and all of the residual counts.
fn across<const N: usize>(miss: [Dual<N>; 3], near: &Near) -> [Dual<N>; 3] {
    let norm = |numbers: [f64; 3]| numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (length, size) = (norm(near.tangent), norm(miss.map(|row| row.re)));
    // Neither square to each other nor within 10⁻⁹ rad or m of the input of it.
    let is_end = near.slope.abs() > length * (1e-6 * size).max(1e-9 * length);
    if length == 0.0 || is_end {
        return miss;
    }
    let unit = near.tangent.map(|t| t / length);
    let along = miss[0] * unit[0] + miss[1] * unit[1] + miss[2] * unit[2];
    core::array::from_fn(|i| miss[i] - along * unit[i])
}

#[cfg(test)]
mod tests {
    use linkage_core::num_dual::Derivative;

    use super::{Near, across};
    use crate::rows::Dual;

    fn number(re: f64, slopes: [f64; 2]) -> Dual<2> {
        Dual::new(re, Derivative::some(slopes.into()))
    }

    /// Neither the residual nor its slopes have a part along the tangent, and what is square to it stays.
    #[test]
    fn a_distance_is_square_to_the_tangent() {
        let (tangent, normal) = ([1.2, -0.9, 2.0], [0.6, 0.8, 0.0]);
        // A part of 1e-9 along the tangent, as roundings leave it; slopes of any direction.
        let at = |i: usize| 0.3 * normal[i] + 1e-9 * tangent[i];
        let miss: [Dual<2>; 3] = core::array::from_fn(|i| {
            number(at(i), [2.0 * normal[i] + 5.0 * tangent[i], -normal[i] + 0.25 * tangent[i]])
        });
        let slope = (0..3).map(|i| at(i) * tangent[i]).sum();
        let rows = across(miss, &Near { input: 0.4, slope, tangent });
        for (i, row) in rows.iter().enumerate() {
            assert!((row.re - 0.3 * normal[i]).abs() < 1e-15, "{row:?}");
            let slopes = row.eps.0.expect("it has slopes");
            for (found, share) in slopes.iter().zip([2.0, -1.0]) {
                assert!((found - share * normal[i]).abs() < 1e-15, "{row:?}");
            }
        }
    }

    /// At an end of the curve the residual is not square to the tangent, and counts whole.
    #[test]
    fn at_an_end_all_of_a_residual_counts() {
        let miss = [number(0.3, [1.0, 0.0]), number(0.1, [0.0, 1.0]), number(0.0, [0.0; 2])];
        let tangent = [1.0, 0.0, 0.0];
        let rows = across(miss, &Near { input: 0.0, slope: 0.3, tangent });
        assert_eq!(rows.map(|row| row.re), [0.3, 0.1, 0.0]);
    }
}
