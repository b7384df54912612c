//! The cost of an acceleration over that of a motion: `cargo bench -p laboratory --bench dynamics`.
//!
//! The four-bar of three uniform bars under gravity, `motion` with both bars as its outputs beside
//! `forward_dynamics`, on the same angles and in turn, round after round. Throughput is that of calls which
//! do not wait for each other, alone and in a sweep; latency that of calls of which each is given what the
//! one before it found. Reported is the median over the rounds of the time over that of the motion in the
//! same round, so that what else the machine does cancels out.

use std::hint::black_box;

use laboratory::race::{Race, Run, angles, at_once, calls, chained, swept};
use linkage_core::{Record, mechanism};

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

const LENGTHS: &str = "slices of one length";

/// Runs both in turn and prints their times, and the second's over the first's.
fn compare(title: &str, [motion, forward]: [Run; 2]) {
    let mut race = Race::default();
    race.enter("motion", motion);
    race.enter("forward", forward);
    let times = race.run(ROUNDS, |_| {});
    let [motion, forward] = [0, 1].map(|way| times[way].nanoseconds);
    println!("{title:34} {motion:8.1} ns {forward:8.1} ns   {:5.2}", times[1].ratio);
}

fn main() {
    let (bars, angles) = (FourBar::new(), angles().take(ANGLES).collect::<Vec<f64>>());
    let [rate, second, drive] = black_box([10.0, 1.0, 0.3]);
    println!("{:34} {:>11} {:>11}   ratio", "time of a call", "motion", "forward");
    let motion = move |theta| bars.motion(theta, rate, second);
    let forward = move |theta| bars.forward_dynamics(theta, rate, drive);
    compare(
        "throughput, call by call",
        [calls(angles.clone(), motion), calls(angles.clone(), forward)],
    );
    compare("throughput, in a sweep", sweeps(bars, &angles, [rate, second, drive]));
    let alpha = |motion: &Result<FourBarMotion<f64>, _>| {
        motion.as_ref().map_or(0.0, |motion| motion.acceleration.DC.alpha)
    };
    let waiting = [
        chained(angles.clone(), motion, alpha),
        chained(angles, forward, |found| found.as_ref().map_or(0.0, |&found| found)),
    ];
    compare("latency", waiting);
}

/// The sweeps, all of what a motion has, and the accelerations alone.
fn sweeps(bars: FourBar, angles: &[f64], [rate, second, drive]: [f64; 3]) -> [Run; 2] {
    let (given, own) = (angles.to_vec(), angles.to_vec());
    let motion = swept(ANGLES, move |out, _| {
        let out: FourBarMotion<&mut [f64]> = Record::from_array(out);
        bars.sweep_motion(&given, rate, second, out, &mut [], ()).expect(LENGTHS);
    });
    let mut seconds = vec![0.0; ANGLES];
    let forward = at_once(ANGLES, move || {
        bars.sweep_forward_dynamics(&own, rate, drive, &mut seconds, &mut [], ()).expect(LENGTHS);
        black_box(&mut seconds);
    });
    [motion, forward]
}
