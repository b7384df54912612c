//! The real zeros of a trigonometric polynomial of known degree around the circle, each proved to be single.
//!
//! A half of the circle is z = ±z₀ (1 + i t)/(1 − i t), −1 ≤ t ≤ 1. Times (1 + t²)ⁿ a trigonometric polynomial of degree n is one
//! of degree 2n in t there, and as many values and one more are all of it. A piece of a half either tells its zeros or
//! is divided, and both parts are looked at anew: the values of a polynomial vary over many decades around the circle.

use core::f64::consts::{PI, TAU};

use libm::{atan, floor};

use crate::MOST_DEGREE;
use crate::chebyshev::{Nodes, ZerosFound};
use crate::disc::Disc;
use crate::listed::Outcome;

/// The first ends of pieces: no number of a drawing.
const ENDS: [f64; 5] = [-1.0, -0.421_875, 0.015_625, 0.406_25, 1.0];
/// The part of a piece at which it is divided: beside its middle, where a drawing has its symmetries.
const DIVIDED_AT: f64 = 0.515_625;
/// The shortest piece that is divided, in half an angle.
const SHORTEST: f64 = 1e-8;
/// The count of pieces that tell nothing behind which the search ends.
const UNTOLD: usize = 16;
/// The most pieces that wait at once: each that is divided leaves one waiting, and none is divided thirty times.
const WAITING: usize = 64;

/// The most that is spent on a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Values of the product over all modes.
    pub samples: u32,
    /// Pieces of the circle that are looked at.
    pub pieces: u32,
}

impl Default for Budget {
    /// More than a group of random lengths needs: a triad takes 200 samples as a rule and 2,000 at most, and nine links 28,000 at most.
    fn default() -> Self {
        Self { samples: 40_000, pieces: 4_000 }
    }
}

/// The part of the circle that is settled, and what was spent on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Searched {
    /// The part that is proved.
    pub outcome: Outcome,
    /// Values that were computed.
    pub samples: u32,
    /// Pieces that were looked at.
    pub pieces: u32,
}

/// The function whose zeros are searched.
pub trait OnCircle {
    /// Its value at a point of the circle.
    fn value(&self, turn: Disc) -> Disc;
    /// True if it has no zero as near to an angle.
    fn has_none(&self, angle: f64, within: f64) -> bool;
}

/// A part of one half of the circle.
#[derive(Clone, Copy)]
struct Piece {
    is_opposite: bool,
    ends: [f64; 2],
}

/// The angle from which halves of the circle are counted.
#[derive(Clone, Copy)]
pub struct CircleOrigin {
    /// The tangent of half of it.
    pub tangent: f64,
}

impl CircleOrigin {
    /// A point of the circle, from the tangent of half the angle between.
    fn turn(self, is_opposite: bool, tangent: Disc) -> Disc {
        let turn = unit(tangent).times(unit(Disc::exact(self.tangent, 0.0)));
        if is_opposite { turn.negative() } else { turn }
    }

    fn angle(self, is_opposite: bool, tangent: f64) -> f64 {
        2.0 * (atan(tangent) + atan(self.tangent)) + if is_opposite { PI } else { 0.0 }
    }
}

/// (1 + i t)/(1 − i t) of a real t.
fn unit(tangent: Disc) -> Disc {
    let [one, i] = [Disc::exact(1.0, 0.0), Disc::exact(0.0, 1.0)];
    let half = one.plus(i.times(tangent));
    half.times(half).times(one.plus(tangent.times(tangent)).inverse())
}

/// Finds all zeros of a trigonometric polynomial of degree `half`, and hands over two angles about each, in ascending order but for
/// the first turn.
pub fn zeros(
    of: &impl OnCircle,
    (half, origin): (usize, CircleOrigin),
    budget: Budget,
    mut found: impl FnMut([f64; 2]),
) -> Searched {
    let nodes = Nodes::of(2 * half.min(MOST_DEGREE) + 1);
    let mut search = Search { budget, samples: 0, pieces: 0, untold: Untold::default() };
    for is_opposite in [false, true] {
        for ends in ENDS.windows(2) {
            let mut waiting = [Piece { is_opposite, ends: [ends[0], ends[1]] }; WAITING];
            let mut count = 1;
            while count > 0 {
                count -= 1;
                let piece = waiting[count];
                if !search.begins_piece() {
                    return search.ended(Outcome::OutOfBudget);
                }
                if piece.has_none(of, origin) {
                    continue;
                }
                if !search.takes_samples(nodes.count) {
                    return search.ended(Outcome::OutOfBudget);
                }
                match piece.zeros(of, origin, &nodes) {
                    ZerosFound::None => {}
                    ZerosFound::One(ends) => found(piece.angles(origin, ends)),
                    ZerosFound::Unknown if !piece.is_short() && count + 2 <= WAITING => {
                        [waiting[count + 1], waiting[count]] = piece.divided();
                        count += 2;
                    }
                    ZerosFound::Unknown => {
                        search.untold.add(piece.angles(origin, piece.ends));
                        if search.untold.pieces == UNTOLD {
                            return search.ended(Outcome::Proved);
                        }
                    }
                }
            }
        }
    }
    search.ended(Outcome::Proved)
}

/// A search under way.
struct Search {
    budget: Budget,
    samples: u32,
    pieces: u32,
    untold: Untold,
}

impl Search {
    /// False where no piece is left.
    fn begins_piece(&mut self) -> bool {
        let is_left = self.pieces < self.budget.pieces;
        self.pieces += u32::from(is_left);
        is_left
    }

    /// False where not so many samples are left.
    fn takes_samples(&mut self, count: usize) -> bool {
        let is_left = (self.budget.samples - self.samples) as usize >= count;
        self.samples += if is_left { count as u32 } else { 0 };
        is_left
    }

    /// An end of the search: what is not told goes before a lack of budget.
    fn ended(&self, otherwise: Outcome) -> Searched {
        let outcome = self.untold.outcome(otherwise);
        Searched { outcome, samples: self.samples, pieces: self.pieces }
    }
}

/// The pieces that tell nothing: their count, and the first with what follows it at once.
#[derive(Default)]
struct Untold {
    pieces: usize,
    first: Option<[f64; 2]>,
}

impl Untold {
    fn add(&mut self, next: [f64; 2]) {
        self.pieces += 1;
        self.first = Some(match self.first {
            Some([from, to]) if (next[0] - to).abs() < 2.0 * SHORTEST => [from, next[1]],
            Some(first) => first,
            None => next,
        });
    }

    fn outcome(&self, otherwise: Outcome) -> Outcome {
        self.first.map_or(otherwise, |[from, to]| Outcome::Open { from, to })
    }
}

impl Piece {
    fn is_short(&self) -> bool {
        self.ends[1] - self.ends[0] < SHORTEST
    }

    fn divided(&self) -> [Self; 2] {
        let [from, to] = self.ends;
        let between = from + (to - from) * DIVIDED_AT;
        [[from, between], [between, to]].map(|ends| Self { ends, ..*self })
    }

    fn angles(&self, origin: CircleOrigin, ends: [f64; 2]) -> [f64; 2] {
        let ends = ends.map(|end| origin.angle(self.is_opposite, end));
        let turns = floor((ends[0] + PI) / TAU);
        ends.map(|end| end - turns * TAU)
    }

    /// The tangent at a node of the piece, which is off by ten units of a cosine and by four of the greater end at most.
    fn tangent(&self, at: f64) -> Disc {
        let [from, to] = self.ends;
        let x = (from + to) / 2.0 + (to - from) / 2.0 * at;
        Disc { x, y: 0.0, radius: 16.0 * f64::EPSILON * from.abs().max(to.abs()) }
    }

    /// True if the function is known to have none here.
    fn has_none(&self, of: &impl OnCircle, origin: CircleOrigin) -> bool {
        let [from, to] = self.ends.map(|end| origin.angle(self.is_opposite, end));
        of.has_none((from + to) / 2.0, (to - from) / 2.0)
    }

    /// The zeros in the piece, between tangents.
    fn zeros(&self, of: &impl OnCircle, origin: CircleOrigin, nodes: &Nodes) -> ZerosFound {
        let (mut values, mut radius) = (Nodes::no_values(), 0.0_f64);
        for (index, to) in values.iter_mut().enumerate().take(nodes.count) {
            let tangent = self.tangent(nodes.node(index));
            let square = Disc::exact(1.0, 0.0).plus(tangent.times(tangent));
            let value = of.value(origin.turn(self.is_opposite, tangent));
            let value = (0..nodes.count / 2).fold(value, |value, _| value.times(square));
            *to = value.x;
            // A radius that is no number stays one.
            radius = if radius.is_nan() || value.radius <= radius { radius } else { value.radius };
        }
        match nodes.polynomial(&values, radius).zeros() {
            ZerosFound::One(ends) => ZerosFound::One(ends.map(|at| self.tangent(at).x)),
            told @ (ZerosFound::None | ZerosFound::Unknown) => told,
        }
    }
}
