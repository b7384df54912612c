//! Enclosures against digits of mpmath's, and against each other.

use core::cmp::Ordering;

use super::reference::Reference;
use super::{Enclosure, Exact, Random, defined, enclosed, number, value};

/// Each row: 101 digits of a postfix expression.
const ENCLOSED: &str = include_str!("enclosed.txt");

fn signed(text: &str) -> Exact {
    match text.strip_prefix('-') {
        Some(size) => number(size).neg(),
        None => number(text),
    }
}

/// True if some number lies in both.
fn overlap(a: &Enclosure, b: &Enclosure) -> bool {
    let difference = a.sub(b);
    difference.sign().is_none_or(Ordering::is_eq)
}

#[test]
fn the_truth_is_enclosed() {
    for row in ENCLOSED.lines() {
        let (digits, expression) = row.split_once(' ').expect("a row has two columns");
        let truth = signed(digits);
        let truth = truth.enclose(400).expect("a rational has an enclosure");
        let unknown = truth.mul(&number("1e-100").enclose(400).expect("a rational has one"));
        let truth = truth.widened(unknown.upper().max(&-unknown.lower()));
        for bits in [64, 128, 256, 320] {
            let by_form = defined(expression).enclose(bits).expect("defined");
            let by_operation = enclosed(expression, bits).expect("defined");
            assert!(overlap(&by_form, &truth), "`{expression}` at {bits} bits");
            assert!(overlap(&by_operation, &truth), "`{expression}` at {bits} bits");
        }
    }
}

#[test]
fn enclosures_are_tight() {
    for row in ENCLOSED.lines() {
        let (_, expression) = row.split_once(' ').expect("a row has two columns");
        let found = enclosed(expression, 256).expect("defined");
        // 256 bits are 77 digits; these expressions lose less than 17 of them.
        assert!(found.width() < 1e-60, "`{expression}` is {:e} wide", found.width());
        let truth = defined(expression).to_f64();
        assert!((found.to_f64() - truth).abs() <= truth.abs() * f64::EPSILON, "`{expression}`");
    }
}

/// The normal form of a number against the same number computed operation by operation.
#[test]
fn normal_forms_keep_the_value() {
    let mut random = Random(2024);
    let (mut compared, mut undefined) = (0, 0);
    while compared < 600 {
        let expression = random.expression(1 + compared % 4);
        let (Some(value), Some(enclosure)) = (value(&expression), enclosed(&expression, 256))
        else {
            undefined += 1;
            assert!(undefined < 1000, "most expressions are defined");
            continue;
        };
        compared += 1;
        let by_form = value.enclose(256).expect("256 bits resolve a small expression");
        assert!(overlap(&by_form, &enclosure), "`{expression}` is not {value}");
    }
}

/// The image of an enclosure contains the images of the points in it.
#[test]
fn wide_enclosures_hold_the_values_of_their_points() {
    type Function = (&'static str, fn(&Enclosure) -> Option<Enclosure>);
    let functions: [Function; 12] = [
        ("sqrt", Enclosure::sqrt),
        ("sin", |x| Some(x.sin())),
        ("cos", |x| Some(x.cos())),
        ("tan", Enclosure::tan),
        ("asin", Enclosure::asin),
        ("acos", Enclosure::acos),
        ("atan", |x| Some(x.atan())),
        ("neg", |x| Some(x.neg())),
        ("exp", Enclosure::exponential),
        ("ln", Enclosure::logarithm),
        ("tanh", |x| Some(x.hyperbolic_tangent())),
        ("reciprocal", |x| Enclosure::integer(1, 128).div(x)),
    ];
    let mut random = Random(5);
    for (name, function) in functions {
        for _ in 0..40 {
            let middle = random.below(4000) as f64 / 1000.0 - 2.0;
            let radius = [0.0, 1e-30, 1e-6, 0.1, 3.0][random.below(5) as usize];
            let point = |place: f64| {
                let offset = Enclosure::float(radius, 128).expect("finite");
                let place = Enclosure::float(place, 128).expect("finite").mul(&offset);
                Enclosure::float(middle, 128).expect("finite").add(&place)
            };
            let wide = hull(&point(-1.0), &point(1.0));
            let Some(image) = function(&wide) else { continue };
            for place in [-1.0, -0.75, -0.25, 0.0, 0.5, 1.0] {
                if let Some(value) = function(&point(place)) {
                    assert!(overlap(&image, &value), "{name} of {middle} ± {radius} at {place}");
                }
            }
        }
    }
}

fn hull(a: &Enclosure, b: &Enclosure) -> Enclosure {
    Enclosure::new(a.lower().clone(), b.upper().clone(), a.bits())
}

#[test]
fn wide_boxes_hold_the_angles_of_their_points() {
    let mut random = Random(11);
    let mut sides = || {
        let middle = random.below(400) as f64 / 100.0 - 2.0;
        let radius = [0.0, 1e-20, 0.01, 0.3, 1.0][random.below(5) as usize];
        let point = |place: f64| Enclosure::float(middle + radius * place, 128).expect("finite");
        [point(-1.0), point(-0.5), point(0.0), point(1.0)]
    };
    for _ in 0..200 {
        let (y, x) = (sides(), sides());
        let (wide_y, wide_x) = (hull(&y[0], &y[3]), hull(&x[0], &x[3]));
        let angle = wide_y.atan2(&wide_x);
        let (length, product) = (wide_y.hypot(&wide_x), wide_y.mul(&wide_x));
        let holds_zero = |side: &Enclosure| side.sign().is_none_or(Ordering::is_eq);
        assert_eq!(angle.is_none(), holds_zero(&wide_y) && holds_zero(&wide_x));
        for y in &y {
            for x in &x {
                assert!(overlap(&length, &y.hypot(x)) && overlap(&product, &y.mul(x)));
                if let Some(angle) = &angle {
                    assert!(overlap(angle, &y.atan2(x).expect("not the zero vector")));
                }
            }
        }
    }
}

#[test]
fn functions_of_points_are_a_few_ulp_wide() {
    let ulp = 2_f64.powi(-200);
    for text in ["0", "0.3", "1", "0.999999999999", "1e-30", "0.5"] {
        let x = number(text).enclose(200).expect("a rational has an enclosure");
        for value in [x.sin(), x.cos(), x.atan(), x.neg().sin(), x.hypot(&x)] {
            assert!(value.width() <= 8.0 * ulp, "{text}");
        }
        // Next to ±1 one ulp of the sine is 10^6 of the angle.
        assert!(x.asin().expect("within one").width() <= 1e7 * ulp, "{text}");
    }
    for text in ["1e6", "1e20", "123456789.25"] {
        let x = number(text).enclose(200).expect("a rational has an enclosure");
        assert!(x.sin().width() <= 8.0 * ulp && x.neg().cos().width() <= 8.0 * ulp, "{text}");
        assert!(x.neg().atan().width() <= 8.0 * ulp, "{text}");
    }
}

#[test]
fn what_an_enclosure_cannot_tell_is_none() {
    let around_zero = |radius: f64| {
        let radius = Enclosure::float(radius, 128).expect("finite");
        hull(&radius.neg(), &radius)
    };
    let one = Enclosure::integer(1, 128);
    assert_eq!(one.div(&around_zero(1e-30)), None);
    assert_eq!(one.neg().sqrt(), None);
    assert_eq!(one.add(&one).asin(), None);
    assert_eq!(one.add(&one).neg().acos(), None);
    assert_eq!(around_zero(1e-30).atan2(&around_zero(1e-30)), None);
    assert_eq!(around_zero(1.0).sign(), None);
    let quarter = Enclosure::pi(128).halved();
    assert_eq!(quarter.tan(), None);
    // Across the branch cut every angle is possible.
    let angle = around_zero(1e-30).atan2(&one.neg()).expect("not the zero vector");
    assert!((angle.width() - core::f64::consts::TAU).abs() < 1e-15);
    assert_eq!(one.sub(&one).atan2(&one.neg()).map(|pi| pi.to_f64()), Some(core::f64::consts::PI));
}

#[test]
fn decimals_of_the_middle() {
    assert_eq!(Enclosure::pi(256).to_decimal(30), "3.141592653589793238462643383279");
    assert_eq!(Enclosure::pi(256).neg().to_decimal(5), "-3.14159");
    assert_eq!(Enclosure::integer(-12, 64).to_decimal(0), "-12");
    let thousandth = number("0.0625").enclose(64).expect("a rational has an enclosure");
    assert_eq!(thousandth.to_decimal(6), "0.062500");
}

#[test]
fn units_are_mixed_in_the_finer_ones() {
    let (coarse, fine) = (Enclosure::pi(64), Enclosure::pi(200));
    let difference = fine.sub(&coarse);
    assert_eq!(difference.bits(), 200);
    assert_eq!(difference.sign(), None);
    assert!(overlap(&coarse, &fine.with_bits(64)));
    assert!(fine.with_bits(64).width() <= 2.0_f64.powi(-63));
}
