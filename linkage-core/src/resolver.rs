//! The direction that a resolver means.
//!
//! A resolver delivers the cosine and the sine of an angle times an amplitude that is near one: a
//! transformer's ratio, the excitation's level and the converter's reference are off by a few per
//! cent, and both channels alike. A link that took them as they are would be longer or shorter by
//! as much, and squares that count on cos² + sin² = 1 would be wrong. So the amplitude is divided
//! out before anything is made of them.
//!
//! An amplitude further than a tenth from one is refused. No healthy resolver has it: a broken or
//! shorted winding, a lost excitation or numbers that were never converted do, and the angle they
//! seem to have is none. (That one winding is lost shows only where the other's part is below 0.9,
//! on five sevenths of a turn; it is no substitute for the converter's own supervision.)

use crate::diagnosis::finite_input;
use crate::{Real, Scalar, SolveError};

/// The squares of the least and the largest amplitude, 0.9 and 1.1.
const LEAST: (f64, f32) = (0.81, 0.81);
const LARGEST: (f64, f32) = (1.21, 1.21);

/// The unit vector along (`cos`, `sin`), each within 2.5 units in the last place, and whether its
/// amplitude is one that a resolver has.
#[inline(always)]
pub fn on_circle<T: Scalar>(cos: T, sin: T) -> (T, T, T::Mask) {
    let square = T::fused(cos, cos, sin * sin);
    let [least, largest] = [LEAST, LARGEST].map(|(wide, narrow)| T::lit(wide, narrow));
    let inverse = T::lit(1.0, 1.0) / square.sqrt();
    (cos * inverse, sin * inverse, square.ge(least) & largest.ge(square))
}

/// The same, or what is wrong with the numbers that were given for the input `name`.
///
/// # Errors
/// `NotFinite` with the name of the one that is not, `OffCircle` with the amplitude.
fn found_on_circle<T: Real>(cos: T, sin: T, name: &'static str) -> Result<(T, T), SolveError> {
    finite_input(cos, "cos")?;
    finite_input(sin, "sin")?;
    let (x, y, is_near_one) = on_circle(cos, sin);
    if is_near_one {
        return Ok((x, y));
    }
    Err(SolveError::OffCircle { name, amplitude: libm::hypot(cos.value(), sin.value()) })
}

/// Goes on with the cosine and sine of a resolver's direction that was given for the input `name`.
///
/// One call, and never inlined: what the slow path needs is no business of the function that may have
/// to take it.
///
/// # Errors
/// `NotFinite` with the name of the one that is not, `OffCircle` with the amplitude, and those of
/// what goes on.
#[cold]
#[inline(never)]
pub fn from_circle<T: Real, R>(
    cos: T,
    sin: T,
    name: &'static str,
    then: impl FnOnce(T, T) -> Result<R, SolveError>,
) -> Result<R, SolveError> {
    let (cos, sin) = found_on_circle(cos, sin, name)?;
    then(cos, sin)
}

/// Goes on with the cosine and sine of an angle that was given for the input `name`, made with more care
/// than in the straight line.
///
/// # Errors
/// `NotFinite` with the name, and those of what goes on.
#[cold]
#[inline(never)]
pub fn from_angle<T: Real, R>(
    angle: T,
    name: &'static str,
    then: impl FnOnce(T, T) -> Result<R, SolveError>,
) -> Result<R, SolveError> {
    finite_input(angle, name)?;
    let (sin, cos) = T::sin_cos(angle);
    then(cos, sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amplitudes_near_one_are_divided_out_and_others_refused() {
        for amplitude in [0.9000001_f64, 0.97, 1.0, 1.01, 1.0999999] {
            let (cos, sin, ok) = on_circle(amplitude * 0.6, amplitude * -0.8);
            assert!(ok && (cos - 0.6).abs() <= f64::EPSILON && (sin + 0.8).abs() <= f64::EPSILON);
            assert!(found_on_circle(amplitude as f32, 0.0, "theta").is_ok());
        }
        for amplitude in [0.0_f64, 1e-300, 0.8999999, 1.1000001, 1e200] {
            assert!(!on_circle(amplitude * 0.6, amplitude * -0.8).2);
            let Err(SolveError::OffCircle { name, amplitude: found }) =
                found_on_circle(amplitude * 0.6, amplitude * -0.8, "theta")
            else {
                panic!("{amplitude:e}")
            };
            assert_eq!(name, "theta");
            assert!((found - amplitude).abs() <= 2.0 * f64::EPSILON * amplitude);
        }
        let not_finite = |name| SolveError::NotFinite { name };
        assert_eq!(found_on_circle(f64::NAN, 0.0, "theta").unwrap_err(), not_finite("cos"));
        assert_eq!(found_on_circle(1.0, f32::INFINITY, "theta").unwrap_err(), not_finite("sin"));
        assert!(!on_circle(f64::NAN, 0.0).2 && !on_circle(1.0, f64::INFINITY).2);
    }

    /// Also of angles that the straight line's sine and cosine are not for.
    #[test]
    fn what_is_given_goes_on_as_a_direction() {
        let both = |cos, sin| Ok([cos, sin]);
        for angle in [0.3, -2e6, 1e22_f64] {
            // Within a unit in the last place of one.
            let [cos, sin] = from_angle(angle, "theta", both).expect("a finite angle");
            let (sin_by, cos_by) = libm::sincos(angle);
            assert!((cos - cos_by).abs() <= f64::EPSILON && (sin - sin_by).abs() <= f64::EPSILON);
        }
        let not_finite = Err(SolveError::NotFinite { name: "theta" });
        assert_eq!(from_angle(f64::NAN, "theta", both), not_finite);
        let [cos, sin] = from_circle(0.57, -0.76_f64, "theta", both).expect("it is near one");
        assert!((cos - 0.6).abs() <= f64::EPSILON && (sin + 0.8).abs() <= f64::EPSILON);
        let off = from_circle(0.0, 2.0, "theta", both);
        assert_eq!(off, Err(SolveError::OffCircle { name: "theta", amplitude: 2.0 }));
        let refused = SolveError::Singular { group: "BC" };
        assert_eq!(from_angle(0.0, "theta", |_, _| Err::<(), _>(refused)), Err(refused));
    }
}
