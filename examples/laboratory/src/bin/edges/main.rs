//! The slow corners of the run time: what a pose out of reach, a distance, a margin, an arc sine, a Jacobian,
//! a search and friction take, each over what the same takes without it.
//!
//! ```text
//! cargo run --release -p laboratory --bin edges
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin edges
//! ```
//!
//! Both sides of a ratio are timed in turn; reported are the median over the rounds for the named machines,
//! and for ten that `build/edges.rs` draws the median and the worst of them. `edges ROUNDS` measures that many rounds.

mod machines;
mod map;

use laboratory::race::median;

const ROUNDS: usize = 501;

fn main() {
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    let mut machines = machines::all();
    // Friction is measured on one machine, not on those that are drawn.
    machines[0].extend(machines::rubbing::pairs());
    println!("                             aim  named  drawn  worst  ns a pose, named");
    for line in 0..machines[0].len() {
        let mut measured =
            machines.iter_mut().filter_map(|pairs| Some(pairs.get_mut(line)?.measure(rounds)));
        let [named, time] = measured.next().expect("one is named");
        let drawn: Vec<f64> = measured.map(|[ratio, _]| ratio).collect();
        let worst = drawn.iter().copied().fold(0.0, f64::max);
        let pair = &machines[0][line];
        let drawn = if drawn.is_empty() { f64::NAN } else { median(drawn) };
        println!(
            "{:28} {:3.1} {named:6.2} {drawn:6.2} {worst:6.2} {time:8.1}",
            pair.what, pair.aim
        );
    }
}
