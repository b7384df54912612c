//! Intervals of `f64`, for values that are not known before run time.
//!
//! The ends are those of the operations on real numbers, as `f64` computes them: whoever needs an
//! interval that holds every value widens the result of each operation.

/// All numbers x with `low` ≤ x ≤ `high` and |x| ≥ `away`.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
    pub away: f64,
}

impl Interval {
    pub fn point(value: f64) -> Self {
        Self { low: value, high: value, away: value.abs() }
    }

    /// From −`magnitude` to `magnitude`.
    pub(super) fn about(magnitude: f64) -> Self {
        Self { low: -magnitude, high: magnitude, away: 0.0 }
    }

    pub fn of(low: f64, high: f64) -> Self {
        let away = if low > 0.0 {
            low
        } else if high < 0.0 {
            -high
        } else {
            0.0
        };
        Self { low, high, away }
    }

    pub(super) fn largest(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// True if all numbers are above zero, false if all are below; `None` otherwise.
    pub fn sign(self) -> Option<bool> {
        (self.low > 0.0 || self.high < 0.0).then_some(self.low > 0.0)
    }

    pub(super) fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }

    pub fn plus(self, other: Self) -> Self {
        Self::of(self.low + other.low, self.high + other.high)
    }

    /// The values of either.
    pub(super) fn or(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            away: self.away.min(other.away),
        }
    }

    pub fn times(self, other: Self) -> Self {
        let corners = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        // A NaN corner makes everything unknown.
        if corners.iter().any(|corner| corner.is_nan()) {
            return Self::about(f64::INFINITY);
        }
        let (low, high) = corners
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)));
        Self { low, high, away: self.away * other.away }
    }

    pub fn squared(self) -> Self {
        let (low, high) = (self.away * self.away, self.largest() * self.largest());
        Self { low, high, away: low }
    }

    pub fn reciprocal(self) -> Option<Self> {
        let (least, most) = (1.0 / self.largest(), 1.0 / self.away);
        if !most.is_finite() {
            return None;
        }
        Some(match self.sign() {
            Some(true) => Self::of(least, most),
            Some(false) => Self::of(-most, -least),
            None => Self { low: -most, high: most, away: least },
        })
    }

    /// The root, of what cannot be negative.
    pub fn root(self) -> Option<Self> {
        (self.low >= 0.0).then(|| Self::of(self.low.sqrt(), self.high.sqrt()))
    }
}
