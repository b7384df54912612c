//! The six-bar that is calibrated, its drawing, and the machine that was built from it.

use linkage_core::{SolveError, mechanism};

mechanism! {
    /// A crank-rocker whose coupler point drives a second rocker. The defaults are the drawing's.
    pub(crate) struct SixBar {
        /// What the encoder on the crank reads.
        input theta: angle;

        param ax = 0mm;
        param ay = 0mm;
        param dx = 300mm;
        param dy = 0mm;
        param gx = 150mm;
        param gy = 350mm;
        param crank = 80mm;
        param coupler = 260mm;
        param rocker = 200mm;
        param ex = 150mm;
        param ey = 110mm;
        param link = 180mm;
        param lever = 140mm;
        /// The crank's angle where the encoder reads zero.
        param zero = 0deg;

        ground A(ax, ay), D(dx, dy), G(gx, gy);

        crank AB(A) -> B        { length: crank, angle: theta + zero }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        point E on BC at (ex, ey);
        rrr   EF(E), GF(G) -> F { lengths: (link, lever), mode: right }

        output C, E, F;
    }
}

/// The number of unknown dimensions.
pub(crate) const UNKNOWNS: usize = SixBar::PARAMS.len();

/// The number of coordinates tracked at each pose: those of the pins C, E and F.
pub(crate) const TRACKED: usize = SixBar::OUTPUTS.len();

/// In the order of `SixBar::PARAMS`: metres, the last one radians.
pub(crate) type Dimensions = [f64; UNKNOWNS];

/// The six-bar with these dimensions.
pub(crate) fn six_bar(dimensions: Dimensions) -> SixBar {
    let [ax, ay, dx, dy, gx, gy, crank, coupler, rocker, ex, ey, link, lever, zero] = dimensions;
    SixBar { ax, ay, dx, dy, gx, gy, crank, coupler, rocker, ex, ey, link, lever, zero }
}

/// The dimensions of a six-bar.
fn dimensions(bars: SixBar) -> Dimensions {
    let SixBar { ax, ay, dx, dy, gx, gy, crank, coupler, rocker, ex, ey, link, lever, zero } = bars;
    [ax, ay, dx, dy, gx, gy, crank, coupler, rocker, ex, ey, link, lever, zero]
}

/// The dimensions on the drawing.
pub(crate) fn drawn() -> Dimensions {
    dimensions(SixBar::new())
}

/// The dimensions as built: up to 1.5 mm and 0.7° off the drawing. A calibration does not know them.
pub(crate) fn built() -> Dimensions {
    const OFF: Dimensions = [
        0.8e-3, -0.5e-3, 1.2e-3, 0.4e-3, -0.9e-3, 1.1e-3, 0.3e-3, -0.7e-3, 0.6e-3, 1.0e-3, -1.5e-3,
        -0.4e-3, 0.5e-3, 12e-3,
    ];
    let drawn = drawn();
    core::array::from_fn(|i| drawn[i] + OFF[i])
}

/// The tracked coordinates at an encoder's reading.
pub(crate) fn tracked(dimensions: Dimensions, theta: f64) -> Result<[f64; TRACKED], SolveError> {
    Ok(six_bar(dimensions).position(theta)?.rows())
}
