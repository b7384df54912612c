//! The picture: error of an acceleration against time, a panel a width, and beside it the error of a
//! position against the distance from a limit.

use charts::{Curve, MarkerShape, Panel};
use laboratory::near_limits;

use crate::bench::Finding;

/// One mechanism in one width, measured.
pub(crate) struct Measured {
    pub(crate) epsilon: f64,
    pub(crate) findings: Vec<Finding>,
}

/// The methods' families with their shapes; every Newton is one, whatever its steps.
const FAMILIES: [(&str, MarkerShape); 8] = [
    ("straightforward", MarkerShape::Square),
    ("tuned by hand", MarkerShape::Diamond),
    ("half angles", MarkerShape::Triangle),
    ("Newton", MarkerShape::Cross),
    ("num-dual", MarkerShape::TriangleDown),
    ("generated, compensated", MarkerShape::Star),
    ("generated, sweep", MarkerShape::Plus),
    ("generated", MarkerShape::Circle),
];

/// Writes `target/charts/work_precision.svg` and says so: a row a width.
pub(crate) fn write(measured: &[Measured]) {
    let panels =
        near_limits::stretched().into_iter().zip([("f64", f64::EPSILON), ("f32", EPSILON)]);
    let panels = panels.flat_map(|(sweep, (width, epsilon))| {
        let of_width = measured.iter().filter(|measured| measured.epsilon == epsilon);
        let stretched = format!("Two bars nearly stretched, {width}");
        [race(width, &of_width.collect::<Vec<_>>()), sweep.panel(&stretched, 0)]
    });
    let title = "Speed against error, each point a mechanism: lower left is better";
    charts::write("work_precision", title, 2, panels.collect());
}

const EPSILON: f64 = f32::EPSILON as f64;

fn race(width: &str, measured: &[&Measured]) -> Panel {
    let dots = |(family, marker): (&str, MarkerShape)| {
        let findings = measured.iter().flat_map(|measured| &measured.findings);
        let points = findings.filter_map(|finding| point(finding, family)).collect();
        Curve::dots(family, charts::colour_of(family), marker, points)
    };
    let axes =
        ["time of a pose over that of the straightforward form", "error of accelerations in ε"];
    let title = format!("Position, velocity and acceleration, {width}");
    Panel::over(&title, axes, FAMILIES.map(dots).into()).logarithmic()
}

/// Time, and the largest error of an acceleration.
fn point(finding: &Finding, family: &str) -> Option<(f64, f64)> {
    let [_, _, acceleration] = finding.errors?;
    let rest = finding.name.strip_prefix(family)?;
    let is_member = rest.is_empty() || rest.starts_with(", steps");
    let is_drawn = is_member && acceleration.is_finite() && acceleration > 0.0;
    is_drawn.then_some((finding.throughput.ratio, acceleration))
}
