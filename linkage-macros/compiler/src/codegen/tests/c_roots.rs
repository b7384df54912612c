//! The search for roots in C beside that of the run-time crate: the same root, size and refusal.
//!
//! Equations are sums of Chebyshev's polynomials, with up to four dead points between the ends; their squares, which
//! touch zero; steps; and sums with a hole in which they are no number. Some ends are a root, a dead point, in the
//! wrong order or no numbers.

use std::collections::BTreeMap;

use linkage_core::find::{FindError, Trend};
use linkage_core::private::{root, root_within_a_turn};
use linkage_core::{Real, Scalar};

use super::c_program::Program;
use super::c_run_time::{Call, EntryOutputs, Random, compare};

/// The first of the functions in C that search: rising, falling, both from a seed, and the same of an angle that is
/// asked for a turn.
const FIRST: i32 = 40;

fn number<T: Scalar>(x: f64) -> T {
    T::lit(x, x as f32)
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
    match found {
        Ok([at, size]) => [0.0, 0.0, at.value(), size.value()],
        Err(FindError::Interval { .. }) => [3.0, 0.0, 0.0, 0.0],
        Err(FindError::NoSolution { by, .. }) => [8.0, by, 0.0, 0.0],
        Err(FindError::SeveralDeadPoints) => [9.0, 0.0, 0.0, 0.0],
        Err(FindError::NotFinite { at }) => [4.0, 0.0, at, 0.0],
        Err(error) => panic!("{error}"),
    }
}

/// The ends, the level, five coefficients and the kind.
fn equation(random: &mut Random, is_single: bool) -> [f64; 9] {
    let scale = random.pick(&[1.0, 1.0, 1.0, 1e-20, 1e12]);
    let mut x = [0.0; 9];
    let most = 1 + random.below(5) as usize;
    for to in &mut x[3..3 + most] {
        *to = scale * (random.unit() * 2.0 - 1.0);
    }
    x[0] = random.unit() * 1.7 - 1.2;
    x[1] = x[0] + random.pick(&[2.2, 1.0, 0.2]) * (0.05 + random.unit());
    x[2] = scale * (random.unit() * 2.0 - 1.0);
    x[8] = random.pick(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
    match random.below(24) {
        0 => x[0] = 0.0,
        1 => x[1] = random.pick(&[x[0], -2.0, f64::NAN, f64::INFINITY, 9.0, 1e300, f64::MAX]),
        2 => x[0] = random.pick(&[f64::NAN, f64::NEG_INFINITY, -1e300, -f64::MAX, -1e-310, -4.0]),
        3 => x[2] = 0.0,
        _ => {}
    }
    let mut x = x.map(|x| if is_single { f64::from(x as f32) } else { x });
    let own: [f64; 7] = std::array::from_fn(|i| x[i + 2]);
    match random.below(12) {
        // A parabola between ends one of which is its dead point.
        0 => [x[3], x[5], x[6], x[7]] = [0.0; 4],
        // An end that is the root, or last places from it.
        1 | 2 => {
            let value = match is_single {
                false => sides(own, x[1])[0],
                true => f64::from(sides(own.map(|x| x as f32), x[1] as f32)[0]),
            };
            let epsilon = if is_single { f64::from(f32::EPSILON) } else { f64::EPSILON };
            x[2] = value * (1.0 + (random.below(13) as f64 - 6.0) * epsilon);
        }
        _ => {}
    }
    x.map(|x| if is_single { f64::from(x as f32) } else { x })
}

/// Also that every kind of answer is often met.
pub(super) fn roots_agree(program: &Program) {
    let mut random = Random(23);
    for is_single in [false, true] {
        let mut statuses = BTreeMap::new();
        for which in FIRST..FIRST + 8 {
            let call = |_| Call { which, is_single, x: equation(&mut random, is_single) };
            let calls: Vec<Call> = (0..10_000).map(call).collect();
            let expected = |call: &Call| match is_single {
                false => expected::<f64>(call),
                true => expected::<f32>(call),
            };
            for call in &calls {
                *statuses.entry(expected(call)[0] as i32).or_insert(0) += 1;
            }
            compare(program, &calls, expected);
        }
        for status in [0, 3, 4, 8, 9] {
            assert!(statuses.get(&status).is_some_and(|&count| count > 100), "{statuses:?}");
        }
    }
}
