//! Which statements need which: each uses what others make.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::syntax::tree::{Declaration, Statement};

use crate::model::references::names_used;
use crate::model::statements::declared_by;

/// The statement that makes what has this name.
pub(super) fn maker(tree: &Declaration, name: &Ident) -> Option<usize> {
    let makes = |statement: &Statement| {
        declared_by(statement).iter().any(|(declared, _)| *declared == name)
    };
    tree.statements.iter().position(makes)
}

/// Which statements each statement needs.
pub(super) struct Needs(Vec<BTreeSet<usize>>);

impl Needs {
    pub(super) fn of(tree: &Declaration) -> Self {
        Self(
            tree.statements
                .iter()
                .enumerate()
                .map(|(index, statement)| {
                    let makers =
                        names_used(statement).into_iter().filter_map(|name| maker(tree, &name));
                    makers.filter(|&maker| maker != index).collect()
                })
                .collect(),
        )
    }

    /// Everything that the statement needs, whether itself or by way of others.
    pub(super) fn closure(&self, statement: usize) -> BTreeSet<usize> {
        let mut all = BTreeSet::new();
        let mut open = vec![statement];
        while let Some(next) = open.pop() {
            open.extend(self.0[next].iter().filter(|&&needed| all.insert(needed)));
        }
        all
    }

    /// The statements that need this one and are needed by it, itself included.
    pub(super) fn circle(&self, statement: usize) -> BTreeSet<usize> {
        let needed = self.closure(statement);
        needed.into_iter().filter(|&other| self.closure(other).contains(&statement)).collect()
    }

    /// The same where one statement needs these alone.
    pub(super) fn with(&self, statement: usize, needed: BTreeSet<usize>) -> Self {
        let mut all = self.0.clone();
        all[statement] = needed;
        Self(all)
    }

    /// The statements, each behind those of them that it needs, as little moved as can be.
    pub(super) fn ordered(&self, mut statements: BTreeSet<usize>) -> Vec<usize> {
        let mut ordered = Vec::new();
        let is_free =
            |open: &BTreeSet<usize>, index: &usize| self.closure(*index).is_disjoint(open);
        while let Some(next) = statements.iter().copied().find(|i| is_free(&statements, i)) {
            statements.remove(&next);
            ordered.push(next);
        }
        ordered
    }
}
