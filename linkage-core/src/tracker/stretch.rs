//! The course of a group's clearance on a stretch of the way, from its values at the ends and the ranges
//! of it and its rates between them: a proof, or the admission that there is none.

use super::Thresholds;
use super::line::{Ranges, Reading};

/// The conclusion.
#[derive(Clone, Copy, Debug)]
pub(super) enum Finding {
    /// It stays above zero, or falls or rises all the time: no change point.
    Quiet,
    /// It touches zero once.
    Touching(Lowest),
    /// It is below zero at this part of the way: the motion has ended before.
    Ended(f64),
    /// Too little.
    Divide,
    /// Too little, and there is nothing to divide.
    Lost,
}

/// Where a clearance is lowest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lowest {
    pub(super) at: f64,
    /// Its value and rates there.
    pub(super) reading: Reading,
}

/// Judges the stretch between two places by the readings there, and by the ranges of all numbers
/// on it.
///
/// A place at which a clearance is lowest belongs to the stretch in which it rises from there: two
/// neighbouring stretches agree on it, since they share the reading.
pub(super) fn judge(
    [a, b]: [(f64, Reading); 2],
    ranges: &Ranges,
    thresholds: Thresholds,
    read: impl Fn(f64) -> Reading,
) -> Finding {
    let Thresholds { zero, clear, .. } = thresholds;
    if b.1.is_below(-zero) {
        return Finding::Ended(b.0);
    }
    let ((from, a), (to, b)) = (a, b);
    if ranges.is_above(clear) {
        return Finding::Quiet;
    }
    let [second_least, second_most] = ranges.second_rate;
    let length = to - from;
    let is_known = ranges.scale[0] > 0.0 && second_least.is_finite() && second_most.is_finite();
    if is_known {
        let bounds = [parabola_least(a, second_least, length), {
            let mirrored = Reading { rate: -b.rate, ..b };
            parabola_least(mirrored, second_least, length)
        }];
        let least = ranges.value[0].max(bounds[0]).max(bounds[1]);
        if least >= clear * ranges.scale[1] {
            return Finding::Quiet;
        }
        let (up, down) = ((second_most * length).max(0.0), (second_least * length).min(0.0));
        let falls = ranges.rate[1].min(a.rate + up).min(b.rate - down);
        let rises = ranges.rate[0].max(a.rate + down).max(b.rate - up);
        if falls < 0.0 || rises > 0.0 || second_most < 0.0 {
            return Finding::Quiet;
        }
        if second_least > 0.0 {
            if !(a.rate < 0.0 && b.rate >= 0.0) {
                return Finding::Quiet;
            }
            return match lowest([(from, a), (to, b)], thresholds, read) {
                Some(lowest) if lowest.reading.is_below(-zero) => Finding::Ended(lowest.at),
                Some(lowest) if lowest.reading.is_above(zero) => Finding::Quiet,
                Some(lowest) => Finding::Touching(lowest),
                None => Finding::Lost,
            };
        }
    }
    Finding::divided(length)
}

impl Finding {
    /// Parts of the way are numbers: below their last places there is nothing to divide.
    pub(super) fn divided(length: f64) -> Self {
        if length <= f64::EPSILON { Self::Lost } else { Self::Divide }
    }
}

/// The least value of the parabola through a reading with this second rate, up to `length` from
/// there: no function with a second rate of at least that lies lower.
fn parabola_least(from: Reading, second_rate: f64, length: f64) -> f64 {
    let at = |x: f64| from.value + x * (from.rate + 0.5 * second_rate * x);
    let vertex = -from.rate / second_rate;
    let ends = from.value.min(at(length));
    if second_rate > 0.0 && vertex > 0.0 && vertex < length { ends.min(at(vertex)) } else { ends }
}

/// The lowest place of a clearance whose second rate is above zero, between one where it falls and
/// one where it rises: the zero of its rate by Newton's method, with halvings where that leaves the
/// bracket. None where numbers end first.
///
/// It ends where a parabola's lowest point is no lower than `zero`: there the parabola is off by
/// the third power of a distance whose square is `zero`.
fn lowest(
    [mut a, mut b]: [(f64, Reading); 2],
    thresholds: Thresholds,
    read: impl Fn(f64) -> Reading,
) -> Option<Lowest> {
    let mut at = 0.5 * (a.0 + b.0);
    // Halvings alone come to the last place of a part of the way.
    for _ in 0..f64::MANTISSA_DIGITS {
        let here = read(at);
        let off = here.rate / here.second_rate;
        let above = 0.5 * here.rate * off;
        if above.abs() <= thresholds.zero * here.scale {
            let reading = Reading { value: here.value - above, rate: 0.0, ..here };
            return Some(Lowest { at: at - off, reading });
        }
        if here.rate < 0.0 {
            a = (at, here);
        } else {
            b = (at, here);
        }
        let newton = at - off;
        at = if a.0 < newton && newton < b.0 { newton } else { 0.5 * (a.0 + b.0) };
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Thresholds = Thresholds { zero: 1e-8, clear: 4e-8 };

    fn judged(from: f64, to: f64, f: impl Fn(f64) -> [f64; 3]) -> Finding {
        judged_at(1.0, from, to, f)
    }

    /// A clearance of this scale with its rates, and their ranges by sampling: good enough for
    /// polynomials.
    fn judged_at(scale: f64, from: f64, to: f64, f: impl Fn(f64) -> [f64; 3]) -> Finding {
        let f = |x: f64| f(x).map(|number| scale * number);
        let read = |x: f64| {
            let [value, rate, second_rate] = f(x);
            Reading { value, rate, second_rate, scale }
        };
        let range = |index: usize| {
            let samples = (0..=1000).map(|i| f(from + (to - from) * f64::from(i) / 1e3)[index]);
            let add =
                |[a, b]: [f64; 2], x: f64| [if x >= a { a } else { x }, if x <= b { b } else { x }];
            samples.fold([f64::MAX, f64::MIN], add)
        };
        let ranges =
            Ranges { value: range(0), rate: range(1), second_rate: range(2), scale: [scale; 2] };
        judge([(from, read(from)), (to, read(to))], &ranges, LIMITS, read)
    }

    fn parabola(low: f64) -> impl Fn(f64) -> [f64; 3] {
        move |x| [(x - 0.3) * (x - 0.3) + low, 2.0 * (x - 0.3), 2.0]
    }

    #[test]
    fn a_parabola_touches_misses_or_ends() {
        for low in [0.0, 0.9e-8, -0.9e-8] {
            let Finding::Touching(lowest) = judged(0.0, 1.0, parabola(low)) else {
                panic!("{low}: {:?}", judged(0.0, 1.0, parabola(low)));
            };
            assert!((lowest.at - 0.3).abs() < 1e-12 && (lowest.reading.value - low).abs() < 1e-15);
        }
        assert!(matches!(judged(0.0, 1.0, parabola(1.1e-8)), Finding::Quiet));
        assert!(matches!(judged(0.0, 1.0, parabola(-1.1e-8)), Finding::Ended(_)));
        assert!(matches!(judged(0.0, 0.3 - 1e-6, parabola(0.0)), Finding::Quiet));
        assert!(matches!(judged(0.3 + 1e-6, 1.0, parabola(0.0)), Finding::Quiet));
    }

    /// Squares of lengths are 1e18 times as large where lengths are 1e9 times.
    #[test]
    fn a_parabola_is_judged_alike_at_every_size() {
        for scale in [1e-36, 1e-18, 1e18, 1e36] {
            for low in [0.0, 0.9e-8, -0.9e-8] {
                let found = judged_at(scale, 0.0, 1.0, parabola(low));
                assert!(matches!(found, Finding::Touching(_)), "{low} of {scale:e}: {found:?}");
            }
            let missed = judged_at(scale, 0.0, 1.0, parabola(1.1e-8));
            assert!(matches!(missed, Finding::Quiet), "{scale:e}: {missed:?}");
            let ended = judged_at(scale, 0.0, 1.0, parabola(-1.1e-8));
            assert!(matches!(ended, Finding::Ended(_)), "{scale:e}: {ended:?}");
        }
    }

    /// A clearance that falls through zero ends the motion where it is found below zero by more than
    /// rounding, however little that is.
    #[test]
    fn what_falls_through_zero_has_ended() {
        let falling = |x: f64| [1e-9 - 3e-8 * x, -3e-8, 0.0];
        assert!(matches!(judged(0.0, 1.0, falling), Finding::Ended(at) if at == 1.0));
        assert!(matches!(judged(0.0, 0.3, falling), Finding::Quiet));
    }

    /// The lowest place at the common end of two stretches belongs to one of them.
    #[test]
    fn the_lowest_place_belongs_to_one_stretch() {
        assert!(matches!(judged(0.0, 0.3, parabola(0.0)), Finding::Touching(_)));
        assert!(matches!(judged(0.3, 1.0, parabola(0.0)), Finding::Quiet));
    }

    #[test]
    fn what_bends_both_ways_is_divided_until_nothing_is_left() {
        let wave =
            |x: f64| [(9.0 * x).cos() + 0.999_999, -9.0 * (9.0 * x).sin(), -81.0 * (9.0 * x).cos()];
        assert!(matches!(judged(0.0, 1.0, wave), Finding::Divide));
        let flat = |_: f64| [1e-9, 0.0, 0.0];
        assert!(matches!(judged(0.0, 1.0, flat), Finding::Divide));
        assert!(matches!(judged(0.0, 1e-16, flat), Finding::Lost));
        let unknown = |_: f64| [f64::NAN, f64::NAN, f64::NAN];
        assert!(matches!(judged(0.0, 1.0, unknown), Finding::Divide));
        let high = |_: f64| [1.0, 0.0, 0.0];
        assert!(matches!(judged(0.0, 1.0, high), Finding::Quiet));
    }
}
