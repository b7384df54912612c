//! Names beside joints: upright, on one side of their joint all the time, and where they cover least.
//! A name that fits nowhere near stands farther away, at the end of a thin line. Where a joint, a link or
//! another name comes in its way all the same it is dimmed until that has passed; it never goes while
//! its joint is there.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::boxes::Box2;

use super::style::{FONT, JOINT, LABEL, Palette, has_descender, text_width};
use super::svg::{Timing, Transform, escaped, pair, path, rigid};

/// Obstacles to labels in one pose, on the page.
#[derive(Clone, Debug, Default)]
pub(super) struct Obstacles {
    /// Lines and half their width.
    pub lines: Vec<([[f64; 2]; 2], f64)>,
    pub boxes: Vec<Box2>,
    pub joints: Vec<[f64; 2]>,
    /// Lines that a label may cover if it must.
    pub traces: Vec<[[f64; 2]; 2]>,
}

/// A name and where its joint is in every pose.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub text: String,
    pub at: Vec<Option<[f64; 2]>>,
    /// Its colour, where it is not that of names.
    pub colour: Option<&'static str>,
}

impl Label {
    /// Half the width and half the height of the text.
    fn half(&self) -> [f64; 2] {
        [0.5 * LABEL * text_width(&self.text), 0.5 * LABEL * (RISE + self.descent())]
    }

    /// From the middle of the letters down to the line they stand on.
    fn baseline(&self) -> f64 {
        0.5 * LABEL * (RISE - self.descent())
    }

    fn descent(&self) -> f64 {
        if has_descender(&self.text) { 0.22 } else { 0.0 }
    }
}

/// Height of a capital letter, of its size.
const RISE: f64 = 0.73;

/// A label with its place beside the joint.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    label: Label,
    /// From the joint to the middle of the text.
    beside: [f64; 2],
    half: [f64; 2],
    /// In which poses nothing is in its way.
    free: Vec<bool>,
}

impl Placed {
    /// The extent over all poses.
    pub(super) fn extent(&self) -> Box2 {
        (0..self.free.len()).filter_map(|pose| self.at(pose)).fold(Box2::NOTHING, Box2::with)
    }

    pub(super) fn shift(&mut self, by: [f64; 2]) {
        let at = self.label.at.iter_mut().flatten();
        at.for_each(|spot| *spot = [spot[0] + by[0], spot[1] + by[1]]);
    }

    /// The box covered in a pose; a label that stands still has one place for all.
    fn at(&self, pose: usize) -> Option<Box2> {
        let [x, y] = self.joint(pose)?;
        Some(Box2::about([x + self.beside[0], y + self.beside[1]], self.half))
    }

    fn joint(&self, pose: usize) -> Option<[f64; 2]> {
        *self.label.at.get(pose).or(self.label.at.first())?
    }

    /// The line to a label that stands far from its joint, as that sees it.
    fn leader(&self) -> Option<[[f64; 2]; 2]> {
        let box2 = Box2::about(self.beside, self.half);
        let end = [0, 1].map(|axis| 0.0_f64.clamp(box2.low[axis], box2.high[axis]));
        let length = end[0].hypot(end[1]);
        let start = (JOINT + 2.0) / length;
        (length > FAR).then(|| [[start * end[0], start * end[1]], end])
    }

    fn leader_at(&self, pose: usize) -> Option<[[f64; 2]; 2]> {
        let [x, y] = self.joint(pose)?;
        Some(self.leader()?.map(|[dx, dy]| [x + dx, y + dy]))
    }

    /// The opacity in each pose.
    fn opacities(&self) -> Vec<f64> {
        let opacity = |pose: usize| match () {
            () if self.joint(pose).is_none() => 0.0,
            () if self.free[pose] => 1.0,
            () => DIMMED,
        };
        (0..self.free.len()).map(opacity).collect()
    }

    fn drawn(&self, timing: Option<Timing>, palette: &Palette) -> String {
        let opacities = self.opacities();
        // A label of a still is never dimmed.
        let first = match opacities[0] {
            opacity if opacity > 0.0 && timing.is_none() => 1.0,
            opacity => opacity,
        };
        if first == 0.0 && timing.is_none() {
            return String::new();
        }
        let hidden = match first {
            1.0 => String::new(),
            opacity => format!(r#" opacity="{opacity}""#),
        };
        let fading = timing.map(|timing| timing.fading(&opacities)).unwrap_or_default();
        let [dx, dy] = [self.beside[0], self.beside[1] + self.label.baseline()];
        let seat = |at: &Option<[f64; 2]>| {
            at.map(|[x, y]| Transform { at: [x + dx, y + dy], degrees: 0.0 })
        };
        let seats: Vec<_> = self.label.at.iter().map(seat).collect();
        let text = escaped(&self.label.text);
        let colour =
            self.label.colour.map(|colour| format!(r#" fill="{colour}""#)).unwrap_or_default();
        let leader = self.leader().map(|ends| leader(ends.map(|[x, y]| [x - dx, y - dy]), palette));
        if let ([Some(only)], None) = (&seats[..], &leader) {
            let at = pair(only.at);
            let (x, y) = at.split_once(' ').unwrap_or_default();
            return format!(r#"<text x="{x}" y="{y}"{colour}{hidden}>{text}{fading}</text>"#);
        }
        // Where the joint is missing the label is not shown, wherever it would be.
        let seats: Vec<_> =
            super::svg::filled(&seats).unwrap_or_default().into_iter().map(Some).collect();
        let leader = leader.unwrap_or_default();
        let timing = timing.filter(|_| seats.len() > 1);
        rigid(&seats, timing, &hidden, &format!("{fading}{leader}<text{colour}>{text}</text>"))
    }
}

/// From a joint to its name.
fn leader(ends: [[f64; 2]; 2], palette: &Palette) -> String {
    format!(
        r#"<path d="{}" fill="none" stroke="{}" stroke-width="1"/>"#,
        path(&ends, false),
        palette.quiet
    )
}

/// The distance from which on a name needs a line to its joint.
const FAR: f64 = JOINT + 22.0;
/// The opacity of a label behind an obstacle.
const DIMMED: f64 = 0.55;

/// All labels in a group that says how they look.
pub(super) fn drawn(labels: &[Placed], timing: Option<Timing>, palette: &Palette) -> String {
    if labels.is_empty() {
        return String::new();
    }
    let texts: String = labels.iter().map(|label| label.drawn(timing, palette)).collect();
    format!(
        r#"<g font-family="{FONT}" font-size="{LABEL}" font-style="italic" text-anchor="middle" fill="{}" stroke="{}" stroke-width="3" stroke-linejoin="round" paint-order="stroke">{texts}</g>"#,
        palette.ink, palette.paper,
    )
}

/// Puts every label where it can be seen most of the time, one after the other. There are obstacles for
/// every pose.
pub(super) fn place(labels: Vec<Label>, obstacles: &[Obstacles]) -> Vec<Placed> {
    let mut placed: Vec<Placed> = Vec::new();
    let count = obstacles.len().min(SAMPLES);
    let sample = |nth: usize| nth * (obstacles.len() - 1) / count.max(2).saturating_sub(1);
    let samples: Vec<usize> = (0..count).map(sample).collect();
    for label in labels {
        let half = label.half();
        let mut best = Placed { label, beside: [0.0; 2], half, free: Vec::new() };
        let (mut found, mut least) = ([0.0; 2], f64::INFINITY);
        for (beside, bias) in places(half) {
            if bias >= least {
                continue;
            }
            best.beside = beside;
            let cost = bias + cost(&best, &samples, obstacles, &placed, least - bias);
            if cost < least {
                (found, least) = (beside, cost);
            }
        }
        best.beside = found;
        let free = (0..obstacles.len()).map(|pose| is_free(&best, pose, obstacles, &placed));
        best.free = steady(free.collect());
        placed.push(best);
    }
    placed
}

/// Poses by which places are chosen.
const SAMPLES: usize = 24;

/// Twelve directions at seven distances, from the upper right on, and what speaks against each.
fn places(half: [f64; 2]) -> impl Iterator<Item = ([f64; 2], f64)> {
    let directions = [-45, -135, 45, 135, 0, 180, -90, 90, -20, -160, 20, 160_i32];
    let near = [(JOINT + 4.5, 0.0), (JOINT + 12.0, 2.5), (JOINT + 20.0, 6.0)];
    let far =
        [(JOINT + 30.0, 18.0), (JOINT + 44.0, 22.0), (JOINT + 62.0, 28.0), (JOINT + 84.0, 36.0)];
    near.into_iter().chain(far).flat_map(move |(gap, far)| {
        directions.into_iter().enumerate().map(move |(nth, degrees)| {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            // The box begins where the gap ends, whichever way it lies.
            let reach = |part: f64, half: f64| part * gap + half * (part * 1.6).clamp(-1.0, 1.0);
            ([reach(cos, half[0]), reach(sin, half[1])], far + 0.15 * nth as f64)
        })
    })
}

/// The cost of a place: the percentage of the poses in which a label would be hidden, and the average
/// length of traces that it covers. A label hidden in the first pose costs much more, as a film that is
/// not played shows that pose. The sum ends early once it reaches `most`.
fn cost(
    candidate: &Placed,
    samples: &[usize],
    obstacles: &[Obstacles],
    placed: &[Placed],
    most: f64,
) -> f64 {
    let (mut hidden, mut traces) = (0.0, 0.0);
    let seen = samples.iter().filter(|&&pose| candidate.joint(pose).is_some()).count();
    let seen = seen.max(1) as f64;
    for &pose in samples {
        let Some(covered) = candidate.at(pose) else { continue };
        if !is_free(candidate, pose, obstacles, placed) {
            hidden += if pose == 0 { 1.0 + 0.3 * samples.len() as f64 } else { 1.0 };
        }
        let lines = obstacles[pose].traces.iter();
        traces += lines.map(|&line| covered.length_inside(line)).sum::<f64>();
        if 100.0 * hidden + 0.5 * traces >= most * seen {
            break;
        }
    }
    (100.0 * hidden + 0.5 * traces) / seen
}

/// True if a label covers no joint, link, support or other label in a pose, and its line no joint or label.
fn is_free(label: &Placed, pose: usize, obstacles: &[Obstacles], placed: &[Placed]) -> bool {
    let (Some(covered), Some(own)) = (label.at(pose), label.joint(pose)) else { return false };
    let Obstacles { lines, boxes, joints, .. } = &obstacles[pose];
    let leader = label.leader_at(pose);
    let crosses = |other: Box2| leader.is_some_and(|line| other.length_inside(line) > 0.0);
    let is_own = |joint: [f64; 2]| (joint[0] - own[0]).hypot(joint[1] - own[1]) < 0.5;
    let on_joint = |&joint: &[f64; 2]| {
        let circle = || Box2::about(joint, [JOINT; 2]);
        !is_own(joint) && (covered.grown(JOINT + CLEAR).holds(joint) || crosses(circle()))
    };
    let on_line = |&(line, width): &([[f64; 2]; 2], f64)| {
        covered.grown(width + CLEAR).length_inside(line) > 0.0
    };
    let on_label = |other: &Placed| {
        let covers = |box2: Box2| covered.overlap(box2.grown(CLEAR)) > 0.0 || crosses(box2);
        other.at(pose).is_some_and(covers)
            || other.leader_at(pose).is_some_and(|line| covered.length_inside(line) > 0.0)
    };
    !(joints.iter().any(on_joint)
        || lines.iter().any(on_line)
        || boxes.iter().any(|other| covered.overlap(*other) > 0.0)
        || placed.iter().any(on_label))
}

/// The smallest gap between a label and anything else, in pixels.
const CLEAR: f64 = 2.0;

/// Dims a label one pose before anything comes in its way until one pose later, and does not show it in
/// full for a moment only.
fn steady(free: Vec<bool>) -> Vec<bool> {
    let last = free.len() - 1;
    let around = |pose: usize| pose.saturating_sub(1)..=(pose + 1).min(last);
    let mut shown: Vec<bool> = (0..=last).map(|pose| around(pose).all(|near| free[near])).collect();
    // The first pose is shown in a film that is not played.
    shown[0] = free[0];
    let moment = free.len() / 12;
    let mut start = 0;
    while start <= last {
        let same = shown[start..].iter().take_while(|other| **other == shown[start]).count();
        let is_inside = start > 0 && start + same <= last;
        if shown[start] && is_inside && same < moment {
            shown[start..start + same].fill(false);
        }
        start += same;
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_is_hidden_before_something_comes_and_never_flickers() {
        let mut free = std::vec![true; 60];
        free[20] = false;
        free[24] = false;
        let shown = steady(free);
        let hidden: Vec<usize> = (0..60).filter(|&pose| !shown[pose]).collect();
        // 22 alone would be shown for a moment.
        assert_eq!(hidden, [19, 20, 21, 22, 23, 24, 25]);
        assert_eq!(steady(std::vec![false]), [false]);
    }

    #[test]
    fn what_is_asked_for_stands_beside_a_line_through_its_joint() {
        let at = std::vec![Some([0.0, 0.0])];
        let label = Label { text: "B".into(), at, colour: None };
        let line = [[-100.0, 100.0], [100.0, -100.0]];
        let obstacles = Obstacles { lines: std::vec![(line, 2.5)], ..Obstacles::default() };
        let placed = place(std::vec![label], &[obstacles]);
        let covered = placed[0].at(0).unwrap();
        assert_eq!(covered.grown(2.5).length_inside(line), 0.0);
        assert!(!covered.holds([0.0, 0.0]));
    }
}
