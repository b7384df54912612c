//! Dimensions from measurements by least squares, with confidence intervals.
//!
//! A calibration is a design whose aim is that the machine explains what was seen. If the noise is independent
//! and of one size, the deviations of the found dimensions are those that `linkage-design` estimates from what
//! remains of the residuals.

use linkage_design::{DesignError, LeastSquares, free};

use super::machine::{Dimensions, SixBar, TRACKED, UNKNOWNS, drawn};
use super::measurement::Measurement;

/// The result of a calibration.
#[derive(Clone, Debug)]
pub(crate) struct Calibration {
    pub(crate) dimensions: Dimensions,
    /// The true dimensions lie within this of the found ones in 95 of 100 calibrations.
    pub(crate) half_widths: Dimensions,
    /// The estimated deviation of the noise, in metres.
    pub(crate) noise: f64,
}

/// No dimension is off by more than this, in metres and radians.
const OFF: f64 = 0.02;

/// Calibrates, starting from the drawing.
///
/// # Errors
/// `Undetermined` where the measurements do not determine the dimensions.
pub(crate) fn calibrate(measurement: &Measurement) -> Result<Calibration, DesignError> {
    let poses = measurement.thetas.iter().copied().zip(measurement.seen.iter().copied());
    let design = free!(
        SixBar: ax, ay, dx, dy, gx, gy, crank, coupler, rocker, ex, ey, link, lever, zero
    );
    let found = design
        .within(drawn().map(|drawn| drawn - OFF..=drawn + OFF))
        .aim("what was seen", poses, |bars, (theta, seen)| {
            let explained = bars.position(theta.into())?.rows();
            Ok(core::array::from_fn::<_, TRACKED, _>(|i| explained[i] - seen[i]))
        })
        .kernel(LeastSquares::default())
        .run()?;
    let freedom = (measurement.thetas.len() * TRACKED) as f64 - UNKNOWNS as f64;
    let deviations = found.deviations()?;
    Ok(Calibration {
        dimensions: found.values,
        half_widths: deviations.map(|deviation| quantile(freedom) * deviation),
        noise: (found.cost / freedom).sqrt(),
    })
}

/// The 97.5 % quantile of Student's distribution by its series in 1/ν (Abramowitz and Stegun
/// 26.7.5), good to five digits from ν = 30 on.
fn quantile(freedom: f64) -> f64 {
    let x = 1.959_963_985_f64;
    let first = (x.powi(3) + x) / 4.0;
    let second = (5.0 * x.powi(5) + 16.0 * x.powi(3) + 3.0 * x) / 96.0;
    x + first / freedom + second / (freedom * freedom)
}
