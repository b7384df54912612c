//! A picture put together: what is drawn, how large, in which order.

use std::string::String;
use std::vec::Vec;

use super::bodies::{Body, bodies, guide_ends};
use super::boxes::Box2;
use super::forces::Load;
use super::gaps::{Gap, gaps};
use super::labels::Placed;
use super::member::LinkShape;
use super::options::Options;
use super::plan::Element;
use super::scene::Scene;
use super::sketch_error::SketchError;
use super::springs::{Coil, below, springs, wall_box};
use super::style::{HEADING, HEADING_LINE, HEIGHT, MARGIN, Palette, text_width, wrapped};
use super::svg::{Transform, View};
use super::symbols;
use super::traces::{self, Trace};

/// Everything that is to be drawn, on a page of its size.
pub(super) struct Picture<'s> {
    pub(super) scene: &'s Scene,
    pub(super) options: &'s Options,
    pub(super) palette: Palette,
    pub(super) colours: Vec<usize>,
    pub(super) view: View,
    pub(super) bodies: Vec<Body>,
    pub(super) traces: Vec<Trace>,
    pub(super) loads: Vec<Load>,
    pub(super) gaps: Vec<Gap>,
    pub(super) springs: Vec<Coil>,
    pub(super) supports: Vec<([f64; 2], f64)>,
    /// Where springs stand on walls, and which way these look.
    pub(super) walls: Vec<([f64; 2], f64)>,
    pub(super) arcs: Vec<([f64; 2], f64, bool)>,
    pub(super) labels: Vec<Placed>,
    pub(super) page: [f64; 2],
    /// The lines of the heading.
    pub(super) heading: Vec<String>,
    /// Where the scale stands.
    pub(super) line: f64,
}

impl<'s> Picture<'s> {
    /// Chooses the scale and places everything.
    pub(super) fn new(scene: &'s Scene, options: &'s Options) -> Result<Self, SketchError> {
        if scene.len() == 0 {
            return Err(SketchError::EmptyPath);
        }
        let mut picture = Self {
            scene,
            options,
            palette: options.theme.palette(),
            colours: colours(scene),
            view: View { scale: first_scale(scene), origin: [0.0; 2] },
            bodies: Vec::new(),
            traces: Vec::new(),
            loads: Vec::new(),
            gaps: Vec::new(),
            springs: Vec::new(),
            supports: Vec::new(),
            walls: Vec::new(),
            arcs: Vec::new(),
            labels: Vec::new(),
            page: [0.0; 2],
            heading: heading(options),
            line: 0.0,
        };
        picture.fit()?;
        picture.place_supports();
        picture.place_labels()?;
        picture.settle();
        Ok(picture)
    }

    pub(super) fn head(&self) -> f64 {
        HEADING_LINE * self.heading.len() as f64
    }

    /// The scale at which everything fits: what is measured in pixels does not grow with it, so it is
    /// found in a few steps.
    fn fit(&mut self) -> Result<(), SketchError> {
        // Largest forces and couples take a second line below.
        let below = BELOW + if self.options.loads.is_empty() { 0.0 } else { 20.0 };
        let room =
            [self.options.width - 2.0 * MARGIN, HEIGHT - MARGIN - FOOT - below - self.head()];
        for _ in 0..6 {
            self.make()?;
            let [width, height] = self.extent().size();
            // One point fits at any scale.
            if width.max(height) < 1.0 {
                break;
            }
            let ratio = (room[0] / width.max(1.0)).min(room[1] / height.max(1.0));
            if (ratio - 1.0).abs() < 1e-3 {
                break;
            }
            self.view.scale *= ratio.clamp(0.05, 20.0);
        }
        self.make()?;
        let low = self.extent().low;
        self.view.origin = [MARGIN - low[0], MARGIN + self.head() - low[1]];
        self.make()
    }

    fn make(&mut self) -> Result<(), SketchError> {
        let (scene, view) = (self.scene, self.view);
        self.bodies = bodies(scene, view);
        self.springs = springs(scene, view);
        let trace = |name: &String| {
            traces::point(scene.plan, name).map(|point| Trace::new(scene, view, point))
        };
        self.traces = self.options.traces.iter().map(trace).collect::<Result<_, _>>()?;
        self.gaps = gaps(scene, view);
        self.loads = Load::all(scene, view, &self.options.loads)?;
        Ok(())
    }

    /// The extent of the drawing without texts and supports, which have room in the margin.
    fn extent(&self) -> Box2 {
        let mut all = Box2::NOTHING;
        for frame in self.scene.frames() {
            for body in &self.bodies {
                all = all.with(Box2::around(body.lines(frame).into_iter().flatten()));
            }
            let points = 0..self.scene.plan.points.len();
            let points = points.filter_map(|point| self.scene.point(frame, point));
            all = all.with(Box2::around(points.map(|at| self.view.pixels(at))));
        }
        for (seat, ends) in self.rails() {
            all = all.with(Box2::around(ends.map(|x| seat.place([x, 0.0]))));
        }
        for (at, radius, swept) in self.cranks() {
            all = match swept {
                None => all.with(Box2::about(at, [radius; 2])),
                Some([from, to]) => {
                    let steps = (0..=24).map(|nth| from + (to - from) * f64::from(nth) / 24.0);
                    let spots = steps.map(|degrees| symbols::on_circle(at, radius, degrees));
                    all.with(Box2::around(spots))
                }
            };
        }
        // A still shows what its own pose misses alone.
        let gaps = self.gaps.iter().filter(|gap| !self.options.is_still || gap.fails[0]);
        let gaps = gaps.map(Gap::extent);
        let loads = self.loads.iter().map(Load::extent);
        let springs = self.springs.iter().map(Coil::extent);
        all = gaps.chain(loads).chain(springs).fold(all, Box2::with);
        if all.is_nothing() { Box2::about([0.0; 2], [60.0; 2]) } else { all }
    }

    /// The guides of the ground: where blocks move, or below them where a spring takes that place.
    pub(super) fn rails(&self) -> Vec<(Transform, [f64; 2])> {
        let mut rails: Vec<(Transform, [f64; 2])> = Vec::new();
        for &made in self.scene.plan.statements {
            let Element::Guide(guide, None) = made else { continue };
            let Some(pose) = self.scene.still(guide) else { continue };
            let seat = self.view.seat(pose);
            let ends = guide_ends(self.scene, self.view, guide);
            match below(&self.springs, seat) {
                Some((low, reach)) => {
                    let seat = Transform { at: seat.place([0.0, low]), ..seat };
                    join(&mut rails, seat, [ends[0].min(reach[0]), ends[1].max(reach[1])]);
                }
                None => rails.push((seat, ends)),
            }
        }
        rails
    }

    /// Each crank that an input turns against the ground: pivot, radius on the page, and the angles between
    /// which its pin moves, unless it makes full turns.
    pub(super) fn cranks(&self) -> Vec<([f64; 2], f64, Option<[f64; 2]>)> {
        let scene = self.scene;
        let of = |&made: &Element| {
            let (Element::Group(_, Some(pin)), Some(crank)) = (made, made.turned()) else {
                return None;
            };
            let pivot = crank.pivot().filter(|_| crank.shape == LinkShape::Bar)?;
            let link = crank.link;
            let pivot = scene.point(0, pivot).filter(|_| is_ground(scene, pivot))?;
            let frame = scene.frames().find(|&frame| scene.point(frame, pin).is_some())?;
            let at = scene.point(frame, pin)?;
            let radius = self.view.scale * (at[0] - pivot[0]).hypot(at[1] - pivot[1]);
            let seats = scene.frames().filter_map(|f| Some(self.view.seat(scene.link(f, link)?)));
            let seats: Vec<_> = seats.collect();
            let turned = super::svg::unrolled(&seats);
            let [from, to] = super::scene::range(turned.map(Some))?;
            let swept = (scene.len() > 1 && to - from < 359.0).then_some([from, to]);
            Some((self.view.pixels(pivot), radius, swept))
        };
        scene.plan.statements.iter().filter_map(of).collect()
    }

    /// Moves everything so that nothing is cut off, and sizes the page.
    fn settle(&mut self) {
        let texts = self.labels.iter().map(Placed::extent);
        let supports = self.supports.iter().map(|&(at, way)| symbols::support_box(at, way));
        let rails = self.rails().into_iter();
        let rails = rails.flat_map(|(seat, ends)| symbols::rail_boxes(seat, ends));
        let walls = self.walls.iter().map(|&(at, way)| wall_box(at, way));
        let shown = texts.chain(supports).chain(rails).chain(walls).fold(self.extent(), Box2::with);
        let content = self.extent();
        // Texts and supports may stand in the margin, but not at its end.
        let low = [0, 1].map(|axis| (content.low[axis] - MARGIN).min(shown.low[axis] - EDGE));
        let right = (content.high[0] + MARGIN).max(shown.high[0] + EDGE);
        self.shift([-low[0], self.head() - low[1]]);
        self.line = (content.high[1] + FOOT).max(shown.high[1] + EDGE + 8.0) - low[1] + self.head();
        // Bold letters are wider by a tenth.
        let heading = self.heading.iter().map(|line| 40.0 + 1.1 * HEADING * text_width(line));
        let least = heading.fold(MIN_WIDTH, f64::max);
        self.page = [(right - low[0]).max(least), self.line + BELOW];
    }

    fn shift(&mut self, by: [f64; 2]) {
        let moved = |at: [f64; 2]| [at[0] + by[0], at[1] + by[1]];
        self.view.origin = moved(self.view.origin);
        self.bodies = bodies(self.scene, self.view);
        self.springs = springs(self.scene, self.view);
        self.gaps = gaps(self.scene, self.view);
        self.traces
            .iter_mut()
            .for_each(|trace| *trace = Trace::new(self.scene, self.view, trace.point));
        self.loads.iter_mut().for_each(|load| load.shift(by));
        self.supports.iter_mut().for_each(|support| support.0 = moved(support.0));
        self.walls.iter_mut().for_each(|wall| wall.0 = moved(wall.0));
        self.arcs.iter_mut().for_each(|arc| arc.0 = moved(arc.0));
        self.labels.iter_mut().for_each(|label| label.shift(by));
    }
}

/// From what is drawn to the line of the scale, and from there to the end of the page.
const FOOT: f64 = 28.0;
const BELOW: f64 = 18.0;
/// The free space around texts.
const EDGE: f64 = 8.0;
/// The page is wide enough for the scale.
const MIN_WIDTH: f64 = 200.0;

/// One more rail, or a longer one where it lies in line with another.
fn join(rails: &mut Vec<(Transform, [f64; 2])>, seat: Transform, [start, end]: [f64; 2]) {
    let along = |other: &Transform| {
        let (sin, cos) = other.degrees.to_radians().sin_cos();
        let (x, y) = (seat.at[0] - other.at[0], seat.at[1] - other.at[1]);
        let is_in_line =
            (seat.degrees - other.degrees).abs() < 0.01 && (cos * y - sin * x).abs() < 0.5;
        is_in_line.then_some(cos * x + sin * y)
    };
    for (other, ends) in rails.iter_mut() {
        if let Some(x) = along(other) {
            *ends = [ends[0].min(x + start), ends[1].max(x + end)];
            return;
        }
    }
    rails.push((seat, [start, end]));
}

/// True if a point belongs to the ground.
pub(super) fn is_ground(scene: &Scene, point: usize) -> bool {
    scene.plan.statements.iter().any(|made| matches!(made, Element::Ground(own) if *own == point))
}

/// The points at which links turn against each other.
pub(super) fn revolutes(scene: &Scene) -> Vec<usize> {
    let statements = scene.plan.statements.iter();
    let turning = statements.flat_map(|made| {
        let pin = made.point().filter(|_| !matches!(made, Element::Ground(_) | Element::Point(..)));
        made.outer().into_iter().chain(pin)
    });
    let mut points: Vec<usize> = turning.collect();
    points.sort_unstable();
    points.dedup();
    points
}

/// A colour for every link: cylinders have one, the others take turns.
fn colours(scene: &Scene) -> Vec<usize> {
    let mut is_cylinder: Vec<bool> = scene.plan.links.iter().map(|_| false).collect();
    for (_, member) in scene.plan.statements.iter().flat_map(|made| made.members()) {
        is_cylinder[member.link] = member.shape == LinkShape::Cylinder;
    }
    let turns: &[usize] =
        if is_cylinder.contains(&true) { &[0, 1, 2, 3, 5] } else { &[0, 1, 2, 3, 4, 5] };
    let mut next = turns.iter().cycle().copied();
    is_cylinder
        .into_iter()
        .map(|is_cylinder| if is_cylinder { CYLINDER } else { next.next().unwrap_or_default() })
        .collect()
}

/// Amber.
const CYLINDER: usize = 4;

/// The title in lines that fit the page.
fn heading(options: &Options) -> Vec<String> {
    let title = options.title.as_deref().unwrap_or_default();
    wrapped(title, 1.1 * HEADING, options.width - 40.0)
}

/// A scale by which the points fill the page.
fn first_scale(scene: &Scene) -> f64 {
    let points = scene.frames().flat_map(|frame| {
        (0..scene.plan.points.len()).filter_map(move |point| scene.point(frame, point))
    });
    let [width, height] = Box2::around(points).size();
    let size = width.max(height);
    if size.is_finite() && size > 0.0 { 500.0 / size } else { 500.0 }
}
