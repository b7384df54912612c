//! Over which angles a crank turns: what the dimensions of a dyad of constants say before anything
//! is solved.

use std::collections::HashMap;

use crate::exact::Exact;
use crate::reach::absolute;
use crate::reach::line::Line;
use crate::reach::turn::{Range, Turn};

use super::Resolver;
use super::assembly::constants;
use super::folding::shown;
use super::mechanism::{
    AngleSum, Carrier, Expr, Group, GroupId, GuideDirection, GuideId, InputId, LinkId, Mechanism,
    Point, PointId, Rotatability, Step, Through,
};

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
        let is_parallelogram =
            lengths[0].cmp_value(&ground).is_eq() && lengths[1].cmp_value(self.radius).is_eq();
        let turn = Turn::of_two_bars(self.radius, &[dx, dy], lengths);
        let Self { link, input, .. } = *self;
        Rotatability { group, crank: link, input, turn, is_parallelogram, reason }
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
        let Self { link, input, .. } = *self;
        Rotatability {
            group,
            crank: link,
            input,
            turn: Turn::of_bar_and_block(self.radius, &pivot, &line.angle, length),
            is_parallelogram: false,
            reason,
        }
    }
}

impl Resolver<'_> {
    /// A dyad on a crank can be assembled at some angle of the crank.
    pub(super) fn cranks_can_turn(&mut self) {
        let never = |found: &&Rotatability| found.turn.range == Range::Never;
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
