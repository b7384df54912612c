//! Times of several ways to the same numbers on a machine that does other things too.
//!
//! Every way runs for some microseconds at a time, in many rounds, in an order that rotates from round to round.
//! Reported are medians over the rounds, those of ratios to the first way's time in the same round: a disturbance hits
//! both or is outvoted.

use std::hint::black_box;
use std::time::Instant;

use linkage_core::Status;

use crate::number::Number;

/// One run: nanoseconds a pose.
pub type Run = Box<dyn FnMut() -> f64>;

/// Ways to be measured against the first of them.
#[derive(Default)]
pub struct Race {
    ways: Vec<(String, Run)>,
}

/// The times of a way.
#[derive(Clone, Debug)]
pub struct Timing {
    /// The way's name.
    pub name: String,
    /// The median of the ratios to the first way.
    pub ratio: f64,
    /// The median time in nanoseconds a pose.
    pub nanoseconds: f64,
}

impl Race {
    /// One more way.
    pub fn enter(&mut self, name: &str, run: Run) {
        self.ways.push((name.to_owned(), run));
    }

    /// The times of all, in the order in which they were entered; `progress` is told how many rounds are done.
    pub fn run(&mut self, rounds: usize, mut progress: impl FnMut(usize)) -> Vec<Timing> {
        let count = self.ways.len();
        let mut times = vec![Vec::with_capacity(rounds); count];
        for round in 0..rounds {
            for place in 0..count {
                let way = (place + round) % count;
                times[way].push((self.ways[way].1)());
            }
            progress(round + 1);
        }
        let timing = |(k, (name, _)): (usize, &(String, Run))| {
            let ratios = times[k].iter().zip(&times[0]).map(|(time, first)| time / first);
            let (ratio, nanoseconds) = (median(ratios.collect()), median(times[k].clone()));
            Timing { name: name.clone(), ratio, nanoseconds }
        };
        self.ways.iter().enumerate().map(timing).collect()
    }
}

/// The median of numbers, of which there is at least one.
#[must_use]
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Angles all over a turn, in no order: multiples of the golden angle.
pub fn angles<F: Number>() -> impl Iterator<Item = F> {
    (0..).map(|k| F::of((f64::from(k) * 2.399_963_229_728_653) % std::f64::consts::TAU))
}

/// One call for so many poses.
pub fn at_once(poses: usize, mut call: impl FnMut() + 'static) -> Run {
    Box::new(move || {
        let start = Instant::now();
        call();
        start.elapsed().as_nanos() as f64 / poses as f64
    })
}

/// Calls that do not wait for each other.
pub fn calls<I: Copy + 'static, R>(inputs: Vec<I>, mut call: impl FnMut(I) -> R + 'static) -> Run {
    at_once(inputs.len(), move || {
        for &input in &inputs {
            // By reference: a value would be moved, and that counted.
            let result = call(black_box(input));
            black_box(&result);
        }
    })
}

/// Calls of which each is given its angle only once the last number of the one before is known.
pub fn chained<F: Number, R>(
    angles: Vec<F>,
    mut call: impl FnMut(F) -> R + 'static,
    last: impl Fn(&R) -> F + 'static,
) -> Run {
    at_once(angles.len(), move || {
        let mut nothing = F::num(0.0);
        for &angle in &angles {
            let result = call(angle + nothing);
            // The compiler does not know that this is zero: it might be infinite.
            nothing = last(&result) * F::num(0.0);
            black_box(&result);
        }
        black_box(nothing);
    })
}

/// A sweep into as many slices as there are numbers.
pub fn swept<F: Number, const OUT: usize>(
    poses: usize,
    sweep: impl Fn([&mut [F]; OUT], &mut [Status]) + 'static,
) -> Run {
    let mut columns: [Vec<F>; OUT] = std::array::from_fn(|_| vec![F::num(0.0); poses]);
    let mut status = vec![Status::Solved; poses];
    at_once(poses, move || {
        sweep(columns.each_mut().map(|column| &mut column[..]), &mut status);
        black_box((&mut columns, &mut status));
    })
}
