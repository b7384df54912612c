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
//! # Pages on which a mechanism is dragged
//!
//! ```
//! # use linkage_core::mechanism;
//! # mechanism! {
//! #     struct Rocker {
//! #         input theta: angle;
//! #         param crank = 80mm;
//! #         ground A(0, 0), D(665.7mm, 0);
//! #         crank AB(A) -> B        { length: crank, angle: theta }
//! #         rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
//! #         point blade on BC at (500mm, -60mm);
//! #     }
//! # }
//! let page = Rocker::new().page().title("A rocker").range("crank", 0.05..=0.2).rate("theta", 12.0);
//! let html = page.traces(["blade"]).curves(["blade", "DC"]).to_html()?;
//! assert!(html.contains("<title>A rocker</title>") && !html.contains("src="));
//! # Ok::<(), linkage_core::sketch::SketchError>(())
//! ```
//!
//! A [`Page`] is one HTML file: the macro prints the formulas as JavaScript, and the page's own script needs no
//! library and nothing of the network. A crank's pin turns its crank, also into a pose that cannot be
//! assembled, which shows what is missing; any other point takes the inputs with it that bring it nearest, and
//! stays where the machine ends. Arrow keys move the input, with Shift ten times as far; space plays. The
//! address holds the state, so that it can be sent. A length input needs a `range` or a `path`. Velocities,
//! accelerations and forces are those at a constant rate of the input that curves are drawn over. The numbers
//! are the solver's to the last bit, but for `tan`, `hypot` and angles beyond 2²⁰ rad, where browsers differ by a
//! unit in the last place; on targets with fused operations the solver itself rounds otherwise. An `unknown` is
//! searched as the solver searches it.
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
pub use page::Page;
#[doc(hidden)]
pub use page::{Declared, Paged};
pub use plan::{Applied, Drawn};
#[doc(hidden)]
pub use plan::{Element, Plan, Spring, applied, followed, place, place_open};
pub use sketch_error::SketchError;
pub use still::{Sketch, Still};
pub use style::{Palette, Theme, Unit};
pub use svg::View;
