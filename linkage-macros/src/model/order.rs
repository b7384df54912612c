//! The order of statements: each uses only what earlier ones have made.
//!
//! A name that is used too early is noted where it is met and judged here, once for the whole
//! declaration: either another order of the statements works, or some of them need each other.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::syntax::tree::Declaration;

use super::Resolver;
use super::class_three;
use super::names::{declared_by, listed, title};
use super::references::names_used;

/// Which statements each statement needs.
pub(super) struct Needs(Vec<BTreeSet<usize>>);

impl Needs {
    fn of(tree: &Declaration) -> Self {
        let made_by = |name: Ident| {
            tree.statements.iter().position(|statement| {
                declared_by(statement).iter().any(|(declared, _)| **declared == name)
            })
        };
        Self(
            tree.statements
                .iter()
                .enumerate()
                .map(|(index, statement)| {
                    let makers = names_used(statement).into_iter().filter_map(made_by);
                    makers.filter(|&maker| maker != index).collect()
                })
                .collect(),
        )
    }

    /// Everything that the statement needs, whether itself or by way of others.
    fn closure(&self, statement: usize) -> BTreeSet<usize> {
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
    fn ordered(&self, mut statements: BTreeSet<usize>) -> Vec<usize> {
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

const TWO_UNKNOWNS: &str = "only drivers and dyads are solved in closed form; drive the chain at another \
                            link, so that each dyad stands on what is known";

impl Resolver<'_> {
    /// Reports names that are used too early: with an order that works, or as a circle of statements
    /// that need each other.
    pub(super) fn statements_are_in_order(&mut self, tree: &Declaration) {
        let Some(first) = self.too_early.first() else {
            return;
        };
        let needs = Needs::of(tree);
        let circles: Vec<_> = self.too_early.iter().map(|use_| needs.circle(use_.user)).collect();
        let told = |index: &usize| {
            let statement = &tree.statements[*index];
            let name = declared_by(statement).first().map_or(String::new(), |(n, _)| n.to_string());
            format!("`{}`", title(statement, &name))
        };
        let (at, message, reason) = match circles.iter().position(|circle| !circle.is_empty()) {
            Some(index) => {
                let statements: Vec<_> = circles[index].iter().map(told).collect();
                (
                    self.too_early[index].name.span(),
                    format!(
                        "{} need each other: a group of class III or higher",
                        listed(&statements, "and")
                    ),
                    class_three::instead(tree, &needs, &circles[index])
                        .unwrap_or_else(|| TWO_UNKNOWNS.to_string()),
                )
            }
            None => {
                let uses = self.too_early.iter();
                let statements = uses.flat_map(|use_| [use_.user, use_.maker]).collect();
                let order: Vec<_> = needs.ordered(statements).iter().map(told).collect();
                let made_by = title(&tree.statements[first.maker], &first.name.to_string());
                (
                    first.name.span(),
                    format!("`{}` is used before `{made_by}` makes it", first.name),
                    format!("this order works: {}", order.join(", ")),
                )
            }
        };
        self.diagnostics.error_because(at, message, reason);
    }
}
