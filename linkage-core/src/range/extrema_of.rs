//! Where an output turns back, by the output's name.

use super::{Extrema, RangeError, extrema};
use crate::mechanism::row;
use crate::roots::number;
use crate::{Mechanism, Real};

/// [`extrema`] of the output of this name, one of [`Mechanism::OUTPUTS`]. The mechanism has one input; of
/// several, [`extrema`] takes a line through them.
///
/// ```
/// use linkage_core::mechanism;
/// use linkage_core::range::{RangeError, extrema_of};
///
/// mechanism! {
///     struct Press {
///         input theta: angle;
///         ground A(0, 0);
///         guide bed through (0, 30mm) along 0deg;
///         crank AB(A) -> B           { length: 80mm, angle: theta }
///         rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
///         output ram.slide, C;
///     }
/// }
///
/// use core::f64::consts::PI;
/// let turns = extrema_of(&Press::new(), "ram.slide", [-PI, PI])?;
/// let stroke = f64::sqrt(0.33 * 0.33 - 0.03 * 0.03) - f64::sqrt(0.17 * 0.17 - 0.03 * 0.03);
/// assert!((turns.stroke() - stroke).abs() < 1e-15);
/// let error = extrema_of(&Press::new(), "slide", [-PI, PI]).unwrap_err();
/// assert_eq!(error.to_string(), "no output of this name; there are `ram.slide`, `C.x`, `C.y`");
/// # Ok::<(), RangeError>(())
/// ```
///
/// A direction's angle is in (−π, π]: where it passes ±π its turns are right and its values wrap.
///
/// # Errors
/// See [`RangeError`]; the first of the solver's errors.
pub fn extrema_of<T: Real, M: Mechanism<Scalar = T, Inputs = [T; 1]>>(
    mechanism: &M,
    output: &str,
    between: [T; 2],
) -> Result<Extrema<T>, RangeError> {
    let outputs = M::OUTPUTS;
    let index = row(outputs, output).ok_or(RangeError::NoOutput { outputs })?;
    extrema(between, |x| {
        let rows = mechanism.motion([x], [number(1.0)], [number(0.0)])?;
        Ok(rows.map(|row| row.as_ref().get(index).copied().unwrap_or(number(f64::NAN))))
    })
}
