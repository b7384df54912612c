//! The hard poses as a table: every number a solver answers, its error, and the error that the
//! data allow.

use linkage_core::{Real, Side, SolveError};

use crate::mechanisms::stacked_sliders::*;
use crate::tables::hard::{self, Case};
use crate::widths::number;

/// One number of one case.
#[derive(Clone, Debug)]
pub struct Line {
    pub mechanism: &'static str,
    pub case: &'static str,
    pub quantity: &'static str,
    pub error: f64,
    pub achievable: f64,
}

impl Line {
    /// The error in units of what rounding the inputs once would cause.
    pub fn ratio(&self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.achievable }
    }
}

type Answer = Result<Vec<f64>, SolveError>;

const BARS: &[&str] = &["Cx", "Cy", "theta2", "theta3", "omega2", "omega3", "alpha2", "alpha3"];
const FOUR_BAR: &[&str] = &["Cx", "Cy", "omega2", "omega3", "alpha3"];
const GUIDES: &[&str] = &["Cx", "Cy", "s1", "s2", "ds1", "ds2"];
const YOKE: &[&str] = &["s1", "s2", "ds1", "ds2", "dds2"];
const BAR: &[&str] = &["theta3", "omega3", "alpha3", "s", "ds", "dds"];
const PISTON: &[&str] = &["s", "ds", "dds", "theta2", "omega2"];

/// A case that was refused, by its mechanism and name.
pub type Refusal = (&'static str, &'static str, SolveError);

/// The whole table, and the cases that were refused.
pub fn table() -> (Vec<Line>, Vec<Refusal>) {
    let (mut lines, mut refusals) = (Vec::new(), Vec::new());
    let mut add = |mechanism, cases: &'static [Case], names, solve: &dyn Fn(&Case) -> Answer| {
        for case in cases {
            match solve(case) {
                Ok(values) => lines.extend(compare(mechanism, case, names, &values)),
                Err(error) => refusals.push((mechanism, case.name, error)),
            }
        }
    };
    add("rrr", &hard::RRR, BARS, &stacked_rrr::<f64>);
    add("rrr, f32", &hard::RRR_F32, BARS, &stacked_rrr::<f32>);
    add("four-bar", &hard::FOUR_BAR_LEFT, FOUR_BAR, &|case| four_bar(&case.inputs, Side::Left));
    add("four-bar", &hard::FOUR_BAR_RIGHT, FOUR_BAR, &|case| four_bar(&case.inputs, Side::Right));
    add("parallelogram", &hard::FOUR_BAR_LEFT, FOUR_BAR, &|case| {
        parallelogram(&case.inputs, Side::Left)
    });
    add("parallelogram", &hard::FOUR_BAR_RIGHT, FOUR_BAR, &|case| {
        parallelogram(&case.inputs, Side::Right)
    });
    add("four-bar", &hard::KITE, FOUR_BAR, &|case| four_bar(&case.inputs, Side::Left));
    add("kite", &hard::KITE, FOUR_BAR, &|case| kite(&case.inputs));
    add("slider-crank", &hard::SLIDER_CRANK, PISTON, &|case| slider_crank(&case.inputs));
    add("prp", &hard::PRP, GUIDES, &|case| prp(&case.inputs));
    add("rpp", &hard::RPP, YOKE, &|case| rpp(&case.inputs));
    add("rpr", &hard::RPR, BAR, &|case| rpr(&case.inputs));
    add("rpr, centric", &hard::RPR[..2], BAR, &|case| centric_rpr(&case.inputs));
    (lines, refusals)
}

fn compare(
    mechanism: &'static str,
    case: &'static Case,
    names: &'static [&'static str],
    values: &[f64],
) -> Vec<Line> {
    assert_eq!((values.len(), names.len()), (case.truth.len(), case.truth.len()));
    let rows = values.iter().zip(&case.truth).zip(names);
    rows.map(|((value, (high, low, achievable)), quantity)| Line {
        mechanism,
        case: case.name,
        quantity,
        error: ((value - high) - low).abs(),
        achievable: *achievable,
    })
    .collect()
}

fn pair<T: Real>(x: f64, y: f64) -> [T; 2] {
    [number(x), number(y)]
}

/// Bx, By, Dx, Dy, l2, l3, vBx, vBy, aBx, aBy. The pin is where the case's Cy says.
fn stacked_rrr<T: Real>(case: &Case) -> Answer {
    let q = &case.inputs;
    let elbow = if case.truth[1].0 >= q[1] { Side::Left } else { Side::Right };
    let group = StackedRrr::<T> {
        dx: number(q[2]),
        dy: number(q[3]),
        l2: number(q[4]),
        l3: number(q[5]),
        elbow,
    };
    let m = group.motion(pair(q[0], q[1]), pair(q[6], q[7]), pair(q[8], q[9]))?;
    let (p, v, a) = (m.position, m.velocity, m.acceleration);
    let values = [p.C.x, p.C.y, p.BC.angle(), p.DC.angle()];
    let rates = [v.BC.omega, v.DC.omega, a.BC.alpha, a.DC.alpha];
    Ok(values.into_iter().chain(rates).map(Real::value).collect())
}

macro_rules! four_bar_answer {
    ($solver:expr, $q:expr) => {{
        let m = $solver.motion($q[0], $q[5], 0.0)?;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        Ok(vec![p.C.x, p.C.y, v.BC.omega, v.DC.omega, a.DC.alpha])
    }};
}

/// theta, a, b, a2, b2, w.
fn four_bar(q: &[f64], elbow: Side) -> Answer {
    let solver =
        ParamFourBar::<f64> { crank: q[1], base: q[2], rocker: q[3], coupler: q[4], elbow };
    four_bar_answer!(solver, q)
}

fn parallelogram(q: &[f64], elbow: Side) -> Answer {
    four_bar_answer!(Parallelogram { elbow, ..Parallelogram::new() }, q)
}

fn kite(q: &[f64]) -> Answer {
    four_bar_answer!(Kite::new(), q)
}

/// theta, r, l, e, w.
fn slider_crank(q: &[f64]) -> Answer {
    let solver = ParamSliderCrank::<f64> { r: q[1], l: q[2], e: q[3] };
    let m = solver.motion(q[0], q[4], 0.0)?;
    let (p, v, a) = (m.position, m.velocity, m.acceleration);
    Ok(vec![p.block.slide, v.block.slide, a.block.slide, p.BC.angle(), v.BC.omega])
}

/// K1x, K1y, K2x, K2y, phi1, phi2, v1x, v1y.
fn prp(q: &[f64]) -> Answer {
    let solver = StackedPrp::<f64> { kx: q[2], ky: q[3], phi1: q[4], phi2: q[5] };
    let m = solver.motion([q[0], q[1]], [q[6], q[7]], [0.0; 2])?;
    let (p, v) = (m.position, m.velocity);
    Ok(vec![p.C.x, p.C.y, p.p.slide, p.q.slide, v.p.slide, v.q.slide])
}

/// phi, beta, Bx, By, vx, vy, ax, ay.
fn rpp(q: &[f64]) -> Answer {
    let solver = StackedRpp::<f64> { phi: q[0], beta: q[1] };
    let m = solver.motion([q[2], q[3]], [q[4], q[5]], [q[6], q[7]])?;
    let (p, v, a) = (m.position, m.velocity, m.acceleration);
    Ok(vec![p.yoke.slide, p.block.slide, v.yoke.slide, v.block.slide, a.block.slide])
}

macro_rules! rpr_answer {
    ($solver:expr, $q:expr) => {{
        let m = $solver.motion([$q[0], $q[1]], [$q[4], $q[5]], [$q[6], $q[7]])?;
        let (p, v, a) = (m.position, m.velocity, m.acceleration);
        let turning = [p.bar.angle(), v.bar.omega, a.bar.alpha];
        let slide = [p.block.slide, v.block.slide, a.block.slide];
        Ok([turning, slide].concat())
    }};
}

/// Bx, By, Dx, Dy, vx, vy, ax, ay, e.
fn rpr(q: &[f64]) -> Answer {
    rpr_answer!(StackedRpr::<f64> { dx: q[2], dy: q[3], e: q[8] }, q)
}

fn centric_rpr(q: &[f64]) -> Answer {
    rpr_answer!(StackedCentricRpr::<f64> { dx: q[2], dy: q[3] }, q)
}
