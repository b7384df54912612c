//! A picture put together: what is drawn, how large, in which order.

use std::string::{String, ToString};
use std::vec::Vec;

use super::bodies::{Body, bodies, guide_ends};
use super::boxes::Box2;
use super::error::SketchError;
use super::gaps::{Gap, gaps};
use super::labels::{self, Label, Obstacles, Placed};
use super::plan::Made;
use super::scene::{Scene, Spot};
use super::style::{HEIGHT, JOINT, MARGIN, Palette, Theme, Unit, WIDTH};
use super::svg::View;
use super::symbols::{self, WAYS};
use super::traces::{self, Force, Trace};

/// What the user asks of a picture.
#[derive(Clone, Debug)]
pub(super) struct Options {
    pub traces: Vec<String>,
    /// None for those that there is room for.
    pub labels: Option<Vec<String>>,
    pub theme: Theme,
    pub width: f64,
    pub unit: Option<Unit>,
    pub title: Option<String>,
    pub forces: Vec<(String, Vec<[f64; 2]>)>,
    pub has_scale: bool,
    pub poses: usize,
    pub seconds: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            traces: Vec::new(),
            labels: None,
            theme: Theme::Light,
            width: WIDTH,
            unit: None,
            title: None,
            forces: Vec::new(),
            has_scale: true,
            poses: 1,
            seconds: 4.0,
        }
    }
}

/// Everything that is to be drawn, on a page of its size.
pub(super) struct Picture<'s> {
    pub(super) scene: &'s Scene,
    pub(super) options: &'s Options,
    pub(super) palette: Palette,
    pub(super) colours: Vec<usize>,
    pub(super) view: View,
    pub(super) bodies: Vec<Body>,
    pub(super) traces: Vec<Trace>,
    pub(super) forces: Vec<Force>,
    pub(super) gaps: Vec<Gap>,
    pub(super) supports: Vec<(Spot, f64)>,
    pub(super) arcs: Vec<(Spot, f64, bool)>,
    pub(super) labels: Vec<Placed>,
    pub(super) page: Spot,
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
            forces: Vec::new(),
            gaps: Vec::new(),
            supports: Vec::new(),
            arcs: Vec::new(),
            labels: Vec::new(),
            page: [0.0; 2],
            line: 0.0,
        };
        picture.fit()?;
        picture.place_supports();
        picture.place_labels()?;
        picture.settle();
        Ok(picture)
    }

    pub(super) fn head(&self) -> f64 {
        if self.options.title.is_some() { 22.0 } else { 0.0 }
    }

    /// The scale at which everything fits: what is measured in pixels does not grow with it, so it is
    /// found in a few steps.
    fn fit(&mut self) -> Result<(), SketchError> {
        let room =
            [self.options.width - 2.0 * MARGIN, HEIGHT - MARGIN - FOOT - BELOW - self.head()];
        for _ in 0..6 {
            self.make()?;
            let [width, height] = self.extent().size();
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
        let trace = |name: &String| {
            traces::point(scene.plan, name).map(|point| Trace::new(scene, view, point))
        };
        self.traces = self.options.traces.iter().map(trace).collect::<Result<_, _>>()?;
        self.gaps = gaps(scene, view);
        self.forces = Force::all(scene, view, &self.options.forces)?;
        Ok(())
    }

    /// What the drawing covers, but for texts and supports, which have room in the margin.
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
        let gaps = self.gaps.iter().map(Gap::extent);
        let forces = self.forces.iter().map(Force::extent);
        all = gaps.chain(forces).fold(all, Box2::with);
        if all.is_nothing() { Box2::about([0.0; 2], [60.0; 2]) } else { all }
    }

    /// The guides of the ground.
    pub(super) fn rails(&self) -> Vec<(super::svg::Seat, [f64; 2])> {
        let guides = self.scene.plan.statements.iter().filter_map(|&made| {
            let Made::Guide(guide, None) = made else { return None };
            let seat = self.view.seat(self.scene.still(guide)?);
            Some((seat, guide_ends(self.scene, self.view, guide)))
        });
        guides.collect()
    }

    /// Of every crank that an input turns against the ground: pivot, radius on the page, and from
    /// where to where its pin goes unless that is all round.
    pub(super) fn cranks(&self) -> Vec<(Spot, f64, Option<[f64; 2]>)> {
        let scene = self.scene;
        let of = |&made: &Made| {
            let Made::Crank(link, pivot, Some(pin), [true, false]) = made else { return None };
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

    /// Up to sixteen poses by which places are chosen.
    fn samples(&self) -> Vec<usize> {
        let count = self.scene.len().min(16);
        (0..count)
            .map(|nth| nth * (self.scene.len() - 1) / count.max(2).saturating_sub(1))
            .collect()
    }

    fn place_supports(&mut self) {
        let (scene, samples) = (self.scene, self.samples());
        let pivots = revolutes(scene).into_iter().filter(|&point| is_ground(scene, point));
        let pivots: Vec<Spot> =
            pivots.filter_map(|point| Some(self.view.pixels(scene.point(0, point)?))).collect();
        let obstacles = self.obstacles_in(&samples);
        for &at in &pivots {
            let cost = |way: f64| {
                let covered = symbols::support_box(at, way);
                let lines = obstacles.iter().flat_map(|pose| &pose.lines);
                let lines: f64 = lines.map(|&(line, _)| covered.length_inside(line)).sum();
                let joints = obstacles.iter().flat_map(|pose| &pose.joints);
                let joints = joints.filter(|&&joint| {
                    (joint[0] - at[0]).hypot(joint[1] - at[1]) > 1.0
                        && covered.grown(JOINT).holds(joint)
                });
                let others = self.supports.iter();
                let others: f64 = others
                    .map(|&(other, way)| covered.overlap(symbols::support_box(other, way)))
                    .sum();
                (lines + 20.0 * joints.count() as f64) / samples.len() as f64 + 0.2 * others
            };
            let ways = WAYS.into_iter().zip([0.0, 6.0, 6.0, 9.0]);
            let best = ways.min_by(|a, b| (cost(a.0) + a.1).total_cmp(&(cost(b.0) + b.1)));
            self.supports.extend(best.map(|(way, _)| (at, way)));
        }
        self.place_arcs(&obstacles);
    }

    /// Arrows beside the pivots of cranks, where they cover least.
    fn place_arcs(&mut self, obstacles: &[Obstacles]) {
        let scene = self.scene;
        for &made in scene.plan.statements {
            let Made::Crank(link, pivot, _, [true, _]) = made else { continue };
            let Some(at) = scene.point(0, pivot).filter(|_| is_ground(scene, pivot)) else {
                continue;
            };
            let at = self.view.pixels(at);
            let seats: Vec<_> =
                scene.frames().filter_map(|f| Some(self.view.seat(scene.link(f, link)?))).collect();
            let turned: Vec<f64> = super::svg::unrolled(&seats).collect();
            let [Some(first), Some(last)] = [turned.first(), turned.last()] else { continue };
            // Degrees of the page run clockwise.
            let is_clockwise = last > first;
            let boxes: Vec<Box2> =
                self.supports.iter().map(|&(at, way)| symbols::support_box(at, way)).collect();
            let cost = |middle: f64| {
                let points = symbols::arc_points(at, middle);
                let covered = Box2::around(points.iter().copied()).grown(3.0);
                let lines = obstacles.iter().flat_map(|pose| &pose.lines);
                let lines: f64 = lines.map(|&(line, _)| covered.length_inside(line)).sum();
                let in_box = |spot: &&Spot| boxes.iter().any(|b| b.grown(3.0).holds(**spot));
                3.0 * lines / obstacles.len() as f64
                    + 3.0 * points.iter().filter(in_box).count() as f64
            };
            let middles = (0..18).map(|nth| 20.0 * f64::from(nth) - 20.0);
            let best = middles.min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
            self.arcs.extend(best.map(|middle| (at, middle, is_clockwise)));
        }
    }

    /// What labels should not cover, in each of these poses.
    fn obstacles_in(&self, frames: &[usize]) -> Vec<Obstacles> {
        let (rails, traces) = (self.rails(), self.traces.iter().flat_map(Trace::lines).collect());
        let still = Obstacles { traces, ..self.standing_obstacles(&rails) };
        frames.iter().map(|&frame| self.obstacles(frame, still.clone())).collect()
    }

    /// What is in the way in all poses.
    fn standing_obstacles(&self, rails: &[(super::svg::Seat, [f64; 2])]) -> Obstacles {
        let mut obstacles = Obstacles::default();
        for &(seat, ends) in rails {
            obstacles.lines.push((ends.map(|x| seat.place([x, 0.0])), 1.0));
            obstacles.boxes.extend(symbols::rail_boxes(seat, ends));
        }
        let supports = self.supports.iter();
        obstacles.boxes.extend(supports.map(|&(at, way)| symbols::support_box(at, way)));
        for &(at, middle, _) in &self.arcs {
            let points = symbols::arc_points(at, middle);
            // A text there would be read as part of the arrow.
            let covered = points.windows(2).map(|ends| Box2::around([ends[0], ends[1]]));
            obstacles.boxes.extend(covered.map(|covered| covered.grown(5.0)));
        }
        obstacles
    }

    fn obstacles(&self, frame: usize, standing: Obstacles) -> Obstacles {
        let mut obstacles = standing;
        for body in &self.bodies {
            for (shape, line) in body.shapes.iter().zip(body.lines(frame)) {
                let sides = line.windows(2).map(|ends| ([ends[0], ends[1]], shape.half_width()));
                obstacles.lines.extend(sides);
            }
        }
        let points = 0..self.scene.plan.points.len();
        let points = points.filter_map(|point| self.scene.point(frame, point));
        obstacles.joints.extend(points.map(|at| self.view.pixels(at)));
        obstacles.traces.extend(self.forces.iter().filter_map(|force| force.line(frame)));
        obstacles
    }

    fn place_labels(&mut self) -> Result<(), SketchError> {
        let (scene, plan) = (self.scene, self.scene.plan);
        let wanted = match &self.options.labels {
            None => (0..plan.points.len()).collect(),
            Some(names) => names
                .iter()
                .map(|name| traces::point(plan, name))
                .collect::<Result<Vec<usize>, _>>()?,
        };
        // What is asked for or traced is named in any case, and first.
        let is_wanted = |point: usize| {
            self.options.labels.is_some()
                || self.traces.iter().any(|trace| trace.point == point)
                || self.forces.iter().any(|force| force.point == point)
        };
        let label = |&point: &usize| {
            let at = scene.frames().map(|f| Some(self.view.pixels(scene.point(f, point)?)));
            let mut at: Vec<Option<Spot>> = at.collect();
            let first = at[0];
            if first.is_some() && at.iter().all(|spot| *spot == first) {
                at.truncate(1);
            }
            let text = plan.points[point].to_string();
            Label { text, at, is_wanted: is_wanted(point) }
        };
        let mut labels: Vec<Label> = wanted.iter().map(label).collect();
        labels.sort_by_key(|label| !label.is_wanted);
        let samples = self.samples();
        let obstacles = self.obstacles_in(&samples);
        self.labels = labels::place(labels, &samples, &obstacles);
        Ok(())
    }

    /// Moves everything so that nothing is cut off, and sizes the page.
    fn settle(&mut self) {
        let texts = self.labels.iter().map(Placed::extent);
        let supports = self.supports.iter().map(|&(at, way)| symbols::support_box(at, way));
        let rails = self.rails().into_iter();
        let rails = rails.flat_map(|(seat, ends)| symbols::rail_boxes(seat, ends));
        let shown = texts.chain(supports).chain(rails).fold(self.extent(), Box2::with);
        let content = self.extent();
        // Texts and supports may stand in the margin, but not at its end.
        let low = [0, 1].map(|axis| (content.low[axis] - MARGIN).min(shown.low[axis] - EDGE));
        let right = (content.high[0] + MARGIN).max(shown.high[0] + EDGE);
        self.shift([-low[0], self.head() - low[1]]);
        self.line = (content.high[1] + FOOT).max(shown.high[1] + EDGE + 8.0) - low[1] + self.head();
        self.page = [(right - low[0]).max(MIN_WIDTH), self.line + BELOW];
    }

    fn shift(&mut self, by: Spot) {
        let moved = |at: Spot| [at[0] + by[0], at[1] + by[1]];
        self.view.origin = moved(self.view.origin);
        self.bodies = bodies(self.scene, self.view);
        self.gaps = gaps(self.scene, self.view);
        self.traces
            .iter_mut()
            .for_each(|trace| *trace = Trace::new(self.scene, self.view, trace.point));
        self.forces.iter_mut().for_each(|force| force.shift(by));
        self.supports.iter_mut().for_each(|support| support.0 = moved(support.0));
        self.arcs.iter_mut().for_each(|arc| arc.0 = moved(arc.0));
        self.labels.iter_mut().for_each(|label| label.shift(by));
    }
}

/// From what is drawn to the line of the scale, and from there to the end of the page.
const FOOT: f64 = 28.0;
const BELOW: f64 = 18.0;
/// What is left free around texts.
const EDGE: f64 = 8.0;
/// The page is wide enough for the scale.
const MIN_WIDTH: f64 = 200.0;

/// Whether a point is one of the ground.
pub(super) fn is_ground(scene: &Scene, point: usize) -> bool {
    scene.plan.statements.iter().any(|made| matches!(made, Made::Ground(own) if *own == point))
}

/// The points at which links turn against each other.
pub(super) fn revolutes(scene: &Scene) -> Vec<usize> {
    let statements = scene.plan.statements.iter();
    let turning = statements.flat_map(|made| {
        let pin = made.point().filter(|_| !matches!(made, Made::Ground(_) | Made::Point(..)));
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
    for &made in scene.plan.statements {
        match made {
            Made::Crank(link, _, _, [_, true]) | Made::Rrp([link, _], _, _, _, true) => {
                is_cylinder[link] = true;
            }
            Made::Rrr(links, _, _, driven) => {
                links.into_iter().zip(driven).for_each(|(link, driven)| is_cylinder[link] = driven);
            }
            _ => {}
        }
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

/// A scale by which the points fill the page.
fn first_scale(scene: &Scene) -> f64 {
    let points = scene.frames().flat_map(|frame| {
        (0..scene.plan.points.len()).filter_map(move |point| scene.point(frame, point))
    });
    let [width, height] = Box2::around(points).size();
    let size = width.max(height);
    if size.is_finite() && size > 0.0 { 500.0 / size } else { 500.0 }
}
