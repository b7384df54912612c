//! The figures of the language, one a statement: frames, signs, dimensions, modes. Every place in
//! them is a solver's.

mod annotations;
mod dyads;
mod placing;

pub use annotations::Figure;

use linkage_core::sketch::{SketchError, Theme};

/// Every figure by the name of its file.
///
/// # Errors
/// What cannot be drawn: a mistake in a figure.
pub fn figures(theme: Theme) -> Result<Vec<(&'static str, String)>, SketchError> {
    Ok(vec![
        ("crank", placing::crank(theme)?),
        ("slider", placing::slider(theme)?),
        ("rrr", dyads::rrr(theme)?),
        ("rrp", dyads::rrp(theme)?),
        ("rpr", dyads::rpr(theme)?),
        ("prp", dyads::prp(theme)?),
        ("rpp", dyads::rpp(theme)?),
        ("guide", placing::guide(theme)?),
        ("point", placing::point(theme)?),
        ("polar", placing::polar(theme)?),
    ])
}
