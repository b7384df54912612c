//! Over which angles a crank turns: what the dimensions of a dyad of constants say before anything
//! is solved.
//!
//! A crank of radius r on the ground takes its pin B to A + r (cos φ, sin φ). A dyad that joins B
//! to the ground assembles as long as one quantity of φ stays between two limits, and in both
//! cases that quantity is linear in one cosine:
//!
//! - rrr on D, with g = |AD| and β the direction from A to D: |BD|² = r² + g² − 2 r g cos(φ − β)
//!   lies between (l₁ − l₂)² and (l₁ + l₂)². With all links rotatability fully this is Grashof's law.
//! - rrp on a line along γ, from which A is h off: B is h + r sin(φ − γ) = h + r cos(φ − γ − 90°)
//!   off the line, by no more than the bar's length.
//!
//! So cos(φ − axis) has to lie between two constants, which are compared with ±1 exactly: whether
//! a crank just turns is not left to rounding.

use std::collections::HashMap;

use crate::exact::Exact;

use super::Resolver;
use super::assembly::{absolute, constants};
use super::facts::Line;
use super::folding::shown;
use super::mechanism::{
    AngleSum, Carrier, Expr, Group, GroupId, GuideDirection, GuideId, InputId, LinkId, Mechanism,
    Point, PointId, Range, Rotatability, Step, Through,
};

/// cos(φ − axis) lies between the two.
struct Limits {
    low: Exact,
    high: Exact,
    axis: Exact,
}

impl Limits {
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
    // What is shown as −180° is a half turn as well.
    let turns = ((from + 180.0 - 1e-9) / 360.0).floor() * 360.0;
    [from - turns, to - turns]
}

/// A crank on the ground: its circle and what turns it.
struct Crank<'m> {
    link: LinkId,
    pivot: &'m [Exact; 2],
    radius: &'m Exact,
    input: Option<InputId>,
    name: PointId,
}

/// What stands still, and what turns on it.
#[derive(Default)]
struct Ground<'m> {
    points: HashMap<PointId, [Exact; 2]>,
    guides: HashMap<GuideId, Line>,
    cranks: HashMap<PointId, Crank<'m>>,
}

/// Every dyad of constants between a crank and the ground.
pub(super) fn rotatabilities(mechanism: &Mechanism) -> Vec<Rotatability> {
    let mut ground = Ground::default();
    for step in &mechanism.steps {
        if let Step::Ground { point, at } = step
            && let Some(at) = constants(at)
        {
            ground.points.insert(*point, at);
        }
    }
    let still = ground.points.clone();
    let mut rotatabilities = Vec::new();
    for step in &mechanism.steps {
        ground.learn(&still, step);
        rotatabilities.extend(ground.rotatability(mechanism, step));
    }
    rotatabilities
}

impl<'m> Ground<'m> {
    fn learn(&mut self, still: &'m HashMap<PointId, [Exact; 2]>, step: &'m Step) {
        match step {
            Step::Guide { guide, carrier: Carrier::Ground, through, course } => {
                let line = line(still, through, course);
                self.guides.extend(line.map(|line| (*guide, line)));
            }
            Step::Crank { link, pivot, pin, angle, relative_to: Carrier::Ground, .. } => {
                let radius = pin.as_ref().and_then(|(pin, r)| Some((*pin, r.value.constant()?)));
                if let (Some(pivot), Some((pin, radius))) = (still.get(pivot), radius)
                    && angle.constant().is_none()
                    && angle.links.is_empty()
                {
                    let input = match angle.rest {
                        Expr::Input(input) => Some(input),
                        _ => None,
                    };
                    let crank = Crank { link: *link, pivot, radius, input, name: pin };
                    self.cranks.insert(pin, crank);
                }
            }
            _ => {}
        }
    }

    fn rotatability(&self, mechanism: &Mechanism, step: &Step) -> Option<Rotatability> {
        match step {
            Step::Rrr { group, outer, lengths, .. } => {
                let lengths = [lengths[0].value.constant()?, lengths[1].value.constant()?];
                let near = usize::from(!self.cranks.contains_key(&outer[0]));
                let (crank, far) = (self.cranks.get(&outer[near])?, outer[1 - near]);
                let at = self.points.get(&far)?;
                let lengths = [lengths[near], lengths[1 - near]];
                let span = span(mechanism, crank.name, far);
                Some(crank.with_two_bars(*group, at, lengths, &span))
            }
            Step::Rrp { group, outer, guide, length, offset, .. } => {
                let (length, offset) = (length.value.constant()?, offset.constant()?);
                let (crank, line) = (self.cranks.get(outer)?, self.guides.get(guide)?);
                let pin = &mechanism.points[crank.name.index()].name;
                Some(crank.with_bar_and_block(*group, line, length, offset, &pin.to_string()))
            }
            _ => None,
        }
    }
}

fn line(
    points: &HashMap<PointId, [Exact; 2]>,
    through: &Through,
    course: &GuideDirection,
) -> Option<Line> {
    let through = match through {
        Through::At(at) => constants(at)?,
        Through::Point(point) => points.get(point)?.clone(),
    };
    let angle = match course {
        GuideDirection::Along(turn) => AngleSum::constant(turn)?.clone(),
        GuideDirection::Towards(point) => {
            let [x, y] = points.get(point)?;
            y.sub(&through[1]).atan2(&x.sub(&through[0]))?
        }
    };
    Some(Line { through, angle })
}

/// |BD|
fn span(mechanism: &Mechanism, from: PointId, to: PointId) -> String {
    let name = |point: PointId| -> &Point { &mechanism.points[point.index()] };
    format!("|{}{}|", name(from).name, name(to).name)
}

fn squared(value: &Exact) -> Exact {
    value.mul(value)
}

impl Crank<'_> {
    /// The second bar stands on the ground.
    fn with_two_bars(
        &self,
        group: GroupId,
        [x, y]: &[Exact; 2],
        lengths: [&Exact; 2],
        span: &str,
    ) -> Rotatability {
        let (dx, dy) = (x.sub(&self.pivot[0]), y.sub(&self.pivot[1]));
        let ground = dx.hypot(&dy);
        let (sum, difference) = (lengths[0].add(lengths[1]), absolute(&lengths[0].sub(lengths[1])));
        let least = absolute(&self.radius.sub(&ground));
        let reason = format!(
            "{span} runs from {} m to {} m, and the bars reach from {} m to {} m",
            shown(&least),
            shown(&self.radius.add(&ground)),
            shown(&difference),
            shown(&sum),
        );
        let both = squared(self.radius).add(&squared(&ground));
        let scale = self.radius.mul(&ground).mul(&Exact::integer(2));
        let cosine = |reach: &Exact| both.sub(&squared(reach)).div(&scale);
        let limits = cosine(&sum).zip(cosine(&difference)).zip(dy.atan2(&dx));
        let is_parallelogram =
            lengths[0].cmp_value(&ground).is_eq() && lengths[1].cmp_value(self.radius).is_eq();
        let (range, change_points) = match limits {
            Some(((low, high), axis)) => {
                let limits = Limits { low, high, axis };
                (limits.range(), limits.change_points())
            }
            // Pivot and joint are one point: the distance is the radius, whatever the angle.
            None if self.radius.cmp_value(&sum).is_le()
                && self.radius.cmp_value(&difference).is_ge() =>
            {
                (Range::Full, Vec::new())
            }
            None => (Range::Never, Vec::new()),
        };
        let Self { link, input, .. } = *self;
        Rotatability { group, crank: link, input, range, change_points, is_parallelogram, reason }
    }

    /// The bar's other pin slides on the line.
    fn with_bar_and_block(
        &self,
        group: GroupId,
        line: &Line,
        length: &Exact,
        offset: &Exact,
        pin: &str,
    ) -> Rotatability {
        let pivot = line.distance(self.pivot).sub(offset);
        let reason = format!(
            "{pin} runs from {} m to {} m off the line of the pin, and the bar reaches {} m",
            shown(&pivot.sub(self.radius)),
            shown(&pivot.add(self.radius)),
            shown(length),
        );
        let cosine = |off: &Exact| off.sub(&pivot).div(self.radius).expect("a crank has a length");
        let quarter = Exact::pi().div(&Exact::integer(2)).expect("two is not zero");
        let axis = line.angle.add(&quarter);
        let limits = Limits { low: cosine(&length.neg()), high: cosine(length), axis };
        let Self { link, input, .. } = *self;
        Rotatability {
            group,
            crank: link,
            input,
            range: limits.range(),
            change_points: limits.change_points(),
            is_parallelogram: false,
            reason,
        }
    }
}

impl Resolver<'_> {
    /// A dyad on a crank can be assembled at some angle of the crank.
    pub(super) fn cranks_can_turn(&mut self) {
        let never = |found: &&Rotatability| found.range == Range::Never;
        for found in self.mechanism.rotatabilities.iter().filter(never) {
            let Group { keyword, title, .. } = &self.mechanism.groups[found.group.index()];
            let crank = &self.mechanism.links[found.crank.index()].name;
            let message = format!(
                "`{title}` cannot be assembled at any angle of `{crank}`; change its dimensions"
            );
            self.diagnostics.error_because(keyword.span(), message, &found.reason);
        }
    }
}
