//! A mechanism that moves.

use core::fmt;
use std::boxed::Box;
use std::path::Path;
use std::string::String;
use std::vec::Vec;

use super::by_name::{self, LinkPose};
use super::options::Options;
use super::picture::Picture;
use super::plan::{Drawn, PlanOf};
use super::player;
use super::scene::Scene;
use super::sketch_error::SketchError;
use super::still::Still;
use super::style::Theme;
use super::svg::View;
use crate::{Point, SolveError};

/// A mechanism as it moves through a path of inputs.
///
/// A pose that cannot be assembled is a gap: dependents of the failed group are hidden, and the missing
/// length between its links is shown.
pub struct Film {
    scene: Scene,
    pub(super) options: Options,
    /// Solves the path again, the modes following the motion.
    follow: Box<dyn Fn() -> Scene>,
}

impl fmt::Debug for Film {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Film").field("scene", &self.scene).field("options", &self.options).finish()
    }
}

/// Poses one after the other that cannot be assembled, for one reason.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmGap {
    /// Their places in the path.
    pub poses: core::ops::Range<usize>,
    /// Why the first of them cannot.
    pub error: SolveError,
}

impl Film {
    /// The film of a solver; generated code calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn of<S: Drawn + 'static>(
        solver: S,
        path: impl IntoIterator<Item = impl Into<S::Input>>,
    ) -> Self
    where
        S::Input: 'static,
    {
        let inputs: Vec<S::Input> = path.into_iter().map(Into::into).collect();
        let mut scene = Scene::new(&PlanOf::<S>::PLAN);
        inputs.iter().for_each(|&q| push(&mut scene, &solver, q, None));
        let follow = move || {
            let mut scene = Scene::new(&PlanOf::<S>::PLAN);
            for (&q, (solver, error)) in inputs.iter().zip(solver.followed(&inputs)) {
                push(&mut scene, &solver, q, error);
            }
            scene
        };
        Self { scene, options: Options::default(), follow: Box::new(follow) }
    }

    /// Lets the assembly modes that are parameters follow the motion through change points, as
    /// [`Tracker`](crate::Tracker) does.
    #[must_use]
    pub fn following(mut self) -> Self {
        self.scene = (self.follow)();
        self
    }

    /// Lets the motion run back again.
    #[must_use]
    pub fn there_and_back(mut self) -> Self {
        self.scene = self.scene.there_and_back();
        self
    }

    /// Sets the duration of the motion, to the millisecond; 4 s by default. A number that is not positive and
    /// finite changes nothing.
    #[must_use]
    pub fn seconds(mut self, seconds: f64) -> Self {
        if seconds.is_finite() && seconds > 0.0 {
            // Rounded as it is written, so that all clocks agree.
            self.options.seconds = (1e3 * seconds.clamp(1e-3, 1e6)).round() / 1e3;
        }
        self
    }

    /// The duration of the motion, in seconds.
    #[must_use]
    pub const fn duration(&self) -> f64 {
        self.options.seconds
    }

    /// Shows so many poses at equal steps at once, all but the first faintly.
    #[must_use]
    pub const fn poses(mut self, count: usize) -> Self {
        self.options.poses = count;
        self
    }

    /// The first pose with traces and faint poses, six unless more or less were asked for, and no
    /// animation.
    #[must_use]
    pub fn still(&self) -> Still {
        let mut options = Options { is_still: true, ..self.options.clone() };
        if options.poses == Options::default().poses {
            options.poses = 6;
        }
        Still::of(self.scene.clone(), options)
    }

    /// The parts of the path where the mechanism cannot be assembled.
    #[must_use]
    pub fn gaps(&self) -> Vec<FilmGap> {
        let mut gaps: Vec<FilmGap> = Vec::new();
        for frame in self.scene.frames() {
            let Some(failure) = self.scene.failure(frame) else { continue };
            let same = |gap: &&mut FilmGap| {
                gap.poses.end == frame
                    && core::mem::discriminant(&gap.error)
                        == core::mem::discriminant(&failure.error)
            };
            match gaps.last_mut().filter(same) {
                Some(gap) => gap.poses.end = frame + 1,
                None => gaps.push(FilmGap { poses: frame..frame + 1, error: failure.error }),
            }
        }
        gaps
    }

    /// The number of poses.
    #[must_use]
    pub fn len(&self) -> usize {
        self.scene.len()
    }

    /// True if it has no poses.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The names of all points.
    #[must_use]
    pub const fn points(&self) -> &'static [&'static str] {
        self.scene.plan.points
    }

    /// The names of all links.
    #[must_use]
    pub const fn links(&self) -> &'static [&'static str] {
        self.scene.plan.links
    }

    /// Where a point is in a pose, in metres in ground axes.
    ///
    /// # Errors
    /// `UnknownName`; `EmptyPath` behind the last pose; `Solve` where the point is missing.
    pub fn point(&self, pose: usize, name: &str) -> Result<Point<f64>, SketchError> {
        by_name::point_of(&self.scene, pose, name)
    }

    /// Where a link is in a pose.
    ///
    /// # Errors
    /// As for [`point`](Self::point).
    pub fn link(&self, pose: usize, name: &str) -> Result<LinkPose, SketchError> {
        by_name::link_of(&self.scene, pose, name)
    }

    /// From metres in ground axes to pixels of the picture.
    ///
    /// # Errors
    /// `UnknownName` and `EmptyPath`.
    pub fn view(&self) -> Result<View, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.view)
    }

    /// The film as animated SVG, without scripts: it plays in any browser, also as an image.
    ///
    /// # Errors
    /// `UnknownName` for a trace, label or force of a point that is not; `EmptyPath`.
    pub fn to_svg(&self) -> Result<String, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.svg(true))
    }

    /// The same on paper of this colour.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg).
    pub fn to_svg_in(&self, theme: Theme) -> Result<String, SketchError> {
        let options = Options { theme, ..self.options.clone() };
        Ok(Picture::new(&self.scene, &options)?.svg(true))
    }

    /// Writes it.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg), and `Write`.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_svg()?)?)
    }

    /// The film on a page, light or dark as its reader wants it, with a button and a slider. It stands still
    /// at first for a reader who prefers reduced motion.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg).
    pub fn to_html(&self) -> Result<String, SketchError> {
        let picture = |width: f64| {
            let width = width.min(self.options.width);
            let options = Options { theme: Theme::Auto, width, ..self.options.clone() };
            let picture = Picture::new(&self.scene, &options)?;
            Ok::<_, SketchError>((picture.title(), picture.svg(true)))
        };
        let ((title, wide), (_, narrow)) = (picture(f64::MAX)?, picture(player::NARROW)?);
        Ok(player::page(&title, [&wide, &narrow], self.options.seconds))
    }

    /// Writes the page.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg), and `Write`.
    pub fn write_html(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_html()?)?)
    }
}

fn push<S: Drawn>(scene: &mut Scene, solver: &S, q: S::Input, refused: Option<SolveError>) {
    match (refused, solver.place(q)) {
        (None, Ok(numbers)) => scene.push(numbers, None),
        (Some(error), _) | (None, Err(error)) => {
            scene.push(solver.place_open(q, error.culprit()), Some(error));
        }
    }
}
