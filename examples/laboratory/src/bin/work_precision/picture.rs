//! The log-log picture: time of a pose against error of its acceleration.

use std::fs;
use std::path::PathBuf;

use kuva::prelude::*;

use crate::bench::Finding;

/// One mechanism in one width, measured.
pub(crate) struct Measured {
    pub(crate) mechanism: &'static str,
    pub(crate) epsilon: f64,
    pub(crate) findings: Vec<Finding>,
}

/// The methods' families with their shapes; every Newton is one, whatever its steps.
const FAMILIES: [(&str, MarkerShape); 8] = [
    ("generated", MarkerShape::Circle),
    ("generated, compensated", MarkerShape::Circle),
    ("generated, sweep", MarkerShape::Circle),
    ("straightforward", MarkerShape::Square),
    ("tuned by hand", MarkerShape::Diamond),
    ("half angles", MarkerShape::Triangle),
    ("Newton", MarkerShape::Cross),
    ("num-dual", MarkerShape::TriangleDown),
];

/// Writes `target/charts/work_precision.svg` and says so: a panel a mechanism and width, since what
/// differs within one would be lost between two widths. Errors are in units of the width's ε.
pub(crate) fn write(measured: &[Measured]) {
    let (plots, layouts): (Vec<_>, Vec<_>) = measured.iter().map(panel).unzip();
    let columns = measured.len().div_ceil(2);
    let scene = Figure::new(2, columns)
        .with_title("Speed against error: lower left is better")
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(440.0, 380.0)
        .with_shared_legend_bottom()
        .render();
    let path: PathBuf = ["target", "charts", "work_precision.svg"].iter().collect();
    let written = fs::create_dir_all("target/charts")
        .and_then(|()| fs::write(&path, SvgBackend.render_scene(&scene)));
    match written {
        Ok(()) => println!("picture: {}", path.display()),
        Err(error) => eprintln!("no picture: {}: {error}", path.display()),
    }
}

fn panel(measured: &Measured) -> (Vec<Plot>, Layout) {
    let plots: Vec<Plot> = FAMILIES
        .into_iter()
        .map(|(family, shape)| {
            let points: Vec<_> =
                measured.findings.iter().filter_map(|finding| point(finding, family)).collect();
            let plot = ScatterPlot::new().with_data(points).with_color(charts::colour_of(family));
            plot.with_legend(family).with_marker(shape).with_size(6.0).into()
        })
        .collect();
    let width = if measured.epsilon < 1e-10 { "f64" } else { "f32" };
    let layout = Layout::auto_from_plots(&plots)
        .with_title(format!("{}, {width}", measured.mechanism))
        .with_x_label("log₁₀ of ns per pose")
        .with_y_label("log₁₀ of the acceleration's error in ε");
    (plots, layout)
}

/// Time, and the largest error of an acceleration: what half an ε would be is a logarithm of −0.3.
fn point(finding: &Finding, family: &str) -> Option<(f64, f64)> {
    let [_, _, acceleration] = finding.errors?;
    let point = (finding.throughput.nanoseconds.log10(), acceleration.log10());
    let rest = finding.name.strip_prefix(family)?;
    let is_member = rest.is_empty() || rest.starts_with(", steps");
    (is_member && point.1.is_finite()).then_some(point)
}
