//! What the slow path decides where the fast path could not: whether a condition is met after all,
//! and if not, whose failure it is.
//!
//! One function a condition. Generated code calls them in the order of evaluation and stops at
//! the first error. They look at the operands a condition came from rather than at the value that
//! was computed from them, and at real parts only, except where a derivative does not exist.

mod search;
mod size;

pub(crate) use search::{ENDS_OF_BETWEEN, closed, moving, no_root, open_by};
pub(crate) use size::{finite_input, finite_result};
pub(crate) use size::{nonzero, not_negative, positive, square};

use crate::limit::{self, Reach, Width};
use crate::{Real, SolveError};

/// How many ε of the spread a value may be wrong by: whoever is above that is above zero.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// The value, (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²) / (4 l₁ l₂)² in squares of a `unit`, provided that circles
/// of radii `l1` and `l2` about points d = (`dx`, `dy`) apart meet; zero where they fail to by at most four
/// units in the last place of the longest of the three lengths. Where rounding could have changed its sign,
/// that is decided without rounding, and the value computed once more.
///
/// # Errors
/// `OutOfReach` by the distance that is missing, `Singular` where the centres coincide or where a
/// derivative is asked for at the limit, `NotFinite` where a number is not or where `l1` · `l2` is
/// too small to be divided by.
#[cold]
pub(crate) fn reach_circles<T: Real>(
    value: T,
    [dx, dy, l1, l2, unit, spread]: [T; 6],
    group: &'static str,
) -> Result<T, SolveError> {
    if is_certain(value, spread) {
        return Ok(value);
    }
    let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
    let reach = limit::circles(d, lengths, width::<T>());
    let is_product_sound = 4.0 * lengths[0] * lengths[1] >= smallest_normal::<T>();
    if matches!(reach, Reach::Meets | Reach::AtLimit) && !is_product_sound {
        return Err(SolveError::NotFinite { name: group });
    }
    let value = match reach {
        Reach::Meets => {
            let unit = unit.value();
            restored(value, limit::height_product(d, lengths) * unit * unit)
        }
        _ => value,
    };
    reached(value, &[dx, dy, l1, l2], reach, group)
}

/// The value, (d² + l₁² − l₂²)/2d²: the share of the line between the centres at which the joint's
/// foot stands. Where [`reach_circles`] decides without rounding on the height, so does this on the
/// share; at the limit it puts the joint at the bar's length from its centre.
#[cold]
pub(crate) fn share_of_centres<T: Real>(value: T, [height, dx, dy, l1, l2, spread]: [T; 6]) -> T {
    if is_certain(height, spread) {
        return value;
    }
    let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
    match limit::circles(d, lengths, width::<T>()) {
        Reach::Meets => restored(value, limit::foot(d, lengths)),
        Reach::AtLimit => restored(value, limit::foot_on_line(d, lengths)),
        Reach::Beyond(_) | Reach::Coincident | Reach::NotFinite => value,
    }
}

/// The value, the square of a point's distance from the line through two joints `l` apart, provided
/// that there is a point at the distances `r1` and `r2` from them. At the limit and in doubt as for
/// [`reach_circles`].
///
/// # Errors
/// Those of [`reach_circles`]; `NotFinite` where the square is below the number's normal range.
#[cold]
pub(crate) fn reach_distances<T: Real>(
    value: T,
    [l, r1, r2, spread]: [T; 4],
    group: &'static str,
) -> Result<T, SolveError> {
    if is_certain(value, spread) {
        return Ok(value);
    }
    let (d, lengths) = ([l.value(), 0.0], [r1.value(), r2.value()]);
    let reach = limit::circles(d, lengths, width::<T>());
    let value = match reach {
        Reach::Meets => {
            let height = 2.0 * lengths[0] * (lengths[1] / d[0]);
            let product = limit::height_product(d, lengths);
            let square = product * height * height;
            if product > 0.0 && square < smallest_normal::<T>() {
                return Err(SolveError::NotFinite { name: group });
            }
            restored(value, square)
        }
        _ => value,
    };
    reached(value, &[l, r1, r2], reach, group)
}

/// Whether the value is above zero whatever rounding did to it.
fn is_certain<T: Real>(value: T, spread: T) -> bool {
    let value = value.value();
    value.is_finite() && value > ROUNDINGS * T::EPSILON * spread.value()
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

/// The value, (l − t)(l + t), provided that |`t`| ≤ `l`; at the limit as for [`reach_circles`].
///
/// # Errors
/// Those of [`reach_circles`]; `NotFinite` where the value has left the number's normal range.
#[cold]
pub(crate) fn reach_line<T: Real>(
    value: T,
    t: T,
    l: T,
    group: &'static str,
) -> Result<T, SolveError> {
    let reach = limit::line(t.value(), l.value(), width::<T>());
    // One unit in the last place from the limit the product is ε l², which full precision of l²
    // leaves in the normal range.
    let has_room = l.value() * l.value() >= T::smallest_square().value();
    let is_inside = t.value().abs() < l.value().abs();
    if reach == Reach::Meets && is_inside && !has_room && value.value() < smallest_normal::<T>() {
        return Err(SolveError::NotFinite { name: group });
    }
    reached(value, &[t, l], reach, group)
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
    let reach = limit::offset([bx.value(), by.value()], e.value(), width::<T>());
    reached(value, &[bx, by, e], reach, group)
}

/// The value that goes with the answer, or the error.
fn reached<T: Real>(
    value: T,
    operands: &[T],
    reach: Reach,
    group: &'static str,
) -> Result<T, SolveError> {
    let real = value.value();
    match reach {
        Reach::Meets if !real.is_finite() => Err(SolveError::NotFinite { name: group }),
        Reach::Meets if real > 0.0 => Ok(value),
        // Zero, or below it by rounding: on the line of centres, where the square root of the
        // value has no derivative. That the value's own derivative is zero there does not help: a
        // motion that touches the limit has a value like −x² or x², and a root like |x|.
        Reach::Meets | Reach::AtLimit
            if value.is_constant() && operands.iter().all(|operand| operand.is_constant()) =>
        {
            Ok(T::lit(0.0, 0.0))
        }
        Reach::Meets | Reach::AtLimit | Reach::Coincident => Err(SolveError::Singular { group }),
        Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
        Reach::NotFinite => Err(SolveError::NotFinite { name: group }),
    }
}

/// The value with its derivatives, its real part as it would be without rounding. What is added
/// first leaves nothing of the rounded one.
fn restored<T: Real>(value: T, exact: f64) -> T {
    let rounded = value.value();
    value + T::lit(-rounded, -rounded as f32) + T::lit(exact, exact as f32)
}

/// The smallest number of full precision.
fn smallest_normal<T: Real>() -> f64 {
    T::smallest_square().value() * T::EPSILON * T::EPSILON
}

fn width<T: Real>() -> Width {
    // smallest_square is MIN_POSITIVE/ε², and the smallest number above zero MIN_POSITIVE·ε.
    Width { epsilon: T::EPSILON, smallest: smallest_normal::<T>() * T::EPSILON }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GROUP: &str = "BC, DC";
    const SINGULAR: SolveError = SolveError::Singular { group: GROUP };
    const NOT_FINITE: SolveError = SolveError::NotFinite { name: GROUP };

    /// A value in units of one that may be wrong by 16 ε.
    fn circles<T: Real>(value: T, [dx, dy, l1, l2]: [T; 4]) -> Result<T, SolveError> {
        reach_circles(value, [dx, dy, l1, l2, T::lit(1.0, 1.0), T::lit(1.0, 1.0)], GROUP)
    }

    #[test]
    fn a_pose_at_the_limit_has_its_inner_joint_on_the_line() {
        // Four units in the last place of 7.
        let beyond = 7.0 + 2.0_f64.powi(-48);
        assert_eq!(circles(-1e-16, [beyond, 0.0, 3.0, 4.0]), Ok(0.0));
        assert_eq!(circles(1e-16, [beyond, 0.0, 3.0, 4.0]), Ok(0.0));
        assert_eq!(circles(-1e-16, [7.0, 0.0, 3.0, 4.0]), Ok(0.0));
        assert_eq!(circles(2.0, [5.0, 0.0, 3.0, 4.0]), Ok(2.0));
        assert_eq!(
            circles(-1.0, [7.5, 0.0, 3.0, 4.0]),
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
        use num_dual::{Dual, DualSVec};
        let [d, l1, l2] = [7.0, 3.0, 4.0].map(Dual::<f64>::from_re);
        let y = Dual::from_re(0.0);
        let constant = circles(Dual::from_re(-1e-16), [d, y, l1, l2]).unwrap();
        assert!(constant.re == 0.0 && constant.eps == 0.0);
        for real in [-1e-16, 0.0] {
            let moving = circles(Dual::new(real, 1.0), [d, y, l1, l2]);
            assert!(matches!(moving, Err(SINGULAR)));
        }
        // A derivative that happens to be zero is one: the motion touches the limit.
        let touching = DualSVec::<f64, 1>::from_re(0.0).derivative(0) * DualSVec::from_re(0.0);
        let [d, l1, l2] = [7.0, 3.0, 4.0].map(DualSVec::<f64, 1>::from_re);
        let y = DualSVec::from_re(0.0);
        assert_eq!(circles(touching, [d, y, l1, l2]).map(|_| ()), Err(SINGULAR));
        assert_eq!(circles(y, [d + touching, y, l1, l2]).map(|_| ()), Err(SINGULAR));
        assert!(circles(y, [d, y, l1, l2]).is_ok());
        let l2 = Dual::from_re(4.0);
        let inside = reach_line(Dual::new(3.0, 1.0), Dual::new(1.0, 1.0), l2, GROUP).unwrap();
        assert!(inside.re == 3.0 && inside.eps == 1.0);
        let steep = Dual::new(3.0, f64::INFINITY);
        assert_eq!(finite_result(steep, "C.x", &[]), Err(SolveError::Singular { group: "C.x" }));
        let lost = Dual::new(f64::NAN, f64::NAN);
        assert_eq!(finite_result(lost, "C.x", &[]), Err(SolveError::NotFinite { name: "C.x" }));
    }

    #[test]
    fn what_is_in_doubt_is_what_it_is_without_rounding() {
        // Four last places of 7 beyond it, and a value that 16 ε may have raised from below zero.
        let beyond = 7.0 + 2.0_f64.powi(-48);
        assert_eq!(circles(4.0 * f64::EPSILON, [beyond, 0.0, 3.0, 4.0]), Ok(0.0));
        let near = 7.0_f64.next_down();
        let exact = limit::height_product([near, 0.0], [3.0, 4.0]);
        assert!(exact > 0.0);
        assert_eq!(reach_circles(0.3, [near, 0.0, 3.0, 4.0, 1.0, 1e20], GROUP), Ok(exact));
        // Folded, the shorter bar's end is behind its own joint.
        let folded = 1.0_f64.next_down();
        let share = |l1, l2| share_of_centres(0.3, [0.0, folded, 0.0, l1, l2, 1.0]);
        assert_eq!((share(3.0, 4.0), share(4.0, 3.0)), (-3.0 / folded, 4.0 / folded));
        // 1 and 0.6, 0.8: a right angle, 0.48 high.
        let square = reach_distances(0.3, [1.0, 0.6, 0.8, 1e20], GROUP).unwrap();
        assert!((square - 0.2304_f64).abs() <= 1e-15, "{square}");
        // A square that leaves the range, and a product that nothing can be divided by.
        let tiny = reach_distances(0.0, [1e-22_f32, 0.6e-22, 0.6e-22, 0.0], GROUP);
        assert_eq!(tiny, Err(NOT_FINITE));
        let thin = reach_circles(0.0, [1e-9_f32, 0.0, 1e-30, 1e-9, 1.0, 1e30], GROUP);
        assert_eq!(thin, Err(NOT_FINITE));
    }

    /// 64 √ε of what the sides are made of, in either width.
    #[test]
    fn an_equation_is_closed_to_the_root_of_rounding() {
        fn is_closed<T: Real>(times: f64) -> bool {
            let size = T::num(3.0);
            let left = times * 64.0 * T::EPSILON.sqrt() * 3.0;
            let by = |left: f64| closed(T::num(left), size, "theta", "m");
            assert_eq!(by(left).is_ok(), by(-left).is_ok());
            match by(left) {
                Ok(()) => true,
                Err(SolveError::NoSolution { unknown: "theta", by, unit: "m", other: None }) => {
                    assert!((by / left - 1.0).abs() < 1e-6);
                    false
                }
                other => panic!("{other:?}"),
            }
        }
        assert_eq!([is_closed::<f64>(0.99), is_closed::<f64>(1.01)], [true, false]);
        assert_eq!([is_closed::<f32>(0.99), is_closed::<f32>(1.01)], [true, false]);
    }

    /// 3, 4 and 5: the cross product of the radii is 12, in units of 2 · 3 · 4 one half.
    #[test]
    fn a_value_is_decided_in_its_own_unit() {
        let cross =
            |value, d, spread| reach_circles(value, [d, 0.0, 3.0, 4.0, 24.0, spread], GROUP);
        assert_eq!(cross(143.7, 5.0, 300.0), Ok(143.7));
        assert_eq!(cross(143.7, 5.0, 1e20), Ok(144.0));
        // Each of the two would be in doubt by the other's spread.
        let least = 16.0 * f64::EPSILON * 300.0;
        assert_eq!(cross(least.next_up(), 7.0, 300.0), Ok(least.next_up()));
        assert_eq!(cross(least, 7.0 + 2.0_f64.powi(-48), 300.0), Ok(0.0));
        let beyond = Err(SolveError::OutOfReach { group: GROUP, by: 0.5 });
        assert_eq!(cross(-1.0, 7.5, 300.0), beyond);
        assert_eq!(cross(f64::NAN, 5.0, 300.0), Err(NOT_FINITE));
    }

    #[test]
    fn what_is_not_finite_is_never_reached() {
        assert_eq!(circles(f64::NAN, [5.0, 0.0, 3.0, 4.0]), Err(NOT_FINITE));
        assert_eq!(circles(f64::INFINITY, [5.0, 0.0, 3.0, 3.0]), Err(NOT_FINITE));
        assert_eq!(circles(0.0, [f64::NAN, 0.0, 3.0, 4.0]), Err(NOT_FINITE));
        assert_eq!(reach_line(1.0, 0.0, f64::INFINITY, GROUP), Err(NOT_FINITE));
        assert_eq!(reach_offset(1.0, 0.0, 0.0, f64::NAN, GROUP), Err(NOT_FINITE));
        assert_eq!(circles(f64::NAN, [0.0, 0.0, 3.0, 3.0]), Err(SINGULAR));
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
        // A rate whose square is a number, and the square of that is none; one of which both are; and of
        // two of one size the first.
        let blamed = |given: &[(f32, &'static str)]| finite_result(f32::NAN, "C.x", given);
        assert_eq!(blamed(&[(1e9, "slow"), (-1e12, "lift")]), Err(not_finite));
        assert_eq!(blamed(&[(1e9, "slow")]), Err(SolveError::NotFinite { name: "C.x" }));
        assert_eq!(blamed(&[(1e20, "lift"), (-1e20, "second")]), Err(not_finite));
        assert_eq!(blamed(&[(-1e20, "first"), (2e20, "lift"), (1e20, "last")]), Err(not_finite));
    }
}
