//! A crank-rocker that drives an RRP group: motion curves, and whether any such mechanism can be
//! assembled and turn fully, asked of the solver itself.

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Crank, coupler, rocker, and a connecting rod from the rocker to a block on a guide.
    pub struct CrankRockerSlider {
        input theta: angle;
        param crank_length = 60mm;
        param rod_length = 220mm;

        ground A(0, 0), D(200mm, -40mm);
        guide way through (0, 260mm) along 0deg;

        crank AB(A) -> B             { length: crank_length, angle: theta }
        rrr   BC(B), DC(D) -> C      { lengths: (190mm, 120mm), mode: left }
        /// End of the rocker beyond the coupler's pin.
        point E on DC at (210mm, 0);
        rrp   EF(E), block(way) -> F { length: rod_length, offset: 0, mode: ahead }
    }
}

/// Checks that the mechanism makes a whole turn; the error is the first angle that it cannot reach, and why.
fn turns_fully(machine: &CrankRockerSlider) -> Result<(), (i32, SolveError)> {
    (0..360).try_for_each(|degrees| {
        let pose = machine.position(f64::from(degrees).to_radians());
        pose.map(drop).map_err(|error| (degrees, error))
    })
}

fn main() -> Result<(), SolveError> {
    let machine = CrankRockerSlider::new();
    println!("Crank-rocker with a slider, 10 rad/s\n");
    println!("crank       DC   ω of DC   α of DC     block v of block a of block");
    println!("  deg      deg     rad/s    rad/s²        mm       m/s       m/s²");
    let (mut slides, mut speeds, mut seconds, mut rocker) = (vec![], vec![], vec![], vec![]);
    for degrees in (0..=360).step_by(3) {
        let at = f64::from(degrees);
        let m = machine.motion(at.to_radians(), 10.0, 0.0)?;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        let psi = p.DC.angle().to_degrees();
        if degrees % 15 == 0 {
            println!(
                "{degrees:5} {psi:8.2} {:9.3} {:9.2} {:9.2} {:9.4} {:10.3}",
                v.DC.omega,
                a.DC.alpha,
                p.block.slide * 1e3,
                v.block.slide,
                a.block.slide,
            );
        }
        rocker.push((at, psi));
        slides.push((at, p.block.slide * 1e3));
        speeds.push((at, v.block.slide));
        seconds.push((at, a.block.slide));
    }

    println!("\nWhich dimensions turn fully?");
    for (crank_length, rod_length) in [(0.06, 0.22), (0.06, 0.10), (0.09, 0.22), (0.12, 0.22)] {
        let other = CrankRockerSlider { crank_length, rod_length };
        print!("  crank {:3.0} mm, rod {:3.0} mm: ", crank_length * 1e3, rod_length * 1e3);
        match turns_fully(&other) {
            Ok(()) => println!("turns fully"),
            Err((degrees, error)) => println!("stops at {degrees}°: {error}"),
        }
    }
    chart([rocker, slides, speeds, seconds]);
    Ok(())
}

fn chart([rocker, slides, speeds, seconds]: [Vec<(f64, f64)>; 4]) {
    let crank = "crank in deg";
    let over = |name, unit, colour: usize, curve: &[(f64, f64)]| {
        Panel::over(name, [crank, unit], vec![Curve::line(COLOURS[colour], curve)])
    };
    charts::write(
        "crank_rocker_slider",
        "Crank-rocker with a slider at 10 rad/s",
        2,
        vec![
            over("Rocker", "deg", 2, &rocker),
            over("Block", "mm", 3, &slides),
            over("Block velocity", "m/s", 3, &speeds),
            over("Block acceleration", "m/s²", 3, &seconds),
        ],
    );
}
