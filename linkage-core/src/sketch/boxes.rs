//! Boxes along the axes of the page, and what of a line is inside one.

/// From the upper left corner to the lower right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box2 {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Box2 {
    /// The empty box: its union with another box is that box.
    pub(super) const NOTHING: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// The smallest that holds all of them.
    pub(super) fn around(spots: impl IntoIterator<Item = [f64; 2]>) -> Self {
        spots.into_iter().fold(Self::NOTHING, |all, spot| all.with(Self { low: spot, high: spot }))
    }

    /// About a middle.
    pub(super) fn about([x, y]: [f64; 2], half: [f64; 2]) -> Self {
        Self { low: [x - half[0], y - half[1]], high: [x + half[0], y + half[1]] }
    }

    pub(super) fn with(self, other: Self) -> Self {
        let both =
            |f: fn(f64, f64) -> f64, a: [f64; 2], b: [f64; 2]| [f(a[0], b[0]), f(a[1], b[1])];
        Self {
            low: both(f64::min, self.low, other.low),
            high: both(f64::max, self.high, other.high),
        }
    }

    pub(super) fn grown(self, by: f64) -> Self {
        let Self { low, high } = self;
        Self { low: low.map(|x| x - by), high: high.map(|x| x + by) }
    }

    pub(super) fn size(self) -> [f64; 2] {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }

    pub(super) fn is_nothing(self) -> bool {
        !(self.low[0] <= self.high[0] && self.low[1] <= self.high[1])
    }

    pub(super) fn holds(self, [x, y]: [f64; 2]) -> bool {
        self.low[0] <= x && x <= self.high[0] && self.low[1] <= y && y <= self.high[1]
    }

    /// The area that both cover.
    pub(super) fn overlap(self, other: Self) -> f64 {
        let side = |axis: usize| {
            (self.high[axis].min(other.high[axis]) - self.low[axis].max(other.low[axis])).max(0.0)
        };
        side(0) * side(1)
    }

    /// The length of a line's part inside the box (Liang and Barsky).
    pub(super) fn length_inside(self, [a, b]: [[f64; 2]; 2]) -> f64 {
        let is_aside = |axis: usize| {
            a[axis].max(b[axis]) < self.low[axis] || a[axis].min(b[axis]) > self.high[axis]
        };
        if is_aside(0) || is_aside(1) {
            return 0.0;
        }
        let along = [b[0] - a[0], b[1] - a[1]];
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let (low, high) = (self.low[axis] - a[axis], self.high[axis] - a[axis]);
            if along[axis] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return 0.0;
                }
                continue;
            }
            let (first, second) = (low / along[axis], high / along[axis]);
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        (leave - enter).max(0.0) * along[0].hypot(along[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_inside_is_what_is_left_of_the_line() {
        let unit = Box2 { low: [0.0; 2], high: [1.0; 2] };
        assert_eq!(unit.length_inside([[-1.0, 0.5], [2.0, 0.5]]), 1.0);
        assert_eq!(unit.length_inside([[0.25, 0.5], [0.25, 0.75]]), 0.25);
        assert_eq!(unit.length_inside([[2.0, -1.0], [2.0, 3.0]]), 0.0);
        assert!((unit.length_inside([[-1.0, -1.0], [2.0, 2.0]]) - 2_f64.sqrt()).abs() < 1e-15);
        assert_eq!(unit.overlap(Box2::about([1.0, 1.0], [0.5, 0.25])), 0.125);
        assert!(Box2::NOTHING.is_nothing() && !unit.is_nothing());
    }
}
