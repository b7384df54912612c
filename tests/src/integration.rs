//! Motion integrated by the plainest method of the fourth order.

use linkage_core::SolveError;

/// A step of the classical Runge–Kutta method.
///
/// # Errors
/// Those of the rates.
pub fn step(
    rates: impl Fn([f64; 2]) -> Result<[f64; 2], SolveError>,
    state: [f64; 2],
    h: f64,
) -> Result<[f64; 2], SolveError> {
    let along = |k: [f64; 2], h: f64| [state[0] + h * k[0], state[1] + h * k[1]];
    let k1 = rates(state)?;
    let k2 = rates(along(k1, h / 2.0))?;
    let k3 = rates(along(k2, h / 2.0))?;
    let k4 = rates(along(k3, h))?;
    Ok([0, 1].map(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i])))
}
