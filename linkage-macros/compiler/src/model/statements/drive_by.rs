//! `drive theta by pull;`: the load that puts in the effort of an input. Its value follows.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, DriveByStatement, StatementKind};

use crate::model::acting::{Dynamics, Effort, Load};
use crate::model::ids::{InputId, LinkId};
use crate::model::mechanism::{
    Drive, Group, GuideDirection, Mechanism, Placement, Scalar, Slideway, Step, Through,
};
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::{named_efforts, uses};

impl Rules for DriveByStatement {
    fn title(&self, _name: &str) -> String {
        format!("drive {} by {}", self.input, self.load)
    }

    fn builds_on(&self) -> Vec<&Ident> {
        vec![&self.input, &self.load]
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        drive_by(scope, &self.input, &self.load);
    }
}

/// The load behind the first `by`.
pub(in crate::model) fn named_by(tree: &Declaration) -> Option<&Ident> {
    tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::DriveBy(DriveByStatement { load, .. }) => Some(load),
        _ => None,
    })
}

/// Reports at its `drive … by` that the load of a mechanism does no work on the input.
pub(crate) fn load_does_no_work(
    tree: &Declaration,
    mechanism: &Mechanism,
    diagnostics: &mut Diagnostics,
) {
    let Some(((input, _), load)) = mechanism.dynamics.driven().zip(named_by(tree)) else { return };
    let input = &mechanism.inputs[input.index()].name;
    let message = format!("`{load}` does no work as `{input}` moves, and cannot drive it");
    let reason = format!(
        "no force acts along what `{input}` moves, and no torque on what it turns; its value follows from the work that \
         it does"
    );
    diagnostics.error_because(load.span(), message, reason);
}

impl Dynamics {
    /// The input that a load drives, and the load.
    pub(crate) fn driven(&self) -> Option<(InputId, &Load)> {
        Some((self.pulled?, self.pull.as_ref()?))
    }
}

impl Mechanism {
    /// The input and the load that leave a crank or a slider without an effort of its own: no other dimension moves
    /// with the input.
    pub(in crate::model) fn driven_through(&self, link: LinkId) -> Option<(InputId, &Load)> {
        let (input, load) = self.dynamics.driven()?;
        let is_input = |expr: &Scalar| matches!(expr, Scalar::Input(id) if *id == input);
        let drive = self.group_with(link)?.outer.first()?.drive.as_ref()?;
        let is_alone = match drive {
            Drive::Angle { angle, .. } => angle.links.is_empty() && is_input(&angle.rest),
            Drive::Slide(slide) => is_input(slide),
        };
        let count = self.dimensions().into_iter().filter(|expr| self.holds(expr, input)).count();
        (is_alone && count == 1).then_some((input, load))
    }

    /// All dimensions by which something is placed.
    fn dimensions(&self) -> Vec<&Scalar> {
        let mut all = Vec::new();
        for step in &self.steps {
            match step {
                // No input moves the ground.
                Step::Ground { .. } => {}
                Step::Guide { through, course, .. } => {
                    if let Through::At(at) = through {
                        all.extend(at);
                    }
                    if let GuideDirection::Along(angle) = course {
                        all.push(&angle.rest);
                    }
                }
                Step::Point { place, .. } => match place {
                    Placement::Cartesian(at) => all.extend(at),
                    Placement::Polar(radius, angle) => all.extend([radius, angle]),
                    Placement::Distances { distances: [first, second], length, .. } => {
                        all.extend([&first.value, &second.value, length]);
                    }
                },
                Step::Group(group) => all.extend(group.dimensions()),
            }
        }
        all
    }

    /// True if the input is written in the expression, or in a name that stands in it.
    fn holds(&self, expr: &Scalar, input: InputId) -> bool {
        let holds = |expr: &Scalar| self.holds(expr, input);
        match expr {
            Scalar::Input(id) => *id == input,
            Scalar::Let(id) => holds(&self.lets[id.index()].rest),
            Scalar::Negate(value) => holds(value),
            Scalar::AboveZero(inner) => holds(&inner.value),
            Scalar::Chain(first, rest) => {
                holds(first) || rest.iter().any(|(_, operand)| holds(operand))
            }
            Scalar::Call(_, arguments) => arguments.iter().any(holds),
            _ => false,
        }
    }
}

impl Group {
    fn dimensions(&self) -> Vec<&Scalar> {
        let lengths = self.lengths.iter().flatten().map(|length| &length.value);
        let drives = self.outer.iter().filter_map(|joint| match joint.drive.as_ref()? {
            Drive::Angle { angle, .. } => Some(&angle.rest),
            Drive::Slide(slide) => Some(slide),
        });
        let slots = self.joints().filter_map(|joint| match joint.slideway()? {
            Slideway::Slot { angle, .. } => Some(&angle.rest),
            Slideway::Guide(_) | Slideway::Bar(_) => None,
        });
        lengths.chain(drives).chain(slots).chain(self.offsets()).collect()
    }
}

fn drive_by(scope: &mut Scope<'_>, input: &Ident, load: &Ident) {
    let kinds = [input, load].map(|name| scope.names.kind(name));
    if kinds == [Some(Kind::Load), Some(Kind::Input)] {
        let message = format!("write `drive {load} by {input};`");
        let reason = "an input is driven by a load, and stands in front";
        return scope.diagnostics.error_because(input.span(), message, reason);
    }
    let (driven, by) =
        (uses::usable(scope, input, &[Kind::Input]), uses::usable(scope, load, &[Kind::Load]));
    let is_first = scope.facts.driving.as_deref() == Some(&load.to_string())
        && scope.mechanism.dynamics.pulled.is_none();
    if !is_first {
        let message = "one load drives one input; remove this statement";
        let reason = "the values of several loads would follow from each other";
        return scope.diagnostics.error_because(input.span(), message, reason);
    }
    if let (Some(Entity::Input(id)), Some(Entity::Pull)) = (driven, by) {
        scope.mechanism.dynamics.pulled = Some(id);
    }
}

/// Returns true if the output is the load that drives an input.
pub(in crate::model) fn pull_output(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
) -> bool {
    let is_pull = scope.names.entity(name) == Some(Entity::Pull);
    if is_pull {
        let own = scope.mechanism.dynamics.pull.iter().flat_map(|load| &load.docs);
        let docs: Vec<_> = docs.iter().chain(own).cloned().collect();
        named_efforts::ask(scope, &docs, name, name, Effort::Pull);
    }
    is_pull
}
