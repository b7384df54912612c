//! A scissor lift on a screw: the torques that raise and lower it, whether it holds itself, and its efficiency.
//!
//! The screw's thread is a formula of the nut's effort, F r tan(φ ± λ), and the pins rub by themselves. Without
//! friction in the pins the effort is W/tan α and the efficiency tan λ/tan(λ + φ); pins cost the more the lower
//! the lift stands, as their forces grow with the effort.

use linkage_core::{SolveError, mechanism};

mechanism! {
    /// One stage: two arms, the nut on the second.
    pub struct ScissorLift {
        /// From the fixed pin to the nut.
        input span: length;
        /// Friction of the pins.
        param pins = 0.12;
        /// Friction of the thread.
        param thread = 0.12;
        load weight: force;

        ground A(0, 0);
        guide bed through A along 0deg;
        slider nut(bed) -> P         { slide: span }
        rrr   long(A), nutted(P) -> M { lengths: (600mm, 600mm), mode: left }
        // The platform's load is in its middle, above both pairs of ends.
        point T on long at (1200mm, 0);
        point S on nutted at (1200mm, 0);

        force (0, -weight / 2) on T;
        force (0, -weight / 2) on S;
        friction pins at A radius 20mm;
        friction pins on nutted at P radius 20mm;
        friction pins at M radius 20mm;

        // A trapezoidal screw of 25 mm, its lead 5 mm and its mean diameter 22.5 mm.
        let lead = atan(5mm / (3.14159265358979 * 22.5mm));
        output span.drive, T, turning = span.drive * 11.25mm,
               raising = -span.drive * 11.25mm * tan(lead + atan(thread)),
               lowering = -span.drive * 11.25mm * tan(atan(thread) - lead);
    }
}

const WEIGHT: f64 = 8e3;
const ARM: f64 = 1.2;
const LEAD: f64 = 5e-3;

struct Lift {
    force: f64,
    raising: f64,
    lowering: f64,
    efficiency: f64,
}

/// The lift with its arms at an angle, in degrees.
fn lift(pins: f64, degrees: f64) -> Result<Lift, SolveError> {
    let lift = ScissorLift { pins, ..ScissorLift::new() };
    let angle = degrees.to_radians();
    let span = ARM * angle.cos();
    // The nut comes nearer where the platform rises.
    let up = lift.statics(span, -1.0, WEIGHT)?;
    let down = lift.statics(span, 1.0, WEIGHT)?;
    // A turn of the screw raises the platform by the lead over tan α.
    let work = WEIGHT * LEAD / angle.tan();
    let efficiency = work / (std::f64::consts::TAU * up.raising);
    Ok(Lift { force: -up.span.drive, raising: up.raising, lowering: down.lowering, efficiency })
}

fn main() -> Result<(), SolveError> {
    let (lead, phi) = ((LEAD / (std::f64::consts::PI * 22.5e-3)).atan(), 0.12_f64.atan());
    println!("{WEIGHT} N on the platform; the screw alone has an efficiency of {:.1} %", {
        100.0 * lead.tan() / (lead + phi).tan()
    });
    println!(
        "\n{:>8} {:>6} {:>10} {:>12} {:>12} {:>12}",
        "degrees", "pins", "nut N", "raises N·m", "lowers N·m", "efficiency"
    );
    for degrees in [10.0, 20.0, 30.0, 45.0, 60.0] {
        for pins in [0.0, 0.12] {
            let Lift { force, raising, lowering, efficiency } = lift(pins, degrees)?;
            println!(
                "{degrees:>8} {pins:>6} {force:>10.0} {raising:>12.2} {lowering:>12.2} {:>10.1} %",
                100.0 * efficiency
            );
            // It needs a torque downwards as well: it holds itself.
            assert!(lowering > 0.0);
            if pins == 0.0 {
                let expected = WEIGHT / f64::tan(f64::to_radians(degrees));
                assert!((force - expected).abs() < 1e-11 * expected);
                let torque = expected * 11.25e-3 * (lead + phi).tan();
                assert!((raising - torque).abs() < 1e-11 * torque);
                assert!((efficiency - lead.tan() / (lead + phi).tan()).abs() < 1e-11);
            }
        }
    }
    Ok(())
}
