//! The efficiency of sweeps on this machine: the time of a sweep over that of a loop which has only the
//! divisions and roots of the same entry point, as many as `COST` counts in the generated code, and over that
//! of a loop which has its sines, additions and products as well, each product in one operation with a sum.
//!
//! ```text
//! cargo run --release -p laboratory --bin sweep_limits
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin sweep_limits
//! ```
//!
//! All run in the run-time crate's loop over blocks of poses, on the same instruction set, in turn; what the
//! loops compute hardly waits for each other, and they write one number a pose. Reported are medians over the
//! rounds, the ratios' of the times within one round. `sweep_limits ROUNDS` measures that many.

use laboratory::generated as g;
use laboratory::race::{Race, Run, angles, swept};
use linkage_core::private::{Entry, Series, sweep};
use linkage_core::{Mask, Record, Scalar, SolveError, Status};

const ROUNDS: usize = 2001;

/// Poses of a round, few enough for the first cache.
const POSES: usize = 240;

/// Tells the loops below from the entry points of mechanisms.
enum OfNothing {}

/// So many divisions and square roots, and so many sines with their cosines and sums with a product.
#[derive(Clone, Copy)]
struct Arithmetic<const DIVISIONS: u32, const ROOTS: u32, const SINES: u32, const SUMS: u32>;

/// The number of sums of a pose that go on beside each other. For the two poses that a sweep computes
/// together, these are more sums than a processor begins while one is under way (two each cycle, four cycles
/// long), and few enough for its registers.
const CHAINS: usize = 6;

/// For how many sums of each chain `sums` is written out.
const ROUNDS_OF_SUMS: usize = 56;

impl<const DIVISIONS: u32, const ROOTS: u32, const SINES: u32, const SUMS: u32>
    Entry<OfNothing, f64, 1, 1> for Arithmetic<DIVISIONS, ROOTS, SINES, SUMS>
{
    #[inline(always)]
    fn solve<U: Scalar>(&self, [x]: [U; 1], put: impl FnOnce(&[U])) -> U::Mask {
        let mut sum = x;
        // Written out: what remained a loop would keep poses from being put together in vectors.
        macro_rules! all {
            ($($nth:literal)*) => {$(
                // Different numbers each time, so that none is a copy of another: 1/(x + 1), 2/(x + 2), …
                if $nth < DIVISIONS {
                    let nth = U::num(f64::from($nth) + 1.0);
                    sum = sum + nth / (x + nth);
                }
                if $nth < ROOTS {
                    sum = sum + (x + U::num(f64::from($nth) + 0.5)).sqrt();
                }
            )*};
        }
        all!(0 1 2 3 4 5 6 7);
        const { assert!(SUMS as usize <= ROUNDS_OF_SUMS * CHAINS && SINES <= 1) };
        const { assert!(DIVISIONS <= 8 && ROOTS <= 8) };
        let (sin, cos) = if SINES > 0 { x.sin_cos_near() } else { (x, x) };
        sum = sum + sums(SUMS as usize, sin, cos);
        put(&[sum]);
        U::Mask::ALL
    }

    fn solve_one(&self, x: [f64; 1], put: impl FnOnce(&[f64])) -> Result<(), SolveError> {
        put(&x);
        Ok(())
    }
}

/// So many sums with a product, in loops so short that they are unrolled.
#[inline(always)]
fn sums<U: Scalar>(count: usize, factor: U, first: U) -> U {
    let mut chains: [U; CHAINS] =
        std::array::from_fn(|nth| if nth % 2 == 0 { first } else { factor });
    macro_rules! a_round {
        ($($from:literal)*) => {$(
            for (nth, chain) in chains.iter_mut().enumerate() {
                if $from * CHAINS + nth < count {
                    *chain = U::fused(*chain, factor, U::num($from as f64 + nth as f64 / CHAINS as f64));
                }
            }
        )*};
    }
    // As many as `ROUNDS_OF_SUMS`.
    a_round!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27);
    a_round!(28 29 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55);
    chains.into_iter().reduce(|a, b| a + b).unwrap_or(first)
}

/// A sweep into as many slices as there are numbers.
fn timed<const OUT: usize>(
    run: impl Fn(&[f64], [&mut [f64]; OUT], &mut [Status]) + 'static,
) -> Run {
    let angles: Vec<f64> = angles().take(POSES).collect();
    swept(POSES, move |out, status| run(&angles, out, status))
}

fn alone<const DIVISIONS: u32, const ROOTS: u32, const SINES: u32, const SUMS: u32>() -> Run {
    timed(|angles, out: [&mut [f64]; 1], status| {
        let inputs = [Series::Each(angles)];
        let loops = Arithmetic::<DIVISIONS, ROOTS, SINES, SUMS>;
        let swept = sweep(&loops, inputs, out, status, ());
        assert_eq!(swept, Ok(()), "all slices are of one length");
    })
}

/// Times a sweep and its two loops in turn and prints a row.
fn compare(name: &str, [divisions, roots]: [u32; 2], runs: [Run; 3], rounds: usize) {
    let mut race = Race::default();
    runs.into_iter().for_each(|run| race.enter(name, run));
    let times = race.run(rounds, |_| {});
    let [sweep, divider, arithmetic] = [0, 1, 2].map(|way| times[way].nanoseconds);
    // The ratios of a round are to the sweep, and the median of their inverses is the inverse of the median.
    let [over_divider, over_arithmetic] = [1, 2].map(|way| 1.0 / times[way].ratio);
    print!("{name:24} {divisions:9} {roots:5} {sweep:9.2} {divider:9.2} {over_divider:6.2}");
    println!(" {arithmetic:12.2} {over_arithmetic:6.2}");
}

/// The least number of operations for additions and products, where one operation has one of each.
const fn at_least(cost: linkage_core::Operations) -> u32 {
    if cost.additions > cost.multiplications { cost.additions } else { cost.multiplications }
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
        let divider = alone::<{ POSITION.divisions }, { POSITION.roots }, 0, 0>();
        let all = alone::<
            { POSITION.divisions },
            { POSITION.roots },
            { POSITION.sines },
            { at_least(POSITION) },
        >();
        let counts = [POSITION.divisions, POSITION.roots];
        compare(concat!($name, ", position"), counts, [position, divider, all], $rounds);
        let motion = timed(|angles, out, status| {
            let out: g::$motion<&mut [f64]> = Record::from_array(out);
            let swept = g::$solver::new().sweep_motion(angles, 30.0, 100.0, out, status, ());
            assert_eq!(swept, Ok(()), "all slices are of one length");
        });
        let divider = alone::<{ MOTION.divisions }, { MOTION.roots }, 0, 0>();
        let all = alone::<
            { MOTION.divisions },
            { MOTION.roots },
            { MOTION.sines },
            { at_least(MOTION) },
        >();
        let counts = [MOTION.divisions, MOTION.roots];
        compare(concat!($name, ", motion"), counts, [motion, divider, all], $rounds);
    }};
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    println!("f64, nanoseconds a pose; medians of {rounds} rounds");
    println!(
        "                         divisions roots     sweep   divider  ratio   arithmetic  ratio"
    );
    compare!(rounds, "S1", FourBar, FourBarPosition, FourBarMotion);
    compare!(rounds, "S5", SixBar, SixBarPosition, SixBarMotion);
    compare!(rounds, "Stephenson III", Stephenson, StephensonPosition, StephensonMotion);
    compare!(rounds, "ten links", Chain, ChainPosition, ChainMotion);
}
