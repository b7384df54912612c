//! Where a declaration makes its names and where it uses them, so that every one of them reaches
//! the generated code and editors find their way from one to the other.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::syntax::tree::{Declaration, Expr, ExprKind, Statement};

use crate::model::mechanism::References;
use crate::model::statements::{declared_by, rules, title};

impl References {
    pub(super) fn of(tree: &Declaration) -> Self {
        let mut references = Self::default();
        for statement in &tree.statements {
            for (name, _) in declared_by(statement) {
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
            let mut used = |name: &Ident| {
                // Modes and what a crank's angle is relative to may also be words.
                if known.contains(&name.to_string()) {
                    references.used.push(name.clone());
                }
            };
            rules(statement).builds_on().into_iter().for_each(&mut used);
            expressions(statement, &mut |expr| names_in(expr, &mut used));
        }
        references
    }
}

/// Every name that a statement uses, as written.
pub(super) fn names_used(statement: &Statement) -> Vec<Ident> {
    let mut names = Vec::new();
    each_name_used(statement, &mut |name| names.push(name.clone()));
    names
}

/// Calls `f` with every name that a statement uses.
pub(super) fn each_name_used(statement: &Statement, f: &mut impl FnMut(&Ident)) {
    rules(statement).builds_on().into_iter().for_each(&mut *f);
    expressions(statement, &mut |expr| names_in(expr, &mut *f));
}

/// Calls `f` with every expression of the statement.
pub(super) fn expressions(statement: &Statement, f: &mut dyn FnMut(&Expr)) {
    rules(statement).each_expression(f);
}

/// Calls `f` with every name in the expression.
pub(super) fn names_in(expr: &Expr, f: &mut impl FnMut(&Ident)) {
    expr.each_part(&mut |part| match &part.kind {
        ExprKind::Name(name) | ExprKind::Member(name, _) => f(name),
        ExprKind::Part(path) => path[..2].iter().for_each(&mut *f),
        _ => {}
    });
}
