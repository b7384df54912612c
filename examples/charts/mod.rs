//! The charts that the examples draw: curves over an input or over time, paths in the plane, and
//! mechanisms drawn as lines. Nothing about one mechanism belongs here.

use std::fs;
use std::path::PathBuf;

use kuva::prelude::*;

/// Blue, orange, green, purple, sky, vermilion: told apart without colour vision too (Okabe and
/// Ito).
pub(crate) const COLOURS: [&str; 6] =
    ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"];
pub(crate) const GREY: &str = "#9aa0a6";
pub(crate) const BLACK: &str = "#222222";

/// A line through points.
pub(crate) struct Curve {
    points: Vec<(f64, f64)>,
    name: Option<String>,
    colour: String,
    width: f64,
    dashed: bool,
}

impl Curve {
    /// A curve with a name in the legend.
    pub(crate) fn named(name: &str, colour: &str, points: Vec<(f64, f64)>) -> Self {
        let name = Some(name.to_owned());
        Self { points, name, colour: colour.to_owned(), width: 2.0, dashed: false }
    }

    /// Links: a line through joints, not in the legend.
    pub(crate) fn links(colour: &str, joints: &[[f64; 2]]) -> Self {
        let points = joints.iter().map(|[x, y]| (*x, *y)).collect();
        Self { points, name: None, colour: colour.to_owned(), width: 1.5, dashed: false }
    }

    #[allow(dead_code, reason = "some examples draw solid curves only")]
    pub(crate) fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }

    fn plot(self) -> Plot {
        let mut line = LinePlot::new()
            .with_data(self.points)
            .with_color(self.colour)
            .with_stroke_width(self.width);
        if let Some(name) = self.name {
            line = line.with_legend(name);
        }
        Plot::Line(if self.dashed { line.with_dashed() } else { line })
    }
}

/// One system of axes.
pub(crate) struct Panel {
    title: String,
    axes: [String; 2],
    curves: Vec<Curve>,
    in_the_plane: bool,
}

impl Panel {
    pub(crate) fn new(title: &str, axes: [&str; 2], curves: Vec<Curve>) -> Self {
        Self {
            title: title.to_owned(),
            axes: axes.map(str::to_owned),
            curves,
            in_the_plane: false,
        }
    }

    /// Both axes are lengths and drawn to one scale.
    #[allow(dead_code, reason = "some examples draw no paths")]
    pub(crate) fn in_the_plane(mut self) -> Self {
        self.in_the_plane = true;
        self
    }

    fn layout(&self, plots: &[Plot]) -> Layout {
        let legend = self.curves.iter().filter(|curve| curve.name.is_some()).count() > 1;
        let position = if legend { LegendPosition::OutsideBottomCenter } else { LegendPosition::InsideTopRight };
        let layout = Layout::auto_from_plots(plots)
            .with_title(self.title.as_str())
            .with_x_label(self.axes[0].as_str())
            .with_y_label(self.axes[1].as_str())
            .with_legend_position(position)
            .with_title_size(16)
            .with_label_size(13)
            .with_tick_size(11);
        if self.in_the_plane { layout.with_equal_aspect() } else { layout }
    }
}

/// Writes the panels, `columns` in a row, to `target/charts/NAME.svg` and says so.
pub(crate) fn write(name: &str, title: &str, columns: usize, panels: Vec<Panel>) {
    let rows = panels.len().div_ceil(columns);
    let (mut plots, mut layouts) = (Vec::new(), Vec::new());
    for mut panel in panels {
        let curves: Vec<Plot> = {
            let layout_curves = std::mem::take(&mut panel.curves);
            layout_curves.into_iter().map(Curve::plot).collect()
        };
        layouts.push(panel.layout(&curves));
        plots.push(curves);
    }
    let scene = Figure::new(rows, columns)
        .with_title(title)
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(560.0, 400.0)
        .render();
    let path: PathBuf = ["target", "charts", &format!("{name}.svg")].iter().collect();
    let written = fs::create_dir_all("target/charts")
        .and_then(|()| fs::write(&path, SvgBackend.render_scene(&scene)));
    match written {
        Ok(()) => println!("\nchart: {}", path.display()),
        Err(error) => eprintln!("\nno chart: {}: {error}", path.display()),
    }
}
