//! Slider-crank with an offset: an engine whose cylinder stands beside the shaft, its dead
//! points, and how far the piston's motion is from harmonic.

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Crank, connecting rod and piston; the cylinder's axis passes beside the shaft.
    pub struct OffsetSliderCrank {
        input theta: angle;
        /// How far the cylinder's axis is to the left of the shaft, seen along the stroke.
        param desaxe = 12mm;

        ground A(0, 0);
        guide bore through A along 90deg;

        crank AB(A) -> B                { length: 43mm, angle: theta }
        rrp   rod(B), piston(bore) -> P { length: 136mm, offset: desaxe, mode: ahead }
    }
}

/// 3000 revolutions per minute.
const OMEGA: f64 = 3000.0 / 60.0 * std::f64::consts::TAU;

/// The crank angle between two angles at which the piston stands still.
fn dead_point(engine: &OffsetSliderCrank, from: f64, to: f64) -> Result<f64, SolveError> {
    let (mut low, mut high) = (from, to);
    let start = engine.velocity(low, 1.0)?.piston.slide;
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if engine.velocity(middle, 1.0)?.piston.slide * start > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok((low + high) / 2.0)
}

fn main() -> Result<(), SolveError> {
    let engine = OffsetSliderCrank::new();
    println!(
        "Engine with 43 mm crank, 136 mm rod, axis {:.0} mm off, 3000 rpm\n",
        engine.desaxe * 1e3
    );
    println!("crank   piston v of piston a of piston   angle of rod");
    println!("  deg       mm         m/s        m/s²            deg");
    for degrees in (0..=360).step_by(15) {
        let m = engine.motion(f64::from(degrees).to_radians(), OMEGA, 0.0)?;
        println!(
            "{degrees:5} {:8.3} {:11.4} {:11.2} {:14.3}",
            m.position.piston.slide * 1e3,
            m.velocity.piston.slide,
            m.acceleration.piston.slide,
            m.position.rod.angle().to_degrees() - 90.0,
        );
    }

    println!("\n   axis off   top dead   bottom dead     stroke   time ratio");
    println!("         mm        deg           deg         mm             ");
    for desaxe in [0.0, 0.006, 0.012, 0.024] {
        let engine = OffsetSliderCrank { desaxe };
        let top = dead_point(&engine, 0.3, 2.8)?;
        let bottom = dead_point(&engine, 3.5, 5.9)?;
        let height = |theta| engine.position(theta).map(|p| p.piston.slide * 1e3);
        println!(
            "{:11.0} {:10.3} {:13.3} {:10.3} {:12.4}",
            desaxe * 1e3,
            top.to_degrees(),
            bottom.to_degrees(),
            height(top)? - height(bottom)?,
            (bottom - top) / (std::f64::consts::TAU - (bottom - top)),
        );
    }
    chart()
}

fn chart() -> Result<(), SolveError> {
    let (mut slides, mut speeds, mut seconds) = (vec![], vec![], vec![]);
    for (desaxe, colour) in [(0.0, COLOURS[0]), (0.012, COLOURS[1]), (0.024, COLOURS[2])] {
        let engine = OffsetSliderCrank { desaxe };
        let (mut slide, mut speed, mut second) = (vec![], vec![], vec![]);
        for degrees in 0..=360 {
            let at = f64::from(degrees);
            let m = engine.motion(at.to_radians(), OMEGA, 0.0)?;
            slide.push((at, m.position.piston.slide * 1e3));
            speed.push((at, m.velocity.piston.slide));
            second.push((at, m.acceleration.piston.slide / 1e3));
        }
        let name = format!("{:.0} mm off", desaxe * 1e3);
        slides.push(Curve::named(&name, colour, slide));
        speeds.push(Curve::named(&name, colour, speed));
        seconds.push(Curve::named(&name, colour, second));
    }
    let crank = "crank in deg";
    charts::write(
        "slider_crank",
        "Slider-crank with an offset at 3000 rpm",
        3,
        vec![
            Panel::over("Piston", [crank, "mm"], slides),
            Panel::over("Piston velocity", [crank, "m/s"], speeds),
            Panel::over("Piston acceleration", [crank, "km/s²"], seconds),
        ],
    );
    Ok(())
}
