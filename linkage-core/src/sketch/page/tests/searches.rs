//! Searches of random equations, with the crate's own roots and refusals.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::cases::{Case, Random, bits};
use crate::Scalar;
use crate::find::Trend;
use crate::roots::unknown::root;
use crate::roots::{At, FindError, judged};

/// Sums of sines with up to six dead points, searched from both ends or from a seed. Now and then the ends are
/// out of order, the target next to a dead point or an end, or the sum no number in a part of the interval. Slopes
/// that are not the sum's lead Newton's steps astray, until evaluations run out.
pub(super) fn searches() -> impl Iterator<Item = Case> {
    let mut random = Random::new(17);
    (0..20_000).map(move |nth| {
        let terms: Vec<[f64; 3]> = (0..=random.bits() % 3)
            .map(|k| {
                let size = 2.0 * random.unit() - 1.0;
                // Now and then more turns than samples can tell apart.
                let turns = if nth % 10 == 0 { 40.0 } else { 1.0 };
                [size, (k + 1) as f64 * turns * (0.2 + random.unit()), 6.0 * random.unit()]
            })
            .collect();
        let from = 4.0 * random.unit() - 2.0;
        let to = if nth % 50 == 0 { from - random.unit() } else { from + 4.0 * random.unit() };
        let of = |x: f64| sum(&terms, x)[0];
        let target = match random.bits() % 8 {
            0 => far(&mut random, of(to)),
            1 => far(&mut random, of(lowest(of, from, to))),
            _ => 1.5 * random.unit() - 0.75,
        };
        let near = if nth % 3 == 0 { from + (to - from) * random.unit() } else { f64::NAN };
        let hole = if nth % 20 == 0 { from + (to - from) * random.unit() } else { f64::INFINITY };
        let trend = if random.bits().is_multiple_of(2) { Trend::Rising } else { Trend::Falling };
        let share = match random.bits() % 16 {
            0 => 0.0,
            1 => -1.0,
            2 => 1e-3,
            3 => 1e9,
            4 => 8.0 * random.unit(),
            _ => 1.0,
        };
        asked([from, to], trend, [near, target, hole, share], &terms)
    })
}

/// Searches of a sine between its dead points, whose slope has one sign: within reach, beyond it, and next to an end.
pub(super) fn steady() -> impl Iterator<Item = Case> {
    let mut random = Random::new(41);
    let quarter = core::f64::consts::FRAC_PI_2;
    (0..20_000).map(move |_| {
        let mut ends = [random.unit(), random.unit()].map(|part| (2.0 * part - 1.0) * quarter);
        ends.sort_by(f64::total_cmp);
        if random.bits().is_multiple_of(2) {
            ends[0] = -quarter;
        }
        if random.bits().is_multiple_of(2) {
            ends[1] = quarter;
        }
        let size = if random.bits().is_multiple_of(2) { 0.3 + random.unit() } else { -0.7 };
        let terms = [[size, 1.0, 0.0]];
        let [a, b] = ends.map(|end| sum(&terms, end)[0]);
        let target = match random.bits() % 4 {
            0 => {
                let end = if random.bits().is_multiple_of(2) { a } else { b };
                far(&mut random, end)
            }
            1 => a + random.unit() * (b - a),
            _ => a + (5.0 * random.unit() - 2.0) * (b - a),
        };
        let trend =
            if (size > 0.0) == (random.unit() < 0.9) { Trend::Rising } else { Trend::Falling };
        let case = asked(ends, trend, [f64::NAN, target, f64::INFINITY, 1.0], &terms);
        Case { name: "steady", ..case }
    })
}

/// Pieces of a survey: mostly one of the numbers that its judgement compares is within some units in the last
/// place of the other.
pub(super) fn pieces() -> impl Iterator<Item = Case> {
    let mut random = Random::new(23);
    (0..40_000).map(move |_| {
        let mut signed = || 2.0 * random.unit() - 1.0;
        let [x, width] = [signed(), 0.1 + signed().abs()];
        let mut place = |x: f64| At { x, value: signed(), slope: 3.0 * signed() };
        let (mut a, mut b, middle) = (place(x), place(x + width), place(x + 0.5 * width));
        let mut error = 0.3 * random.unit();
        // The rise and the slopes by the part of the way, of which a judgement is made.
        let [rise, d0, d1] = [b.value - a.value, a.slope * width, b.slope * width];
        match random.bits() % 8 {
            0 => error = far(&mut random, a.value.abs().min(b.value.abs())),
            1 => (a.value, b.value, error) = (1e-15 * a.value, b.value.abs(), 0.0),
            2 => error = far(&mut random, d0.abs().min(d1.abs()) / 3.1),
            3 => error = far(&mut random, (6.0 * rise - 4.0 * d0 - 2.0 * d1).abs() / 32.0),
            4 => error = far(&mut random, (6.0 * rise - 2.0 * d0 - 4.0 * d1).abs() / 32.0),
            5 => (a.slope, error) = (0.0, 1e-3 * error),
            6 => (b.slope, error) = (0.0, 1e-3 * error),
            _ => {}
        }
        match random.bits() % 40 {
            0 => (a.value, error) = (0.0, 0.0),
            1 => (b.value, error) = (0.0, 0.0),
            2 => (b.value, a.value, error) = (-0.0, -0.0, 0.0),
            _ => {}
        }
        let (is_clear, turn, halves) = judged([a, b], error, middle);
        let given = [a, b, middle].map(|at| [at.x, at.value, at.slope]).concat();
        let answer = format!("{is_clear} {turn} {}", bits(halves));
        Case { name: "piece", given: [&[error][..], &given].concat(), answer }
    })
}

/// The number up to some 64 units in the last place away.
fn far(random: &mut Random, x: f64) -> f64 {
    (0..8).fold(x, |x, _| random.beside(x))
}

/// The lowest of a hundred places, moved to where three of them have their parabola's vertex.
fn lowest(of: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let at = |k: u32| from + (to - from) * f64::from(k) / 100.0;
    let least = (1..100).min_by(|&a, &b| of(at(a)).total_cmp(&of(at(b)))).unwrap_or(1);
    let [x, h] = [at(least), (to - from) / 100.0];
    let [a, b, c] = [of(x - h), of(x), of(x + h)];
    x + 0.5 * h * (a - c) / (a - 2.0 * b + c)
}

/// The sum of a sin(bx + c) and its slope, rounded as the script rounds it.
fn sum(terms: &[[f64; 3]], x: f64) -> [f64; 2] {
    terms.iter().fold([0.0; 2], |[value, slope], [a, b, c]| {
        let (sin, cos) = Scalar::sin_cos(b * x + c);
        [value + a * sin, slope + a * b * cos]
    })
}

fn asked(
    between: [f64; 2],
    trend: Trend,
    [near, target, hole, share]: [f64; 4],
    terms: &[[f64; 3]],
) -> Case {
    let sides = |x: f64| {
        let [value, slope] = sum(terms, x);
        [if x > hole { f64::NAN } else { value }, target, slope * share]
    };
    let seed = (!near.is_nan()).then_some(near);
    let answer = said(root(between, trend, seed, || unreachable!("these carry none"), sides));
    let head = [between[0], between[1], trend.sign(), near, target, hole, share];
    Case { name: "search", given: [&head[..], terms.as_flattened()].concat(), answer }
}

fn said(found: Result<[f64; 2], FindError>) -> String {
    match found {
        Ok([at, size]) => format!("{} {}", bits(at), bits(size)),
        Err(FindError::Interval { from, to }) => format!("Interval {}", to > from),
        Err(FindError::NoSolution { by, other, .. }) => {
            let other = other.map(|of| format!(" {} {}", of.trend.sign::<f64>(), bits(of.at)));
            format!("NoSolution {}{}", bits(by), other.unwrap_or_default())
        }
        Err(FindError::SeveralDeadPoints) => "SeveralDeadPoints".to_string(),
        Err(FindError::NotFinite { at }) => format!("NotFinite {}", bits(at)),
        Err(FindError::Singular { .. }) => "Singular".to_string(),
    }
}
