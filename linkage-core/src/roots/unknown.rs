//! The root of the equation of a declaration's `solve`, from its two sides.

use core::cell::Cell;

use super::approach::{Approach, constant, greater, magnitude, number};
use super::equation::Equation;
use super::{FindError, Search, Trend};
use crate::Real;
use crate::limit::ROUNDINGS;

/// A target within 4 ulp of an end counts as that end; the ulp is that of the larger sides.
const SLACK: f64 = 4.0;

/// The root of left − right, and the size by which their rounding is measured: the largest sides
/// that were met, and what they would change by over the whole interval at the last slope.
///
/// `sides` gives left, right and the slope of their difference. Numbers that carry derivatives take both
/// from `plain`, the same search on numbers that carry none: their own arithmetic rounds otherwise, and
/// might end at another root, or meet a pose that cannot be assembled where the search of the values
/// meets none. The root then gets its derivatives, provided that the slope is the wanted way by more
/// than rounding: what `diagnosis::moving` asks.
///
/// # Errors
/// See [`FindError`].
pub fn root<T: Real>(
    between: [T; 2],
    trend: Trend,
    near: Option<T>,
    plain: impl FnOnce() -> Result<[T::Plain; 2], FindError>,
    sides: impl FnMut(T) -> [T; 3],
) -> Result<[T; 2], FindError> {
    root_of(between, trend, (near, false), plain, sides)
}

/// [`root`], from a seed if there is one, of an equation whose slope may be proved to have one sign between the ends.
pub(super) fn root_of<T: Real>(
    between: [T; 2],
    trend: Trend,
    (near, is_steady): (Option<T>, bool),
    plain: impl FnOnce() -> Result<[T::Plain; 2], FindError>,
    mut sides: impl FnMut(T) -> [T; 3],
) -> Result<[T; 2], FindError> {
    if T::ORDER == 0 {
        return searched(between, trend, (near, is_steady), sides);
    }
    let [at, size] = plain()?.map(|found| number::<T>(found.value()));
    let last = Cell::new(number::<T>(0.0));
    let mut difference = |x| {
        let [left, right, slope] = sides(x);
        last.set(trend.sign::<T>() * slope);
        [left - right, slope]
    };
    let found = Equation::new(&mut difference, trend).differentiated(at)?.at;
    let change = last.get().value() * (between[1].value() - between[0].value());
    let is_slope = change > ROUNDINGS * T::EPSILON * size.value();
    if found.is_constant() || is_slope {
        Ok([found, size])
    } else {
        Err(FindError::Singular { at: at.value() })
    }
}

/// [`root`] of an angle whose ends are known at run time: beyond a turn every pose comes once more.
///
/// # Errors
/// Those of [`root`]; `Interval` where the ends are more than a turn apart.
pub fn root_within_a_turn<T: Real>(
    between: [T; 2],
    trend: Trend,
    near: Option<T>,
    plain: impl FnOnce() -> Result<[T::Plain; 2], FindError>,
    sides: impl FnMut(T) -> [T; 3],
) -> Result<[T; 2], FindError> {
    let [from, to] = between.map(Real::value);
    // Each end is rounded, and so are the turn and the difference.
    let turn = core::f64::consts::TAU;
    let rounding = T::EPSILON * (magnitude(from) + magnitude(to) + turn);
    if to - from > turn + rounding {
        return Err(FindError::Interval { from, to });
    }
    root(between, trend, near, plain, sides)
}

/// [`root`] by a search, which is [`Search::find`]'s but for two things. A target that an end misses by
/// no more than four units in the last place of what was met gives that end. And a seed that is the root
/// at once, on sides near zero, tells nothing of their size: then the lower end is looked at as well, an
/// evaluation more.
fn searched<T: Real>(
    between: [T; 2],
    trend: Trend,
    (near, is_steady): (Option<T>, bool),
    mut sides: impl FnMut(T) -> [T; 3],
) -> Result<[T; 2], FindError> {
    let Some(approach) = Approach::new(between) else {
        let [from, to] = between.map(Real::value);
        return Err(FindError::Interval { from, to });
    };
    let width = approach.to - approach.from;
    let (extent, change) = (Cell::new(number::<T>(0.0)), Cell::new(number::<T>(0.0)));
    let mut difference = |x| {
        let [left, right, slope] = sides(x);
        let size = magnitude(constant(left)) + magnitude(constant(right));
        // Ignore NaN and infinity.
        extent.set(if size.is_finite() { greater(extent.get(), size) } else { extent.get() });
        change.set(magnitude(constant(slope)) * width);
        [left - right, slope]
    };
    let mut f = Equation::new(&mut difference, trend);
    let at = match near.and_then(|seed| f.newton(seed, approach, width, None)) {
        Some(at) => {
            let last = change.get();
            if last.gt(extent.get()) {
                f.at(approach.from)?;
            }
            change.set(last);
            at
        }
        None => Search::new(between, trend).bracketed(&mut f, approach, is_steady, &|[a, b]| {
            let met = greater(greater(magnitude(a), magnitude(b)), extent.get());
            met * number(SLACK * T::EPSILON)
        })?,
    };
    let found = f.differentiated(at)?.at;
    Ok([found, extent.get() + change.get()])
}

/// The root that [`root`] has found and its size, or NaN where it has found none.
pub fn open<T: Real>(found: Result<[T; 2], FindError>) -> (T, T) {
    let [at, size] = found.unwrap_or([number(f64::NAN); 2]);
    (at, size)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF_TURN: [f64; 2] = [0.0, core::f64::consts::PI];

    /// The ram of a crank of one and a rod of three, whose dead points are the ends of half a turn.
    fn ram(theta: f64, target: f64) -> [f64; 3] {
        let (sin, cos) = theta.sin_cos();
        let rod = ((3.0 - sin) * (3.0 + sin)).sqrt();
        [cos + rod, target, -sin - sin * cos / rod]
    }

    fn of_ram(target: f64, near: Option<f64>) -> Result<[f64; 2], FindError> {
        searched(HALF_TURN, Trend::Falling, (near, false), |theta| ram(theta, target))
    }

    #[test]
    fn a_target_by_last_places_beyond_an_end_gives_that_end() {
        for (target, end) in [(4.0, HALF_TURN[0]), (2.0, HALF_TURN[1])] {
            let beyond = |ulps: f64| target + ulps * target * f64::EPSILON * (target - 3.0);
            for ulps in [0.0, 1.0, 3.0] {
                assert_eq!(
                    of_ram(beyond(ulps), None).map(|[at, _]| at),
                    Ok(end),
                    "{target} {ulps}"
                );
            }
            let refused = of_ram(beyond(40.0), None);
            assert!(matches!(refused, Err(FindError::NoSolution { .. })), "{refused:?}");
        }
    }

    #[test]
    fn the_size_is_that_of_the_sides_with_and_without_a_seed() {
        for target in [2.5, 3.0, 3.9] {
            let [cold, size] = of_ram(target, None).expect("within the stroke");
            let [warm, other] = of_ram(target, Some(cold)).expect("the seed is the root");
            assert!((cold - warm).abs() <= 8.0 * f64::EPSILON);
            for size in [size, other] {
                assert!((target..20.0).contains(&size), "{target}: {size}");
            }
        }
        // Sides that are zero where the seed is: the lower end tells their size.
        let line = |x: f64| [x - 1.0, 0.0, 1.0];
        let [at, size] =
            searched([0.0, 3.0], Trend::Rising, (Some(1.0), false), line).expect("it is the root");
        assert!(at == 1.0 && size == 4.0, "{at} {size}");
    }

    /// Sides whose sum of sizes overflows where their difference does not.
    #[test]
    fn sides_too_large_to_add_do_not_count() {
        let sides = |x: f64| [1.2e308 * x, 0.6e308, 1e300];
        let [at, size] = searched([0.0, 1.0], Trend::Rising, (None, false), sides).expect("a root");
        assert!((at - 0.5).abs() < 1e-15 && size.is_finite() && size >= 1.2e308, "{at} {size}");
    }

    /// A trial falls next to the toggle of a rod that is shorter than its crank, where the slope is
    /// 1900: a short step there leads to no root.
    #[test]
    fn a_vertical_slope_is_no_root() {
        let (crank, rod, target) = (2.100_037_8_f32, 1.993_971_2, 1.032_491_7);
        let sides = |theta: f32| {
            let (sin, cos) = theta.sin_cos();
            let across = crank * sin;
            let along = ((rod - across) * (rod + across)).sqrt();
            [crank * cos + along, target, -across - across * crank * cos / along]
        };
        let [theta, _] =
            searched([0.0, core::f32::consts::PI], Trend::Falling, (None, false), sides)
                .expect("a root");
        // In f64 it is 1.2175330182.
        assert!((theta - 1.217_533).abs() < 1e-6, "{theta}");
    }

    #[test]
    fn what_is_no_number_is_where_it_was_met() {
        let sides = |x| [if x > 1.0 { f64::NAN } else { x }, 0.5, -1.0];
        let found = searched(HALF_TURN, Trend::Falling, (None, false), sides);
        assert_eq!(found, Err(FindError::NotFinite { at: HALF_TURN[1] }));
        let reversed = searched([1.0, 0.0], Trend::Falling, (None, false), sides);
        assert_eq!(reversed, Err(FindError::Interval { from: 1.0, to: 0.0 }));
    }

    #[cfg(feature = "ad")]
    #[test]
    fn a_root_is_derived_where_the_slope_is_one_and_goes_the_wanted_way() {
        use num_dual::Dual64;
        // slope · (x − 1/2) = t, with dt = 1, at t = 0.
        let derived = |trend, slope: f64| {
            let sides = |x| {
                let slope = Dual64::from_re(slope);
                [slope * (x - Dual64::from_re(0.5)), Dual64::new(0.0, 1.0), slope]
            };
            let between = [0.0, 1.0].map(Dual64::from_re);
            let found = root(between, trend, None, || Ok([0.5, 1.0]), sides);
            found.map(|[at, size]| (at.re, at.eps, size.re))
        };
        assert_eq!(derived(Trend::Rising, 2.0), Ok((0.5, 0.5, 1.0)));
        assert_eq!(derived(Trend::Falling, -4.0), Ok((0.5, -0.25, 1.0)));
        let none = Err(FindError::Singular { at: 0.5 });
        assert_eq!(derived(Trend::Falling, 2.0), none);
        // For a size of one, over an interval of one, a slope this small is rounding.
        assert_eq!(derived(Trend::Rising, ROUNDINGS * f64::EPSILON), none);
        assert!(derived(Trend::Rising, 1.01 * ROUNDINGS * f64::EPSILON).is_ok());
        // A root that depends on no differentiated number needs no slope: it may be a dead point.
        let touching = |x: Dual64| {
            let away = x - Dual64::from_re(0.5);
            [away * away, Dual64::from_re(0.0), away + away]
        };
        let between = [0.0, 1.0].map(Dual64::from_re);
        let found = root(between, Trend::Rising, None, || Ok([0.5, 1.0]), touching);
        assert_eq!(found.map(|[at, _]| (at.re, at.eps)), Ok((0.5, 0.0)));
    }

    /// Ends that are a turn apart but for their rounding are a turn apart, and no more than that.
    #[test]
    fn ends_a_turn_apart_are_a_turn_apart_wherever_they_are() {
        let turn = core::f64::consts::TAU;
        let sides = |x: f64| [(x - 0.3).sin(), 0.25, (x - 0.3).cos()];
        let found = |between| {
            root_within_a_turn(between, Trend::Rising, None, || unreachable!("numbers"), sides)
        };
        let mut wider = 0;
        for step in 0..2000 {
            // Beyond 128 a turn is rounded up.
            let from = -300.0 + 0.3 * f64::from(step);
            let to = from + turn;
            wider += u32::from(to - from > turn);
            assert!(!matches!(found([from, to]), Err(FindError::Interval { .. })), "{from}");
            // 1e-13 of the ends is two hundred units in their last place.
            let beyond = to + 1e-13 * (from.abs() + to.abs() + turn);
            assert_eq!(found([from, beyond]), Err(FindError::Interval { from, to: beyond }));
        }
        assert!(wider > 200, "{wider}");
    }
}
