//! Four-bar with a closed vector loop: the table every 5° of both angles, angular velocities and
//! angular accelerations at 250 rad/s, and the coupler drawn over a turn.

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A crank-rocker of 12, 4, 10 and 7 inches.
    pub struct FourBar {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }
    }
}

const OMEGA: f64 = 250.0;

fn main() -> Result<(), SolveError> {
    let bars = FourBar::new();
    println!("Four-bar 304.8 / 101.6 / 254.0 / 177.8 mm at {OMEGA} rad/s\n");
    println!("crank       BC       DC    ω of BC   ω of DC    α of BC    α of DC");
    println!("  deg      deg      deg      rad/s     rad/s     rad/s²     rad/s²");
    let mut tables: [Vec<(f64, f64)>; 6] = Default::default();
    for step in 0..=72 {
        let degrees = f64::from(step) * 5.0;
        let m = bars.motion(degrees.to_radians(), OMEGA, 0.0)?;
        let row = [
            m.position.BC.angle().to_degrees(),
            m.position.DC.angle().to_degrees(),
            m.velocity.BC.omega,
            m.velocity.DC.omega,
            m.acceleration.BC.alpha,
            m.acceleration.DC.alpha,
        ];
        let [coupler, rocker, w3, w4, a3, a4] = row;
        println!("{degrees:5.0} {coupler:8.3} {rocker:8.3} {w3:10.3} {w4:9.3} {a3:10.1} {a4:10.1}");
        for (table, value) in tables.iter_mut().zip(row) {
            table.push((degrees, value));
        }
    }
    chart(tables);
    Ok(())
}

fn chart([coupler, rocker, w3, w4, a3, a4]: [Vec<(f64, f64)>; 6]) {
    let two = |first, second| {
        vec![Curve::named("coupler", COLOURS[0], first), Curve::named("rocker", COLOURS[2], second)]
    };
    let crank = "crank in deg";
    charts::write(
        "four_bar",
        "Four-bar at 250 rad/s",
        3,
        vec![
            Panel::over("Angles", [crank, "deg"], two(coupler, rocker)),
            Panel::over("Angular velocities", [crank, "rad/s"], two(w3, w4)),
            Panel::over("Angular accelerations", [crank, "rad/s²"], two(a3, a4)),
        ],
    );
}
