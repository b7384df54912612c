//! Driving torque of a four-bar as a motor is sized by it: peak and effective value, the points of
//! torque over speed while it starts, what a flywheel does to the speed and a counterweight to what
//! shakes the frame.
//!
//! The dimensions are those of a course work on the dynamics of machines, 250, 510, 500 and 750 mm with
//! uniform bars at 12 rpm, run for 5 s from 60°. Its program takes the torque by virtual work, derived
//! by hand, with three mistakes: the bars' m l²/12 have a stray factor 1e-6, as if l were in
//! millimetres; the weight is left out; and in the velocity of the coupler's centre, ẏ = l₁ ω₁ cos θ₁ +
//! ½ l₂ ω₂ cos θ₂, one term has the wrong sign. The first two are drawn beside the truth.

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
        /// A counterweight on the crank, behind its pivot, and one on the rocker.
        param crank_weight = 0kg;
        param rocker_weight = 0kg;
        /// On the crank's shaft.
        param flywheel = 0(kg*m^2);

        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }

        gravity (0, -g);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        mass crank_weight on AB at (-125mm, 0);
        mass rocker_weight on DC at (-125mm, 0);
        inertia flywheel on AB;

        output theta.drive, shaking, energy;
    }
}

mechanism! {
    /// The same as the text's program computes it: no weight, and next to nothing that turns.
    pub struct AsInTheText {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        mass 52.21g on AB at (125mm, 0);
        mass 104.21g on BC at (255mm, 0);
        mass 102.21g on DC at (250mm, 0);
        output theta.drive;
    }
}

/// Points of a curve.
type Points = Vec<(f64, f64)>;

const SPEED: f64 = 0.4 * PI;
const SECONDS: f64 = 5.0;
/// Where a flywheel and counterweights are worth their mass.
const FAST: f64 = 4.0 * PI;
const STEPS: u32 = 720;

/// Times and the torques there, at constant speed.
fn torques(machine: FourBar) -> Result<Points, SolveError> {
    let sample = |step| {
        let time = SECONDS * f64::from(step) / f64::from(STEPS);
        Ok((time, machine.forces(FRAC_PI_3 + SPEED * time, SPEED, 0.0)?.theta.drive))
    };
    (0..=STEPS).map(sample).collect()
}

fn peak(points: &Points) -> f64 {
    points.iter().map(|(_, torque)| torque.abs()).fold(0.0, f64::max)
}

/// The root of the mean square, which is what heats a motor.
fn effective(points: &Points) -> f64 {
    let squares: f64 = points[1..].iter().map(|(_, torque)| torque * torque).sum();
    (squares / (points.len() - 1) as f64).sqrt()
}

/// Speed in rpm and torque while the machine starts with constant acceleration, in a second.
fn start(machine: FourBar) -> Result<Points, SolveError> {
    let sample = |step| {
        let time = f64::from(step) / f64::from(STEPS);
        let (theta, omega) = (FRAC_PI_3 + FAST * time * time / 2.0, FAST * time);
        let torque = machine.forces(theta, omega, FAST)?.theta.drive;
        Ok((omega * 60.0 / TAU, torque))
    };
    (0..=STEPS).map(sample).collect()
}

/// Crank angles of a turn.
fn turn() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|step| TAU * f64::from(step) / f64::from(STEPS))
}

/// The speed at every angle of a turn while nothing drives or brakes: T + V stays what it is, and
/// T = ½ M ω² with the mass that the energy at a unit rate tells.
fn coasting(machine: FourBar, mean: f64) -> Result<Points, SolveError> {
    let energies: Vec<_> =
        turn().map(|theta| machine.energy(theta, 1.0)).collect::<Result<_, _>>()?;
    let speeds =
        |total: f64| energies.iter().map(move |e| ((total - e.potential) / e.kinetic).sqrt());
    let highest = energies.iter().map(|e| e.potential).fold(f64::MIN, f64::max);
    // The total energy at which a turn takes as long as one at the mean speed.
    let (mut low, mut high) = (highest, highest + 1e3);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        let time: f64 = speeds(middle).skip(1).map(|speed| TAU / f64::from(STEPS) / speed).sum();
        if time > TAU / mean { low = middle } else { high = middle }
    }
    Ok(turn().map(f64::to_degrees).zip(speeds(high)).collect())
}

/// Largest less smallest speed over the mean.
fn ripple(speeds: &Points) -> f64 {
    let of = |pick: fn(f64, f64) -> f64, from| speeds.iter().map(|s| s.1).fold(from, pick);
    (of(f64::max, f64::MIN) - of(f64::min, f64::MAX)) / FAST
}

/// The shaking force at constant speed: its components over a turn.
fn shaking(machine: FourBar) -> Result<Points, SolveError> {
    let force = |theta| machine.forces(theta, FAST, 0.0).map(|f| (f.shaking.x, f.shaking.y));
    turn().map(force).collect()
}

fn largest(forces: &Points) -> f64 {
    forces.iter().map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max)
}

fn main() -> Result<(), SolveError> {
    let machine = FourBar::new();
    let flat = FourBar { g: 0.0, ..machine };
    let text = AsInTheText::new();
    let text = (0..=STEPS).map(|step| {
        let time = SECONDS * f64::from(step) / f64::from(STEPS);
        Ok((time, text.forces(FRAC_PI_3 + SPEED * time, SPEED, 0.0)?.theta.drive))
    });
    let text: Points = text.collect::<Result<_, SolveError>>()?;
    let (inertia, all) = (torques(flat)?, torques(machine)?);
    println!("a torque takes {} operations; at 12 rpm:\n", FourBar::COST.forces.total());
    println!("{:34} {:>10} {:>10}", "", "peak N·m", "rms N·m");
    for (name, points) in [
        ("the text: no weight, m l²/12 · 1e-6", &text),
        ("inertia alone", &inertia),
        ("weight and inertia", &all),
    ] {
        println!("{name:34} {:>10.5} {:>10.5}", peak(points), effective(points));
    }
    let starts = [machine, FourBar { flywheel: 0.02, ..machine }].map(start);
    let [plain, heavy] = starts;
    let (plain, heavy) = (plain?, heavy?);
    println!(
        "\nfrom rest to 120 rpm in a second: peak {:.3} N·m, rms {:.3} N·m;",
        peak(&plain),
        effective(&plain)
    );
    println!(
        "with a flywheel of 0.02 kg·m²:    peak {:.3} N·m, rms {:.3} N·m",
        peak(&heavy),
        effective(&heavy)
    );
    let wheels = print_ripples(machine)?;
    let shakes = print_shaking(machine)?;
    let sized = print_speeds(machine)?;
    let over = |title, axes, curves| Panel::over(title, axes, curves);
    let milli = |points: &Points| points.iter().map(|(t, torque)| (*t, 1e3 * torque)).collect();
    let of_inertia = vec![
        Curve::named("truth", COLOURS[1], milli(&inertia)),
        Curve::named("text", GREY, milli(&text)),
    ];
    let torque = vec![
        Curve::named("weight and inertia", COLOURS[0], all),
        Curve::named("inertia alone", COLOURS[1], inertia),
    ];
    let starting =
        vec![Curve::named("flywheel", COLOURS[2], heavy), Curve::named("none", COLOURS[0], plain)];
    charts::write(
        "driving_torque",
        "Driving torque of a four-bar",
        2,
        vec![
            over("12 rpm from 60°", ["time in s", "torque in N·m"], torque),
            over("Of inertia alone", ["time in s", "torque in mN·m"], of_inertia),
            over("Constant speed", ["speed in rpm", "torque in N·m"], sized),
            over(
                "Starting: points of torque over speed",
                ["speed in rpm", "torque in N·m"],
                starting,
            ),
            over("Coasting at 120 rpm", ["crank angle in degrees", "speed in rad/s"], wheels),
            Panel::plane(
                "What shakes the frame, 120 rpm",
                ["force in N, x", "force in N, y"],
                shakes,
            ),
        ],
    );
    Ok(())
}

/// Peak and effective torque over speeds, where inertia comes to count for more than weight.
fn print_speeds(machine: FourBar) -> Result<Vec<Curve>, SolveError> {
    println!(
        "\nat constant speed:\n{:>8} {:>10} {:>10} {:>10}",
        "rpm", "peak N·m", "rms N·m", "peak W"
    );
    let (mut peaks, mut effectives) = (Points::new(), Points::new());
    for rpm in [12, 30, 60, 90, 120, 150, 180].map(f64::from) {
        let speed = rpm * TAU / 60.0;
        let torque = |theta| Ok((theta, machine.forces(theta, speed, 0.0)?.theta.drive));
        let points: Points = turn().map(torque).collect::<Result<_, SolveError>>()?;
        let (peak, effective) = (peak(&points), effective(&points));
        println!("{rpm:>8} {peak:>10.4} {effective:>10.4} {:>10.3}", peak * speed);
        peaks.push((rpm, peak));
        effectives.push((rpm, effective));
    }
    Ok(vec![Curve::named("peak", COLOURS[0], peaks), Curve::named("rms", COLOURS[2], effectives)])
}

/// The effect of flywheels on the speed, printed and as curves.
fn print_ripples(machine: FourBar) -> Result<Vec<Curve>, SolveError> {
    println!("\ncoasting at 120 rpm:\n{:>18} {:>14}", "flywheel kg·m²", "speed ripple %");
    let mut curves = Vec::new();
    for (flywheel, colour) in [0.0, 0.01, 0.02, 0.05, 0.1].into_iter().zip(COLOURS) {
        let speeds = coasting(FourBar { flywheel, ..machine }, FAST)?;
        println!("{flywheel:>18} {:>14.2}", 100.0 * ripple(&speeds));
        curves.push(Curve::named(&format!("{flywheel} kg·m²"), colour, speeds));
    }
    Ok(curves)
}

/// The effect of counterweights on the frame. Those that balance all of it carry the moments of crank and
/// rocker and of the coupler's halves at both pins (Berkof and Lowen, 1969).
fn print_shaking(machine: FourBar) -> Result<Vec<Curve>, SolveError> {
    let crank_weight = 0.5 * (0.05221 + 0.10421) * 0.25 / 0.125;
    let rocker_weight = 0.5 * (0.10221 + 0.10421) * 0.5 / 0.125;
    println!("\nat 120 rpm:\n{:>24} {:>12}", "counterweights kg", "shaking N");
    let mut curves = Vec::new();
    for ((name, machine), colour) in [
        ("none", machine),
        ("crank", FourBar { crank_weight, ..machine }),
        ("crank and rocker: nothing left", FourBar { crank_weight, rocker_weight, ..machine }),
    ]
    .into_iter()
    .zip(COLOURS)
    {
        let forces = shaking(machine)?;
        let weights = format!("{:.4} + {:.4}", machine.crank_weight, machine.rocker_weight);
        println!("{weights:>24} {:>12.2e}", largest(&forces));
        curves.push(Curve::named(name, colour, forces));
    }
    Ok(curves)
}
