//! Vibrations of one and of two masses, free, damped and forced, beside their exact solutions.
//!
//! The numbers are those of a course work: 1.6632 kg on a spring of 15 N/m, let go at 10 m; a damper of
//! 1.5 N·s/m, the critical one, and one with c/2m = 5/s; a force of 1 N at 2π rad/s; two such masses
//! in a row, of which the second is let go at 10 m, or pushed with 0.5 N. The mechanism contains
//! masses, springs and forces. The closed forms in `exact.rs` are independent of the mechanism.

mod exact;
mod pictures;

use std::f64::consts::TAU;

use dynamics::{Motion, Stopped};
use linkage_core::mechanism;

mechanism! {
    /// A mass on a spring and a damper.
    pub struct Oscillator {
        /// From where the spring is at rest.
        input x: length;
        param k = 15(N/m);
        param c = 0(N*s/m);
        load push: force;

        ground O(0, 0);
        guide rail through (15m, 0) along 0deg;
        slider body(rail) -> P { slide: x }

        mass 1.6632kg on P;
        spring between O and P { stiffness: k, free_length: 15m }
        force (push - c * rate(x), 0) on P;
        output P;
    }
}

mechanism! {
    /// Two masses in a row on two springs: each from where it is at rest.
    pub struct TwoMasses {
        input x, y: length;
        param k = 15(N/m);
        load push: force;

        ground O(0, 0);
        guide inner through (15m, 0) along 0deg;
        guide outer through (40m, 0) along 0deg;
        slider first(inner) -> P { slide: x }
        slider second(outer) -> Q { slide: y }

        mass 1.6632kg on P;
        mass 1.6632kg on Q;
        spring between O and P { stiffness: k, free_length: 15m }
        spring between P and Q { stiffness: k, free_length: 25m }
        force (push, 0) on Q;
        output P, Q;
    }
}

/// In kg and N/m.
const MASS: f64 = 1.6632;
const STIFFNESS: f64 = 15.0;
/// Where masses are let go, in m.
const START: f64 = 10.0;
/// The frequency of the forces, in rad/s, and their amplitudes in N on one mass and on the second of two.
const FREQUENCY: f64 = TAU;
const PUSH: f64 = 1.0;
const PUSH_ON_TWO: f64 = 0.5;

const SECONDS: f64 = 12.0;
const SAMPLES: u32 = 480;
const TOLERANCE: f64 = 1e-13;

/// One mass of one case: where it is over time by the integrator and by the closed form, in m.
struct Trace {
    name: &'static str,
    found: Vec<(f64, f64)>,
    exact: Vec<(f64, f64)>,
    evaluations: usize,
}

impl Trace {
    /// The largest way of the exact solution.
    fn amplitude(&self) -> f64 {
        self.exact.iter().map(|(_, x)| x.abs()).fold(0.0, f64::max)
    }

    /// Over time, as a share of the amplitude.
    fn errors(&self) -> Vec<(f64, f64)> {
        let amplitude = self.amplitude();
        let both = self.found.iter().zip(&self.exact);
        both.map(|((t, found), (_, exact))| (*t, (found - exact).abs() / amplitude)).collect()
    }

    fn worst(&self) -> f64 {
        self.errors().into_iter().map(|(_, error)| error).fold(0.0, f64::max)
    }
}

/// One mass with a damper, let go at `start`, under a force `push` cos wt.
fn one(
    name: &'static str,
    [damper, start, push]: [f64; 3],
    exact: impl Fn(f64) -> f64,
) -> Result<Trace, Stopped> {
    let machine = Oscillator { c: damper, ..Oscillator::new() };
    let rates = |t: f64, state| machine.state_rates(state, 0.0, push * (FREQUENCY * t).cos());
    let motion = Motion::new([0.0, SECONDS], [start, 0.0], rates).tolerance(TOLERANCE);
    let run = motion.sampled(SAMPLES)?;
    Ok(Trace {
        name,
        found: run.curve(|_, [x, _]| x),
        exact: run.curve(|t, _| exact(t)),
        evaluations: run.evaluations,
    })
}

/// Both masses, let go at `start`, the second under a force `push` cos wt.
fn two(
    names: [&'static str; 2],
    (start, push): ([f64; 2], f64),
    exact: impl Fn(f64) -> [f64; 2],
) -> Result<[Trace; 2], Stopped> {
    let machine = TwoMasses::new();
    let rates = |t: f64, state| machine.state_rates(state, [0.0; 2], push * (FREQUENCY * t).cos());
    let start = [start[0], start[1], 0.0, 0.0];
    let run = Motion::new([0.0, SECONDS], start, rates).tolerance(TOLERANCE).sampled(SAMPLES)?;
    Ok([0, 1].map(|mass| Trace {
        name: names[mass],
        found: run.curve(|_, state| state[mass]),
        exact: run.curve(|t, _| exact(t)[mass]),
        evaluations: run.evaluations,
    }))
}

/// Every case: free and forced with one mass, free and forced with two.
struct Cases {
    free: Vec<Trace>,
    forced: Vec<Trace>,
    two_free: Vec<Trace>,
    two_forced: Vec<Trace>,
}

impl Cases {
    fn all(&self) -> impl Iterator<Item = &Trace> {
        let one = self.free.iter().chain(&self.forced);
        one.chain(&self.two_free).chain(&self.two_forced)
    }
}

fn cases() -> Result<Cases, Stopped> {
    let [m, k, w] = [MASS, STIFFNESS, FREQUENCY];
    let (light, critical, heavy) = (1.5, 2.0 * (k * m).sqrt(), 2.0 * m * 5.0);
    let free = vec![
        one("undamped", [0.0, START, 0.0], exact::underdamped([m, 0.0, k], START))?,
        one("under-damped", [light, START, 0.0], exact::underdamped([m, light, k], START))?,
        one("critically damped", [critical, START, 0.0], exact::critical([m, k], START))?,
        one("over-damped", [heavy, START, 0.0], exact::overdamped([m, heavy, k], START))?,
    ];
    let forced = vec![
        one("forced, undamped", [0.0, 0.0, PUSH], exact::forced([m, 0.0, k], [PUSH, w]))?,
        one("forced, damped", [light, 0.0, PUSH], exact::forced([m, light, k], [PUSH, w]))?,
    ];
    let names = ["first of two, free", "second of two, free"];
    let two_free = two(names, ([0.0, START], 0.0), exact::two_free([m, k], [0.0, START]))?;
    let names = ["first of two, forced", "second of two, forced"];
    let from_rest = exact::two_forced([m, k], [PUSH_ON_TWO, w]);
    let two_forced = two(names, ([0.0; 2], PUSH_ON_TWO), from_rest)?;
    // Let go where the vibration that stays would have them, they have no other.
    let steady = exact::two_steady([m, k], [PUSH_ON_TWO, w]);
    let names = ["first of two, steady", "second of two, steady"];
    let two_steady = two(names, (steady, PUSH_ON_TWO), |t| steady.map(|x| x * (w * t).cos()))?;
    let two_forced = two_forced.into_iter().chain(two_steady).collect();
    Ok(Cases { free, forced, two_free: two_free.into(), two_forced })
}

fn main() -> Result<(), Stopped> {
    let cases = cases()?;
    println!("Vibrations over {SECONDS} s, each beside its closed form\n");
    println!("{:>22} {:>12} {:>12} {:>12}", "", "amplitude", "error of it", "evaluations");
    for trace in cases.all() {
        println!(
            "{:>22} {:>10.6} m {:>12.1e} {:>12}",
            trace.name,
            trace.amplitude(),
            trace.worst(),
            trace.evaluations
        );
    }
    pictures::draw(&cases);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_within_1e_10_of_its_amplitude() {
        let cases = cases().unwrap();
        assert_eq!(cases.all().count(), 12);
        for trace in cases.all() {
            assert!(trace.worst() <= 1e-10, "{}: {:e}", trace.name, trace.worst());
            assert!(trace.amplitude() > 1e-3, "{}", trace.name);
        }
    }

    /// The closed forms by themselves: they begin where they should, and obey their equation of
    /// motion, by central differences of an h whose square times the fourth derivative and whose
    /// rounding of 1e-16/h² are both below the bound.
    #[test]
    fn the_closed_forms_obey_their_equations() {
        let ([m, k, w], h) = ([MASS, STIFFNESS, FREQUENCY], 1e-4);
        let obeys = |x: &dyn Fn(f64) -> f64, c: f64, start: f64, push: f64| {
            assert!((x(0.0) - start).abs() < 1e-14 * START, "{}", x(0.0));
            let size = START.max(1.0) * k;
            assert!((x(h) - x(-h)).abs() / (2.0 * h) < 1e-5 * size);
            for step in 1..40 {
                let t = 0.25 * f64::from(step);
                let rate = (x(t + h) - x(t - h)) / (2.0 * h);
                let second = (x(t + h) - 2.0 * x(t) + x(t - h)) / (h * h);
                let left = m * second + c * rate + k * x(t) - push * (w * t).cos();
                assert!(left.abs() < 1e-5 * size, "{t}: {left}");
            }
        };
        let (critical, heavy) = (2.0 * (k * m).sqrt(), 10.0 * m);
        obeys(&exact::underdamped([m, 0.0, k], START), 0.0, START, 0.0);
        obeys(&exact::underdamped([m, 1.5, k], START), 1.5, START, 0.0);
        obeys(&exact::critical([m, k], START), critical, START, 0.0);
        obeys(&exact::overdamped([m, heavy, k], START), heavy, START, 0.0);
        obeys(&exact::forced([m, 0.0, k], [PUSH, w]), 0.0, 0.0, PUSH);
        obeys(&exact::forced([m, 1.5, k], [PUSH, w]), 1.5, 0.0, PUSH);
    }

    #[test]
    fn energy_that_a_damper_takes_is_gone_and_no_other() {
        let machine = Oscillator { c: 1.5, ..Oscillator::new() };
        // A third state: what the damper has taken, c ẋ².
        let rates = |_: f64, [x, v, _]: [f64; 3]| {
            let [v, a] = machine.state_rates([x, v], 0.0, 0.0)?;
            Ok([v, a, 1.5 * v * v])
        };
        let run = Motion::new([0.0, 5.0], [START, 0.0, 0.0], rates).tolerance(1e-13).ended();
        let (_, [x, v, taken]) = run.unwrap().last();
        let left = 0.5 * MASS * v * v + 0.5 * STIFFNESS * x * x + taken;
        let start = 0.5 * STIFFNESS * START * START;
        assert!((left - start).abs() < 1e-11 * start, "{left} {start}");
    }
}
