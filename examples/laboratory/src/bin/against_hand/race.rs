//! Times both ways to the same numbers in turns.

use std::hint::black_box;
use std::time::Instant;

use crate::kernels::{Call, Contest};

/// The generated solver's time over the hand form's.
#[derive(Clone, Copy)]
pub(crate) struct Ratios {
    pub(crate) throughput: f64,
    pub(crate) latency: f64,
    /// The generated solver's of a call: throughput and latency.
    pub(crate) nanoseconds: [f64; 2],
}

/// The rates of each input, in rad/s and rad/s² or in m/s and m/s².
pub(crate) const RATES: [[f64; 2]; 2] = [[250.0, 1000.0], [-130.0, 700.0]];

/// At how many places of a page numbers are put, one after the other: a processor takes a store for one to
/// where it loads from next if both addresses end alike, and waits.
const PLACES: usize = 512;

/// Medians of rounds that each way has in turns: a disturbance hits both or is outvoted.
pub(crate) fn ratios<const N: usize>(
    &Contest { made, by_hand, ranges }: &Contest<N>,
    rounds: usize,
) -> Ratios {
    let poses = poses(ranges);
    let mut room = vec![0.0; PLACES + N];
    let mut race = |run: Run<N>, round: usize| {
        let at = round * 37 % PLACES;
        let out = room[at..].first_chunk_mut().expect("there is room for every place");
        let number = round / 2 % N;
        // Neither is always the first.
        if round.is_multiple_of(2) {
            [made, by_hand].map(|call| run(call, &poses, out, number))
        } else {
            let [by_hand, made] = [by_hand, made].map(|call| run(call, &poses, out, number));
            [made, by_hand]
        }
    };
    let pairs: Vec<_> = (0..rounds).map(|round| race(one_by_one::<N>, round)).collect();
    let throughput = median(pairs.iter().map(|[made, by_hand]| made / by_hand).collect());
    let each = median(pairs.iter().map(|[made, _]| *made).collect());

    let mut waits = vec![[Vec::new(), Vec::new()]; N];
    for round in 0..rounds.max(2 * N) {
        let times = race(one_after_another::<N>, round);
        let of_number = waits[round / 2 % N].iter_mut();
        of_number.zip(times).for_each(|(waits, time)| waits.push(time));
    }
    // An answer is there when its last number is, whichever that is.
    let last = |way: usize| {
        let of_numbers = waits.iter().map(|of_number| median(of_number[way].clone()));
        of_numbers.fold(0.0, f64::max)
    };
    let [wait, by_hand] = [0, 1].map(last);
    let nanoseconds = [each, wait].map(|time| time / poses.len() as f64);
    Ratios { throughput, latency: wait / by_hand, nanoseconds }
}

/// All poses one way, with the number that is waited for: how long it takes, in nanoseconds.
type Run<const N: usize> = fn(Call<N>, &[[f64; 2]], &mut [f64; N], usize) -> f64;

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// All over the ranges, in no order: an angle at multiples of the golden angle, and what goes with it at
/// those of the golden angle's square root.
pub(crate) fn poses(ranges: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let share = |k: f64, [low, high]: [f64; 2], step: f64| {
        let turned = (k * step) % std::f64::consts::TAU;
        low + turned * ((high - low) / std::f64::consts::TAU)
    };
    let [first, second] = ranges;
    let steps = [2.399_963_229_728_653, 1.549_181_599_985_955];
    (0..240)
        .map(|k| [share(f64::from(k), first, steps[0]), share(f64::from(k), second, steps[1])])
        .collect()
}

/// Poses that do not wait for each other.
fn one_by_one<const N: usize>(
    call: Call<N>,
    poses: &[[f64; 2]],
    out: &mut [f64; N],
    _: usize,
) -> f64 {
    let [[v, a], [w, b]] = black_box(RATES);
    match call {
        Call::One(call) => {
            let call = black_box(call);
            each(poses, out, |[q, _], out| call(q, v, a, out))
        }
        Call::Two(call) => {
            let call = black_box(call);
            each(poses, out, |[q, r], out| call(q, r, v, w, a, b, out))
        }
    }
}

#[inline(always)]
fn each<const N: usize>(
    poses: &[[f64; 2]],
    out: &mut [f64; N],
    call: impl Fn([f64; 2], &mut [f64; N]) -> bool,
) -> f64 {
    let start = Instant::now();
    for &pose in poses {
        black_box(call(pose, out));
        black_box(&mut *out);
    }
    start.elapsed().as_nanos() as f64
}

/// Poses whose inputs are known only once a number of the one before is.
fn one_after_another<const N: usize>(
    call: Call<N>,
    poses: &[[f64; 2]],
    out: &mut [f64; N],
    number: usize,
) -> f64 {
    let [[v, a], [w, b]] = black_box(RATES);
    match call {
        Call::One(call) => {
            let call = black_box(call);
            chained(poses, out, number, |[q, _], nothing, out| call(q + nothing, v, a, out))
        }
        Call::Two(call) => {
            let call = black_box(call);
            chained(poses, out, number, |[q, r], nothing, out| {
                call(q + nothing, r + nothing, v, w, a, b, out)
            })
        }
    }
}

#[inline(always)]
fn chained<const N: usize>(
    poses: &[[f64; 2]],
    out: &mut [f64; N],
    number: usize,
    call: impl Fn([f64; 2], f64, &mut [f64; N]) -> bool,
) -> f64 {
    let mut nothing = 0.0;
    let start = Instant::now();
    for &pose in poses {
        black_box(call(pose, nothing, out));
        // The compiler does not know that this is zero: it might be infinite.
        nothing = out[number] * 0.0;
    }
    black_box(nothing);
    start.elapsed().as_nanos() as f64
}
