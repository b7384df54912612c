//! Times both ways to the same numbers in turns.

use std::hint::black_box;
use std::time::Instant;

/// The generated solver's time over the hand form's.
#[derive(Clone, Copy)]
pub(crate) struct Ratios {
    pub(crate) throughput: f64,
    pub(crate) latency: f64,
    /// The generated solver's of a call: throughput and latency.
    pub(crate) nanoseconds: [f64; 2],
}

/// rad/s and rad/s²
const RATES: [f64; 2] = [250.0, 1000.0];

/// At how many places of a page numbers are put, one after the other: a processor takes a store for one to
/// where it loads from next if both addresses end alike, and waits.
const PLACES: usize = 512;

/// Angle and rates in, numbers out.
pub(crate) type Call<const N: usize> = fn([f64; 3], &mut [f64; N]) -> bool;

/// Medians of rounds that each way has in turns: a disturbance hits both or is outvoted.
pub(crate) fn ratios<const N: usize>([made, by_hand]: [Call<N>; 2], rounds: usize) -> Ratios {
    let angles = angles();
    let mut room = vec![0.0; PLACES + N];
    let mut race = |run: Run<N>, round: usize| {
        let at = round * 37 % PLACES;
        let out = room[at..].first_chunk_mut().expect("there is room for every place");
        let number = round / 2 % N;
        // Neither is always the first.
        if round.is_multiple_of(2) {
            [made, by_hand].map(|call| run(call, &angles, out, number))
        } else {
            let [by_hand, made] = [by_hand, made].map(|call| run(call, &angles, out, number));
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
    let nanoseconds = [each, wait].map(|time| time / angles.len() as f64);
    Ratios { throughput, latency: wait / by_hand, nanoseconds }
}

/// All angles one way, with the number that is waited for: how long it takes, in nanoseconds.
type Run<const N: usize> = fn(Call<N>, &[f64], &mut [f64; N], usize) -> f64;

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// All over a turn, in no order: multiples of the golden angle.
pub(crate) fn angles() -> Vec<f64> {
    (0..240).map(|k| (f64::from(k) * 2.399_963_229_728_653) % std::f64::consts::TAU).collect()
}

/// Poses that do not wait for each other.
fn one_by_one<const N: usize>(call: Call<N>, angles: &[f64], out: &mut [f64; N], _: usize) -> f64 {
    let (call, [omega, alpha]) = (black_box(call), black_box(RATES));
    let start = Instant::now();
    for &angle in angles {
        black_box(call([angle, omega, alpha], out));
        black_box(&mut *out);
    }
    start.elapsed().as_nanos() as f64
}

/// Poses whose angle is known only once a number of the one before is.
fn one_after_another<const N: usize>(
    call: Call<N>,
    angles: &[f64],
    out: &mut [f64; N],
    number: usize,
) -> f64 {
    let (call, [omega, alpha]) = (black_box(call), black_box(RATES));
    let mut nothing = 0.0;
    let start = Instant::now();
    for &angle in angles {
        black_box(call([angle + nothing, omega, alpha], out));
        // The compiler does not know that this is zero: it might be infinite.
        nothing = out[number] * 0.0;
    }
    black_box(nothing);
    start.elapsed().as_nanos() as f64
}
