//! Pictures and films of mechanisms, drawn from their declarations by the symbols of kinematic
//! diagrams (feature `sketch`).
//!
//! ```
//! use linkage_core::mechanism;
//! use std::f64::consts::TAU;
//!
//! mechanism! {
//!     /// A crank-rocker.
//!     struct Rocker {
//!         input theta: angle;
//!         ground A(0, 0), D(665.7mm, 0);
//!         crank AB(A) -> B        { length: 80mm, angle: theta }
//!         rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
//!         point blade on BC at (500mm, -60mm);
//!     }
//! }
//!
//! let rocker = Rocker::new();
//! let still = rocker.sketch(2.0)?.to_svg()?;
//! let turn = (0..=120).map(|k| f64::from(k) * TAU / 120.0);
//! let film = rocker.film(turn).trace("blade").seconds(3.0);
//! assert!(still.len() < 8_000 && film.to_svg()?.len() < 40_000);
//! assert!(film.gaps().is_empty());
//! # Ok::<(), linkage_core::sketch::SketchError>(())
//! ```
//!
//! Everything declared is drawn, whether an output asks for it or not. A film is animated SVG
//! without scripts (SMIL): it plays in a browser, also as an image on a page. A pose that cannot be
//! assembled is a gap of the film, never bridged: how far the links of the failed group reach is
//! shown instead, and what is missing between them.
//!
//! Springs and dampers between two points are drawn as such, torsion springs are not. A path of inputs
//! does not determine forces, whose values may depend on loads and rates: pass the solver's results.
//! `film.applied(path.map(|q| solver.applied(q, rate, load)))` draws what the declaration's `force`
//! statements put on points, `film.reactions(path.map(|q| solver.statics(q, load)))` the reactions of
//! joints that its outputs ask for, `film.force("P", …)` any other, `film.couple("A", …)` couples as arcs.
//! A still writes each value beside its arrow, a film the largest of each below.
//!
//! One picture suits light and dark pages: a browser replaces its colours where the reader prefers a dark
//! scheme, other programs show it light. `theme` fixes either.
//!
//! With the feature `page`, `page` of a solver writes an HTML file on which the mechanism is dragged.
//!
//! # Units
//!
//! Lengths are in metres, coordinates those of the ground, forces in newtons. Pictures are at most
//! 720 pixels wide and 640 high, but for texts, to one scale in both directions.

mod asking;
mod bodies;
mod boxes;
mod by_name;
mod drawn;
mod film;
mod forces;
mod gaps;
mod labels;
mod member;
mod options;
#[cfg(feature = "page")]
mod page;
mod picture;
mod placing;
mod plan;
mod player;
mod sketch_error;

mod scene;
mod shapes;
mod springs;
mod still;
mod style;
mod svg;
mod symbols;
mod traces;

pub use by_name::LinkPose;
pub use film::{Film, FilmGap};
#[doc(hidden)]
pub use member::Member;
#[cfg(feature = "page")]
pub use page::Page;
#[cfg(feature = "page")]
#[doc(hidden)]
pub use page::{Declared, Machine, Paged, Wishes, html, html_of_sets, shortened};
pub use plan::{Applied, Drawn};
#[doc(hidden)]
pub use plan::{Element, Plan, Spring, applied, followed, place, place_open};
pub use sketch_error::SketchError;
pub use still::{Sketch, Still};
pub use style::{Palette, Theme, Unit};
pub use svg::View;
