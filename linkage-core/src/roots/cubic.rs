//! The cubic through values and slopes of two places.

use super::approach::{At, number};
use crate::Real;

/// By the part u of the way from the first place to the second: p u³ + q u² + d₀ u + y₀.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic<T> {
    p: T,
    q: T,
    /// The slopes at both places.
    slopes: [T; 2],
    values: [T; 2],
}

impl<T: Real> Cubic<T> {
    pub(crate) fn through([a, b]: [At<T>; 2]) -> Self {
        let width = b.x - a.x;
        let [d0, d1] = [a.slope * width, b.slope * width];
        let rise = b.value - a.value;
        Self {
            p: d0 + d1 - number::<T>(2.0) * rise,
            q: number::<T>(3.0) * rise - number::<T>(2.0) * d0 - d1,
            slopes: [d0, d1],
            values: [a.value, b.value],
        }
    }

    /// The value at a part of the way.
    pub(crate) fn at(self, part: T) -> T {
        ((self.p * part + self.q) * part + self.slopes[0]) * part + self.values[0]
    }

    /// The slope at a part of the way.
    pub(crate) fn slope_at(self, part: T) -> T {
        (number::<T>(3.0) * self.p * part + number::<T>(2.0) * self.q) * part + self.slopes[0]
    }

    /// Where, between 0 and 1, it is lowest, if it falls at the first place and rises at the second.
    pub(crate) fn turning_part(self) -> T {
        let Self { p, q, slopes: [d0, _], .. } = self;
        -d0 / (q + (q * q - number::<T>(3.0) * p * d0).sqrt())
    }

    /// Where it bends the other way, if it goes against both ends' slopes there: between its two turns.
    pub(crate) fn bend(self) -> Option<T> {
        let none = number::<T>(0.0);
        let part = -self.q / (number::<T>(3.0) * self.p);
        let slope = self.slope_at(part);
        let is_against = |other: T| none.gt(slope * other);
        let is_inside = part.gt(none) && number::<T>(1.0).gt(part);
        let [d0, d1] = self.slopes;
        (is_inside && is_against(d0) && is_against(d1)).then_some(part)
    }

    /// Numbers between the smallest and the largest of which all values are.
    pub(super) fn values_within(self) -> [T; 4] {
        let ([y0, y1], third) = (self.values, number::<T>(1.0 / 3.0));
        [y0, y0 + self.slopes[0] * third, y1 - self.slopes[1] * third, y1]
    }

    /// Numbers between the smallest and the largest of which all slopes are.
    pub(super) fn slopes_within(self) -> [T; 3] {
        let [d0, d1] = self.slopes;
        [d0, d0 + self.q, d1]
    }

    /// The second derivatives at both places.
    pub(super) fn curvatures(self) -> [T; 2] {
        let first = number::<T>(2.0) * self.q;
        [first, first + number::<T>(6.0) * self.p]
    }
}
