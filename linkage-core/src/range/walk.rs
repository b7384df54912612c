//! Where a smooth function comes through zero between two places, and where it only touches it.
//!
//! The way is walked in panels that a cubic describes. In each a change of sign is closed in on,
//! and a dip whose cubic comes near zero is followed to its lowest point. A change that
//! is narrower than a panel and shows at none of its ends is missed: this is a search, not a proof.

use super::panels::Panels;
use crate::Real;
use crate::roots::{
    At, Cubic, FindError, constant, crossing, differentiated, greater, less, lowest, magnitude,
    number,
};

/// The behaviour of the function at a zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event<T> {
    /// The function becomes positive.
    Rises(T),
    /// It becomes negative.
    Falls(T),
    /// It comes down to zero, as far as rounding can tell, and stays positive.
    Touches(T),
}

/// The shortest piece, as a part of its panel.
const SHORTEST: f64 = 1.0 / 128.0;

/// A function between two places, and how far from zero rounding may put it where it is zero. It is
/// asked nowhere else.
pub(super) struct Walk<F, T> {
    pub(super) f: F,
    pub(super) zero: T,
    pub(super) ends: [T; 2],
}

impl<T: Real, F: FnMut(T) -> [T; 2]> Walk<F, T> {
    /// f without the derivatives that its numbers carry.
    ///
    /// # Errors
    /// `NotFinite` where the function is not finite.
    pub(super) fn at(&mut self, x: T) -> Result<At<T>, FindError> {
        let [value, slope] = (self.f)(x).map(constant);
        let is_finite = value.is_finite() && slope.is_finite();
        if is_finite {
            Ok(At { x, value, slope })
        } else {
            Err(FindError::NotFinite { at: x.value() })
        }
    }

    /// True if the value counts as positive: zero itself does.
    pub(super) fn is_positive(&self, at: At<T>) -> bool {
        at.value.ge(-self.zero)
    }

    /// True if the function is positive between two places between which its sign does not change, beyond
    /// rounding; none where it is zero to rounding.
    ///
    /// # Errors
    /// `NotFinite` where the function is not finite.
    pub(super) fn way(&mut self, [from, to]: [T; 2]) -> Result<Option<bool>, FindError> {
        // It may touch zero in the middle, but hardly at three places.
        for part in [0.5, 0.3, 0.7] {
            let value = self.at(from + (to - from) * number(part))?.value;
            if value.gt(self.zero) || (-self.zero).gt(value) {
                return Ok(Some(value.gt(self.zero)));
            }
        }
        Ok(None)
    }

    /// Tells every event between the ends, in order, panel by panel.
    ///
    /// # Errors
    /// `NotFinite` where f is not finite.
    pub(super) fn events(
        &mut self,
        panels: Panels,
        mut tell: impl FnMut(Event<T>),
    ) -> Result<(), FindError> {
        let [from, to] = self.ends;
        let width = to - from;
        let mut here = self.at(from)?;
        for [part, long] in panels.ends() {
            let goal = if part < 1.0 { from + width * number(part) } else { to };
            let shortest = width * number(long * SHORTEST);
            // At most as many pieces as the shortest are of a panel.
            while goal.gt(here.x) {
                here = self.stretch(here, goal, shortest, &mut tell)?;
            }
        }
        Ok(())
    }

    /// The events from here to the end of the longest stretch that a cubic describes, at most to
    /// the goal: that end.
    fn stretch(
        &mut self,
        here: At<T>,
        goal: T,
        shortest: T,
        tell: &mut impl FnMut(Event<T>),
    ) -> Result<At<T>, FindError> {
        let mut end = self.at(goal)?;
        let mut middle = self.at(half_way(here.x, goal))?;
        // Next to each other there is no middle.
        let is_divisible = |middle: At<T>, end: At<T>| {
            (end.x - here.x).gt(shortest) && middle.x.gt(here.x) && end.x.gt(middle.x)
        };
        while is_divisible(middle, end) && !is_cubic(here, middle, end) {
            end = middle;
            middle = self.at(half_way(here.x, end.x))?;
        }
        self.piece([here, middle], tell)?;
        self.piece([middle, end], tell)?;
        Ok(end)
    }

    /// The events of a piece: of its halves, where its cubic turns back and back again.
    fn piece(
        &mut self,
        [a, b]: [At<T>; 2],
        tell: &mut impl FnMut(Event<T>),
    ) -> Result<(), FindError> {
        let Some(bend) = Cubic::through([a, b]).bend() else { return self.arc([a, b], tell) };
        let middle = self.at(a.x + (b.x - a.x) * bend)?;
        self.arc([a, middle], tell)?;
        self.arc([middle, b], tell)
    }

    /// The events of a piece that turns back at most once.
    fn arc(
        &mut self,
        [a, b]: [At<T>; 2],
        tell: &mut impl FnMut(Event<T>),
    ) -> Result<(), FindError> {
        match (self.is_positive(a), self.is_positive(b)) {
            (true, false) => {
                let top = self.top([a, b], a)?;
                tell(Event::Falls(self.root([top, b])?));
            }
            (false, true) => {
                let top = self.top([a, b], b)?;
                tell(Event::Rises(self.root([top, a])?));
            }
            (true, true) => {
                let Some(least) = self.turn([a, b], number(1.0))? else { return Ok(()) };
                if !self.is_positive(least) {
                    tell(Event::Falls(self.root([a, least])?));
                    tell(Event::Rises(self.root([b, least])?));
                } else if self.zero.ge(least.value) {
                    tell(Event::Touches(least.x));
                }
            }
            (false, false) => {
                let Some(most) = self.turn([a, b], number(-1.0))? else { return Ok(()) };
                if most.value.gt(self.zero) {
                    tell(Event::Rises(self.root([most, a])?));
                    tell(Event::Falls(self.root([most, b])?));
                }
            }
        }
        Ok(())
    }

    /// The end of a piece that counts as positive; where it is zero to rounding and the function goes up
    /// from it and down to the other end, the top of that hump: the zero at the end is another one.
    fn top(&mut self, ends: [At<T>; 2], end: At<T>) -> Result<At<T>, FindError> {
        if end.value.gt(self.zero) {
            return Ok(end);
        }
        let most = self.turn(ends, number(-1.0))?;
        Ok(most.filter(|most| most.value.gt(self.zero)).unwrap_or(end))
    }

    /// The root between a value that counts as positive and one that does not.
    fn root(&mut self, [positive, negative]: [At<T>; 2]) -> Result<T, FindError> {
        if positive.value.gt(number(0.0)) {
            return crossing(in_order([positive, negative]), &mut self.f);
        }
        // Zero to rounding: the root is here, as near as the slope can tell.
        let step = -positive.value / positive.slope;
        if !magnitude(negative.x - positive.x).ge(magnitude(step)) {
            return Ok(self.differentiated(positive.x));
        }
        // Where a parabola of this value and slope has roots, it is above zero behind twice the step.
        let behind = positive.x + step + step;
        let [from, to] = self.ends;
        if step.value() != 0.0 && behind.ge(from) && to.ge(behind) {
            let behind = self.at(behind)?;
            if behind.value.gt(number(0.0)) {
                return crossing(in_order([behind, positive]), &mut self.f);
            }
        }
        Ok(self.differentiated(less(greater(positive.x + step, from), to)))
    }

    /// A root with the derivatives that f's numbers carry; without where it has none.
    fn differentiated(&mut self, at: T) -> T {
        differentiated(at, &mut self.f).unwrap_or(at)
    }

    /// The lowest point of a dip (`sign` 1) or the highest of a hump (−1), if there is one between
    /// two places that comes near zero: at most to where it is beyond zero for certain.
    fn turn(&mut self, ends: [At<T>; 2], sign: T) -> Result<Option<At<T>>, FindError> {
        let turned = |at: At<T>| At { value: sign * at.value, slope: sign * at.slope, ..at };
        let [a, b] = ends.map(turned);
        let none = number::<T>(0.0);
        if !(none.gt(a.slope) && b.slope.ge(none)) {
            return Ok(None);
        }
        let nearer = if a.value.gt(b.value) { b.value } else { a.value };
        let cubic = Cubic::through([a, b]);
        if cubic.at(cubic.turning_part()).gt(nearer * number(NEAR) + self.zero) {
            return Ok(None);
        }
        let floor = -self.zero;
        let found = lowest([a, b], floor, u32::MAX, &mut |x| self.at(x).map(turned))?;
        Ok(Some(turned(found)))
    }
}

/// A dip is followed if its cubic comes below this part of the lower end: a cubic that meets the
/// value in the middle of a panel to one part in a hundred is not wrong by more than that.
const NEAR: f64 = 0.15;

fn in_order<T: Real>([a, b]: [At<T>; 2]) -> [At<T>; 2] {
    if b.x.gt(a.x) { [a, b] } else { [b, a] }
}

fn half_way<T: Real>(a: T, b: T) -> T {
    a + (b - a) * number(0.5)
}

/// True if the cubic of the ends meets the value in the middle: to a quarter of the smallest of
/// the three, or to one part in a hundred of the largest.
fn is_cubic<T: Real>(a: At<T>, middle: At<T>, b: At<T>) -> bool {
    let error = magnitude(Cubic::through([a, b]).at(number(0.5)) - middle.value);
    let [x, y, z] = [a, middle, b].map(|at| magnitude(at.value));
    let least = if x.gt(y) { y } else { x };
    let least = if least.gt(z) { z } else { least };
    let most = greater(greater(x, y), z);
    (least * number(0.25)).ge(error) || (most * number(0.01)).ge(error)
}
