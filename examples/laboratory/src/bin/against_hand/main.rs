//! The generated solvers beside the best hand forms known: on the reported mechanisms, on thirty that were
//! drawn at random, so that nothing is tuned for a single one, and on ten more with sliding joints, guides
//! on links and two inputs.
//!
//! ```text
//! cargo run --release -p laboratory --bin against_hand
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p laboratory --bin against_hand
//! ```
//!
//! Prints ratios of times, measured in turns within the run, and where there is an `objdump` what
//! the calls take in instructions. `against_hand ROUNDS NAME` measures that many rounds, and only what is
//! so named.

mod counted;
mod drawn;
mod kernels;
mod machines;
mod race;
mod solvers;
#[cfg(test)]
mod tests;

use std::collections::HashMap;

use counted::Count;
use kernels::{Contest, Visit};
use laboratory::race::median;
use race::Ratios;

const ROUNDS: usize = 1001;

/// Mechanisms that were not drawn at random.
const REPORTED: [&str; 3] = ["s1", "other_point", "s5"];

/// A line of the table.
struct Line {
    name: String,
    call: String,
    ratios: Ratios,
    counts: Option<[Count; 2]>,
}

struct Report {
    rounds: usize,
    wanted: String,
    counts: Option<HashMap<String, Count>>,
    lines: Vec<Line>,
}

impl Report {
    fn count(&self, name: &str, call: &str, way: &str) -> Option<Count> {
        let counts = self.counts.as_ref()?;
        let short = if name == "other_point" { "other" } else { name };
        let path = match name {
            _ if REPORTED.contains(&name) => format!("kernels::{short}_{call}::{way}"),
            _ => format!("drawn::{name}::{call}_{way}"),
        };
        counts.get(&path).copied()
    }
}

impl Visit for Report {
    fn contest<const N: usize>(&mut self, name: &str, call: &str, contest: &Contest<N>) {
        if !name.starts_with(&self.wanted) {
            return;
        }
        let ratios = race::ratios(contest, self.rounds);
        let count = |way| self.count(name, call, way);
        let counts = count("made").zip(count("by_hand")).map(|(made, by_hand)| [made, by_hand]);
        let line = Line { name: name.into(), call: call.into(), ratios, counts };
        println!("{}", line.text());
        self.lines.push(line);
    }
}

impl Line {
    fn text(&self) -> String {
        let Ratios { throughput, latency, nanoseconds: [each, wait] } = self.ratios;
        let mut text = format!("{:20} {:14} {throughput:7.3} {latency:7.3}", self.name, self.call);
        text += &format!("  {each:6.1} {wait:6.1}");
        if let Some(counts) = self.counts {
            let columns: [fn(Count) -> usize; 4] =
                [|c| c.instructions, |c| c.arithmetic, |c| c.constants, |c| c.shuffles];
            for column in columns {
                let [made, by_hand] = counts.map(column);
                text += &format!("   {made:4} {by_hand:4}");
            }
        }
        text
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let rounds = arguments.next().and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    let wanted = arguments.next().unwrap_or_default();
    let fused = if cfg!(target_feature = "fma") { "with" } else { "without" };
    println!("Generated over hand form, compiled {fused} fused operations, {rounds} rounds.");
    println!("Counts are the generated solver's and the hand form's.\n");
    println!(
        "{:35} through- latency  ns: each  wait  instruct. arithmetic  constants   shuffles\n{:35} put",
        "", ""
    );
    let counts = counted::counts();
    let mut report = Report { rounds, wanted, counts, lines: Vec::new() };
    kernels::reported(&mut report);
    drawn::every(&mut report);
    print_solvers(report.counts.as_ref());
    for call in ["motion", "position"] {
        let (bars, machines): (Vec<_>, Vec<_>) = report
            .lines
            .iter()
            .filter(|line| line.call == call && !REPORTED.contains(&&line.name[..]))
            .partition(|line| {
                ["four_bar_", "six_bar_"].iter().any(|start| line.name.starts_with(start))
            });
        summary(&bars, "drawn mechanisms", call);
        summary(&machines, "machines with sliding joints or two inputs", call);
    }
}

/// The instructions of what has no hand form beside it.
fn print_solvers(counts: Option<&HashMap<String, Count>>) {
    for (path, title) in solvers::called() {
        if let Some(count) = counts.and_then(|counts| counts.get(path)) {
            println!("{title:35} {:4} instructions", count.instructions);
        }
    }
}

/// A number of a line, where it has been measured.
type Column = fn(&Line) -> Option<f64>;

/// Median and worst of mechanisms.
fn summary(lines: &[&Line], what: &str, call: &str) {
    if lines.is_empty() {
        return;
    }
    let columns: [(&str, Column); 3] = [
        ("throughput", |line| Some(line.ratios.throughput)),
        ("latency", |line| Some(line.ratios.latency)),
        ("instructions", |line| {
            line.counts
                .map(|[made, by_hand]| made.instructions as f64 / by_hand.instructions as f64)
        }),
    ];
    println!("\n{} {what}, {call}:", lines.len());
    for (name, column) in columns {
        let values: Vec<f64> = lines.iter().filter_map(|line| column(line)).collect();
        if values.is_empty() {
            continue;
        }
        let worst = values.iter().copied().fold(0.0, f64::max);
        println!("  {name:13} median {:.3}, worst {worst:.3}", median(values));
    }
}
