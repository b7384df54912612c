//! Jacobians by automatic differentiation, with the dual numbers of `num-dual`.

use nalgebra::SMatrix;
use num_dual::{Derivative, DualNum, DualNumFloat, DualSVec};

use crate::{Real, SolveError};

/// `f32` or `f64`, as what a dual number is made of.
pub trait Part: Real + DualNum + DualNumFloat {}

impl Part for f32 {}
impl Part for f64 {}

/// The Jacobian of the rows with respect to `x`: a row an output, a column an input.
///
/// # Errors
/// Those of the rows; `Singular` where a derivative is not finite.
pub fn differentiate<F: Part, const OUT: usize, const N: usize>(
    x: [F; N],
    rows: impl FnOnce([DualSVec<F, N>; N]) -> Result<[DualSVec<F, N>; OUT], SolveError>,
) -> Result<SMatrix<F, OUT, N>, SolveError> {
    let seeds = core::array::from_fn(|i| DualSVec::from_re(x[i]).derivative(i));
    let rows = rows(seeds)?;
    // A row without a derivative part does not depend on any input.
    let jacobian = SMatrix::<F, OUT, N>::from_fn(|i, j| match &rows[i].eps {
        Derivative(Some(gradient)) => gradient[j],
        _ => F::lit(0.0, 0.0),
    });
    if jacobian.iter().all(|&entry| <F as crate::Scalar>::is_finite(entry)) {
        Ok(jacobian)
    } else {
        Err(SolveError::Singular { group: "the derivative" })
    }
}
