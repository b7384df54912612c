//! Flying shear of a strip mill: a crank-rocker whose coupler carries the upper blade, under the
//! drive law of its motor.
//!
//! The table is what a commissioning report shows: rocker angle, angular velocity and angular
//! acceleration over the 15 s of a cut, and where the pins and the blade are. The derivatives are
//! exact; differences of the angle would be 25 % off in the acceleration near the ends.

use std::f64::consts::PI;

use charts::{COLOURS, Curve, GREY, Panel, rounded};
use linkage_core::{Point, SolveError, mechanism};

mechanism! {
    /// The shear's crank-rocker.
    pub struct FlyingShear {
        input theta: angle;

        ground A(0, 0), D(665.7mm, 0);

        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }

        /// Cutting edge of the upper blade.
        point blade on BC at (500mm, -60mm);
    }
}

/// Half a period of the drive, in seconds.
const STROKE: f64 = 15.0;

/// Crank angle, angular velocity and acceleration at time `t`:
/// θ = π/12 (1 − cos(π t/15)) + 115°.
fn drive(t: f64) -> [f64; 3] {
    let (sin, cos) = (PI * t / STROKE).sin_cos();
    let rate = PI / STROKE;
    [
        PI / 12.0 * (1.0 - cos) + 115_f64.to_radians(),
        PI / 12.0 * rate * sin,
        PI / 12.0 * rate * rate * cos,
    ]
}

fn main() -> Result<(), SolveError> {
    let shear = FlyingShear::new();
    println!("Flying shear under θ(t) = π/12 (1 − cos(π t/15)) + 115°\n");
    println!("    t     crank        DC   ω of DC    α of DC       C.x      C.y  blade.x  blade.y");
    println!("    s       deg       deg    mrad/s    mrad/s²        mm       mm       mm       mm");
    for step in 0..=30 {
        let t = f64::from(step) * 0.5;
        let [theta, omega, alpha] = drive(t);
        let m = shear.motion(theta, omega, alpha)?;
        println!(
            "{t:5.1} {:9.3} {:9.4} {:9.4} {:10.5} {:9.2} {:8.2} {:8.2} {:8.2}",
            theta.to_degrees(),
            m.position.DC.angle().to_degrees(),
            rounded(m.velocity.DC.omega * 1e3, 4),
            rounded(m.acceleration.DC.alpha * 1e3, 5),
            m.position.C.x * 1e3,
            m.position.C.y * 1e3,
            m.position.blade.x * 1e3,
            m.position.blade.y * 1e3,
        );
    }
    chart(&shear)
}

fn chart(shear: &FlyingShear) -> Result<(), SolveError> {
    let (mut angle, mut omega, mut alpha) = (vec![], vec![], vec![]);
    let (mut b, mut c, mut blade) = (vec![], vec![], vec![]);
    for step in 0..=300 {
        let t = f64::from(step) * STROKE / 300.0;
        let [theta, rate, second] = drive(t);
        let m = shear.motion(theta, rate, second)?;
        angle.push((t, m.position.DC.angle().to_degrees()));
        omega.push((t, m.velocity.DC.omega * 1e3));
        alpha.push((t, m.acceleration.DC.alpha * 1e3));
        b.push((m.position.B.x * 1e3, m.position.B.y * 1e3));
        c.push((m.position.C.x * 1e3, m.position.C.y * 1e3));
        blade.push((m.position.blade.x * 1e3, m.position.blade.y * 1e3));
    }
    let pin = |point: Point<f64>| (point.x * 1e3, point.y * 1e3);
    let (mut turn_b, mut turn_c, mut turn_blade) = (vec![], vec![], vec![]);
    for step in 0..=120 {
        let p = shear.position(f64::from(step) * PI / 60.0)?;
        turn_b.push(pin(p.B));
        turn_c.push(pin(p.C));
        turn_blade.push(pin(p.blade));
    }
    let machine = shear.position(115_f64.to_radians())?;
    let bars = [(0.0, 0.0), pin(machine.B), pin(machine.blade), pin(machine.C), pin(machine.B)];
    let paths = vec![
        Curve::named("machine at the start", GREY, bars.into()),
        Curve::line(GREY, &[pin(machine.C), (665.7, 0.0)]),
        Curve::named("a whole turn", COLOURS[5], turn_b),
        Curve::line(COLOURS[5], &turn_c),
        Curve::line(COLOURS[5], &turn_blade),
        Curve::named("crank pin B", charts::colour_of_pin("B"), b),
        Curve::named("rocker pin C", charts::colour_of_pin("C"), c),
        Curve::named("blade", COLOURS[0], blade),
    ];
    let over = |title, unit, curve| {
        Panel::over(title, ["t in s", unit], vec![Curve::line(COLOURS[2], curve)])
    };
    charts::write(
        "flying_shear",
        "Flying shear, one cut",
        2,
        vec![
            over("Rocker angle", "ψ in deg", &angle),
            over("Rocker angular velocity", "ω in mrad/s", &omega),
            over("Rocker angular acceleration", "α in mrad/s²", &alpha),
            Panel::plane("Paths of the pins and the blade", ["x in mm", "y in mm"], paths),
        ],
    );
    Ok(())
}
