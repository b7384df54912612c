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

/// The methods' families with colour and shape; every Newton is one, whatever its steps.
const FAMILIES: [(&str, &str, MarkerShape); 8] = [
    ("generated", "#d55e00", MarkerShape::Circle),
    ("generated, compensated", "#222222", MarkerShape::Circle),
    ("generated, sweep", "#f0b28c", MarkerShape::Circle),
    ("straightforward", "#0072b2", MarkerShape::Square),
    ("tuned by hand", "#56b4e9", MarkerShape::Diamond),
    ("half angles", "#009e73", MarkerShape::Triangle),
    ("Newton", "#cc79a7", MarkerShape::Cross),
    ("num-dual", "#e69f00", MarkerShape::TriangleDown),
];

/// Writes `target/charts/work_precision.svg` and says so. The axes are linear in the logarithms.
pub(crate) fn write(measured: &[Measured]) {
    let mut mechanisms: Vec<&str> = measured.iter().map(|m| m.mechanism).collect();
    mechanisms.dedup();
    mechanisms.truncate(measured.len() / 2);
    let panels = mechanisms.iter().map(|name| panel(name, measured));
    let (plots, layouts): (Vec<_>, Vec<_>) = panels.unzip();
    let scene = Figure::new(2, 2)
        .with_title("Speed against error: lower left is better; above, f32, below, f64")
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(620.0, 420.0)
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

fn panel(mechanism: &str, measured: &[Measured]) -> (Vec<Plot>, Layout) {
    let plots: Vec<Plot> = FAMILIES
        .into_iter()
        .map(|(family, colour, shape)| {
            let points: Vec<_> = measured
                .iter()
                .filter(|of| of.mechanism == mechanism)
                .flat_map(|of| of.findings.iter().filter_map(|f| point(f, family, of.epsilon)))
                .collect();
            let plot = ScatterPlot::new().with_data(points).with_color(colour).with_legend(family);
            plot.with_marker(shape).with_size(5.0).into()
        })
        .collect();
    let layout = Layout::auto_from_plots(&plots)
        .with_title(mechanism)
        .with_x_label("log₁₀ of nanoseconds per pose")
        .with_y_label("log₁₀ of the relative error of acceleration");
    (plots, layout)
}

fn point(finding: &Finding, family: &str, epsilon: f64) -> Option<(f64, f64)> {
    let [_, _, acceleration] = finding.errors?;
    let point = (finding.throughput.nanoseconds.log10(), (acceleration * epsilon).log10());
    let rest = finding.name.strip_prefix(family)?;
    let is_member = rest.is_empty() || rest.starts_with(", steps");
    (is_member && point.1.is_finite()).then_some(point)
}
