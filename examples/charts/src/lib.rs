//! The charts that the examples draw: curves over an input or over time, and paths in the plane.
//! Nothing about one mechanism belongs here; mechanisms are drawn by `linkage_core::sketch`.

use std::fs;
use std::path::PathBuf;

pub use kuva::prelude::MarkerShape;
use kuva::prelude::*;

/// Blue, vermilion, green, orange, purple, sky: told apart without colour vision too (Okabe and
/// Ito).
pub const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7", "#56b4e9"];
/// The colour of what is about a pin, wherever it is drawn: A to F in the order of `COLOURS`.
pub fn colour_of_pin(name: &str) -> &'static str {
    let nth = name.bytes().next().unwrap_or_default().wrapping_sub(b'A');
    COLOURS.get(usize::from(nth)).copied().unwrap_or(BLACK)
}

/// For what stands behind the curves.
pub const GREY: &str = "#b4b8bc";
/// For what stands still.
pub const BLACK: &str = "#222222";

/// The colour of a way to solve, wherever it is compared with others.
pub fn colour_of(method: &str) -> &'static str {
    match method {
        "generated" | "this solver" => COLOURS[1],
        "generated, compensated" | "compensated" => BLACK,
        "generated, sweep" => "#f0b28c",
        "what the data allow" => GREY,
        "half angles" => COLOURS[2],
        "tuned by hand" => COLOURS[5],
        "Newton" => COLOURS[4],
        "num-dual" => COLOURS[3],
        // What a textbook has.
        _ => COLOURS[0],
    }
}

/// A line through points.
pub struct Curve {
    points: Vec<(f64, f64)>,
    name: Option<String>,
    colour: String,
    width: f64,
    /// Dots of this shape instead of a line.
    marker: Option<MarkerShape>,
}

impl Curve {
    /// A curve with a name in the legend.
    pub fn named(name: &str, colour: &str, points: Vec<(f64, f64)>) -> Self {
        Self {
            points,
            name: Some(name.to_owned()),
            colour: colour.to_owned(),
            width: 2.0,
            marker: None,
        }
    }

    /// A broad grey curve, to stand behind one that should cover it.
    pub fn band(points: Vec<(f64, f64)>) -> Self {
        Self { points, name: None, colour: GREY.to_owned(), width: 6.0, marker: None }
    }

    /// A curve without a name.
    pub fn line(colour: &str, points: &[(f64, f64)]) -> Self {
        Self {
            points: points.to_vec(),
            name: None,
            colour: colour.to_owned(),
            width: 1.5,
            marker: None,
        }
    }

    /// Dots with a name in the legend.
    pub fn dots(name: &str, colour: &str, marker: MarkerShape, points: Vec<(f64, f64)>) -> Self {
        Self { marker: Some(marker), ..Self::named(name, colour, points) }
    }
}

/// One system of axes.
pub struct Panel {
    title: String,
    axes: [String; 2],
    curves: Vec<Curve>,
    in_the_plane: bool,
    is_logarithmic: bool,
}

impl Panel {
    /// Curves over an input or over time.
    pub fn over(title: &str, axes: [&str; 2], curves: Vec<Curve>) -> Self {
        let axes = axes.map(str::to_owned);
        Self { title: title.to_owned(), axes, curves, in_the_plane: false, is_logarithmic: false }
    }

    /// Paths: both axes are lengths and drawn to one scale.
    pub fn plane(title: &str, axes: [&str; 2], curves: Vec<Curve>) -> Self {
        Self { in_the_plane: true, ..Self::over(title, axes, curves) }
    }

    /// With logarithmic axes, both.
    #[must_use]
    pub fn logarithmic(self) -> Self {
        Self { is_logarithmic: true, ..self }
    }

    fn drawn(self) -> (Vec<Plot>, Layout) {
        let last = self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0);
        let last = last.fold(f64::NEG_INFINITY, f64::max);
        let mut curves = self.curves;
        if let [only] = &mut curves[..] {
            // The title names it.
            only.name = None;
        }
        let plots: Vec<Plot> = curves.into_iter().map(drawn).collect();
        let layout = Layout::auto_from_plots(&plots)
            .with_title(self.title)
            .with_x_label(self.axes[0].as_str())
            .with_y_label(self.axes[1].as_str())
            .with_legend_position(LegendPosition::OutsideRightTop)
            .with_title_size(15)
            .with_label_size(12)
            .with_tick_size(10)
            .with_body_size(11);
        let layout = match (self.in_the_plane, last) {
            _ if self.is_logarithmic => layout.with_log_scale(),
            (true, _) => layout.with_equal_aspect(),
            // A turn of a crank in degrees.
            (false, last) if (last - 360.0).abs() < 1e-6 => {
                layout.with_x_axis_max(360.0).with_x_tick_step(60.0)
            }
            (false, _) => layout.with_x_axis_max(last),
        };
        (plots, layout)
    }
}

fn drawn(curve: Curve) -> Plot {
    if let Some(marker) = curve.marker {
        let dots = ScatterPlot::new().with_data(curve.points).with_color(curve.colour);
        let dots = dots.with_marker(marker).with_size(5.0);
        return dots.with_legend(curve.name.unwrap_or_default()).into();
    }
    let line = LinePlot::new()
        .with_data(curve.points)
        .with_color(curve.colour)
        .with_stroke_width(curve.width);
    Plot::Line(match curve.name {
        Some(name) => line.with_legend(name),
        None => line,
    })
}

/// Writes the panels, `columns` in a row, to `target/charts/NAME.svg` and says so.
pub fn write(name: &str, title: &str, columns: usize, panels: Vec<Panel>) {
    let rows = panels.len().div_ceil(columns);
    let (plots, layouts): (Vec<_>, Vec<_>) = panels.into_iter().map(Panel::drawn).unzip();
    let scene = Figure::new(rows, columns)
        .with_title(title)
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(600.0, 420.0)
        .render();
    let path: PathBuf = ["target", "charts", &format!("{name}.svg")].iter().collect();
    let written = fs::create_dir_all("target/charts")
        .and_then(|()| fs::write(&path, SvgBackend.render_scene(&scene)));
    match written {
        Ok(()) => println!("\nchart: {}", path.display()),
        Err(error) => eprintln!("\nno chart: {}: {error}", path.display()),
    }
}
