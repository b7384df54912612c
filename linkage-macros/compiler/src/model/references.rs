//! Where a declaration makes its names and where it uses them, so that every one of them reaches
//! the generated code and editors find their way from one to the other.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::syntax::tree::{Declaration, Expr, Statement};

use crate::model::mechanism::References;
use crate::model::statements::{declared_by, rules, title};

impl References {
    pub(super) fn of(tree: &Declaration) -> Self {
        let mut references = Self::default();
        for statement in &tree.statements {
            let is_written = |(name, _): &(&Ident, _)| !tree.unwritten.names.contains(name);
            for (name, _) in declared_by(statement).into_iter().filter(is_written) {
                // A pin that a group makes and a drawing places is made once.
                match references.made.iter().any(|(made, _)| made == name) {
                    true => references.used.push(name.clone()),
                    false => {
                        let title = title(statement, &name.to_string());
                        references.made.push((name.clone(), title));
                    }
                }
            }
        }
        let known: HashSet<_> = references.made.iter().map(|(name, _)| name.to_string()).collect();
        for statement in &tree.statements {
            rules(statement).each_name(&mut |name| {
                // Modes and what a crank's angle is relative to may also be words.
                if known.contains(&name.to_string()) {
                    references.used.push(name.clone());
                }
            });
        }
        references
    }
}

/// Every name that a statement uses, as written.
pub(super) fn names_used(statement: &Statement) -> Vec<Ident> {
    rules(statement).names_used()
}

/// Calls `f` with every expression of the statement.
pub(super) fn expressions(statement: &Statement, f: &mut dyn FnMut(&Expr)) {
    rules(statement).each_expression(f);
}
