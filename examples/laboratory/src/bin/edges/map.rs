//! The map that a five-bar's hand is moved over.

/// The points of a square map.
pub(crate) fn map([x, y]: [f64; 2], half: f64, across: u32) -> impl Iterator<Item = [f64; 2]> {
    let at = move |step: u32| half * (2.0 * f64::from(step) / f64::from(across - 1) - 1.0);
    (0..across * across).map(move |nth| [x + at(nth % across), y + at(nth / across)])
}
