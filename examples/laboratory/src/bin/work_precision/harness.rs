//! Measures several methods against each other on a machine that does other things too.
//!
//! Every method runs for some microseconds at a time, in many rounds, in an order that rotates
//! from round to round. The report is the median over the rounds of the ratio to the first
//! method's time in the same round: a disturbance hits both or is outvoted.

use std::hint::black_box;
use std::time::Instant;

use crate::number::Number;

/// One run: nanoseconds per pose.
pub(crate) type Run = Box<dyn FnMut() -> f64>;

/// Methods to be measured against the first of them.
#[derive(Default)]
pub(crate) struct Race {
    entrants: Vec<(String, Run)>,
}

/// The result of a method.
#[derive(Clone, Debug)]
pub(crate) struct Timing {
    pub(crate) name: String,
    /// The median of the ratios to the first method.
    pub(crate) ratio: f64,
    /// The median time in nanoseconds per pose.
    pub(crate) nanoseconds: f64,
}

impl Race {
    pub(crate) fn enter(&mut self, name: &str, run: Run) {
        self.entrants.push((name.to_owned(), run));
    }

    pub(crate) fn run(mut self, rounds: usize, mut progress: impl FnMut(usize)) -> Vec<Timing> {
        let count = self.entrants.len();
        let mut times = vec![Vec::with_capacity(rounds); count];
        for round in 0..rounds {
            for place in 0..count {
                let entrant = (place + round) % count;
                times[entrant].push((self.entrants[entrant].1)());
            }
            progress(round + 1);
        }
        let timing = |(k, (name, _)): (usize, (String, Run))| {
            let ratios = times[k].iter().zip(&times[0]).map(|(time, reference)| time / reference);
            let (ratio, nanoseconds) = (median(ratios.collect()), median(times[k].clone()));
            Timing { name, ratio, nanoseconds }
        };
        self.entrants.into_iter().enumerate().map(timing).collect()
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Poses that do not wait for each other.
pub(crate) fn throughput<A: Copy + 'static, R>(
    inputs: Vec<A>,
    mut solve: impl FnMut(A) -> R + 'static,
) -> Run {
    Box::new(move || {
        let start = Instant::now();
        for &input in &inputs {
            // By reference: a value would be moved, and that counted.
            let result = solve(black_box(input));
            black_box(&result);
        }
        start.elapsed().as_nanos() as f64 / inputs.len() as f64
    })
}

/// Poses whose angle is known only once the last pose's acceleration is.
pub(crate) fn latency<F: Number, R>(
    angles: Vec<F>,
    mut solve: impl FnMut(F) -> R + 'static,
    last: impl Fn(&R) -> F + 'static,
) -> Run {
    Box::new(move || {
        let start = Instant::now();
        let mut nothing = F::of(0.0);
        for &angle in &angles {
            let result = solve(angle + nothing);
            // The compiler does not know that this is zero: it might be infinite.
            nothing = last(&result) * F::of(0.0);
            black_box(&result);
        }
        black_box(nothing);
        start.elapsed().as_nanos() as f64 / angles.len() as f64
    })
}

/// All poses in one call.
pub(crate) fn batch(poses: usize, mut solve: impl FnMut() + 'static) -> Run {
    Box::new(move || {
        let start = Instant::now();
        solve();
        start.elapsed().as_nanos() as f64 / poses as f64
    })
}
