//! The items that are resolved one after the other: the statements of a declaration, and of a drawing what it became.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Declaration, Statement, StatementKind};

use crate::model::statements::{Rules, rules};

/// A statement, or what a drawing became in place of one.
#[derive(Clone, Copy)]
pub(super) struct Item<'t> {
    pub docs: &'t [Attribute],
    pub rules: &'t dyn Rules,
    /// The statement, where it is written.
    pub written: Option<&'t StatementKind>,
}

impl<'t> Item<'t> {
    pub(super) fn of(statement: &'t Statement) -> Self {
        let Statement { docs, kind } = statement;
        Self { docs, rules: rules(statement), written: Some(kind) }
    }

    /// An item that nobody has written.
    pub(super) fn made(rules: &'t dyn Rules) -> Self {
        Self { docs: &[], rules, written: None }
    }
}

/// The statements of a declaration.
pub(super) fn items(tree: &Declaration) -> Vec<Item<'_>> {
    tree.statements.iter().map(Item::of).collect()
}

/// The item that makes what has this name.
pub(super) fn maker(items: &[Item<'_>], name: &Ident) -> Option<usize> {
    items.iter().position(|item| item.rules.declares().iter().any(|(made, _)| *made == name))
}
