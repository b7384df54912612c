//! What the user asks of a picture.

use std::string::{String, ToString};
use std::vec::Vec;

use super::film::Film;
use super::still::Sketch;
use super::style::{Theme, Unit, WIDTH};

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
