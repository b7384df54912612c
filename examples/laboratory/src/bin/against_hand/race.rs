//! Times both ways to the same numbers in turns.

use std::hint::black_box;

use laboratory::race::{Race, Run, Timing, at_once};

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

pub(crate) fn ratios<const N: usize>(
    &Contest { made, by_hand, ranges }: &Contest<N>,
    rounds: usize,
) -> Ratios {
    let poses = poses(ranges);
    let race = |waits_for: Option<usize>, rounds: usize| -> [Timing; 2] {
        let mut race = Race::default();
        race.enter("by hand", timed(by_hand, poses.clone(), waits_for));
        race.enter("made", timed(made, poses.clone(), waits_for));
        race.run(rounds, |_| {}).try_into().expect("two ways")
    };
    let [_, each] = race(None, rounds);
    // An answer is there when its last number is, whichever that is.
    let mut waits = [0.0_f64; 2];
    for number in 0..N {
        let of_number = race(Some(number), (rounds / N).max(2));
        waits.iter_mut().zip(of_number).for_each(|(wait, of)| *wait = wait.max(of.nanoseconds));
    }
    let [by_hand, made] = waits;
    let nanoseconds = [each.nanoseconds, made];
    Ratios { throughput: each.ratio, latency: made / by_hand, nanoseconds }
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

/// All poses one way, each waiting for a number of the one before or for none.
fn timed<const N: usize>(call: Call<N>, poses: Vec<[f64; 2]>, waits_for: Option<usize>) -> Run {
    let [[v, a], [w, b]] = black_box(RATES);
    match call {
        Call::One(call) => {
            let call = black_box(call);
            one_by_one(poses, waits_for, move |[q, _], out| call(q, v, a, out))
        }
        Call::Two(call) => {
            let call = black_box(call);
            one_by_one(poses, waits_for, move |[q, r], out| call(q, r, v, w, a, b, out))
        }
    }
}

fn one_by_one<const N: usize>(
    poses: Vec<[f64; 2]>,
    waits_for: Option<usize>,
    call: impl Fn([f64; 2], &mut [f64; N]) -> bool + 'static,
) -> Run {
    let (mut room, mut round) = (vec![0.0; PLACES + N], 0);
    at_once(poses.len(), move || {
        round += 1;
        let out: &mut [f64; N] =
            room[round * 37 % PLACES..].first_chunk_mut().expect("there is room for every place");
        if let Some(number) = waits_for {
            let mut nothing = 0.0;
            for &pose in &poses {
                black_box(call(pose.map(|input| input + nothing), out));
                // The compiler does not know that this is zero: it might be infinite.
                nothing = out[number] * 0.0;
            }
            black_box(nothing);
        } else {
            for &pose in &poses {
                black_box(call(pose, out));
                black_box(&mut *out);
            }
        }
    })
}
