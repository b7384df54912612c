//! Lines that have to be reached.

use super::{Diagnosis, behind_reach, reached, smallest_normal, width};
use crate::limit::{self, Reach};
use crate::{Real, Scalar, SolveError};

/// The value is (l − t)(l + t): |t| ≤ l. Operands t and l; then the group. At the limit as for
/// [`ReachCircles`](super::ReachCircles).
///
/// # Errors
/// Those of [`ReachCircles`](super::ReachCircles); `NotFinite` where the value has left the number's normal
/// range.
#[derive(Clone, Copy, Debug)]
pub struct ReachLine<T>(pub [T; 2], pub &'static str);

impl<T: Real> ReachLine<T> {
    /// The answer where the line is not beyond reach.
    #[cold]
    #[inline(never)]
    fn decided(self, value: T, reach: Reach) -> Result<T, SolveError> {
        let Self([t, l], group) = self;
        // One unit in the last place from the limit the product is ε l², which full precision of l²
        // leaves in the normal range.
        let has_room = l.value() * l.value() >= T::smallest_square().value();
        let is_inside = t.value().abs() < l.value().abs();
        let is_lost = value.value() < smallest_normal::<T>();
        if reach == Reach::Meets && is_inside && !has_room && is_lost {
            return Err(SolveError::NotFinite { name: group });
        }
        reached(value, &[t, l], reach, group)
    }
}

impl<T: Scalar> Diagnosis<T> for ReachLine<T> {
    #[inline(always)]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self([t, l], group) = self;
        match limit::line(t.value(), l.value(), width::<T>()) {
            Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
            reach => self.decided(value, reach),
        }
    }

    /// Against t².
    #[inline(always)]
    fn behind(self, met: T::Mask, value: T) -> T::Mask {
        let [t, l] = self.0;
        behind_reach(met, value, t * t, &[t, l])
    }
}

/// The value is bx² + by² − e²: |e| ≤ |(bx, by)|. Operands bx, by and e; then the group. At the limit and
/// errors as for [`ReachCircles`](super::ReachCircles).
#[derive(Clone, Copy, Debug)]
pub struct ReachOffset<T>(pub [T; 3], pub &'static str);

impl<T: Scalar> Diagnosis<T> for ReachOffset<T> {
    #[inline(always)]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self([bx, by, e], group) = self;
        match limit::offset([bx.value(), by.value()], e.value(), width::<T>()) {
            Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
            reach => reached(value, &[bx, by, e], reach, group),
        }
    }

    /// Against e².
    #[inline(always)]
    fn behind(self, met: T::Mask, value: T) -> T::Mask {
        let [bx, by, e] = self.0;
        behind_reach(met, value, e * e, &[bx, by, e])
    }
}
