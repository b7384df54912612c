//! Excavator: the inputs are the lengths of the three cylinders, as its hydraulics give them.

use charts::{BLACK, COLOURS, Curve, Panel, rounded};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Boom, stick and bucket, each moved by a cylinder; ground level is y = 0.
    pub struct Excavator {
        /// Lengths of the boom's, the stick's and the bucket's cylinder, pin to pin.
        input lift, crowd, curl: length;

        ground O(0, 1.7m), F(0.6m, 1.2m);

        rrr   lift_ram(F), boom(O) -> G   { lengths: (lift, 2.4m), mode: right }
        point S on boom at (5.4m, -0.9m);
        point H on boom at (2.6m, 0.55m);
        rrr   crowd_ram(H), stick(S) -> J { lengths: (crowd, 0.8m), mode: left }
        point T on stick at (-2.7m, 0.2m);
        point N on stick at (-0.2m, -0.5m);
        point K on stick at (-2.3m, 0);
        rrr   curl_ram(N), lever(K) -> V  { lengths: (curl, 0.6m), mode: left }
        rrr   pull(V), bucket(T) -> W     { lengths: (0.6m, 0.45m), mode: left }
        /// Cutting edge of the bucket.
        point tooth on bucket at (-0.4m, -1.4m);
    }
}

/// Cylinder lengths at the corners of a digging cycle, a second and a half apart.
const CYCLE: [[f64; 3]; 6] = [
    [2.35, 2.65, 1.80],
    [2.15, 2.75, 1.85],
    [2.15, 3.20, 2.10],
    [2.30, 3.45, 2.35],
    [2.75, 3.30, 2.40],
    [2.35, 2.65, 1.80],
];
const LEG: f64 = 1.5;

/// Lengths, rates and accelerations at time `t`: fifth-order transitions, at rest at each corner.
fn cylinders(t: f64) -> [[f64; 3]; 3] {
    let leg = ((t / LEG) as usize).min(CYCLE.len() - 2);
    let s = t / LEG - leg as f64;
    let blend = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * (s * (1.0 - s)).powi(2) / LEG;
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (LEG * LEG);
    let (from, to) = (CYCLE[leg], CYCLE[leg + 1]);
    [
        core::array::from_fn(|i| from[i] + (to[i] - from[i]) * blend),
        core::array::from_fn(|i| (to[i] - from[i]) * rate),
        core::array::from_fn(|i| (to[i] - from[i]) * second),
    ]
}

fn main() -> Result<(), SolveError> {
    let digger = Excavator::new();
    let duration = LEG * (CYCLE.len() - 1) as f64;
    println!("Excavator over one digging cycle of {duration} s\n");
    println!("    t    lift   crowd    curl   tooth x  tooth y v tooth  a tooth  bucket  ω bucket");
    println!("    s       m       m       m         m        m     m/s     m/s²     deg     rad/s");
    let (mut path, mut speeds) = (vec![], vec![]);
    let mut volumes = [vec![], vec![], vec![]];
    for step in 0..=150 {
        let t = duration * f64::from(step) / 150.0;
        let [q, rate, second] = cylinders(t);
        let m = digger.motion(q, rate, second)?;
        let (p, v, a) = (m.position.tooth, m.velocity.tooth, m.acceleration.tooth);
        let speed = v.x.hypot(v.y);
        if step % 5 == 0 {
            println!(
                "{t:5.2} {:7.3} {:7.3} {:7.3} {:9.3} {:8.3} {speed:7.3} {:8.3} {:7.1} {:9.3}",
                q[0],
                q[1],
                q[2],
                p.x,
                p.y,
                a.x.hypot(a.y),
                m.position.bucket.angle().to_degrees(),
                rounded(m.velocity.bucket.omega, 3),
            );
        }
        path.push((p.x, p.y));
        speeds.push((t, speed));
        for (curve, rate) in volumes.iter_mut().zip(rate) {
            curve.push((t, rate));
        }
    }

    // The motion of the tooth for a millimetre of each cylinder, halfway through the cut.
    let slopes = digger.coefficients(cylinders(2.25)[0])?;
    println!("\ntooth per millimetre of cylinder, in the cut");
    for (name, row) in Excavator::OUTPUTS.iter().zip(slopes) {
        if name.starts_with("tooth") {
            println!("  {name}: lift {:6.2}, crowd {:6.2}, curl {:6.2} mm", row[0], row[1], row[2]);
        }
    }
    chart(&path, &speeds, volumes);
    Ok(())
}

fn chart(path: &[(f64, f64)], speeds: &[(f64, f64)], rates: [Vec<(f64, f64)>; 3]) {
    let plane =
        vec![Curve::line(BLACK, &[(-1.5, 0.0), (10.0, 0.0)]), Curve::line(COLOURS[1], path)];
    let names = ["lift", "crowd", "curl"];
    let rates = rates.into_iter().zip(names).zip(COLOURS);
    let rates = rates.map(|((curve, name), colour)| Curve::named(name, colour, curve)).collect();
    charts::write(
        "excavator",
        "Excavator, one digging cycle",
        3,
        vec![
            Panel::plane("The tooth's path over the ground", ["x in m", "y in m"], plane),
            Panel::over("Cylinder speeds", ["t in s", "m/s"], rates),
            Panel::over("Tooth speed", ["t in s", "m/s"], vec![Curve::line(COLOURS[1], speeds)]),
        ],
    );
}
