//! What the user asks of a picture.

use std::string::{String, ToString};
use std::vec::Vec;

use super::film::Film;
use super::plan::Applied;
use super::still::Sketch;
use super::style::{Theme, Unit, WIDTH};
use crate::{Record, SolveError};

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
    /// Whether nothing but the first pose is drawn in full.
    pub is_still: bool,
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
            is_still: false,
            seconds: 4.0,
        }
    }
}

/// The reactions by their joints, no numbers where there is no result.
fn reactions<R: Record<Number = f64>>(
    results: impl IntoIterator<Item = Result<R, SolveError>>,
) -> Vec<(String, Vec<[f64; 2]>)> {
    let mut found: Vec<(&str, Vec<[f64; 2]>)> = Vec::new();
    let mut count = 0;
    for result in results {
        // A path of two names is a link and its joint; what shakes the ground has one.
        let joints =
            result.into_iter().flat_map(Record::points).filter(|(path, _)| path.contains('.'));
        for (path, force) in joints {
            let known = found.iter().position(|(name, _)| *name == path);
            let place = known.unwrap_or_else(|| {
                found.push((path, Vec::new()));
                found.len() - 1
            });
            found[place].1.resize(count, [f64::NAN; 2]);
            found[place].1.push([force.x, force.y]);
        }
        count += 1;
    }
    let joint = |path: &str| path.rsplit('.').next().unwrap_or_default().to_string();
    found
        .into_iter()
        .map(|(path, mut forces)| {
            forces.resize(count, [f64::NAN; 2]);
            (joint(path), forces)
        })
        .collect()
}

/// The applied forces in the order of the declaration, no numbers where there is no result.
fn applied(
    results: impl IntoIterator<Item = Result<Applied, SolveError>>,
) -> Vec<(String, Vec<[f64; 2]>)> {
    let results: Vec<_> = results.into_iter().map(Result::ok).collect();
    let Some(first) = results.iter().flatten().next() else { return Vec::new() };
    let force = |(nth, (point, _)): (usize, &(&str, _))| {
        let of = |result: &Option<Applied>| Some(result.as_ref()?.forces.get(nth)?.1);
        let forces = results.iter().map(|result| of(result).unwrap_or([f64::NAN; 2]));
        (point.to_string(), forces.collect())
    };
    first.forces.iter().enumerate().map(force).collect()
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

            /// Draws the reactions of joints that the results of `forces` or `statics` hold, one result for
            /// each pose: which there are, the declaration's outputs say. There are no arrows where
            /// there is no result, and none for guides.
            #[must_use]
            pub fn reactions<R: Record<Number = f64>>(
                mut self,
                results: impl IntoIterator<Item = Result<R, SolveError>>,
            ) -> Self {
                self.options.forces.extend(reactions(results));
                self
            }

            /// Draws the forces that the declaration puts on points, one result of the solver's `applied`
            /// for each pose. They are asked of the solver, since their values may hold loads and rates,
            /// of which a path of inputs says nothing. Torques have no arrows.
            #[must_use]
            pub fn applied(
                mut self,
                results: impl IntoIterator<Item = Result<Applied, SolveError>>,
            ) -> Self {
                self.options.forces.extend(applied(results));
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
