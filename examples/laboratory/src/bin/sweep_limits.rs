//! How near sweeps come to what the divider and the root allow: the time of a sweep over that of a loop which
//! has only the divisions and roots of the same entry point, as many as `COST` counts in the generated code.
//!
//! ```text
//! cargo run --release -p laboratory --bin sweep_limits
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin sweep_limits
//! ```
//!
//! Both run in the run-time crate's loop over blocks of poses, on the same instruction set, in turn; divisions
//! and roots of the loop do not wait for each other, and it writes one number a pose. Reported are medians over
//! the rounds, the ratio's of the times within one round. `sweep_limits ROUNDS` measures that many.

use std::hint::black_box;
use std::time::Instant;

use laboratory::generated as g;
use linkage_core::private::{Entry, Series, sweep};
use linkage_core::{Mask, Record, Scalar, SolveError, Status};

const ROUNDS: usize = 2001;

/// Poses of a round, few enough for the first cache.
const POSES: usize = 240;

/// Tells the loop below from the entry points of mechanisms.
enum OfDivider {}

/// So many divisions and square roots.
struct Divider<const DIVISIONS: u32, const ROOTS: u32>;

impl<const DIVISIONS: u32, const ROOTS: u32> Entry<OfDivider, f64, 1, 1>
    for Divider<DIVISIONS, ROOTS>
{
    #[inline(always)]
    fn solve<U: Scalar>(&self, [x]: [U; 1], put: impl FnOnce(&[U])) -> U::Mask {
        let mut sum = x;
        // Different numbers each time, so that none is a copy of another: 1/(x + 1), 2/(x + 2), …
        for nth in 0..DIVISIONS {
            let nth = U::num(f64::from(nth) + 1.0);
            sum = sum + nth / (x + nth);
        }
        for nth in 0..ROOTS {
            sum = sum + (x + U::num(f64::from(nth) + 0.5)).sqrt();
        }
        put(&[sum]);
        U::Mask::ALL
    }

    fn solve_one(&self, x: [f64; 1], put: impl FnOnce(&[f64])) -> Result<(), SolveError> {
        put(&x);
        Ok(())
    }
}

/// Nanoseconds a pose.
type Run = Box<dyn FnMut() -> f64>;

/// A sweep into as many slices as there are numbers.
fn timed<const OUT: usize>(
    run: impl Fn(&[f64], [&mut [f64]; OUT], &mut [Status]) + 'static,
) -> Run {
    // Multiples of the golden angle: all over a turn, in no order.
    let angles: Vec<f64> =
        (0..POSES).map(|k| (k as f64 * 2.399_963_229_728_653) % std::f64::consts::TAU).collect();
    let mut columns: [Vec<f64>; OUT] = std::array::from_fn(|_| vec![0.0; POSES]);
    let mut status = vec![Status::Solved; POSES];
    Box::new(move || {
        let start = Instant::now();
        run(&angles, columns.each_mut().map(|column| &mut column[..]), &mut status);
        let time = start.elapsed();
        black_box((&mut columns, &mut status));
        time.as_nanos() as f64 / POSES as f64
    })
}

fn divider<const DIVISIONS: u32, const ROOTS: u32>() -> Run {
    timed(|angles, out: [&mut [f64]; 1], status| {
        let inputs = [Series::Each(angles)];
        let swept = sweep(&Divider::<DIVISIONS, ROOTS>, inputs, out, status, ());
        assert_eq!(swept, Ok(()), "all slices are of one length");
    })
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Times a sweep and its loop in turn and prints a row.
fn compare(name: &str, counts: [u32; 2], mut runs: [Run; 2], rounds: usize) {
    let mut times = [const { Vec::new() }; 2];
    for round in 0..rounds {
        for place in 0..2 {
            let which = (place + round) % 2;
            times[which].push((runs[which])());
        }
    }
    let [sweep, limit] = times;
    let ratio = median(sweep.iter().zip(&limit).map(|(sweep, limit)| sweep / limit).collect());
    let [divisions, roots] = counts;
    let [sweep, limit] = [sweep, limit].map(median);
    println!("{name:24} {divisions:9} {roots:5} {sweep:9.2} {limit:9.2} {ratio:6.2}");
}

/// Both entry points of a mechanism.
macro_rules! compare {
    ($rounds:ident, $name:literal, $solver:ident, $position:ident, $motion:ident) => {{
        const POSITION: linkage_core::Operations = g::$solver::COST.position;
        const MOTION: linkage_core::Operations = g::$solver::COST.motion;
        let position = timed(|angles, out, status| {
            let out: g::$position<&mut [f64]> = Record::from_array(out);
            let swept = g::$solver::new().sweep_position(angles, out, status, ());
            assert_eq!(swept, Ok(()), "all slices are of one length");
        });
        let limit = divider::<{ POSITION.divisions }, { POSITION.roots }>();
        let counts = [POSITION.divisions, POSITION.roots];
        compare(concat!($name, ", position"), counts, [position, limit], $rounds);
        let motion = timed(|angles, out, status| {
            let out: g::$motion<&mut [f64]> = Record::from_array(out);
            let swept = g::$solver::new().sweep_motion(angles, 30.0, 100.0, out, status, ());
            assert_eq!(swept, Ok(()), "all slices are of one length");
        });
        let limit = divider::<{ MOTION.divisions }, { MOTION.roots }>();
        let counts = [MOTION.divisions, MOTION.roots];
        compare(concat!($name, ", motion"), counts, [motion, limit], $rounds);
    }};
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    println!("f64, nanoseconds a pose; medians of {rounds} rounds");
    println!("                         divisions roots     sweep      loop  ratio");
    compare!(rounds, "S1", FourBar, FourBarPosition, FourBarMotion);
    compare!(rounds, "S5", SixBar, SixBarPosition, SixBarMotion);
    compare!(rounds, "Stephenson III", Stephenson, StephensonPosition, StephensonMotion);
    compare!(rounds, "ten links", Chain, ChainPosition, ChainMotion);
}
