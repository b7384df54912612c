//! Tests of numbers of any width, run in both.

use linkage_core::Scalar;

/// The number of a width that is nearest.
pub fn number<T: Scalar>(value: f64) -> T {
    T::num(value)
}

/// Several of them.
pub fn list<T: Scalar, const N: usize>(values: [f64; N]) -> [T; N] {
    values.map(number)
}

/// Makes tests of functions that are generic over the number, one for `f64` and one for `f32`. A number
/// that is another one in each width stands behind the function.
#[macro_export]
macro_rules! in_both_widths {
    ($($test:ident $(($wide:literal, $narrow:literal))?)+) => {
        mod double {
            $(#[test] fn $test() { super::$test::<f64>($($wide)?); })+
        }
        mod single {
            $(#[test] fn $test() { super::$test::<f32>($($narrow)?); })+
        }
    };
}
