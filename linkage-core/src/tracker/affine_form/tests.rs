//! Ranges hold every value that formulas take.

use core::f64::consts::TAU;

use super::*;

type Ball = AffineForm<f64>;

fn contains(ball: Ball, value: f64) -> bool {
    let [low, high] = ball.bounds();
    low <= value && value <= high
}

/// Every function of one and two operands on ranges of many sizes: what it takes at the ends,
/// in the middle and in between lies inside; and the range is not much larger than it must be.
#[test]
fn a_range_holds_every_value() {
    type One = (fn(Ball) -> Ball, fn(f64) -> f64);
    type Two = (fn(Ball, Ball) -> Ball, fn(f64, f64) -> f64);
    let ones: [One; 11] = [
        (Scalar::sqrt, f64::sqrt),
        (|x| x.sin_cos().0, f64::sin),
        (|x| x.sin_cos().1, f64::cos),
        (Scalar::tan, f64::tan),
        (Scalar::asin, f64::asin),
        (Scalar::acos, f64::acos),
        (Scalar::atan, f64::atan),
        (Scalar::exp, f64::exp),
        (Scalar::ln, f64::ln),
        (Scalar::tanh, f64::tanh),
        (|x| -x, |x| -x),
    ];
    let twos: [Two; 7] = [
        (|x, y| x + y, |x, y| x + y),
        (|x, y| x - y, |x, y| x - y),
        (|x, y| x * y, |x, y| x * y),
        (|x, y| x / y, |x, y| x / y),
        (Scalar::atan2, f64::atan2),
        (Scalar::hypot, f64::hypot),
        (Scalar::pow, f64::powf),
    ];
    let parts = [-1.0, -0.6, 0.0, 0.3, 1.0];
    let mut known = 0;
    for x in [0.01, 0.3, 0.7, 0.95] {
        for radius in [0.0, 1e-12, 1e-3, 0.04, 0.4] {
            let ball = Ball::around(x, radius);
            for (index, (of_range, of_number)) in ones.iter().enumerate() {
                let range = of_range(ball);
                known += usize::from(range.is_finite());
                for part in parts {
                    let value = of_number(x + part * radius);
                    let inside = value.is_nan() || contains(range, value);
                    assert!(inside || !range.is_finite(), "{index} {x} {radius} {part}");
                }
            }
            for y in [-0.9, 0.2, 0.5] {
                // Along the step of the first, against it, or on its own.
                let others = [radius / 3.0, -radius / 3.0].map(|radius| Ball::around(y, radius));
                let others = [others[0], others[1], Ball::anywhere(y, radius / 3.0)];
                for (index, (of_ranges, of_numbers), way) in twos
                    .iter()
                    .enumerate()
                    .flat_map(|(index, of)| [0, 1, 2].map(|way| (index, of, way)))
                {
                    let range = of_ranges(ball, others[way]);
                    known += usize::from(range.is_finite());
                    for (p, q) in parts.iter().flat_map(|&p| parts.map(|q| (p, q))) {
                        let q = [p, -p, q][way];
                        let value = of_numbers(x + p * radius, y + q * radius / 3.0);
                        let turned = [value, value + TAU, value - TAU];
                        let inside = turned.map(|value| contains(range, value));
                        let is_angle = index == 4;
                        let inside = inside[0] || is_angle && (inside[1] || inside[2]);
                        let inside = inside || !range.is_finite();
                        assert!(inside, "{index} {x} {y} {radius}: {value:e} {range:?}");
                    }
                }
            }
        }
    }
    // There are 20 ranges for 11 functions and 180 pairs for 7: less than a tenth may stay unknown.
    assert!(known > (20 * 11 + 180 * 7) * 9 / 10, "{known}");
}

/// A product of two ranges, each of a middle, a slope and a radius: nothing it can be is left out, and
/// where all of the signs agree it is as large as its bound says, which therefore has each of its parts.
#[test]
fn a_product_reaches_its_bound_and_no_farther() {
    let ways = [-1.0, -0.5, 0.0, 0.25, 1.0];
    let middles = [2.0, -2.0, 0.5, -0.125, 0.0];
    let parts = [0.0, 0.25, 1.0, 3.0];
    for (a, p, r) in all(middles, parts) {
        for (b, q, s) in all(middles, parts) {
            let [x, y] = [(a, p, r), (b, q, s)].map(|(middle, slope, radius)| Ball {
                middle,
                slope,
                radius,
            });
            let product = x * y;
            let [low, high] = product.bounds();
            let (mut least, mut most) = (f64::MAX, f64::MIN);
            for step in ways {
                for (m, n) in ways.iter().flat_map(|&m| ways.map(|n| (m, n))) {
                    let value = (a + p * step + r * m) * (b + q * step + s * n);
                    (least, most) = (least.min(value), most.max(value));
                }
            }
            assert!(low <= least && most <= high, "{x:?} {y:?}: {product:?} for {least} to {most}");
            if a > 0.0 && b > 0.0 {
                // At the end of the step and of both radii; its own rounding is some ε of it.
                assert!(high <= most * (1.0 + 1e-14), "{x:?} {y:?}: {high} for {most}");
            }
        }
    }
}

/// Every middle with every slope and radius of these sizes.
fn all(middles: [f64; 5], parts: [f64; 4]) -> impl Iterator<Item = (f64, f64, f64)> {
    let of = move |middle| parts.into_iter().map(move |slope| (middle, slope));
    let of = middles.into_iter().flat_map(of);
    of.flat_map(move |(middle, slope)| parts.map(|radius| (middle, slope, radius)))
}

#[test]
fn what_has_no_value_somewhere_is_unknown() {
    let across_zero = Ball::around(0.1, 0.2);
    let one = Ball::lit(1.0, 1.0);
    for unknown in [across_zero.sqrt(), one / across_zero, (one + across_zero).asin()] {
        assert!(!unknown.is_finite(), "{unknown:?}");
    }
    assert!(!across_zero.atan2(across_zero).is_finite());
    assert!(!Ball::around(f64::NAN, 0.0).sqrt().is_finite());
    assert!(!(Ball::around(1e308, 1.0) * Ball::around(1e308, 1.0)).is_finite());
}

/// Sin and cos near their extremes change with the square of the range.
#[test]
fn ranges_are_tight() {
    let radius = |ball: Ball| {
        let [low, high] = ball.bounds();
        (high - low) / 2.0
    };
    assert!(radius(Ball::around(0.0, 1e-3).sin_cos().1) < 1e-6);
    assert!(radius(Ball::around(0.0, 1e-3).sin_cos().0) < 1.001e-3);
    assert!(radius(Ball::around(5.0, 1e9).sin_cos().0) <= 2.1);
    assert!(radius(Ball::around(4.0, 1e-3).sqrt()) < 2.6e-4);
    assert!(radius(Ball::anywhere(2.0, 0.0) * Ball::anywhere(3.0, 0.0)) <= 20.0 * f64::EPSILON);
}

/// Parts common to two ranges to first order cancel, whatever operations made them.
#[test]
fn what_is_common_cancels() {
    let radius = |ball: Ball| {
        let [low, high] = ball.bounds();
        (high - low) / 2.0
    };
    let (one, two) = (Ball::lit(1.0, 1.0), Ball::lit(2.0, 2.0));
    for step in [1e-2, 1e-3] {
        let x = Ball::around(0.7, step);
        let (sin, cos) = x.sin_cos();
        let root = (two - sin * sin).sqrt();
        let differences = [
            sin * sin + cos * cos - one,
            root * root + sin * sin - two,
            sin.atan2(cos) - x,
            (sin + sin).hypot(cos + cos) - two,
            one / (one / root) - root,
        ];
        for (index, difference) in differences.into_iter().enumerate() {
            assert!(radius(difference) < 12.0 * step * step, "{index} {step}: {difference:?}");
            assert!(contains(difference, 0.0), "{index} {step}: {difference:?}");
        }
    }
}

/// The roots of x² = a for all a of a range, and no more: that is √a.
#[test]
fn all_roots_of_a_range_of_equations() {
    let squares = |a: Ball| move |x: Ball| [x * x - a, x + x];
    for (a, off) in [(2.0, 0.1), (2.0, 1e-6), (1e-4, 1e-6), (1e-4, 3e-5)] {
        let middle = Ball::anywhere(f64::sqrt(a), 0.0);
        let roots = middle.with_all_roots(squares(Ball::anywhere(a, off)));
        let (least, most) = ((a - off).sqrt(), (a + off).sqrt());
        assert!(contains(roots, least) && contains(roots, most), "{a} {off}: {roots:?}");
        let [low, high] = roots.bounds();
        assert!(high - low < 1.6 * (most - least), "{a} {off}: {roots:?}");
    }
    // As far as zero there is no telling.
    let zero = Ball::anywhere(0.1, 0.0).with_all_roots(squares(Ball::anywhere(0.01, 0.01)));
    assert!(!zero.is_finite(), "{zero:?}");
    let plain = 0.3_f64.with_all_roots(|_| [f64::NAN; 2]);
    assert_eq!(plain, 0.3);
}
