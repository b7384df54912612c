//! Annotations on a sketch: axes, dimensions, angles, names, the other mode.

use std::fmt::Write;

use linkage_core::sketch::{LinkPose, Palette, Sketch, SketchError, Theme, View};

type Spot = [f64; 2];

/// A sketch with something written over it.
pub struct Figure {
    theme: Theme,
    palette: Palette,
    view: View,
    /// The sketch's own drawing, and its size.
    sketch: String,
    size: Spot,
    /// Below the sketch's own drawing, and above it.
    below: String,
    above: String,
    /// The margins that the drawing needs beyond the sketch: left, top, right, bottom.
    more: [f64; 4],
    statement: &'static str,
}

const FONT: &str = "Helvetica Neue,Arial,Liberation Sans,sans-serif";

impl Figure {
    /// The sketch, so wide at most, with the statement beneath.
    ///
    /// # Errors
    /// None: everything named is there.
    pub fn new(
        sketch: Sketch,
        theme: Theme,
        width: f64,
        statement: &'static str,
    ) -> Result<Self, SketchError> {
        let sketch = sketch.unlabelled().without_scale().theme(theme).width(width);
        let (view, text) = (sketch.view()?, sketch.to_svg()?);
        let number = |name: &str| {
            let value = text.split_once(name).and_then(|(_, behind)| behind.split('"').next());
            value.and_then(|value| value.parse().ok()).unwrap_or(0.0)
        };
        let size = [number(" width=\""), number(" height=\"")];
        // The elements after the paper, which is the first rectangle.
        let inside = text.split_once("<rect").and_then(|(_, behind)| behind.split_once("/>"));
        let inside = inside.map_or("", |(_, behind)| behind.trim_end().trim_end_matches("</svg>"));
        let (below, above) = (String::new(), String::new());
        let sketch = inside.to_string();
        Ok(Self {
            theme,
            palette: theme.palette(),
            view,
            sketch,
            size,
            below,
            above,
            more: [0.0; 4],
            statement,
        })
    }

    /// Room beside the sketch: left, top, right, bottom.
    pub const fn room(mut self, more: [f64; 4]) -> Self {
        self.more = more;
        self
    }

    fn line(&mut self, path: &str, width: f64) {
        let ink = self.palette.ink;
        let _ = write!(
            self.above,
            r#"<path d="{path}" fill="none" stroke="{ink}" stroke-width="{width}"/>"#
        );
    }

    /// A head at the end of a line that comes from a direction.
    fn head(&mut self, tip: Spot, from: Spot, colour: &str) {
        let (dx, dy) = (tip[0] - from[0], tip[1] - from[1]);
        let length = dx.hypot(dy).max(1e-9);
        let (ux, uy) = (dx / length, dy / length);
        let corner =
            |side: f64| [tip[0] - 9.0 * ux - side * 3.0 * uy, tip[1] - 9.0 * uy + side * 3.0 * ux];
        let ([ax, ay], [bx, by]) = (corner(1.0), corner(-1.0));
        let [x, y] = tip;
        let _ = write!(
            self.above,
            r#"<path d="M{x:.1} {y:.1}L{ax:.1} {ay:.1}L{bx:.1} {by:.1}Z" fill="{colour}"/>"#
        );
    }

    fn words(&mut self, [x, y]: Spot, text: &str, colour: &str, style: &str) {
        let paper = self.palette.paper;
        let y = y + 4.5;
        let _ = write!(
            self.above,
            r#"<text x="{x:.1}" y="{y:.1}" {style} font-size="13" text-anchor="middle" fill="{colour}" stroke="{paper}" stroke-width="3" stroke-linejoin="round" paint-order="stroke">{text}</text>"#
        );
    }

    /// A name or a dimension beside a place.
    pub fn name(mut self, at: Spot, [dx, dy]: Spot, text: &str) -> Self {
        let ([x, y], ink) = (self.view.pixels(at), self.palette.ink);
        self.words([x + dx, y + dy], text, ink, &italic());
        self
    }

    /// The name of a link, in its colour.
    pub fn link(mut self, nth: usize, at: Spot, [dx, dy]: Spot, text: &str) -> Self {
        let ([x, y], colour) = (self.view.pixels(at), self.palette.links[nth]);
        self.words([x + dx, y + dy], text, colour, &italic());
        self
    }

    /// Words of the language.
    pub fn code(mut self, at: Spot, [dx, dy]: Spot, text: &str) -> Self {
        let ([x, y], ink) = (self.view.pixels(at), self.palette.ink);
        self.words([x + dx, y + dy], text, ink, r#"font-family="monospace""#);
        self
    }

    /// A distance, measured so far beside the line from one place to the other.
    pub fn distance(mut self, ends: [Spot; 2], beside: f64, text: &str, [dx, dy]: Spot) -> Self {
        let [a, b] = ends.map(|end| self.view.pixels(end));
        let (ux, uy) = (b[0] - a[0], b[1] - a[1]);
        let length = ux.hypot(uy).max(1e-9);
        let (ux, uy) = (ux / length, uy / length);
        let aside = |[x, y]: Spot, by: f64| [x + by * uy, y - by * ux];
        let reach = beside + 6.0 * beside.signum();
        let start = 7.0 * beside.signum();
        for end in [a, b] {
            let ([x, y], [z, w]) = (aside(end, start), aside(end, reach));
            self.line(&format!("M{x:.1} {y:.1}L{z:.1} {w:.1}"), 0.8);
        }
        let (a, b) = (aside(a, beside), aside(b, beside));
        self.line(&format!("M{:.1} {:.1}L{:.1} {:.1}", a[0], a[1], b[0], b[1]), 0.8);
        let ink = self.palette.ink;
        if length > 24.0 {
            self.head(a, b, ink);
            self.head(b, a, ink);
        }
        let middle = [0.5 * (a[0] + b[0]) + dx, 0.5 * (a[1] + b[1]) + dy];
        self.words(middle, text, ink, &italic());
        self
    }

    /// The axes of a link's frame.
    pub fn axes(mut self, pose: LinkPose) -> Self {
        let LinkPose { origin, direction } = pose;
        let at = self.view.pixels([origin.x, origin.y]);
        let ink = self.palette.ink;
        for (text, (cos, sin)) in
            [("x", (direction.cos, direction.sin)), ("y", (-direction.sin, direction.cos))]
        {
            let along = |by: f64| [at[0] + by * cos, at[1] - by * sin];
            let (start, tip) = (along(5.0), along(40.0));
            self.line(
                &format!("M{:.1} {:.1}L{:.1} {:.1}", start[0], start[1], tip[0], tip[1]),
                1.6,
            );
            self.head(tip, at, ink);
            let aside = along(36.0);
            // Beside the arrow, outside the corner of both.
            let sign = if text == "x" { 11.0 } else { -11.0 };
            let place = [aside[0] + sign * sin, aside[1] + sign * cos];
            self.words(place, text, ink, &italic());
        }
        self
    }

    /// An angle at a place, from one direction to another, in degrees, counter-clockwise.
    pub fn angle(mut self, at: Spot, [from, to]: [f64; 2], radius: f64, text: &str) -> Self {
        let [x, y] = self.view.pixels(at);
        let on = |degrees: f64, radius: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [x + radius * cos, y - radius * sin]
        };
        let (start, end) = (on(from, radius), on(to, radius));
        let (sweep, large) = (u8::from(to < from), u8::from((to - from).abs() > 180.0));
        self.line(
            &format!(
                "M{:.1} {:.1}A{radius} {radius} 0 {large} {sweep} {:.1} {:.1}",
                start[0], start[1], end[0], end[1]
            ),
            0.8,
        );
        let ink = self.palette.ink;
        // The head is as long as this much of the arc.
        let back = 8.0 / radius.max(1.0) * 57.3 * (to - from).signum();
        self.head(end, on(to - back, radius), ink);
        let half = 3.6 * text.chars().count() as f64;
        let middle = 0.5 * (from + to);
        let out = radius + 10.0 + half * middle.to_radians().cos().abs();
        self.words(on(middle, out), text, ink, &italic());
        self
    }

    /// A thin broken line, of which angles and distances are measured.
    pub fn axis(mut self, ends: [Spot; 2]) -> Self {
        let ([[x, y], [z, w]], quiet) = (ends.map(|end| self.view.pixels(end)), self.palette.quiet);
        let _ = write!(
            self.below,
            r#"<path d="M{x:.1} {y:.1}L{z:.1} {w:.1}" fill="none" stroke="{quiet}" stroke-width="1" stroke-dasharray="9 3 2 3"/>"#
        );
        self
    }

    /// A thin arrow between places, which tells a direction.
    pub fn arrow(self, ends: [Spot; 2]) -> Self {
        let quiet = self.palette.quiet;
        self.directed(ends, quiet, "1.2")
    }

    /// The line of a guide, with the way in which slides count.
    pub fn rail(self, ends: [Spot; 2]) -> Self {
        let ink = self.palette.ink;
        self.directed(ends, ink, "1.6")
    }

    fn directed(mut self, ends: [Spot; 2], colour: &str, width: &str) -> Self {
        let [a, b] = ends.map(|end| self.view.pixels(end));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy).max(1e-9);
        let tip = [b[0] - 6.0 * dx / length, b[1] - 6.0 * dy / length];
        let _ = write!(
            self.below,
            r#"<path d="M{:.1} {:.1}L{:.1} {:.1}" fill="none" stroke="{colour}" stroke-width="{width}"/>"#,
            a[0], a[1], tip[0], tip[1]
        );
        self.head(tip, a, colour);
        self
    }

    /// A link in the other mode.
    pub fn other(mut self, nth: usize, places: &[Spot]) -> Self {
        let places: Vec<String> = places
            .iter()
            .map(|&place| {
                let [x, y] = self.view.pixels(place);
                format!("{x:.1} {y:.1}")
            })
            .collect();
        let colour = self.palette.links[nth];
        let _ = write!(
            self.below,
            r#"<path d="M{}" fill="none" stroke="{colour}" stroke-width="5" stroke-linecap="round" stroke-dasharray=".1 9" opacity=".55"/>"#,
            places.join("L")
        );
        self
    }

    /// A joint in the other mode, or one that nothing draws.
    pub fn joint(mut self, at: Spot) -> Self {
        let ([x, y], Palette { paper, ink, .. }) = (self.view.pixels(at), self.palette);
        let _ = write!(
            self.above,
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="4.6" fill="{paper}" stroke="{ink}" stroke-width="1.8" opacity=".7"/>"#
        );
        self
    }

    /// The text of the figure; without empty lines, as documentation needs it.
    pub fn svg(self) -> String {
        let [left, top, right, bottom] = self.more;
        let Palette { paper, ink, .. } = self.palette;
        let wanted = 28.0 + 7.9 * self.statement.chars().count() as f64;
        let width = (self.size[0] + left + right).max(wanted).ceil();
        let height = (self.size[1] + top + bottom + 30.0).ceil();
        let shift = left + 0.5 * (width - self.size[0] - left - right).max(0.0);
        let statement =
            self.statement.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let figure = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img"><title>{statement}</title><rect width="{width}" height="{height}" fill="{paper}"/><g transform="translate({shift} {top})">{}{}{}</g><text x="14" y="{}" font-family="monospace" font-size="13" fill="{ink}">{statement}</text></svg>
"#,
            self.below,
            self.sketch,
            self.above,
            height - 16.0
        );
        self.theme.applied_to(&figure)
    }
}

fn italic() -> String {
    format!(r#"font-family="{FONT}" font-style="italic""#)
}
