//! Six-bar of a crank, an RPR and an RPP group: a shaper whose swinging rod moves a ram.

use charts::{COLOURS, Curve, Panel, rounded};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Crank, swinging rod and ram.
    pub struct SixBar {
        input theta: angle;

        ground A(0, 0), D(0, -1m);
        guide rail through (0, 0.8m) along 0deg;

        crank AB(A) -> B        { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)  { mode: ahead }
        /// Upper end of the rod.
        point E on rod at (1.6m, 0);
        rpp   pin(E), ram(rail) { slot: 90deg }
    }
}

const OMEGA: f64 = 10.0;

fn main() -> Result<(), SolveError> {
    let shaper = SixBar::new();
    println!("Six-bar: crank 0.4 m, rod 1.6 m about a pivot 1 m below, at {OMEGA} rad/s\n");
    println!("crank     rod ω of rod  α of rod    block       pin       ram  v of ram   a of ram");
    println!("  deg     deg    rad/s    rad/s²        m         m         m       m/s       m/s²");
    let (mut slides, mut speeds, mut seconds) = (vec![], vec![], vec![]);
    for degrees in (0..=360).step_by(3) {
        let m = shaper.motion(f64::from(degrees).to_radians(), OMEGA, 0.0)?;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        if degrees % 15 == 0 {
            println!(
                "{degrees:5} {:7.2} {:8.4} {:9.4} {:8.4} {:9.4} {:9.4} {:9.4} {:10.4}",
                p.rod.angle().to_degrees(),
                rounded(v.rod.omega, 4),
                rounded(a.rod.alpha, 4),
                p.block.slide,
                p.pin.slide,
                rounded(p.ram.slide, 4),
                rounded(v.ram.slide, 4),
                rounded(a.ram.slide, 4),
            );
        }
        slides.push((f64::from(degrees), p.ram.slide));
        speeds.push((f64::from(degrees), v.ram.slide));
        seconds.push((f64::from(degrees), a.ram.slide));
    }
    let crank = "crank in deg";
    let ram = |name, unit, curve: &[(f64, f64)]| {
        Panel::over(name, [crank, unit], vec![Curve::line(COLOURS[3], curve)])
    };
    charts::write(
        "six_bar",
        "Crank, swinging rod and ram at 10 rad/s",
        3,
        vec![
            ram("Ram", "m", &slides),
            ram("Ram velocity", "m/s", &speeds),
            ram("Ram acceleration", "m/s²", &seconds),
        ],
    );
    Ok(())
}
