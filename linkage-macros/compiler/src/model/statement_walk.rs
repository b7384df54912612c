//! The walk through the statements, one after the other: each is resolved by its rules.

use crate::syntax::tree::{Declaration, Statement};

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
    rules(statement).resolve(scope, &statement.docs);
}

/// Notes what the statement has made with the unknown that is searched, or with what follows
/// it.
fn note_what_follows(scope: &mut Scope<'_>, statement: &Statement) {
    let Some(searched) = scope.facts.searched() else { return };
    if !rules(statement).uses(scope, &|entity| searched.reaches(entity)) {
        return;
    }
    let declared = declared_by(statement);
    let made = declared.iter().filter_map(|(name, _)| scope.names.made(name));
    if let Some(searched) = scope.facts.searches.last_mut() {
        searched.follows.extend(made);
    }
}
