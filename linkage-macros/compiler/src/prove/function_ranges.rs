//! Functions of intervals, and their slopes.
//!
//! The library's functions are off by less than [`LIBRARY`] of their result, and so are theirs at the ends.

use core::f64::consts::PI;

use super::outward::{OutwardInterval, above};
use super::sloped::{InputBox, SlopedValue};
use crate::function::Function;

/// More than the error of a function of `f64` by a good library, relative and absolute for results up to 4.
const LIBRARY: f64 = 4.0 * f64::EPSILON;

/// Beyond it, quarters of a turn are not counted.
const FAR: f64 = 1.1e6;

/// More than the rounding of an angle below [`FAR`] in half turns.
const PHASE: f64 = 1e-9;

/// Value and slopes of a function by each argument; none where it is not followed, or where it jumps or has a corner
/// on the way.
pub fn of(
    function: Function,
    arguments: &[OutwardInterval],
) -> Option<(OutwardInterval, [OutwardInterval; 2])> {
    let one = |value, slope| Some((value, [slope, OutwardInterval::ZERO]));
    let unit = OutwardInterval::point(1.0);
    match (function, arguments) {
        (Function::Sqrt, &[a]) => {
            let root = a.root();
            one(root, root.add(root).reciprocal())
        }
        (Function::Sin, &[a]) => one(sin(a), cos(a)),
        (Function::Cos, &[a]) => one(cos(a), sin(a).neg()),
        (Function::Asin, &[a]) => one(by_ends(a, f64::asin)?, arc_slope(a)),
        (Function::Acos, &[a]) => one(by_ends(a.neg(), |x| (-x).acos())?, arc_slope(a).neg()),
        (Function::Atan, &[a]) => one(by_ends(a, f64::atan)?, unit.add(a.square()).reciprocal()),
        (Function::Abs, &[a]) => one(a.abs(), sign_slope(a)),
        (Function::Sign, &[a]) if a.is_zero() => one(OutwardInterval::ZERO, OutwardInterval::ZERO),
        (Function::Sign, &[a]) if !a.has_zero() => {
            one(OutwardInterval::point(a.low.signum()), OutwardInterval::ZERO)
        }
        (Function::Hypot, &[a, b]) => {
            let length = a.square().add(b.square()).root();
            // A direction's components are at most one.
            let share =
                |part: OutwardInterval| part.div(length).meet(OutwardInterval::between(-1.0, 1.0));
            Some((length, [share(a), share(b)]))
        }
        (Function::Atan2, &[y, x]) => atan2(y, x),
        (Function::Min, &[a, b]) => {
            let least = OutwardInterval::between(a.low.min(b.low), a.high.min(b.high));
            Some((least, chosen(a.high < b.low, b.high < a.low)))
        }
        (Function::Max, &[a, b]) => {
            let most = OutwardInterval::between(a.low.max(b.low), a.high.max(b.high));
            Some((most, chosen(a.low > b.high, b.low > a.high)))
        }
        _ => None,
    }
}

/// The slopes of what is the first or the second.
fn chosen(is_first: bool, is_second: bool) -> [OutwardInterval; 2] {
    let [no, yes] = [OutwardInterval::ZERO, OutwardInterval::point(1.0)];
    match (is_first, is_second) {
        (true, _) => [yes, no],
        (_, true) => [no, yes],
        _ => [OutwardInterval::between(0.0, 1.0); 2],
    }
}

fn sign_slope(a: OutwardInterval) -> OutwardInterval {
    let [low, high] = [a.low > 0.0, a.high < 0.0];
    OutwardInterval::between(if low { 1.0 } else { -1.0 }, if high { -1.0 } else { 1.0 })
}

fn arc_slope(a: OutwardInterval) -> OutwardInterval {
    OutwardInterval::point(1.0).sub(a.square()).root().reciprocal()
}

/// A rising function between its values at the ends; none beyond its domain.
fn by_ends(a: OutwardInterval, function: impl Fn(f64) -> f64) -> Option<OutwardInterval> {
    let between = OutwardInterval::between(function(a.low), function(a.high));
    (!between.low.is_nan() && !between.high.is_nan()).then(|| between.widened(LIBRARY))
}

pub(crate) fn sin(a: OutwardInterval) -> OutwardInterval {
    wave(a, f64::sin, 0.5)
}

pub(crate) fn cos(a: OutwardInterval) -> OutwardInterval {
    wave(a, f64::cos, 0.0)
}

/// A sine or a cosine, whose first maximum stands so many half turns after zero.
fn wave(a: OutwardInterval, function: impl Fn(f64) -> f64, first: f64) -> OutwardInterval {
    let whole = OutwardInterval::between(-1.0, 1.0);
    if a.magnitude() > FAR {
        return whole;
    }
    let (from, to) = (function(a.low), function(a.high));
    let ends = OutwardInterval::between(from.min(to), from.max(to)).widened(LIBRARY);
    // Half turns from a maximum: even ones are maxima, odd ones minima.
    let (k, last) = ((a.low / PI - first - PHASE).ceil(), (a.high / PI - first + PHASE).floor());
    let is_even = (k / 2.0).floor() * 2.0 == k;
    let [has_top, has_bottom] = [is_even, !is_even].map(|first| match first {
        true => k <= last,
        false => k < last,
    });
    OutwardInterval {
        low: if has_bottom { -1.0 } else { ends.low.max(-1.0) },
        high: if has_top { 1.0 } else { ends.high.min(1.0) },
    }
}

/// The angle of vectors that neither are zero nor pass half a turn.
fn atan2(
    y: OutwardInterval,
    x: OutwardInterval,
) -> Option<(OutwardInterval, [OutwardInterval; 2])> {
    let passes = x.low <= 0.0 && y.has_zero();
    if passes || !x.is_finite() || !y.is_finite() {
        return None;
    }
    // Between two directions of a box that the origin is outside of lie all others.
    let angles = [(y.low, x.low), (y.low, x.high), (y.high, x.low), (y.high, x.high)]
        .map(|(y, x): (f64, f64)| y.atan2(x));
    let low = angles.into_iter().fold(f64::INFINITY, f64::min);
    let high = angles.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let square = x.square().add(y.square());
    let slopes = [x.div(square), y.neg().div(square)];
    Some((OutwardInterval::between(low, high).widened(LIBRARY), slopes))
}

/// The angles from 0 to π of these sines, which are not negative, and cosines.
pub(crate) fn angle(sine: OutwardInterval, cosine: OutwardInterval) -> OutwardInterval {
    let half_turn = OutwardInterval::between(0.0, above(PI));
    atan2(sine, cosine).map_or(half_turn, |(angle, _)| angle.meet(half_turn))
}

/// The slopes of a function by its arguments over a box, with their own slopes where these are simple.
pub(super) fn slopes(
    frame: &InputBox,
    function: Function,
    arguments: &[&SlopedValue],
) -> [SlopedValue; 2] {
    let one = |value: SlopedValue| [frame.met(&value), SlopedValue::ZERO];
    let unit = SlopedValue::constant(OutwardInterval::point(1.0));
    match (function, arguments) {
        (Function::Sin, [a]) => one(frame.chain(a, cos, sin(a.range()).neg())),
        (Function::Cos, [a]) => one(frame.neg(&frame.chain(a, sin, cos(a.range())))),
        (Function::Sqrt, [a]) => {
            let root = root(frame, a);
            one(frame.div(&unit, &frame.add(&root, &root)))
        }
        (Function::Hypot, [a, b]) => {
            let length = root(frame, &frame.add(&frame.square(a), &frame.square(b)));
            [a, b].map(|part| frame.met(&frame.div(part, &length)))
        }
        _ => plain_slopes(frame, function, arguments),
    }
}

pub(crate) fn root(frame: &InputBox, value: &SlopedValue) -> SlopedValue {
    let root = value.range().root();
    frame.met(&frame.chain(value, OutwardInterval::root, root.add(root).reciprocal()))
}

/// Slopes of which nothing is known but their values.
fn plain_slopes(
    frame: &InputBox,
    function: Function,
    arguments: &[&SlopedValue],
) -> [SlopedValue; 2] {
    [0, 1].map(|which| {
        let column = |at: usize| {
            let arguments: Vec<_> = arguments.iter().map(|value| value.columns[at]).collect();
            of(function, &arguments).map_or(OutwardInterval::ALL, |(_, by)| by[which])
        };
        frame.map(column, |_| OutwardInterval::ALL)
    })
}
