//! Jacobians by automatic differentiation, with the dual numbers of `num-dual`.

use nalgebra::SMatrix;
use num_dual::{Derivative, DualNum, DualSVec};

use crate::{Float, Scalar, SolveError};

/// The Jacobian of the rows with respect to `x`: a row an output, a column an input.
///
/// # Errors
/// Those of the rows; `Singular` where a derivative is not finite.
pub fn differentiate<F: Float + DualNum, const OUT: usize, const N: usize>(
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
    if jacobian.iter().all(|&entry| Scalar::is_finite(entry)) {
        Ok(jacobian)
    } else {
        Err(SolveError::Singular { group: "the derivative" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jacobian_has_a_row_an_output_and_a_column_an_input() {
        let polar = |[r, t]: [DualSVec<f64, 2>; 2]| {
            let (sin, cos) = Scalar::sin_cos(t);
            Ok([r * cos, r * sin, DualSVec::from_re(7.0)])
        };
        let jacobian = differentiate([2.0, 0.0], polar).unwrap();
        assert_eq!(jacobian, SMatrix::<f64, 3, 2>::new(1.0, 0.0, 0.0, 2.0, 0.0, 0.0));
        let line = differentiate([3.0_f32], |[x]| Ok([x * x])).unwrap();
        assert_eq!(line[(0, 0)], 6.0);
    }

    #[test]
    fn errors_and_infinite_derivatives_are_refused() {
        let error = SolveError::Singular { group: "BC, DC" };
        let refused = differentiate::<f64, 1, 1>([1.0], |_| Err(error));
        assert_eq!(refused, Err(error));
        let refused = differentiate([0.0], |[x]| Ok([Scalar::sqrt(x)]));
        assert_eq!(refused, Err(SolveError::Singular { group: "the derivative" }));
    }
}
