//! A crank-rocker that generates a function, with its lengths found by `linkage-design`.
//!
//! The rocker shall follow a parabola over 90° of crank, and the transmission angle shall stay
//! within 45° of a right angle. From six starts the lengths of coupler and rocker are sought by exact
//! derivatives. All must end at the same lengths; the table says how many evaluations that took, how many of
//! them until the lengths were within 10⁻⁶ of the end, and how much time.

mod generator;
mod pictures;
mod search;
#[cfg(test)]
mod tests;

use std::error::Error;
use std::time::{Duration, Instant};

use generator::{Lengths, Limit, Transmission};
use search::{Outcome, STARTS, Step, search};

/// The number of timed runs of each search; the shortest counts.
const ROUNDS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    println!("Crank-rocker 1 : coupler : rocker : 5, rocker angle ψ₀ + 2/(3π) (φ − φ₀)²,");
    println!("transmission angle from 45° to 135°\n");
    println!(
        "start         values  slopes  refused  to 10⁻⁶       time   coupler    rocker   objective"
    );
    let mut outcomes = Vec::new();
    for start in STARTS {
        let outcome = search(start)?;
        print_row(start, &outcome, time(start)?);
        outcomes.push(outcome);
    }
    println!("\n{}", outcomes[0].found);
    let [coupler, rocker] = outcomes[0].lengths();
    let bars = Transmission { coupler, rocker };
    let [least, largest] = Limit::BOTH.map(|limit| limit.angle(&bars).map(f64::to_degrees));
    println!("transmission angle from {:.6}° to {:.6}°", least?, largest?);
    Ok(pictures::draw(&outcomes)?)
}

/// The shortest time of a search.
fn time(start: Lengths) -> Result<Duration, Box<dyn Error>> {
    let mut shortest = Duration::MAX;
    for _ in 0..ROUNDS {
        let begun = Instant::now();
        std::hint::black_box(search(std::hint::black_box(start))?);
        shortest = begun.elapsed().min(shortest);
    }
    Ok(shortest)
}

fn print_row(start: Lengths, outcome: &Outcome, time: Duration) {
    let [coupler, rocker] = outcome.lengths();
    let count = |of: fn(&Step) -> bool| outcome.steps.iter().filter(|step| of(step)).count();
    println!(
        "{:.2}, {:.2}    {:7} {:7} {:8} {:8} {:7.0} µs  {coupler:.6}  {rocker:.6}  {:.8}",
        start[0],
        start[1],
        outcome.steps.len(),
        count(|step| step.with_slopes),
        count(|step| step.objective.is_none()),
        outcome.to_six_digits().unwrap_or(0),
        time.as_secs_f64() * 1e6,
        outcome.found.cost,
    );
}
