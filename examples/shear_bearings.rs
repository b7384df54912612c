//! The bearings of a flying shear under the force of its cut, which each call is given as a load.
//!
//! The crank turns at 60 rpm. While the blade comes down through the last 8 mm above its lowest point the
//! strip pushes it up with up to 25 kN, as a half wave over the depth. Masses and the cutting force are
//! invented: a source gives the dimensions alone.

use std::f64::consts::{PI, TAU};

use charts::{COLOURS, Curve, GREY, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Strip-mill flying shear with its masses.
    pub struct FlyingShear {
        input theta: angle;
        /// What the strip puts on the blade, upwards.
        load cut: force;

        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);

        gravity (0, -9.81);
        mass 60kg on AB at (15mm, 0) inertia 0.6(kg*m^2);
        mass 85kg on BC at (380mm, -20mm) inertia 3.5(kg*m^2);
        mass 40kg on DC uniform;
        force (0, cut) on blade;

        output AB, blade, AB.drive, AB.A, AB.B, BC.C, DC.D;
    }
}

const OMEGA: f64 = TAU;
const DEPTH: f64 = 8e-3;
const LARGEST: f64 = 25e3;
const STEPS: u32 = 1440;

fn angle(step: u32) -> f64 {
    TAU * f64::from(step) / f64::from(STEPS)
}

/// The force on the blade: none but on its way down through the strip.
fn cut(shear: FlyingShear, theta: f64, lowest: f64) -> Result<f64, SolveError> {
    let above = shear.position(theta)?.blade.y - lowest;
    let comes_down = shear.velocity(theta, OMEGA)?.blade.y < 0.0;
    Ok(if comes_down && above < DEPTH { LARGEST * (PI * above / DEPTH).sin() } else { 0.0 })
}

/// The largest of what the bearings carry, and of the torque.
#[derive(Default)]
struct Largest([f64; 5]);

fn main() -> Result<(), SolveError> {
    let shear = FlyingShear::new();
    let heights = (0..STEPS).map(|step| shear.position(angle(step)).map(|p| p.blade.y));
    let heights: Vec<f64> = heights.collect::<Result<_, _>>()?;
    let lowest = heights.into_iter().fold(f64::MAX, f64::min);
    let names = ["A in kN", "B in kN", "C in kN", "D in kN", "torque in kN·m"];
    let (mut idle, mut cutting) = (Largest::default(), Largest::default());
    let (mut torque, mut empty) = (vec![], vec![]);
    let mut loads: [Vec<(f64, f64)>; 4] = Default::default();
    let (mut housing, mut pin) = ([vec![], vec![]], vec![]);
    for step in 0..=STEPS {
        let theta = angle(step);
        let force = cut(shear, theta, lowest)?;
        let without = shear.forces(theta, OMEGA, 0.0, 0.0)?;
        let with = shear.forces(theta, OMEGA, 0.0, force)?;
        for (largest, f) in [(&mut idle, without), (&mut cutting, with)] {
            let bearings = [f.AB.A, f.AB.B, f.BC.C, f.DC.D].map(|force| force.magnitude() / 1e3);
            let [a, b, c, d] = bearings;
            for (known, new) in largest.0.iter_mut().zip([a, b, c, d, f.AB.drive.abs() / 1e3]) {
                *known = known.max(new);
            }
        }
        let degrees = theta.to_degrees();
        torque.push((degrees, with.AB.drive / 1e3));
        empty.push((degrees, without.AB.drive / 1e3));
        let bearings = [with.AB.A, with.AB.B, with.BC.C, with.DC.D];
        loads
            .iter_mut()
            .zip(bearings)
            .for_each(|(curve, f)| curve.push((degrees, f.magnitude() / 1e3)));
        housing[0].push((with.AB.A.x / 1e3, with.AB.A.y / 1e3));
        housing[1].push((with.DC.D.x / 1e3, with.DC.D.y / 1e3));
        let (crank, b) = (shear.position(theta)?.AB, with.AB.B);
        let (along, across) =
            (crank.cos * b.x + crank.sin * b.y, crank.cos * b.y - crank.sin * b.x);
        pin.push((along / 1e3, across / 1e3));
    }
    println!("{:>16} {:>10} {:>10}", "largest", "idle", "cutting");
    for (name, (idle, cutting)) in names.iter().zip(idle.0.iter().zip(cutting.0)) {
        println!("{name:>16} {idle:>10.3} {cutting:>10.3}");
    }
    chart([torque, empty], loads, housing, pin);
    Ok(())
}

type Points = Vec<(f64, f64)>;

fn chart([torque, empty]: [Points; 2], loads: [Points; 4], housing: [Points; 2], pin: Points) {
    let degrees = "crank angle in degrees";
    let bearings = ["A", "B", "C", "D"].iter().zip(COLOURS).zip(loads);
    let bearings =
        bearings.map(|((name, colour), points)| Curve::named(name, colour, points)).collect();
    let [a, d] = housing;
    charts::write(
        "shear_bearings",
        "A flying shear under its cutting force, 60 rpm",
        2,
        vec![
            Panel::over(
                "Driving torque",
                [degrees, "torque in kN·m"],
                vec![
                    Curve::named("cutting", COLOURS[0], torque),
                    Curve::named("idle", GREY, empty),
                ],
            ),
            Panel::over("What the bearings carry", [degrees, "force in kN"], bearings),
            Panel::plane(
                "On the frame's side",
                ["force in kN, x", "force in kN, y"],
                vec![
                    Curve::named("A on crank", COLOURS[0], a),
                    Curve::named("D on rocker", COLOURS[3], d),
                ],
            ),
            Panel::plane(
                "On the crank pin, in the crank's axes",
                ["force in kN, along", "force in kN, across"],
                vec![Curve::named("B on crank", COLOURS[1], pin)],
            ),
        ],
    );
}
