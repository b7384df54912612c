//! The first phase: from tokens to the tree, or to a tree for each of several sets of inputs.

use proc_macro2::{Ident, TokenStream};

use crate::diagnostics::Diagnostics;
use crate::model::{self, DrivenBySet};
use crate::syntax::tree::Declaration;
use crate::{blocks, syntax};

/// A declaration as it was read, and those that its sets of inputs drive.
pub(super) struct Parsed {
    pub tree: Declaration,
    pub drivings: Vec<DrivenBySet>,
    /// True if nothing is wrong with the sets.
    pub are_well: bool,
    /// The set that is meant, where the declaration is marked with it.
    chosen: Option<Ident>,
}

pub(super) fn parsed(source: TokenStream, diagnostics: &mut Diagnostics) -> Option<Parsed> {
    let (tokens, chosen) = blocks::chosen(source);
    let tree = syntax::parse(tokens, diagnostics)?;
    let reported = diagnostics.count();
    let drivings = model::drivings(&tree, diagnostics);
    Some(Parsed { tree, drivings, are_well: diagnostics.count() == reported, chosen })
}

impl Parsed {
    pub(super) fn means_all_sets(&self) -> bool {
        self.chosen.is_none() && !self.drivings.is_empty()
    }

    /// The declaration that the chosen set drives, the first where none is chosen; itself where it has no sets.
    pub(super) fn driven(self) -> Declaration {
        let is_chosen =
            |driving: &DrivenBySet| self.chosen.as_ref().is_none_or(|set| driving.set == *set);
        self.drivings.into_iter().find(is_chosen).map_or(self.tree, |driving| driving.tree)
    }
}
