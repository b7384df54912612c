//! The text of a picture whose parts all have their places.

use std::format;
use std::string::String;

use super::bodies::Body;
use super::gaps::messages;
use super::labels;
use super::picture::{Picture, is_ground};

use super::style::{FONT, HEADING, HEADING_LINE, JOINT, SMALL, text_width, wrapped};
use super::svg::{Timing, escaped, pair, rigid, short};
use super::{forces, springs, symbols, traces};

impl Picture<'_> {
    pub(super) fn colour(&self, link: Option<usize>) -> &'static str {
        match link {
            Some(link) => self.palette.links[self.colours[link]],
            None => self.palette.ink,
        }
    }

    /// The text of the picture; of the first pose alone without a timing.
    pub(super) fn svg(&self, is_film: bool) -> String {
        let timing = (is_film && self.scene.len() > 1)
            .then_some(Timing { seconds: self.options.seconds, frames: self.scene.len() });
        let scale = symbols::scale_bar(self.view.scale, self.page[0], self.options.unit);
        let (footers, below) = self.footers(self.line, &scale);
        let [width, height] = [self.page[0], self.page[1] + below].map(short);
        let palette = &self.palette;
        let mut svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img"><title>{}</title>"#,
            escaped(&self.title())
        );
        if !self.scene.plan.docs.is_empty() {
            svg += &format!("<desc>{}</desc>", escaped(self.scene.plan.docs));
        }
        svg += &format!(r#"<rect width="{width}" height="{height}" fill="{}"/>"#, palette.paper);
        for (nth, line) in self.heading.iter().enumerate() {
            svg += &format!(
                r#"<text x="20" y="{}" font-family="{FONT}" font-size="{HEADING}" font-weight="bold" fill="{}">{}</text>"#,
                30 + HEADING_LINE as usize * nth,
                palette.ink,
                escaped(line)
            );
        }
        svg += &self.standing();
        svg += &self.behind();
        svg += r#"<g fill="none" stroke-linecap="round" stroke-linejoin="round">"#;
        for (spring, coil) in self.scene.plan.springs.iter().zip(&self.springs) {
            let [from, to] = spring.ends.map(|end| self.scene.plan.points[end]);
            svg += &coil.drawn(&escaped(&format!("{from} {to}")), timing, palette);
        }
        for (nth, body) in self.bodies.iter().enumerate() {
            svg += &self.body(nth, body, timing);
        }
        svg += "</g>";
        svg += &self.ground_joints();
        let gaps = self.gaps.iter();
        svg.extend(gaps.map(|gap| gap.drawn(timing, |link| self.colour(Some(link)), palette)));
        svg.extend(
            self.loads.iter().map(|load| {
                load.drawn(&escaped(self.scene.plan.points[load.point]), timing, palette)
            }),
        );
        svg += &labels::drawn(&self.labels, timing, palette);
        svg += &footers;
        svg += "</svg>\n";
        self.options.theme.applied_to(&svg)
    }

    pub(super) fn title(&self) -> String {
        self.options.title.clone().unwrap_or_else(|| spaced(self.scene.plan.name))
    }

    /// Supports, rails, circles and arrows of cranks.
    fn standing(&self) -> String {
        let palette = &self.palette;
        let supports = self.supports.iter();
        let mut svg: String =
            supports.map(|&(at, way)| symbols::support(at, way, palette)).collect();
        let walls = self.walls.iter();
        svg.extend(walls.map(|&(at, way)| springs::wall(at, way, palette)));
        svg.extend(self.rails().into_iter().map(|(seat, ends)| symbols::rail(seat, ends, palette)));
        for (at, radius, swept) in self.cranks() {
            svg += &symbols::crank_circle(at, radius, swept, palette.quiet);
        }
        for &(at, middle, is_clockwise) in &self.arcs {
            svg += &symbols::arc_arrow(at, middle, is_clockwise, palette.ink);
        }
        svg
    }

    /// Faint poses and traces.
    fn behind(&self) -> String {
        let ghosts = traces::ghosts(self.scene, &self.bodies, self.options.poses);
        let mut svg = String::new();
        for (link, path) in ghosts {
            svg += &format!(
                r#"<path d="{path}" fill="none" stroke="{}" stroke-width="1.6" stroke-linejoin="round" opacity=".28"/>"#,
                self.colour(link)
            );
        }
        let traces = self.traces.iter();
        svg.extend(traces.map(|trace| {
            let name = escaped(self.scene.plan.points[trace.point]);
            trace.drawn(&name, self.colour(trace.link(self.scene)))
        }));
        svg
    }

    fn body(&self, nth: usize, body: &Body, timing: Option<Timing>) -> String {
        let colour = self.colour(body.link);
        let mut content: String =
            body.shapes.iter().map(|shape| shape.draw(colour, &self.palette)).collect();
        for &(point, at) in &body.carries {
            if self.is_shown_on(nth, point) {
                content += &self.joint(point, at);
            }
        }
        let name = match body.link {
            Some(link) => format!(r#" data-link="{}""#, escaped(self.scene.plan.links[link])),
            None => String::new(),
        };
        rigid(&body.seats, timing, &name, &content)
    }

    /// A joint's circle belongs to the body there that is drawn last; where that one is missing in
    /// some pose in which the joint is not, also to the first.
    fn is_shown_on(&self, nth: usize, point: usize) -> bool {
        if is_ground(self.scene, point) {
            return false;
        }
        let has = |body: &Body| body.carries.iter().any(|&(own, _)| own == point);
        let last = self.bodies.iter().rposition(has);
        let first = self.bodies.iter().position(has);
        let goes = last.is_some_and(|last| {
            let seats = self.bodies[last].seats.iter().enumerate();
            let mut gone = seats.filter(|(_, seat)| seat.is_none());
            gone.any(|(frame, _)| self.scene.point(frame, point).is_some())
        });
        last == Some(nth) || (goes && first == Some(nth))
    }

    /// A circle where links turn, a dot elsewhere.
    fn joint(&self, point: usize, at: [f64; 2]) -> String {
        let (paper, ink) = (self.palette.paper, self.palette.ink);
        let at = pair(at);
        let (x, y) = at.split_once(' ').unwrap_or_default();
        let is_traced = self.traces.iter().any(|trace| trace.point == point);
        let name = escaped(self.scene.plan.points[point]);
        match self.pivots().contains(&point) {
            true => format!(
                r#"<circle data-point="{name}" cx="{x}" cy="{y}" r="{JOINT}" fill="{paper}" stroke="{ink}" stroke-width="1.8"/>"#
            ),
            false => {
                let radius = if is_traced { "4" } else { "2.6" };
                format!(
                    r#"<circle data-point="{name}" cx="{x}" cy="{y}" r="{radius}" fill="{ink}"/>"#
                )
            }
        }
    }

    fn ground_joints(&self) -> String {
        let points = 0..self.scene.plan.points.len();
        let ground = points.filter(|&point| is_ground(self.scene, point));
        ground
            .filter_map(|point| {
                let at = self.scene.point(0, point)?;
                Some(self.joint(point, self.view.pixels(at)))
            })
            .collect()
    }

    /// The scale, and what cannot be assembled behind it or below; how much longer the page is for
    /// that.
    fn footers(&self, line: f64, scale: &(f64, String)) -> (String, f64) {
        let palette = &self.palette;
        let (mut svg, mut x) = match self.options.has_scale {
            true => symbols::drawn_scale(scale, line, palette),
            false => (String::new(), 0.0),
        };
        let (mut y, mut below) = (line, 0.0);
        x += 28.0;
        let messages = messages(self.scene, self.options.unit).into_iter();
        let messages = messages.map(|message| (message, palette.accent));
        let legend = forces::legend(&self.loads, self.scene.plan.points).into_iter();
        let all = self.loads.iter().map(|load| load.colour(palette));
        let colour = all.reduce(|a, b| if a == b { a } else { palette.accent });
        let legend = legend.map(|line| (line, colour.unwrap_or(palette.accent)));
        let room = self.page[0] - 40.0;
        let lines = messages.chain(legend).flat_map(|(text, colour)| {
            wrapped(&text, SMALL, room).into_iter().map(move |line| (line, colour))
        });
        for (text, colour) in lines {
            let width = SMALL * text_width(&text);
            if x + width > self.page[0] - 20.0 {
                (x, y, below) = (20.0, y + 20.0, below + 20.0);
            }
            svg += &format!(
                r#"<text x="{}" y="{}" font-family="{FONT}" font-size="{SMALL}" fill="{}">{}</text>"#,
                short(x),
                short(y + 4.0),
                colour,
                escaped(&text)
            );
            x += width + 24.0;
        }
        (svg, below)
    }
}

/// `FlyingShear` as a heading.
pub(super) fn spaced(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !text.is_empty() {
            text.push(' ');
            text.extend(letter.to_lowercase());
        } else {
            text.push(letter);
        }
    }
    text
}
