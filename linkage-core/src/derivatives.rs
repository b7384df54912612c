//! First and second derivatives by automatic differentiation, with the dual numbers of
//! `num-dual`.
//!
//! The generated `sensitivity` is [`differentiate`] on a mechanism's parameters, and so is `jacobian` on its
//! inputs where the kinematic coefficients do not suffice. For any other derivative, write a closure over a
//! lifted solver. Nothing here allocates.

use nalgebra::{SMatrix, SVector};
use num_dual::{Derivative, Dual2SVec, DualNum, DualSVec};

use crate::{Float, Mechanism, Scalar, SolveError};

/// `f32` or `f64`, as what a derivative is made of.
pub trait Differentiable: Float + DualNum {}

impl<F: Float + DualNum> Differentiable for F {}

/// The Jacobian of the `rows` with respect to `x`: a row an output, a column an element of `x`.
///
/// ```
/// # use linkage_core::{SolveError, differentiate, mechanism};
/// mechanism! {
///     pub struct Press {
///         input theta: angle;
///         param crank = 1m;
///         param rod = 3m;
///         ground A(0, 0);
///         guide rail through A along 0deg;
///         crank AB(A) -> B { length: crank, angle: theta }
///         rrp BC(B), ram(rail) -> C { length: rod, mode: ahead }
///         output ram.slide;
///     }
/// }
/// # fn main() -> Result<(), SolveError> {
/// let press = Press::new();
/// // How the stroke between two angles changes with each of them, and with the crank.
/// let stroke = differentiate([0.0, 3.0, press.crank], |[from, to, crank]| {
///     let press = Press { crank, ..press.lift() };
///     Ok([press.position(from)?.ram.slide - press.position(to)?.ram.slide])
/// })?;
/// assert_eq!(stroke[(0, 0)], 0.0);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Those of the rows; `Singular` where a derivative is not finite.
pub fn differentiate<F: Differentiable, const OUT: usize, const N: usize>(
    x: [F; N],
    rows: impl FnOnce([DualSVec<F, N>; N]) -> Result<[DualSVec<F, N>; OUT], SolveError>,
) -> Result<SMatrix<F, OUT, N>, SolveError> {
    let seeds = core::array::from_fn(|i| DualSVec::from_re(x[i]).derivative(i));
    let rows = rows(seeds)?;
    // A row without a derivative part does not depend on any element.
    let jacobian = SMatrix::<F, OUT, N>::from_fn(|i, j| match &rows[i].eps {
        Derivative(Some(gradient)) => gradient[j],
        _ => F::lit(0.0, 0.0),
    });
    are_finite(&jacobian).then_some(jacobian).ok_or(UNDEFINED)
}

/// The generated `jacobian`: the coefficients at `x`, which cost a fraction of what duals do. Where there are
/// none, duals say why, or differentiate what has no rates: a group that stands still at its limit.
///
/// # Errors
/// Those of the rows of the mechanism on dual numbers, `lifted`; `Singular` where a derivative is not finite.
#[inline]
pub fn jacobian<F: Differentiable, M, const OUT: usize, const N: usize>(
    coefficients: Result<[[F; N]; OUT], SolveError>,
    x: [F; N],
    lifted: impl FnOnce() -> M,
) -> Result<SMatrix<F, OUT, N>, SolveError>
where
    M: Mechanism<
            Scalar = DualSVec<F, N>,
            Inputs = [DualSVec<F, N>; N],
            Rows = [DualSVec<F, N>; OUT],
        >,
{
    match coefficients {
        // An input that no coefficient depends on was not looked at.
        Ok(rows) if x.iter().all(|&input| Scalar::is_finite(input)) => {
            // nalgebra's arrays are of columns.
            Ok(SMatrix::from_fn(|row, column| rows[row][column]))
        }
        _ => by_duals(x, lifted()),
    }
}

#[cold]
#[inline(never)]
fn by_duals<F: Differentiable, M, const OUT: usize, const N: usize>(
    x: [F; N],
    lifted: M,
) -> Result<SMatrix<F, OUT, N>, SolveError>
where
    M: Mechanism<
            Scalar = DualSVec<F, N>,
            Inputs = [DualSVec<F, N>; N],
            Rows = [DualSVec<F, N>; OUT],
        >,
{
    differentiate(x, |inputs| lifted.position(inputs))
}

/// A number with its first and second derivatives, by [`differentiate_twice`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives<F, const N: usize> {
    /// The number itself.
    pub value: F,
    /// The first derivatives.
    pub gradient: SVector<F, N>,
    /// The second derivatives, a symmetric matrix.
    pub hessian: SMatrix<F, N, N>,
}

/// The value, the gradient and the Hessian of one output, or of any expression of outputs, with
/// respect to `x`: inputs, parameters or both.
///
/// ```
/// # use linkage_core::{SolveError, differentiate_twice, mechanism};
/// mechanism! {
///     pub struct Press {
///         input theta: angle;
///         param rod = 3m;
///         ground A(0, 0);
///         guide rail through A along 0deg;
///         crank AB(A) -> B { length: 1m, angle: theta }
///         rrp BC(B), ram(rail) -> C { length: rod, mode: ahead }
///         output ram.slide;
///     }
/// }
/// # fn main() -> Result<(), SolveError> {
/// let press = Press::new();
/// let ram = differentiate_twice([0.0, press.rod], |[theta, rod]| {
///     let press = Press { rod, ..press.lift() };
///     Ok(press.position(theta)?.ram.slide)
/// })?;
/// // At the outer dead centre the slide is a maximum over the crank's angle: −(1 + 1/3) m/rad².
/// assert_eq!((ram.value, ram.gradient[0]), (4.0, 0.0));
/// assert!((ram.hessian[(0, 0)] + 4.0 / 3.0).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Those of the function; `Singular` where it or a derivative is not finite.
pub fn differentiate_twice<F: Differentiable, const N: usize>(
    x: [F; N],
    function: impl FnOnce([Dual2SVec<F, N>; N]) -> Result<Dual2SVec<F, N>, SolveError>,
) -> Result<Derivatives<F, N>, SolveError> {
    let seeds = core::array::from_fn(|i| Dual2SVec::from_re(x[i]).derivative(i));
    let Dual2SVec { re: value, v1, v2, .. } = function(seeds)?;
    let gradient = v1.0.map_or_else(SVector::zeros, |row| row.transpose());
    let hessian = v2.0.unwrap_or_else(SMatrix::zeros);
    let all_finite = Scalar::is_finite(value) && are_finite(&gradient) && are_finite(&hessian);
    all_finite.then_some(Derivatives { value, gradient, hessian }).ok_or(UNDEFINED)
}

const UNDEFINED: SolveError = SolveError::Singular { group: "the derivative" };

fn are_finite<F: Differentiable, const R: usize, const C: usize>(
    matrix: &SMatrix<F, R, C>,
) -> bool {
    matrix.iter().all(|&entry| Scalar::is_finite(entry))
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
    fn second_derivatives_are_a_symmetric_matrix() {
        let sine = |[r, t]: [Dual2SVec<f64, 2>; 2]| Ok(r * r * Scalar::sin_cos(t).0);
        let at = differentiate_twice([3.0, 0.0], sine).unwrap();
        assert_eq!((at.value, at.gradient), (0.0, SVector::from([0.0, 9.0])));
        assert_eq!(at.hessian, SMatrix::<f64, 2, 2>::new(0.0, 6.0, 6.0, 0.0));
        let nothing = differentiate_twice([3.0_f32], |_| Ok(Dual2SVec::from_re(7.0))).unwrap();
        assert_eq!((nothing.value, nothing.gradient[0], nothing.hessian[0]), (7.0, 0.0, 0.0));
    }

    #[test]
    fn errors_and_infinite_derivatives_are_refused() {
        let error = SolveError::Singular { group: "BC, DC" };
        assert_eq!(differentiate::<f64, 1, 1>([1.0], |_| Err(error)), Err(error));
        assert_eq!(differentiate_twice::<f64, 1>([1.0], |_| Err(error)), Err(error));
        assert_eq!(differentiate([0.0], |[x]| Ok([Scalar::sqrt(x)])), Err(UNDEFINED));
        assert_eq!(differentiate_twice([0.0], |[x]| Ok(Scalar::sqrt(x))), Err(UNDEFINED));
        // x^(3/2) has a slope at zero, and no curvature; the chain rule gives neither.
        assert_eq!(differentiate_twice([0.0], |[x]| Ok(x * Scalar::sqrt(x))), Err(UNDEFINED));
    }
}
