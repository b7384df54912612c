//! Computed-torque control of a five-bar robot at 1 kHz. The controller is a crate of its own,
//! `controller/lib.rs`, as it runs on the drive: without the standard library, heap or panic.
//!
//! Here is what it is tried on: the robot as it is, simulated by the same fixed-step Runge–Kutta over
//! `state_rates`, its torques held constant for a millisecond as a drive holds them. The tool goes round
//! a circle of 50 mm twice a second, set down 3 mm beside it. The error is what is between tool and
//! circle after the first half second.

use std::f64::consts::TAU;

use charts::{COLOURS, Curve, Panel};
use dynamics::show;
use linkage_core::{Real, SolveError};
use robot_controller::{Controller, Pair, Robot, Wanted, motors, rk4};

/// The period of the control, in s, and the number of simulation steps in it.
const PERIOD: f64 = 1e-3;
const STEPS: u32 = 4;
const SECONDS: f64 = 2.0;
/// When the start is forgotten: e⁻⁷⁵ is left of it.
const SETTLED: f64 = 0.5;
/// The rate at which errors decay, in 1/s.
const BANDWIDTH: f64 = 150.0;
/// Where the tool is set down beside its circle, in m.
const BESIDE: f64 = 3e-3;

/// The tool's task: a circle of 50 mm about (20, 300) mm, twice a second.
fn circle(t: f64) -> Wanted<f64> {
    let (radius, w) = (0.05, 2.0 * TAU);
    let (sin, cos) = (w * t).sin_cos();
    Wanted {
        place: [0.02 + radius * cos, 0.3 + radius * sin],
        rate: [-radius * w * sin, radius * w * cos],
        second: [-radius * w * w * cos, -radius * w * w * sin],
    }
}

/// Who gives the torques.
#[derive(Clone, Copy, PartialEq)]
enum Control {
    /// The controller, which believes this of the payload, in kg.
    Computed { payload: f64 },
    /// The same corrections through a constant inertia for each motor, and nothing of the motion.
    Joints { inertia: f64 },
}

/// One millisecond.
struct Sample {
    time: f64,
    tool: Pair<f64>,
    /// From where it should be, in m.
    error: f64,
    torques: Pair<f64>,
    angles: Pair<f64>,
}

fn to<T: Real>(pair: Pair<f64>) -> Pair<T> {
    pair.map(|x| T::lit(x, x as f32))
}

/// The controller's torques, computed in this precision.
fn torques<T: Real + Into<f64>>(
    payload: f64,
    state: [Pair<f64>; 2],
    tool: Wanted<f64>,
) -> Result<Pair<f64>, SolveError> {
    let number = |x: f64| T::lit(x, x as f32);
    let model = Robot { payload: number(payload), ..Robot::default() };
    let controller = Controller { model, bandwidth: number(BANDWIDTH) };
    let tool = Wanted { place: to(tool.place), rate: to(tool.rate), second: to(tool.second) };
    Ok(controller.torques(state.map(to::<T>), tool)?.map(Into::into))
}

/// The robot under a control of this precision.
fn run<T: Real + Into<f64>>(control: Control, steps: u32) -> Result<Vec<Sample>, SolveError> {
    let robot = Robot::new();
    let mut start = circle(0.0);
    start.place[0] += BESIDE;
    let start = motors(start)?;
    let ([a, b], [u, v]) = (start.place, start.rate);
    let mut state = [a, b, u, v];
    let mut samples = Vec::new();
    for tick in 0..=(SECONDS / PERIOD) as u32 {
        let time = f64::from(tick) * PERIOD;
        let ([a, b, u, v], wanted) = (state, circle(time));
        let given = match control {
            Control::Computed { payload } => torques::<T>(payload, [[a, b], [u, v]], wanted)?,
            Control::Joints { inertia } => {
                let aim = motors(wanted)?;
                [0, 1].map(|i| {
                    let error = [aim.place[i] - [a, b][i], aim.rate[i] - [u, v][i]];
                    inertia * BANDWIDTH * (BANDWIDTH * error[0] + 2.0 * error[1])
                })
            }
        };
        let tool = robot.position([a, b])?.P;
        let error = (tool.x - wanted.place[0]).hypot(tool.y - wanted.place[1]);
        samples.push(Sample {
            time,
            tool: [tool.x, tool.y],
            error,
            torques: given,
            angles: [a, b],
        });
        for _ in 0..steps {
            let rates = |state| robot.state_rates(state, given);
            state = rk4(rates, state, PERIOD / f64::from(steps))?;
        }
    }
    Ok(samples)
}

/// The largest error after the start is forgotten, in m.
fn settled(samples: &[Sample]) -> f64 {
    let after = samples.iter().filter(|sample| sample.time >= SETTLED);
    after.map(|sample| sample.error).fold(0.0, f64::max)
}

const KNOWN: Control = Control::Computed { payload: 0.5 };
const UNKNOWN: Control = Control::Computed { payload: 0.4 };
/// Control with the average inertia that the motors of the standing robot feel.
const JOINTS: Control = Control::Joints { inertia: 0.025 };

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("A five-bar robot's tool on a circle of 50 mm, twice a second, controlled at 1 kHz\n");
    println!("{:>34} {:>16} {:>16}", "", "tracking error", "largest torque");
    let runs = [
        ("computed torque, f64", run::<f64>(KNOWN, STEPS)?),
        ("computed torque, f32", run::<f32>(KNOWN, STEPS)?),
        ("payload believed 20 % too light", run::<f64>(UNKNOWN, STEPS)?),
        ("each motor by itself", run::<f64>(JOINTS, STEPS)?),
    ];
    for (name, samples) in &runs {
        let torque = samples.iter().flat_map(|sample| sample.torques);
        let torque = torque.map(f64::abs).fold(0.0, f64::max);
        println!("{name:>34} {:>13.4} mm {torque:>12.3} N·m", 1e3 * settled(samples));
    }
    println!("\nan acceleration of the robot takes {}", Robot::COST.forward_dynamics);
    draw(&runs);
    let film = runs[0].1.iter().skip(500).take(501).step_by(5).map(|sample| sample.angles);
    show("computed_torque_film", &Robot::new().film(film).trace("P").seconds(3.0))?;
    Ok(())
}

fn draw(runs: &[(&str, Vec<Sample>)]) {
    let errors = runs.iter().zip(COLOURS).map(|((name, samples), colour)| {
        // The worst of every 20 ms.
        let worst = samples.chunks(20).map(|chunk| {
            let worst = chunk.iter().map(|sample| sample.error).fold(1e-9, f64::max);
            (chunk[0].time, (1e3 * worst).log10())
        });
        Curve::named(name, colour, worst.collect())
    });
    // A round of the tool, its errors enlarged.
    let path = |samples: &[Sample]| -> Vec<(f64, f64)> {
        let round = samples.iter().skip(1000).take(501).step_by(5);
        let enlarged = |sample: &Sample| {
            let wanted = circle(sample.time).place;
            [0, 1].map(|i| 1e3 * (wanted[i] + 20.0 * (sample.tool[i] - wanted[i])))
        };
        round.map(enlarged).map(|[x, y]| (x, y)).collect()
    };
    let wanted = (0..=120).map(|k| circle(f64::from(k) / 240.0).place);
    let wanted = wanted.map(|[x, y]| (1e3 * x, 1e3 * y)).collect();
    let torque = |i: usize| -> Vec<(f64, f64)> {
        // Behind the start, whose correction takes several times as much.
        let samples = runs[0].1.iter().skip(100).take(901).step_by(2);
        samples.map(|sample| (sample.time, sample.torques[i])).collect()
    };
    let mut paths = vec![Curve::band(wanted)];
    // That of `f32` is no other.
    for run in [3, 2, 0] {
        let ((name, samples), colour) = (&runs[run], COLOURS[run]);
        paths.push(Curve::named(name, colour, path(samples)));
    }
    charts::write(
        "computed_torque",
        "Computed-torque control of a five-bar robot at 1 kHz",
        3,
        vec![
            Panel::over(
                "Tracking error of the tool",
                ["t in s", "log₁₀ of the error in mm"],
                errors.collect(),
            ),
            Panel::plane("Path of the tool, errors drawn 20 times", ["x in mm", "y in mm"], paths),
            Panel::over(
                "Torques, computed in f64",
                ["t in s", "torque in N·m"],
                vec![
                    Curve::named("left motor", COLOURS[0], torque(0)),
                    Curve::named("right motor", COLOURS[1], torque(1)),
                ],
            ),
        ],
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use dynamics::Motion;

    #[test]
    fn the_tool_keeps_to_its_circle() {
        let known = settled(&run::<f64>(KNOWN, STEPS).unwrap());
        let narrow = settled(&run::<f32>(KNOWN, STEPS).unwrap());
        let unknown = settled(&run::<f64>(UNKNOWN, STEPS).unwrap());
        let joints = settled(&run::<f64>(JOINTS, STEPS).unwrap());
        assert!(known < 5e-5, "{known:e}");
        assert!(narrow < 1.1 * known, "{narrow:e} {known:e}");
        assert!(known < unknown && unknown < joints, "{known:e} {unknown:e} {joints:e}");
        assert!(joints > 10.0 * known, "{joints:e} {known:e}");
    }

    /// Under torques that do not wait for a millisecond, errors obey ë + 2ωė + ω²e = 0 exactly: whatever
    /// the pose, they are (e₀ + (ė₀ + ωe₀) t) e^(−ωt).
    #[test]
    fn errors_die_out_critically_damped() {
        let robot = Robot::new();
        let controller = Controller { model: robot, bandwidth: 20.0 };
        let aim = motors(circle(0.0)).unwrap();
        let off = [0.02, -0.03];
        let start = [aim.place[0] + off[0], aim.place[1] + off[1], aim.rate[0], aim.rate[1]];
        let rates = |t: f64, state: [f64; 4]| {
            let [a, b, u, v] = state;
            robot.state_rates(state, controller.torques([[a, b], [u, v]], circle(t))?)
        };
        for (t, state) in Motion::new([0.0, 0.4], start, rates).sampled(8).unwrap().iter() {
            let aim = motors(circle(t)).unwrap();
            for i in 0..2 {
                let exact = off[i] * (1.0 + 20.0 * t) * (-20.0 * t).exp();
                let found = state[i] - aim.place[i];
                assert!((found - exact).abs() < 1e-11, "{t}: {found} {exact}");
            }
        }
    }

    /// Half the step gives a sixteenth of the error, against the integrator of order 8.
    #[test]
    fn the_drives_integrator_is_of_order_four() {
        let robot = Robot::new();
        let aim = motors(circle(0.0)).unwrap();
        let start = [aim.place[0], aim.place[1], 3.0, -4.0];
        let rates = |state| robot.state_rates(state, [0.3, -0.2]);
        let exact = Motion::new([0.0, 0.1], start, |_, state| rates(state)).tolerance(1e-13);
        let exact = exact.ended().unwrap().last().1;
        let error = |steps: u32| {
            let mut state = start;
            for _ in 0..steps {
                state = rk4(rates, state, 0.1 / f64::from(steps)).unwrap();
            }
            state.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max)
        };
        let ratio = error(50) / error(100);
        assert!((12.0..20.0).contains(&ratio), "{ratio}");
    }
}
