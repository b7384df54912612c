//! Where an output turns back.

use core::fmt;
use core::ops::Deref;

use super::panels::Panels;
use super::walk::{Event, Walk};
use super::{MOST, RangeError};
use crate::roots::{Approach, FindError, constant, greater, magnitude, number};
use crate::{Real, SolveError};

/// Which way an output turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Turn {
    /// From rising to falling.
    Maximum,
    /// From falling to rising.
    Minimum,
}

/// A place where an output turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Extremum<T = f64> {
    /// The input, with the derivatives that the output's numbers carry.
    pub at: T,
    /// The output there.
    pub value: T,
    /// Which way it turns.
    pub turn: Turn,
}

/// The places where an output turns back, in rising order of the input: a slice without a heap.
#[derive(Clone, Copy)]
pub struct Extrema<T = f64> {
    list: [Extremum<T>; MOST],
    count: usize,
    /// Input and output at the ends.
    ends: [[T; 2]; 2],
}

impl<T: Real> Extrema<T> {
    /// Input and output where the output is smallest, the ends included.
    #[must_use]
    pub fn least(&self) -> [T; 2] {
        self.all().fold(self.ends[0], |least, at| if least[1].gt(at[1]) { at } else { least })
    }

    /// Input and output where the output is greatest, the ends included.
    #[must_use]
    pub fn greatest(&self) -> [T; 2] {
        self.all().fold(self.ends[0], |most, at| if at[1].gt(most[1]) { at } else { most })
    }

    /// The range of the output: a ram's stroke, a rocker's swing.
    #[must_use]
    pub fn stroke(&self) -> T {
        self.greatest()[1] - self.least()[1]
    }

    fn all(&self) -> impl Iterator<Item = [T; 2]> {
        self.iter().map(|extremum| [extremum.at, extremum.value]).chain(self.ends)
    }
}

impl<T> Deref for Extrema<T> {
    type Target = [Extremum<T>];

    fn deref(&self) -> &[Extremum<T>] {
        self.list.get(..self.count).unwrap_or(&[])
    }
}

/// As the slice that it is.
impl<T: fmt::Debug> fmt::Debug for Extrema<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// As the slice that it is; the ends are left out.
#[cfg(feature = "serde")]
impl<T: serde::Serialize> serde::Serialize for Extrema<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// Where an output turns back between two inputs. The function gives the output with its first and
/// second derivative by the input.
///
/// ```
/// use linkage_core::mechanism;
/// use linkage_core::range::extrema;
///
/// mechanism! {
///     struct Press {
///         input theta: angle;
///         ground A(0, 0);
///         guide bed through (0, 30mm) along 0deg;
///         crank AB(A) -> B           { length: 80mm, angle: theta }
///         rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
///         output ram.slide;
///     }
/// }
///
/// use core::f64::consts::PI;
/// let press = Press::new();
/// let turns = extrema([-PI, PI], |theta| {
///     let at = press.motion(theta, 1.0, 0.0)?;
///     Ok([at.position.ram.slide, at.velocity.ram.slide, at.acceleration.ram.slide])
/// })?;
/// assert_eq!(turns.len(), 2);
/// let stroke = f64::sqrt(0.33 * 0.33 - 0.03 * 0.03) - f64::sqrt(0.17 * 0.17 - 0.03 * 0.03);
/// assert!((turns.stroke() - stroke).abs() < 1e-15);
/// # Ok::<(), linkage_core::range::RangeError>(())
/// ```
///
/// The output is to be smooth: the angle of a link that passes ±π is not, but
/// [`angle_near`](crate::Direction::angle_near) an angle within its swing is, and so is its angle
/// from another link. A velocity's extremes take its own derivatives, which
/// `differentiate_twice` gives.
///
/// A turn is inside the interval, and the output goes one way before it and the other way behind it. An end
/// is no turn, also where the rate is zero there, but [`Extrema::least`], [`Extrema::greatest`] and
/// [`Extrema::stroke`] count the ends. An output that rests, to the rounding of its value, and goes on the
/// same way does not turn; one that turns back after a rest does so somewhere in the rest.
/// An output and its negative turn at the same inputs, bit for bit.
///
/// # Errors
/// See [`RangeError`]; the first of the function's errors.
pub fn extrema<T: Real>(
    between: [T; 2],
    mut f: impl FnMut(T) -> Result<[T; 3], SolveError>,
) -> Result<Extrema<T>, RangeError> {
    let [from, to] = between;
    if Approach::new(between).is_none() {
        return Err(RangeError::Interval { from: from.value(), to: to.value() });
    }
    let ends = between.map(constant);
    let Size { zero, sign } = Size::of(ends, &mut f)?;
    let mut found = Extrema::between(ends, &mut f)?;
    let mut failure = None;
    let rate = |x| match f(x) {
        Ok([_, rate, second]) => [sign * rate, sign * second],
        Err(error) => {
            failure = failure.or(Some(error));
            [number(f64::NAN); 2]
        }
    };
    let (mut zeros, mut count) = ([ends[1]; ZEROS], 0_usize);
    let mut walk = Walk { f: rate, zero, ends };
    let panels = Panels::over((to - from).value());
    let walked = walk.events(panels, |event| {
        if let Event::Falls(at) | Event::Rises(at) = event {
            zeros.iter_mut().skip(count).take(1).for_each(|place| *place = at);
            count += 1;
        }
    });
    let zeros = zeros.get(..count).ok_or(RangeError::TooMany);
    let turned = match (walked, zeros) {
        (Ok(()), Ok(zeros)) => found.turns(&mut walk, zeros, sign),
        (Ok(()), Err(error)) => return Err(error),
        (Err(error), _) => Err(error),
    };
    match turned {
        Ok(turned) => turned?,
        Err(_) => return Err(failure.unwrap_or(NO_NUMBER).into()),
    }
    for extremum in found.list.iter_mut().take(found.count) {
        let [value, ..] = f(extremum.at)?;
        extremum.value = value;
    }
    Ok(found)
}

/// The most zeros of a rate: each turn has one, a rest that begins and ends has two.
const ZEROS: usize = 2 * MOST;

const NO_NUMBER: SolveError = SolveError::NotFinite { name: "the output" };

/// The size of a rate.
struct Size<T> {
    /// A rate that rounding alone cannot tell from zero.
    zero: T,
    /// The sign of the largest of some rates, 1 or −1: an output and its mirror image are walked by the
    /// same numbers once both are multiplied by it.
    sign: T,
}

impl<T: Real> Size<T> {
    fn of(
        [from, to]: [T; 2],
        f: &mut impl FnMut(T) -> Result<[T; 3], SolveError>,
    ) -> Result<Self, RangeError> {
        let (mut size, mut largest) = (number::<T>(0.0), number::<T>(0.0));
        for part in [0.0, 0.3, 0.6, 1.0] {
            let [value, rate, _] = f(from + (to - from) * number(part))?.map(constant);
            if magnitude(rate).gt(magnitude(largest)) {
                largest = rate;
            }
            size = greater(size, greater(magnitude(rate), magnitude(value) / (to - from)));
        }
        let sign = number(if number::<T>(0.0).gt(largest) { -1.0 } else { 1.0 });
        Ok(Self { zero: size * number(64.0 * <T as Real>::EPSILON), sign })
    }
}

impl<T: Real> Extrema<T> {
    fn between(
        ends: [T; 2],
        f: &mut impl FnMut(T) -> Result<[T; 3], SolveError>,
    ) -> Result<Self, RangeError> {
        let [from, to] = ends;
        let [[first, ..], [last, ..]] = [f(from)?, f(to)?];
        if !(first.is_finite() && last.is_finite()) {
            return Err(NO_NUMBER.into());
        }
        let none = Extremum { at: from, value: first, turn: Turn::Maximum };
        Ok(Self { list: [none; MOST], count: 0, ends: [[from, first], [to, last]] })
    }

    /// Adds the turns of an output whose rate is zero at these places, in order; the walk is over the rate
    /// times the sign.
    ///
    /// The rate between two of these places tells a rising output from a falling one. Next to a place where
    /// the rate only touches zero, its sign is rounding.
    fn turns(
        &mut self,
        walk: &mut Walk<impl FnMut(T) -> [T; 2], T>,
        zeros: &[T],
        sign: T,
    ) -> Result<Result<(), RangeError>, FindError> {
        let [from, to] = walk.ends;
        let is_mirrored = number::<T>(0.0).gt(sign);
        let (mut before, mut here, mut rest) = (None, from, None::<[T; 2]>);
        for &next in zeros.iter().chain([&to]) {
            if let Some(rises) = walk.way([here, next])? {
                if let (true, Some([first, last])) = (before == Some(!rises), rest) {
                    let at = first + (last - first) * number(0.5);
                    let turn = if rises != is_mirrored { Turn::Minimum } else { Turn::Maximum };
                    if let Err(error) = self.push(Extremum { at, value: at, turn }) {
                        return Ok(Err(error));
                    }
                }
                (before, rest) = (Some(rises), None);
            }
            rest = Some([rest.map_or(next, |[first, _]| first), next]);
            here = next;
        }
        Ok(Ok(()))
    }

    fn push(&mut self, extremum: Extremum<T>) -> Result<(), RangeError> {
        let place = self.list.get_mut(self.count).ok_or(RangeError::TooMany)?;
        *place = extremum;
        self.count += 1;
        Ok(())
    }
}
