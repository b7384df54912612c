//! Errors with constant dimensions and with the same ones as parameters, on random poses of the mechanisms that
//! `build/twins.rs` draws: of every group, behind cranks and between them, next to limits to the
//! last place, next to quarter turns and after thousands of turns, in both widths.
//!
//! ```text
//! cargo run --release -p laboratory --bin errors
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin errors
//! ```
//!
//! `errors POSES SEED` draws that many poses of a mechanism and width. An error is in units of what half a
//! unit in the last place of every dimension, input and rate changes, added up, and of half a unit of the
//! number itself: 1 is an error that the data allow. The truth is the mechanism with its dimensions as
//! parameters on numbers of two words.

mod measure;
mod poses;
mod tally;
#[cfg(test)]
mod tests;
mod twins;

use std::thread;
use std::time::Instant;

use linkage_tests::measured::Width;
use linkage_tests::measured::poses::Source;
use tally::Tally;
use twins::Twin;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().map_or(10_000, |text| text.parse().expect("a number of poses"));
    let seed = arguments.next().map_or(1, |text| text.parse().expect("a seed"));
    let fused = if cfg!(target_feature = "fma") { "with" } else { "without" };
    let twins = twins::all();
    println!(
        "{} mechanisms, {count} poses of each in either width, seed {seed}, {fused} fused operations\n",
        twins.len()
    );
    let start = Instant::now();
    let tallies = thread::scope(|scope| {
        let searches = [Width::Double, Width::Single].map(|width| {
            let twins = &twins;
            scope.spawn(move || search(twins, width, count, seed))
        });
        searches.map(|search| search.join().expect("no search panics"))
    });
    tally::report(&tallies);
    println!("\n{:.0} s", start.elapsed().as_secs_f64());
}

fn search(twins: &[Twin], width: Width, count: usize, seed: u64) -> Vec<Tally> {
    let mut tallies: Vec<Tally> = Vec::new();
    for (index, twin) in twins.iter().enumerate() {
        // One mechanism's poses do not depend on the others.
        let mut source = Source::new(seed.wrapping_add((index as u64) << 32));
        let place = tallies.iter().position(|tally| tally.group == twin.group);
        let place = place.unwrap_or_else(|| {
            tallies.push(Tally::new(twin.group, width));
            tallies.len() - 1
        });
        for _ in 0..count {
            let pose = poses::draw(twin, &mut source, width);
            let sample = measure::measure(twin, &pose, width);
            tallies[place].note(twin, &pose, sample);
        }
    }
    tallies
}
