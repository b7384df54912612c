//! A press with friction in its pins and its guide, over a turn: the extra torque, the losses, the efficiency,
//! and the band of drives between which it stands still.
//!
//! The stock is cut over the last fifth of the stroke. Friction loads the joints that it brakes, so that
//! the torque of all of it together is more than the sum of the joints one by one.

use std::f64::consts::{PI, TAU};

use charts::{COLOURS, Curve, GREY, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Crank press.
    pub struct CutPress {
        input theta: angle;
        param pins = 0.12;
        param ways = 0.15;
        /// Force of the stock on the ram, against the stroke.
        load cut: force;

        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B          { length: 60mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 240mm, mode: ahead }

        mass 6kg on BC uniform;
        mass 40kg on ram at (0, 0);
        force (-cut, 0) on C;
        friction pins at A radius 40mm;
        friction pins at B radius 45mm;
        friction pins on BC at C radius 25mm;
        friction ways on ram length 200mm;

        output theta.drive, ram, losses;
    }
}

const SPEED: f64 = TAU;
const FORCE: f64 = 60e3;
const STROKE: f64 = 0.12;
const STEPS: u32 = 360;

type Points = Vec<(f64, f64)>;

/// The force of the stock, where the ram goes forwards through the last fifth of its stroke.
fn cut(press: CutPress, theta: f64) -> Result<f64, SolveError> {
    let slide = press.position(theta)?.ram.slide;
    let goes_forwards = theta.rem_euclid(TAU) > PI;
    Ok(if goes_forwards && slide > 0.3 - 0.2 * STROKE { FORCE } else { 0.0 })
}

fn turn() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|step| TAU * f64::from(step) / f64::from(STEPS))
}

/// Torque and losses over a turn.
fn running(press: CutPress) -> Result<(Points, Points), SolveError> {
    let (mut torques, mut losses) = (Points::new(), Points::new());
    for theta in turn() {
        let f = press.forces(theta, SPEED, 0.0, cut(press, theta)?)?;
        torques.push((theta.to_degrees(), f.theta.drive));
        losses.push((theta.to_degrees(), f.losses));
    }
    Ok((torques, losses))
}

/// The ends of the band of drives that hold the press at rest under the stock's force.
fn resting(press: CutPress) -> Result<[Points; 2], SolveError> {
    let (mut lower, mut upper) = (Points::new(), Points::new());
    for theta in turn() {
        let [backwards, forwards] = match press.holding(theta, cut(press, theta)?) {
            // Next to a dead point friction may hold any force.
            Err(SolveError::Jams { .. }) => continue,
            ends => ends?,
        };
        lower.push((theta.to_degrees(), backwards));
        upper.push((theta.to_degrees(), forwards));
    }
    Ok([lower, upper])
}

/// The mean over a turn, whose ends are one pose.
fn mean(points: &Points) -> f64 {
    points[1..].iter().map(|(_, value)| value).sum::<f64>() / f64::from(STEPS)
}

fn main() -> Result<(), SolveError> {
    let press = CutPress::new();
    let free = CutPress { pins: 0.0, ways: 0.0 };
    let (torque, losses) = running(press)?;
    let (without, _) = running(free)?;
    let peak = |points: &Points| points.iter().fold(0.0, |peak: f64, (_, value)| peak.max(*value));
    println!("at {:.0} rpm, {:.0} kN over the last fifth of the stroke:", 60.0, 1e-3 * FORCE);
    println!(
        "peak torque      {:8.0} N·m, without friction {:8.0} N·m",
        peak(&torque),
        peak(&without)
    );
    println!(
        "power, mean      {:8.0} W,   of which friction {:8.0} W",
        SPEED * mean(&torque),
        mean(&losses)
    );
    println!("efficiency       {:8.1} %", 100.0 * mean(&without) / mean(&torque));
    // Drives put in as much as the stock takes and friction does.
    let apart = SPEED * (mean(&torque) - mean(&without)) - mean(&losses);
    assert!(apart.abs() < 1e-9 * mean(&losses));
    println!("\n{:>24} {:>14}", "friction of", "mean W");
    let mut sum = 0.0;
    for (name, one) in [
        ("the pins alone", CutPress { ways: 0.0, ..press }),
        ("the guide alone", CutPress { pins: 0.0, ..press }),
    ] {
        let losses = mean(&running(one)?.1);
        println!("{name:>24} {losses:>14.1}");
        sum += losses;
    }
    println!("{:>24} {sum:>14.1}", "sum of both");
    println!("{:>24} {:>14.1}", "all together", mean(&losses));
    let [lower, upper] = resting(press)?;
    let over =
        |title, curves| Panel::over(title, ["crank angle in degrees", "torque in N·m"], curves);
    charts::write(
        "press_friction",
        "A press with friction",
        2,
        vec![
            over(
                "Running at 60 rpm",
                vec![
                    Curve::named("with friction", COLOURS[1], torque),
                    Curve::named("without", GREY, without.clone()),
                ],
            ),
            over(
                "At rest: between the two it stands still",
                vec![
                    Curve::named("creeps forwards", COLOURS[2], upper),
                    Curve::named("creeps backwards", COLOURS[0], lower),
                ],
            ),
        ],
    );
    Ok(())
}
