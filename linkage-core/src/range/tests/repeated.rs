//! Intervals of many turns: what repeats in each of them is found in each.

use core::cell::Cell;
use core::f64::consts::{PI, TAU};
use std::prelude::v1::*;
use std::vec::Vec;

use crate::cases::cases;
use crate::range::panels::Panels;
use crate::range::{RangeError, Stop, extrema, limits};
use crate::roots::number;
use crate::solver::{Solver, Titles};
use crate::{Real, Scalar, SolveError};

/// A four-bar: crank, base, rocker and coupler.
#[derive(Clone, Copy)]
struct FourBar<'a, T> {
    lengths: [T; 4],
    /// A dimension is none where the crank's cosine is above this.
    highest_cosine: f64,
    /// The number of evaluations of its clearance.
    calls: &'a Cell<u32>,
}

impl<'a, T: Real> FourBar<'a, T> {
    fn new(lengths: [f64; 4], calls: &'a Cell<u32>) -> Self {
        Self { lengths: lengths.map(number), highest_cosine: 2.0, calls }
    }
}

/// (c + r)² − d² times d² − (c − r)² for coupler and rocker and the distance d between their pins, and what
/// its rounding is a few ε of.
fn clearance<U: Scalar>([crank, base, rocker, coupler]: [U; 4], angle: U) -> [U; 2] {
    let two = number::<U>(2.0);
    let square = crank * crank + base * base - two * crank * base * angle.sin_cos().1;
    let [sum, difference] = [coupler + rocker, coupler - rocker];
    let size = sum * sum + square;
    [(sum * sum - square) * (square - difference * difference), size * size]
}

impl<T: Real> Solver for FourBar<'static, T> {
    output_is_input!(T);
    type Groups<X: Copy> = [X; 1];

    const TITLES: Titles =
        Titles { name: "FourBar", inputs: &["q"], outputs: &["q"], groups: &[("dyad", None)] };

    fn position(&self, q: T) -> Result<T, SolveError> {
        let [value, size] = clearance(self.lengths, q).map(Real::value);
        let is_a_dimension = q.value().cos() <= self.highest_cosine;
        let is_met = value >= -16.0 * <T as Real>::EPSILON * size;
        let group = if is_met { "dimension" } else { "dyad" };
        let is_answered = is_a_dimension && is_met;
        if is_answered { Ok(q) } else { Err(SolveError::OutOfReach { group, by: 1.0 }) }
    }

    fn told<U: Real, X: Copy>(
        &self,
        standing: impl Fn(T) -> U,
        input: impl Fn(usize) -> U,
        of: impl Fn([U; 2]) -> X,
    ) -> [X; 1] {
        self.calls.set(self.calls.get() + 1);
        [of(clearance(self.lengths.map(standing), input(0)))]
    }
}

fn counter() -> &'static Cell<u32> {
    Box::leak(Box::new(Cell::new(0)))
}

/// Where the four-bar reaches between two angles by the law of cosines, ends with the error of their
/// cosine; `None` where one is nearer to a change point, or a stretch or a gap shorter, than `apart`.
fn closed_form(
    [crank, base, rocker, coupler]: [f64; 4],
    [from, to]: [f64; 2],
    apart: f64,
) -> Option<Vec<[f64; 2]>> {
    let cosine = |d: f64| (crank * crank + base * base - d * d) / (2.0 * crank * base);
    let [least, most] = [cosine(coupler + rocker), cosine(coupler - rocker)];
    if [least.abs() - 1.0, most.abs() - 1.0].iter().any(|away| away.abs() < apart) {
        return None;
    }
    if least > 1.0 || most < -1.0 {
        return Some(Vec::new());
    }
    let [inner, outer] = [most.min(1.0).acos(), least.max(-1.0).acos()];
    let mut found: Vec<[f64; 2]> = Vec::new();
    for turn in (from / TAU).floor() as i32 - 1..=(to / TAU).ceil() as i32 + 1 {
        let zero = TAU * f64::from(turn);
        for [low, high] in [[zero - outer, zero - inner], [zero + inner, zero + outer]] {
            let [low, high] = [low.max(from), high.min(to)];
            match found.last_mut() {
                _ if high <= low => {}
                // Not a limit: the crank passes it.
                Some(last) if low - last[1] < 1e-12 => last[1] = high,
                _ => found.push([low, high]),
            }
        }
    }
    let all: Vec<f64> =
        [from].into_iter().chain(found.iter().flatten().copied()).chain([to]).collect();
    let is_clear = all.windows(2).all(|pair| pair[1] == pair[0] || pair[1] - pair[0] > apart);
    is_clear.then_some(found)
}

/// The stretches are those of the law of cosines.
#[track_caller]
fn assert_found<T: Real>(lengths: [f64; 4], between: [f64; 2]) -> usize {
    // Computed from the lengths and ends as rounded to this width.
    let lengths = lengths.map(|length| number::<T>(length).value());
    let between = between.map(|end| number::<T>(end).value());
    // Next to a change point the angle is right to √ε of the size, a few times over.
    let apart = 16.0 * <T as Real>::EPSILON.sqrt();
    let Some(expected) = closed_form(lengths, between, apart) else { return 0 };
    let found = limits(&FourBar::<T>::new(lengths, counter()), between.map(number));
    let found = found.expect("as many as there may be");
    assert_eq!(found.len(), expected.len(), "{lengths:?} {between:?} {:?}", &*found);
    for (stretch, [from, to]) in found.iter().zip(&expected) {
        for (end, &angle) in [(stretch.from, from), (stretch.to, to)] {
            let off = (end.at.value() - angle).abs();
            // The angle's own rounding, and 64 ε of the clearance's size at a sample or two halves of an ε in
            // each of a dozen operations, over a slope of at least √apart of it.
            let [size, slope] = [256.0 * <T as Real>::EPSILON, apart.sqrt()];
            let room = 4.0 * <T as Real>::EPSILON * angle.abs().max(1.0) + size / slope;
            assert!(off <= room, "{off:e} {lengths:?} {between:?}");
        }
    }
    expected.len()
}

/// Numbers between 0 and 1 that are spread evenly.
fn spread(index: u32, prime: f64) -> f64 {
    (f64::from(index) * prime.sqrt()).fract()
}

/// A sample of the machines of `.ci/nightly`.
#[test]
fn a_limit_of_every_turn_is_found_wherever_the_interval_begins() {
    // The panels of an interval of ten turns were two thirds of a turn long, and the first of them looked
    // like a cubic without a zero.
    let lengths = [1.910_054_9, 1.892_396_3, 1.256_552_1, 0.348_047_55];
    for between in [[-64.676_94, 0.0], [-64.676_94, -4e-45], [-61.0, 3.0], [0.0, 64.676_94]] {
        assert!(assert_found::<f64>(lengths, between) > 19, "{between:?}");
        assert!(assert_found::<f32>(lengths, between) > 19, "{between:?}");
    }
    let mut count = [0, 0];
    let machines = cases(150, 600);
    for machine in 1..=machines as u32 {
        let lengths = [2.0, 3.0, 5.0, 7.0].map(|prime| 0.2 + 1.8 * spread(machine, prime));
        let from = -40.0 + 80.0 * spread(machine, 11.0);
        let between = [from, from + 15.0 * TAU * spread(machine, 13.0)];
        count[0] += assert_found::<f64>(lengths, between);
        count[1] += assert_found::<f32>(lengths, between);
    }
    // A comparison of nothing with nothing would not tell.
    assert!(count.iter().all(|&count| count > machines * 20 / 3), "{count:?}");
}

/// Every panel begins and ends, or begins, ends and has its middle, at the same angle of the crank. An ordinary run
/// takes every other of the counts of turns that are too many, and `.ci/nightly` all.
#[test]
fn whole_turns_hide_no_limit() {
    fn stretches<T: Real>(turns: f64, from: f64) -> Result<usize, RangeError> {
        let four_bar = FourBar::<T>::new([2.0, 4.0, 2.5, 3.0], counter());
        limits(&four_bar, [from, from + turns * TAU].map(number)).map(|found| found.len())
    }
    for from in [0.0, PI, 1.0] {
        for turns in [8.0, 16.0, 31.0] {
            let expected = turns as usize + usize::from(from == 0.0 || from == 1.0);
            assert_eq!(stretches::<f64>(turns, from), Ok(expected), "{turns} {from}");
            assert_eq!(stretches::<f32>(turns, from), Ok(expected), "{turns} {from}");
        }
        for turns in [33.0, 34.0, 48.0, 64.0, 512.0, 1024.0, 1e5].into_iter().step_by(cases(2, 1)) {
            assert_eq!(stretches::<f64>(turns, from), Err(RangeError::TooMany), "{turns} {from}");
            assert_eq!(stretches::<f32>(turns, from), Err(RangeError::TooMany), "{turns} {from}");
        }
    }
}

/// Two samples a panel, its end and its middle, and four for size and ends.
#[test]
fn evaluations_grow_with_the_turns_up_to_a_bound() {
    // Clear of its limits by much.
    let lengths = [0.5, 4.0, 3.0, 3.5];
    for (width, most) in [(1.0, 36), (TAU, 36), (2.0 * TAU, 68), (33.0 * TAU, 1042)] {
        let calls = counter();
        let four_bar = FourBar::<f64>::new(lengths, calls);
        assert!(limits(&four_bar, [0.3, 0.3 + width]).expect("an interval").is_whole());
        assert!(calls.get() <= most, "{width} {}", calls.get());
    }
    // Behind that each of 16 panels is of up to 128 pieces, each found in up to 7 halvings beside two
    // samples, with a search of up to 59 for the lowest point of each of its halves.
    for width in [1e3, 1e6, 1e15, 1e300] {
        let calls = counter();
        let four_bar = FourBar::<f64>::new(lengths, calls);
        assert!(limits(&four_bar, [0.3, 0.3 + width]).expect("an interval").is_whole());
        assert!(calls.get() <= 4 + 2 * 535 + 16 * 128 * (9 + 2 * 59), "{width} {}", calls.get());
    }
}

/// A seventeenth of each turn, which no clearance tells.
#[test]
fn the_solver_itself_is_asked_in_every_turn() {
    fn assert_asked<T: Real>(turns: u32) {
        let mut four_bar = FourBar::<T>::new([0.5, 4.0, 3.0, 3.5], counter());
        four_bar.highest_cosine = 0.98;
        let ends = [0.1 - PI, 0.1 - PI + f64::from(turns) * TAU];
        let found = limits(&four_bar, ends.map(number)).expect("an interval");
        assert_eq!(found.len(), turns as usize + 1, "{:?}", &*found);
        for (turn, pair) in found.windows(2).enumerate() {
            let zero = turn as f64 * TAU;
            let room = 4.0 * <T as Real>::EPSILON * (zero + 1.0);
            let [before, behind] = [zero - 0.98_f64.acos(), zero + 0.98_f64.acos()];
            assert!((pair[0].to.at.value() - before).abs() <= room, "{turn}");
            assert!((pair[1].from.at.value() - behind).abs() <= room, "{turn}");
            assert_eq!(pair[0].to.stop, Stop::Limit { group: "dimension" });
        }
    }
    for turns in [1, 2, 10, 31] {
        assert_asked::<f64>(turns);
        assert_asked::<f32>(turns);
    }
}

#[test]
fn turns_of_every_turn_are_found() {
    fn count<T: Real>(ends: [f64; 2]) -> Result<usize, RangeError> {
        let cosine = |x: T| {
            let (sin, cos) = x.value().sin_cos();
            Ok([cos, -sin, -cos].map(number))
        };
        extrema(ends.map(number::<T>), cosine).map(|found| found.len())
    }
    for (ends, expected) in [([0.03, 0.03 + 15.0 * TAU], 30), ([-7.0, 64.0], 23)] {
        assert_eq!([count::<f64>(ends), count::<f32>(ends)], [Ok(expected); 2], "{ends:?}");
    }
    for turns in [17.0, 32.0, 64.0, 128.0, 1024.0] {
        for from in [0.0, 0.5 * PI, 1.0] {
            let ends = [from, from + turns * TAU];
            let many = Err(RangeError::TooMany);
            assert_eq!([count::<f64>(ends), count::<f32>(ends)], [many; 2], "{ends:?}");
        }
    }
}

#[test]
fn panels_are_no_longer_than_a_sixteenth_of_a_turn_for_34_turns() {
    for length in [0.0, 1e-300, 0.1, TAU, 6.39] {
        let ends: Vec<_> = Panels::over(length).ends().collect();
        let equal: Vec<_> = (1..=16).map(|panel| [f64::from(panel) / 16.0, 0.0625]).collect();
        assert_eq!(ends, equal, "{length}");
    }
    for length in [6.41, 7.0, 100.0, 34.0 * TAU, 213.99, 214.01, 215.0, 1e6, 1e300] {
        let ends: Vec<_> = Panels::over(length).ends().collect();
        assert!(ends.len() <= 535 + 16 && ends.last().map(|end| end[0]) == Some(1.0), "{length}");
        let mut before = 0.0;
        for [end, long] in ends {
            assert!(end > before || length == 1e300, "{length} {end}");
            // The difference of two parts is as right as their larger one.
            assert!((end - before - long).abs() <= 2.0 * f64::EPSILON, "{length} {end}");
            let is_short = long * length <= 0.4 * (1.0 + 4.0 * f64::EPSILON);
            assert!(is_short || before * length >= 34.0 * TAU - 1e-9, "{length} {end}");
            before = end;
        }
    }
}

/// A limit on a sample of the walk moves with the dimensions as one between two samples does.
#[cfg(feature = "ad")]
#[test]
fn a_limit_on_a_sample_has_its_derivatives() {
    use num_dual::Dual64;
    for machine in 1..200 {
        let lengths = [2.0, 3.0, 5.0, 7.0].map(|prime| 0.2 + 1.8 * spread(machine, prime));
        let Some(stretches) = closed_form(lengths, [0.0, PI], 1e-2) else { continue };
        let [crank, base, ..] = lengths;
        for limit in stretches.into_iter().flatten().filter(|&end| end > 0.0 && end < PI) {
            // cos θ = (k² + b² − d²)/(2kb), by the crank's length k.
            let slope = (1.0 / base - limit.cos() / crank) / -limit.sin();
            let mut four_bar = FourBar::<Dual64>::new(lengths, counter());
            four_bar.lengths[0].eps = 1.0;
            for aside in [0.01, 0.0] {
                let ends = [limit - 0.005 - aside, limit + 0.005].map(Dual64::from_re);
                let found = limits(&four_bar, ends).expect("an interval");
                let ends: Vec<_> = found.iter().flat_map(|s| [s.from, s.to]).collect();
                let end = ends.iter().find(|end| matches!(end.stop, Stop::Limit { .. }));
                let at = end.expect("the limit").at;
                assert!((at.re - limit).abs() < 1e-11, "{lengths:?} {at}");
                assert!(
                    (at.eps - slope).abs() < 1e-9 * slope.abs().max(1.0),
                    "{lengths:?} {at} {slope}"
                );
            }
        }
    }
}
