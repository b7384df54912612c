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
    let ink = annotations::Ink::of(theme);
    Ok(vec![
        ("crank", placing::crank(ink)?),
        ("slider", placing::slider(ink)?),
        ("rrr", dyads::rrr(ink)?),
        ("rrp", dyads::rrp(ink)?),
        ("rpr", dyads::rpr(ink)?),
        ("prp", dyads::prp(ink)?),
        ("rpp", dyads::rpp(ink)?),
        ("guide", placing::guide(ink)?),
        ("point", placing::point(ink)?),
        ("polar", placing::polar(ink)?),
    ])
}
