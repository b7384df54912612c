//! Motions under forces through change points: poses in which all bars lie in one line, and from which a
//! machine can go on in two ways. Its inertia takes it on as it came.
//!
//! A solver keeps its modes, and at a change point another motion has them from there on: integrated by
//! `state_rates` alone, the links jump to other velocities, and the energy to another value. `Tracker`
//! changes the modes, so that velocities stay continuous. A hundred turns of three machines tell how well
//! the energy is kept: no drive and no friction, and gravity.

use std::cell::Cell;
use std::f64::consts::TAU;

use charts::{COLOURS, Curve, Panel};
use dynamics::{Motion, Run, Stopped};
use linkage_core::{Sense, Side, SolveError, Tracker, mechanism};

mechanism! {
    /// Bars of 1 m and 2 m, equal in pairs: two change points a turn.
    pub struct FallingPairs {
        input q: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        gravity (0, -9.81(m/s^2));
        mass 1kg on AB uniform;
        mass 2kg on BC uniform;
        mass 1kg on DC uniform;
        output DC, energy;
    }
}

mechanism! {
    /// Bars of 4 m, 1 m, 2 m and 3 m: one change point a turn, and two turns to be as before.
    pub struct FallingFourBar {
        input q: angle;
        param elbow: mode = left;

        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B        { length: 1m, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 3m), mode: elbow }

        gravity (0, -9.81(m/s^2));
        mass 1kg on AB uniform;
        mass 2kg on BC uniform;
        mass 1kg on DC uniform;
        output DC, energy;
    }
}

mechanism! {
    /// Crank and rod of one length: twice a turn the block is at the crank's pivot, and may stay there
    /// while the rod turns with the crank.
    pub struct FallingSliderCrank {
        input q: angle;
        param side: mode = ahead;

        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        crank AB(A) -> B              { length: 1m, angle: q }
        rrp   BC(B), block(rail) -> C { length: 1m, mode: side }

        gravity (0, -9.81(m/s^2));
        mass 1kg on AB uniform;
        mass 2kg on BC uniform;
        mass 1kg on C;
        output block, energy;
    }
}

/// The crank's angle and rate in rad and rad/s.
type State = [f64; 2];

const TURNS: f64 = 100.0;

/// A machine that is let go.
struct Fall<'a> {
    name: &'static str,
    start: State,
    rates: &'a dyn Fn(State) -> Result<State, SolveError>,
    /// Kinetic and potential, in J.
    energy: &'a dyn Fn(State) -> Result<f64, SolveError>,
}

impl Fall<'_> {
    /// Samples over so many turns.
    fn turned(&self, turns: f64, tolerance: f64) -> Result<Run<2>, Stopped> {
        let start = self.start[0];
        Motion::new([0.0, 1000.0], self.start, |_, state| (self.rates)(state))
            .tolerance(tolerance)
            .until(0.02, |_, [q, _]| (q - start).abs() - turns * TAU)
    }

    /// The error of the energy, as a share of the first, over the turns.
    fn off(&self, run: &Run<2>) -> Vec<(f64, f64)> {
        let total = |state| (self.energy)(state).unwrap_or(f64::NAN);
        let first = total(self.start);
        let share = |[q, v]: State| (total([q, v]) / first - 1.0).abs();
        run.iter()
            .map(|(_, state)| ((state[0] - self.start[0]).abs() / TAU, share(state)))
            .collect()
    }
}

/// Calls `with` with the fall of a solver, followed by a tracker or with the modes it has.
macro_rules! fall {
    ($name:literal, $solver:expr, $start:expr, $is_followed:expr, $with:expr) => {{
        let tracker = Cell::new(Tracker::new($solver));
        let rates = |[q, v]: State| match $is_followed {
            true => {
                let mut tracked = tracker.get();
                let rates = tracked.follow(q, v, |solver, q| solver.state_rates([q, v], 0.0));
                tracker.set(tracked);
                rates
            }
            false => $solver.state_rates([q, v], 0.0),
        };
        let energy = |[q, v]: State| {
            let mut tracked = tracker.get();
            let energy = match $is_followed {
                true => tracked.follow(q, v, |solver, q| solver.energy(q, v))?,
                false => $solver.energy(q, v)?,
            };
            tracker.set(tracked);
            Ok(energy.kinetic + energy.potential)
        };
        $with(&Fall { name: $name, start: $start, rates: &rates, energy: &energy })
    }};
}

/// All falls, one after the other.
fn each(is_followed: bool, mut with: impl FnMut(&Fall)) {
    let pairs = FallingPairs::new();
    fall!("parallelogram", pairs, [1.0, -8.0], is_followed, with);
    let anti = FallingPairs { elbow: Side::Right, ..pairs };
    fall!("antiparallelogram", anti, [1.0, -8.0], is_followed, with);
    fall!("bars 4, 1, 2, 3", FallingFourBar::new(), [1.0, 8.0], is_followed, with);
    let slider = FallingSliderCrank { side: Sense::Ahead, ..FallingSliderCrank::new() };
    fall!("equal slider-crank", slider, [1.0, 8.0], is_followed, with);
}

fn largest(points: &[(f64, f64)]) -> f64 {
    // NaN is larger than any number here.
    points.iter().fold(0.0, |most, (_, value)| if *value <= most { most } else { *value })
}

fn main() {
    println!(
        "What the energy is off by, as a share, after {TURNS} turns of a tracker, and after one of"
    );
    println!("a solver that keeps its mode:\n");
    println!("{:>20} {:>12} {:>10} {:>16}", "", "evaluations", "tracker", "constant mode");
    let mut curves = Vec::new();
    let mut constant = Vec::new();
    each(false, |fall| {
        constant.push(match fall.turned(1.0, 1e-6) {
            Ok(run) => format!("{:.2}", largest(&fall.off(&run))),
            Err(stopped) => stopped.to_string(),
        });
    });
    let mut constant = constant.into_iter();
    each(true, |fall| {
        let beside = constant.next().unwrap_or_default();
        match fall.turned(TURNS, 1e-13) {
            Ok(run) => {
                let off = fall.off(&run);
                let (name, most) = (fall.name, largest(&off));
                println!("{name:>20} {:>12} {most:10.1e} {beside:>16}", run.evaluations);
                let worst = |chunk: &[(f64, f64)]| (chunk[0].0, largest(chunk).max(1e-17).log10());
                let colour = COLOURS[curves.len()];
                curves.push(Curve::named(name, colour, off.chunks(40).map(worst).collect()));
            }
            Err(stopped) => println!("{:>20} {stopped}", fall.name),
        }
    });
    charts::write(
        "change_points",
        "A hundred turns through change points",
        1,
        vec![Panel::over(
            "What the energy is off by, as a share",
            ["turns of the crank", "log₁₀ of the share"],
            curves,
        )],
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rounding of an acceleration at the edge of what is interpolated, w = √(2 · 2e-3) from a change
    /// point, is some 16 ε/w³ v² = 1.4e-11 v² here; over the 2 w/v that it lasts it changes v by
    /// 2 · 1.4e-11 w v, the energy by twice that share, 3.5e-12, and two hundred passages, unlike each
    /// other, by √200 times as much: 5e-11. Integration adds less.
    #[test]
    fn a_hundred_turns_through_change_points_keep_the_energy() {
        let mut count = 0;
        each(true, |fall| {
            let run = fall.turned(TURNS, 1e-13).unwrap();
            assert!(run.is_interrupted, "{}: {:?}", fall.name, run.last());
            let most = largest(&fall.off(&run));
            println!("{}: {most:e}", fall.name);
            assert!(most < 1e-10, "{}: {most:e}", fall.name);
            count += 1;
        });
        assert_eq!(count, 4);
    }

    /// The parallelogram's crank is a pendulum: 8/3 q̈ = −3 g cos q, from bars whose centres it moves as
    /// its own or as its pin.
    #[test]
    fn a_parallelogram_that_is_followed_is_a_pendulum() {
        fall!("parallelogram", FallingPairs::new(), [1.0, -8.0], true, |fall: &Fall| {
            let run = fall.turned(3.0, 1e-13).unwrap();
            for (_, [q, v]) in run.iter() {
                let energy = 4.0 / 3.0 * v * v + 3.0 * 9.81 * q.sin();
                let first = 4.0 / 3.0 * 64.0 + 3.0 * 9.81 * 1.0_f64.sin();
                assert!((energy / first - 1.0).abs() < 1e-10, "{q}: {energy} for {first}");
            }
        });
    }

    /// Why a tracker is wanted: the energy jumps, or the motion is refused.
    #[test]
    fn with_constant_modes_the_energy_is_not_kept() {
        each(false, |fall| {
            if let Ok(run) = fall.turned(1.0, 1e-6) {
                let most = largest(&fall.off(&run));
                assert!(most > 0.1, "{}: {most}", fall.name);
            }
        });
    }
}
