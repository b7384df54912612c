//! The range that a width of numbers holds, for values that are never to be infinite.

use super::routine::Threshold;

/// The range that one width of numbers holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    /// The largest magnitude of any value, …
    pub(super) largest: f64,
    /// … of a product or quotient that is asked for, …
    pub(super) asked: f64,
    /// … of a factor whose product's rounding is computed, …
    pub(super) factor: f64,
    /// … and of what is given.
    pub given: f64,
    /// The largest that a value has to be where it is asked: far beyond those of machines, and so small that what is made
    /// of it is asked seldom.
    pub(super) usual: f64,
    /// The quotient that a divisor is asked for, and the divisor up to which that is no loss.
    pub(super) quotient: f64,
    pub(super) divisor: f64,
    /// The largest power of e, and the smallest number and square of full precision.
    pub(super) exponent: f64,
    pub(super) normal: f64,
    pub(super) square: f64,
    /// More than what underflow takes from a value.
    pub(super) tiny: f64,
    /// The largest angle whose sine is computed.
    pub near: f64,
    pub(super) is_narrow: bool,
}

impl Room {
    pub(crate) const WIDE: Self = Self {
        largest: 1e307,
        asked: 1e300,
        factor: 1e297,
        given: 1e15,
        usual: 1e60,
        quotient: 1e80,
        divisor: 1e-40,
        exponent: 690.0,
        normal: f64::MIN_POSITIVE,
        square: 4.5e-277,
        tiny: 1e-300,
        near: 1_048_576.0,
        is_narrow: false,
    };
    pub(crate) const NARROW: Self = Self {
        largest: 1e38,
        asked: 1e36,
        factor: 1e34,
        given: 1e12,
        usual: 1e36,
        quotient: 1e24,
        divisor: 1e-30,
        exponent: 80.0,
        normal: f32::MIN_POSITIVE as f64,
        square: 8.2e-25,
        tiny: 1e-35,
        near: 51_471.0,
        is_narrow: true,
    };

    pub(super) fn of(self, threshold: Threshold) -> f64 {
        match threshold {
            Threshold::SmallestSquare => self.square,
            Threshold::Number(wide, narrow) => [wide, narrow][usize::from(self.is_narrow)],
        }
    }
}
