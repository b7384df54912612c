//! The truth of a result: the same formulas on numbers of twice the width, and the error that the data allow.
//!
//! A result may be as wrong as if every number given, and the result itself, had been changed by
//! half a unit in its last place as often as the solver rounds: every operation rounds once, and
//! does no more harm than that. Close to a limit the allowed error may double within a
//! unit; no result is judged there.

use linkage_core::Scalar;
use linkage_tests::double_double::DoubleDouble;
use num_dual::Dual64;

use super::numbers::Number;
use super::state::State;

/// A mechanism's motion on any number: positions, velocities and accelerations in one list.
pub(crate) trait Motion<const N: usize, const P: usize> {
    const OUTPUTS: &'static [&'static str];
    /// The least size whose unit in the last place counts: a smaller number may be wrong by this size's unit,
    /// as an angle stands in sums with whole turns.
    const LEAST: f64 = 0.0;

    /// The additional error that a result may have for each rounding, in units in the last place of its
    /// largest row.
    fn loss(_: &State<f64, N, P>) -> f64 {
        0.0
    }

    fn motion<S: Scalar<Mask = bool>>(state: &State<S, N, P>) -> Option<Vec<S>>;
}

/// By how many units a number moves: not at all in turn 0, else each its own way.
fn moved(place: usize, turn: usize) -> f64 {
    let bits = (place + 1).wrapping_mul(0x9e37_79b9).wrapping_mul(2 * turn + 1) >> 7;
    if turn == 0 { 0.0 } else { [-1.0, 1.0][bits % 2] }
}

/// The change of each row by half a unit in the last place of every number.
fn allowed<M: Motion<N, P>, const N: usize, const P: usize>(
    state: &State<f64, N, P>,
    half_unit: f64,
    turn: usize,
) -> Option<Vec<f64>> {
    let mut sums: Option<Vec<f64>> = None;
    for varied in 0..State::<f64, N, P>::COUNT {
        let seeded = state.map(|place, x| {
            let x = x * (1.0 + 2.0 * half_unit * moved(place, turn));
            let size = if x.abs() < M::LEAST { M::LEAST } else { x };
            Dual64::new(x, if place == varied { size } else { 0.0 })
        });
        let rows = M::motion(&seeded)?;
        let sums = sums.get_or_insert_with(|| rows.iter().map(|row| row.re.abs()).collect());
        sums.iter_mut().zip(&rows).for_each(|(sum, row)| *sum += row.eps.abs());
    }
    let mut sums = sums?;
    sums.iter_mut().for_each(|sum| *sum *= half_unit);
    // A coordinate may be small by chance; then it may be wrong by what the data allow the others.
    let outputs = M::OUTPUTS;
    for order in sums.chunks_mut(outputs.len()) {
        let is_length = |row: usize| !outputs[row].ends_with(".angle");
        let lengths = || (0..outputs.len()).filter(|&row| is_length(row));
        let largest = lengths().map(|row| order[row]).fold(0.0, f64::max);
        lengths().for_each(|row| order[row] = largest);
    }
    Some(sums)
}

/// The worst of the rows' errors over what half a unit in the last place of everything changes;
/// `None` where the data do not determine the answer.
pub(crate) fn error<M: Motion<N, P>, T: Number, const N: usize, const P: usize>(
    state: &State<T, N, P>,
    found: &[T],
) -> Option<f64> {
    let data = state.map(|_, x| x.value());
    let at = |turn| allowed::<M, N, P>(&data, T::HALF_UNIT, turn);
    let mut allowed = at(0)?;
    let total = |allowed: &[f64]| allowed.iter().sum::<f64>();
    for turn in 1..3 {
        if !(0.5..2.0).contains(&(total(&at(turn)?) / total(&allowed))) {
            return None;
        }
    }
    let truth: Vec<[f64; 2]> = if T::HALF_UNIT == f64::HALF_UNIT {
        let truth = M::motion(&data.map(|_, x| DoubleDouble::<false>::new(x)))?;
        truth.iter().map(|row| [row.high, row.low]).collect()
    } else {
        let truth = M::motion(&data.map(|_, x| DoubleDouble::<true>::new(x)))?;
        truth.iter().map(|row| [row.high, row.low]).collect()
    };
    let largest = truth.iter().map(|[high, _]| high.abs()).fold(0.0, f64::max);
    let lost = 2.0 * M::loss(&data) * T::HALF_UNIT * largest;
    allowed.iter_mut().for_each(|allowed| *allowed += lost);
    let mut worst = 0.0_f64;
    for (row, ((found, [high, low]), allowed)) in found.iter().zip(truth).zip(allowed).enumerate() {
        let away = found.value() - high;
        let is_angle = M::OUTPUTS.get(row).is_some_and(|output| output.ends_with(".angle"));
        let turns = if is_angle { (away / core::f64::consts::TAU).round() } else { 0.0 };
        let error = (away - turns * core::f64::consts::TAU - low).abs();
        worst = worst.max(if error == 0.0 { 0.0 } else { error / allowed });
    }
    Some(worst)
}
