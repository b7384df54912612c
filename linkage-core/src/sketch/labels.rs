//! Names beside joints: upright, on one side of their joint as long as nothing comes in their way. Where a joint, a
//! link or another name does, the name goes to another side, as seldom as possible. A name that fits nowhere near
//! stands farther away, at the end of a thin line.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::boxes::Box2;

use super::style::{FONT, JOINT, LABEL, Palette, has_descender, text_width};
use super::svg::{Timing, Transform, escaped, fine, pair, path, rigid};

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

/// A label with its places beside the joint.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    label: Label,
    /// From the joint to the middle of the text in every pose.
    beside: Vec<[f64; 2]>,
    half: [f64; 2],
}

/// A label at one place.
#[derive(Clone, Copy)]
struct Tried<'l> {
    label: &'l Label,
    beside: [f64; 2],
    half: [f64; 2],
}

impl Tried<'_> {
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

    /// From the joint to where the text begins.
    fn foot(&self) -> [f64; 2] {
        [self.beside[0], self.beside[1] + self.label.baseline()]
    }
}

impl Placed {
    fn tried(&self, pose: usize) -> Tried<'_> {
        Tried { label: &self.label, beside: self.beside[pose], half: self.half }
    }

    /// The extent over all poses.
    pub(super) fn extent(&self) -> Box2 {
        let poses = 0..self.beside.len();
        poses.filter_map(|pose| self.tried(pose).at(pose)).fold(Box2::NOTHING, Box2::with)
    }

    pub(super) fn shift(&mut self, by: [f64; 2]) {
        let at = self.label.at.iter_mut().flatten();
        at.for_each(|spot| *spot = [spot[0] + by[0], spot[1] + by[1]]);
    }

    /// One pose of each place that it takes, in their order.
    fn places(&self) -> Vec<usize> {
        let mut first: Vec<usize> = Vec::new();
        for (pose, beside) in self.beside.iter().enumerate() {
            if !first.iter().any(|&known| self.beside[known] == *beside) {
                first.push(pose);
            }
        }
        first
    }

    fn drawn(&self, timing: Option<Timing>, palette: &Palette) -> String {
        let is_there: Vec<bool> =
            (0..self.beside.len()).map(|pose| self.tried(pose).joint(pose).is_some()).collect();
        if !is_there[0] && timing.is_none() {
            return String::new();
        }
        let text = escaped(&self.label.text);
        let colour =
            self.label.colour.map(|colour| format!(r#" fill="{colour}""#)).unwrap_or_default();
        let (places, first) = (self.places(), self.tried(0));
        if let ([Some([x, y])], [_], None) = (&self.label.at[..], &places[..], first.leader()) {
            let [dx, dy] = first.foot();
            let at = pair([x + dx, y + dy]);
            let (x, y) = at.split_once(' ').unwrap_or_default();
            return format!(r#"<text x="{x}" y="{y}"{colour}>{text}</text>"#);
        }
        // Where the joint is missing the label is not shown, wherever it would be.
        let joints = super::svg::filled(&self.label.at).unwrap_or_default().into_iter();
        let [ox, oy] = first.foot();
        let seats: Vec<_> =
            joints.map(|[x, y]| Some(Transform { at: [x + ox, y + oy], degrees: 0.0 })).collect();
        let content = |pose: usize| {
            let own = self.tried(pose);
            let line =
                own.leader().map(|ends| leader(ends.map(|[x, y]| [x - ox, y - oy]), palette));
            let [x, y] = [own.foot()[0] - ox, own.foot()[1] - oy];
            let at = if pose == 0 {
                String::new()
            } else {
                format!(r#" x="{}" y="{}""#, fine(x), fine(y))
            };
            format!("{}<text{at}{colour}>{text}</text>", line.unwrap_or_default())
        };
        let seen = |pose: usize| -> Vec<bool> {
            let is_here = self.beside.iter().map(|beside| *beside == self.beside[pose]);
            is_here.zip(&is_there).map(|(is_here, is_there)| is_here && *is_there).collect()
        };
        let hidden = |seen: &[bool]| if seen[0] { "" } else { r#" opacity="0""# };
        let shown = |seen: &[bool]| timing.map(|timing| timing.visible(seen)).unwrap_or_default();
        let moving = timing.filter(|_| seats.len() > 1);
        if let [only] = places[..] {
            let own = seen(only);
            let content = format!("{}{}", shown(&own), content(only));
            return rigid(&seats, moving, hidden(&own), &content);
        }
        let all = places.into_iter().map(|pose| {
            let own = seen(pose);
            format!("<g{}>{}{}</g>", hidden(&own), shown(&own), content(pose))
        });
        rigid(&seats, moving, "", &all.collect::<String>())
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

/// Puts every label where it can be seen, one after the other. There are obstacles for every pose.
pub(super) fn place(labels: Vec<Label>, obstacles: &[Obstacles]) -> Vec<Placed> {
    let mut placed: Vec<Placed> = Vec::new();
    let count = obstacles.len().min(SAMPLES);
    let sample = |nth: usize| nth * (obstacles.len() - 1) / count.max(2).saturating_sub(1);
    let samples: Vec<usize> = (0..count).map(sample).collect();
    for label in labels {
        let half = label.half();
        let places: Vec<_> = places(half).collect();
        let tried = |nth: usize| Tried { label: &label, beside: places[nth].0, half };
        let (mut found, mut least) = (0, f64::INFINITY);
        for (nth, &(_, bias)) in places.iter().enumerate() {
            if bias >= least {
                continue;
            }
            let cost = bias + cost(&tried(nth), &samples, obstacles, &placed, least - bias);
            if cost < least {
                (found, least) = (nth, cost);
            }
        }
        let is_free = |nth: usize, pose: usize| {
            let own = tried(nth);
            own.joint(pose).is_none() || is_free(&own, pose, obstacles, &placed)
        };
        let poses = obstacles.len();
        let way = match (0..poses).all(|pose| is_free(found, pose)) {
            true => std::vec![found; poses],
            false => way(&places, found, poses, is_free),
        };
        let beside = way.into_iter().map(|nth| places[nth].0).collect();
        placed.push(Placed { label, beside, half });
    }
    placed
}

/// The cost of a label that is covered in a pose, of one that goes elsewhere, and the share of what speaks against a place
/// that counts in a pose.
const COVERED: f64 = 100.0;
const HOP: f64 = 30.0;
const SHARE: f64 = 0.02;

/// The place of each pose: of all ways over the poses the one that costs least. `found` is the best place for all.
fn way(
    places: &[([f64; 2], f64)],
    found: usize,
    poses: usize,
    is_free: impl Fn(usize, usize) -> bool,
) -> Vec<usize> {
    let mut costs: Vec<f64> = std::vec![0.0; places.len()];
    let mut before: Vec<Vec<usize>> = Vec::new();
    for pose in 0..poses {
        let least =
            (0..places.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b])).unwrap_or(found);
        let hop = if pose == 0 { 0.0 } else { costs[least] + HOP };
        let from = |nth: usize| if hop < costs[nth] { least } else { nth };
        let own: Vec<usize> = (0..places.len()).map(from).collect();
        costs = (0..places.len())
            .map(|nth| {
                let bias = if nth == found { 0.0 } else { SHARE * (places[nth].1 + 1.0) };
                let covered = if is_free(nth, pose) { 0.0 } else { COVERED };
                costs[nth].min(hop) + bias + covered
            })
            .collect();
        before.push(own);
    }
    let mut at = (0..places.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b])).unwrap_or(found);
    let mut way: Vec<usize> = before
        .iter()
        .rev()
        .map(|from| {
            let own = at;
            at = from[at];
            own
        })
        .collect();
    way.reverse();
    way
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
    candidate: &Tried<'_>,
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
fn is_free(label: &Tried<'_>, pose: usize, obstacles: &[Obstacles], placed: &[Placed]) -> bool {
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
        let other = other.tried(pose);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A bar passes by on the right: the name goes to the left once and comes back once.
    #[test]
    fn a_label_gives_way_and_hops_seldom() {
        let at = std::vec![Some([0.0, 0.0])];
        let label = Label { text: "B".into(), at, colour: None };
        let turning = |pose: i32| {
            let (sin, cos) = f64::from(3 * pose).to_radians().sin_cos();
            let line = [[0.0, 0.0], [100.0 * cos, 100.0 * sin]];
            Obstacles { lines: std::vec![(line, 2.5)], ..Obstacles::default() }
        };
        let obstacles: Vec<Obstacles> = (0..120).map(turning).collect();
        let placed = place(std::vec![label], &obstacles);
        let hops = placed[0].beside.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!((1..=2).contains(&hops), "{hops}");
        for (pose, obstacles) in obstacles.iter().enumerate() {
            let covered = placed[0].tried(pose).at(pose).unwrap();
            assert_eq!(covered.grown(2.5).length_inside(obstacles.lines[0].0), 0.0, "{pose}");
        }
    }

    #[test]
    fn what_is_asked_for_stands_beside_a_line_through_its_joint() {
        let at = std::vec![Some([0.0, 0.0])];
        let label = Label { text: "B".into(), at, colour: None };
        let line = [[-100.0, 100.0], [100.0, -100.0]];
        let obstacles = Obstacles { lines: std::vec![(line, 2.5)], ..Obstacles::default() };
        let placed = place(std::vec![label], &[obstacles]);
        let covered = placed[0].tried(0).at(0).unwrap();
        assert_eq!(covered.grown(2.5).length_inside(line), 0.0);
        assert!(!covered.holds([0.0, 0.0]));
    }
}
