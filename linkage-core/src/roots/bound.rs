//! Where the roots of an equation's trend end: what following a motion looks at.

use super::approach::{Approach, At, constant, number};
use super::{FindError, Trend, crossing};
use crate::Real;

/// The end, 0 or 1, of the stretch on which left − right has the trend: that of the interval, or the
/// dead point next to it where it lies beyond one. And one at a dead point, zero elsewhere.
///
/// There is a root of the trend between both ends' stretches if the difference has a sign at one and
/// the other at the other; it is what [`root`](super::unknown::root) goes by. Values at a dead point are
/// smooth as the inputs go on to where there is no root, as those at an end of the interval are.
///
/// `f` gives left − right, its slope and its curvature. Not a number where these are none.
pub fn bound<T: Real>(
    between: [T; 2],
    trend: Trend,
    end: usize,
    f: impl FnMut(T) -> [T; 3],
) -> (T, T) {
    let unknown = number(f64::NAN);
    stretch_end(between, trend, end, f).unwrap_or((unknown, unknown))
}

fn stretch_end<T: Real>(
    between: [T; 2],
    trend: Trend,
    end: usize,
    mut f: impl FnMut(T) -> [T; 3],
) -> Result<(T, T), FindError> {
    let [from, to] = between;
    let (zero, one) = (number::<T>(0.0), number::<T>(1.0));
    let sign = trend.sign::<T>();
    let mut slope = |x| {
        let [_, slope, curvature] = f(x);
        [sign * slope, sign * curvature]
    };
    let Some(approach) = Approach::new(between) else {
        return Err(FindError::Interval { from: from.value(), to: to.value() });
    };
    let (here, there) = if end == 0 { (from, to) } else { (to, from) };
    let at_end = slope(here);
    let [least, most] = at_end[0].bounds();
    if least.is_nan() || most.is_nan() {
        return Err(FindError::NotFinite { at: here.value() });
    }
    if least >= 0.0 {
        return Ok((here, zero));
    }
    if most >= 0.0 {
        // Only ranges come here: the root is the end for some inputs, and for others a dead point next to it
        // if the slope's own rate at the end allows one.
        let [lowest, highest] = at_end[1].bounds();
        let is_next_to_it = if end == 0 { lowest > 0.0 } else { highest < 0.0 };
        if !is_next_to_it {
            return Err(FindError::Singular { at: here.value() });
        }
        return Ok((here.joined(here.with_all_roots(&mut slope)), zero.joined(one)));
    }
    let at =
        |x: T, [value, slope]: [T; 2]| At { x, value: constant(value), slope: constant(slope) };
    let other = at(constant(there), slope(constant(there)));
    let inner = if other.value.gt(zero) {
        other
    } else {
        let middle = approach.from + (approach.to - approach.from) * number(0.5);
        at(middle, slope(middle))
    };
    if !inner.value.gt(zero) {
        return Ok((here, zero));
    }
    let outer = at(constant(here), at_end);
    let ends = if end == 0 { [outer, inner] } else { [inner, outer] };
    Ok((crossing(ends, &mut slope)?, one))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scalar;

    const HALF: f64 = core::f64::consts::FRAC_PI_2;

    fn cosine(shift: f64) -> impl Fn(f64) -> [f64; 3] {
        move |x| {
            let (sin, cos) = (x - shift).sin_cos();
            [cos, -sin, -cos]
        }
    }

    #[test]
    fn an_end_beyond_a_dead_point_comes_back_to_it() {
        for shift in [-0.3, 0.0, 1e-9, 0.7] {
            let found = [0, 1].map(|end| bound([-HALF, HALF], Trend::Rising, end, cosine(shift)));
            assert_eq!(found[0], (-HALF, 0.0));
            assert!((found[1].0 - shift).abs() < 1e-15 && found[1].1 == 1.0, "{found:?}");
            let found = [0, 1].map(|end| bound([-HALF, HALF], Trend::Falling, end, cosine(shift)));
            assert!((found[0].0 - shift).abs() < 1e-15 && found[0].1 == 1.0, "{found:?}");
            assert_eq!(found[1], (HALF, 0.0));
        }
        // Where no dead point shows, the end is as good as any.
        let line = |x: f64| [x, -1.0, 0.0];
        assert_eq!(bound([0.0, 1.0], Trend::Rising, 0, line), (0.0, 0.0));
        let nowhere = bound([0.0, f64::NAN], Trend::Rising, 0, line);
        assert!(nowhere.0.is_nan() && nowhere.1.is_nan());
        let hole = |x: f64| [x, if x > 0.5 { f64::NAN } else { 1.0 }, 0.0];
        assert!(bound([0.0, 1.0], Trend::Rising, 1, hole).0.is_nan());
    }

    /// A dead point that is the end is not beyond it.
    #[test]
    fn an_end_without_slope_stays() {
        let still = |x: f64| [x, 0.0, 0.0];
        for (end, at) in [(0, 0.0), (1, 1.0)] {
            assert_eq!(bound([0.0, 1.0], Trend::Rising, end, still), (at, 0.0));
        }
    }

    /// A wave whose dead point is on either side of an end, as inputs are: for some of them the end is
    /// what is found, for the others the dead point.
    #[test]
    fn ranges_hold_the_end_and_the_dead_point_next_to_it() {
        type Ranges = <f64 as Real>::Enclosing;
        let shift = 0.0.enclosing(0.1);
        let cosine = |x: Ranges| {
            let (sin, cos) = (x - shift).sin_cos();
            [cos, -sin, -cos]
        };
        let holds = |range: Ranges, [least, most]: [f64; 2], widest: f64| {
            let [low, high] = range.bounds();
            assert!(low <= least && most <= high && high - low <= widest, "{range:?}");
        };
        for (between, trend, end, dead) in [
            ([0.0, HALF], Trend::Falling, 0, [0.0, 0.1]),
            ([-HALF, 0.0], Trend::Rising, 1, [-0.1, 0.0]),
        ] {
            let between = between.map(Ranges::num);
            let (at, is_dead_point) = bound(between, trend, end, cosine);
            // All dead points, and half as much again for the curvature.
            holds(at, dead, 0.3);
            holds(is_dead_point, [0.0, 1.0], 3.0);
            // Where the slope goes the other way from the end there is nothing to come back to.
            let (at, is_dead_point) = bound(between, trend.flipped(), end, cosine);
            assert!([at, is_dead_point].iter().all(|range| range.bounds()[0].is_nan()));
        }
    }

    /// A curvature of one sign has the dead point next to the end, and one of either sign says nothing.
    #[test]
    fn a_curvature_of_either_sign_says_nothing() {
        type Ranges = <f64 as Real>::Enclosing;
        let range = |least: f64, most: f64| -> Ranges {
            (0.5 * (least + most)).enclosing(0.5 * (most - least))
        };
        let found = |end: usize, [least, most]: [f64; 2]| {
            let f = |_| [range(-1.0, 1.0), range(-0.01, 0.01), range(least, most)];
            let (at, is_dead) = bound([0.0, 1.0].map(Ranges::num), Trend::Rising, end, f);
            [at, is_dead].map(|range| range.bounds()[0])
        };
        for (end, curvature) in [(0, [0.5, 2.0]), (1, [-2.0, -0.5])] {
            assert!(found(end, curvature).iter().all(|least| least.is_finite()), "{end}");
        }
        for (end, curvature) in
            [(0, [-0.5, 2.0]), (1, [-2.0, 0.5]), (0, [-2.0, -0.5]), (1, [0.5, 2.0])]
        {
            assert!(
                found(end, curvature).iter().all(|least| least.is_nan()),
                "{end} {curvature:?}"
            );
        }
    }
}
