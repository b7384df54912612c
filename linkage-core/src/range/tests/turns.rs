//! Extremes of functions and of their mirror images.

use std::vec::Vec;

use crate::range::{Turn, extrema};
use crate::roots::number;
use crate::{Real, SolveError};

/// Value, rate and second rate.
type Function = fn(f64) -> [f64; 3];

/// The turns of ±f(±x), as they are on f itself, in rising order.
fn turns<T: Real>(
    f: Function,
    [from, to]: [f64; 2],
    [across, along]: [f64; 2],
) -> Vec<(f64, f64, bool)> {
    let ends = if along > 0.0 { [from, to] } else { [-to, -from] };
    let mirrored = |x: T| -> Result<[T; 3], SolveError> {
        let [value, rate, second] = f(along * x.value());
        Ok([value, along * rate, second].map(|y| number(across * y)))
    };
    let found = extrema(ends.map(number::<T>), mirrored).expect("numbers everywhere");
    let original = |turn: &super::super::Extremum<T>| {
        let is_maximum = (turn.turn == Turn::Maximum) == (across > 0.0);
        (along * turn.at.value(), across * turn.value.value(), is_maximum)
    };
    let mut list: Vec<_> = found.iter().map(original).collect();
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    list
}

/// The turns of all four mirror images are these.
#[track_caller]
fn assert_turns<T: Real>(f: Function, between: [f64; 2], expected: &[(f64, bool)], place: f64) {
    for mirror in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let found = turns::<T>(f, between, mirror);
        assert_eq!(found.len(), expected.len(), "{mirror:?} {found:?}");
        for ((at, value, is_maximum), &(x, expected)) in found.into_iter().zip(expected) {
            assert!((at - x).abs() <= place && is_maximum == expected, "{mirror:?} {at} for {x}");
            assert!((value - f(x)[0]).abs() <= 4.0 * T::EPSILON * f(x)[0].abs().max(1.0));
        }
    }
}

fn both(f: Function, between: [f64; 2], expected: &[(f64, bool)]) {
    // A rate is zero to 64 ε of its size, and a turn of these functions goes with a slope of one and more.
    assert_turns::<f64>(f, between, expected, 128.0 * f64::EPSILON);
    assert_turns::<f32>(f, between, expected, 128.0 * f64::from(f32::EPSILON));
}

const PI: f64 = core::f64::consts::PI;

#[test]
fn an_end_is_no_turn() {
    let cosine: Function = |x| [x.cos(), -x.sin(), -x.cos()];
    both(cosine, [0.0, PI], &[]);
    both(cosine, [-1.0, PI], &[(0.0, true)]);
    both(cosine, [0.0, 4.0], &[(PI, false)]);
    both(cosine, [-1.0, 7.0], &[(0.0, true), (PI, false), (2.0 * PI, true)]);
    let parabola: Function = |x| [x * x, 2.0 * x, 2.0];
    both(parabola, [0.0, 1.0], &[]);
    both(parabola, [-1.0, 0.0], &[]);
    both(parabola, [-1.0, 1.0], &[(0.0, false)]);
}

/// A rate that touches zero, on a sample, beside one and at an end.
#[test]
fn an_output_that_rests_and_goes_on_does_not_turn() {
    let cube: Function = |x| [x * x * x, 3.0 * x * x, 6.0 * x];
    both(cube, [-1.0, 1.0], &[]);
    both(cube, [-0.9, 1.0], &[]);
    both(cube, [0.0, 1.0], &[]);
    // A slide that rests once a turn.
    let resting: Function = |x| [x - x.sin(), 1.0 - x.cos(), x.sin()];
    both(resting, [-PI, PI], &[]);
    both(resting, [-1.0, 7.0], &[]);
    both(resting, [0.0, 4.0 * PI], &[]);
    // Between two turns, in the middle and beside it.
    let between: Function = |x| {
        let [a, b] = [x * x, x * x - 1.0];
        [x * a * (a / 5.0 - 1.0 / 3.0), a * b, 2.0 * x * b + 2.0 * x * a]
    };
    both(between, [-2.0, 2.0], &[(-1.0, true), (1.0, false)]);
    both(between, [-1.9, 2.0], &[(-1.0, true), (1.0, false)]);
    // No number changes at all.
    both(|_| [3.0, 0.0, 0.0], [-1.0, 1.0], &[]);
}

/// An output that rises, stays and falls turns once, somewhere in its rest.
#[test]
fn a_dwell_between_two_ways_is_one_turn() {
    let dwell: Function = |x| {
        let away = if x > 0.25 { x - 0.25 } else { (x + 0.25).min(0.0) };
        [-away.powi(4), -4.0 * away.powi(3), -12.0 * away * away]
    };
    for mirror in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let found = turns::<f64>(dwell, [-1.0, 1.1], mirror);
        let [(at, _, true)] = found[..] else { panic!("{mirror:?} {found:?}") };
        assert!(at.abs() <= 0.26, "{at}");
    }
}

/// The rate's dip below zero is told from rounding at 64 ε of its size: at half of that it is none, at
/// twice it is two turns.
#[test]
fn a_rate_is_zero_to_64_epsilon_of_its_size() {
    // The rate x² − d, which is one at both ends.
    fn count<T: Real>(times: f64) -> usize {
        let d = times * 64.0 * T::EPSILON;
        let f = |x: T| {
            let x = x.value();
            Ok([x * x * x / 3.0 - d * x, x * x - d, 2.0 * x].map(number))
        };
        extrema([-1.0, 1.0].map(number::<T>), f).expect("numbers everywhere").len()
    }
    assert_eq!([count::<f64>(0.8), count::<f64>(1.25)], [0, 2]);
    assert_eq!([count::<f32>(0.8), count::<f32>(1.25)], [0, 2]);
}

/// A sum of waves, each an amplitude, a frequency and a phase.
fn waves<T: Real>(constant: f64, waves: [[f64; 3]; 3], x: T) -> [T; 3] {
    let none = number::<T>(0.0);
    waves.iter().fold([number(constant), none, none], |[value, rate, second], wave| {
        let [size, frequency, phase] = wave.map(number::<T>);
        let (sin, cos) = (frequency * x + phase).sin_cos();
        let by = size * frequency;
        [value + size * sin, rate + by * cos, second - by * frequency * sin]
    })
}

/// A maximum and a minimum 0.05 apart, the rate between them 200 times what rounding makes in f32, and the
/// upper one of them next to a sample: the rate's hump was not seen from below.
#[test]
fn two_turns_close_together_are_found_in_both_mirror_images() {
    fn assert_found<T: Real>() {
        let [from, to] = [2.121_175_3, 8.655_712];
        let at = |x| {
            let sizes = [-0.609_082_34, 0.258_501_7, 0.325_262_4];
            let phases = [2.427_109, 0.182_679_13, 2.739_114_8];
            let [a, b, c] = [0, 1, 2].map(|i| [sizes[i], i as f64 + 1.0, phases[i]]);
            waves::<T>(-0.718_797_8, [a, b, c], x)
        };
        let found = extrema([from, to].map(number), |x| Ok(at(x))).expect("numbers");
        let mirrored = extrema([from, to].map(number), |x| Ok(at(x).map(|y| -y))).expect("numbers");
        let places: Vec<_> = found.iter().map(|turn| turn.at.value()).collect();
        assert_eq!(found.len(), 6, "{places:?}");
        // Bit for bit: the same numbers are compared.
        assert_eq!(places, mirrored.iter().map(|turn| turn.at.value()).collect::<Vec<_>>());
        assert!(found.iter().zip(mirrored.iter()).all(|(one, other)| one.turn != other.turn));
        assert_eq!(found[3].turn, Turn::Maximum);
        assert!((places[3] - 6.4095).abs() < 1e-3 && (places[4] - 6.4615).abs() < 1e-3);
    }
    assert_found::<f32>();
    assert_found::<f64>();
}

/// Two turns as near to each other as can be told, either of them on a sample, beside it by less than what
/// counts as zero, or by more, the sample at a panel's end, in its middle or in neither.
#[test]
fn nearly_flat_pairs_are_found_in_all_mirror_images() {
    fn assert_found<T: Real>(sample: f64, gap: f64, off: f64) {
        // The rate is (x − a)(x − b).
        let (a, b) = (sample + off, sample + off + gap);
        let mirrors = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
        let places = mirrors.map(|[across, along]| {
            let f = |x: T| {
                let x = along * x.value();
                let value = x * (x * (x / 3.0 - (a + b) / 2.0) + a * b);
                let (rate, second) = ((x - a) * (x - b), 2.0 * x - a - b);
                Ok([across * value, across * along * rate, across * second].map(number))
            };
            let found = extrema([-1.0, 1.0].map(number::<T>), f).expect("numbers everywhere");
            let mut places: Vec<_> = found.iter().map(|turn| along * turn.at.value()).collect();
            places.sort_by(f64::total_cmp);
            assert_eq!(places.len(), 2, "{sample} {gap:e} {off:e} {across} {along} {places:?}");
            // Rounding is in the last place of x alone.
            let room = 2.0 * <T as Real>::EPSILON;
            let is_right = (places[0] - a).abs() <= room && (places[1] - b).abs() <= room;
            assert!(is_right, "{places:?} for {a} {b} {across} {along}");
            places
        });
        // Bit for bit where the output is multiplied by -1.
        assert!(places[0] == places[1] && places[2] == places[3], "{places:?}");
    }
    fn assert_family<T: Real>() {
        let zero = 64.0 * <T as Real>::EPSILON;
        for sample in [-0.75, -0.5, -0.0625, 0.0, 0.1875, 0.25, 0.3, 0.75] {
            // A hump of gap²/4 counts from 64 ε of the rate's size, 3.6 at most, on.
            let least = 4.0 * zero.sqrt();
            let gaps = [0.125, 0.03125, 0.0078125, 1e-3, 1e-5, 8.0 * least, least];
            for gap in gaps.into_iter().filter(|&gap| gap >= least) {
                for off in [0.0, 0.25, -0.25, 0.5, -0.5, 2.0, -2.0] {
                    // The rate at the sample is as many times what counts as zero.
                    assert_found::<T>(sample, gap, off * zero / gap);
                    assert_found::<T>(sample - gap, gap, off * zero / gap);
                }
            }
        }
    }
    assert_family::<f64>();
    assert_family::<f32>();
}
