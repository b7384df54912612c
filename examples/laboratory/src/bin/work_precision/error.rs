//! The error of a method against 50 digits.

use crate::mechanisms::Mechanism;
use crate::number::Number;
use crate::truth::ANGLES;

/// The largest errors of position, velocity and acceleration over all poses of the table.
///
/// In units of the width's ε (two to four ulp of an average number are one ε) times the largest
/// value that the same quantity takes over the table: a point's or a direction's two components
/// are one quantity, and a velocity that passes through zero is not divided by it.
pub(crate) type Errors = [f64; 3];

/// `solve` is given angle, rate and second rate.
pub(crate) fn errors<F: Number, const N: usize>(
    mechanism: &Mechanism<N>,
    mut solve: impl FnMut([F; 3]) -> Option<[F; N]>,
) -> Errors {
    let found: Vec<[f64; N]> = ANGLES
        .iter()
        .map(|&angle| {
            let input = [angle, mechanism.rate, mechanism.second].map(F::of);
            solve(input).map_or([f64::NAN; N], |out| out.map(F::widen))
        })
        .collect();
    let (positions, velocities) = mechanism.orders;
    let mut errors = [0.0; 3];
    let mut first = 0;
    for &size in mechanism.vectors {
        let quantity = first..first + size;
        let order = usize::from(first >= positions) + usize::from(first >= positions + velocities);
        let error = quantity_error(mechanism, &found, quantity) / F::EPSILON;
        // A number that is not one has no error, and must not look as if it had none.
        errors[order] = if error.is_nan() { error } else { f64::max(errors[order], error) };
        first += size;
    }
    errors
}

fn quantity_error<const N: usize>(
    mechanism: &Mechanism<N>,
    found: &[[f64; N]],
    quantity: std::ops::Range<usize>,
) -> f64 {
    let length = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    let (mut largest, mut error) = (0.0_f64, 0.0_f64);
    for (truth, found) in mechanism.truth.iter().zip(found) {
        let size = length(&mut quantity.clone().map(|k| truth[k].0));
        let off = length(&mut quantity.clone().map(|k| (found[k] - truth[k].0) - truth[k].1));
        largest = largest.max(size);
        error = if off.is_nan() { off } else { error.max(off) };
    }
    error / largest
}
