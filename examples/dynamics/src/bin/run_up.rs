//! A motor runs a four-bar up from rest, with and without a flywheel on the crank's shaft.
//!
//! The four-bar is that of a course work: 250, 510, 500 and 750 mm, uniform bars, 12 rpm, from 60°. The
//! geared motor is invented: its rotor, a straight line of torque over speed, and a drive that limits the current.
//! Nothing holds the speed at 12 rpm: the program says when it is passed, and the crank goes on to nearly
//! the 14 rpm of the motor without load, since weight does no work over a turn. With the crank so slow, weight
//! decides within a turn: the motor lifts, is then driven, and its speed ripples, all the more the less
//! turns with it.

use std::f64::consts::{FRAC_PI_3, TAU};

use charts::{BLACK, COLOURS, Curve, GREY, Panel};
use dynamics::{Motion, Run, Stopped, show};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Four-bar of three uniform bars, with a flywheel.
    pub struct FourBar {
        input theta: angle;
        /// On the crank's shaft.
        param flywheel = 0(kg*m^2);

        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }

        gravity (0, -9.81(m/s^2));
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        inertia flywheel on AB;
        // The motor's rotor, behind its gear.
        inertia 0.2(kg*m^2) on AB;
        output theta.drive, energy;
    }
}

const RPM: f64 = TAU / 60.0;
/// The speed of the course work, which the crank passes, in rad/s.
const SPEED: f64 = 12.0 * RPM;
/// The motor behind its gear: speed without load in rad/s, torque of its line at rest and under the limit
/// of the current in N·m, and how broad the corner between them is.
const NO_LOAD: f64 = 14.0 * RPM;
const AT_REST: f64 = 2.0;
const LIMIT: f64 = 0.8;
const CORNER: f64 = 0.05;

const SECONDS: f64 = 40.0;
const FLYWHEELS: [f64; 3] = [0.0, 2.0, 5.0];

/// The motor's torque at a speed, in N·m: the smaller of limit and line, without an edge.
fn motor(speed: f64) -> f64 {
    let line = AT_REST * (1.0 - speed / NO_LOAD);
    (line + LIMIT - (line - LIMIT).hypot(CORNER)) / 2.0
}

/// Angle, speed and the motor's work.
type State = [f64; 3];

/// The machine under its motor, from rest.
fn machine(flywheel: f64) -> Motion<impl Fn(f64, State) -> Result<State, SolveError>, 3> {
    let machine = FourBar { flywheel };
    let rates = move |_: f64, [theta, speed, _]: State| {
        let torque = motor(speed);
        let [speed, acceleration] = machine.state_rates([theta, speed], torque)?;
        Ok([speed, acceleration, torque * speed])
    };
    Motion::new([0.0, SECONDS], [FRAC_PI_3, 0.0, 0.0], rates).tolerance(1e-11)
}

/// Up to where the speed is reached for the first time.
fn run_up(flywheel: f64) -> Result<Run<3>, Stopped> {
    machine(flywheel).until(0.02, |_, [_, speed, _]| speed - SPEED)
}

/// The mean speed in the end, in rad/s, and by how much the speed ripples over it: (largest −
/// smallest)/mean of the last 15 s, which are three turns and a half.
fn settled(run: &Run<3>) -> [f64; 2] {
    let speeds = run.iter().filter(|(t, _)| *t > SECONDS - 15.0).map(|(_, [_, speed, _])| speed);
    let (mut least, mut most, mut sum, mut count) = (f64::INFINITY, 0.0_f64, 0.0, 0.0);
    for speed in speeds {
        (least, most) = (least.min(speed), most.max(speed));
        (sum, count) = (sum + speed, count + 1.0);
    }
    [sum / count, (most - least) * count / sum]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("A motor of 14 rpm without load runs a four-bar up, through 12 rpm\n");
    println!(
        "{:>10} {:>12} {:>10} {:>10} {:>10} {:>10}",
        "flywheel", "passes", "crank then", "work then", "in the end", "ripple"
    );
    println!(
        "{:>10} {:>12} {:>10} {:>10} {:>10} {:>10}",
        "kg·m²", "12 rpm at s", "deg", "J", "rpm", "%"
    );
    let mut runs = Vec::new();
    for flywheel in FLYWHEELS {
        let (time, [theta, _, work]) = run_up(flywheel)?.last();
        let run = machine(flywheel).sampled(800)?;
        let [mean, ripple] = settled(&run);
        println!(
            "{flywheel:10.1} {time:12.6} {:10.2} {work:10.4} {:10.2} {:10.1}",
            theta.to_degrees(),
            mean / RPM,
            100.0 * ripple
        );
        runs.push(run);
    }
    draw(&runs)?;
    let angles = machine(0.0).sampled(240)?;
    let film = FourBar::new().film(angles.states.iter().take(121).map(|[theta, ..]| *theta));
    show("run_up_film", &film.trace("C").seconds(0.5 * SECONDS))?;
    Ok(())
}

fn draw(runs: &[Run<3>]) -> Result<(), Stopped> {
    let names = FLYWHEELS.map(|flywheel| match flywheel {
        0.0 => "no flywheel".to_owned(),
        flywheel => format!("{flywheel} kg·m²"),
    });
    let over_time = |value: &dyn Fn(State) -> f64, from: f64| -> Vec<Curve> {
        let curve = |((run, name), colour): ((&Run<3>, &String), &str)| {
            let points = run.curve(|_, state| value(state));
            Curve::named(name, colour, points.into_iter().filter(|(t, _)| *t >= from).collect())
        };
        runs.iter().zip(&names).zip(COLOURS).map(curve).collect()
    };
    let mut speeds = over_time(&|[_, speed, _]| speed / RPM, 0.0);
    let wanted = Curve::named("12 rpm, passed", GREY, vec![(0.0, 12.0), (SECONDS, 12.0)]);
    speeds.insert(0, wanted);
    for flywheel in FLYWHEELS {
        let (time, _) = run_up(flywheel)?.last();
        speeds.push(Curve::line(BLACK, &[(time, 11.6), (time, 12.4)]));
    }
    let line = (0..=150).map(|k| f64::from(k) * 0.1).map(|rpm| (rpm, motor(rpm * RPM)));
    let mut plane = vec![Curve::named("motor", GREY, line.collect())];
    let lifts = |run: &Run<3>, flywheel| -> Vec<(f64, f64)> {
        let machine = FourBar { flywheel };
        let point = |[theta, speed, _]: State| {
            let weight = machine.forces(theta, speed, 0.0).map_or(f64::NAN, |f| f.theta.drive);
            (speed / RPM, weight)
        };
        run.iter().filter(|(t, _)| *t > SECONDS - 15.0).map(|(_, state)| point(state)).collect()
    };
    for (((run, flywheel), name), colour) in runs.iter().zip(FLYWHEELS).zip(&names).zip(COLOURS) {
        plane.push(Curve::named(name, colour, lifts(run, flywheel)));
    }
    charts::write(
        "run_up",
        "A four-bar run up by a motor",
        2,
        vec![
            Panel::over("Speed", ["t in s", "crank in rpm"], speeds),
            Panel::over(
                "Motor",
                ["t in s", "torque in N·m"],
                over_time(&|[_, w, _]| motor(w), 0.0),
            ),
            Panel::over(
                "The motor's line, and what lifts and swings the bars",
                ["crank in rpm", "torque in N·m"],
                plane,
            ),
            Panel::over(
                "What the motor has done",
                ["t in s", "work in J"],
                over_time(&|[_, _, work]| work, 0.0),
            ),
        ],
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_event_is_where_the_speed_is_reached() {
        let mut before = 0.0;
        for flywheel in FLYWHEELS {
            let run = run_up(flywheel).unwrap();
            let (time, [_, speed, _]) = run.last();
            assert!(run.is_interrupted);
            assert!((speed - SPEED).abs() < 1e-14, "{speed} {SPEED}");
            // For the first time, and the later the heavier the flywheel.
            assert!(run.states.iter().rev().skip(1).all(|[_, speed, _]| *speed < SPEED));
            assert!(time > before, "{time} {before}");
            before = time;
            // The state is that of the motion: followed to that very time, it is there.
            let again = machine(flywheel).tolerance(1e-13).spanning([0.0, time]);
            let at = again.ended().unwrap().last().1;
            assert!((at[1] - SPEED).abs() < 1e-9, "{} {SPEED}", at[1]);
        }
    }

    #[test]
    fn the_motor_gives_what_the_machine_has() {
        for flywheel in FLYWHEELS {
            let machine_of = FourBar { flywheel };
            let total = |[theta, speed, _]: State| {
                let energy = machine_of.energy(theta, speed).unwrap();
                energy.kinetic + energy.potential
            };
            let run = machine(flywheel).tolerance(1e-13).sampled(40).unwrap();
            let start = total(run.states[0]);
            for state in &run.states {
                let gained = total(*state) - start;
                assert!(
                    (gained - state[2]).abs() < 1e-10 * state[2].max(1.0),
                    "{gained} {}",
                    state[2]
                );
            }
        }
    }

    /// Inverse dynamics of what came out: the torque is the motor's.
    #[test]
    fn forces_of_the_motion_are_the_motors() {
        let machine_of = FourBar { flywheel: 2.0 };
        for [theta, speed, _] in machine(2.0).sampled(50).unwrap().states {
            let torque = motor(speed);
            let [_, acceleration] = machine_of.state_rates([theta, speed], torque).unwrap();
            let found = machine_of.forces(theta, speed, acceleration).unwrap().theta.drive;
            assert!((found - torque).abs() < 1e-14, "{found} {torque}");
        }
    }

    #[test]
    fn a_flywheel_smooths_the_speed() {
        let ripples =
            FLYWHEELS.map(|flywheel| settled(&machine(flywheel).sampled(800).unwrap())[1]);
        assert!(ripples[0] > 2.0 * ripples[1] && ripples[1] > 1.5 * ripples[2], "{ripples:?}");
    }

    /// Weight does no work over a turn, and nothing else brakes: what the motor does over three turns at
    /// its line is nothing, and the speed is the one without load but for the ripple.
    #[test]
    fn the_speed_in_the_end_is_that_without_load() {
        for flywheel in FLYWHEELS {
            let [mean, ripple] = settled(&machine(flywheel).sampled(800).unwrap());
            let short = 1.0 - mean / NO_LOAD;
            println!("{flywheel}: {} rpm, {ripple}", mean / RPM);
            // Where the limit does not act the torque is linear in the speed, whose mean over time differs
            // from that over the angle by the ripple's square; the ends of the 15 s are no whole turns.
            assert!(short.abs() < ripple, "{flywheel}: {short} {ripple}");
            assert!(mean > 1.1 * SPEED, "{flywheel}: {} rpm", mean / RPM);
        }
    }
}
