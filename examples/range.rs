//! The range of machines, found instead of stepped: which dimensions let the crank turn fully, which
//! group stops it where they do not, and the stroke and time ratio where they do.

use std::f64::consts::{PI, TAU};

use charts::{COLOURS, Curve, Panel};
use linkage_core::mechanism;
use linkage_core::range::{End, Extrema, RangeError, Stop, Stretches, extrema, extrema_of, limits};

mechanism! {
    /// A four-bar whose ground is as long as one likes.
    pub struct FourBar {
        input theta: angle;
        param base = 300mm;

        ground A(0, 0), D(base, 0);

        crank AB(A) -> B        { length: 100mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (250mm, 200mm), mode: left }

        output DC;
    }
}

mechanism! {
    /// A shaper: crank, swinging bar, connecting rod and ram.
    pub struct Shaper {
        input theta: angle;
        /// How far the bar's pivot is below the shaft.
        param depth = 250mm;
        param rod = 420mm;

        ground A(0, 0), D(0, -depth);
        guide way through (0, 50mm) along 180deg;

        crank AB(A) -> B           { length: 120mm, angle: theta }
        rpr   block(B), bar(D)     { offset: 40mm, mode: ahead }
        point E on bar at (280mm, 0);
        rrp   EF(E), ram(way) -> F { length: rod, mode: ahead }

        output ram.slide;
    }
}

/// The whole turn, seen from where the crank lies along the ground.
const TURN: [f64; 2] = [-PI, PI];

/// The stretches of an input and what ends each, a line for each stretch.
fn described(stretches: &Stretches) -> Vec<String> {
    if stretches.is_whole() {
        return vec!["turns fully".to_owned()];
    }
    let end = |stop| match stop {
        Stop::Edge => "goes on".to_owned(),
        Stop::Limit { group } => format!("{group} at its limit"),
        Stop::ChangePoint { group } => format!("{group} at a change point"),
    };
    let mut ends: Vec<[End; 2]> =
        stretches.iter().map(|stretch| [stretch.from, stretch.to]).collect();
    // Stretches that go on at both ends of the turn are one stretch, across ±180°.
    if let ([[first, _], .., [_, last]], true) = (&ends[..], ends.len() > 1)
        && (first.stop, last.stop) == (Stop::Edge, Stop::Edge)
    {
        let [_, to] = ends.remove(0);
        if let Some(last) = ends.last_mut() {
            last[1] = End { at: to.at + TAU, ..to };
        }
    }
    let lines = ends.into_iter().map(|[from, to]| {
        let degrees = [from.at, to.at].map(f64::to_degrees);
        let stops = if from.stop == to.stop {
            end(from.stop)
        } else {
            format!("{}; {}", end(from.stop), end(to.stop))
        };
        format!("{:8.3}° to {:8.3}°  {stops}", degrees[0], degrees[1])
    });
    let lines: Vec<String> = lines.collect();
    if lines.is_empty() { vec!["cannot be assembled".to_owned()] } else { lines }
}

/// The turn of the crank while the output goes one way, over its turn while the output goes back.
fn time_ratio(turns: &Extrema) -> f64 {
    let part = (turns.greatest()[0] - turns.least()[0]).rem_euclid(TAU);
    let ratio = part / (TAU - part);
    ratio.max(ratio.recip())
}

fn rocker(four_bar: &FourBar) -> Result<Extrema, RangeError> {
    extrema(TURN, |theta| {
        let at = four_bar.motion(theta, 1.0, 0.0)?;
        // A rocker that swings stays above the ground.
        let angle = at.position.DC.angle_near(PI / 2.0);
        Ok([angle, at.velocity.DC.omega, at.acceleration.DC.alpha])
    })
}

fn ram(shaper: &Shaper) -> Result<Extrema, RangeError> {
    extrema_of(shaper, "ram.slide", TURN)
}

fn main() -> Result<(), RangeError> {
    println!("Four-bar, crank 100 mm, coupler 250 mm, rocker 200 mm\n");
    println!("ground   rocker from        to   time   crank");
    println!("    mm           deg       deg  ratio");
    for millimetres in [30, 50, 70, 120, 150, 152, 200, 300, 348, 350, 352, 450, 540, 560] {
        let four_bar = FourBar { base: f64::from(millimetres) / 1000.0 };
        let stretches = limits(&four_bar, TURN)?;
        let result = if stretches.is_whole() {
            let swing = rocker(&four_bar)?;
            if swing.is_empty() {
                format!("{:>27}", "turns, too   ")
            } else {
                let [least, greatest] =
                    [swing.least()[1], swing.greatest()[1]].map(f64::to_degrees);
                format!("{least:11.3} {greatest:9.3} {:6.3}", time_ratio(&swing))
            }
        } else {
            String::new()
        };
        let mut result = result.as_str();
        let mut ground = millimetres.to_string();
        for line in described(&stretches) {
            println!("{ground:>6}   {result:28}  {line}");
            (ground, result) = (String::new(), "");
        }
    }

    println!("\nShaper, crank 120 mm, bar 280 mm, way 50 mm above the shaft\n");
    println!(" pivot     rod    stroke    time   crank");
    println!("    mm      mm        mm   ratio");
    for depth in [0.18, 0.22, 0.25, 0.3] {
        for rod in [0.02, 0.05, 0.1, 0.42] {
            let shaper = Shaper { depth, rod };
            let stretches = limits(&shaper, TURN)?;
            let result = if stretches.is_whole() {
                let way = ram(&shaper)?;
                format!("{:9.3} {:7.4}", way.stroke() * 1e3, time_ratio(&way))
            } else {
                String::new()
            };
            let mut head = format!("{:6.0} {:7.0} {result:17}", depth * 1e3, rod * 1e3);
            for line in described(&stretches) {
                println!("{head:33}  {line}");
                head = String::new();
            }
        }
    }
    chart()
}

/// The effect of the four-bar's ground on the crank's range, the rocker's swing and the time ratio.
fn chart() -> Result<(), RangeError> {
    let (mut upper, mut lower) = (vec![], vec![]);
    let (mut least, mut greatest, mut ratios) = (vec![], vec![], vec![]);
    for step in 0..=860 {
        let millimetres = 120.0 + 0.5 * f64::from(step);
        let four_bar = FourBar { base: millimetres / 1000.0 };
        let stretches = limits(&four_bar, TURN)?;
        if stretches.is_whole() {
            let swing = rocker(&four_bar)?;
            least.push((millimetres, swing.least()[1].to_degrees()));
            greatest.push((millimetres, swing.greatest()[1].to_degrees()));
            ratios.push((millimetres, time_ratio(&swing)));
        }
        // The stretch towards the rocker's pivot, or the one above it.
        if let Some(stretch) = stretches.last() {
            upper.push((millimetres, stretch.to.at.to_degrees()));
            lower.push((millimetres, stretch.from.at.to_degrees()));
        }
    }
    let range =
        vec![Curve::named("to", COLOURS[0], upper), Curve::named("from", COLOURS[1], lower)];
    let swing =
        vec![Curve::named("to", COLOURS[0], greatest), Curve::named("from", COLOURS[1], least)];
    let ratio = vec![Curve::named("forward over back", COLOURS[2], ratios)];
    let axes = |unit| ["ground in mm", unit];
    charts::write(
        "range",
        "How far a four-bar goes: crank 100 mm, coupler 250 mm, rocker 200 mm",
        3,
        vec![
            Panel::over("Crank's range", axes("crank in deg"), range),
            Panel::over("Rocker's swing", axes("rocker in deg"), swing),
            Panel::over("Time ratio", axes("crank angle out over back"), ratio),
        ],
    );
    Ok(())
}
