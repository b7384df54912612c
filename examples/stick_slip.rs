//! A block on a spring with dry friction, to its rest by events; and with a smooth sign, which creeps.
//!
//! With the sign itself a motion ends exactly: where the rate is zero the integrator stops, and asks for the second
//! rate there. The solver answers zero as long as friction holds the block. A smooth sign has no friction
//! at rest, so that the block creeps on, the slower the smaller the smoothing, at ever more steps.

use charts::{COLOURS, Curve, GREY, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A block of 2 kg on a level guide.
    pub struct DryBlock {
        input x: length;
        ground O(0, 0);
        guide bed through O along 0deg;
        slider block(bed) -> P { slide: x }
        gravity (0, -9.81(m/s^2));
        mass 2kg on block at (0, 0);
        force (-800(N/m) * x, 0) on P;
        friction 0.25 on block;
        output x.drive, losses;
    }
}

mechanism! {
    /// The same with a smooth sign.
    pub struct CreepingBlock {
        input x: length;
        param smoothing = 0.001(m/s);
        ground O(0, 0);
        guide bed through O along 0deg;
        slider block(bed) -> P { slide: x }
        gravity (0, -9.81(m/s^2));
        mass 2kg on block at (0, 0);
        force (-800(N/m) * x, 0) on P;
        friction 0.25 on block smooth smoothing;
        output x.drive, losses;
    }
}

const MASS: f64 = 2.0;
const STIFFNESS: f64 = 800.0;
const RELEASED_AT: f64 = 0.1;
/// The energy that a metre takes.
const FORCE: f64 = 0.25 * MASS * 9.81;

/// Place, rate, and the work that friction has taken.
type State = [f64; 3];

/// Places in millimetres over time.
type Way = Vec<(f64, f64)>;

/// A step of the classical Runge–Kutta method.
fn step(
    rates: impl Fn([f64; 2]) -> Result<[f64; 2], SolveError>,
    [x, rate]: [f64; 2],
    h: f64,
) -> Result<[f64; 2], SolveError> {
    let along = |k: [f64; 2], h: f64| [x + h * k[0], rate + h * k[1]];
    let k1 = rates([x, rate])?;
    let k2 = rates(along(k1, h / 2.0))?;
    let k3 = rates(along(k2, h / 2.0))?;
    let k4 = rates(along(k3, h))?;
    let mean = |i: usize| h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    Ok([x + mean(0), rate + mean(1)])
}

/// From rest to the next rest.
///
/// A step that would turn the motion about ends shortly before: the rate, which falls almost along a line,
/// is a thousandth of what it was. Once rounding is all that is left of it, it is zero.
fn half_turn(
    block: &DryBlock,
    from: State,
    mut told: impl FnMut(f64, State),
) -> Result<State, SolveError> {
    const STEP: f64 = 1e-4;
    let rates = |state| block.state_rates(state, 0.0);
    let [_, start] = rates([from[0], 0.0])?;
    let (mut state, mut time) = (from, 0.0);
    loop {
        let [x, rate, lost] = state;
        let [_, second] = rates([x, rate])?;
        let left = if time > 0.0 { -0.999 * rate / second } else { STEP };
        let h = if left > 0.0 { left.min(STEP) } else { STEP };
        let [next, next_rate] = step(rates, [x, rate], h)?;
        state = [next, next_rate, lost + FORCE * (next - x).abs()];
        time += h;
        told(time, state);
        if next_rate * start <= 0.0 || h < 1e-18 {
            return Ok([next, 0.0, state[2]]);
        }
    }
}

/// Turning points to the last, at which friction holds the block, and the way there over time.
fn by_events() -> Result<(Vec<State>, Way), SolveError> {
    let block = DryBlock::new();
    let (mut turns, mut way) = (vec![[RELEASED_AT, 0.0, 0.0]], vec![(0.0, 1e3 * RELEASED_AT)]);
    let mut before = 0.0;
    loop {
        let last = turns[turns.len() - 1];
        if block.forward_dynamics(last[0], 0.0, 0.0)? == 0.0 {
            return Ok((turns, way));
        }
        let (mut now, mut shown) = (before, before);
        let next = half_turn(&block, last, |time, state| {
            now = before + time;
            if now - shown > 2e-3 {
                shown = now;
                way.push((now, 1e3 * state[0]));
            }
        })?;
        before = now;
        way.push((now, 1e3 * next[0]));
        turns.push(next);
    }
}

/// The block under a smooth sign after so many seconds, by steps that its stiffness bears.
fn creeping(smoothing: f64, seconds: f64) -> Result<(Way, usize), SolveError> {
    let block = CreepingBlock { smoothing };
    let rates = |state| block.state_rates(state, 0.0);
    // The rate falls by μ g/e a second of itself, and the method bears 2.7 over that.
    let h = (0.5 * smoothing / (0.25 * 9.81)).min(1e-3);
    let steps = (seconds / h).ceil() as usize;
    let (mut state, mut way) = ([RELEASED_AT, 0.0], Vec::new());
    for nth in 0..=steps {
        if nth % steps.div_ceil(1500) == 0 || nth == steps {
            way.push((nth as f64 * h, 1e3 * state[0]));
        }
        state = step(rates, state, h)?;
    }
    Ok((way, 4 * steps))
}

fn main() -> Result<(), SolveError> {
    let (turns, way) = by_events()?;
    println!("released at {} mm; turning points:\n", 1e3 * RELEASED_AT);
    println!("{:>10} {:>12} {:>14}", "mm", "closed form", "energy apart");
    // Friction takes 2 μ m g/k from each half turn.
    let shrinks = 2.0 * FORCE / STIFFNESS;
    for (nth, [x, _, lost]) in turns.iter().enumerate() {
        let side = if nth % 2 == 0 { 1.0 } else { -1.0 };
        let closed = side * (RELEASED_AT - nth as f64 * shrinks);
        let apart = 0.5 * STIFFNESS * (RELEASED_AT * RELEASED_AT - x * x) - lost;
        println!("{:>10.4} {:>12.4} {apart:>14.1e}", 1e3 * x, 1e3 * closed);
        assert!((x - closed).abs() < 1e-12 && apart.abs() < 1e-11);
    }
    assert_eq!(turns.len(), 9);
    let rest = 1e3 * turns[8][0];
    println!("\nit rests at {rest:.4} mm after {:.3} s, exactly", way[way.len() - 1].0);
    println!("\n{:>14} {:>14} {:>10}", "smoothing m/s", "mm after 3 s", "calls");
    let mut curves = vec![Curve::named("by events", GREY, way)];
    let mut last = vec![Curve::named("by events", GREY, vec![(1.2, rest), (3.0, rest)])];
    for (nth, smoothing) in [1e-2, 1e-3, 1e-4].into_iter().enumerate() {
        let (way, calls) = creeping(smoothing, 3.0)?;
        let end = way[way.len() - 1].1;
        println!("{smoothing:>14} {end:>14.4} {calls:>10}");
        assert!(end < rest);
        let name = format!("smooth {smoothing} m/s");
        let late = way.iter().copied().filter(|(time, _)| *time > 1.2).collect();
        last.push(Curve::named(&name, COLOURS[nth], late));
        if nth == 0 {
            curves.push(Curve::named(&name, COLOURS[nth], way));
        }
    }
    let over = |title, curves| Panel::over(title, ["time in s", "place in mm"], curves);
    charts::write(
        "stick_slip",
        "Stick and slip",
        2,
        vec![over("Eight half turns", curves), over("At rest, and creeping", last)],
    );
    Ok(())
}
