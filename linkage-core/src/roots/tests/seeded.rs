//! Evaluations from pose to pose, of the ram of a press.

use core::cell::Cell;

use super::*;
use crate::roots::seed::{Apart, Seed, root_by_seed};
use crate::roots::unknown::root;

const STROKE: [f64; 2] = [0.0, core::f64::consts::PI];

/// The ram of a crank of 80 and a rod of 250, and its slope.
fn ram(theta: f64) -> [f64; 2] {
    let (sin, cos) = (0.08 * theta.sin(), 0.08 * theta.cos());
    let rod = ((0.25 - sin) * (0.25 + sin)).sqrt();
    [cos + rod, -sin - sin * cos / rod]
}

/// A root found by a seed and from both ends, and the evaluations that each took. The target stands on the
/// right, or on the left.
fn both(
    seed: &mut Seed<f64>,
    given: f64,
    [is_right, has_one_root]: [bool; 2],
) -> ([Result<[f64; 2], FindError>; 2], [u32; 2]) {
    let (calls, apart) = (Cell::new(0), Apart { given, is_right, has_one_root });
    let sides = |theta| {
        calls.set(calls.get() + 1);
        let [slide, slope] = ram(theta);
        if is_right { [slide, given, slope] } else { [given, slide, -slope] }
    };
    let trend = if is_right { Trend::Falling } else { Trend::Rising };
    let plain = || panic!("the numbers are plain");
    let seeded = root_by_seed(STROKE, trend, Some(seed), apart, plain, sides);
    let by_seed = calls.replace(0);
    let cold = root(STROKE, trend, None, plain, sides);
    ([seeded, cold], [by_seed, calls.get()])
}

/// The evaluations a pose of a sweep over targets, from both ends and by seeds.
fn evaluations(targets: impl Iterator<Item = f64>, ways: [bool; 2]) -> [f64; 2] {
    let (mut seed, mut sum, mut count) = (Seed::unknown(), [0, 0], 0);
    for target in targets {
        let ([seeded, cold], calls) = both(&mut seed, target, ways);
        match (seeded, cold) {
            (Ok([at, _]), Ok([other, size])) => {
                // ε/2 of the larger end each, and 4 ε of the sides over the slope.
                let slope = ram(other)[1].abs();
                let rounding = 8.0 * f64::EPSILON * size / slope;
                let allowed = if ways[1] { f64::EPSILON * STROKE[1] + rounding } else { 0.0 };
                assert!((at - other).abs() <= allowed, "{target}: {at} {other}");
            }
            (seeded, cold) => assert_eq!(std::format!("{seeded:?}"), std::format!("{cold:?}")),
        }
        sum = [sum[0] + calls[0], sum[1] + calls[1]];
        count += 1;
    }
    std::println!("{sum:?} of {count}");
    sum.map(|sum| f64::from(sum) / f64::from(count))
}

/// A sample of the targets of `.ci/nightly`.
#[test]
fn neighbours_take_half_of_the_evaluations() {
    let poses = cases(6000, 20_000) as i32;
    let along = |poses: i32| (1..poses).map(move |i| 0.17 + 0.16 * f64::from(i) / f64::from(poses));
    for is_right in [true, false] {
        let [seeded, cold] = evaluations(along(poses), [is_right, true]);
        assert!(seeded <= 2.5 && cold >= 5.0, "{seeded} {cold}");
        // Steps from a tenth of a degree on, that next to the dead points are too long for a seed.
        let [seeded, _] = evaluations(along(1000), [is_right, true]);
        assert!(seeded <= 3.5, "{seeded}");
        // Without a proof the ends alone are remembered: two evaluations less, and the same bits.
        let [seeded, cold] = evaluations(along(poses), [is_right, false]);
        assert!((cold - seeded - 2.0).abs() < 1e-3, "{seeded} {cold}");
    }
}

/// Targets in no order, beyond both ends and no numbers: a seed costs one evaluation and saves two.
#[test]
fn jumps_take_no_more_than_both_ends() {
    let mut random = Random(5);
    let targets = (0..20_000).map(|nth| match nth % 50 {
        7 => f64::NAN,
        9 => 1e300,
        _ => random.between(0.165, 0.335),
    });
    let [seeded, cold] = evaluations(targets, [true, true]);
    assert!(seeded < cold - 0.9, "{seeded} {cold}");
}

/// Next to a dead point both ends are asked: the root is lost in the rounding, and so is a root's absence.
#[test]
fn dead_points_are_searched_from_both_ends() {
    let mut seed = Seed::unknown();
    for k in 1..60 {
        for sign in [1.0, -1.0] {
            let target = 0.33 - sign * 0.1 * (-f64::from(k)).exp2();
            let ([seeded, cold], _) = both(&mut seed, target, [true, true]);
            assert_eq!(seeded.is_ok(), cold.is_ok(), "{target}");
            if (0.33 - target).abs() < 1e-16 {
                assert_eq!(seeded, cold, "{target}");
            }
        }
    }
}

/// A seed is no excuse for a root of another stretch: without signs at both ends there is none taken.
#[test]
fn a_root_is_taken_between_signs_alone() {
    let apart = Apart { given: 0.0, is_right: true, has_one_root: true };
    let line = |x: f64| [x, 0.0, 1.0];
    let plain = || panic!("the numbers are plain");
    let mut seed = Seed::unknown();
    let mut of = |ends, given| {
        let sides = |x| [line(x)[0], given, 1.0];
        root_by_seed(ends, Trend::Rising, Some(&mut seed), Apart { given, ..apart }, plain, sides)
    };
    let found = of([-1.0, 1.0], 0.5);
    assert_eq!(found.map(|[at, _]| at), Ok(0.5));
    // Beyond the end by less than the rounding: that end, as from both ends.
    let found = of([-1.0, 1.0], 1.0 + 2.0 * f64::EPSILON);
    assert_eq!(found.map(|[at, _]| at), Ok(1.0));
    assert!(matches!(of([-1.0, 1.0], 1.0001), Err(FindError::NoSolution { .. })));
}

/// Roots of a side by a seed and from both ends, at one target after the other.
fn roots_of(
    side: impl Fn(f64) -> [f64; 2],
    targets: impl Iterator<Item = f64>,
    mut each: impl FnMut([Result<[f64; 2], FindError>; 2]),
) {
    let mut seed = Seed::unknown();
    for given in targets {
        let apart = Apart { given, is_right: true, has_one_root: true };
        let sides = |x| {
            let [value, slope] = side(x);
            [value, given, slope]
        };
        let plain = || panic!("the numbers are plain");
        let ends = [-1.0, 1.0];
        let by_seed = root_by_seed(ends, Trend::Rising, Some(&mut seed), apart, plain, sides);
        each([by_seed, root(ends, Trend::Rising, None, plain, sides)]);
    }
}

/// An end whose value is off by more than its last places refuses a root that lies next to it.
#[test]
fn an_end_of_the_wrong_sign_is_heard() {
    let rounded = |x: f64| [if x < 1.0 { x } else { 1.0 - 1e-12 }, 1.0];
    let mut refused = 0;
    roots_of(rounded, [0.999, 1.0 - 1e-14].into_iter(), |[by_seed, cold]| {
        assert_eq!(by_seed.is_ok(), cold.is_ok());
        refused += u32::from(cold.is_err());
    });
    assert_eq!(refused, 1);
}

/// A slope that is lost in the rounding of the sides: every root is that of both ends, to the last bit.
#[test]
fn a_slope_next_to_rounding_is_searched_from_both_ends() {
    let flat = |x: f64| [1.0 + 1e-9 * x, 1e-9];
    let targets = (0..200).map(|nth| 1.0 + 1e-9 * (0.001 * f64::from(nth) - 0.1));
    roots_of(flat, targets, |[by_seed, cold]| assert_eq!(by_seed, cold));
}
