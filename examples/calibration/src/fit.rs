//! Dimensions from measurements by least squares, with confidence intervals.
//!
//! With residuals r and their derivatives J by the dimensions, which are the mechanism's exact
//! sensitivities, Levenberg and Marquardt's method finds the dimensions of least ‖r‖². If the noise
//! is independent and of one size, that is estimated by s² = ‖r‖²/ν, ν being the residuals less the
//! dimensions, and the covariance of the dimensions by s² (JᵀJ)⁻¹ (Bates and Watts, Nonlinear
//! Regression Analysis, 1988, chapter 2).

use basin::{
    ConstraintDescription, ConstraintSet, Constraints, DenseMatrix, Executor, Jacobian,
    LevenbergMarquardt, NoConstraints, PointState, Residual,
};
use linkage_core::SolveError;
use nalgebra::SMatrix;

use super::machine::{Dimensions, UNKNOWNS, drawn, six_bar, tracked};
use super::measurement::Measurement;

/// The result of a calibration.
#[derive(Clone, Debug)]
pub(crate) struct Calibration {
    pub(crate) dimensions: Dimensions,
    /// The true dimensions lie within this of the found ones in 95 of 100 calibrations.
    pub(crate) half_widths: Dimensions,
    /// The estimated deviation of the noise, in metres.
    pub(crate) noise: f64,
    pub(crate) iterations: u64,
}

/// Seen coordinates that dimensions shall explain.
struct Unexplained<'a>(&'a Measurement);

/// The method asks for dimensions in a vector of its own.
fn fixed(dimensions: &[f64]) -> Dimensions {
    core::array::from_fn(|i| dimensions[i])
}

impl Unexplained<'_> {
    fn residuals(&self, dimensions: Dimensions) -> Result<Vec<f64>, SolveError> {
        let mut residuals = Vec::new();
        for (theta, seen) in self.0.thetas.iter().zip(&self.0.seen) {
            let explained = tracked(dimensions, *theta)?;
            residuals.extend(explained.iter().zip(seen).map(|(explained, seen)| explained - seen));
        }
        Ok(residuals)
    }

    /// A row for each residual, row after row.
    fn slopes(&self, dimensions: Dimensions) -> Result<Vec<f64>, SolveError> {
        let bars = six_bar(dimensions);
        let mut slopes = Vec::new();
        for theta in &self.0.thetas {
            let sensitivity = bars.sensitivity(*theta)?;
            slopes.extend(
                sensitivity.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()),
            );
        }
        Ok(slopes)
    }
}

impl Residual for Unexplained<'_> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = SolveError;

    fn residual(&self, dimensions: &Vec<f64>) -> Result<Vec<f64>, SolveError> {
        self.residuals(fixed(dimensions))
    }
}

impl Jacobian for Unexplained<'_> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, dimensions: &Vec<f64>) -> Result<DenseMatrix, SolveError> {
        let slopes = self.slopes(fixed(dimensions))?;
        Ok(DenseMatrix::from_row_slice(slopes.len() / UNKNOWNS, UNKNOWNS, &slopes))
    }
}

impl Constraints for Unexplained<'_> {
    type Set = NoConstraints;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new()
    }
}

/// Calibrates, starting from the drawing.
///
/// # Errors
/// Those of the mechanism, where the search leaves the dimensions that can be assembled; `Singular`
/// where the measurements do not determine the dimensions.
pub(crate) fn calibrate(measurement: &Measurement) -> Result<Calibration, SolveError> {
    let start = PointState::new(drawn().to_vec());
    let method = LevenbergMarquardt::new();
    let result = Executor::new(Unexplained(measurement), method, start).max_iter(100).run()?;
    let dimensions = fixed(result.param());
    let (half_widths, noise) = uncertainty(&Unexplained(measurement), dimensions)?;
    Ok(Calibration { dimensions, half_widths, noise, iterations: result.iter() })
}

/// Half widths of the 95 % intervals, and the noise.
fn uncertainty(
    problem: &Unexplained<'_>,
    dimensions: Dimensions,
) -> Result<(Dimensions, f64), SolveError> {
    let (residuals, slopes) = (problem.residuals(dimensions)?, problem.slopes(dimensions)?);
    let mut squares = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::zeros();
    for row in slopes.chunks(UNKNOWNS) {
        squares += SMatrix::from_fn(|i, j| row[i] * row[j]);
    }
    let undetermined = SolveError::Singular { group: "the dimensions" };
    let inverse = squares.cholesky().ok_or(undetermined)?.inverse();
    let freedom = (residuals.len() - UNKNOWNS) as f64;
    let variance = residuals.iter().map(|residual| residual * residual).sum::<f64>() / freedom;
    let half_width = |i: usize| quantile(freedom) * (variance * inverse[(i, i)]).sqrt();
    Ok((core::array::from_fn(half_width), variance.sqrt()))
}

/// The 97.5 % quantile of Student's distribution by its series in 1/ν (Abramowitz and Stegun
/// 26.7.5), good to five digits from ν = 30 on.
fn quantile(freedom: f64) -> f64 {
    let x = 1.959_963_985_f64;
    let first = (x.powi(3) + x) / 4.0;
    let second = (5.0 * x.powi(5) + 16.0 * x.powi(3) + 3.0 * x) / 96.0;
    x + first / freedom + second / (freedom * freedom)
}
