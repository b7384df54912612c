//! Last places of a width, and what the run-time's kernels promise.

use crate::exact::Exact;
use crate::function::Function;

/// A width of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    Single,
    Double,
}

/// The factor of ε of a spread by which a value may be wrong, as the run-time crate counts it.
const ROUNDINGS: f64 = 16.0;

impl Precision {
    /// The bits of a significand.
    const fn bits(self) -> i32 {
        match self {
            Self::Single => 24,
            Self::Double => 53,
        }
    }

    /// The distance from 1 to the next number.
    pub(crate) fn epsilon(self) -> f64 {
        match self {
            Self::Single => f32::EPSILON.into(),
            Self::Double => f64::EPSILON,
        }
    }

    /// The relative error of a rounding that does not underflow.
    pub(crate) fn relative(self) -> f64 {
        self.epsilon() / 2.0
    }

    /// The smallest number: functions lose some of these where they underflow.
    pub(crate) fn smallest(self) -> f64 {
        match self {
            Self::Single => f32::from_bits(1).into(),
            Self::Double => f64::from_bits(1),
        }
    }

    /// At least what an operation loses that underflows: half the smallest number, which `f64` does not hold of its
    /// own.
    pub(crate) fn underflow(self) -> f64 {
        match self {
            Self::Single => self.smallest() / 2.0,
            Self::Double => self.smallest(),
        }
    }

    /// The largest number.
    pub(crate) fn largest(self) -> f64 {
        match self {
            Self::Single => f32::MAX.into(),
            Self::Double => f64::MAX,
        }
    }

    /// The smallest square of full precision, as the run-time crate counts it: the smallest normal number over ε².
    pub(crate) fn smallest_square(self) -> f64 {
        self.smallest_normal() / (self.epsilon() * self.epsilon())
    }

    fn smallest_normal(self) -> f64 {
        match self {
            Self::Single => f32::MIN_POSITIVE.into(),
            Self::Double => f64::MIN_POSITIVE,
        }
    }

    /// A spread's rounding, as a factor.
    pub(crate) fn rounding(self) -> f64 {
        ROUNDINGS * self.epsilon()
    }

    /// The largest angle that the fast path's sine takes, in rad.
    pub(crate) fn largest_angle(self) -> f64 {
        match self {
            Self::Single => 51_471.0,
            Self::Double => 1_048_576.0,
        }
    }

    /// Half a last place of any number up to this size: the error of a rounding to nearest, where what is rounded
    /// is no larger. It is never below what underflow takes.
    pub(crate) fn half_last_place(self, size: f64) -> f64 {
        if size == 0.0 {
            return 0.0;
        }
        if !size.is_finite() {
            return f64::INFINITY;
        }
        // Below the normal numbers the exponent's field is 0, and the least last place is the answer.
        let exponent = ((size.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        power_of_two(exponent - self.bits()).max(self.underflow())
    }

    /// The constant rounded to this width.
    pub(crate) fn round(self, value: &Exact) -> f64 {
        match self {
            Self::Single => value.to_f32().into(),
            Self::Double => value.to_f64(),
        }
    }

    /// The rest that rounding to this width leaves of a constant, rounded once to this width.
    pub(crate) fn rest(self, value: &Exact) -> f64 {
        match self {
            Self::Single => value.low_f32().into(),
            Self::Double => value.low_f64(),
        }
    }

    /// The error that a function promises: in last places, and absolutely for an argument of this size. None where
    /// nothing is promised.
    pub(crate) fn promised(self, function: Function, argument: f64) -> Option<(f64, f64)> {
        let [double, single] = function.last_places()?;
        // Without the third word of π, which the fused kernel leaves out, see the run-time crate.
        let reduces = function.reduces_turns();
        match self {
            Self::Single => Some((single, 0.0)),
            Self::Double if reduces => Some((double, 1.5e-33 * (argument + 1.0))),
            Self::Double => Some((double, 0.0)),
        }
    }
}

/// 2 to this power; zero below the numbers.
fn power_of_two(power: i32) -> f64 {
    match power {
        -1022..=1023 => f64::from_bits(((power + 1023) as u64) << 52),
        -1074..=-1023 => f64::from_bits(1 << (power + 1074)),
        _ if power < 0 => 0.0,
        _ => f64::INFINITY,
    }
}
