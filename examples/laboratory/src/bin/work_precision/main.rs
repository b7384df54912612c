//! Speed against error: the generated solver beside what else one can do, in one run.
//!
//! ```text
//! cargo run --release -p laboratory --bin work_precision
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin work_precision
//! ```
//!
//! Four mechanisms, each in f64 and f32: position, velocity and acceleration of every output with
//! all checks on the result. Times are ratios to the straightforward hand-written closed form,
//! measured in turns; errors are those against numbers of two words. Writes a picture of both, beside it
//! how errors grow next to a limit, and beside that what the other of the two commands has found.
//!
//! `work_precision ROUNDS` measures that many rounds instead of the default, and
//! `work_precision ROUNDS S1` nothing but the mechanisms whose name starts like that.

mod bench;
mod contest;
mod dots;
mod error;
mod forms;
mod mechanisms;
mod picture;
mod report;
#[cfg(test)]
mod tests;

use std::io::{IsTerminal, Write};

use picture::Measured;

/// Rounds of each race: enough for the medians' second digit on a busy machine.
const ROUNDS: usize = 1001;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let rounds = arguments.next().and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    let wanted = arguments.next().unwrap_or_default();
    println!("{}\n", report::heading(rounds));
    let mut contests = contest::all();
    contests.retain(|contest| contest.mechanism.starts_with(&wanted));
    let (count, is_watched) = (contests.len(), std::io::stderr().is_terminal());
    let mut measured = Vec::new();
    for (index, contest) in contests.into_iter().enumerate() {
        let title = format!("{}, {}", contest.mechanism, contest.width);
        let progress = |round: usize| {
            if is_watched && round.is_multiple_of(64) {
                let percent = round * 50 / rounds;
                eprint!("\r{} of {count}: {title}: {percent} %   ", index + 1);
                let _ = std::io::stderr().flush();
            }
        };
        let width = contest.width;
        let findings = (contest.run)(rounds, &progress);
        if is_watched {
            eprint!("\r{:60}\r", "");
        }
        report::print(&title, &findings);
        measured.push(Measured { width, findings });
    }
    if wanted.is_empty() {
        picture::write(&measured);
    }
}
