//! Driving torque of a four-bar at constant speed, as a motor is sized by it: peak, effective value, and
//! the points of torque over speed; and the text's own torque, which leaves the weight out.
//!
//! The dimensions are those of a course work on the dynamics of machines, 250, 510, 500 and 750 mm with
//! uniform bars at 12 rpm, run for 5 s from 60°. Its program takes the torque by virtual work; the same
//! numbers come from here without a derivation by hand.

use std::f64::consts::{FRAC_PI_3, PI, TAU};

use charts::{COLOURS, Curve, GREY, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Four-bar of three uniform bars.
    pub struct FourBar {
        /// Angle of the crank.
        input theta: angle;
        /// Gravity, zero where the machine lies flat.
        param g = 9.81(m/s^2);
        /// A counterweight on the crank, behind its pivot.
        param counterweight = 0kg;

        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }

        gravity (0, -g);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        mass counterweight on AB at (-125mm, 0);

        output theta.drive, AB.A, DC.D;
    }
}

const SPEED: f64 = 0.4 * PI;
const SECONDS: f64 = 5.0;
const STEPS: u32 = 500;

/// Times and the torques there.
fn torques(machine: FourBar, speed: f64) -> Result<Vec<(f64, f64)>, SolveError> {
    let sample = |step| {
        let time = SECONDS * f64::from(step) / f64::from(STEPS) * SPEED / speed;
        let f = machine.forces(FRAC_PI_3 + speed * time, speed, 0.0)?;
        Ok((time, f.theta.drive))
    };
    (0..=STEPS).map(sample).collect()
}

fn peak(torques: &[(f64, f64)]) -> f64 {
    torques.iter().map(|(_, torque)| torque.abs()).fold(0.0, f64::max)
}

/// The root of the mean square, which is what heats a motor.
fn effective(torques: &[(f64, f64)]) -> f64 {
    let squares: f64 = torques[1..].iter().map(|(_, torque)| torque * torque).sum();
    (squares / (torques.len() - 1) as f64).sqrt()
}

/// The counterweight, in steps of ten grams, with the smallest peak.
fn best_counterweight(machine: FourBar) -> Result<f64, SolveError> {
    let mut best = (0.0, f64::INFINITY);
    for grams in (0..=1000).step_by(10) {
        let counterweight = f64::from(grams) / 1000.0;
        let peak = peak(&torques(FourBar { counterweight, ..machine }, SPEED)?);
        if peak < best.1 {
            best = (counterweight, peak);
        }
    }
    Ok(best.0)
}

fn main() -> Result<(), SolveError> {
    let machine = FourBar::new();
    let flat = FourBar { g: 0.0, ..machine };
    let balanced = FourBar { counterweight: best_counterweight(machine)?, ..machine };
    println!(
        "{} operations a torque and both reactions of the ground",
        FourBar::COST.forces.total()
    );
    println!("{:>24} {:>10} {:>10}", "", "peak N·m", "rms N·m");
    let weight = format!("balanced with {:.2} kg", balanced.counterweight);
    let cases =
        [("inertia alone", flat), ("weight and inertia", machine), (weight.as_str(), balanced)];
    for (name, machine) in cases {
        let torques = torques(machine, SPEED)?;
        println!("{name:>24} {:>10.5} {:>10.5}", peak(&torques), effective(&torques));
    }

    println!("\nhow fast before inertia counts for more than weight:");
    println!("{:>10} {:>10} {:>10} {:>10}", "rpm", "peak N·m", "rms N·m", "peak W");
    let mut speeds = Vec::new();
    for rpm in [12.0, 30.0, 60.0, 90.0, 120.0, 180.0] {
        let speed = rpm * TAU / 60.0;
        let torques = torques(machine, speed)?;
        let (peak, effective) = (peak(&torques), effective(&torques));
        println!("{rpm:>10} {peak:>10.4} {effective:>10.4} {:>10.3}", peak * speed);
        speeds.push((rpm, peak, effective));
    }

    let curves = |cases: &[(&str, FourBar, &str)]| {
        let of = |(name, machine, colour): &(&str, FourBar, &str)| {
            Ok(Curve::named(name, colour, torques(*machine, SPEED)?))
        };
        cases.iter().map(of).collect::<Result<Vec<_>, SolveError>>()
    };
    let over_time = curves(&[
        ("inertia alone", flat, GREY),
        ("weight and inertia", machine, COLOURS[0]),
        (&weight, balanced, COLOURS[1]),
    ])?;
    let sizing = vec![
        Curve::named("peak", COLOURS[0], speeds.iter().map(|s| (s.0, s.1)).collect()),
        Curve::named("rms", COLOURS[2], speeds.iter().map(|s| (s.0, s.2)).collect()),
    ];
    charts::write(
        "driving_torque",
        "Driving torque of a four-bar",
        2,
        vec![
            Panel::over("12 rpm from 60°", ["time in s", "torque in N·m"], over_time),
            Panel::over("What a motor is sized by", ["speed in rpm", "torque in N·m"], sizing),
        ],
    );
    Ok(())
}
