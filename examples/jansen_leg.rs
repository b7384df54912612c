//! Theo Jansen's leg: one crank, four RRR groups' worth of bars, a foot that walks. Six legs on one
//! shaft are one solver called with six phases.

use std::f64::consts::TAU;

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// One leg with Jansen's eleven numbers, in centimetres.
    pub struct JansenLeg {
        input theta: angle;

        ground A(0, 0), D(-38cm, -7.8cm);

        crank AB(A) -> B           { length: 15cm, angle: theta }
        rrr   upper(B), b(D) -> U  { lengths: (50cm, 41.5cm), mode: right }
        rrr   lower(B), c(D) -> L  { lengths: (61.9cm, 39.3cm), mode: left }
        point E on b at distances (40.1cm, 55.8cm) left;
        rrr   f(E), g(L) -> F      { lengths: (39.4cm, 36.7cm), mode: right }
        point foot on g at distances (49cm, 65.7cm) left;
    }
}

/// The height below which a foot carries weight, above the lowest point of its path.
const SINKING: f64 = 0.02;

fn main() -> Result<(), SolveError> {
    let leg = JansenLeg::new();
    println!("Jansen's leg at one turn of the crank a second\n");
    println!("crank   foot x   foot y  v of foot x v of foot y");
    println!("  deg       cm       cm         cm/s        cm/s");
    let mut path = Vec::new();
    for degrees in 0..360 {
        let theta = f64::from(degrees).to_radians();
        let m = leg.motion(theta, TAU, 0.0)?;
        let (at, speed) = (m.position.foot, m.velocity.foot);
        if degrees % 15 == 0 {
            println!(
                "{degrees:5} {:8.2} {:8.2} {:12.2} {:11.2}",
                at.x * 1e2,
                at.y * 1e2,
                speed.x * 1e2,
                speed.y * 1e2
            );
        }
        path.push((at.x, at.y));
    }
    let ground = path.iter().fold(f64::INFINITY, |low, (_, y)| low.min(*y));
    let top = path.iter().fold(f64::NEG_INFINITY, |high, (_, y)| high.max(*y));
    let down: Vec<_> = path.iter().filter(|(_, y)| *y < ground + SINKING).collect();
    let back = down.iter().fold(f64::INFINITY, |low, (x, _)| low.min(*x));
    let front = down.iter().fold(f64::NEG_INFINITY, |high, (x, _)| high.max(*x));
    println!("\nstep {:.1} cm, lift {:.1} cm", (front - back) * 1e2, (top - ground) * 1e2);
    println!("on the ground for {:.0} % of a turn", down.len() as f64 / 3.6);

    // Six legs, 60° apart: how many carry at once.
    let mut carrying = [0; 7];
    for degrees in 0..360 {
        let mut feet = 0;
        for number in 0..6 {
            let phase = f64::from(number) * TAU / 6.0;
            let foot = leg.position(f64::from(degrees).to_radians() + phase)?.foot;
            feet += usize::from(foot.y < ground + SINKING);
        }
        carrying[feet] += 1;
    }
    println!("\nsix legs 60° apart: feet on the ground, share of a turn");
    for (feet, count) in carrying.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        println!("  {feet} feet: {:5.1} %", f64::from(count) / 3.6);
    }
    chart(&leg)
}

fn chart(leg: &JansenLeg) -> Result<(), SolveError> {
    let cm = |point: linkage_core::Point| (point.x * 1e2, point.y * 1e2);
    let (mut path, mut heights) = (vec![], vec![]);
    for step in 0..=180 {
        path.push(cm(leg.position(f64::from(step) * TAU / 180.0)?.foot));
    }
    for (number, colour) in COLOURS.into_iter().enumerate() {
        let phase = number as f64 * TAU / 6.0;
        let mut height = vec![];
        for step in 0..=120 {
            let theta = f64::from(step) * TAU / 120.0;
            height.push((theta.to_degrees(), leg.position(theta + phase)?.foot.y * 1e2));
        }
        heights.push(Curve::named(&format!("leg {}", number + 1), colour, height));
    }
    let path = vec![Curve::line(COLOURS[1], &path)];
    charts::write(
        "jansen_leg",
        "Jansen's leg",
        2,
        vec![
            Panel::plane("The foot's path", ["x in cm", "y in cm"], path),
            Panel::over("Feet of six legs on one shaft", ["crank in deg", "height in cm"], heights),
        ],
    );
    Ok(())
}
