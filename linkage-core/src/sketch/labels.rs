//! Names beside joints: upright, on one side of their joint all the time, and where they cover least.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::boxes::Box2;
use super::scene::Spot;
use super::style::{FONT, JOINT, LABEL, Palette, text_width};
use super::svg::{Seat, Timing, escaped, pair, rigid};

/// What is in the way in one pose, on the page.
#[derive(Clone, Debug, Default)]
pub(super) struct Obstacles {
    /// Lines and half their width.
    pub lines: Vec<([Spot; 2], f64)>,
    pub boxes: Vec<Box2>,
    pub joints: Vec<Spot>,
    /// What may be covered rather than anything else.
    pub traces: Vec<[Spot; 2]>,
}

/// A name and where its joint is in every pose.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub text: String,
    pub at: Vec<Option<Spot>>,
    /// Whether it is shown though it covers something.
    pub is_wanted: bool,
}

/// A label with its place beside the joint.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    label: Label,
    /// From the joint to the middle of the text.
    beside: Spot,
    half: Spot,
}

impl Placed {
    /// What it covers over all poses.
    pub(super) fn extent(&self) -> Box2 {
        let boxes = (0..self.label.at.len()).filter_map(|pose| self.at(pose));
        boxes.fold(Box2::NOTHING, Box2::with)
    }

    pub(super) fn shift(&mut self, by: Spot) {
        let at = self.label.at.iter_mut().flatten();
        at.for_each(|spot| *spot = [spot[0] + by[0], spot[1] + by[1]]);
    }

    /// What it covers in a pose; a label that stands still has one for all.
    fn at(&self, pose: usize) -> Option<Box2> {
        let [x, y] = (*self.label.at.get(pose).or(self.label.at.first())?)?;
        Some(Box2::about([x + self.beside[0], y + self.beside[1]], self.half))
    }

    pub(super) fn drawn(&self, timing: Option<Timing>) -> String {
        // The letters stand on a line a third of their size below their middle.
        let [dx, dy] = [self.beside[0], self.beside[1] + 0.34 * LABEL];
        let seat = |at: &Option<Spot>| at.map(|[x, y]| Seat { at: [x + dx, y + dy], degrees: 0.0 });
        let seats: Vec<_> = self.label.at.iter().map(seat).collect();
        let text = escaped(&self.label.text);
        match &seats[..] {
            [Some(only)] => {
                let at = pair(only.at);
                let (x, y) = at.split_once(' ').unwrap_or_default();
                format!(r#"<text x="{x}" y="{y}">{text}</text>"#)
            }
            seats => rigid(seats, timing, "", &format!("<text>{text}</text>")),
        }
    }
}

/// All labels in a group that says how they look.
pub(super) fn drawn(labels: &[Placed], timing: Option<Timing>, palette: &Palette) -> String {
    if labels.is_empty() {
        return String::new();
    }
    let texts: String = labels.iter().map(|label| label.drawn(timing)).collect();
    format!(
        r#"<g font-family="{FONT}" font-size="{LABEL}" font-style="italic" text-anchor="middle" fill="{}" stroke="{}" stroke-width="3" stroke-linejoin="round" paint-order="stroke">{texts}</g>"#,
        palette.ink, palette.paper,
    )
}

/// Puts every label where it covers least, one after the other; leaves out those that would cover
/// a joint or much of a link, unless they are wanted. The obstacles are those of `samples`.
pub(super) fn place(labels: Vec<Label>, samples: &[usize], obstacles: &[Obstacles]) -> Vec<Placed> {
    let mut placed: Vec<Placed> = Vec::new();
    for label in labels {
        let half = [0.5 * LABEL * text_width(&label.text), 0.42 * LABEL];
        let candidates = places(half).enumerate().map(|(nth, beside)| {
            let candidate = Placed { label: label.clone(), beside, half };
            let cost = cost(&candidate, samples, obstacles, &placed);
            (Cost { bias: 0.15 * nth as f64, ..cost }, candidate)
        });
        let best = candidates.min_by(|a, b| a.0.total().total_cmp(&b.0.total()));
        placed.extend(
            best.filter(|(cost, candidate)| candidate.label.is_wanted || cost.is_bearable())
                .map(|(_, candidate)| candidate),
        );
    }
    placed
}

/// Twelve directions at two distances, from the upper right on.
fn places(half: Spot) -> impl Iterator<Item = Spot> {
    let directions = [-45, -135, 45, 135, 0, 180, -90, 90, -20, -160, 20, 160_i32];
    let gaps = [JOINT + 4.5, JOINT + 12.0, JOINT + 20.0];
    gaps.into_iter().flat_map(move |gap| {
        directions.into_iter().map(move |degrees| {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            // The box begins where the gap ends, whichever way it lies.
            let reach = |part: f64, half: f64| part * gap + half * (part * 1.6).clamp(-1.0, 1.0);
            [reach(cos, half[0]), reach(sin, half[1])]
        })
    })
}

/// What a label covers, on the average of the poses.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    joints: f64,
    links: f64,
    others: f64,
    bias: f64,
}

impl Cost {
    fn total(self) -> f64 {
        100.0 * self.joints + self.links + self.others + self.bias
    }

    /// No joint in any pose, and no link but now and then.
    fn is_bearable(self) -> bool {
        self.joints == 0.0 && self.links < BEARABLE
    }
}

/// Pixels of links below a label, on the average.
const BEARABLE: f64 = 9.0;

fn cost(candidate: &Placed, samples: &[usize], obstacles: &[Obstacles], placed: &[Placed]) -> Cost {
    let mut cost = Cost::default();
    let mut seen = 0.0;
    for (&pose, obstacles) in samples.iter().zip(obstacles) {
        let Some(covered) = candidate.at(pose) else { continue };
        seen += 1.0;
        let own = candidate.label.at.get(pose).or(candidate.label.at.first());
        let own = own.copied().flatten().unwrap_or_default();
        for &joint in &obstacles.joints {
            let is_own = (joint[0] - own[0]).hypot(joint[1] - own[1]) < 0.5;
            if !is_own && covered.grown(JOINT + 0.5).holds(joint) {
                cost.joints += 1.0;
            }
        }
        let links = obstacles.lines.iter();
        cost.links +=
            links.map(|&(line, width)| covered.grown(width).length_inside(line)).sum::<f64>();
        let boxes = obstacles.boxes.iter();
        cost.links += boxes.map(|other| 0.4 * covered.overlap(*other)).sum::<f64>();
        let traces = obstacles.traces.iter();
        cost.others += traces.map(|&line| 0.5 * covered.length_inside(line)).sum::<f64>();
        let labels = placed.iter().filter_map(|other| other.at(pose));
        cost.joints +=
            labels.filter(|other| covered.overlap(other.grown(1.0)) > 0.0).count() as f64;
    }
    let seen = f64::max(seen, 1.0);
    Cost {
        joints: cost.joints / seen,
        links: cost.links / seen,
        others: cost.others / seen,
        bias: 0.0,
    }
}
