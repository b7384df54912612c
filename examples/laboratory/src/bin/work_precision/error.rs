//! The error of a method against numbers of two words.

use laboratory::number::Number;
use linkage_core::Real;
use linkage_tests::double_double::DoubleDouble;

use crate::mechanisms::Mechanism;

/// The largest errors of position, velocity and acceleration over all poses.
///
/// In units of the width's ε (two to four ulp of an average number are one ε) times the largest
/// value that the same quantity takes over the poses: a point's or a direction's two components
/// are one quantity, and a velocity that passes through zero is not divided by it.
pub(crate) type Errors = [f64; 3];

/// Crank angles that both f32 and f64 hold exactly.
fn angles() -> impl Iterator<Item = f64> {
    (0..32).map(|k| 0.0625 + f64::from(25 * k) / 128.0)
}

/// `solve` is given angle, rate and acceleration.
pub(crate) fn errors<F: Number + Real, const N: usize>(
    mechanism: &Mechanism<N>,
    mut solve: impl FnMut([F; 3]) -> Option<[F; N]>,
) -> Errors {
    let input = |angle| [angle, mechanism.rate, mechanism.second];
    let truth: Vec<[DoubleDouble; N]> = angles()
        .map(|angle| (mechanism.truth)(input(angle).map(DoubleDouble::new)))
        .map(|numbers| numbers.expect("every angle is reached"))
        .collect();
    let found: Vec<[f64; N]> = angles()
        .map(|angle| solve(input(angle).map(F::num)))
        .map(|numbers| numbers.map_or([f64::NAN; N], |numbers| numbers.map(F::value)))
        .collect();
    let (mut errors, mut first) = ([0.0; 3], 0);
    for (order, labels) in mechanism.labels.into_iter().enumerate() {
        let pairs = labels
            .windows(2)
            .map(|pair| pair[0] == pair[1] || pair[0].ends_with(".x") && pair[1].ends_with(".y"));
        let is_with_next: Vec<bool> = pairs.chain([false]).collect();
        let mut at = 0;
        while at < labels.len() {
            let size = 1 + usize::from(is_with_next[at]);
            let numbers = first + at..first + at + size;
            let error = of_quantity(&truth, &found, numbers) / F::EPSILON;
            // A number that is not one has no error, and must not look as if it had none.
            errors[order] = if error.is_nan() { error } else { f64::max(errors[order], error) };
            at += size;
        }
        first += labels.len();
    }
    errors
}

fn of_quantity<const N: usize>(
    truth: &[[DoubleDouble; N]],
    found: &[[f64; N]],
    numbers: std::ops::Range<usize>,
) -> f64 {
    let length = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    let (mut largest, mut error) = (0.0_f64, 0.0_f64);
    for (truth, found) in truth.iter().zip(found) {
        let size = length(&mut numbers.clone().map(|k| truth[k].high));
        let off = length(&mut numbers.clone().map(|k| (found[k] - truth[k].high) - truth[k].low));
        largest = largest.max(size);
        error = if off.is_nan() { off } else { error.max(off) };
    }
    error / largest
}
