//! A mechanism that moves.

use core::fmt;
use std::boxed::Box;
use std::path::Path;
use std::string::{String, ToString};
use std::vec::Vec;

use super::error::SketchError;
use super::picture::{Options, Picture};
use super::plan::Drawn;
use super::scene::Scene;
use super::style::{Theme, Unit};
use super::svg::View;
use super::{LinkPose, page};
use crate::{Point, SolveError, Tracker};

/// A mechanism as it moves through a path of inputs.
///
/// A pose that cannot be assembled is a gap: what hangs on the failed group is not shown, and what
/// is missing between its links is.
pub struct Film {
    scene: Scene,
    options: Options,
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
            let (mut scene, mut tracker) = (Scene::new(&PlanOf::<S>::PLAN), Tracker::new(solver));
            for &q in &inputs {
                let error = tracker.position(q).err();
                let solver = *tracker.solver();
                push(&mut scene, &solver, q, error);
            }
            scene
        };
        Self { scene, options: Options::default(), follow: Box::new(follow) }
    }

    /// Lets the assembly modes that are parameters follow the motion through change points, as
    /// [`Tracker`] does.
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

    /// How long the motion takes; 4 s if nothing is said. What is no positive number says nothing.
    #[must_use]
    pub fn seconds(mut self, seconds: f64) -> Self {
        if seconds.is_finite() && seconds > 0.0 {
            self.options.seconds = seconds.clamp(1e-3, 1e6);
        }
        self
    }

    /// How long the motion takes, in seconds.
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
        let mut options = self.options.clone();
        if options.poses == Options::default().poses {
            options.poses = 6;
        }
        Still { scene: self.scene.clone(), options }
    }

    /// What cannot be assembled on the path.
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

    /// How many poses it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.scene.len()
    }

    /// Whether it has none.
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
        super::point_of(&self.scene, pose, name)
    }

    /// Where a link is in a pose.
    ///
    /// # Errors
    /// As for [`point`](Self::point).
    pub fn link(&self, pose: usize, name: &str) -> Result<LinkPose, SketchError> {
        super::link_of(&self.scene, pose, name)
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

    /// The film on a page, light or dark as its reader wants it, with a button and a slider.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg).
    pub fn to_html(&self) -> Result<String, SketchError> {
        let picture = |theme| {
            let options = Options { theme, ..self.options.clone() };
            let picture = Picture::new(&self.scene, &options)?;
            Ok::<_, SketchError>((picture.title(), picture.svg(true)))
        };
        let ((title, light), (_, dark)) = (picture(Theme::Light)?, picture(Theme::Dark)?);
        Ok(page::page(&title, &light, &dark, self.options.seconds))
    }

    /// Writes the page.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg), and `Write`.
    pub fn write_html(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_html()?)?)
    }
}

/// The first pose of a film with traces and faint poses.
#[derive(Clone, Debug)]
pub struct Still {
    scene: Scene,
    options: Options,
}

impl Still {
    /// The picture as SVG.
    ///
    /// # Errors
    /// `UnknownName` and `EmptyPath`.
    pub fn to_svg(&self) -> Result<String, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.svg(false))
    }

    /// Writes it.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg), and `Write`.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_svg()?)?)
    }
}

/// A mechanism in one pose.
#[derive(Clone, Debug)]
pub struct Sketch {
    scene: Scene,
    options: Options,
}

impl Sketch {
    /// The pose of a solver; generated code calls it.
    ///
    /// # Errors
    /// The first group that cannot be assembled.
    #[doc(hidden)]
    pub fn of<S: Drawn>(solver: &S, q: S::Input) -> Result<Self, SolveError> {
        let mut scene = Scene::new(&PlanOf::<S>::PLAN);
        scene.push(solver.place(q)?, None);
        Ok(Self { scene, options: Options::default() })
    }

    /// Where a point is, in metres in ground axes.
    ///
    /// # Errors
    /// `UnknownName`.
    pub fn point(&self, name: &str) -> Result<Point<f64>, SketchError> {
        super::point_of(&self.scene, 0, name)
    }

    /// Where a link is.
    ///
    /// # Errors
    /// `UnknownName`.
    pub fn link(&self, name: &str) -> Result<LinkPose, SketchError> {
        super::link_of(&self.scene, 0, name)
    }

    /// From metres in ground axes to pixels of the picture.
    ///
    /// # Errors
    /// `UnknownName`.
    pub fn view(&self) -> Result<View, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.view)
    }

    /// The picture as SVG.
    ///
    /// # Errors
    /// `UnknownName` for a trace, label or force of a point that is not.
    pub fn to_svg(&self) -> Result<String, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.svg(false))
    }

    /// Writes it.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg), and `Write`.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_svg()?)?)
    }
}

macro_rules! asked_of_a_picture {
    ($($picture:ident)*) => {$(
        impl $picture {
            /// Draws the path of a point, with dots at twelve equal steps.
            #[must_use]
            pub fn trace(mut self, point: &str) -> Self {
                self.options.traces.push(point.to_string());
                self
            }

            /// Names these points and no others. What is not said is named where there is room.
            #[must_use]
            pub fn label<N: AsRef<str>>(mut self, points: impl IntoIterator<Item = N>) -> Self {
                let names = points.into_iter().map(|name| name.as_ref().to_string());
                self.options.labels = Some(names.collect());
                self
            }

            /// Names no point.
            #[must_use]
            pub fn unlabelled(mut self) -> Self {
                self.options.labels = Some(Vec::new());
                self
            }

            /// Draws an arrow for a force on a point, in newtons in ground axes: one for each pose,
            /// or one for all.
            #[must_use]
            pub fn force(mut self, point: &str, forces: impl IntoIterator<Item = [f64; 2]>) -> Self {
                let forces = forces.into_iter().collect();
                self.options.forces.push((point.to_string(), forces));
                self
            }

            /// Light or dark; light if nothing is said.
            #[must_use]
            pub const fn theme(mut self, theme: Theme) -> Self {
                self.options.theme = theme;
                self
            }

            /// How wide the picture may be, in pixels: 200 to 4000; 720 if nothing is said.
            #[must_use]
            pub const fn width(mut self, pixels: f64) -> Self {
                if pixels.is_finite() {
                    self.options.width = pixels.clamp(200.0, 4000.0);
                }
                self
            }

            /// The unit of what is written: the scale and missing distances.
            #[must_use]
            pub const fn unit(mut self, unit: Unit) -> Self {
                self.options.unit = Some(unit);
                self
            }

            /// Leaves the scale out.
            #[must_use]
            pub const fn without_scale(mut self) -> Self {
                self.options.has_scale = false;
                self
            }

            /// A heading.
            #[must_use]
            pub fn title(mut self, title: &str) -> Self {
                self.options.title = Some(title.to_string());
                self
            }
        }
    )*};
}

asked_of_a_picture!(Film Sketch);

/// The plan as a constant in memory.
struct PlanOf<S>(core::marker::PhantomData<S>);

impl<S: Drawn> PlanOf<S> {
    const PLAN: super::plan::Plan = S::PLAN;
}

fn push<S: Drawn>(scene: &mut Scene, solver: &S, q: S::Input, refused: Option<SolveError>) {
    match (refused, solver.place(q)) {
        (None, Ok(numbers)) => scene.push(numbers, None),
        (Some(error), _) | (None, Err(error)) => scene.push(solver.place_open(q), Some(error)),
    }
}
