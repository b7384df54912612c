//! Over which angles a crank turns: what the dimensions of a dyad of constants say before anything
//! is solved.

use std::collections::{HashMap, HashSet};

use crate::exact::Exact;
use crate::reach::absolute;
use crate::reach::line::BodyLine;
use crate::reach::turn::{Range, Turn, degrees};

use super::assembly::{constants, span_of};
use super::folding::shown;
use super::mechanism::{
    AngleSum, Carrier, Drive, Group, GroupId, GroupName, GuideDirection, GuideId, InputId, LinkId,
    Mechanism, Mode, PointId, Rotatability, Scalar, Step, Through,
};
use super::scope::Scope;
use super::touching::in_words;

/// A crank on the ground: its circle and what turns it.
struct TurningCrank<'m> {
    link: LinkId,
    pivot: &'m [Exact; 2],
    radius: &'m Exact,
    input: Option<InputId>,
    name: PointId,
}

/// The fixed points and guides, and the cranks that turn on them.
#[derive(Default)]
struct Ground<'m> {
    points: HashMap<PointId, [Exact; 2]>,
    guides: HashMap<GuideId, BodyLine>,
    cranks: HashMap<PointId, TurningCrank<'m>>,
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
            Step::Group(group) => self.cranks.extend(crank(still, group)),
            _ => {}
        }
    }

    /// The rotatability of a bar that hangs on a crank, with another bar or a block on the ground.
    fn rotatability(&self, mechanism: &Mechanism, step: &Step) -> Option<Rotatability> {
        let Step::Group(group @ Group { id, outer, lengths, pin: Some(_), .. }) = step else {
            return None;
        };
        if group.opposite().is_some() {
            // It assembles everywhere.
            return None;
        }
        let constant = |index: usize| lengths.get(index)?.as_ref()?.value.constant();
        match &outer[..] {
            [first, second] if second.guide().is_none() => {
                let (outer, lengths) =
                    ([first.point()?, second.point()?], [constant(0)?, constant(1)?]);
                let near = usize::from(!self.cranks.contains_key(&outer[0]));
                let (crank, far) = (self.cranks.get(&outer[near])?, outer[1 - near]);
                let at = self.points.get(&far)?;
                let lengths = [lengths[near], lengths[1 - near]];
                let span = span_of(mechanism, [crank.name, far]);
                Some(crank.with_two_bars(*id, at, lengths, &span))
            }
            [first, second] => {
                let (length, offset) = (constant(0)?, second.offset()?.constant()?);
                let line = self.guides.get(&group.slides_on(1))?;
                let crank = self.cranks.get(&first.point()?)?;
                let pin = &mechanism.points[crank.name.index()].name;
                Some(crank.with_bar_and_block(*id, line, length, offset, &pin.to_string()))
            }
            _ => None,
        }
    }
}

/// The group as a crank on the ground that turns, by its pin.
fn crank<'m>(
    still: &'m HashMap<PointId, [Exact; 2]>,
    group: &'m Group,
) -> Option<(PointId, TurningCrank<'m>)> {
    let joint = group.outer.first()?;
    let Some(Drive::Angle { angle, relative_to: Carrier::Ground }) = &joint.drive else {
        return None;
    };
    let (pin, radius) = (group.pin?, group.lengths[0].as_ref()?.value.constant()?);
    let pivot = still.get(&joint.point()?)?;
    if angle.constant().is_some() || !angle.links.is_empty() {
        return None;
    }
    let input = match angle.rest {
        Scalar::Input(input) => Some(input),
        _ => None,
    };
    Some((pin, TurningCrank { link: group.links[0], pivot, radius, input, name: pin }))
}

fn line(
    points: &HashMap<PointId, [Exact; 2]>,
    through: &Through,
    course: &GuideDirection,
) -> Option<BodyLine> {
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
    Some(BodyLine { through, angle })
}

impl TurningCrank<'_> {
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
        line: &BodyLine,
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

/// A dyad on a crank can be assembled at some angle of the crank.
pub(super) fn cranks_can_turn(scope: &mut Scope<'_>) {
    let never = |found: &&Rotatability| found.turn.range == Range::Never;
    for found in scope.mechanism.rotatabilities.iter().filter(never) {
        let GroupName { keyword, title, .. } = &scope.mechanism.groups[found.group.index()];
        let crank = &scope.mechanism.links[found.crank.index()].name;
        let message = format!(
            "`{title}` cannot be assembled at any angle of `{crank}`; change its dimensions"
        );
        scope.diagnostics.error_because(keyword.span(), message, &found.reason);
    }
}

/// Notes groups whose two modes meet at an angle of a crank, where a constant mode does not follow the motion.
pub(super) fn note_change_points(scope: &mut Scope<'_>) {
    let groups = scope.mechanism.group_steps();
    let constant = groups.filter(|group| matches!(group.mode(), Some(Mode::Fixed(_))));
    let constant: HashSet<GroupId> = constant.map(|group| group.id).collect();
    let is_passed = |found: &&Rotatability| {
        !found.turn.change_points.is_empty() && constant.contains(&found.group)
    };
    for found in scope.mechanism.rotatabilities.iter().filter(is_passed) {
        let keyword = scope.mechanism.groups[found.group.index()].keyword.span();
        let angle = match found.input {
            Some(input) => scope.mechanism.inputs[input.index()].name.to_string(),
            None => format!("{}.angle", scope.mechanism.links[found.crank.index()].name),
        };
        let angles: Vec<_> = found.turn.change_points.iter().copied().map(degrees).collect();
        let (at, is_drawn) =
            (format!("`{angle}` = {}", angles.join(" and ")), scope.drawn.is_some());
        let [message, reason] =
            in_words(&scope.mechanism, found.group, &at, found.is_parallelogram, is_drawn);
        scope.diagnostics.note_because(keyword, message, reason);
    }
}
