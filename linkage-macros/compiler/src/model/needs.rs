//! Which statements need which: each uses what others make.

use std::collections::BTreeSet;

use crate::model::items::{Item, maker};

/// Which statements each statement needs.
pub(super) struct Needs(Vec<BTreeSet<usize>>);

impl Needs {
    pub(super) fn of(items: &[Item<'_>]) -> Self {
        let needs = items.iter().enumerate().map(|(index, item)| {
            let used = item.rules.names_used().into_iter();
            used.filter_map(|name| maker(items, &name)).filter(|&maker| maker != index).collect()
        });
        Self(needs.collect())
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
