//! The error bounds the kernels state, tested against the truth.

use std::vec::Vec;

use super::double_word::{self, DoubleWord};
use super::far_arguments::{FAR_ARGUMENTS, FAR_ARGUMENTS_F32};
use super::hard_arguments::{HARD_ARGUMENTS, HardArgument};
use super::{Fused, Fusion, NEAR_F32, NEAR_F64, Plain, sin_cos_f32, sin_cos_f64};
use crate::Scalar;
use crate::cases::cases;

/// In units in the last place: a little above the largest errors seen, 0.79 and 0.84, so that a
/// rounding too many shows, and below the one unit that is promised.
const BOUND: f64 = 0.85;

/// The larger of the two errors in units in the last place.
fn error_f64<F: Fusion>(x: f64, (sin, cos): (DoubleWord, DoubleWord)) -> f64 {
    let (s, c) = sin_cos_f64::sin_cos::<F>(x);
    sin.distance_in_ulp(s, 53).max(cos.distance_in_ulp(c, 53))
}

/// The bound of the fast kernel in units in the last place. The promised error is the sum of half a unit
/// for the last rounding, half for that of 1 − r²/2, a quarter for that of r², 0.36 for the remainder's
/// times sin π/4, and less than 0.1 for the series. The largest error seen is 1.42.
const NEAR_BOUND: f64 = 1.7;

/// The same of the fast kernel where operations are fused, without what two words of π/2 are off by: a
/// third one, for every quarter turn.
fn error_near(x: f64, (sin, cos): (DoubleWord, DoubleWord)) -> f64 {
    let (s, c) = sin_cos_f64::sin_cos_near::<Fused, true>(x);
    let off = 1.5e-33 * (x * core::f64::consts::FRAC_2_PI).abs().round();
    let [sin, cos] = [(sin, s), (cos, c)].map(|(truth, found)| {
        let error = ((found - truth.high) - truth.low).abs();
        if error <= off { 0.0 } else { truth.distance_in_ulp(found, 53) * (1.0 - off / error) }
    });
    sin.max(cos)
}

fn error_f32<F: Fusion>(x: f32, (sin, cos): (f64, f64)) -> f64 {
    let (s, c) = sin_cos_f32::sin_cos::<F>(x);
    let truth = |high| DoubleWord { high, low: 0.0 };
    truth(sin).distance_in_ulp(s.into(), 24).max(truth(cos).distance_in_ulp(c.into(), 24))
}

/// The arguments of a table with sine and cosine as double words.
fn in_double_words(table: &[HardArgument]) -> Vec<(f64, DoubleWord, DoubleWord)> {
    let word = |bits: u64, ulps: f64| {
        let high = f64::from_bits(bits);
        let ulp = f64::from_bits((high.abs().to_bits() & !((1 << 52) - 1)).max(53 << 52))
            * 2f64.powi(-52);
        DoubleWord { high, low: ulps * ulp }
    };
    let entry = |&(x, sin, sin_rest, cos, cos_rest): &_| {
        (f64::from_bits(x), word(sin, sin_rest), word(cos, cos_rest))
    };
    table.iter().map(entry).collect()
}

fn hard_arguments() -> Vec<(f64, DoubleWord, DoubleWord)> {
    in_double_words(&HARD_ARGUMENTS)
}

/// `count` arguments from `from` to `to` in equal ratios, with alternating signs.
fn sweep(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    let step = (to / from).ln() / f64::from(count);
    (0..=count).map(move |i| {
        let x = (from * (step * f64::from(i)).exp()).min(to);
        if i % 2 == 0 { x } else { -x }
    })
}

#[test]
fn the_reference_agrees_with_eighty_digits() {
    for (x, sin, cos) in hard_arguments() {
        let (s, c) = double_word::sin_cos(x);
        for (truth, word) in [(sin, s), (cos, c)] {
            // The table's rest is rounded to 5·10⁻⁶ of a last place.
            let rest = ((word.high - truth.high) + (word.low - truth.low)).abs();
            assert!(rest <= 1e-5 * f64::EPSILON * truth.high.abs(), "{x:e} {word:?} {truth:?}");
        }
    }
}

#[test]
fn f64_keeps_its_bound_at_hard_arguments() {
    for (x, sin, cos) in hard_arguments() {
        let errors = [error_f64::<Plain>(x, (sin, cos)), error_f64::<Fused>(x, (sin, cos))];
        assert!(errors[0].max(errors[1]) <= BOUND, "{errors:?} ulp at {x:e}");
        let error = error_near(x, (sin, cos));
        assert!(error <= NEAR_BOUND, "{error} ulp at {x:e}");
    }
}

#[test]
fn the_fast_kernel_is_the_other_where_nothing_is_fused() {
    for x in sweep(1e-9, NEAR_F64, 2000) {
        assert_eq!(sin_cos_f64::sin_cos_near::<Plain, true>(x), sin_cos_f64::sin_cos::<Plain>(x));
    }
}

/// A sample of the arguments of `.ci/nightly`.
#[test]
fn f64_keeps_its_bound_on_dense_sweeps() {
    f64_keeps_its_bound(cases(8000, 20_000) as u32);
}

#[test]
#[ignore = "two minutes in release: a thousand times as dense"]
fn f64_keeps_its_bound_on_denser_sweeps() {
    f64_keeps_its_bound(20_000_000);
}

fn f64_keeps_its_bound(count: u32) {
    for (from, to) in [(1e-9, 0.1), (0.1, 7.0), (7.0, 1000.0), (1000.0, NEAR_F64)] {
        for x in sweep(from, to, count) {
            let truth = double_word::sin_cos(x);
            let errors = [error_f64::<Plain>(x, truth), error_f64::<Fused>(x, truth)];
            assert!(errors[0].max(errors[1]) <= BOUND, "{errors:?} ulp at {x:e}");
            let error = error_near(x, truth);
            assert!(error <= NEAR_BOUND, "{error} ulp at {x:e}");
        }
    }
}

/// A sample of the arguments of `.ci/nightly`.
#[test]
fn f32_keeps_its_bound_on_dense_sweeps() {
    // A part of all numbers up to the limit, by a prime.
    f32_keeps_its_bound(cases(3001, 1009));
}

#[test]
#[ignore = "three minutes in release: every f32 up to the limit"]
fn f32_keeps_its_bound_everywhere() {
    f32_keeps_its_bound(1);
}

fn f32_keeps_its_bound(step: usize) {
    for bits in (0..=NEAR_F32.to_bits()).step_by(step) {
        let x = f32::from_bits(bits);
        // f64's error is 2⁻²⁹ of f32's last place.
        let truth = libm::sincos(x.into());
        let errors = [error_f32::<Plain>(x, truth), error_f32::<Fused>(x, truth)];
        assert!(errors[0].max(errors[1]) <= BOUND, "{errors:?} ulp at {x:e}");
    }
}

#[test]
fn parts_of_half_pi_leave_room_for_the_quadrant() {
    // 20 bits of q beside 33 bits, 15 beside 9: the low bits of the parts are zero.
    for part in &sin_cos_f64::PARTS[..3] {
        assert_eq!(part.to_bits() & ((1 << 20) - 1), 0, "{part:e}");
    }
    for part in &sin_cos_f32::PARTS[..4] {
        assert_eq!(part.to_bits() & ((1 << 15) - 1), 0, "{part:e}");
    }
    assert!((NEAR_F64 * core::f64::consts::FRAC_2_PI) < 2f64.powi(20) - 0.5);
    assert!((NEAR_F32 * core::f32::consts::FRAC_2_PI) < 2f32.powi(15) - 0.5);
}

#[test]
fn zeros_keep_their_sign_and_tiny_angles_their_value() {
    for x in [0.0_f64, -0.0, 5e-324, -1e-310, 1e-200] {
        let (sin, cos) = x.sin_cos_near();
        assert_eq!((sin.to_bits(), cos), (x.to_bits(), 1.0));
    }
    for x in [0.0_f32, -0.0, 1e-45, -1e-40, 1e-20] {
        let (sin, cos) = x.sin_cos_near();
        assert_eq!((sin.to_bits(), cos), (x.to_bits(), 1.0));
    }
}

#[test]
fn far_angles_are_reduced_correctly_and_no_number_has_no_sine() {
    assert!(NEAR_F64.is_near() && !NEAR_F64.next_up().is_near() && !f64::NAN.is_near());
    assert!(NEAR_F32.is_near() && !NEAR_F32.next_up().is_near() && !f32::INFINITY.is_near());
    for (x, sin, cos) in in_double_words(&FAR_ARGUMENTS) {
        for (s, c) in [sin_cos_f64::sin_cos_far::<Plain>(x), sin_cos_f64::sin_cos_far::<Fused>(x)] {
            let error = sin.distance_in_ulp(s, 53).max(cos.distance_in_ulp(c, 53));
            assert!(error <= BOUND, "{error} ulp at {x:e}");
        }
    }
    for (bits, sin, cos) in FAR_ARGUMENTS_F32 {
        let (x, truth) = (f32::from_bits(bits), [sin, cos].map(f64::from_bits));
        for (s, c) in [sin_cos_f32::sin_cos_far::<Plain>(x), sin_cos_f32::sin_cos_far::<Fused>(x)] {
            let [sin, cos] = truth.map(|high| DoubleWord { high, low: 0.0 });
            let error = sin.distance_in_ulp(s.into(), 24).max(cos.distance_in_ulp(c.into(), 24));
            assert!(error <= BOUND, "{error} ulp at {x:e}");
        }
    }
    // The sine of 10²² is the classic test of a reduction.
    assert_eq!(Scalar::sin_cos(1e22_f64).0, -0.8522008497671888);
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let ((s, c), (near_s, near_c)) = (Scalar::sin_cos(x), x.sin_cos_near());
        assert!(s.is_nan() && c.is_nan() && near_s.is_nan() && near_c.is_nan());
    }
}
