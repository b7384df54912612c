//! Two parallelogram four-bars in a row, falling: the benchmark A02 of IFToMM's library of multibody
//! problems. Twice a turn all five bars lie in one line; there loops written as equations lose their
//! rank, and a solver may leave on the branch of the antiparallelogram.
//!
//! Declared with bars that keep parallel, the machine has no loops at all. The compiler finds that it is
//! one pendulum, q̈ = −(7/6)(g/l) cos q, which is separable, so that symplectic steps are open to it too.

use charts::{COLOURS, Curve, Panel};
use dynamics::{Motion, Run, Stopped, show};
use linkage_core::mechanism;

mechanism! {
    /// Two parallelogram four-bars in a row: thin bars of 1 m and 1 kg.
    pub struct TwoParallelograms {
        input q: angle;

        ground A0(0, 0), A1(1m, 0), A2(2m, 0);
        crank AB0(A0) -> B0 { length: 1m, angle: q }
        crank AB1(A1) -> B1 { length: 1m, angle: 0, relative_to: AB0 }
        crank AB2(A2) -> B2 { length: 1m, angle: 0, relative_to: AB0 }
        crank BB0(B0)       { angle: 0 }
        crank BB1(B1)       { angle: 0 }
        // Where the second ends of the level bars are: at B1 and B2.
        point E0 on BB0 at (1m, 0);
        point E1 on BB1 at (1m, 0);

        gravity (0, -9.81(m/s^2));
        mass 1kg on AB0 uniform;
        mass 1kg on AB1 uniform;
        mass 1kg on AB2 uniform;
        mass 1kg on BB0 at (0.5m, 0);
        mass 1kg on BB1 at (0.5m, 0);
        output B0, B1, B2, energy;
    }
}

/// All cranks upright, and B0 moving by 1 m/s along x.
const START: [f64; 2] = [std::f64::consts::FRAC_PI_2, -1.0];
const SECONDS: f64 = 10.0;
/// Where B0 is then, in m: the pendulum's elliptic functions in 30 digits.
const END: [f64; 2] = [0.328_458_111_540_815, 0.944_518_538_178_601];

fn fallen(tolerance: f64) -> Result<Run<2>, Stopped> {
    let machine = TwoParallelograms::new();
    let rates = |_: f64, state| machine.state_rates(state, 0.0);
    Motion::new([0.0, SECONDS], START, rates).tolerance(tolerance).sampled(2000)
}

/// The same by steps of 2 ms of a symplectic method, over so many seconds.
fn stepped(seconds: f64) -> Result<Run<2>, Stopped> {
    let machine = TwoParallelograms::new();
    let rates = |_: f64, state| machine.state_rates(state, 0.0);
    Motion::new([0.0, seconds], START, rates).symplectic(2e-3)
}

/// Kinetic and potential energy over those at the start, less one.
fn energies(run: &Run<2>) -> Vec<(f64, f64)> {
    let machine = TwoParallelograms::new();
    let total = |q, rate| {
        machine.energy(q, rate).map_or(f64::NAN, |energy| energy.kinetic + energy.potential)
    };
    let start = total(START[0], START[1]);
    run.curve(|_, [q, rate]| (total(q, rate) / start - 1.0).abs())
}

fn largest(points: &[(f64, f64)]) -> f64 {
    points.iter().map(|(_, value)| *value).fold(0.0, f64::max)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let machine = TwoParallelograms::new();
    println!("Two parallelograms fall for {SECONDS} s; an acceleration takes");
    println!("{}\n", TwoParallelograms::COST.forward_dynamics);
    println!(
        "{:>9} {:>12} {:>20} {:>20} {:>9}",
        "", "evaluations", "B0.x in m", "B0.y in m", "energy"
    );
    let exact = fallen(1e-13)?;
    let symplectic = stepped(SECONDS)?;
    for (name, run) in [("1e-9", &fallen(1e-9)?), ("1e-13", &exact), ("2 ms", &symplectic)] {
        let at = machine.position(run.last().1[0])?.B0;
        let energy = largest(&energies(run));
        println!("{name:>9} {:>12} {:>20.15} {:>20.15} {energy:9.1e}", run.evaluations, at.x, at.y);
    }
    println!("{:>9} {:>12} {:>20.15} {:>20.15}", "exact", "", END[0], END[1]);
    let turns = exact.curve(|_, [q, _]| q / std::f64::consts::TAU);
    let logarithms = |run: &Run<2>| {
        let worst = |chunk: &[(f64, f64)]| (chunk[0].0, largest(chunk).max(1e-17).log10());
        energies(run).chunks(50).map(worst).collect()
    };
    charts::write(
        "parallelograms",
        "Two parallelogram four-bars in a row, falling",
        2,
        vec![
            Panel::over("The cranks", ["t in s", "turns"], vec![Curve::line(COLOURS[1], &turns)]),
            Panel::over(
                "What the energy is off by, as a share",
                ["t in s", "log₁₀ of the share"],
                vec![
                    Curve::named("order 8, 1e-13", COLOURS[1], logarithms(&exact)),
                    Curve::named("symplectic, 2 ms", COLOURS[0], logarithms(&symplectic)),
                ],
            ),
        ],
    );
    let film = exact.states.iter().step_by(8).map(|[q, _]| *q);
    show(
        "parallelograms_film",
        &machine
            .film(film)
            .trace("B1")
            .label(["A0", "A1", "A2", "B0", "B1", "B2"])
            .seconds(SECONDS),
    )?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_end_where_the_pendulum_does() {
        let run = fallen(1e-13).unwrap();
        let at = TwoParallelograms::new().position(run.last().1[0]).unwrap().B0;
        let apart = (at.x - END[0]).hypot(at.y - END[1]);
        assert!(apart < 1e-9, "{apart:e}");
        // Singular poses were passed: the cranks turned over more than three times.
        assert!(run.last().1[0] < -6.0 * std::f64::consts::PI, "{}", run.last().1[0]);
    }

    #[test]
    fn the_bars_stay_as_long_as_they_are() {
        let machine = TwoParallelograms::new();
        for (_, [q, _]) in fallen(1e-6).unwrap().iter() {
            let p = machine.position(q).unwrap();
            for length in [p.B0.distance(p.B1), p.B1.distance(p.B2)] {
                assert!((length - 1.0).abs() < 4.0 * f64::EPSILON, "{q}: {length}");
            }
        }
    }

    #[test]
    fn symplectic_steps_keep_the_energy_bounded() {
        let energies = energies(&stepped(200.0).unwrap());
        let (early, late) = energies.split_at(energies.len() / 10);
        // An order-4 method that is not symplectic would be off ten times as far after ten times as long.
        assert!(largest(late) < 1.5 * largest(early), "{} {}", largest(early), largest(late));
        assert!(largest(early) < 1e-6, "{}", largest(early));
    }
}
