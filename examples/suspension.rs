//! A double wishbone, driven by the wheel's travel: the chain is a crank and a dyad, but what drives it
//! is a point at its end. The lower arm's angle is the unknown, the wheel's height its equation; driven
//! by the arm's angle the same machine goes through the same poses. The strut acts at the wheel: the
//! effort of the wheel's height is the load.

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Driven by the wheel: the plane across the car, x outwards, y up.
    pub struct ByTheWheel {
        /// The height of the wheel's centre.
        input z: length;

        ground A(0, 200mm), D(50mm, 450mm);
        /// Where the strut hangs on the body.
        ground S(130mm, 640mm);

        unknown theta: angle between (-25deg, 25deg);
        crank lower(A) -> B             { length: 380mm, angle: theta }
        rrr   kingpin(B), upper(D) -> C { lengths: (250mm, 280mm), mode: right }
        point W on kingpin at (120mm, -60mm);
        /// Where the tyre stands.
        point tyre on kingpin at (-180mm, -60mm);
        solve theta { W.y = z, mode: rising }

        point E on lower at (270mm, 0);
        spring strut between E and S { stiffness: 42(N/mm), free_length: 600mm, damping: 2800(N*s/m) }

        output theta, z.drive, W, tyre, kingpin.angle, lower.angle, upper.angle, B, C;
    }
}

mechanism! {
    /// Driven by the lower arm.
    pub struct ByTheArm {
        input theta: angle;
        ground A(0, 200mm), D(50mm, 450mm);
        crank lower(A) -> B             { length: 380mm, angle: theta }
        rrr   kingpin(B), upper(D) -> C { lengths: (250mm, 280mm), mode: right }
        point W on kingpin at (120mm, -60mm);
        output W, kingpin.angle;
    }
}

/// Half the track: from the lower arm's pivot to the car's middle plane, inwards.
const MIDDLE: f64 = -0.35;

/// The height of the roll centre: the line from the tyre to the instantaneous centre, about which
/// the kingpin turns against the body, in the middle plane.
fn roll_centre(p: &ByTheWheelPosition) -> f64 {
    // Both arms' lines meet there.
    let (a, d) = ([0.0, 0.2], [0.05, 0.45]);
    let (u, v) = (p.lower, p.upper);
    let cross = u.cos * v.sin - u.sin * v.cos;
    let along = ((d[0] - a[0]) * v.sin - (d[1] - a[1]) * v.cos) / cross;
    let centre = [a[0] + along * u.cos, a[1] + along * u.sin];
    let part = (MIDDLE - p.tyre.x) / (centre[0] - p.tyre.x);
    p.tyre.y + part * (centre[1] - p.tyre.y)
}

fn main() -> Result<(), SolveError> {
    let (car, arm) = (ByTheWheel::new(), ByTheArm::new());
    println!("{}\n", ByTheWheel::COST);
    println!("travel     camber   camber gain   scrub   roll centre      arm   load");
    println!("    mm        deg        deg/mm      mm            mm      deg      N");
    let middle = car.position(0.33)?;
    let mut apart = 0.0_f64;
    let mut curves = [vec![], vec![], vec![], vec![]];
    for step in -60..=60 {
        let travel = f64::from(step) * 1e-3;
        let m = car.motion(0.33 + travel, 1.0, 0.0)?;
        let (p, v) = (m.position, m.velocity);
        // The wheel leans with the kingpin, outwards at the top where the angle is less.
        let camber = (middle.kingpin.angle() - p.kingpin.angle()).to_degrees();
        let gain = -v.kingpin.omega.to_degrees() * 1e-3;
        let (scrub, centre) =
            (1e3 * (p.tyre.x - middle.tyre.x), 1e3 * (roll_centre(&p) - p.tyre.y));
        // The same pose by the arm, and the same camber gain by its rates.
        let again = arm.motion(p.theta, v.theta, m.acceleration.theta)?;
        apart = apart
            .max((again.position.W.y - p.W.y).abs())
            .max((again.velocity.W.y - 1.0).abs())
            .max(again.acceleration.W.y.abs())
            .max((again.velocity.kingpin.omega - v.kingpin.omega).abs());
        let values = [camber, gain, scrub, centre];
        for (curve, value) in curves.iter_mut().zip(values) {
            curve.push((1e3 * travel, value));
        }
        if step % 10 == 0 {
            let degrees = p.theta.to_degrees();
            // The road's upward force is the drive force, as nothing has mass.
            let load = car.statics(0.33 + travel)?.z.drive;
            println!(
                "{step:6} {camber:10.4} {gain:13.5} {scrub:7.3} {centre:13.3} {degrees:8.3} {load:6.0}"
            );
        }
    }
    println!("\nDriven by the arm it is the same to {apart:.1e}.");
    let low = car.position(0.1).expect_err("below the lowest arm");
    println!("With the wheel at 100 mm: {low}");
    let titles =
        [("Camber", "deg"), ("Camber gain", "deg/mm"), ("Scrub", "mm"), ("Roll centre", "mm")];
    let panels = titles.iter().zip(curves).zip(COLOURS).map(|(((title, unit), curve), colour)| {
        Panel::over(title, ["travel in mm", unit], vec![Curve::named(title, colour, curve)])
    });
    charts::write("suspension", "A double wishbone by its wheel's travel", 2, panels.collect());
    Ok(())
}
