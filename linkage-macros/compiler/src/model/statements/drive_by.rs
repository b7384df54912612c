//! `drive theta by pull;`: the load that puts in the effort of an input. Its value follows.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, DriveByStatement, StatementKind};

use crate::model::acting::{Dynamics, Effort, Load};
use crate::model::ids::InputId;
use crate::model::mechanism::Mechanism;
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
    pub fn driven(&self) -> Option<(InputId, &Load)> {
        Some((self.pulled?, self.pull.as_ref()?))
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
