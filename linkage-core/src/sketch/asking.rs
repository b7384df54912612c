//! The methods by which a user asks for parts of a picture: one list for films, stills and sketches.

use std::string::ToString;
use std::vec::Vec;

use super::film::Film;
use super::options::{applied, reactions};
use super::plan::Applied;
use super::still::{Sketch, Still};
use super::style::{Theme, Unit};
use crate::{Record, SolveError};

macro_rules! asked_of_a_picture {
    ($($picture:ident)*) => {$(
        impl $picture {
            /// Draws the path of a point, with dots at twelve equal steps.
            #[must_use]
            pub fn trace(mut self, point: &str) -> Self {
                self.options.traces.push(point.to_string());
                self
            }

            /// Names these points and no others. By default, points are named where there is room.
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
                self.options.loads.forces.push((point.to_string(), forces));
                self
            }

            /// Draws an arc with an arrow for a couple about a point, in newton metres, counter-clockwise
            /// positive: one for each pose, or one for all.
            #[must_use]
            pub fn couple(mut self, point: &str, couples: impl IntoIterator<Item = f64>) -> Self {
                let couples = couples.into_iter().collect();
                self.options.loads.couples.push((point.to_string(), couples));
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
                self.options.loads.reactions.extend(reactions(results));
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
                self.options.loads.forces.extend(applied(results));
                self
            }

            /// The colours; those that the reader prefers if nothing is said.
            #[must_use]
            pub const fn theme(mut self, theme: Theme) -> Self {
                self.options.theme = theme;
                self
            }

            /// The largest width of the picture, in pixels: 200 to 4000; 720 by default.
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

asked_of_a_picture!(Film Sketch Still);
