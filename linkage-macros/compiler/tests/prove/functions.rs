//! Functions of intervals, and their slopes, at numbers that are known.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::function::Function;
use crate::prove::function_ranges::of;
use crate::prove::outward::OutwardInterval;

/// More than the four last places of the library, of results up to 10.
const NEAR: f64 = 1e-14;

fn range(function: Function, arguments: &[[f64; 2]]) -> Option<[[f64; 2]; 3]> {
    let arguments: Vec<_> =
        arguments.iter().map(|&[low, high]| OutwardInterval::between(low, high)).collect();
    let (range, [first, second]) = of(function, &arguments)?;
    Some([range, first, second].map(|one| [one.low, one.high]))
}

/// An interval holds what is expected, and little more.
fn assert_just(found: [f64; 2], [low, high]: [f64; 2], of: &str) {
    assert!(found[0] <= low && found[0] > low - NEAR, "{of}: {found:?} for {low} to {high}");
    assert!(found[1] >= high && found[1] < high + NEAR, "{of}: {found:?} for {low} to {high}");
}

#[test]
fn functions_of_one_number_are_between_their_ends_and_extrema() {
    for (function, argument, expected, slope) in [
        (Function::Sqrt, [4.0, 9.0], [2.0, 3.0], [1.0 / 6.0, 0.25]),
        (Function::Sin, [0.1, 0.2], [0.1_f64.sin(), 0.2_f64.sin()], [0.2_f64.cos(), 0.1_f64.cos()]),
        (Function::Sin, [1.0, 2.0], [1.0_f64.sin(), 1.0], [2.0_f64.cos(), 1.0_f64.cos()]),
        (Function::Sin, [4.0, 5.0], [-1.0, 4.0_f64.sin()], [4.0_f64.cos(), 5.0_f64.cos()]),
        (Function::Cos, [3.0, 4.0], [-1.0, 4.0_f64.cos()], [-(3.0_f64.sin()), -(4.0_f64.sin())]),
        (Function::Cos, [-3.5, 3.5], [-1.0, 1.0], [-1.0, 1.0]),
        (
            Function::Asin,
            [-0.5, 0.25],
            [-0.5_f64.asin(), 0.25_f64.asin()],
            [1.0, 1.0 / 0.75_f64.sqrt()],
        ),
        (
            Function::Acos,
            [-0.5, 0.25],
            [0.25_f64.acos(), (-0.5_f64).acos()],
            [-1.0 / 0.75_f64.sqrt(), -1.0],
        ),
        (Function::Atan, [-1.0, 2.0], [-PI / 4.0, 2.0_f64.atan()], [0.2, 1.0]),
        (Function::Abs, [-1.0, 2.0], [0.0, 2.0], [-1.0, 1.0]),
        (Function::Abs, [-2.0, -1.0], [1.0, 2.0], [-1.0, -1.0]),
        (Function::Abs, [1.0, 2.0], [1.0, 2.0], [1.0, 1.0]),
        (Function::Sign, [-2.0, -1.0], [-1.0, -1.0], [0.0, 0.0]),
    ] {
        let [found, by, _] = range(function, &[argument]).expect("it is followed");
        let of = format!("{function:?} of {argument:?}");
        assert_just(found, expected, &of);
        assert_just(by, slope, &format!("slope of {of}"));
    }
}

#[test]
fn functions_of_two_numbers_are_between_those_of_corners() {
    for (function, arguments, expected, slopes) in [
        (Function::Min, [[1.0, 3.0], [2.0, 5.0]], [1.0, 3.0], [[0.0, 1.0]; 2]),
        (Function::Min, [[1.0, 2.0], [3.0, 4.0]], [1.0, 2.0], [[1.0; 2], [0.0; 2]]),
        (Function::Max, [[1.0, 3.0], [2.0, 5.0]], [2.0, 5.0], [[0.0, 1.0]; 2]),
        (Function::Max, [[1.0, 2.0], [3.0, 4.0]], [3.0, 4.0], [[0.0; 2], [1.0; 2]]),
        // Each part over the shortest length, and over the longest.
        (Function::Hypot, [[3.0, 6.0], [4.0, 8.0]], [5.0, 10.0], [[0.3, 1.0], [0.4, 1.0]]),
        (
            Function::Atan2,
            [[1.0, 2.0], [3.0, 4.0]],
            [0.25_f64.atan(), (2.0_f64 / 3.0).atan()],
            [[3.0 / 20.0, 0.4], [-0.2, -1.0 / 20.0]],
        ),
    ] {
        let [found, first, second] = range(function, &arguments).expect("it is followed");
        let of = format!("{function:?} of {arguments:?}");
        assert_just(found, expected, &of);
        for (by, slope) in [first, second].into_iter().zip(slopes) {
            assert_just(by, slope, &format!("slope of {of}"));
        }
    }
    // Next to the origin, but not round it.
    let [beside, ..] = range(Function::Atan2, &[[-1.0, 1.0], [0.05, 1.0]]).expect("it is followed");
    assert_just(beside, [-(20.0_f64.atan()), 20.0_f64.atan()], "beside the origin");
    let [above, ..] = range(Function::Atan2, &[[0.05, 1.0], [-1.0, 1.0]]).expect("it is followed");
    assert_just(
        above,
        [FRAC_PI_2 - 20.0_f64.atan(), FRAC_PI_2 + 20.0_f64.atan()],
        "above the origin",
    );
}

#[test]
fn what_jumps_or_is_undefined_has_no_range() {
    for (function, arguments) in [
        (Function::Asin, &[[-1.5, 0.5]][..]),
        (Function::Asin, &[[0.5, 1.5]]),
        (Function::Acos, &[[-1.5, 0.5]]),
        (Function::Acos, &[[0.5, 1.5]]),
        (Function::Sign, &[[-1.0, 1.0]]),
        (Function::Atan2, &[[-1.0, 1.0], [-1.0, 1.0]]),
        (Function::Atan2, &[[-1.0, 1.0], [-2.0, -1.0]]),
        (Function::Atan2, &[[0.0, 1.0], [0.0, 1.0]]),
    ] {
        assert_eq!(range(function, arguments), None, "{function:?} of {arguments:?}");
    }
}
