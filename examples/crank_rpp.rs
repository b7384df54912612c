//! A crank whose pin slides in the upright slot of a yoke: slides, velocities and accelerations
//! over a turn at 10 rad/s.

use charts::{COLOURS, Curve, Panel, rounded};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Crank and RPP group.
    pub struct CrankYoke {
        input theta: angle;

        ground A(0, 0);
        guide rail through (0, -800mm) along 0deg;

        crank AB(A) -> B           { length: 400mm, angle: theta }
        rpp   block(B), yoke(rail) { slot: 90deg }

        output block.slide, yoke.slide;
    }
}

const OMEGA: f64 = 10.0;

fn main() -> Result<(), SolveError> {
    let crank = CrankYoke::new();
    println!("Crank 0.4 m with an RPP group, rail 0.8 m below, at {OMEGA} rad/s\n");
    println!("crank   block  v of block    a of block       yoke   v of yoke     a of yoke");
    println!("  deg        m         m/s          m/s²          m         m/s          m/s²");
    let mut tables: [Vec<(f64, f64)>; 6] = Default::default();
    for degrees in (0..=360).step_by(3) {
        let theta = f64::from(degrees).to_radians();
        let m = crank.motion(theta, OMEGA, 0.0)?;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        let row =
            [p.block.slide, v.block.slide, a.block.slide, p.yoke.slide, v.yoke.slide, a.yoke.slide];
        if degrees % 15 == 0 {
            let shown = row.map(|value| rounded(value, 4));
            println!(
                "{degrees:5} {:8.4} {:11.4} {:13.4} {:10.4} {:11.4} {:13.4}",
                shown[0], shown[1], shown[2], shown[3], shown[4], shown[5]
            );
        }
        for (table, value) in tables.iter_mut().zip(row) {
            table.push((f64::from(degrees), value));
        }
    }
    let [s2, v2, a2, s3, v3, a3] = tables;
    let two = |slot, rail| {
        vec![
            Curve::named("block in the slot", COLOURS[0], slot),
            Curve::named("yoke on the rail", COLOURS[2], rail),
        ]
    };
    let crank = "crank in deg";
    charts::write(
        "crank_rpp",
        "Crank with an RPP group at 10 rad/s",
        3,
        vec![
            Panel::over("Slides", [crank, "m"], two(s2, s3)),
            Panel::over("Velocities", [crank, "m/s"], two(v2, v3)),
            Panel::over("Accelerations", [crank, "m/s²"], two(a2, a3)),
        ],
    );
    Ok(())
}
