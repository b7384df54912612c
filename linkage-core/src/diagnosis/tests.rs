use super::*;
use crate::limit;

const GROUP: &str = "BC, DC";
const SINGULAR: SolveError = SolveError::Singular { group: GROUP };
const NOT_FINITE: SolveError = SolveError::NotFinite { name: GROUP };

/// A value in units of one that may be wrong by 16 ε.
fn circles<T: Real>(value: T, [dx, dy, l1, l2]: [T; 4]) -> Result<T, SolveError> {
    ReachCircles([dx, dy, l1, l2, T::lit(1.0, 1.0), T::lit(1.0, 1.0)], GROUP).diagnose(value)
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
    assert_eq!(ReachLine([1.0_f32.next_up(), 1.0], GROUP).diagnose(-1e-16_f32), Ok(0.0));
    assert_eq!(
        ReachLine([-1.5, 1.0], GROUP).diagnose(-1.0_f32),
        Err(SolveError::OutOfReach { group: GROUP, by: 0.5 })
    );
    assert_eq!(ReachOffset([0.0, 1.0, 1.0_f32.next_up()], GROUP).diagnose(-1e-16_f32), Ok(0.0));
    assert_eq!(
        ReachOffset([0.0, 1.0, -1.5], GROUP).diagnose(-1.0),
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
    let inside = ReachLine([Dual::new(1.0, 1.0), l2], GROUP).diagnose(Dual::new(3.0, 1.0)).unwrap();
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
    assert_eq!(ReachCircles([near, 0.0, 3.0, 4.0, 1.0, 1e20], GROUP).diagnose(0.3), Ok(exact));
    // Folded, the shorter bar's end is behind its own joint.
    let folded = 1.0_f64.next_down();
    let share = |l1, l2| ShareOfCentres([0.0, folded, 0.0, l1, l2, 1.0], GROUP).diagnose(0.3);
    assert_eq!((share(3.0, 4.0), share(4.0, 3.0)), (Ok(-3.0 / folded), Ok(4.0 / folded)));
    // 1 and 0.6, 0.8: a right angle, 0.48 high.
    let square = ReachDistances([1.0, 0.6, 0.8, 1e20], GROUP).diagnose(0.3).unwrap();
    assert!((square - 0.2304_f64).abs() <= 1e-15, "{square}");
    // A square that leaves the range, and a product that nothing can be divided by.
    let tiny = ReachDistances([1e-22_f32, 0.6e-22, 0.6e-22, 0.0], GROUP).diagnose(0.0);
    assert_eq!(tiny, Err(NOT_FINITE));
    // Such circles meet, and miss each other by rounding.
    for d in [1e-9_f32, 1e-9_f32.next_up()] {
        let thin = ReachCircles([d, 0.0, 1e-30, 1e-9, 1.0, 1e30], GROUP).diagnose(0.0);
        assert_eq!(thin, Err(NOT_FINITE));
    }
    // On its limit a bar is at it, however short; inside, its legs are lost where their product is.
    let least = f32::MIN_POSITIVE;
    let short = |t: f32| ReachLine([t, least], GROUP).diagnose(0.0);
    assert_eq!((short(least), short(least / 2.0)), (Ok(0.0), Err(NOT_FINITE)));
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
        |value, d, spread| ReachCircles([d, 0.0, 3.0, 4.0, 24.0, spread], GROUP).diagnose(value);
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
    assert_eq!(ReachLine([0.0, f64::INFINITY], GROUP).diagnose(1.0), Err(NOT_FINITE));
    assert_eq!(ReachOffset([0.0, 0.0, f64::NAN], GROUP).diagnose(1.0), Err(NOT_FINITE));
    assert_eq!(circles(f64::NAN, [0.0, 0.0, 3.0, 3.0]), Err(SINGULAR));
}

#[test]
fn lengths_squares_and_divisors_say_what_is_wrong_with_them() {
    let invalid = SolveError::Invalid { group: GROUP, name: "lift" };
    let not_finite = SolveError::NotFinite { name: "lift" };
    assert_eq!(Positive(GROUP, "lift").diagnose(5e-324), Ok(5e-324));
    for zero_or_less in [0.0, -0.0, -1.0, f64::NEG_INFINITY] {
        assert_eq!(Positive(GROUP, "lift").diagnose(zero_or_less), Err(invalid));
    }
    assert_eq!(Positive(GROUP, "lift").diagnose(f64::NAN), Err(not_finite));
    assert_eq!(Nonzero(GROUP).diagnose(-1.0_f32), Ok(-1.0));
    assert_eq!(Nonzero(GROUP).diagnose(-0.0), Err(SINGULAR));
    assert_eq!(Nonzero(GROUP).diagnose(f64::NAN), Err(NOT_FINITE));
    // (10⁻⁹ m)² is a square of full precision also in single precision.
    assert_eq!(Square(GROUP).diagnose(1e-18_f32), Ok(1e-18));
    assert_eq!(Square(GROUP).diagnose(0.0), Err(SINGULAR));
    for out_of_range in [1e-30_f32, f32::INFINITY, f32::NAN, -1.0] {
        assert_eq!(Square(GROUP).diagnose(out_of_range), Err(NOT_FINITE));
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
