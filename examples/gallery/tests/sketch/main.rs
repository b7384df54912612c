//! Drawings against the solvers: what a picture's text says is where the solver puts it.

mod bad_input;
mod bodies;
mod browser;
#[path = "../../../../linkage-core/src/cases.rs"]
mod cases;
#[path = "../chromium/mod.rs"]
mod chromium;
mod gaps;
mod layout;
mod loads;
mod look;
mod motion;
mod names;
mod placed;
mod placing;
mod searched;
mod site;
mod snapshots;
mod springs;
mod text;
mod xml;

use cases::cases;
use gallery::{Piece, pieces};

/// Every third machine of the gallery, and with `LINKAGE_WHOLE` every one.
fn sample() -> impl Iterator<Item = Piece> {
    pieces().into_iter().step_by(cases(3, 1))
}
