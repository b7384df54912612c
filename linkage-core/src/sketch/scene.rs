//! The poses of a mechanism: where everything stands in each, and what is missing in some.

use std::vec;
use std::vec::Vec;

use super::plan::{Element, Layout, Plan};
use crate::SolveError;

/// Origin and unit vector along x, in ground axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub origin: [f64; 2],
    pub cos: f64,
    pub sin: f64,
}

impl Pose {
    /// Where a place of the frame is in ground axes.
    pub(super) fn place(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [ox, oy] = self.origin;
        [ox + self.cos * x - self.sin * y, oy + self.sin * x + self.cos * y]
    }

    /// Where a place of the ground is in the frame.
    pub(super) fn local(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.origin[0], y - self.origin[1]);
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    /// Another frame as this one sees it.
    pub(super) fn local_pose(self, other: Self) -> Self {
        Self {
            origin: self.local(other.origin),
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.cos * other.sin - self.sin * other.cos,
        }
    }

    pub(super) fn moved_to(self, origin: [f64; 2]) -> Self {
        Self { origin, ..self }
    }
}

/// One pose of the mechanism.
#[derive(Clone, Debug)]
struct Frame {
    /// Its place in the path.
    pose: usize,
    numbers: Vec<f64>,
    failure: Option<Failure>,
    /// True for each point that can be drawn; the same for links and guides.
    points: Vec<bool>,
    links: Vec<bool>,
    guides: Vec<bool>,
}

/// Why a pose is not whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Failure {
    pub error: SolveError,
    /// The place of the failed statement, where it is one's failure.
    pub statement: Option<usize>,
}

/// A mechanism in one pose or many.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    pub plan: &'static Plan,
    layout: Layout,
    frames: Vec<Frame>,
}

impl Scene {
    pub(super) fn new(plan: &'static Plan) -> Self {
        Self { plan, layout: Layout::of(plan), frames: Vec::new() }
    }

    /// One more pose; with an error what can be placed nevertheless.
    pub(super) fn push(&mut self, numbers: Vec<f64>, error: Option<SolveError>) {
        let failure = error.map(|error| Failure { error, statement: self.failed(error) });
        let plan = self.plan;
        let all = |count: usize| vec![true; count];
        let (points, links, guides) =
            (all(plan.points.len()), all(plan.links.len()), all(plan.guides.len()));
        let pose = self.frames.len();
        let mut frame = Frame { pose, numbers, failure, points, links, guides };
        if failure.is_some() {
            self.leave_out(&mut frame);
        }
        self.frames.push(frame);
    }

    fn failed(&self, error: SolveError) -> Option<usize> {
        let (SolveError::OutOfReach { group, .. }
        | SolveError::Singular { group }
        | SolveError::Invalid { group, .. }) = error
        else {
            return None;
        };
        let mut titles = self.plan.statements.iter().map(|&made| self.plan.title(made));
        titles.position(|title| title == group)
    }

    /// Hides failed, dependent and non-finite parts.
    fn leave_out(&self, frame: &mut Frame) {
        let statement = frame.failure.and_then(|failure| failure.statement);
        for (nth, &made) in self.plan.statements.iter().enumerate() {
            let stands = made.outer().iter().all(|&point| frame.points[point])
                && made.slides().iter().all(|&(_, guide)| frame.guides[guide])
                && made.carrier().is_none_or(|link| frame.links[link])
                && statement != Some(nth);
            let of_links = made.links();
            for &link in &of_links {
                let at = self.layout.links + 5 * link;
                frame.links[link] = stands && are_finite(&frame.numbers, at, 5);
            }
            let has_links = of_links.iter().all(|&link| frame.links[link]);
            if let Some(point) = made.point() {
                frame.points[point] =
                    stands && has_links && are_finite(&frame.numbers, 2 * point, 2);
            }
            if let Element::Guide(guide, _) = made {
                let at = self.layout.guides + 4 * guide;
                frame.guides[guide] = stands && are_finite(&frame.numbers, at, 4);
            }
        }
    }

    pub(super) fn len(&self) -> usize {
        self.frames.len()
    }

    /// The poses, by their places.
    pub(super) fn frames(&self) -> core::ops::Range<usize> {
        0..self.frames.len()
    }

    /// The place in the path of what a frame shows: back again the path is gone through twice.
    pub(super) fn pose(&self, frame: usize) -> usize {
        self.frames[frame].pose
    }

    pub(super) fn failure(&self, frame: usize) -> Option<Failure> {
        self.frames[frame].failure
    }

    /// All poses, and back again.
    pub(super) fn there_and_back(&self) -> Self {
        let back = self.frames.iter().rev().skip(1);
        Self { frames: self.frames.iter().chain(back).cloned().collect(), ..*self }
    }

    pub(super) fn point(&self, frame: usize, point: usize) -> Option<[f64; 2]> {
        let frame = &self.frames[frame];
        let at = 2 * point;
        frame.points[point].then(|| [frame.numbers[at], frame.numbers[at + 1]])
    }

    pub(super) fn link(&self, frame: usize, link: usize) -> Option<Pose> {
        let frame = &self.frames[frame];
        frame.links[link].then(|| pose(&frame.numbers, self.layout.links + 5 * link))
    }

    pub(super) fn slide(&self, frame: usize, link: usize) -> Option<f64> {
        let frame = &self.frames[frame];
        frame.links[link].then(|| frame.numbers[self.layout.links + 5 * link + 4])
    }

    pub(super) fn guide(&self, frame: usize, guide: usize) -> Option<Pose> {
        let frame = &self.frames[frame];
        frame.guides[guide].then(|| pose(&frame.numbers, self.layout.guides + 4 * guide))
    }

    /// A length or an offset of a statement.
    pub(super) fn dimension(&self, frame: usize, statement: usize, nth: usize) -> f64 {
        let before = self.plan.statements[..statement].iter();
        let before: usize = before.map(|made| made.dimensions()).sum();
        self.frames[frame].numbers[self.layout.dimensions + before + nth]
    }

    /// Where a point is on a link, if it stands still there.
    pub(super) fn on_link(&self, link: usize, point: usize) -> Option<[f64; 2]> {
        constant(self.frames().map(|f| Some(self.link(f, link)?.local(self.point(f, point)?))))
    }

    /// Where a guide lies on a link, if it lies still there.
    pub(super) fn guide_on_link(&self, link: usize, guide: usize) -> Option<Pose> {
        let seen = |f| Some(self.link(f, link)?.local_pose(self.guide(f, guide)?));
        constant_pose(self.frames().map(seen))
    }

    /// Where a frame lies, if it lies still.
    pub(super) fn still(&self, guide: usize) -> Option<Pose> {
        constant_pose(self.frames().map(|f| self.guide(f, guide)))
    }

    /// From where to where links slide on a guide.
    pub(super) fn travel(&self, guide: usize) -> Option<[f64; 2]> {
        let on_it = |&(_, on): &(usize, usize)| on == guide;
        let links = self.plan.statements.iter().flat_map(|made| made.slides()).filter(on_it);
        let slides = links.flat_map(|(link, _)| self.frames().map(move |f| self.slide(f, link)));
        range(slides)
    }

    /// From where to where a link slides.
    pub(super) fn travel_of(&self, link: usize) -> Option<[f64; 2]> {
        range(self.frames().map(|f| self.slide(f, link)))
    }
}

fn pose(numbers: &[f64], at: usize) -> Pose {
    Pose { origin: [numbers[at], numbers[at + 1]], cos: numbers[at + 2], sin: numbers[at + 3] }
}

fn are_finite(numbers: &[f64], at: usize, count: usize) -> bool {
    numbers[at..at + count].iter().all(|number| number.is_finite())
}

/// The least and the greatest.
pub(super) fn range(values: impl Iterator<Item = Option<f64>>) -> Option<[f64; 2]> {
    values.flatten().fold(None, |range, value| {
        let [low, high] = range.unwrap_or([value; 2]);
        Some([value.min(low), value.max(high)])
    })
}

/// The spot that all known spots share, to a billionth of its size; none if they differ.
fn constant(mut seen: impl Iterator<Item = Option<[f64; 2]>>) -> Option<[f64; 2]> {
    let first = seen.by_ref().flatten().next()?;
    let size = 1e-9 * (first[0].abs() + first[1].abs()) + 1e-12;
    let is_near = |other: [f64; 2]| {
        (other[0] - first[0]).abs() <= size && (other[1] - first[1]).abs() <= size
    };
    seen.flatten().all(is_near).then_some(first)
}

fn constant_pose(seen: impl Iterator<Item = Option<Pose>> + Clone) -> Option<Pose> {
    let origin = constant(seen.clone().map(|pose| Some(pose?.origin)))?;
    let [cos, sin] = constant(seen.map(|pose| Some([pose?.cos, pose?.sin])))?;
    Some(Pose { origin, cos, sin })
}
