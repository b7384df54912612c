//! The walk through the statements, one after the other: each is resolved by its rules.

use crate::syntax::tree::{Declaration, Statement};

use crate::model::names::Entity;
use crate::model::references::each_name_used;
use crate::model::scope::Scope;
use crate::model::statements::{declared_by, rules};

pub(super) fn statements(scope: &mut Scope<'_>, tree: &Declaration) {
    for (index, next) in tree.statements.iter().enumerate() {
        scope.names.go_to(index);
        statement(scope, next);
        note_what_follows(scope, next);
    }
    scope.names.go_to(tree.statements.len());
}

pub(super) fn statement(scope: &mut Scope<'_>, statement: &Statement) {
    // A statement moves what it makes if anything that it uses does.
    let moves = uses(scope, statement, |scope, entity| scope.facts.moves(entity));
    rules(statement).resolve(scope, &statement.docs, moves);
}

/// True if the statement uses a name of which this is true.
fn uses(
    scope: &Scope<'_>,
    statement: &Statement,
    asks: impl Fn(&Scope<'_>, Entity) -> bool,
) -> bool {
    let mut found = false;
    each_name_used(statement, &mut |name| {
        found = found || scope.names.entity(name).is_some_and(|entity| asks(scope, entity));
    });
    found
}

/// Notes what the statement has made with the unknown that is searched, or with what follows
/// it.
fn note_what_follows(scope: &mut Scope<'_>, statement: &Statement) {
    let Some(searched) = scope.facts.searched() else { return };
    if !uses(scope, statement, |_, entity| searched.reaches(entity)) {
        return;
    }
    let declared = declared_by(statement);
    let made = declared.iter().filter_map(|(name, _)| scope.names.made(name));
    if let Some(searched) = scope.facts.searches.last_mut() {
        searched.follows.extend(made);
    }
}
