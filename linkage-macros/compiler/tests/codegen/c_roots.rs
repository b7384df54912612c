//! The search for roots in C beside that of the run-time crate: the same root, size and refusal.
//!
//! Equations are sums of Chebyshev's polynomials, with up to four dead points between the ends, or with many; their
//! squares, which touch zero; steps; sums that level off, or have a slope that is infinite; and sums with a hole in which
//! they are no number, about their root or elsewhere. Some ends are a root, a dead point, neighbours, a turn apart, in
//! the wrong order or no numbers.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::c_program::Program;
use super::c_run_time::{Call, EntryOutputs, Random, answers, compare};
use linkage_core::find::{FindError, Trend};
use linkage_core::private::{Checks, FirstError, Nonzero, root, root_within_a_turn};
use linkage_core::{Real, Scalar, SolveError};

/// The first of the functions in C that search: rising, falling, both from a seed, the same of an angle that is asked for
/// a turn, and all of them where something has failed before, and where an unknown was to blame before; then one whose
/// slope is known to have one sign; and that one with the number of its evaluations in place of the size.
const FIRST: i32 = 40;

fn number<T: Scalar>(x: f64) -> T {
    T::lit(x, x as f32)
}

fn size<T: Scalar>(x: T) -> T {
    T::select(x.ge(number(0.0)), x, -x)
}

/// Both sides and the slope, as the caller in C computes them.
fn sides<T: Real>([level, c1, c2, c3, c4, c5, kind]: [T; 7], x: T) -> [T; 3] {
    let [one, two, four, eight] = [1.0, 2.0, 4.0, 8.0].map(number::<T>);
    let square = x * x;
    let sum = c1 * x
        + c2 * (two * square - one)
        + c3 * (four * square - number(3.0)) * x
        + c4 * (eight * square * (square - one) + one)
        + c5 * ((number::<T>(16.0) * square - number(20.0)) * square + number(5.0)) * x;
    let slope = c1
        + c2 * four * x
        + c3 * (number::<T>(12.0) * square - number(3.0))
        + c4 * (number::<T>(32.0) * square - number(16.0)) * x
        + c5 * ((number::<T>(80.0) * square - number(60.0)) * square + number(5.0));
    match kind.value() as i32 {
        1 => [sum * sum, level, (sum + sum) * slope],
        2 => [if sum.gt(number(0.8)) { number(f64::NAN) } else { sum }, level, slope],
        3 => [if sum.gt(number(0.0)) { one } else { -one }, level, number(0.0)],
        4 => [sum, level, if sum.gt(level) { number(f64::INFINITY) } else { slope }],
        5 => {
            let bound = number::<T>(0.05) + size(sum);
            [sum / bound, level, number::<T>(0.05) * slope / (bound * bound)]
        }
        6 => {
            let is_hole = (number::<T>(0.01) * size(level)).gt(size(sum - level));
            [if is_hole { number(f64::NAN) } else { sum }, level, slope]
        }
        kind @ (7 | 8) => {
            let (mut wave, mut rate) = (x, one);
            for _ in 0..(if kind == 7 { 4 } else { 6 }) {
                (wave, rate) = (two * wave * wave - one, four * wave * rate);
            }
            [c1 * wave + c2 * x, level, c1 * rate + c2]
        }
        9 => {
            let is_hole = square.gt(number(1e-4)) && number::<T>(1.5e-2).gt(square);
            [if is_hole { number(f64::NAN) } else { sum }, level, slope]
        }
        _ => [sum, level, slope],
    }
}

fn expected<T: Real>(call: &Call) -> EntryOutputs {
    let [from, to, own @ ..] = call.x.map(number::<T>);
    let which = call.which - FIRST;
    let trend = if which & 1 == 0 { Trend::Rising } else { Trend::Falling };
    let near = (which & 2 != 0).then(|| from + (to - from) * number(0.25));
    let plain = || unreachable!("numbers without derivatives");
    let of_trial = |x| sides(own, x);
    let found = match which & 4 {
        0 => root([from, to], trend, near, plain, of_trial),
        _ => root_within_a_turn([from, to], trend, near, plain, of_trial),
    };
    let mut diagnosed = FirstError::new();
    match which & 24 {
        8 => {
            diagnosed.guard(number::<T>(0.0), Nonzero("earlier"));
        }
        16 => {
            let earlier: Result<[T; 2], FindError> = Err(FindError::NotFinite { at: 0.0 });
            diagnosed.root(earlier, "earlier", "m");
        }
        _ => {}
    }
    let (at, size) = diagnosed.root(found, "x", "m");
    let [at, size] = [at, size].map(T::value);
    // Who is to blame stands in the place of the size, which is zero then.
    let refused = |status, by, who| [status, by, at, who];
    match (diagnosed.first(), found) {
        (Ok(()), _) => [0.0, 0.0, at, size],
        (Err(SolveError::Singular { group: "earlier" }), Ok(_)) => [2.0, 0.0, at, size],
        (Err(SolveError::NotFinite { name: "earlier" }), Ok(_)) => [4.0, 0.0, at, size],
        (Err(SolveError::Singular { group: "earlier" }), _) => refused(2.0, 0.0, -20.0),
        (Err(SolveError::Singular { .. }), _) => refused(2.0, 0.0, -1.0),
        (Err(SolveError::Invalid { name, .. }), _) => {
            refused(3.0, 0.0, if name == "ends of between" { -4.0 } else { -5.0 })
        }
        (Err(SolveError::NotFinite { name }), _) => {
            refused(4.0, 0.0, if name == "earlier" { -30.0 } else { -3.0 })
        }
        (Err(SolveError::NoSolution { by, .. }), _) => refused(8.0, by, -2.0),
        (Err(SolveError::SeveralDeadPoints { .. }), _) => refused(9.0, 0.0, -2.0),
        (Err(error), _) => panic!("{error}"),
    }
}

/// The ends, the level, five coefficients and the kind.
fn equation(random: &mut Random, is_single: bool) -> [f64; 9] {
    let huge = if is_single { 1e38 } else { 8e307 };
    let scale = random.pick(&[1.0, 1.0, 1.0, 1.0, 1.0, 1e-20, 1e12, huge]);
    let epsilon = if is_single { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let mut x = [0.0; 9];
    let most = 1 + random.below(5) as usize;
    for to in &mut x[3..3 + most] {
        *to = scale * (random.unit() * 2.0 - 1.0);
    }
    x[0] = random.unit() * 1.7 - 1.2;
    x[1] = x[0] + random.pick(&[2.2, 1.0, 0.2]) * (0.05 + random.unit());
    x[2] = scale * (random.unit() * 2.0 - 1.0);
    x[8] = random.pick(&[0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    match random.below(24) {
        0 => x[0] = 0.0,
        1 => x[1] = random.pick(&[x[0], -2.0, f64::NAN, f64::INFINITY, 9.0, 1e300, f64::MAX]),
        2 => x[0] = random.pick(&[f64::NAN, f64::NEG_INFINITY, -1e300, -f64::MAX, -1e-310, -4.0]),
        3 => x[2] = 0.0,
        4 => x[1] = x[0] * (1.0 - random.below(8) as f64 * epsilon),
        5 => x[1] = x[0] + 2.0 * PI * (1.0 + (random.below(9) as f64 - 4.0) * epsilon),
        _ => {}
    }
    let mut x = x.map(|x| if is_single { f64::from(x as f32) } else { x });
    let own: [f64; 7] = std::array::from_fn(|i| x[i + 2]);
    match random.below(12) {
        // A parabola between ends one of which is its dead point.
        0 => [x[3], x[5], x[6], x[7]] = [0.0; 4],
        // An end that is the root, or last places from it.
        1 | 2 => {
            let end = x[random.below(2) as usize];
            let value = match is_single {
                false => sides(own, end)[0],
                true => f64::from(sides(own.map(|x| x as f32), end as f32)[0]),
            };
            x[2] = value * (1.0 + (random.below(13) as f64 - 6.0) * epsilon);
        }
        _ => {}
    }
    x.map(|x| if is_single { f64::from(x as f32) } else { x })
}

/// A cubic whose slope has one sign everywhere, or is zero at an end alone; its level is within reach, beyond it, or some
/// last places off an end.
fn steady_equation(random: &mut Random, is_single: bool) -> [f64; 9] {
    let epsilon = if is_single { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let rounded = |x: f64| if is_single { f64::from(x as f32) } else { x };
    let from = random.unit() * 1.7 - 1.2;
    let mut x = [0.0; 9];
    [x[0], x[1]] = [from, from + 0.05 + 2.0 * random.unit()];
    // The slope is c1 + c3 (12 x² - 3).
    x[3] = random.pick(&[1.0, -1.0]) * (0.1 + random.unit());
    let bend = 0.3 * random.unit();
    x[5] = x[3] * random.pick(&[0.0, bend, 1.0 / 3.0]);
    if random.below(4) == 0 {
        x[random.below(2) as usize] = 0.0;
    }
    x = x.map(rounded);
    if x[0] >= x[1] {
        x[1] = x[0] + 1.0;
    }
    let own: [f64; 7] = std::array::from_fn(|i| x[i + 2]);
    let ends = [x[0], x[1]].map(|end| sides(own, end)[0]);
    x[2] = match random.below(3) {
        0 => ends[0] + random.unit() * (ends[1] - ends[0]),
        1 => ends[random.below(2) as usize] * (1.0 + (random.below(33) as f64 - 16.0) * epsilon),
        _ => ends[0] + (4.0 * random.unit() - 1.5) * (ends[1] - ends[0]),
    };
    x.map(rounded)
}

/// Calls of one of the functions with such equations.
fn steady_calls(random: &mut Random, (is_single, which): (bool, i32), count: usize) -> Vec<Call> {
    let call = |_| Call { which: FIRST + which, is_single, x: steady_equation(random, is_single) };
    (0..count).map(call).collect()
}

/// The search by C where the slope is known to have one sign, beside a survey of the crate.
fn steady_roots_agree(programs: &[Program], count: usize) {
    let mut random = Random(37);
    for (is_single, which) in [(false, 32), (false, 33), (true, 32), (true, 33)] {
        let calls = steady_calls(&mut random, (is_single, which), count);
        let expected = compare(programs, &calls, |call| match is_single {
            false => expected::<f64>(call),
            true => expected::<f32>(call),
        });
        let refused = expected.iter().filter(|answer| answer[0] == 8.0).count();
        assert!(refused > count / 4 && refused < count, "{refused}");
    }
}

/// The equation's value and slope at both ends, its trend being the way.
fn ends<T: Real>(call: &Call, way: f64) -> [[f64; 2]; 2] {
    let [from, to, own @ ..] = call.x.map(number::<T>);
    [from, to].map(|x| {
        let [left, right, slope] = sides(own, x);
        [way * (left - right).value(), way * slope.value()]
    })
}

/// Where both ends say that such an equation rises on one side of zero, nothing but the ends is asked. Anywhere else a
/// refusal is decided by more than them.
fn steady_refusals_ask_the_ends_alone(programs: &[Program], count: usize) {
    let mut random = Random(41);
    for (is_single, which) in [(false, 96), (false, 97), (true, 96), (true, 97)] {
        let calls = steady_calls(&mut random, (is_single, which), count);
        let way = if which & 1 == 0 { 1.0 } else { -1.0 };
        for program in programs {
            let (mut by_ends, mut by_more) = (0, 0);
            for (call, answer) in calls.iter().zip(answers(program, &calls)) {
                if answer[0] != 8.0 {
                    continue;
                }
                let [[a, slope_a], [b, slope_b]] = match is_single {
                    false => ends::<f64>(call, way),
                    true => ends::<f32>(call, way),
                };
                let rises = b > a && ((a > 0.0 && slope_a >= 0.0) || (b < 0.0 && slope_b >= 0.0));
                assert_eq!(answer[3] == 2.0, rises, "{call:?}: {answer:?}");
                *if rises { &mut by_ends } else { &mut by_more } += 1;
            }
            assert!(by_ends > count / 20 && by_more > count / 20, "{by_ends}, {by_more}");
        }
    }
}

/// A sum that falls through zero at a sample of value zero, with holes between that and the samples beside it: the
/// sample says all, and nothing is asked beside it.
const FALLS_AT_A_SAMPLE: [f64; 9] = [-0.375, 0.625, 0.25, -0.75, -0.25, 1.4375, 0.0, 1.0, 9.0];

fn planted_agree(programs: &[Program]) {
    for is_single in [false, true] {
        let call = Call { which: FIRST, is_single, x: FALLS_AT_A_SAMPLE };
        let answers = compare(programs, &[call], |call| match is_single {
            false => expected::<f64>(call),
            true => expected::<f32>(call),
        });
        assert_eq!(answers[0][..2], [8.0, 0.585_937_5]);
    }
}

/// Also that every kind of answer is often met.
pub(super) fn roots_agree(programs: &[Program], count: usize) {
    planted_agree(programs);
    steady_roots_agree(programs, count);
    steady_refusals_ask_the_ends_alone(programs, count);
    let mut random = Random(23);
    for is_single in [false, true] {
        let mut statuses = BTreeMap::new();
        for which in FIRST..FIRST + 24 {
            let call = |_| Call { which, is_single, x: equation(&mut random, is_single) };
            let calls: Vec<Call> = (0..count).map(call).collect();
            let expected = compare(programs, &calls, |call| match is_single {
                false => expected::<f64>(call),
                true => expected::<f32>(call),
            });
            for answer in expected {
                *statuses.entry(answer[0] as i32).or_insert(0) += 1;
            }
        }
        for status in [0, 2, 3, 4, 8, 9] {
            assert!(statuses.get(&status).is_some_and(|&met| met > count / 50), "{statuses:?}");
        }
    }
}
