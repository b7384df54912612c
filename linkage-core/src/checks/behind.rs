//! Conditions as margins go on behind them: what stands behind a group without a pose is no number.

use super::Checks;
use crate::diagnosis::Diagnosis;
use crate::roots::FindError;
use crate::{Real, SolveError};

/// A checker of conditions that goes on behind a group that is out of reach and behind an unknown without a
/// root, each with a number in the place of what is under its root. NaN makes everything behind it NaN.
/// Any other number shows what is NaN for that alone: of a condition that is refused for another reason, NaN
/// is left in either case.
#[derive(Clone, Copy, Debug)]
pub struct Behind {
    stand_in: f64,
    /// True if an equation was found open behind which nothing becomes NaN.
    is_open: bool,
}

impl Behind {
    /// NaN behind what has no pose.
    pub(crate) fn unknown() -> Self {
        Self { stand_in: f64::NAN, is_open: false }
    }

    /// One in the place of what has no pose: finite numbers that mean nothing.
    pub(crate) fn invented() -> Self {
        Self { stand_in: 1.0, ..Self::unknown() }
    }

    /// True if the numbers do not tell what is known.
    pub(crate) fn is_open(self) -> bool {
        self.is_open
    }

    fn in_place<T: Real>(self, has_no_pose: bool) -> T {
        let number = if has_no_pose { self.stand_in } else { f64::NAN };
        T::num(number)
    }
}

/// True if this says that there is no pose, and nothing worse.
pub(crate) fn has_no_pose(refusal: SolveError) -> bool {
    matches!(refusal, SolveError::OutOfReach { .. } | SolveError::NoSolution { .. })
}

impl<T: Real> Checks<T> for Behind {
    /// An equation is not a number where a group of its own has no pose, too.
    fn root(
        &mut self,
        found: Result<[T; 2], FindError>,
        _: &'static str,
        _: &'static str,
    ) -> (T, T) {
        match found {
            Ok([at, size]) => (at, size),
            Err(error) => {
                let has_no_pose =
                    matches!(error, FindError::NoSolution { .. } | FindError::NotFinite { .. });
                (self.in_place(has_no_pose), T::num(1.0))
            }
        }
    }

    /// Behind a root that was found: where it was not, neither is the difference, but by a stand-in.
    fn closed(&mut self, difference: T, size: T, unknown: &'static str, unit: &'static str) {
        let is_known = self.stand_in.is_nan() && !difference.value().is_nan();
        let closed = || crate::diagnosis::closed(difference, size, unknown, unit);
        self.is_open |= is_known && closed().is_err();
    }

    fn sin_cos(&mut self, angle: T) -> (T, T) {
        angle.sin_cos()
    }

    fn guard(&mut self, value: T, diagnosis: impl Diagnosis<T>) -> T {
        diagnosis.diagnose(value).unwrap_or_else(|refusal| self.in_place(has_no_pose(refusal)))
    }
}
