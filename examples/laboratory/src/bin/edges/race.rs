//! Times of two ways in turn.

use std::hint::black_box;
use std::time::Instant;

use linkage_core::Status;

/// Nanoseconds a pose.
pub(crate) type Run = Box<dyn FnMut() -> f64>;

/// A line of the table for one machine: the time of the first way over that of the second.
pub(crate) struct Pair {
    pub(crate) what: &'static str,
    pub(crate) aim: f64,
    pub(crate) runs: [Run; 2],
}

/// A call a pose.
pub(crate) fn calls<I: 'static, O>(inputs: Vec<I>, call: impl Fn(&I) -> O + 'static) -> Run {
    Box::new(move || {
        let start = Instant::now();
        for input in &inputs {
            black_box(call(black_box(input)));
        }
        start.elapsed().as_nanos() as f64 / inputs.len() as f64
    })
}

/// A sweep into as many slices as there are numbers.
pub(crate) fn swept<const OUT: usize>(
    poses: usize,
    run: impl Fn([&mut [f64]; OUT], &mut [Status]) + 'static,
) -> Run {
    let mut columns: [Vec<f64>; OUT] = std::array::from_fn(|_| vec![0.0; poses]);
    let mut status = vec![Status::Solved; poses];
    Box::new(move || {
        let start = Instant::now();
        run(columns.each_mut().map(|column| &mut column[..]), &mut status);
        let time = start.elapsed();
        black_box((&mut columns, &mut status));
        time.as_nanos() as f64 / poses as f64
    })
}

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

impl Pair {
    /// The median of the ratios of times that follow each other, and that of the first way's times.
    pub(crate) fn measure(&mut self, rounds: usize) -> [f64; 2] {
        let (mut ratios, mut times) = (Vec::new(), Vec::new());
        for round in 0..rounds {
            let [first, second] = &mut self.runs;
            let (a, b) = if round % 2 == 0 {
                let a = first();
                (a, second())
            } else {
                let b = second();
                (first(), b)
            };
            ratios.push(a / b);
            times.push(a);
        }
        [median(ratios), median(times)]
    }
}
