//! Names for what a drawing does not name: an unknown, the block at the end of a bar, the bar that two links are.
//!
//! Nothing in the declaration is called so and nothing in it asks for such a name, so that none of them is taken for
//! another.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

use crate::syntax::tree::{Declaration, OutputStatement, StatementKind};

use crate::model::references::names_used;
use crate::model::statements::declared_by;

pub(in crate::model) struct FreeNames(HashSet<String>);

impl FreeNames {
    pub(in crate::model) fn of(tree: &Declaration) -> Self {
        let mut taken = HashSet::new();
        for statement in &tree.statements {
            taken.extend(declared_by(statement).iter().map(|(name, _)| name.to_string()));
            taken.extend(names_used(statement).iter().map(ToString::to_string));
            if let StatementKind::Output(OutputStatement { items, .. }) = &statement.kind {
                taken.extend(items.iter().filter_map(|item| Some(item.name.as_ref()?.to_string())));
            }
        }
        Self(taken)
    }

    /// The name, with this ending as often as it takes until it is free.
    pub(in crate::model) fn made(&mut self, name: String, ending: &str, span: Span) -> Ident {
        let longer = std::iter::successors(Some(name), |name| Some(format!("{name}{ending}")));
        self.first(longer, span)
    }

    /// The first of these names that is free.
    pub(in crate::model::drawn) fn first(
        &mut self,
        names: impl Iterator<Item = String>,
        span: Span,
    ) -> Ident {
        let mut free = names.filter(|name| self.0.insert(name.clone()));
        Ident::new(&free.next().expect("there is always another name"), span)
    }
}
