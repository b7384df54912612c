//! Searches over intervals: roots, the limits of an input, the extremes of an output.

use core::f64::consts::{PI, TAU};

use linkage_core::find::{FindError, Search};
use linkage_core::range::{RangeError, Stop, Stretch, Turn, extrema, limits};
use linkage_core::{Mechanism, Real, Trend};
use linkage_tests::mechanisms::single_groups::{CouplerFourBar, InclinedSliderCrank};
use linkage_tests::mechanisms::stacked_sliders::ParamFourBar;

use super::calls::{At, Calls};
use super::numbers::{Number, Source};

/// A sum of waves, as a mechanism's output is one of its angle.
#[derive(Clone, Copy, Debug)]
struct Waves<T> {
    constant: T,
    /// Amplitude, frequency and phase of each.
    waves: [[T; 3]; 3],
}

impl<T: Number> Waves<T> {
    fn drawn(source: &mut Source) -> Self {
        let waves = [1.0, 2.0, 3.0].map(|frequency: f64| {
            let numbers =
                [source.between(-1.0, 1.0) / frequency, frequency, source.between(-PI, PI)];
            numbers.map(T::near)
        });
        Self { constant: T::near(source.between(-1.0, 1.0)), waves }
    }

    /// The value, the rate and the acceleration.
    fn at(&self, x: T) -> [T; 3] {
        let start = [self.constant, T::near(0.0), T::near(0.0)];
        self.waves.iter().fold(start, |[value, rate, second], &[size, frequency, phase]| {
            let (sin, cos) = (frequency * x + phase).sin_cos();
            let by = size * frequency;
            [value + size * sin, rate + by * cos, second - by * frequency * sin]
        })
    }
}

/// One interval in so many is also scanned densely.
const SCANNED: usize = 16;
const SAMPLES: u32 = 2000;

/// So many calls, a third of each kind.
pub(crate) fn run<T: Number>(source: &mut Source, count: u64, calls: &mut Calls) {
    let end = calls.count + count;
    while calls.count < end {
        let waves = Waves::<T>::drawn(source);
        let between = interval(source, 7.0);
        found(source, &waves, between, calls);
        let turns = if source.below(4) == 0 { MANY_TURNS } else { 1.1 };
        let between = interval(source, turns * TAU);
        turned(source, &waves, between, calls);
        let params = [0, 1, 2, 3].map(|_| T::near(source.between(0.2, 2.0)));
        let [crank, base, rocker, coupler] = match source.below(8) {
            0 => [0, 1, 2, 3].map(|_| source.odd()),
            _ => params,
        };
        let four_bar = ParamFourBar { crank, base, rocker, coupler, ..Default::default() };
        limited(source, &four_bar, between, calls);
        limited(source, &CouplerFourBar::<T>::default(), between, calls);
        limited(source, &InclinedSliderCrank::<T>::default(), between, calls);
    }
}

/// The most turns of an interval: the clearance of a four-bar comes to zero at most four times in each turn.
const MANY_TURNS: f64 = 15.0;

/// Ends no farther apart than somebody may mean, or odd ones.
fn interval<T: Number>(source: &mut Source, width: f64) -> [T; 2] {
    if source.below(8) == 0 {
        return [source.odd(), source.odd()];
    }
    let from = source.between(-4.0, 4.0);
    [from, from + source.between(0.01, width)].map(T::near)
}

fn is_meant<T: Number>([from, to]: [T; 2]) -> bool {
    [from, to].iter().all(|end| end.value().abs() < 100.0) && to.value() - from.value() > 1e-3
}

/// Places all over an interval, both ends among them.
fn places<T: Number>([from, to]: [T; 2]) -> impl Iterator<Item = T> {
    let step = (to.value() - from.value()) / f64::from(SAMPLES);
    (0..=SAMPLES).map(move |i| T::near(from.value() + step * f64::from(i)))
}

fn found<T: Number>(source: &mut Source, waves: &Waves<T>, between: [T; 2], calls: &mut Calls) {
    let trend = [Trend::Rising, Trend::Falling][source.below(2)];
    let mut search = Search::new(between, trend);
    if source.below(2) == 0 {
        search = search.near(if source.below(4) == 0 {
            source.odd()
        } else {
            T::near(source.between(-4.0, 10.0))
        });
    }
    let mut evaluations = 0_u32;
    let found = search.find(|x| {
        evaluations += 1;
        let [value, rate, _] = waves.at(x);
        [value, rate]
    });
    calls.count += 1;
    let state = (trend, search, *waves);
    let mut at = At { calls, mechanism: "sums of waves", state: &state };
    if evaluations > 2 * Search::<T>::MOST + 3 {
        at.wrong("find", "more evaluations than promised", &evaluations);
    }
    let sign = trend.sign::<f64>();
    // Six roundings of numbers up to three, at angles of up to 40.
    let rounding = 512.0 * T::HALF_UNIT;
    match found {
        Ok(root) => {
            let [value, rate, _] = waves.at(root.at).map(Real::value);
            let is_inside = root.at >= between[0] && root.at <= between[1];
            let is_root = value.abs() <= rounding * (1.0 + root.at.value().abs())
                && sign * rate >= -rounding.sqrt() * 4.0;
            if !(is_inside && (is_root || !is_meant(between))) {
                at.wrong("find", "no root of the trend", &(root, value, rate));
            }
        }
        Err(FindError::NoSolution { .. }) if is_meant(between) && source.below(SCANNED) == 0 => {
            // A crossing, and not one that rounding makes.
            let clear = rounding * 10.0;
            let values = places(between).map(|x| sign * waves.at(x)[0].value());
            let mut was_below = false;
            for value in values {
                if was_below && value > clear {
                    at.wrong("find", "a root that was not found", &found);
                    break;
                }
                was_below = value < -clear || (was_below && value <= clear);
            }
        }
        Err(_) => {}
    }
}

/// Extremes are where the dense scan has them, and mirrored functions have mirrored ones.
fn turned<T: Number>(source: &mut Source, waves: &Waves<T>, between: [T; 2], calls: &mut Calls) {
    let found = extrema(between, |x| Ok(waves.at(x)));
    let mirrored = extrema(between, |x| Ok(waves.at(x).map(|number| -number)));
    calls.count += 2;
    let state = (between, *waves);
    let mut at = At { calls, mechanism: "sums of waves", state: &state };
    let (found, mirrored) = match (found, mirrored) {
        (Ok(found), Ok(mirrored)) => (found, mirrored),
        (Err(RangeError::Interval { .. }), Err(RangeError::Interval { .. })) => return,
        (Err(one), Err(other)) if one == other => return,
        both => return at.wrong("extrema", "mirrored otherwise", &both),
    };
    let turn = |turn| if turn == Turn::Maximum { Turn::Minimum } else { Turn::Maximum };
    // Both are searched by the same numbers.
    let is_mirrored = found.len() == mirrored.len()
        && found
            .iter()
            .zip(mirrored.iter())
            .all(|(a, b)| a.at == b.at && a.value == -b.value && a.turn == turn(b.turn));
    if !is_mirrored {
        at.wrong("extrema", "mirrored otherwise", &(found, mirrored));
    }
    let is_sorted =
        found.windows(2).all(|pair| pair[0].at < pair[1].at && pair[0].turn != pair[1].turn);
    let is_inside = found.iter().all(|turn| turn.at >= between[0] && turn.at <= between[1]);
    let numbers = found.iter().flat_map(|turn| [turn.at, turn.value]).chain([found.stroke()]);
    if !(is_sorted && is_inside && numbers.into_iter().all(|number| number.value().is_finite())) {
        at.wrong("extrema", "not in order, not inside or no numbers", &found);
    }
    if is_meant(between) && source.below(SCANNED) == 0 {
        let [mut least, mut most] = [f64::INFINITY, f64::NEG_INFINITY];
        for x in places(between) {
            let value = waves.at(x)[0].value();
            (least, most) = (least.min(value), most.max(value));
        }
        let slack = 512.0 * T::HALF_UNIT * (1.0 + between[1].value().abs());
        let [low, high] = [found.least()[1].value(), found.greatest()[1].value()];
        if low > least + slack || high < most - slack {
            at.wrong("extrema", "a scan goes further", &([low, high], [least, most]));
        }
    }
}

/// Every pose within a stretch is assembled, and none of a scan outside is.
fn limited<T, M>(source: &mut Source, machine: &M, between: [T; 2], calls: &mut Calls)
where
    T: Number,
    M: linkage_core::Solver<Scalar = T, Input = T> + core::fmt::Debug,
{
    let found = limits(machine, between);
    calls.count += 1;
    let state = (between, *machine);
    let mut at = At { calls, mechanism: <M as Mechanism>::NAME, state: &state };
    let stretches = match found {
        Ok(stretches) => stretches,
        Err(RangeError::Interval { .. } | RangeError::TooMany | RangeError::Solve(_)) => return,
        Err(error) => return at.wrong("limits", "a kind that this program does not know", &error),
    };
    let is_sorted = stretches.iter().all(|stretch| {
        between[0] <= stretch.from.at
            && stretch.from.at < stretch.to.at
            && stretch.to.at <= between[1]
    }) && stretches.windows(2).all(|pair| pair[0].to.at <= pair[1].from.at);
    if !is_sorted {
        at.wrong("limits", "not in order or not inside", &stretches);
    }
    // At a change point a group barely reaches, on either side of it.
    let is_barely = |stretch: &Stretch<T>| {
        [stretch.from, stretch.to].iter().any(|end| matches!(end.stop, Stop::ChangePoint { .. }))
    };
    if !is_meant(between) || stretches.iter().any(is_barely) || source.below(SCANNED) != 0 {
        return;
    }
    // Next to a limit rounding decides, and what is narrower than a sixteenth may be missed.
    let room = (64.0 * T::HALF_UNIT).sqrt() * 8.0;
    for x in places(between) {
        let here = x.value();
        let inside = |room: f64| {
            stretches
                .iter()
                .any(|s| here > s.from.at.value() + room && here < s.to.at.value() - room)
        };
        let solved = linkage_core::Solver::position(machine, x).is_ok();
        if inside(room) && !solved {
            return at.wrong("limits", "a pose inside that cannot be assembled", &(x, stretches));
        }
        if !inside(-room) && solved {
            return at.wrong("limits", "a pose outside that can be assembled", &(x, stretches));
        }
    }
}
