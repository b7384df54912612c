//! Times both ways to the same numbers in turns.

use std::hint::black_box;
use std::time::Instant;

/// The generated solver's time over the hand form's.
#[derive(Clone, Copy)]
pub(crate) struct Ratios {
    pub(crate) throughput: f64,
    pub(crate) latency: f64,
}

/// rad/s and rad/s²
const RATES: [f64; 2] = [250.0, 1000.0];

/// Angle and rates in, numbers out.
pub(crate) type Call<const N: usize> = fn([f64; 3], &mut [f64; N]) -> bool;

/// Medians of the ratios of one round each: a disturbance hits both ways or is outvoted.
pub(crate) fn ratios<const N: usize>([made, by_hand]: [Call<N>; 2], rounds: usize) -> Ratios {
    let angles = angles();
    let ratio = |run: fn(Call<N>, &[f64]) -> f64| {
        let ratios = (0..rounds).map(|round| {
            // Neither is always the first.
            if round % 2 == 0 {
                let time = run(made, &angles);
                time / run(by_hand, &angles)
            } else {
                let time = run(by_hand, &angles);
                run(made, &angles) / time
            }
        });
        median(ratios.collect())
    };
    Ratios { throughput: ratio(one_by_one::<N>), latency: ratio(one_after_another::<N>) }
}

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// All over a turn, in no order: multiples of the golden angle.
pub(crate) fn angles() -> Vec<f64> {
    (0..240).map(|k| (f64::from(k) * 2.399_963_229_728_653) % std::f64::consts::TAU).collect()
}

/// Poses that do not wait for each other.
fn one_by_one<const N: usize>(call: Call<N>, angles: &[f64]) -> f64 {
    let (call, [omega, alpha]) = (black_box(call), black_box(RATES));
    let mut out = [0.0; N];
    let start = Instant::now();
    for &angle in angles {
        black_box(call([angle, omega, alpha], &mut out));
        black_box(&mut out);
    }
    start.elapsed().as_nanos() as f64
}

/// Poses whose angle is known only once the last number of the one before is.
fn one_after_another<const N: usize>(call: Call<N>, angles: &[f64]) -> f64 {
    let (call, [omega, alpha]) = (black_box(call), black_box(RATES));
    let (mut out, mut nothing) = ([0.0; N], 0.0);
    let start = Instant::now();
    for &angle in angles {
        black_box(call([angle + nothing, omega, alpha], &mut out));
        // The compiler does not know that this is zero: it might be infinite.
        nothing = out[N - 1] * 0.0;
    }
    black_box(nothing);
    start.elapsed().as_nanos() as f64
}
