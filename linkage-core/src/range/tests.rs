//! Zeros of functions that are made to be missed.

/// A solver whose output is its input; where it has a pose and how clear of its limits, a test says.
macro_rules! output_is_input {
    ($number:ident) => {
        type Scalar = $number;
        type Input = $number;
        type Position = $number;
        type Velocity = $number;
        type Motion = $number;
        type Rows = [$number; 1];
        type Coefficients = [[$number; 1]; 1];

        fn input(mut number: impl FnMut(usize) -> $number) -> $number {
            number(0)
        }

        fn velocity(&self, q: $number, _: $number) -> Result<$number, SolveError> {
            self.position(q)
        }

        fn motion(&self, q: $number, _: $number, _: $number) -> Result<$number, SolveError> {
            self.position(q)
        }

        fn coefficients(&self, q: $number) -> Result<[[$number; 1]; 1], SolveError> {
            self.position(q).map(|q| [[q]])
        }

        fn position_rows(q: $number) -> [$number; 1] {
            [q]
        }

        fn motion_rows(q: $number) -> [[$number; 1]; 3] {
            [[q]; 3]
        }

        fn solve<const ORDER: usize, U: Scalar>(
            &self,
            given: impl Fn(usize) -> U,
            put: impl FnOnce(&[U]),
        ) -> U::Mask {
            put(&[given(0)]);
            <U::Mask as crate::Mask>::ALL
        }
    };
}

mod repeated;
mod turns;

use std::prelude::v1::*;
use std::vec::Vec;

use super::panels::Panels;
use super::walk::{Event, Walk};
use super::{extrema, limits};
use crate::clearance::Clearance;
use crate::solver::{Solver, Titles};
use crate::{Real, Scalar, SolveError};

fn events(f: impl FnMut(f64) -> [f64; 2], ends: [f64; 2]) -> Vec<Event<f64>> {
    let mut list = Vec::new();
    let mut walk = Walk { f, zero: 64.0 * f64::EPSILON, ends };
    walk.events(Panels::over(ends[1] - ends[0]), |event| list.push(event))
        .expect("numbers everywhere");
    list
}

fn at(event: &Event<f64>) -> f64 {
    let (Event::Rises(at) | Event::Falls(at) | Event::Touches(at)) = *event;
    at
}

/// The product of the distances from a dozen places, its sign and its slope.
fn polynomial(roots: &[f64], x: f64) -> [f64; 2] {
    roots
        .iter()
        .fold([1.0, 0.0], |[value, slope], root| [value * (x - root), slope * (x - root) + value])
}

#[test]
fn zeros_close_together_and_far_apart_are_told_in_order() {
    for gap in [0.3, 1e-2, 1e-4, 1e-6, 3e-7] {
        // A dip below zero, and with the sign turned a hump above it, at any place in a panel.
        for place in 0..50 {
            let middle = -0.9 + 0.037 * f64::from(place);
            let roots = [middle - gap, middle + gap];
            for sign in [1.0, -1.0] {
                let found = events(|x| polynomial(&roots, x).map(|y| sign * y), [-1.5, 1.7]);
                assert_eq!(found.len(), 2, "{gap} {middle} {sign} {found:?}");
                let falls_first = matches!(found[..], [Event::Falls(_), Event::Rises(_)]);
                let rises_first = matches!(found[..], [Event::Rises(_), Event::Falls(_)]);
                assert!(if sign > 0.0 { falls_first } else { rises_first }, "{found:?}");
                for (event, root) in found.iter().zip(roots) {
                    // Each root is as right as the difference of squares is: ε over the gap.
                    assert!((at(event) - root).abs() <= 4.0 * f64::EPSILON * (1.0 + 1.0 / gap));
                }
            }
        }
    }
}

#[test]
fn what_touches_zero_is_told_from_what_misses_it() {
    for place in 0..50 {
        let middle = -0.9 + 0.037 * f64::from(place);
        let parabola = |above: f64| {
            events(|x| [(x - middle) * (x - middle) + above, 2.0 * (x - middle)], [-1.5, 1.7])
        };
        let touching = parabola(0.0);
        assert!(matches!(touching[..], [Event::Touches(_)]), "{middle} {touching:?}");
        assert!((at(&touching[0]) - middle).abs() < 1e-7);
        assert!(parabola(1e-12).is_empty() && parabola(0.1).is_empty());
        assert_eq!(parabola(-1e-12).len(), 2);
        // From below nothing opens but what is zero to rounding, where a sample falls on it.
        let below = |x: f64| [-(x - middle) * (x - middle), -2.0 * (x - middle)];
        let found = events(below, [-1.5, 1.7]);
        assert!(found.len() <= 2 && found.iter().all(|event| (at(event) - middle).abs() < 2e-7));
    }
    // At a sample, exactly, and at an end of the way.
    for middle in [0.0, 0.25, 0.5, 0.5625, 1.0] {
        let found = events(|x| [(x - middle) * (x - middle), 2.0 * (x - middle)], [-1.0, 1.0]);
        assert!(found.len() <= 1, "{middle} {found:?}");
        assert!(middle == 1.0 || matches!(found[..], [Event::Touches(_)]), "{middle} {found:?}");
        let found = events(|x| [x - middle, 1.0], [-1.0, 1.0]);
        assert!(matches!(found[..], [Event::Rises(_)]), "{middle} {found:?}");
        assert!((at(&found[0]) - middle).abs() <= f64::EPSILON, "{middle} {found:?}");
    }
}

/// The clearance of a four-bar's dyad: zeros of two kinds in one product, with the number of
/// evaluations that they take.
#[test]
fn a_turn_of_a_four_bar_takes_few_evaluations() {
    let mut most = [0, 0];
    for machine in 0..400_i32 {
        let length = |prime: i32| 0.2 + 1.8 * f64::from(machine * prime % 401) / 401.0;
        let [crank, coupler, rocker, base] = [101, 211, 307, 17].map(length);
        let mut calls = 0;
        let f = |angle: f64| {
            calls += 1;
            let square = crank * crank + base * base - 2.0 * crank * base * angle.cos();
            let rate = 2.0 * crank * base * angle.sin();
            let outer = (coupler + rocker) * (coupler + rocker) - square;
            let inner = square - (coupler - rocker) * (coupler - rocker);
            let scale = coupler * coupler * rocker * rocker;
            [outer * inner / scale, rate * (outer - inner) / scale]
        };
        let found = events(f, [-3.2, 3.08]);
        assert!(found.len() <= 4, "{found:?}");
        let kind = usize::from(!found.is_empty());
        most[kind] = most[kind].max(calls);
    }
    std::println!("{most:?} evaluations without and with a limit");
    // 33 samples, and six trials for each of up to four limits and for a dip.
    assert!(most[0] <= 40 && most[1] <= 65, "{most:?}");
}

#[test]
fn what_varies_fast_is_walked_in_short_steps() {
    // Fifteen periods are a panel each, forty are none.
    for periods in [15.0_f64, 40.0] {
        let f = |x: f64| [(periods * x).sin(), periods * (periods * x).cos()];
        let found = events(f, [0.03, 6.3]);
        assert_eq!(found.len(), 2 * periods as usize, "{found:?}");
        for (count, event) in found.iter().enumerate() {
            let zero = core::f64::consts::PI * (count + 1) as f64 / periods;
            assert!((at(event) - zero).abs() < 2e-15, "{event:?}");
        }
    }
}

/// A zero behind an end, by less than what counts as zero, is at the end, and nothing is asked behind it.
#[test]
fn a_walk_stays_between_its_ends() {
    for off in [1.0, 10.0, 40.0].map(|times| times * f64::EPSILON) {
        for end in [-1.0, 1.0] {
            let f = |x: f64| {
                assert!(x.abs() <= 1.0, "{x}");
                [end * x - 1.0 - off, end]
            };
            let found = events(f, [-1.0, 1.0]);
            assert!(found.iter().all(|event| at(event) == end) && !found.is_empty(), "{found:?}");
        }
    }
}

/// Between numbers that are farther apart than the shortest piece is long a walk comes to its end.
#[test]
fn what_no_number_lies_between_is_not_divided() {
    for from in [1e15, 3e16, 1e17] {
        for numbers in [1.0, 2.0, 3.0, 10.0, 64.0] {
            let mut calls = 0;
            let f = |x: f64| {
                calls += 1;
                assert!(calls < 10_000, "a walk that does not go on");
                [x.sin(), x.cos()]
            };
            events(f, [from, from + numbers * from * f64::EPSILON]);
        }
    }
}

/// A sample at which the function is zero to rounding is as far from the root as its slope tells, or the
/// root itself where the slope tells nothing.
#[test]
fn a_root_next_to_a_sample_is_where_the_slope_puts_it() {
    let off = 40.0 * f64::EPSILON;
    for slope in [1.0, 0.25] {
        // The sample at zero is beyond the root by so much.
        let found = events(|x| [-slope * (x + off / slope), -slope], [-1.0, 1.0]);
        let [Event::Falls(at)] = found[..] else { unreachable!("{found:?}") };
        assert!((at + off / slope).abs() <= f64::EPSILON / 4.0, "{slope} {at}");
        let found = events(|x| [slope * (x - off / slope), slope], [-1.0, 1.0]);
        let [Event::Rises(at)] = found[..] else { unreachable!("{found:?}") };
        assert!((at - off / slope).abs() <= f64::EPSILON / 4.0, "{slope} {at}");
    }
    let flat = events(|x| [-x * x * x - off, -3.0 * x * x], [-1.0, 1.0]);
    assert_eq!(flat.last(), Some(&Event::Falls(0.0)), "{flat:?}");
}

/// A sample that is zero to rounding counts as above zero, and hides no hump that comes down to it: with
/// one zero on the sample both are told, and nothing at all where the hump is a dip.
#[test]
fn a_hump_that_ends_on_a_sample_is_told() {
    for gap in [0.1, 1e-2, 1e-3, 1e-4, 1e-5] {
        for off in [0.0, 20.0, -20.0].map(|times| times * f64::EPSILON / gap) {
            for sample in [-0.5, 0.0, 0.125] {
                for roots in
                    [[sample + off, sample + off + gap], [sample + off - gap, sample + off]]
                {
                    let hump = |x| polynomial(&roots, x).map(|y| -y);
                    let found: Vec<_> = events(hump, [-1.0, 1.0]);
                    let mut is_above = false;
                    let mut widths = Vec::new();
                    let mut from = -1.0;
                    for event in &found {
                        match event {
                            Event::Rises(at) if !is_above => (is_above, from) = (true, *at),
                            Event::Falls(at) if is_above => {
                                is_above = false;
                                widths.push(at - from);
                            }
                            Event::Falls(_) => {}
                            _ => unreachable!("{found:?}"),
                        }
                    }
                    let [width] = widths[..] else { unreachable!("{roots:?} {found:?}") };
                    assert!((width - gap).abs() <= 8.0 * f64::EPSILON, "{roots:?} {found:?}");
                }
            }
        }
    }
}

#[test]
fn numbers_that_are_none_are_refused() {
    for bad in [[f64::NAN, 1.0], [1.0, f64::INFINITY]] {
        let mut walk = Walk {
            f: |x: f64| if x > 0.9 { bad } else { [1.0, 0.0] },
            zero: 0.0,
            ends: [0.0, 1.0],
        };
        assert!(walk.events(Panels::over(1.0), |_| ()).is_err());
    }
}

/// Two groups, the first between −1 and 1 and the second with the height h = √(1 − q²) of the first
/// in its clearance, a polynomial: as a dyad's on a coupler is.
#[derive(Clone, Copy)]
struct Chained<'a> {
    heights: &'a [f64],
}

impl Solver for Chained<'_> {
    output_is_input!(f64);
    type Groups<X: Copy> = [X; 2];

    const TITLES: Titles = Titles {
        name: "Chained",
        inputs: &["q"],
        outputs: &["q"],
        groups: &[("first", None), ("second", None)],
    };

    fn position(&self, q: f64) -> Result<f64, SolveError> {
        let [first, second] = self.clearances(q, 0.0).map(|clearance| clearance.value);
        let group = if first < -4e-16 { "first" } else { "second" };
        // Rounding, as in a group's own rule; NaN is behind the limit of the first group.
        let is_met = group == "second" && (second.is_nan() || second >= -1e-15);
        if is_met { Ok(q) } else { Err(SolveError::OutOfReach { group, by: 1.0 }) }
    }

    /// Its clearances are its own.
    fn told<U: Real, X: Copy>(
        &self,
        _: impl Fn(f64) -> U,
        _: impl Fn(usize) -> U,
        of: impl Fn([U; 2]) -> X,
    ) -> [X; 2] {
        [of([U::num(f64::NAN); 2]); 2]
    }

    fn clearances(&self, q: f64, rate: f64) -> [Clearance<f64>; 2] {
        let square = (1.0 - q) * (1.0 + q);
        let height = square.sqrt();
        let ([value, slope], nan) = (polynomial(self.heights, height), f64::NAN);
        [
            Clearance { value: square, rate: -2.0 * q * rate, second_rate: nan, scale: 1.0 },
            Clearance { value, rate: slope * -q / height * rate, second_rate: nan, scale: 1.0 },
        ]
    }
}

#[test]
fn stretches_and_extremes_print_as_lists_of_what_there_is() {
    let chained = Chained { heights: &[0.2, 0.4, 0.6] };
    let found = limits(&chained, [-1.5, 1.3]).expect("an interval");
    assert_eq!(format!("{found:?}"), format!("{:?}", &found[..]));
    let sine = |q: f64| Ok([q.sin(), q.cos(), -q.sin()]);
    let turns = extrema([0.0, 3.0], sine).expect("an interval");
    assert_eq!(format!("{turns:?}"), format!("{:?}", &turns[..]));
    assert_eq!(turns.len(), 1);
}

/// Heights of the first group at which the second is at its limit, several of them within a piece
/// of the way to the first one's: where the input goes with their square, they are apart.
#[test]
fn a_group_behind_a_limit_is_followed_to_it() {
    for machine in 0..400_i32 {
        let part = f64::from(machine) / 400.0;
        let lowest = 0.02 + 0.3 * part * part;
        let heights = [1.0, 1.5, 2.2].map(|times| times * lowest);
        let chained = Chained { heights: &heights };
        // Positive between the lower two heights and above the upper one.
        let [q0, q1, q2] = heights.map(|height| ((1.0 - height) * (1.0 + height)).sqrt());
        let assert_found = |between, expected: &[[f64; 2]]| {
            let found = limits(&chained, between).expect("an interval");
            assert_eq!(found.len(), expected.len(), "{heights:?} {:?}", &*found);
            for (stretch, [from, to]) in found.iter().zip(expected) {
                let error = (stretch.from.at - from).abs().max((stretch.to.at - to).abs());
                // The rounding of the input, and what that of the polynomial, the product of two
                // differences of heights smaller than themselves, makes of it.
                let allowed = 8.0 * f64::EPSILON * (1.0 + 1.0 / lowest);
                assert!(error <= allowed, "{error:e} {heights:?}");
            }
        };
        assert_found([-1.5, 1.3], &[[-q0, -q1], [-q2, q2], [q1, q0]]);
        assert_found([-1.5, 0.0], &[[-q0, -q1], [-q2, 0.0]]);
        assert_found([-0.1, 1.3], &[[-0.1, q2], [q1, q0]]);
    }
}
