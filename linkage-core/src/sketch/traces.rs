//! The paths of points, and faint poses.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::bodies::Body;
use super::boxes::Box2;
use super::plan::Plan;
use super::scene::Scene;
use super::sketch_error::SketchError;
use super::svg::{View, path, short};

/// The point of this name.
pub(super) fn point(plan: &Plan, name: &str) -> Result<usize, SketchError> {
    named(plan.points, name, "point")
}

/// The link of this name.
pub(super) fn link(plan: &Plan, name: &str) -> Result<usize, SketchError> {
    named(plan.links, name, "link")
}

/// The place of a name among those that are known.
pub(super) fn named(names: &[&str], name: &str, kind: &'static str) -> Result<usize, SketchError> {
    names.iter().position(|known| *known == name).ok_or_else(|| {
        let nearest = names.iter().min_by_key(|known| distance(name, known));
        let nearest = nearest.map(|known| known.to_string());
        SketchError::UnknownName { name: name.to_string(), kind, nearest }
    })
}

/// The number of letters that differ, a change of case counting half (Wagner and Fischer).
fn distance(a: &str, b: &str) -> usize {
    let letters: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=letters.len()).map(|nth| 2 * nth).collect();
    for (nth, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = 2 * (nth + 1);
        for (at, other) in letters.iter().enumerate() {
            let change = match () {
                () if letter == *other => 0,
                () if letter.eq_ignore_ascii_case(other) => 1,
                () => 2,
            };
            let best = (diagonal + change).min(row[at] + 2).min(row[at + 1] + 2);
            diagonal = row[at + 1];
            row[at + 1] = best;
        }
    }
    row[letters.len()]
}

/// The path of a point.
#[derive(Clone, Debug)]
pub(super) struct Trace {
    pub point: usize,
    /// Where the point is in each pose, on the page.
    at: Vec<Option<[f64; 2]>>,
}

impl Trace {
    pub(super) fn new(scene: &Scene, view: View, point: usize) -> Self {
        let at = scene.frames().map(|f| Some(view.pixels(scene.point(f, point)?))).collect();
        Self { point, at }
    }

    /// The link that carries the point: of a pin the last one.
    pub(super) fn link(&self, scene: &Scene) -> Option<usize> {
        let joints = scene.plan.statements.iter().filter(|made| made.point() == Some(self.point));
        joints.flat_map(|made| made.joints()).rfind(|joint| joint.1 == self.point).map(|j| j.0)
    }

    /// About where it goes: every third pose is enough to keep texts away.
    pub(super) fn lines(&self) -> Vec<[[f64; 2]; 2]> {
        self.at.windows(4).step_by(3).filter_map(|ends| Some([ends[0]?, ends[3]?])).collect()
    }

    /// A line with a gap wherever the point is missing, and dots at equal steps of time.
    pub(super) fn drawn(&self, name: &str, colour: &str) -> String {
        let runs = self.at.split(Option::is_none).filter(|run| run.len() > 1);
        let line: String = runs
            .map(|run| path(&run.iter().copied().flatten().collect::<Vec<_>>(), false))
            .collect();
        if line.is_empty() {
            return String::new();
        }
        let last = self.at.len() - 1;
        let steps = (0..=DOTS).map(|nth| nth * last / DOTS);
        let mut dots: Vec<[f64; 2]> = steps.filter_map(|frame| self.at[frame]).collect();
        dots.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1.0);
        let dot = |[x, y]: [f64; 2]| format!("M{} {}h0", short(x), short(y));
        let dots: String = dots.into_iter().map(dot).collect();
        format!(
            r#"<g data-trace="{name}" fill="none" stroke="{colour}" stroke-linejoin="round" stroke-linecap="round"><path d="{line}" stroke-width="2"/><path d="{dots}" stroke-width="5.2"/></g>"#
        )
    }
}

/// Steps of time of a trace.
const DOTS: usize = 12;

/// Faint copies of every link but the first pose's, a path a link.
pub(super) fn ghosts(scene: &Scene, bodies: &[Body], poses: usize) -> Vec<(Option<usize>, String)> {
    let poses = poses.min(scene.len());
    if poses < 2 {
        return Vec::new();
    }
    let last = scene.len() - 1;
    // The last pose of a closed motion is the first.
    let steps = if is_closed(scene) { poses } else { poses - 1 };
    let frames = (1..poses).map(|nth| nth * last / steps);
    let frames: Vec<usize> = frames.filter(|&frame| frame > 0).collect();
    let mut ghosts: Vec<(Option<usize>, String)> = Vec::new();
    for body in bodies {
        let mut drawn = String::new();
        for &frame in &frames {
            for (shape, line) in body.shapes.iter().zip(body.lines(frame)) {
                if shape.is_long() {
                    drawn += &path(&line, false);
                }
            }
        }
        if drawn.is_empty() {
            continue;
        }
        match ghosts.iter_mut().find(|(link, _)| *link == body.link) {
            Some((_, path)) => *path += &drawn,
            None => ghosts.push((body.link, drawn)),
        }
    }
    ghosts
}

/// True if the motion ends where it began, to a billionth of the mechanism's size.
pub(super) fn is_closed(scene: &Scene) -> bool {
    let last = scene.len() - 1;
    let points = 0..scene.plan.points.len();
    let all = points.clone().filter_map(|point| scene.point(0, point));
    let size = Box2::around(all).size();
    let near = 1e-9 * (size[0].max(0.0) + size[1].max(0.0));
    points.into_iter().all(|point| match (scene.point(0, point), scene.point(last, point)) {
        (Some(a), Some(b)) => (a[0] - b[0]).hypot(a[1] - b[1]) <= near,
        (None, None) => true,
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_named() {
        const NAMES: &[&str] = &["B", "blade", "C"];
        let nearest = |name| match named(NAMES, name, "point") {
            Err(SketchError::UnknownName { nearest, .. }) => nearest,
            _ => None,
        };
        assert_eq!(nearest("Blade").as_deref(), Some("blade"));
        assert_eq!(nearest("b").as_deref(), Some("B"));
        assert_eq!(nearest("c").as_deref(), Some("C"));
        assert_eq!(named(NAMES, "C", "point").ok(), Some(2));
    }
}
