//! The arithmetic that others are compared with is right itself.

use linkage_core::Scalar;
use linkage_tests::double_double::DoubleDouble;

const SQRT: [f64; 2] = [0.8366600265340756, -4.12265279558505e-17];
const RECIPROCAL: [f64; 2] = [1.4285714285714286, 5.890979314337566e-17];
const SIN: [f64; 2] = [-0.7040813137533816, -1.9646969196301474e-17];
const COS: [f64; 2] = [0.7101193587160628, -2.4815747415365305e-17];
const ANGLE: [f64; 2] = [-2.9669204545815537, 1.8713204772237422e-16];

/// Against digits of mpmath's.
#[test]
fn two_words_hold_thirty_digits() {
    type Number = DoubleDouble<false>;
    let close = |found: Number, high: f64, low: f64| {
        let error = (found - Number::pair(high, low)).high.abs();
        assert!(error <= 1e-30 * high.abs(), "{found:?} for {high:e} + {low:e}");
    };
    let x = Number::new(0.7);
    close(x.sqrt(), SQRT[0], SQRT[1]);
    close(Number::new(1.0) / x, RECIPROCAL[0], RECIPROCAL[1]);
    let (sin, cos) = Number::new(12345.678).sin_cos();
    close(sin, SIN[0], SIN[1]);
    close(cos, COS[0], COS[1]);
    close(Number::new(-0.3).atan2(Number::new(-1.7)), ANGLE[0], ANGLE[1]);
}
