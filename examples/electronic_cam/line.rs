//! Electronic cam of a flying shear: a drive that keeps the blade at the speed of the strip while
//! it cuts, and makes the wanted length over the rest of the turn.
//!
//! The cam itself is in `cam.rs`, a crate of its own, as it runs on the drive at 1 kHz, in double and in single
//! precision. Here are the line that it is tried on, the report of its cuts, and the chart.

use std::f64::consts::{PI, TAU};

use cam::{Cam, FlyingShear, Setpoint, Strip, WORST_CASE};
use charts::{BLACK, COLOURS, Curve, GREY, Panel};
use linkage_core::{Real, SolveError};

/// The period of the control, in s.
const PERIOD: f64 = 1e-3;
/// The overtravel of the blade through the strip, in m: its thickness and the overlap of the blades.
const DEPTH: f64 = 1e-3;
/// The lengths in the order: three pieces of each, in m.
const ORDER: [f64; 9] = [0.45, 0.45, 0.45, 0.32, 0.32, 0.32, 0.6, 0.6, 0.6];

/// The strip's position, speed and acceleration at time `t`: the line is speeding up, and its
/// looper swings.
fn line(t: f64) -> [f64; 3] {
    let (swing, rate) = (0.012, 9.0);
    let (sin, cos) = (rate * t).sin_cos();
    [
        0.9 * t + 0.025 * t * t + swing / rate * (1.0 - cos),
        0.9 + 0.05 * t + swing * sin,
        0.05 + swing * rate * cos,
    ]
}

/// The crank angles at which the blade meets the strip, is deepest, and leaves the strip.
fn engagement(shear: &FlyingShear) -> Result<[f64; 3], SolveError> {
    // At commissioning there is time to search; the blade is deepest near 290°.
    let lowest = bisect([PI * 1.5, PI * 1.75], |angle| Ok(shear.coefficients(angle)?[1][0]))?;
    let surface = shear.position(lowest)?.blade.y + DEPTH;
    let above = |angle| Ok(shear.position(angle)?.blade.y - surface);
    let meets = bisect([lowest - 0.5, lowest], |angle| Ok(-above(angle)?))?;
    let leaves = bisect([lowest, lowest + 0.5], above)?;
    Ok([meets, lowest, leaves])
}

/// Where a function changes from negative to positive.
fn bisect(
    [mut low, mut high]: [f64; 2],
    f: impl Fn(f64) -> Result<f64, SolveError>,
) -> Result<f64, SolveError> {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle)? < 0.0 { low = middle } else { high = middle }
    }
    Ok(0.5 * (low + high))
}

/// One piece of strip, between two cuts.
struct Piece {
    wanted: f64,
    length: f64,
}

/// The record of the drive's and the blade's motion.
#[derive(Default)]
struct Record {
    pieces: Vec<Piece>,
    /// Over time in s.
    strip: Vec<(f64, f64)>,
    blade: Vec<(f64, f64)>,
    speed: Vec<(f64, f64)>,
    acceleration: Vec<(f64, f64)>,
    /// Over the crank angle in degrees, in mm/s; one curve for each cut.
    slips: Vec<Vec<(f64, f64)>>,
}

/// Cuts the order with a cam of this precision. The drive follows its set-points: from each of
/// them it turns with the acceleration that it was given, for a period.
fn cut_to_length<T: Real>([meets, lowest, leaves]: [f64; 3]) -> Result<Record, SolveError> {
    let number = |value: f64| T::lit(value, value as f32);
    let mut cam = Cam::<T>::new(number(meets), number(leaves), number(ORDER[0]))?;
    let mut record = Record::default();
    let (mut counter, mut last_cut, mut was_cutting) = (0.0, None, false);
    for tick in 0_u32.. {
        let t = f64::from(tick) * PERIOD;
        let [s, speed, acceleration] = line(t);
        let strip = Strip {
            advance: number(s - counter),
            speed: number(speed),
            acceleration: number(acceleration),
        };
        counter = s;
        let Setpoint { angle, speed, acceleration } = cam.step(strip)?;
        let drive = [angle, speed, acceleration].map(Real::value);
        if cam.is_cutting() && !was_cutting {
            record.slips.push(Vec::new());
        }
        was_cutting = cam.is_cutting();
        record.follow(t, drive, was_cutting.then_some(leaves))?;
        if let Some(deepest) = reaches(lowest, drive).filter(|_| was_cutting) {
            let [s, ..] = line(t + deepest);
            if let Some(before) = last_cut.replace(s) {
                record.part(s - before);
            }
            if let Some(&next) = ORDER.get(record.pieces.len()) {
                cam.length = number(next);
            }
        }
        if record.pieces.len() == ORDER.len() && !was_cutting {
            break;
        }
    }
    Ok(record)
}

/// When in this period the crank gets to the angle, if it does.
fn reaches(target: f64, [angle, speed, acceleration]: [f64; 3]) -> Option<f64> {
    // Half an acceleration over a period is a thousandth of the speed: its square is no matter.
    let time = (target - angle) / speed;
    let time = time / (1.0 + 0.5 * acceleration * time / speed);
    (0.0..PERIOD).contains(&time).then_some(time)
}

impl Record {
    /// Follows the blade over one period in double precision; in a cut, until the crank angle at which
    /// the blade is out of the strip.
    fn follow(&mut self, t: f64, drive: [f64; 3], cut: Option<f64>) -> Result<(), SolveError> {
        let (shear, [angle, speed, acceleration]) = (FlyingShear::new(), drive);
        self.speed.push((t, speed));
        self.acceleration.push((t, acceleration));
        self.strip.push((t, line(t)[1]));
        self.blade.push((t, shear.velocity(angle, speed)?.blade.x));
        let (Some(leaves), Some(slips)) = (cut, self.slips.last_mut()) else { return Ok(()) };
        for tau in [0.0, 0.25, 0.5, 0.75, 0.999].map(|part| part * PERIOD) {
            let turned = angle + (speed + 0.5 * acceleration * tau) * tau;
            let blade = shear.velocity(turned, speed + acceleration * tau)?.blade;
            if turned <= leaves {
                slips.push((turned.to_degrees(), (blade.x - line(t + tau)[1]) * 1e3));
            }
        }
        Ok(())
    }

    /// Another piece is off.
    fn part(&mut self, length: f64) {
        self.pieces.push(Piece { wanted: ORDER[self.pieces.len()], length });
    }

    /// The largest difference of speed between blade and strip in the cut that ends each piece, in
    /// mm/s.
    fn most_slip(&self) -> impl Iterator<Item = f64> {
        self.slips.iter().skip(1).map(|cut| largest(cut))
    }

    /// Over the number of the piece, in µm.
    fn errors(&self) -> Vec<(f64, f64)> {
        let error = |piece: &Piece| (piece.length - piece.wanted) * 1e6;
        (1_u8..).zip(&self.pieces).map(|(n, piece)| (f64::from(n), error(piece))).collect()
    }
}

/// The largest magnitude of a curve.
fn largest(curve: &[(f64, f64)]) -> f64 {
    curve.iter().fold(0.0, |most, (_, y)| most.max(y.abs()))
}

fn main() -> Result<(), SolveError> {
    let shear = FlyingShear::new();
    let engagement = engagement(&shear)?;
    let [meets, lowest, leaves] = engagement.map(f64::to_degrees);
    let [from, _, to] = engagement.map(|angle| shear.position(angle));
    println!("Electronic cam of a flying shear at {:.0} Hz\n", 1.0 / PERIOD);
    println!("blade in the strip from {meets:.2}° to {leaves:.2}°, deepest at {lowest:.2}°");
    println!("strip that passes meanwhile: {:.2} mm\n", (to?.blade.x - from?.blade.x) * 1e3);
    let records = [cut_to_length::<f64>(engagement)?, cut_to_length::<f32>(engagement)?];
    report(&records);
    chart(&records, engagement)
}

fn report([wide, narrow]: &[Record; 2]) {
    println!("                        in f64                  in f32");
    println!("piece   wanted      error       slip        error       slip");
    println!("            mm         µm       mm/s           µm       mm/s");
    let errors = wide.errors().into_iter().zip(narrow.errors());
    let slips = wide.most_slip().zip(narrow.most_slip());
    for ((piece, errors), slips) in wide.pieces.iter().zip(errors).zip(slips) {
        let ((number, wide), (_, narrow)) = errors;
        println!(
            "{number:5} {:8.1} {wide:10.3} {:10.4} {narrow:12.3} {:10.4}",
            piece.wanted * 1e3,
            slips.0,
            slips.1,
        );
    }
    let (speed, acceleration) = (largest(&wide.speed), largest(&wide.acceleration));
    println!("\ncrank: at most {speed:.1} rad/s and {acceleration:.0} rad/s²");
    let sizes = (size_of::<Cam<f64>>(), size_of::<Cam<f32>>());
    println!("state: {} bytes in f64, {} in f32, all on the stack", sizes.0, sizes.1);
    println!("the dearest step: {WORST_CASE} floating-point operations");
    println!("the linkage in them: {}", FlyingShear::COST.coefficients);
    println!("                 and {}", FlyingShear::COST.motion);
}

fn chart([wide, narrow]: &[Record; 2], engagement: [f64; 3]) -> Result<(), SolveError> {
    let shear = FlyingShear::new();
    let path = |from: f64, to: f64| -> Result<Vec<(f64, f64)>, SolveError> {
        let angles = (0_u8..=120).map(|step| from + (to - from) * f64::from(step) / 120.0);
        let points = angles.map(|angle| Ok(shear.position(angle)?.blade));
        points.map(|blade| blade.map(|blade| (blade.x * 1e3, blade.y * 1e3))).collect()
    };
    let paths = vec![
        Curve::named("a whole turn", GREY, path(0.0, TAU)?),
        Curve::named("in the strip", COLOURS[1], path(engagement[0], engagement[2])?),
    ];
    let speeds = vec![
        Curve::named("blade, along the strip", COLOURS[0], wide.blade.clone()),
        Curve::named("strip", BLACK, wide.strip.clone()),
    ];
    let last = |record: &Record| record.slips.last().cloned().unwrap_or_default();
    let slips = vec![
        Curve::named("f64", COLOURS[0], last(wide)),
        Curve::named("f32", COLOURS[1], last(narrow)),
    ];
    let errors = vec![
        Curve::named("f64", COLOURS[0], wide.errors()),
        Curve::named("f32", COLOURS[1], narrow.errors()),
    ];
    let crank = |curve: &[(f64, f64)]| vec![Curve::line(COLOURS[0], curve)];
    let over_time = |title, unit, curves| Panel::over(title, ["t in s", unit], curves);
    charts::write(
        "electronic_cam",
        "Electronic cam of a flying shear",
        2,
        vec![
            over_time("Blade and strip", "speed in m/s", speeds),
            Panel::plane("Path of the blade", ["x in mm", "y in mm"], paths),
            over_time("Crank speed", "ω in rad/s", crank(&wide.speed)),
            over_time("Crank acceleration", "α in rad/s²", crank(&wide.acceleration)),
            Panel::over(
                "Slip in the last cut",
                ["crank angle in deg", "blade − strip in mm/s"],
                slips,
            ),
            Panel::over("Error of the cut length", ["piece", "error in µm"], errors),
        ],
    );
    Ok(())
}
