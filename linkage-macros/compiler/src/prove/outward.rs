//! Intervals of `f64`, rounded outwards: they hold every value that real arithmetic gives for any members of the
//! operands.
//!
//! There are no rounding modes: an end is computed to the nearest and moved out by more than half a last place.

/// All numbers x with `low` ≤ x ≤ `high`; an end that is not known is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutwardInterval {
    pub low: f64,
    pub high: f64,
}

/// Above the relative error of an operation: twice half a last place.
const OUT: f64 = f64::EPSILON;

/// The smallest number, for what underflows.
const TINY: f64 = f64::from_bits(1);

/// A number below every real number that rounds to this one.
#[inline]
pub(crate) fn below(value: f64) -> f64 {
    // Not a number, as the difference of infinities is, is less than all.
    (value - value.abs() * OUT - TINY).max(f64::NEG_INFINITY)
}

/// A number above every real number that rounds to this one.
#[inline]
pub(crate) fn above(value: f64) -> f64 {
    (value + value.abs() * OUT + TINY).min(f64::INFINITY)
}

impl OutwardInterval {
    pub(crate) const ZERO: Self = Self { low: 0.0, high: 0.0 };
    pub(crate) const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    pub const fn point(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// Between two numbers that are known without error.
    pub const fn between(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// Between the results of operations.
    #[inline]
    fn out(low: f64, high: f64) -> Self {
        Self { low: below(low), high: above(high) }
    }

    #[inline]
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The least magnitude.
    pub(crate) fn least(self) -> f64 {
        if self.has_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) }
    }

    #[inline]
    pub(crate) fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    pub(crate) fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    #[inline]
    pub(crate) fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    #[inline]
    pub(crate) fn add(self, other: Self) -> Self {
        Self::out(self.low + other.low, self.high + other.high)
    }

    #[inline]
    pub(crate) fn sub(self, other: Self) -> Self {
        Self::out(self.low - other.high, self.high - other.low)
    }

    #[inline]
    pub(crate) fn mul(self, other: Self) -> Self {
        // Zero times an unknown number is zero.
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let corners = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        Self::hull_of(corners)
    }

    /// The least interval around results of operations. One that is not a number, zero times infinity, lies between
    /// the others or makes all unknown.
    #[inline]
    fn hull_of([a, b, c, d]: [f64; 4]) -> Self {
        if (a + b + c + d).is_nan() {
            return Self::ALL;
        }
        Self::out(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }

    pub(crate) fn square(self) -> Self {
        let (least, most) = (self.least(), self.magnitude());
        Self { low: below(least * least).max(0.0), high: above(most * most) }
    }

    pub(crate) fn div(self, other: Self) -> Self {
        if other.has_zero() || !self.is_finite() {
            return Self::ALL;
        }
        let corners = [
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ];
        Self::hull_of(corners)
    }

    pub(crate) fn reciprocal(self) -> Self {
        Self::point(1.0).div(self)
    }

    /// The root of what is not negative in it; unknown where nothing is.
    pub(crate) fn root(self) -> Self {
        if self.high < 0.0 {
            return Self::ALL;
        }
        Self { low: below(self.low.max(0.0).sqrt()).max(0.0), high: above(self.high.sqrt()) }
    }

    pub(crate) fn abs(self) -> Self {
        Self { low: self.least(), high: self.magnitude() }
    }

    pub(crate) fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The numbers of both: the first, where there is none.
    #[inline]
    pub(crate) fn meet(self, other: Self) -> Self {
        let met = Self { low: self.low.max(other.low), high: self.high.min(other.high) };
        if met.low <= met.high { met } else { self }
    }

    #[inline]
    pub(crate) fn widened(self, by: f64) -> Self {
        if by == 0.0 { self } else { Self::out(self.low - by, self.high + by) }
    }

    /// Scaled by a number that is not negative.
    pub(crate) fn scaled(self, by: f64) -> Self {
        self.mul(Self::point(by))
    }
}
