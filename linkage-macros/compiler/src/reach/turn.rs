//! Over which angles a crank turns.
//!
//! A crank of radius r on the ground takes its pin B to A + r (cos φ, sin φ). A dyad that joins B
//! to the ground assembles as long as one quantity of φ stays between two limits, and in both
//! cases that quantity is linear in one cosine:
//!
//! - rrr on D, with g = |AD| and β the direction from A to D: |BD|² = r² + g² − 2 r g cos(φ − β)
//!   lies between (l₁ − l₂)² and (l₁ + l₂)². With all links turning fully this is Grashof's law.
//! - rrp on a line along γ, from which A is h off: B is h + r sin(φ − γ) = h + r cos(φ − γ − 90°)
//!   off the line, by no more than the bar's length.
//!
//! So cos(φ − axis) has to lie between two constants, which are compared with ±1 exactly: whether
//! a crank just turns is not left to rounding.

use super::{absolute, squared};
use crate::exact::Exact;

/// The part of a turn over which a dyad on a crank can be assembled.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    pub range: Range,
    /// The angles, in degrees, at which both assembly modes are one while the crank passes.
    pub change_points: Vec<f64>,
}

/// The angles of a crank at which a dyad assembles, in degrees.
#[derive(Clone, Debug, PartialEq)]
pub enum Range {
    Full,
    /// From, to: one interval, or two that the crank cannot leave for each other.
    Within(Vec<[f64; 2]>),
    Never,
}

/// An angle in degrees, to a hundredth.
pub(crate) fn degrees(angle: f64) -> String {
    let hundredths = (angle * 100.0).round() / 100.0;
    // Adding zero takes the sign off minus zero.
    format!("{}°", hundredths + 0.0)
}

impl Turn {
    /// Two bars between the pin of a crank of this radius and a point of the ground, that far from
    /// the crank's pivot.
    pub fn of_two_bars(radius: &Exact, [dx, dy]: &[Exact; 2], lengths: [&Exact; 2]) -> Self {
        let ground = dx.hypot(dy);
        let (sum, difference) = (lengths[0].add(lengths[1]), absolute(&lengths[0].sub(lengths[1])));
        let both = squared(radius).add(&squared(&ground));
        let scale = radius.mul(&ground).mul(&Exact::integer(2));
        let cosine = |reach: &Exact| both.sub(&squared(reach)).div(&scale);
        match cosine(&sum).zip(cosine(&difference)).zip(dy.atan2(dx)) {
            Some(((low, high), axis)) => Limits { low, high, axis }.turn(),
            // Pivot and joint are one point: the distance is the radius, whatever the angle.
            None if radius.cmp_value(&sum).is_le() && radius.cmp_value(&difference).is_ge() => {
                Self { range: Range::Full, change_points: Vec::new() }
            }
            None => Self { range: Range::Never, change_points: Vec::new() },
        }
    }

    /// A bar between the pin of a crank of this radius and a line in this direction, from which the
    /// pivot is that far off.
    pub(crate) fn of_bar_and_block(
        radius: &Exact,
        pivot: &Exact,
        direction: &Exact,
        length: &Exact,
    ) -> Self {
        let cosine = |off: &Exact| off.sub(pivot).div(radius).expect("a crank has a length");
        let quarter = Exact::pi().div(&Exact::integer(2)).expect("two is not zero");
        let axis = direction.add(&quarter);
        Limits { low: cosine(&length.neg()), high: cosine(length), axis }.turn()
    }
}

/// cos(φ − axis) lies between the two.
struct Limits {
    low: Exact,
    high: Exact,
    axis: Exact,
}

impl Limits {
    fn turn(&self) -> Turn {
        Turn { range: self.range(), change_points: self.change_points() }
    }

    fn range(&self) -> Range {
        let one = Exact::integer(1);
        let [low, high] = [&self.low, &self.high].map(|limit| limit.cmp_value(&one.neg()));
        let [low_to_one, high_to_one] = [&self.low, &self.high].map(|limit| limit.cmp_value(&one));
        if high.is_lt() || low_to_one.is_gt() {
            return Range::Never;
        }
        // An arc cosine in double precision is good for the digits that are shown.
        let angle = |cosine: &Exact| cosine.to_f64().clamp(-1.0, 1.0).acos().to_degrees();
        let axis = self.axis.to_f64().to_degrees();
        let intervals = match (high_to_one.is_lt(), low.is_gt()) {
            (false, false) => return Range::Full,
            (true, false) => {
                let nearest = angle(&self.high);
                vec![[axis + nearest, axis + 360.0 - nearest]]
            }
            (false, true) => {
                let farthest = angle(&self.low);
                vec![[axis - farthest, axis + farthest]]
            }
            (true, true) => {
                let (nearest, farthest) = (angle(&self.high), angle(&self.low));
                vec![[axis - farthest, axis - nearest], [axis + nearest, axis + farthest]]
            }
        };
        Range::Within(intervals.into_iter().map(from_half_turn).collect())
    }

    /// Where the cosine touches a limit without passing it.
    fn change_points(&self) -> Vec<f64> {
        let one = Exact::integer(1);
        let axis = self.axis.to_f64().to_degrees();
        let mut angles = Vec::new();
        if self.high.cmp_value(&one).is_eq() {
            angles.push(from_half_turn([axis, axis])[0]);
        }
        if self.low.cmp_value(&one.neg()).is_eq() {
            angles.push(from_half_turn([axis + 180.0, axis])[0]);
        }
        angles
    }
}

/// The interval with its start in (−180°, 180°].
fn from_half_turn([from, to]: [f64; 2]) -> [f64; 2] {
    // An angle shown as −180° becomes 180°.
    let turns = ((from + 180.0 - 1e-9) / 360.0).floor() * 360.0;
    [from - turns, to - turns]
}
