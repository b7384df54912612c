//! The charts that the examples draw: curves over an input or over time, and paths in the plane;
//! and numbers as their tables have them.
//! Nothing about one mechanism belongs here; mechanisms are drawn by `linkage_core::sketch`.

mod axis;
mod page;

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use axis::Axis;

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

/// A number as a table has it with so many decimals, and no minus before a zero.
pub fn rounded(value: f64, decimals: i32) -> f64 {
    let power = 10_f64.powi(decimals);
    // Adding zero takes the sign off a zero.
    (value * power).round() / power + 0.0
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
        // Textbook forms.
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

    /// The number of curve names on a line below a panel so wide, and the number of such lines.
    fn legend(&self, width: f64) -> (usize, usize) {
        let names = self.curves.iter().filter_map(|curve| curve.name.as_deref());
        let letters = names.clone().map(|name| name.chars().count()).max().unwrap_or_default();
        let columns = ((width - 110.0) / (44.0 + 7.6 * letters as f64)).floor().max(1.0) as usize;
        (columns, names.count().div_ceil(columns))
    }

    fn drawn(self, width: f64) -> (Vec<Plot>, Layout) {
        let columns = self.legend(width).0;
        let mut curves = self.curves;
        if let [only] = &mut curves[..] {
            // The title names it.
            only.name = None;
        }
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let [x, y] = [
            Axis::over(points().map(|point| point.0), &self.axes[0]),
            Axis::over(points().map(|point| point.1), &self.axes[1]),
        ];
        let is_angle = axis::is_angle(&self.axes[1]);
        let plots: Vec<Plot> =
            curves.into_iter().flat_map(|curve| drawn(curve, is_angle)).collect();
        let layout = Layout::auto_from_plots(&plots)
            .with_title(self.title)
            .with_x_label(self.axes[0].as_str())
            .with_y_label(self.axes[1].as_str())
            .with_legend_position(LegendPosition::OutsideBottomColumns)
            .with_legend_box(false)
            .with_legend_col_limit(columns)
            .with_title_size(15)
            .with_label_size(13)
            .with_tick_size(12)
            .with_body_size(13)
            .with_tick_format(TickFormat::Custom(Arc::new(axis::written)));
        let layout = match (self.in_the_plane, self.is_logarithmic) {
            (_, true) => layout.with_log_scale(),
            (true, _) => layout.with_equal_aspect(),
            _ => layout
                .with_x_axis_min(x.ends[0])
                .with_x_axis_max(x.ends[1])
                .with_x_tick_step(x.step)
                .with_y_axis_min(y.round()[0])
                .with_y_axis_max(y.round()[1])
                .with_y_tick_step(y.step),
        };
        (plots, layout)
    }
}

/// A curve as plots: an angle that leaves a turn at one end and comes back at the other is drawn in
/// pieces, since nothing is between them.
fn drawn(curve: Curve, is_angle: bool) -> Vec<Plot> {
    if let Some(marker) = curve.marker {
        let dots = ScatterPlot::new().with_data(curve.points).with_color(curve.colour);
        let dots = dots.with_marker(marker).with_size(5.0);
        return vec![dots.with_legend(curve.name.unwrap_or_default()).into()];
    }
    let pieces = if is_angle { axis::pieces(&curve.points) } else { vec![&curve.points[..]] };
    let mut name = curve.name;
    let line = |points: &[(f64, f64)]| {
        let line = LinePlot::new()
            .with_data(points.to_vec())
            .with_color(curve.colour.clone())
            .with_stroke_width(curve.width);
        Plot::Line(match name.take() {
            Some(name) => line.with_legend(name),
            None => line,
        })
    };
    pieces.into_iter().map(line).collect()
}

/// The panels as one picture, `columns` in a row, for light pages and dark ones.
fn text(title: &str, columns: usize, panels: Vec<Panel>) -> String {
    let rows = panels.len().div_ceil(columns);
    // Wide enough for numbers and words of a page, and the whole no wider than most windows.
    let width = (1260.0 / columns as f64).clamp(420.0, 560.0);
    let lines = panels.iter().map(|panel| panel.legend(width).1).max().unwrap_or_default();
    let (plots, layouts): (Vec<_>, Vec<_>) =
        panels.into_iter().map(|panel| panel.drawn(width)).unzip();
    let scene = Figure::new(rows, columns)
        .with_title(title)
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(width, 0.6 * width + 64.0 + 20.0 * lines as f64)
        .render();
    page::fitted(&SvgBackend.render_scene(&scene))
}

/// Writes the panels, `columns` in a row, to `target/charts/NAME.svg` and says so.
pub fn write(name: &str, title: &str, columns: usize, panels: Vec<Panel>) {
    let text = text(title, columns, panels);
    let path: PathBuf = ["target", "charts", &format!("{name}.svg")].iter().collect();
    let written = fs::create_dir_all("target/charts").and_then(|()| fs::write(&path, text));
    match written {
        Ok(()) => println!("\nchart: {}", path.display()),
        Err(error) => eprintln!("\nno chart: {}: {error}", path.display()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panels() -> Vec<Panel> {
        let turn = |k: f64| (k, 200.0 * (k / 57.3).sin() + 100.0);
        let points: Vec<(f64, f64)> = (0..=36).map(|k| turn(10.0 * f64::from(k))).collect();
        let wrapped = points.iter().map(|&(x, y)| (x, if y > 180.0 { y - 360.0 } else { y }));
        let named = |name, points| Curve::named(name, COLOURS[0], points);
        vec![
            Panel::over("One", ["crank in deg", "x in mm"], vec![Curve::line(COLOURS[0], &points)]),
            Panel::over(
                "Several",
                ["crank in deg", "angle in deg"],
                vec![
                    named("a name as long as that of a rod", wrapped.collect()),
                    named("other", points),
                ],
            ),
        ]
    }

    #[test]
    fn a_chart_fits_its_page_and_is_light_and_dark() {
        let text = text("Title", 2, panels());
        let (head, rest) = text.split_once('>').unwrap();
        let number = |name: &str| head.split_once(name).unwrap().1.split('"').next().unwrap();
        let size = format!("viewBox=\"0 0 {} {}\"", number(" width=\""), number(" height=\""));
        assert!(head.contains(&size), "{head}");
        assert!(rest.contains("prefers-color-scheme:dark"));
        // Every colour has its dark one.
        for part in rest.split("</style>").nth(1).unwrap().split("fill=\"").skip(1) {
            let colour = part.split('"').next().unwrap();
            let is_known = colour == "none" || rest.contains(&format!("[fill=\"{colour}\"]"));
            assert!(is_known, "{colour}");
        }
        for part in rest.split("</style>").nth(1).unwrap().split("stroke=\"").skip(1) {
            let colour = part.split('"').next().unwrap();
            let is_known = colour == "none" || rest.contains(&format!("[stroke=\"{colour}\"]"));
            assert!(is_known, "{colour}");
        }
    }

    /// Names of curves stand below: panels beside each other are equally wide.
    #[test]
    fn a_legend_does_not_squeeze_its_panel() {
        let widths = panels().into_iter().map(|panel| {
            let text = text("", 1, vec![panel]);
            let lines = text.split("<line ").skip(1).filter_map(|line| {
                let of =
                    |name: &str| line.split_once(name)?.1.split('"').next()?.parse::<f64>().ok();
                Some(of("x2=\"")? - of("x1=\"")?)
            });
            lines.fold(0.0, f64::max)
        });
        let widths: Vec<f64> = widths.collect();
        // Numbers at the ticks may be of other lengths.
        assert!(widths[0] > 430.0 && (widths[0] - widths[1]).abs() < 12.0, "{widths:?}");
    }

    #[test]
    fn an_angle_that_wraps_is_drawn_in_pieces() {
        let count = |panel: Panel| panel.drawn(560.0).0.len();
        let [one, several] = panels().try_into().ok().unwrap();
        assert_eq!((count(one), count(several)), (1, 4));
    }

    #[test]
    fn no_zero_of_a_table_has_a_minus() {
        assert_eq!(
            format!("{:.3} {:.3}", rounded(-0.0004, 3), rounded(-0.0006, 3)),
            "0.000 -0.001"
        );
    }
}
