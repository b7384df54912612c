//! One file a statement: what the model knows of a kind of statement stands in the file of its rules.
//!
//! [`Rules`] is what the rest of the model asks of a statement; [`rules`] finds them. What is asked of a whole
//! declaration (the order of its statements, the names it uses, the stub after a mistake) asks each of its
//! statements through these, and knows no kind by itself.

pub(super) mod acts;
pub(super) mod closed_loops;
pub(super) mod contacts;
pub(super) mod drive_by;
pub(super) mod dyads;
pub(super) mod force;
mod friction_numbers;
pub(super) mod gravity;
pub(super) mod ground;
pub(super) mod guides;
pub(super) mod input;
pub(super) mod load;
pub(super) mod made;
pub(super) mod made_groups;
pub(super) mod mass;
pub(super) mod named;
pub(super) mod output;
pub(super) mod param;
pub(super) mod pins_and_links;
pub(super) mod points;
pub(super) mod settings;
pub(super) mod solves;
pub(super) mod spring;
pub(super) mod stop;
pub(super) mod torque;
pub(super) mod unknowns;

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Action, Expr, Statement, StatementKind};

use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;

/// Everything that the model asks of a kind of statement.
pub(super) trait Rules {
    /// The names that the statement declares. The name of an output is not among them: it is a field of the
    /// result alone.
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        Vec::new()
    }

    /// The statement that declares `name`, as messages call it: `crank AB`. Empty where no message does.
    fn title(&self, name: &str) -> String {
        titled(&self.declares(), name)
    }

    /// The points, links and guides that it builds on.
    fn builds_on(&self) -> Vec<&Ident> {
        Vec::new()
    }

    /// Calls `f` with every expression in it, from left to right.
    fn each_expression(&self, _f: &mut dyn FnMut(&Expr)) {}

    /// Calls `f` with every name that it uses.
    fn each_name(&self, f: &mut dyn FnMut(&Ident)) {
        self.builds_on().into_iter().for_each(&mut *f);
        self.each_expression(&mut |expr| expr.each_name(f));
    }

    /// Every name that it uses, as written.
    fn names_used(&self) -> Vec<Ident> {
        let mut names = Vec::new();
        self.each_name(&mut |name| names.push(name.clone()));
        names
    }

    /// True if it uses a name of which this is true.
    fn uses(&self, scope: &Scope<'_>, asks: &dyn Fn(Entity) -> bool) -> bool {
        let mut found = false;
        self.each_name(&mut |name| found = found || scope.names.entity(name).is_some_and(asks));
        found
    }

    /// True if what it makes moves: anything that it uses does.
    fn moves(&self, scope: &Scope<'_>) -> bool {
        self.uses(scope, &|entity| scope.facts.moves(entity))
    }

    /// Makes what the statement declares, and reports every mistake in it.
    fn resolve(&self, _scope: &mut Scope<'_>, _docs: &[Attribute]) {}

    /// The stand-in for one of its names where the statement was not understood.
    fn stand_in(
        &self,
        _scope: &mut Scope<'_>,
        _docs: &[Attribute],
        _name: &Ident,
    ) -> Option<Entity> {
        None
    }
}

/// The word for one of these names in front of it; empty where it is none of them.
fn titled(names: &[(&Ident, Kind)], name: &str) -> String {
    let kind = names.iter().find(|(own, _)| *own == name).map(|(_, kind)| kind);
    kind.map_or(String::new(), |kind| format!("{} {name}", kind.word()))
}

/// The rules of a statement.
pub(super) fn rules(statement: &Statement) -> &dyn Rules {
    match &statement.kind {
        StatementKind::Input(it) => it,
        StatementKind::InputSet(it) => it,
        StatementKind::Param(it) => it,
        StatementKind::Let(it) => it,
        StatementKind::Unknown(it) => it,
        StatementKind::Solve(it) => it,
        StatementKind::Ground(it) => it,
        StatementKind::Pin(it) => it,
        StatementKind::Link(it) => it,
        StatementKind::Drive(it) => it,
        StatementKind::DriveBy(it) => it,
        StatementKind::Guide(it) => it,
        StatementKind::Point(it) => it,
        StatementKind::Group(it) => it,
        StatementKind::Load(it) => it,
        StatementKind::Action(action) => match action {
            Action::Gravity(it) => it,
            Action::Mass(it) => it,
            Action::Inertia(it) => it,
            Action::Force(it) => it,
            Action::ForceBetween(it) => it,
            Action::Torque(it) => it,
            Action::TorqueBetween(it) => it,
            Action::Spring(it) => it,
            Action::Friction(it) => it,
            Action::Stop(it) => it,
        },
        StatementKind::Output(it) => it,
        StatementKind::Numerics(it) => it,
        StatementKind::Crate(it) => it,
        StatementKind::Export(it) => it,
    }
}

/// The names a statement declares.
pub(in crate::model) fn declared_by(statement: &Statement) -> Vec<(&Ident, Kind)> {
    rules(statement).declares()
}

/// The statement that declares `name`, as messages call it.
pub(in crate::model) fn title(statement: &Statement, name: &str) -> String {
    rules(statement).title(name)
}
