//! Quick return: a crank drives a bar that swings or, with the pivot inside the crank's circle
//! (Whitworth), turns, and the bar drives a ram. The table compares the time ratio of the strokes
//! with its formula.

use std::f64::consts::{PI, TAU};

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A shaper: crank, swinging bar, connecting rod and ram.
    pub struct Shaper {
        input theta: angle;
        /// How far the bar's pivot is below the shaft.
        param depth = 250mm;

        ground A(0, 0), D(0, -depth);
        guide way through (0, 300mm - depth) along 180deg;

        crank AB(A) -> B           { length: 120mm, angle: theta }
        rpr   block(B), bar(D)     { mode: ahead }
        point E on bar at (280mm, 0);
        rrp   EF(E), ram(way) -> F { length: 420mm, mode: ahead }
    }
}

mechanism! {
    /// Whitworth's form: the bar goes round and drives the ram by its far end.
    pub struct Whitworth {
        input theta: angle;
        /// How far the bar's pivot is below the shaft, less than the crank's length.
        param depth = 50mm;

        ground A(0, 0), D(0, -depth);
        guide way through D along 180deg;

        crank AB(A) -> B           { length: 120mm, angle: theta }
        rpr   block(B), bar(D)     { mode: ahead }
        point E on bar at (-90mm, 0);
        rrp   EF(E), ram(way) -> F { length: 420mm, mode: ahead }
    }
}

const STEPS: u32 = 36_000;

/// The part of a turn in which the ram moves forwards, over the part in which it moves back.
fn time_ratio(speed: impl Fn(f64) -> Result<f64, SolveError>) -> Result<f64, SolveError> {
    let mut forwards = 0;
    for step in 0..STEPS {
        if speed(f64::from(step) * TAU / f64::from(STEPS))? > 0.0 {
            forwards += 1;
        }
    }
    let ratio = f64::from(forwards) / f64::from(STEPS - forwards);
    Ok(ratio.max(ratio.recip()))
}

fn main() -> Result<(), SolveError> {
    println!("Quick return, crank 120 mm: slow stroke over quick stroke\n");
    println!("pivot below  bar     measured   formula");
    println!("         mm                            ");
    for depth in [0.18_f64, 0.25, 0.35] {
        let shaper = Shaper { depth };
        let ratio = time_ratio(|theta| Ok(shaper.velocity(theta, 1.0)?.ram.slide))?;
        // The bar turns back where it is square to the crank; the measured turn is cut into
        // hundredths of a degree, which is what separates the two columns.
        let swing = (0.12 / depth).asin();
        let formula = (PI + 2.0 * swing) / (PI - 2.0 * swing);
        println!("{:11.0}  swings {ratio:9.4} {formula:9.4}", depth * 1e3);
    }
    for depth in [0.03_f64, 0.05, 0.08] {
        let press = Whitworth { depth };
        let ratio = time_ratio(|theta| Ok(press.velocity(theta, 1.0)?.ram.slide))?;
        // The ram turns back where the bar lies along its way: there the crank pin is at the
        // depth of the pivot.
        let level = (depth / 0.12).asin();
        let formula = (PI + 2.0 * level) / (PI - 2.0 * level);
        println!("{:11.0}  turns  {ratio:9.4} {formula:9.4}", depth * 1e3);
    }

    let shaper = Shaper::new();
    println!("\nShaper at 1 turn a second, pivot 250 mm below");
    println!("crank      bar      ram   v of ram      a of ram");
    println!("  deg      deg       mm        m/s          m/s²");
    for degrees in (0..=360).step_by(20) {
        let m = shaper.motion(f64::from(degrees).to_radians(), TAU, 0.0)?;
        println!(
            "{degrees:5} {:8.3} {:8.2} {:10.4} {:13.4}",
            m.position.bar.angle().to_degrees(),
            m.position.ram.slide * 1e3,
            m.velocity.ram.slide,
            m.acceleration.ram.slide,
        );
    }
    chart(&shaper, &Whitworth::new())
}

fn chart(shaper: &Shaper, press: &Whitworth) -> Result<(), SolveError> {
    let (mut swings, mut turns) = (vec![], vec![]);
    for degrees in 0..=360 {
        let at = f64::from(degrees);
        swings.push((at, shaper.velocity(at.to_radians(), TAU)?.ram.slide));
        turns.push((at, press.velocity(at.to_radians(), TAU)?.ram.slide));
    }
    let speeds = vec![
        Curve::named("bar swings", COLOURS[0], swings),
        Curve::named("bar turns", COLOURS[1], turns),
    ];
    charts::write(
        "whitworth",
        "Quick return",
        1,
        vec![Panel::over("Ram velocity at 1 turn/s", ["crank in deg", "m/s"], speeds)],
    );
    Ok(())
}
