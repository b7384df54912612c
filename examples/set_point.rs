//! A press ram commanded at 1 kHz: which angle, speed and acceleration of the drive give the ram's
//! motion that is wanted. The angle is the unknown, the ram's place its equation.

use std::f64::consts::PI;

use charts::{COLOURS, Curve, Panel, rounded};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A press whose shaft is 30 mm off the ram's line.
    pub struct Press {
        /// Where the ram is to be, from the shaft.
        input x: length;
        /// The drive's angle, where the search begins.
        param seed: near = 90deg;

        ground A(0, 0);
        guide bed through (0, 30mm) along 0deg;

        unknown theta: angle between (6deg, 189deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }

        output theta, ram.slide;
    }
}

/// The ram's way in a cycle of one second, its rate and its acceleration: in as a versine, a dwell,
/// and back.
fn command(t: f64) -> [f64; 3] {
    const TOP: f64 = 0.325;
    const WAY: f64 = 0.135;
    let versine = |part: f64, time: f64, sign: f64| {
        let (sin, cos) = (PI * part).sin_cos();
        let omega = PI / time;
        let way = WAY * 0.5;
        [way * sign * (1.0 - cos), way * sign * omega * sin, way * sign * omega * omega * cos]
    };
    match t {
        _ if t < 0.4 => {
            let [way, rate, second] = versine(t / 0.4, 0.4, -1.0);
            [TOP + way, rate, second]
        }
        _ if t < 0.5 => [TOP - WAY, 0.0, 0.0],
        _ => {
            let [way, rate, second] = versine((t - 0.5) / 0.5, 0.5, 1.0);
            [TOP - WAY + way, rate, second]
        }
    }
}

fn main() -> Result<(), SolveError> {
    let mut press = Press::new();
    println!("{}", Press::COST);
    println!("\n    t       ram     theta ω of theta   α of theta");
    println!("   ms        mm       deg      rad/s      rad/s²");
    let mut curves = [vec![], vec![], vec![], vec![]];
    let mut worst = 0.0_f64;
    for tick in 0..=1000 {
        let t = f64::from(tick) * 1e-3;
        let [x, rate, second] = command(t);
        let m = press.motion(x, rate, second)?;
        // A tick later the drive is about here.
        let (theta, omega, alpha) = (m.position.theta, m.velocity.theta, m.acceleration.theta);
        press.seed = theta + 1e-3 * (omega + 0.5e-3 * alpha);
        worst = worst.max((m.position.ram.slide - x).abs());
        for (curve, value) in curves.iter_mut().zip([1e3 * x, theta.to_degrees(), omega, alpha]) {
            curve.push((1e3 * t, value));
        }
        if tick % 50 == 0 {
            let degrees = theta.to_degrees();
            let (omega, alpha) = (rounded(omega, 4), rounded(alpha, 4));
            println!("{tick:5} {:9.3} {degrees:9.4} {omega:10.4} {alpha:12.4}", 1e3 * x);
        }
    }
    println!("\nThe ram misses its command by at most {worst:.1e} m.");
    let out = press.position(0.34).expect_err("beyond the dead point");
    println!("At 340 mm: {out}");
    let titles = [("Ram", "mm"), ("Drive", "deg"), ("Speed", "rad/s"), ("Acceleration", "rad/s²")];
    let panels = titles.iter().zip(curves).zip(COLOURS).map(|(((title, unit), curve), colour)| {
        Panel::over(title, ["t in ms", unit], vec![Curve::named(title, colour, curve)])
    });
    charts::write("set_point", "The drive of a press for a wanted ram", 2, panels.collect());
    Ok(())
}
