//! A mechanism that stands still.

use std::path::Path;
use std::string::String;
use std::vec::Vec;

use super::by_name::{self, LinkPose};
use super::options::Options;
use super::picture::Picture;
use super::plan::{Drawn, Plan, PlanOf};
use super::scene::Scene;
use super::sketch_error::SketchError;
use super::style::Theme;
use super::svg::View;
use crate::{Point, SolveError};

/// The first pose of a film with traces and faint poses.
#[derive(Clone, Debug)]
pub struct Still {
    scene: Scene,
    pub(super) options: Options,
}

impl Still {
    pub(super) const fn of(scene: Scene, options: Options) -> Self {
        Self { scene, options }
    }

    /// The picture as SVG.
    ///
    /// # Errors
    /// `UnknownName` and `EmptyPath`.
    pub fn to_svg(&self) -> Result<String, SketchError> {
        Ok(Picture::new(&self.scene, &self.options)?.svg(false))
    }

    /// The same on paper of this colour.
    ///
    /// # Errors
    /// Those of [`to_svg`](Self::to_svg).
    pub fn to_svg_in(&self, theme: Theme) -> Result<String, SketchError> {
        let options = Options { theme, ..self.options.clone() };
        Ok(Picture::new(&self.scene, &options)?.svg(false))
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
    pub(super) options: Options,
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

    /// The pose of a plan whose numbers are known; programs without generated code call it.
    #[doc(hidden)]
    #[must_use]
    pub fn placed(plan: &'static Plan, numbers: Vec<f64>) -> Self {
        let mut scene = Scene::new(plan);
        scene.push(numbers, None);
        Self { scene, options: Options::default() }
    }

    /// Where a point is, in metres in ground axes.
    ///
    /// # Errors
    /// `UnknownName`.
    pub fn point(&self, name: &str) -> Result<Point<f64>, SketchError> {
        by_name::point_of(&self.scene, 0, name)
    }

    /// Where a link is.
    ///
    /// # Errors
    /// `UnknownName`.
    pub fn link(&self, name: &str) -> Result<LinkPose, SketchError> {
        by_name::link_of(&self.scene, 0, name)
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
