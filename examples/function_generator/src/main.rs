//! A crank-rocker that generates a function, with its lengths optimised by exact gradients.
//!
//! The rocker shall follow a parabola over 90° of crank, and the transmission angle shall stay
//! within 45° of a right angle. From six starts the lengths of coupler and rocker are sought twice:
//! by sequential quadratic programming, which is given the exact gradients of the objective and of
//! the constraints, and by COBYLA, which does without. Both must end at the same lengths; the
//! table says how many evaluations that took, how many of them until the lengths were within 10⁻⁶
//! of the end, how many gradients and how much time.

mod generator;
mod pictures;
mod search;
#[cfg(test)]
mod tests;

use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

use linkage_core::SolveError;

use generator::{Lengths, Limit};
use search::{Outcome, Progress, STARTS, Step, by_gradients, without_gradients};

type Method = fn(Lengths, Progress<'_>) -> Outcome;

const METHODS: [(&str, Method); 2] = [("slsqp", by_gradients), ("cobyla", without_gradients)];

/// The number of timed runs of each search; the shortest counts.
const ROUNDS: usize = 20;

fn main() -> Result<(), SolveError> {
    println!("Crank-rocker 1 : coupler : rocker : 5, rocker angle ψ₀ + 2/(3π) (φ − φ₀)²,");
    println!("transmission angle from 45° to 135°\n");
    println!(
        "start         method  values  to 10⁻⁶  gradients       time   coupler    rocker   objective  status"
    );
    let mut outcomes = Vec::new();
    for start in STARTS {
        let found = METHODS.map(|(name, method)| search_with_progress(name, method, start));
        let times = times(start);
        for (((name, _), outcome), time) in METHODS.into_iter().zip(&found).zip(times) {
            print_row(name, start, outcome, time);
        }
        outcomes.push(found);
    }
    let lengths = outcomes[0][0].lengths;
    let [least, largest] = Limit::BOTH.map(|limit| limit.angle(lengths).map(f64::to_degrees));
    println!("\ntransmission angle from {:.6}° to {:.6}°", least?, largest?);
    pictures::draw(&outcomes)
}

fn search_with_progress(name: &str, method: Method, start: Lengths) -> Outcome {
    let shown = stderr().is_terminal();
    let outcome = method(start, &|count, Step { lengths: [coupler, rocker], objective, .. }| {
        if shown {
            eprint!("\r{name} {count:4}: {coupler:.6} {rocker:.6} objective {objective:.8}  ");
            // A line that cannot be shown is not worth a failure.
            let _ = stderr().flush();
        }
    });
    if shown {
        eprint!("\r{:60}\r", "");
    }
    outcome
}

/// The shortest time of each method, the methods taking turns.
fn times(start: Lengths) -> [Duration; 2] {
    let mut shortest = [Duration::MAX; 2];
    for _ in 0..ROUNDS {
        for (shortest, (_, method)) in shortest.iter_mut().zip(METHODS) {
            let begun = Instant::now();
            std::hint::black_box(method(std::hint::black_box(start), &|_, _| {}));
            *shortest = begun.elapsed().min(*shortest);
        }
    }
    shortest
}

fn print_row(name: &str, start: Lengths, outcome: &Outcome, time: Duration) {
    let gradients = outcome.steps.iter().filter(|step| step.with_gradient).count();
    let digits = outcome.to_six_digits().unwrap_or(0);
    let [coupler, rocker] = outcome.lengths;
    println!(
        "{:.2}, {:.2}    {name:6} {:7} {digits:8} {gradients:10} {:7.0} µs  {coupler:.6}  {rocker:.6}  {:.8}  {}",
        start[0],
        start[1],
        outcome.steps.len(),
        time.as_secs_f64() * 1e6,
        outcome.objective,
        outcome.status,
    );
}
