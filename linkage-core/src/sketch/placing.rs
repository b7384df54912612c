//! Where supports, arrows of cranks and labels stand: where they cover least.

use std::string::ToString;
use std::vec::Vec;

use super::boxes::Box2;
use super::labels::{self, Label, Obstacles};
use super::picture::{Picture, is_ground, revolutes};

use super::sketch_error::SketchError;
use super::springs::{Coil, wall_box};
use super::style::JOINT;
use super::symbols::{self, WAYS};
use super::traces::{self, Trace};

/// Half the width of an arrow's head.
const ARROW: f64 = 3.5;

impl Picture<'_> {
    /// Up to sixteen poses by which places are chosen.
    fn samples(&self) -> Vec<usize> {
        let count = self.scene.len().min(16);
        (0..count)
            .map(|nth| nth * (self.scene.len() - 1) / count.max(2).saturating_sub(1))
            .collect()
    }

    pub(super) fn place_supports(&mut self) {
        let (scene, samples) = (self.scene, self.samples());
        for (end, coil) in self.spring_ends() {
            let way = coil.wall(end).filter(|_| !self.pivots().contains(&end));
            if let (Some(way), Some(at)) = (way, scene.point(0, end)) {
                self.walls.push((self.view.pixels(at), way));
            }
        }
        let mut pivots = self.pivots();
        pivots.retain(|&point| is_ground(scene, point));
        let pivots = pivots.into_iter();
        let pivots: Vec<[f64; 2]> =
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

    /// The points at which links turn, and on which springs do.
    pub(super) fn pivots(&self) -> Vec<usize> {
        let mut pivots = revolutes(self.scene);
        let springs = self.spring_ends().into_iter();
        let turning = springs.filter(|(end, coil)| coil.wall(*end).is_none());
        pivots.extend(turning.map(|(end, _)| end));
        pivots.sort_unstable();
        pivots.dedup();
        pivots
    }

    /// The ends of springs that are points of the ground.
    fn spring_ends(&self) -> Vec<(usize, Coil)> {
        let springs = self.scene.plan.springs.iter().zip(&self.springs);
        let ends = springs.flat_map(|(spring, coil)| spring.ends.map(|end| (end, coil.clone())));
        ends.filter(|&(end, _)| is_ground(self.scene, end)).collect()
    }

    /// Arrows beside the pivots of cranks, where they cover least.
    fn place_arcs(&mut self, obstacles: &[Obstacles]) {
        let scene = self.scene;
        for &made in scene.plan.statements {
            let Some(crank) = made.turned() else { continue };
            let (Some(pivot), link) = (crank.pivot(), crank.link) else { continue };
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
                let in_box = |spot: &&[f64; 2]| boxes.iter().any(|b| b.grown(3.0).holds(**spot));
                // Links pass, supports stay.
                3.0 * lines / obstacles.len() as f64
                    + 30.0 * points.iter().filter(in_box).count() as f64
            };
            let middles = (0..18).map(|nth| 20.0 * f64::from(nth) - 20.0);
            let best = middles.min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
            self.arcs.extend(best.map(|middle| (at, middle, is_clockwise)));
        }
    }

    /// Obstacles that labels should not cover, in each of these poses.
    fn obstacles_in(&self, frames: &[usize]) -> Vec<Obstacles> {
        let (rails, traces) = (self.rails(), self.traces.iter().flat_map(Trace::lines).collect());
        let still = Obstacles { traces, ..self.standing_obstacles(&rails) };
        frames.iter().map(|&frame| self.obstacles(frame, still.clone())).collect()
    }

    /// Obstacles common to all poses.
    fn standing_obstacles(&self, rails: &[(super::svg::Transform, [f64; 2])]) -> Obstacles {
        let mut obstacles = Obstacles::default();
        for &(seat, ends) in rails {
            obstacles.lines.push((ends.map(|x| seat.place([x, 0.0])), 1.0));
            obstacles.boxes.extend(symbols::rail_boxes(seat, ends));
        }
        let supports = self.supports.iter();
        obstacles.boxes.extend(supports.map(|&(at, way)| symbols::support_box(at, way)));
        obstacles.boxes.extend(self.walls.iter().map(|&(at, way)| wall_box(at, way)));
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
        let springs = self.springs.iter();
        let springs = springs.filter_map(|coil| Some((coil.line(frame)?, coil.half_width())));
        obstacles.lines.extend(springs);
        let points = 0..self.scene.plan.points.len();
        let points = points.filter_map(|point| self.scene.point(frame, point));
        obstacles.joints.extend(points.map(|at| self.view.pixels(at)));
        let arrows = self.loads.iter().flat_map(|load| load.sides(frame));
        let arrows = arrows.chain(self.gaps.iter().filter_map(|gap| gap.line(frame)));
        obstacles.lines.extend(arrows.map(|line| (line, ARROW)));
        obstacles
    }

    /// In how many poses a label can be seen.
    fn shown_poses(&self) -> usize {
        if self.options.is_still { 1 } else { self.scene.len() }
    }

    pub(super) fn place_labels(&mut self) -> Result<(), SketchError> {
        let (scene, plan) = (self.scene, self.scene.plan);
        // In a still, only the first pose has obstacles.
        let frames: Vec<usize> = scene.frames().take(self.shown_poses()).collect();
        let wanted = match &self.options.labels {
            None => (0..plan.points.len()).filter(|&at| !plan.points[at].is_empty()).collect(),
            Some(names) => names
                .iter()
                .map(|name| traces::point(plan, name))
                .collect::<Result<Vec<usize>, _>>()?,
        };
        // Traced points get the first choice of places.
        let is_traced = |point: &usize| self.traces.iter().any(|trace| trace.point == *point);
        let label = |&point: &usize| {
            let at = frames.iter().map(|&f| Some(self.view.pixels(scene.point(f, point)?)));
            let mut at: Vec<Option<[f64; 2]>> = at.collect();
            let first = at[0];
            if first.is_some() && at.iter().all(|spot| *spot == first) {
                at.truncate(1);
            }
            Label { text: plan.points[point].to_string(), at, colour: None }
        };
        let mut wanted: Vec<usize> = wanted;
        wanted.sort_by_key(|point| !is_traced(point));
        let mut labels: Vec<Label> = wanted.iter().map(label).collect();
        if frames.len() == 1 {
            labels.extend(self.values());
        }
        let obstacles = self.obstacles_in(&frames);
        self.labels = labels::place(labels, &obstacles);
        Ok(())
    }

    /// The values of forces and couples in the first pose.
    fn values(&self) -> Vec<Label> {
        let written = self.loads.iter().filter_map(|load| {
            let (at, text) = load.value(0)?;
            Some(Label { text, at: [Some(at)].into(), colour: Some(load.colour(&self.palette)) })
        });
        written.collect()
    }
}
