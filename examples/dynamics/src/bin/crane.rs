//! A trolley with a hanging load. The trolley's acceleration is given, and the sway is passive: no drive
//! acts on it. Both follow from one equation of motion, M q̈ = force + drive, of which the trolley's row
//! gives the drive and the sway's row the acceleration.
//!
//! A crane that accelerates for exactly one period of its swinging load leaves no sway: under constant
//! acceleration the load swings about a slanted line, and after a period hangs still as at the start. The
//! period is that of the real pendulum, not of the linear one, and is found as an event.

use charts::{COLOURS, Curve, Panel};
use dynamics::{Motion, Run, Stopped, show};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A crane of two tonnes on six metres of rope.
    pub struct Crane {
        input x: length;
        /// From hanging, positive ahead.
        input sway: angle;

        ground O(0, 0);
        guide beam through O along 0deg;
        slider trolley(beam) -> P { slide: x }
        crank rope(P) -> L        { length: 6m, angle: sway - 90deg }

        gravity (0, -9.81(m/s^2));
        mass 800kg on P;
        mass 2000kg on L;
        inertia 900(kg*m^2) on rope;
        output P, L, x.drive, sway.drive, energy;
    }
}

/// While it speeds up, in m/s².
const ACCELERATION: f64 = 0.4;
/// At constant speed, and standing, in s.
const CRUISE: f64 = 3.0;
const REST: f64 = 10.0;

/// x, sway, and their rates.
type State = [f64; 4];

/// The sway's acceleration and the trolley's drive in N, where the trolley accelerates as given.
fn passive([x, sway, v, rate]: State, acceleration: f64) -> Result<[f64; 2], SolveError> {
    let e = Crane::new().equations_of_motion([x, sway], [v, rate])?;
    let second = (e.force[1] - e.mass[1][0] * acceleration) / e.mass[1][1];
    let drive = e.mass[0][0] * acceleration + e.mass[0][1] * second - e.force[0];
    Ok([second, drive])
}

/// A constant acceleration of the trolley over a span of time.
fn leg(
    span: [f64; 2],
    start: State,
    acceleration: f64,
) -> Motion<impl Fn(f64, State) -> Result<State, SolveError>, 4> {
    let rates = move |_: f64, state: State| {
        let [second, _] = passive(state, acceleration)?;
        Ok([state[2], state[3], acceleration, second])
    };
    Motion::new(span, start, rates).tolerance(1e-13)
}

/// The time after which the accelerated load hangs as at the start, in s. It falls behind, swings back,
/// and at the end stands for a moment: its rate, positive before, passes zero.
fn period(acceleration: f64) -> Result<f64, Stopped> {
    let swinging = leg([0.0, 20.0], [0.0; 4], acceleration);
    Ok(swinging.until(1.0, |_, [_, _, _, rate]| -rate)?.last().0)
}

/// Times, states and the acceleration there.
struct Ride {
    times: Vec<f64>,
    states: Vec<State>,
    accelerations: Vec<f64>,
}

/// Speeds up for so long, cruises, brakes for so long and stands.
fn ride(seconds: f64, acceleration: f64) -> Result<Ride, Stopped> {
    let legs = [(seconds, acceleration), (CRUISE, 0.0), (seconds, -acceleration), (REST, 0.0)];
    let mut ride = Ride { times: vec![], states: vec![], accelerations: vec![] };
    let (mut time, mut state) = (0.0, [0.0; 4]);
    for (seconds, acceleration) in legs {
        let run: Run<4> = leg([time, time + seconds], state, acceleration).sampled(100)?;
        (time, state) = run.last();
        ride.accelerations.extend(run.times.iter().map(|_| acceleration));
        ride.times.extend(run.times);
        ride.states.extend(run.states);
    }
    Ok(ride)
}

impl Ride {
    fn curve(&self, value: impl Fn(State, f64) -> f64) -> Vec<(f64, f64)> {
        let both = self.times.iter().zip(&self.states).zip(&self.accelerations);
        both.map(|((time, state), acceleration)| (*time, value(*state, *acceleration))).collect()
    }

    /// The largest sway of the crane that stands, in rad.
    fn left_over(&self) -> f64 {
        let standing = self.states.iter().rev().take(101);
        standing.map(|[_, sway, ..]| sway.abs()).fold(0.0, f64::max)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let seconds = period(ACCELERATION)?;
    println!("A crane's load under {ACCELERATION} m/s² swings back within {seconds:.9} s\n");
    // The same speed in half the time, and in the time of the period.
    let (hasty, timed) = (ride(0.5 * seconds, 2.0 * ACCELERATION)?, ride(seconds, ACCELERATION)?);
    println!("{:>22} {:>12} {:>14} {:>18}", "", "largest sway", "largest drive", "sway left over");
    for (name, ride) in [("in half a period", &hasty), ("in a whole period", &timed)] {
        let largest = |points: Vec<(f64, f64)>| {
            points.into_iter().map(|(_, value)| value.abs()).fold(0.0, f64::max)
        };
        println!(
            "{name:>22} {:>8.3} deg {:>12.1} N {:>14.2e} deg",
            largest(ride.curve(|[_, sway, ..], _| sway.to_degrees())),
            largest(ride.curve(|state, a| passive(state, a).map_or(f64::NAN, |[_, drive]| drive))),
            ride.left_over().to_degrees()
        );
    }
    draw(&hasty, &timed);
    let film = timed.states.iter().step_by(3).map(|[x, sway, ..]| [*x, *sway]);
    let film = Crane::new().film(film).trace("L").label(["P", "L"]).seconds(12.0);
    show("crane_film", &film)?;
    Ok(())
}

fn draw(hasty: &Ride, timed: &Ride) {
    let both = |value: &dyn Fn(State, f64) -> f64| {
        vec![
            Curve::named("half a period", COLOURS[0], hasty.curve(value)),
            Curve::named("a whole period", COLOURS[1], timed.curve(value)),
        ]
    };
    charts::write(
        "crane",
        "A crane that speeds up and brakes for half and for a whole period of its load",
        2,
        vec![
            Panel::over(
                "Sway",
                ["t in s", "sway in deg"],
                both(&|[_, sway, ..], _| sway.to_degrees()),
            ),
            Panel::over(
                "Speed of the trolley",
                ["t in s", "speed in m/s"],
                both(&|[_, _, v, _], _| v),
            ),
            Panel::over(
                "Drive of the trolley",
                ["t in s", "force in kN"],
                both(&|state, a| passive(state, a).map_or(f64::NAN, |[_, drive]| drive / 1e3)),
            ),
            Panel::over(
                "Where the load is ahead of the trolley",
                ["t in s", "way in m"],
                both(&|[_, sway, ..], _| 6.0 * sway.sin()),
            ),
        ],
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Under constant acceleration the load is a pendulum in the field √(g² + a²), about a line slanted
    /// by atan(a/g), let go at that angle from it. Its period is 2π/(ω₀ agm(1, cos(A/2))) (Gauss).
    #[test]
    fn the_period_is_that_of_a_pendulum_in_a_slanted_field() {
        for acceleration in [0.1_f64, 0.4, 4.0] {
            let (turning, moment) = (2000.0 * 36.0 + 900.0, 2000.0 * 6.0_f64);
            let own = (moment * acceleration.hypot(9.81) / turning).sqrt();
            let (mut a, mut b) = (1.0, (0.5 * acceleration.atan2(9.81)).cos());
            for _ in 0..6 {
                (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
            }
            let exact = std::f64::consts::TAU / (own * a);
            let found = period(acceleration).unwrap();
            assert!((found / exact - 1.0).abs() < 1e-11, "{acceleration}: {found} {exact}");
        }
    }

    #[test]
    fn a_whole_period_leaves_no_sway() {
        let seconds = period(ACCELERATION).unwrap();
        let timed = ride(seconds, ACCELERATION).unwrap();
        assert!(timed.left_over() < 1e-11, "{:e}", timed.left_over());
        // Half a period leaves it at the turning point, and braking adds to it or not; not nothing.
        let hasty = ride(0.5 * seconds, 2.0 * ACCELERATION).unwrap();
        assert!(hasty.left_over() > 0.01, "{}", hasty.left_over());
        let [_, _, v, _] = timed.states[150];
        assert!((v - ACCELERATION * seconds).abs() < 1e-12, "{v}");
    }

    /// The drive that is found moves the free crane as was asked, without one on the sway.
    #[test]
    fn forward_dynamics_under_that_drive_is_the_motion() {
        let seconds = period(ACCELERATION).unwrap();
        let ride = ride(0.7 * seconds, ACCELERATION).unwrap();
        for (state, acceleration) in ride.states.iter().zip(&ride.accelerations) {
            let [second, drive] = passive(*state, *acceleration).unwrap();
            let [x, sway, v, rate] = *state;
            let found = Crane::new().forward_dynamics([x, sway], [v, rate], [drive, 0.0]).unwrap();
            assert!((found[0] - acceleration).abs() < 1e-14 && (found[1] - second).abs() < 1e-14);
        }
    }
}
