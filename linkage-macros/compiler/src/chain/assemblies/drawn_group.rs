//! A pinned group with the places of its drawing: its closures enclosed, and those of one mode in plain numbers.

use super::circle::OnCircle;
use super::closure::{Algebra, Twin, closure};
use super::degree::ClosureDegree;
use super::disc::Disc;
use super::pinned::{BodyPin, PinnedGroup, STANDING, TURNED};
use crate::chain::plane::Complex;

/// The part of a bar's length, squared, within which a dyad is not said to fail.
const ROUNDING: f64 = 1e-9;

/// The sides of the dyads, a bit each: set where the inner pin is on the left of the way from the first outer pin to the second.
pub(super) type DyadSides = usize;

pub(super) struct DrawnGroup<'g> {
    pub group: &'g PinnedGroup,
    pub degree: &'g ClosureDegree,
    /// By pin of the machine, in a unit in which it is about one.
    pub pins: &'g [Complex],
    /// The pins of the link that was left out, whose distance is the equation.
    pub left_out: [Complex; 2],
}

impl DrawnGroup<'_> {
    pub(super) fn modes(&self) -> usize {
        1 << self.group.dyads.len()
    }

    /// The sides on which the dyads are drawn.
    pub(super) fn drawn(&self) -> DyadSides {
        let side = |(index, dyad): (usize, &super::pinned::PinnedDyad)| {
            let [from, to] = dyad.bars.map(|bar| self.pins[bar.outer.pin]);
            let is_left = (to - from).cross(self.pins[dyad.inner] - from) > 0.0;
            usize::from(is_left) << index
        };
        self.group.dyads.iter().enumerate().map(side).sum()
    }

    /// The equation of one mode, turned by an angle from the drawing; `None` where a dyad does not assemble.
    pub(super) fn missed(&self, angle: f64, sides: DyadSides) -> Option<f64> {
        let turn = Complex::turned(angle);
        let mut plain = Plain { of: self, turn, sides, assembles: true };
        let missed = closure(self.group, &mut plain, |_, _| {}).x;
        (plain.assembles && missed.is_finite()).then_some(missed)
    }
}

impl OnCircle for DrawnGroup<'_> {
    /// The product over all modes, with the powers of the bases.
    fn value(&self, turn: Disc) -> Disc {
        let mut all = Disc::exact(1.0, 0.0);
        for sides in 0..self.modes() {
            let mut enclosed = Enclosed { of: self, turn, sides };
            let mut bases = all;
            let missed = closure(self.group, &mut enclosed, |index, base| {
                // A base depends on the sides of the dyads before it alone.
                if sides >> index == 0 {
                    bases = (0..self.degree.powers[index]).fold(bases, |all, _| all.times(*base));
                }
            });
            all = bases.times(missed);
        }
        all
    }

    /// True where a dyad on the turned body and on what stands still does not assemble: its base is longer than both bars, or shorter
    /// than their difference, by more than the base can change.
    fn has_none(&self, angle: f64, within: f64) -> bool {
        self.group.dyads.iter().any(|dyad| {
            let hosts = dyad.bars.map(|bar| bar.outer);
            let [turned, standing] = match hosts.map(|host| host.body) {
                [TURNED, STANDING] => hosts,
                [STANDING, TURNED] => [hosts[1], hosts[0]],
                _ => return false,
            };
            let pivot = self.pins[self.group.pivot];
            let [arm, far] = [turned, standing].map(|host| self.pins[host.pin] - pivot);
            let base = Complex::turned(angle) * arm - far;
            let square = base.dot(base);
            let change = 2.0 * arm.length() * far.length() * within;
            let bars =
                dyad.bars.map(|bar| (self.pins[dyad.inner] - self.pins[bar.outer.pin]).length());
            let [sum, difference] =
                [bars[0] + bars[1], bars[0] - bars[1]].map(|length| length * length);
            let room = ROUNDING * (square + sum + change);
            square - change > sum + room || square + change < difference - room
        })
    }
}

/// A closure whose numbers hold its roundings.
struct Enclosed<'g> {
    of: &'g DrawnGroup<'g>,
    turn: Disc,
    /// The sides of the dyads that are not placed yet.
    sides: DyadSides,
}

fn twin(place: Complex) -> Twin<Disc> {
    let place = Disc::exact(place.x, place.y);
    [place, place.conjugate()]
}

impl Algebra for Enclosed<'_> {
    type Number = Disc;

    fn plus(&self, a: &Disc, b: &Disc) -> Disc {
        a.plus(*b)
    }

    fn minus(&self, a: &Disc, b: &Disc) -> Disc {
        a.minus(*b)
    }

    fn times(&self, a: &Disc, b: &Disc) -> Disc {
        a.times(*b)
    }

    fn inverse(&self, a: &Disc) -> Disc {
        a.inverse()
    }

    fn root(&mut self, square: Disc) -> Disc {
        let is_set = self.sides & 1 == 1;
        self.sides >>= 1;
        let root = square.root();
        if is_set { root } else { root.negative() }
    }

    fn place(&self, at: BodyPin) -> Twin<Disc> {
        twin(self.of.pins[at.pin])
    }

    fn turn(&self) -> Twin<Disc> {
        [self.turn, self.turn.conjugate()]
    }

    fn left_out(&self) -> Twin<Disc> {
        let [from, to] = self.of.left_out.map(twin);
        [to[0].minus(from[0]), to[1].minus(from[1])]
    }
}

/// A closure of one mode where all dyads assemble.
struct Plain<'g> {
    of: &'g DrawnGroup<'g>,
    turn: Complex,
    sides: DyadSides,
    assembles: bool,
}

impl Algebra for Plain<'_> {
    type Number = Complex;

    fn plus(&self, a: &Complex, b: &Complex) -> Complex {
        *a + *b
    }

    fn minus(&self, a: &Complex, b: &Complex) -> Complex {
        *a - *b
    }

    fn times(&self, a: &Complex, b: &Complex) -> Complex {
        *a * *b
    }

    fn inverse(&self, a: &Complex) -> Complex {
        a.conjugate().times(1.0 / a.dot(*a))
    }

    fn root(&mut self, square: Complex) -> Complex {
        let sign = if self.sides & 1 == 1 { 1.0 } else { -1.0 };
        self.sides >>= 1;
        self.assembles &= square.x <= 0.0;
        Complex::new(0.0, sign * (-square.x).max(0.0).sqrt())
    }

    fn place(&self, at: BodyPin) -> Twin<Complex> {
        let place = self.of.pins[at.pin];
        [place, place.conjugate()]
    }

    fn turn(&self) -> Twin<Complex> {
        [self.turn, self.turn.conjugate()]
    }

    fn left_out(&self) -> Twin<Complex> {
        let way = self.of.left_out[1] - self.of.left_out[0];
        [way, way.conjugate()]
    }
}
