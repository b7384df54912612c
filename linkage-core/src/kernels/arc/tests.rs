//! The bound of the arc functions, against double words.

use std::vec::Vec;

use super::*;
use crate::cases::cases;
use crate::kernels::double_word::{self, DoubleWord};
use crate::kernels::{Fused, Fusion, Plain};

/// In units in the last place, as promised.
const BOUND: f64 = 1.5;

/// Numbers from 0 to 1: evenly, next to both ends, to a half and where the octants meet. An ordinary run takes
/// every fifth of those of `.ci/nightly`.
fn shares() -> Vec<f64> {
    let (even, doubling) = (cases(8000, 40_000) as u32, cases(12, 60) as u32);
    let mut shares: Vec<f64> = (0..=even).map(|k| f64::from(k) / f64::from(even)).collect();
    for k in 0..4000 * doubling / 60 {
        let small = 2_f64.powf(-f64::from(k) / f64::from(doubling));
        shares.extend([small, 1.0 - small, 0.5 * (1.0 - small), 0.5 * (1.0 + small)]);
    }
    for near in [0.5, 1.0, core::f64::consts::FRAC_1_SQRT_2] {
        shares.extend((-20..=20).map(|ulps| near + f64::from(ulps) * f64::EPSILON));
    }
    shares.retain(|share| (0.0..=1.0).contains(share));
    shares
}

/// The error of an angle in units in the last place, against the angle with these cosine and sine. It is
/// a first-order formula, whose own relative error is 10⁻³⁰.
fn off(angle: f64, [x, y]: [DoubleWord; 2], length: f64) -> f64 {
    let (sin, cos) = double_word::sin_cos(angle);
    let across = sin * x - cos * y;
    let ulp = angle.abs().next_up() - angle.abs();
    (across.high / length / ulp).abs()
}

fn exact(x: f64) -> DoubleWord {
    DoubleWord { high: x, low: 0.0 }
}

/// √(1 − x²) in two words, by a step of Newton's method.
fn other_leg(x: f64) -> DoubleWord {
    let square = (exact(1.0) - exact(x)) * (exact(1.0) + exact(x));
    let root = square.high.sqrt();
    if root == 0.0 {
        return exact(0.0);
    }
    DoubleWord::sum(root, (square - DoubleWord::product(root, root)).high / (2.0 * root))
}

fn are_within_the_bound<F: Fusion>() {
    let mut worst = [0.0_f64; 3];
    for x in shares().into_iter().flat_map(|x| [x, -x]) {
        let leg = other_leg(x);
        worst[0] = worst[0].max(off(wide::asin::<F>(x), [leg, exact(x)], 1.0));
        // At one the angle is zero, and so is its unit.
        if x < 1.0 {
            worst[1] = worst[1].max(off(wide::acos::<F>(x), [exact(x), leg], 1.0));
        }
        let [short, long] = [x * 0.7, 0.7_f64];
        for (y, x) in [(short, long), (long, short), (short, -long), (-long, short)] {
            let angle = wide::atan2::<F>(y, x);
            worst[2] = worst[2].max(off(angle, [exact(x), exact(y)], x.hypot(y)));
        }
        let (narrow, wide) = (x as f32, f64::from(x as f32));
        let ulps = |found: f32, truth: f64| {
            let ulp = f64::from((truth.abs() as f32).next_up() - truth.abs() as f32);
            assert!((f64::from(found) - truth).abs() <= BOUND * ulp, "{x}: {found:e} {truth:e}");
        };
        ulps(narrow::asin::<F>(narrow), wide::asin::<F>(wide));
        ulps(narrow::acos::<F>(narrow), wide::acos::<F>(wide));
        ulps(narrow::atan::<F>(narrow), wide::atan::<F>(wide));
        ulps(narrow::atan2::<F>(narrow, -0.3), wide::atan2::<F>(wide, f64::from(-0.3_f32)));
        ulps(narrow::atan2::<F>(0.9, narrow), wide::atan2::<F>(f64::from(0.9_f32), wide));
    }
    std::println!("asin, acos, atan2: {worst:.3?} units in the last place");
    assert!(worst.iter().all(|&worst| worst <= BOUND), "{worst:?}");
}

/// `cargo test -p linkage-core --lib arc -- --nocapture` prints the largest errors.
#[test]
fn arcs_are_within_their_bound() {
    are_within_the_bound::<Fused>();
    are_within_the_bound::<Plain>();
}

#[test]
fn arcs_of_special_numbers_are_those_of_libm() {
    let same = |found: f64, expected: f64, what: [f64; 2]| {
        // An ulp where neither is zero or none: both have a bound of more than a half.
        let is_near = expected != 0.0 && (found - expected).abs() <= f64::EPSILON * expected.abs();
        let is_same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
        let is_same = is_same || is_near;
        assert!(is_same, "{what:?}: {found} {expected}");
    };
    let (tiny, huge) = (f64::from_bits(1), f64::MAX);
    let special = [0.0, tiny, f64::MIN_POSITIVE, 1.0, huge, f64::INFINITY, f64::NAN];
    for y in special.into_iter().flat_map(|y| [y, -y]) {
        same(wide::asin::<Plain>(y), libm::asin(y), [y; 2]);
        same(wide::acos::<Plain>(y), libm::acos(y), [y; 2]);
        same(wide::atan::<Plain>(y), libm::atan(y), [y; 2]);
        for x in special.into_iter().flat_map(|x| [x, -x]) {
            // Half a turn is positive, and so is zero.
            same(wide::atan2::<Plain>(y, x), libm::atan2(y + 0.0, x), [y, x]);
        }
    }
    for beyond in [1.0_f64.next_up(), -2.0, f64::INFINITY] {
        assert!(wide::asin::<Plain>(beyond).is_nan() && wide::acos::<Plain>(beyond).is_nan());
    }
}
