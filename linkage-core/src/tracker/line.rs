//! Clearances along a straight line of inputs.

use super::Linear;
use crate::clearance::Clearance;
use crate::solver::Solver;
use crate::{Real, Scalar};

/// A straight line between two inputs, its parts counted from 0 to 1; it goes on beyond them.
#[derive(Clone, Copy)]
pub(super) struct Line<M: Solver> {
    from: M::Input,
    to: M::Input,
    step: M::Input,
}

/// Clearance of one group at a place, and its rates along the line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reading {
    pub(super) value: f64,
    pub(super) rate: f64,
    pub(super) second_rate: f64,
    pub(super) scale: f64,
}

/// All that a group's clearance and its rates are on a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ranges {
    pub(super) value: [f64; 2],
    pub(super) rate: [f64; 2],
    pub(super) second_rate: [f64; 2],
    pub(super) scale: [f64; 2],
}

/// The readings of every group.
pub(super) struct AllReadings<M: Solver>(M::Groups<Clearance<M::Scalar>>);

/// The ranges of every group.
pub(super) struct AllRanges<M: Solver>(M::Groups<Clearance<Enclosing<M>>>);

/// The same of values alone.
pub(super) struct AllValues<M: Solver>(M::Groups<[Enclosing<M>; 2]>);

type Enclosing<M> = <<M as Solver>::Scalar as Real>::Enclosing;

impl<M: Solver> Line<M> {
    pub(super) fn new(from: M::Input, to: M::Input) -> Self {
        Self { from, to, step: to.minus(from) }
    }

    /// The line through an input along a direction.
    pub(super) fn along(from: M::Input, step: M::Input) -> Self {
        Self { from, to: from.plus(number::<M>(1.0), step), step }
    }

    /// The line from the same beginning to other inputs.
    pub(super) fn to(&self, to: M::Input) -> Self {
        Self::new(self.from, to)
    }

    /// The step from the beginning to the end, unless there is none.
    pub(super) fn direction(&self) -> Option<M::Input> {
        (!self.step.all(|number| number.value() == 0.0)).then_some(self.step)
    }

    pub(super) fn input(&self, part: f64) -> M::Input {
        if part == 1.0 { self.to } else { self.from.plus(number::<M>(part), self.step) }
    }

    pub(super) fn reading(&self, solver: &M, part: f64, group: usize) -> Reading {
        self.readings(solver, part).of(group)
    }

    pub(super) fn readings(&self, solver: &M, part: f64) -> AllReadings<M> {
        AllReadings(solver.clearances(self.input(part), self.step))
    }

    /// Between two parts.
    pub(super) fn ranges(&self, solver: &M, parts: [f64; 2]) -> AllRanges<M> {
        let [middle, radius] = self.around(parts);
        AllRanges(solver.enclosures(middle, radius, self.step))
    }

    /// All the way.
    pub(super) fn values(&self, solver: &M) -> AllValues<M> {
        let [middle, radius] = self.around([0.0, 1.0]);
        AllValues(solver.values(middle, radius))
    }

    /// Inputs, and how far from them those between two parts are.
    fn around(&self, [a, b]: [f64; 2]) -> [M::Input; 2] {
        // The end of a step is rounded, a part of it again, and their sum.
        let radius = 0.5 * (b - a) + 4.0 * M::Scalar::EPSILON;
        let none = self.step.minus(self.step);
        [self.input(0.5 * (a + b)), none.plus(number::<M>(radius), self.step)]
    }
}

impl<M: Solver> AllReadings<M> {
    pub(super) fn of(&self, group: usize) -> Reading {
        match self.0.as_ref().get(group) {
            Some(of) => {
                let of = of.map(|number| number.value());
                let (value, rate) = (of.value, of.rate);
                Reading { value, rate, second_rate: of.second_rate, scale: of.scale }
            }
            None => Reading { value: 1.0, rate: 0.0, second_rate: 0.0, scale: 1.0 },
        }
    }
}

impl<M: Solver> AllRanges<M> {
    pub(super) fn of(&self, group: usize) -> Ranges {
        match self.0.as_ref().get(group) {
            Some(of) => {
                let of = of.map(|range| range.bounds());
                let (value, rate) = (of.value, of.rate);
                Ranges { value, rate, second_rate: of.second_rate, scale: of.scale }
            }
            None => {
                Ranges { value: [1.0; 2], rate: [0.0; 2], second_rate: [0.0; 2], scale: [1.0; 2] }
            }
        }
    }
}

impl<M: Solver> AllValues<M> {
    /// The ranges of a group, with unbounded rates.
    pub(super) fn of(&self, group: usize) -> Ranges {
        let known = self.0.as_ref().get(group).map(|of| of.map(|range| range.bounds()));
        let [value, scale] = known.unwrap_or([[1.0; 2]; 2]);
        let anything = [f64::NEG_INFINITY, f64::INFINITY];
        Ranges { value, rate: anything, second_rate: anything, scale }
    }
}

impl<T: Copy> Clearance<T> {
    fn map<U>(self, f: impl Fn(T) -> U) -> Clearance<U> {
        let Self { value, rate, second_rate, scale } = self;
        Clearance { value: f(value), rate: f(rate), second_rate: f(second_rate), scale: f(scale) }
    }
}

impl Reading {
    /// True if the clearance is below so many times its scale; false for NaN.
    pub(super) fn is_below(&self, threshold: f64) -> bool {
        self.value < threshold * self.scale
    }

    /// True if it is at least so many times its scale.
    pub(super) fn is_above(&self, threshold: f64) -> bool {
        self.scale > 0.0 && self.value >= threshold * self.scale
    }

    pub(super) fn is_finite(&self) -> bool {
        let Self { value, rate, second_rate, scale } = *self;
        scale > 0.0 && [value, rate, second_rate, scale].iter().all(|number| number.is_finite())
    }
}

impl Ranges {
    /// True if a reading is within these ranges, but for its own rounding, which is less than `zero` of its
    /// scale. Ranges of NaN hold every reading.
    pub(super) fn hold(&self, reading: &Reading, zero: f64) -> bool {
        let [least, most] = self.value;
        let room = zero * reading.scale;
        !(reading.value < least - room || reading.value > most + room)
    }

    /// True if it is everywhere at least so many times its scale.
    pub(super) fn is_above(&self, threshold: f64) -> bool {
        self.scale[0] > 0.0 && self.value[0] >= threshold * self.scale[1]
    }
}

fn number<M: Solver>(value: f64) -> M::Scalar {
    Scalar::lit(value, value as f32)
}
