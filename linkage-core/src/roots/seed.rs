//! The root of an equation, pose after pose: the numbers that a sweep's next search need not compute again,
//! and the place where it begins.
//!
//! An equation stands apart where one side is made of constants, parameters and the unknown alone, and the
//! other of what no trial changes. From pose to pose its difference moves up or down as a whole. So the
//! unknown's side and the slope at both ends of the interval are those of the pose before, to the last bit,
//! and a search that reads them instead of evaluating them gives the same root and the same refusal.
//!
//! Where it is proved, besides, that the equation has one root, Newton's steps come first, from where the last
//! two trials foresee the root. Their root is taken where a search from both ends is sure to find one: where the difference has the
//! signs of the trend at both ends. Both roots are right to the same tolerance; the last place may differ.

use core::cell::Cell;

use super::approach::{Approach, constant, greater, magnitude, number};
use super::equation::Equation;
use super::unknown::root_of;
use super::{FindError, Trend};
use crate::Real;
use crate::kernels::sqrt;

/// The longest first step from a seed, as a part of the interval. After a first step s, three of Newton's
/// steps leave (Cs)⁸/C, with C half the curvature over the slope, about 1 over the interval. For 1/64 that
/// is 2⁻⁴⁸ of the interval, the most that the foreseen last step may leave. A longer step is not worth two
/// more trials.
const LONGEST: f64 = 1.0 / 64.0;

/// The longest step, as a multiple of the last one, for which the trials before are a guide.
const FARTHEST: f64 = 2.0;

/// The facts that one pose leaves to the next about the search of one unknown.
#[derive(Clone, Copy, Debug)]
pub struct Seed<T> {
    /// The last trials of the last two searches, the older one first; not numbers before they are known.
    trials: [LastTrial<T>; 2],
    /// The unknown's side and the slope at both ends; not numbers before they are known.
    ends: [[T; 2]; 2],
}

/// A place, and the unknown's side and the slope there.
#[derive(Clone, Copy, Debug)]
struct LastTrial<T> {
    x: T,
    side: T,
    slope: T,
}

impl<T: Real> Seed<T> {
    /// The seed of the first pose.
    pub(crate) fn unknown() -> Self {
        let none = number(f64::NAN);
        Self { trials: [LastTrial { x: none, side: none, slope: none }; 2], ends: [[none; 2]; 2] }
    }

    /// Where the unknown's side is expected to be `given`: on the cubic in the side through places and slopes of
    /// both trials; on the line through the later one where the cubic is no guide or there is but one trial.
    fn foreseen(&self, given: T, turn: T) -> T {
        let [older, LastTrial { x, side, slope }] = self.trials;
        let run = side - older.side;
        let [before, after] = [older.slope, slope].map(|slope| turn * run / slope);
        let (rise, step) = (x - older.x, (given - side) / run);
        let bend = before + after + after - number::<T>(3.0) * rise;
        let twist = before + after - (rise + rise);
        if number::<T>(FARTHEST).ge(magnitude(step)) {
            x + step * (after + step * (bend + step * twist))
        } else {
            x + turn * (given - side) / slope
        }
    }
}

/// An equation one side of which no trial changes.
#[derive(Clone, Copy, Debug)]
pub struct Apart<T> {
    /// The value of that side.
    pub given: T,
    /// True if that side is the right one.
    pub is_right: bool,
    /// True if the slope is proved to have one sign over the whole interval except its ends: then there is one root at
    /// most, and none where both ends lie on one side of zero.
    pub has_one_root: bool,
}

impl<T: Real> Apart<T> {
    /// Left, right and the slope, from the unknown's side and the slope.
    fn sides(&self, [side, slope]: [T; 2]) -> [T; 3] {
        if self.is_right { [side, self.given, slope] } else { [self.given, side, slope] }
    }

    /// The unknown's side and the slope.
    fn parts(&self, [left, right, slope]: [T; 3]) -> [T; 2] {
        [if self.is_right { left } else { right }, slope]
    }
}

/// [`root`](super::unknown::root) of an equation that stands apart, by the seed that the pose before has left. Parameters are
/// those of the pose before; between them only inputs change.
///
/// # Errors
/// Those of [`root`](super::unknown::root).
pub fn root_by_seed<T: Real>(
    between: [T; 2],
    trend: Trend,
    seed: Option<&mut Seed<T>>,
    apart: Apart<T>,
    plain: impl FnOnce() -> Result<[T::Plain; 2], FindError>,
    mut sides: impl FnMut(T) -> [T; 3],
) -> Result<[T; 2], FindError> {
    let seed = seed.filter(|_| T::ORDER == 0);
    let from_both_ends = (None, apart.has_one_root);
    let Some(seed) = seed else { return root_of(between, trend, from_both_ends, plain, sides) };
    let last = Cell::new(None);
    let mut sides = |x| {
        let met = sides(x);
        let [side, slope] = apart.parts(met);
        last.set(Some(LastTrial { x, side, slope }));
        met
    };
    let found = match followed(seed, between, trend, apart, &mut sides) {
        Some(found) => Ok(found),
        None => root_of(between, trend, from_both_ends, plain, |x| {
            let mut ends = between.iter().zip(&mut seed.ends);
            let Some((_, known)) = ends.find(|(end, _)| end.value() == x.value()) else {
                return sides(x);
            };
            let [side, _] = *known;
            if !side.is_finite() {
                *known = apart.parts(sides(x));
            }
            apart.sides(*known)
        }),
    };
    // A pose without a root leaves the next one the trials before it.
    if let (Ok(_), Some(trial)) = (&found, last.get()) {
        seed.trials = [seed.trials[1], trial];
    }
    found
}

/// The root next to the seed and the size that its rounding is measured by, where a search from both
/// ends is sure to find the same one.
///
/// It is sure to where the difference is below zero at the lower end and above it at the upper: such a bracket
/// is closed in on a place where the difference rises through zero, and there is one. And where the slope is
/// far from that of a dead point, at which the root is lost in the rounding: the difference changes over the
/// interval by √ε of its size or more, of which a dead point has no more than 16 ε.
fn followed<T: Real>(
    seed: &Seed<T>,
    between: [T; 2],
    trend: Trend,
    apart: Apart<T>,
    mut sides: impl FnMut(T) -> [T; 3],
) -> Option<[T; 2]> {
    let approach = Approach::new(between).filter(|_| apart.has_one_root)?;
    let (width, zero) = (approach.to - approach.from, number::<T>(0.0));
    let size = |[left, right, _]: [T; 3]| magnitude(left) + magnitude(right);
    let ends = seed.ends.map(|known| apart.sides(known));
    let [a, b] = ends.map(|[left, right, _]| trend.sign::<T>() * (left - right));
    if !(zero.gt(a) && b.gt(zero)) {
        return None;
    }
    let [first, second] = ends.map(size);
    let (extent, change) = (Cell::new(greater(first, second)), Cell::new(zero));
    let mut difference = |x| {
        let met = sides(x);
        let [left, right, slope] = met;
        extent.set(greater(extent.get(), constant(size(met))));
        change.set(magnitude(slope) * width);
        [left - right, slope]
    };
    let mut f = Equation::new(&mut difference, trend);
    // The slope is that of left − right.
    let turn = number::<T>(if apart.is_right { 1.0 } else { -1.0 });
    let foreseen = seed.foreseen(apart.given, turn);
    let LastTrial { x, slope, .. } = seed.trials[1];
    let longest = width * number(LONGEST);
    // Two slopes tell the curvature at the root only where they stand close together.
    let led = longest.ge(magnitude(foreseen - x)).then_some((foreseen - x, slope));
    let at = f.newton(foreseen, approach, longest, led)?;
    let (change, size) = (change.get(), extent.get() + change.get());
    (size.is_finite() && change.gt(size * number(sqrt(<T as Real>::EPSILON)))).then_some([at, size])
}
