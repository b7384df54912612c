//! Last places of a width, and what the run-time's kernels promise.

use crate::exact::Exact;
use crate::function::Function;

/// A width of numbers: what rounding to it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// The bits of a significand.
    bits: i32,
    /// The smallest number is this power of two.
    least: i32,
    /// The largest number.
    largest: f64,
    /// The largest angle that the fast path's sine takes, in rad.
    largest_angle: f64,
    /// True if it has the run-time's constants and kernels of double precision.
    is_double: bool,
}

/// The factor of ε of a spread by which a value may be wrong, as the run-time crate counts it.
const ROUNDINGS: f64 = 16.0;

impl Precision {
    pub const SINGLE: Self = Self {
        bits: 24,
        least: -149,
        largest: f32::MAX as f64,
        largest_angle: 51_471.0,
        is_double: false,
    };
    pub const DOUBLE: Self = Self {
        bits: 53,
        least: -1074,
        largest: f64::MAX,
        largest_angle: 1_048_576.0,
        is_double: true,
    };

    /// A format of so few bits that all its numbers can be tried.
    pub const fn small(bits: i32, least: i32, largest: f64) -> Self {
        Self { bits, least, largest, ..Self::SINGLE }
    }

    /// That one of two, in double and in single precision.
    pub fn of_width<T>(self, [double, single]: [T; 2]) -> T {
        if self.is_double { double } else { single }
    }

    /// The distance from 1 to the next number.
    pub(crate) fn epsilon(self) -> f64 {
        power_of_two(1 - self.bits)
    }

    /// The relative error of a rounding that does not underflow.
    pub(crate) fn relative(self) -> f64 {
        power_of_two(-self.bits)
    }

    /// The smallest number: functions lose some of these where they underflow.
    pub(crate) fn smallest(self) -> f64 {
        power_of_two(self.least)
    }

    /// At least what an operation loses that underflows: half the smallest number, which `f64` does not hold of its
    /// own.
    pub(crate) fn underflow(self) -> f64 {
        power_of_two(self.least - 1).max(f64::from_bits(1))
    }

    pub(crate) const fn largest(self) -> f64 {
        self.largest
    }

    /// The smallest square of full precision, as the run-time crate counts it: the smallest normal number over ε².
    pub(crate) fn smallest_square(self) -> f64 {
        let smallest_normal = power_of_two(self.least + self.bits - 1);
        smallest_normal / (self.epsilon() * self.epsilon())
    }

    /// A spread's rounding, as a factor.
    pub(crate) fn rounding(self) -> f64 {
        ROUNDINGS * self.epsilon()
    }

    pub(crate) const fn largest_angle(self) -> f64 {
        self.largest_angle
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
        power_of_two(exponent - self.bits).max(self.underflow())
    }

    /// The constant rounded to this width.
    pub fn round(self, value: &Exact) -> f64 {
        if self.is_double { value.to_f64() } else { value.to_f32().into() }
    }

    /// The rest that rounding to this width leaves of a constant, rounded once to this width.
    pub(crate) fn rest(self, value: &Exact) -> f64 {
        if self.is_double { value.low_f64() } else { value.low_f32().into() }
    }

    /// The error that a function promises: in last places, and absolutely for an argument of this size. None where
    /// nothing is promised.
    pub(crate) fn promised(self, function: Function, argument: f64) -> Option<(f64, f64)> {
        let last_places = self.of_width(function.last_places()?);
        // Without the third word of π, which the fused kernel leaves out, see the run-time crate.
        let is_beside = self.is_double && function.reduces_turns();
        Some((last_places, if is_beside { 1.5e-33 * (argument + 1.0) } else { 0.0 }))
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
