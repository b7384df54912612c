//! What the slow path decides where the fast path could not: whether a condition is met after all,
//! and if not, whose failure it is.
//!
//! One function a condition. Generated code calls them in the order of evaluation and stops at
//! the first error. They look at the operands a condition came from rather than at the value that
//! was computed from them, and at real parts only, except where a derivative does not exist.

use crate::checks::FirstError;
use crate::limit::{self, Reach, Width};
use crate::{Real, Record, SolveError};

/// Whether an input, or a parameter, is finite.
///
/// # Errors
/// `NotFinite` with its name.
#[cold]
pub fn finite_input<T: Real>(value: T, name: &'static str) -> Result<(), SolveError> {
    if value.is_finite() { Ok(()) } else { Err(SolveError::NotFinite { name }) }
}

/// Whether a result is finite, `given` being what it was made from.
///
/// # Errors
/// `Singular` where only a derivative that it carries is not finite. Else `NotFinite`: with the
/// name of the largest of the given numbers whose fourth power leaves the number's range, as a
/// rate that is squared on the way does, or with the result's own name where there is none.
#[cold]
pub fn finite_result<T: Real>(
    value: T,
    name: &'static str,
    given: &[(T, &'static str)],
) -> Result<(), SolveError> {
    if value.is_finite() {
        return Ok(());
    }
    if value.value().is_finite() {
        return Err(SolveError::Singular { group: name });
    }
    let mut blamed = (0.0, name);
    for &(number, name) in given {
        let square = number * number;
        let size = number.value().max(-number.value());
        if !(square * square).value().is_finite() && size > blamed.0 {
            blamed = (size, name);
        }
    }
    Err(SolveError::NotFinite { name: blamed.1 })
}

/// The slow path of an entry point that returns a record: what is `given` must be finite, then every
/// condition of the formulas be met, then each number of the result be finite.
///
/// # Errors
/// The first that is not so.
#[cold]
pub fn diagnose<T: Real, R: Record<Number = T> + Copy>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
) -> Result<R, SolveError> {
    let result = conditions_met(given, formulas)?;
    let mut numbers = R::LABELS.iter().zip(result.into_array());
    numbers.try_for_each(|(name, value)| finite_result(value, name, given))?;
    Ok(result)
}

/// The same of one that returns anything else: `results` says which of its numbers are asked.
///
/// # Errors
/// See [`diagnose`].
#[cold]
pub fn diagnose_all<T: Real, R: Copy, const N: usize>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
    results: impl FnOnce(R) -> [(T, &'static str); N],
) -> Result<R, SolveError> {
    let result = conditions_met(given, formulas)?;
    results(result).iter().try_for_each(|&(value, name)| finite_result(value, name, given))?;
    Ok(result)
}

fn conditions_met<T: Real, R>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
) -> Result<R, SolveError> {
    given.iter().try_for_each(|&(value, name)| finite_input(value, name))?;
    let mut first = FirstError::new();
    let result = formulas(&mut first);
    first.first()?;
    Ok(result)
}

/// The value, (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²) / (4 l₁ l₂)², provided that circles of radii `l1` and
/// `l2` about points d = (`dx`, `dy`) apart meet; zero where they fail to by at most four units in
/// the last place of the longest of the three lengths. Where they meet and the value was rounded
/// away, it is computed once more without rounding.
///
/// # Errors
/// `OutOfReach` by the distance that is missing, `Singular` where the centres coincide or where a
/// derivative is asked for at the limit, `NotFinite` where a number is not.
#[cold]
pub(crate) fn reach_circles<T: Real>(
    value: T,
    dx: T,
    dy: T,
    l1: T,
    l2: T,
    group: &'static str,
) -> Result<T, SolveError> {
    let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
    let reach = limit::circles(d, lengths, width::<T>());
    let lost = reach == Reach::Meets && value.value() <= 0.0;
    let value = if lost { restored(value, limit::height_product(d, lengths)) } else { value };
    reached(value, reach, group)
}

/// The squared length `value` between centres of circles of radii `l1` and `l2`, provided that it
/// is in the range in which a square carries full precision.
///
/// # Errors
/// As for [`square`]; about one point, circles of different radii are `OutOfReach`.
#[cold]
pub(crate) fn square_of_centres<T: Real>(
    value: T,
    dx: T,
    dy: T,
    l1: T,
    l2: T,
    group: &'static str,
) -> Result<T, SolveError> {
    let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
    match limit::circles(d, lengths, width::<T>()) {
        Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
        Reach::Coincident => Err(SolveError::Singular { group }),
        Reach::Meets | Reach::AtLimit | Reach::NotFinite => square(value, group),
    }
}

/// The value, at least zero, provided that |`t`| ≤ `l`; at the limit and errors as for
/// [`reach_circles`].
#[cold]
pub(crate) fn reach_line<T: Real>(
    value: T,
    t: T,
    l: T,
    group: &'static str,
) -> Result<T, SolveError> {
    reached(value, limit::line(t.value(), l.value(), width::<T>()), group)
}

/// The value, at least zero, provided that |`e`| ≤ |(`bx`, `by`)|; at the limit and errors as for
/// [`reach_circles`].
#[cold]
pub(crate) fn reach_offset<T: Real>(
    value: T,
    bx: T,
    by: T,
    e: T,
    group: &'static str,
) -> Result<T, SolveError> {
    reached(value, limit::offset([bx.value(), by.value()], e.value(), width::<T>()), group)
}

/// The value, provided that it is not zero.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` where it is not a number.
#[cold]
pub(crate) fn nonzero<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    let real = value.value();
    if real.is_nan() {
        Err(SolveError::NotFinite { name: group })
    } else if real == 0.0 {
        Err(SolveError::Singular { group })
    } else {
        Ok(value)
    }
}

/// The value, a length, provided that it is greater than zero.
///
/// # Errors
/// `Invalid` with its name where it is not, `NotFinite` with its name where it is not a number.
#[cold]
pub(crate) fn positive<T: Real>(
    value: T,
    group: &'static str,
    name: &'static str,
) -> Result<T, SolveError> {
    let real = value.value();
    if real.is_nan() {
        Err(SolveError::NotFinite { name })
    } else if real > 0.0 {
        Ok(value)
    } else {
        Err(SolveError::Invalid { group, name })
    }
}

/// The value, a squared length that something is divided by, provided that it is in the range in
/// which a square carries full precision.
///
/// # Errors
/// `Singular` where it is zero, `NotFinite` with the group's name where it is below
/// [`Scalar::smallest_square`](crate::Scalar::smallest_square), infinite or not a number.
#[cold]
pub(crate) fn square<T: Real>(value: T, group: &'static str) -> Result<T, SolveError> {
    let real = value.value();
    if real == 0.0 {
        Err(SolveError::Singular { group })
    } else if real.is_finite() && real >= T::smallest_square().value() {
        Ok(value)
    } else {
        Err(SolveError::NotFinite { name: group })
    }
}

/// The value that goes with the answer, or the error.
fn reached<T: Real>(value: T, reach: Reach, group: &'static str) -> Result<T, SolveError> {
    let real = value.value();
    match reach {
        Reach::Meets if !real.is_finite() => Err(SolveError::NotFinite { name: group }),
        Reach::Meets if real > 0.0 => Ok(value),
        // Zero, or below it by rounding: on the line of centres, where the square root of the
        // value has no derivative.
        Reach::Meets | Reach::AtLimit if value.is_constant() => Ok(T::lit(0.0, 0.0)),
        Reach::Meets | Reach::AtLimit | Reach::Coincident => Err(SolveError::Singular { group }),
        Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
        Reach::NotFinite => Err(SolveError::NotFinite { name: group }),
    }
}

/// The value with its derivatives, its real part as it would be without rounding.
fn restored<T: Real>(value: T, exact: f64) -> T {
    let missing = exact - value.value();
    value + T::lit(missing, missing as f32)
}

fn width<T: Real>() -> Width {
    // smallest_square is MIN_POSITIVE/ε², and the smallest number above zero MIN_POSITIVE·ε.
    let epsilon = <T as Real>::EPSILON;
    Width { epsilon, smallest: T::smallest_square().value() * epsilon * epsilon * epsilon }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GROUP: &str = "BC, DC";
    const SINGULAR: SolveError = SolveError::Singular { group: GROUP };
    const NOT_FINITE: SolveError = SolveError::NotFinite { name: GROUP };

    #[test]
    fn a_pose_at_the_limit_has_its_inner_joint_on_the_line() {
        // Four units in the last place of 7.
        let beyond = 7.0 + 2.0_f64.powi(-48);
        assert_eq!(reach_circles(-1e-16, beyond, 0.0, 3.0, 4.0, GROUP), Ok(0.0));
        assert_eq!(reach_circles(1e-16, beyond, 0.0, 3.0, 4.0, GROUP), Ok(0.0));
        assert_eq!(reach_circles(-1e-16, 7.0, 0.0, 3.0, 4.0, GROUP), Ok(0.0));
        assert_eq!(reach_circles(2.0, 5.0, 0.0, 3.0, 4.0, GROUP), Ok(2.0));
        assert_eq!(
            reach_circles(-1.0, 7.5, 0.0, 3.0, 4.0, GROUP),
            Err(SolveError::OutOfReach { group: GROUP, by: 0.5 })
        );
        assert_eq!(reach_line(-1e-16_f32, 1.0_f32.next_up(), 1.0, GROUP), Ok(0.0));
        assert_eq!(
            reach_line(-1.0_f32, -1.5, 1.0, GROUP),
            Err(SolveError::OutOfReach { group: GROUP, by: 0.5 })
        );
        assert_eq!(reach_offset(-1e-16_f32, 0.0, 1.0, 1.0_f32.next_up(), GROUP), Ok(0.0));
        assert_eq!(
            reach_offset(-1.0, 0.0, 1.0, -1.5, GROUP),
            Err(SolveError::OutOfReach { group: GROUP, by: 0.5 })
        );
    }

    #[cfg(feature = "ad")]
    #[test]
    fn at_the_limit_only_a_constant_has_a_derivative() {
        use num_dual::Dual;
        let [d, l1, l2] = [7.0, 3.0, 4.0].map(Dual::<f64>::from_re);
        let y = Dual::from_re(0.0);
        let constant = reach_circles(Dual::from_re(-1e-16), d, y, l1, l2, GROUP).unwrap();
        assert!(constant.re == 0.0 && constant.eps == 0.0);
        for real in [-1e-16, 0.0] {
            let moving = reach_circles(Dual::new(real, 1.0), d, y, l1, l2, GROUP);
            assert!(matches!(moving, Err(SINGULAR)));
        }
        let inside = reach_line(Dual::new(3.0, 1.0), Dual::new(1.0, 1.0), l2, GROUP).unwrap();
        assert!(inside.re == 3.0 && inside.eps == 1.0);
        let steep = Dual::new(3.0, f64::INFINITY);
        assert_eq!(finite_result(steep, "C.x", &[]), Err(SolveError::Singular { group: "C.x" }));
        let lost = Dual::new(f64::NAN, f64::NAN);
        assert_eq!(finite_result(lost, "C.x", &[]), Err(SolveError::NotFinite { name: "C.x" }));
    }

    #[test]
    fn what_is_not_finite_is_never_reached() {
        assert_eq!(reach_circles(f64::NAN, 5.0, 0.0, 3.0, 4.0, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_circles(f64::INFINITY, 5.0, 0.0, 3.0, 4.0, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_circles(1.0, f64::NAN, 0.0, 3.0, 4.0, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_line(1.0, 0.0, f64::INFINITY, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_offset(1.0, 0.0, 0.0, f64::NAN, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_circles(f64::NAN, 0.0, 0.0, 3.0, 3.0, GROUP), Err(SINGULAR));
    }

    #[test]
    fn lengths_squares_and_divisors_say_what_is_wrong_with_them() {
        let invalid = SolveError::Invalid { group: GROUP, name: "lift" };
        let not_finite = SolveError::NotFinite { name: "lift" };
        assert_eq!(positive(5e-324, GROUP, "lift"), Ok(5e-324));
        for zero_or_less in [0.0, -0.0, -1.0, f64::NEG_INFINITY] {
            assert_eq!(positive(zero_or_less, GROUP, "lift"), Err(invalid));
        }
        assert_eq!(positive(f64::NAN, GROUP, "lift"), Err(not_finite));
        assert_eq!(nonzero(-1.0_f32, GROUP), Ok(-1.0));
        assert_eq!(nonzero(-0.0, GROUP), Err(SINGULAR));
        assert_eq!(nonzero(f64::NAN, GROUP), Err(NOT_FINITE));
        // (10⁻⁹ m)² is a square of full precision also in single precision.
        assert_eq!(square(1e-18_f32, GROUP), Ok(1e-18));
        assert_eq!(square(0.0, GROUP), Err(SINGULAR));
        for out_of_range in [1e-30_f32, f32::INFINITY, f32::NAN, -1.0] {
            assert_eq!(square(out_of_range, GROUP), Err(NOT_FINITE));
        }
        assert_eq!(finite_input(1e300, "lift"), Ok(()));
        assert_eq!(finite_input(f64::INFINITY, "lift"), Err(not_finite));
        assert_eq!(finite_result(f32::NAN, "lift", &[]), Err(not_finite));
        let given = [(1e12_f32, "small"), (-1e20, "lift"), (1e19, "large"), (0.0, "none")];
        assert_eq!(finite_result(f32::NAN, "C.x", &given), Err(not_finite));
        assert_eq!(finite_result(1.0, "C.x", &given), Ok(()));
    }
}
