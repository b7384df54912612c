//! The cost of an acceleration over that of a motion: `cargo bench -p laboratory --bench dynamics`.
//!
//! The four-bar of three uniform bars under gravity, `motion` with both bars as its outputs beside
//! `forward_dynamics`, on the same angles and in turn, round after round. Throughput is that of calls which
//! do not wait for each other, alone and in a sweep; latency that of calls of which each is given what the
//! one before it found. Reported is the median over the rounds of the time over that of the motion in the
//! same round, so that what else the machine does cancels out.

use std::hint::black_box;
use std::time::Instant;

use linkage_core::{AngularAcceleration, AngularVelocity, Direction, mechanism};

mechanism! {
    /// A crank, a coupler and a rocker.
    pub struct FourBar {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        gravity (0, -9.81);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        output theta.drive, BC, DC;
    }
}

/// Angles of one round.
const ANGLES: usize = 4096;

const ROUNDS: usize = 400;

/// Calls an entry point at every angle.
type Calls<'a> = Box<dyn FnMut(&[f64]) + 'a>;

/// Runs both in turn and prints their times, and the second's over the first's.
fn compare(title: &str, angles: &[f64], mut calls: [Calls<'_>; 2]) {
    let mut times = [const { Vec::new() }; 2];
    for round in 0..ROUNDS {
        // Each round begins with another way: none is always behind the same one.
        for turn in 0..2 {
            let place = (round + turn) % 2;
            let begun = Instant::now();
            calls[place](black_box(angles));
            times[place].push(begun.elapsed().as_secs_f64() / angles.len() as f64);
        }
    }
    let ratios = times[1].iter().zip(&times[0]).map(|(own, motion)| own / motion);
    let ratio = median(ratios.collect());
    let [motion, own] = times.map(|times| 1e9 * median(times));
    println!("{title:34} {motion:8.1} ns {own:8.1} ns   {ratio:5.2}");
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Angles all over a turn, in no order: multiples of the golden angle.
fn angles() -> Vec<f64> {
    (0..ANGLES).map(|k| (k as f64 * 2.399_963_229_728_653) % std::f64::consts::TAU).collect()
}

fn main() {
    let (bars, angles) = (FourBar::new(), angles());
    let given = black_box([10.0, 1.0, 0.3]);
    println!("{:34} {:>11} {:>11}   ratio", "time of a call", "motion", "forward");
    alone(&bars, &angles, given);
    sweeps(&bars, &angles, given);
    chained(&bars, &angles, given);
}

/// Calls that do not wait for each other.
fn alone(bars: &FourBar, angles: &[f64], [rate, second, drive]: [f64; 3]) {
    let motion = |angles: &[f64]| {
        for &theta in angles {
            let _ = black_box(bars.motion(theta, rate, second));
        }
    };
    let forward = |angles: &[f64]| {
        for &theta in angles {
            let _ = black_box(bars.forward_dynamics(theta, rate, drive));
        }
    };
    compare("throughput, call by call", angles, [Box::new(motion), Box::new(forward)]);
}

/// Calls of which each waits for the one before it, whose result it is given in a place that changes
/// nothing.
fn chained(bars: &FourBar, angles: &[f64], [rate, second, drive]: [f64; 3]) {
    let motion = |angles: &[f64]| {
        let last = angles.iter().fold(0.0, |found, theta| {
            let motion = bars.motion(theta + 1e-300 * found, rate, second);
            motion.map_or(0.0, |motion| motion.acceleration.DC.alpha)
        });
        black_box(last);
    };
    let forward = |angles: &[f64]| {
        let last = angles.iter().fold(0.0, |found, theta| {
            bars.forward_dynamics(theta + 1e-300 * found, rate, drive).unwrap_or(0.0)
        });
        black_box(last);
    };
    compare("latency", angles, [Box::new(motion), Box::new(forward)]);
}

/// The sweeps, all of what a motion has, and the second rates alone.
fn sweeps(bars: &FourBar, angles: &[f64], [rate, second, drive]: [f64; 3]) {
    let mut columns = vec![vec![0.0; angles.len()]; 8];
    let mut seconds = vec![0.0; angles.len()];
    let motion = |angles: &[f64]| {
        let [a, b, c, d, e, f, g, h] = &mut columns[..] else { return };
        let out = FourBarMotion {
            position: FourBarPosition {
                BC: Direction { cos: &mut a[..], sin: b },
                DC: Direction { cos: c, sin: d },
            },
            velocity: FourBarVelocity {
                BC: AngularVelocity { omega: &mut e[..] },
                DC: AngularVelocity { omega: f },
            },
            acceleration: FourBarAcceleration {
                BC: AngularAcceleration { alpha: &mut g[..] },
                DC: AngularAcceleration { alpha: h },
            },
        };
        let swept = bars.sweep_motion(angles, rate, second, out, &mut [], ());
        black_box(swept).expect("slices of one length");
        black_box(&mut columns);
    };
    let forward = |angles: &[f64]| {
        let swept = bars.sweep_forward_dynamics(angles, rate, drive, &mut seconds, &mut [], ());
        black_box(swept).expect("slices of one length");
        black_box(&mut seconds);
    };
    compare("throughput, in a sweep", angles, [Box::new(motion), Box::new(forward)]);
}
