//! The picture: error of an acceleration against time, a panel a width and an instruction set, and beside
//! them the error of a position against the distance from a limit.

use charts::{Curve, MarkerShape, Panel};
use laboratory::near_limits;

use crate::bench::Finding;
use crate::dots::{self, Dot};

/// One mechanism in one width, measured.
pub(crate) struct Measured {
    pub(crate) width: &'static str,
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

/// Writes `target/charts/work_precision.svg` and prints its path: a row a width. The results of the last
/// run that was compiled the other way are drawn as well.
pub(crate) fn write(measured: &[Measured]) {
    let here = cfg!(target_feature = "fma");
    let found = found(measured);
    dots::keep(here, &found);
    let other = dots::kept(!here);
    let ways = if here { [(false, other), (true, found)] } else { [(false, found), (true, other)] };
    let ways: Vec<_> = ways.into_iter().filter(|(_, dots)| !dots.is_empty()).collect();
    let mut panels = Vec::new();
    for (sweep, width) in near_limits::stretched().into_iter().zip(["f64", "f32"]) {
        panels.extend(ways.iter().map(|(is_fused, dots)| race(width, *is_fused, dots)));
        panels.push(sweep.panel(&format!("Two bars nearly stretched, {width}"), 0));
    }
    let title = "Speed against error, each point a mechanism: lower left is better";
    charts::write("work_precision", title, ways.len() + 1, panels);
}

fn race(width: &str, is_fused: bool, dots: &[Dot]) -> Panel {
    let curve = |(family, marker): (&str, MarkerShape)| {
        let dots = dots.iter().filter(|dot| dot.width == width && dot.family == family);
        let points = dots.map(|dot| dot.point).collect();
        Curve::dots(family, charts::colour_of(family), marker, points)
    };
    let axes =
        ["time of a pose over that of the straightforward form", "error of accelerations in ε"];
    let fused = if is_fused { "with" } else { "without" };
    let title = format!("Motion, {width}, {fused} fused operations");
    Panel::over(&title, axes, FAMILIES.map(curve).into()).logarithmic()
}

/// Times, and the largest errors of an acceleration.
fn found(measured: &[Measured]) -> Vec<Dot> {
    let dots = measured.iter().flat_map(|Measured { width, findings }| {
        findings.iter().filter_map(|finding| {
            let (family, point) = point(finding)?;
            Some(Dot { width: (*width).to_owned(), family: family.to_owned(), point })
        })
    });
    dots.collect()
}

fn point(finding: &Finding) -> Option<(&'static str, (f64, f64))> {
    let [_, _, acceleration] = finding.errors?;
    let is_member = |family: &str| {
        finding
            .name
            .strip_prefix(family)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(", steps"))
    };
    let (family, _) = FAMILIES.into_iter().find(|&(family, _)| is_member(family))?;
    let is_drawn = acceleration.is_finite() && acceleration > 0.0;
    is_drawn.then_some((family, (finding.throughput.ratio, acceleration)))
}
