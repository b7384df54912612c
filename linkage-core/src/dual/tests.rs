//! Against closed forms in f64; and each number against the others, which have chain rules of
//! their own.

use nalgebra::{Const, U1};
use num_dual::{
    Dual, Dual2, Dual2SVec, Dual3, DualNum, DualSVec, HyperDual, HyperDualVec, HyperHyperDual,
};

use crate::chain_rule::Compose;
use crate::clearance::Jet;
use crate::{Real, Scalar};

/// A few roundings of numbers of the size of `scale`.
#[track_caller]
fn assert_close(value: f64, expected: f64, scale: f64) {
    let allowed = 16.0 * f64::EPSILON * scale;
    assert!((value - expected).abs() <= allowed, "{value} instead of {expected} ± {allowed:e}");
}

fn parts(x: Dual3<f64>) -> [f64; 4] {
    [x.re, x.v1, x.v2, x.v3]
}

#[track_caller]
fn assert_parts(x: Dual3<f64>, expected: [f64; 4]) {
    for (value, expected) in parts(x).into_iter().zip(expected) {
        assert_close(value, expected, expected.abs().max(1.0));
    }
}

/// t with the derivatives 1, 0, 0.
fn variable(t: f64) -> Dual3<f64> {
    Dual3::from_re(t).derivative()
}

#[test]
fn functions_of_one_number_have_their_derivatives() {
    for x in [0.25_f64, 0.6, 1.0, 2.5] {
        let r = x.sqrt();
        let expected = [r, 0.5 / r, -0.25 / (x * r), 0.375 / (x * x * r)];
        assert_parts(Scalar::sqrt(variable(x)), expected);
    }
    for x in [-2.5_f64, -0.3, 0.0, 1.2, 3.0] {
        let (s, c, t) = (x.sin(), x.cos(), x.tan());
        for (sin, cos) in [Scalar::sin_cos(variable(x)), variable(x).sin_cos_near()] {
            assert_parts(sin, [s, c, -s, -c]);
            assert_parts(cos, [c, -s, -c, s]);
        }
        let sec2 = 1.0 + t * t;
        let expected = [t, sec2, 2.0 * t * sec2, sec2 * (2.0 + 6.0 * t * t)];
        assert_parts(Scalar::tan(variable(x)), expected);
        let q = 1.0 + x * x;
        let expected = [x.atan(), 1.0 / q, -2.0 * x / (q * q), (6.0 * x * x - 2.0) / (q * q * q)];
        assert_parts(Scalar::atan(variable(x)), expected);
    }
    for x in [-1.5_f64, -0.2, 0.0, 0.4, 2.0] {
        let (e, t) = (x.exp(), x.tanh());
        assert_parts(Scalar::exp(variable(x)), [e; 4]);
        let q = 1.0 - t * t;
        let expected = [t, q, -2.0 * t * q, q * (6.0 * t * t - 2.0)];
        assert_parts(Scalar::tanh(variable(x)), expected);
    }
    for x in [0.2_f64, 1.0, 3.0] {
        let expected = [x.ln(), 1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)];
        assert_parts(Scalar::ln(variable(x)), expected);
        for y in [-1.3_f64, 0.5, 2.0, 3.7] {
            let (f1, f2) = (y * x.powf(y - 1.0), y * (y - 1.0) * x.powf(y - 2.0));
            let f3 = y * (y - 1.0) * (y - 2.0) * x.powf(y - 3.0);
            let power = Scalar::pow(variable(x), Dual3::from_re(y));
            // Each derivative is made of the one before by three operations.
            for (value, expected) in parts(power).into_iter().zip([x.powf(y), f1, f2, f3]) {
                assert_close(value, expected, expected.abs());
            }
            // As an exponent: xʸ lnⁿ x.
            let (power, log) = (Scalar::pow(Dual3::from_re(y.abs()), variable(x)), y.abs().ln());
            let expected = [0, 1, 2, 3].map(|n| y.abs().powf(x) * log.powi(n));
            assert_parts(power, expected);
        }
    }
    for x in [-0.7_f64, 0.0, 0.1, 0.5] {
        let q = 1.0 - x * x;
        let [f1, f2, f3] = [q.powf(-0.5), x * q.powf(-1.5), (1.0 + 2.0 * x * x) * q.powf(-2.5)];
        assert_parts(Scalar::asin(variable(x)), [x.asin(), f1, f2, f3]);
        assert_parts(Scalar::acos(variable(x)), [x.acos(), -f1, -f2, -f3]);
    }
}

/// A point that goes round: its angle is t, its distance ρ(t) = 2 + t/3 + t².
fn spiral(t: Dual3<f64>) -> (Dual3<f64>, Dual3<f64>, Dual3<f64>) {
    let (sin, cos) = Scalar::sin_cos(t);
    let distance = Dual3::from_re(2.0) + t / Dual3::from_re(3.0) + t * t;
    (distance * cos, distance * sin, distance)
}

#[test]
fn angle_and_length_of_a_vector_are_right_all_around() {
    use core::f64::consts::{FRAC_PI_2, PI};
    for t in [0.0, 0.5, FRAC_PI_2, 2.0, 3.0, -0.1, -FRAC_PI_2, -2.5] {
        let (x, y, distance) = spiral(variable(t));
        let angle = Scalar::atan2(y, x);
        // Derivatives of the point grow with the order: up to 30 at the third.
        for (value, expected) in parts(angle).into_iter().zip([t, 1.0, 0.0, 0.0]) {
            assert_close(value, expected, 30.0);
        }
        for (value, expected) in parts(Scalar::hypot(x, y)).into_iter().zip(parts(distance)) {
            assert_close(value, expected, 30.0);
        }
    }
    // On the axes to the last bit: the angle of (x, y) turns by dy/x, or by −dx/y.
    let up = Scalar::atan2(Dual::new(2.0, 3.0), Dual::new(0.0, 1.0));
    assert_eq!((up.re, up.eps), (FRAC_PI_2, -0.5));
    let down = Scalar::atan2(Dual::new(-2.0, 3.0), Dual::new(0.0, 1.0));
    assert_eq!((down.re, down.eps), (-FRAC_PI_2, 0.5));
    let back = Scalar::atan2(Dual::new(-0.0, 3.0), Dual::new(-2.0, 1.0));
    assert_eq!((back.re, back.eps), (PI, -1.5));
    let length = Scalar::hypot(Dual::new(0.0, 7.0), Dual::new(-2.0, 1.0));
    assert_eq!((length.re, length.eps), (2.0, -1.0));
    // Squares beyond the range do not matter.
    let far = Scalar::atan2(Dual::new(1e200, 0.0), Dual::new(1e200, 1e200));
    assert_close(far.eps, -0.5, 1.0);
    assert_close(Scalar::hypot(Dual::new(3e200, 1.0), Dual::new(4e200, 0.0)).eps, 0.6, 1.0);
}

#[test]
fn constants_stay_finite_where_a_derivative_would_not() {
    fn check<D: Compose>(one: D) {
        let [zero, minus_one] = [D::lit(0.0, 0.0), D::lit(-1.0, -1.0)];
        for (result, expected) in [
            (zero.sqrt(), 0.0),
            (one.asin(), core::f64::consts::FRAC_PI_2),
            (minus_one.acos(), core::f64::consts::PI),
            (Scalar::atan2(zero, zero), 0.0),
            (Scalar::hypot(zero, zero), 0.0),
        ] {
            assert!(Scalar::is_finite(result) && result.is_constant(), "{result:?}");
            assert!((result.value() - expected).abs() < 1e-6);
        }
    }
    check(Dual::from_re(1.0));
    check(Dual::from_re(1.0_f32));
    check(Dual2::from_re(1.0));
    check(Dual3::from_re(1.0));
    check(HyperDual::from_re(1.0));
    check(HyperHyperDual::from_re(1.0));
    check(DualSVec::<f64, 3>::from_re(1.0));
    check(Dual2SVec::<f32, 2>::from_re(1.0));
    check(HyperDualVec::<f64, Const<2>, Const<2>>::from_re(1.0));
    check(Dual::from_re(Dual2::from_re(1.0)));
}

/// A derivative of zero is none: √(x²) has a kink at zero.
#[test]
fn what_depends_on_something_is_no_constant_where_its_derivative_is_zero() {
    let x = DualSVec::<f64, 2>::from_re(0.0).derivative(0);
    assert!(!Real::is_constant(x * x) && !Scalar::is_finite(Scalar::sqrt(x * x)));
    let x = Dual2SVec::<f64, 1>::from_re(0.0).derivative(0);
    assert!(!Real::is_constant(x * x * x) && !Scalar::is_finite(Scalar::sqrt(x * x * x)));
    assert!(DualSVec::<f64, 2>::from_re(0.0).is_constant());
}

/// The root of 10⁻²²⁰ is 10⁻¹¹⁰, its derivative 5·10¹⁰⁹, the second is out of range.
#[test]
fn constants_do_not_meet_a_second_derivative_out_of_range() {
    fn check<D: Compose>(x: D) {
        let root = x.sqrt();
        assert!(root.is_constant() && (root.value() - 1e-110).abs() < 1e-125, "{root:?}");
    }
    check(Dual2::from_re(1e-220));
    check(HyperDual::from_re(1e-220));
    check(Dual2SVec::<f64, 2>::from_re(1e-220));
    check(Dual::<f64>::from_re(1e-220));
    let first = Scalar::sqrt(Dual::new(1e-220_f64, 1.0));
    assert!((first.eps / 5e109 - 1.0).abs() < 1e-14);
    assert!(!Scalar::is_finite(Scalar::sqrt(Dual2::new(1e-220, 1.0, 0.0))));
}

#[test]
fn an_infinite_derivative_is_not_finite() {
    let zero = Dual::new(0.0, 1.0);
    assert!(!Scalar::is_finite(Scalar::sqrt(zero)));
    assert!(!Scalar::is_finite(Scalar::asin(Dual::new(1.0, 1e-300))));
    assert!(!Scalar::is_finite(Scalar::atan2(zero, Dual::new(0.0, 0.0))));
    assert!(!Scalar::is_finite(Scalar::sqrt(DualSVec::<f64, 2>::from_re(0.0).derivative(1))));
    let inner = Dual::from_re(Dual::new(0.0, 1.0));
    assert!(!Scalar::is_finite(Scalar::sqrt(inner)) && !inner.is_constant());
    let second_only = Dual2::new(0.0, 0.0, 1.0);
    assert!(!Scalar::is_finite(Scalar::sqrt(second_only)) && !second_only.is_constant());
}

/// Every function once, with all derivatives in play: a function of one variable near 0.3.
fn everything<T: Scalar>(t: T) -> T {
    let c = |x: f64| T::lit(x, x as f32);
    let (sin, cos) = t.sin_cos();
    let root = (c(1.0) + t * t).sqrt();
    let arcs = (t * t).asin() + (t / c(2.0)).acos() * t.atan() + (t * c(0.5)).tan();
    let polar = Scalar::atan2(sin - c(2.0), cos * t - c(0.25)) * Scalar::hypot(t, sin + c(1.0));
    let laws = (t * c(0.5)).exp() * root.ln() - sin.tanh() + root.pow(cos - t) * t.pow(c(1.3));
    T::det(root, arcs, polar, sin) + T::fused(sin, cos, t) / (root + c(1.0)) + laws
}

#[test]
fn all_numbers_agree_on_all_derivatives() {
    let t = 0.3;
    let [f0, f1, f2, f3] = parts(everything(variable(t)));
    assert_close(f0, everything(t), 4.0);
    let same = |value: f64, expected: f64| assert_close(value, expected, 10.0 * expected.abs());

    same(everything(Dual::from_re(t).derivative()).eps, f1);
    let second = everything(Dual2::from_re(t).derivative());
    same(second.v1, f1);
    same(second.v2, f2);
    let mixed = everything(HyperDual::from_re(t).derivative1().derivative2());
    same(mixed.eps1, f1);
    same(mixed.eps2, f1);
    same(mixed.eps1eps2, f2);
    let third = everything(HyperHyperDual::from_re(t).derivative1().derivative2().derivative3());
    same(third.eps3, f1);
    for second in [third.eps1eps2, third.eps1eps3, third.eps2eps3] {
        same(second, f2);
    }
    same(third.eps1eps2eps3, f3);
    let gradient = everything(DualSVec::<f64, 2>::from_re(t).derivative(1)).eps;
    let gradient = gradient.unwrap_generic(Const::<2>, U1);
    same(gradient[1], f1);
    assert_eq!(gradient[0], 0.0);
    let hessian = everything(Dual2SVec::<f64, 2>::from_re(t).derivative(0)).v2;
    same(hessian.unwrap_generic(Const::<2>, Const::<2>)[(0, 0)], f2);
    let block = HyperDualVec::<f64, Const<1>, Const<2>>::from_re(t).derivative1(0).derivative2(1);
    same(everything(block).eps1eps2.unwrap_generic(Const::<1>, Const::<2>)[(0, 1)], f2);

    let jet = everything(Jet::along(t, 1.0));
    same(jet.rate, f1);
    same(jet.second_rate, f2);

    let nested = Dual::new(Dual2::from_re(t).derivative(), Dual2::from_re(1.0));
    let nested = everything(nested);
    same(nested.re.v2, f2);
    same(nested.eps.re, f1);
    same(nested.eps.v1, f2);
    same(nested.eps.v2, f3);
}

/// Constants are left out of the sums, by each operation and with either operand constant.
#[test]
fn moving_and_standing_numbers_meet_as_dual_numbers_do() {
    let [re, v1, v2] = [[0.75, 0.5, -1.25], [1.5, -2.0, 3.0], [-0.5, 0.25, 0.125]];
    for moving in 0..8 {
        let moves = |at: usize| moving >> at & 1 == 1;
        let dual = [0, 1, 2].map(|at| match moves(at) {
            true => Dual2::new(re[at], v1[at], v2[at]),
            false => Dual2::from_re(re[at]),
        });
        // An acceleration comes of composing: x² has 2 ẋ² + 2 x ẍ.
        let jet = [0, 1, 2].map(|at| match moves(at) {
            true => Jet::along(0.0, 1.0).compose([re[at], v1[at], v2[at], 0.0]),
            false => Jet::standing(re[at]),
        });
        fn each<T: Scalar>([a, b, c]: [T; 3]) -> [T; 8] {
            let fused = [T::fused(a, b, c), T::fused(-a, b, -c)];
            [a + b, a - b, -a, a * b, a / b, fused[0], fused[1], T::det(a, b, c, a)]
        }
        for (jet, dual) in each(jet).into_iter().zip(each(dual)) {
            assert_close(jet.value, dual.re, 1.0);
            assert_close(jet.rate, dual.v1, 4.0);
            assert_close(jet.second_rate, dual.v2, 16.0);
            assert_eq!(jet.is_constant(), dual.is_constant(), "{jet:?} for {dual:?}");
        }
    }
    // Nothing is computed with a rate of zero: it would be no number here.
    let product = Jet::standing(f64::INFINITY) * Jet::standing(2.0);
    assert!(product.rate == 0.0 && product.is_constant());
}

#[test]
fn single_precision_has_derivatives_too() {
    let [_, f1, f2, _] = parts(everything(variable(0.3)));
    let x = everything(Dual2::from_re(0.3_f32).derivative());
    // As in double precision, in units of single precision.
    let allowed = 160.0 * f64::from(f32::EPSILON);
    assert!((f64::from(x.v1) - f1).abs() <= allowed * f1.abs());
    assert!((f64::from(x.v2) - f2).abs() <= allowed * f2.abs());
    assert_eq!(<Dual2<f32> as Real>::EPSILON, f64::from(f32::EPSILON));
}

#[test]
fn rounding_errors_and_conditions_look_at_real_parts() {
    let [a, b] = [Dual::new(0.1, 1.0), Dual::new(0.3, 1.0)];
    let error = Scalar::mul_err(a, b);
    assert_eq!((error.re, error.eps), (Scalar::mul_err(0.1, 0.3), 0.0));
    assert!(error.re != 0.0);
    let error = Scalar::add_err(a, b);
    assert_eq!((error.re, error.eps), (Scalar::add_err(0.1, 0.3), 0.0));
    let det = Scalar::det(a, b, b, a + Dual::from_re(f64::EPSILON));
    assert_eq!(det.re, Scalar::det(0.1, 0.3, 0.3, 0.1 + f64::EPSILON));
    assert!(Scalar::ge(a, a) && !Scalar::gt(a, Dual::new(0.1, -1.0)) && Scalar::gt(b, a));
    assert_eq!(Scalar::select(false, a, b).re, 0.3);
    assert!(!a.is_constant() && Dual::<f64>::from_re(0.1).is_constant());
    assert!(!Scalar::is_finite(Dual::new(1.0, f64::NAN)));
    assert!(a.is_near() && !Dual::new(1e9, 0.0).is_near());
    assert_eq!(Dual::<f32>::smallest_square().re, f32::smallest_square());
    assert_eq!(a.recip().value(), 10.0);
}
