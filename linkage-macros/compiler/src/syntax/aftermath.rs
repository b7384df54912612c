//! Memory of the mistakes in a declaration while it is read, so that they cause no further reports.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenTree};

use super::words;

/// Consequences of mistakes for the rest of the declaration.
#[derive(Default)]
pub struct Aftermath {
    /// The identifiers that were given up, see [`super::tree::Unread`].
    pub unread: HashSet<String>,
    /// True if a statement by which the machine moves was not read as it is written.
    pub is_damaged: bool,
    /// True if the statement in hand was told that no force reads a reaction.
    pub reads_a_reaction: bool,
    /// Names that were declared and cannot be: one message is enough for all of their uses.
    refused: HashSet<String>,
}

impl Aftermath {
    /// Remembers a name that cannot be given, and gives the one that stands in for it.
    pub(super) fn refuse(&mut self, name: &Ident) -> Ident {
        self.refused.insert(name.to_string());
        // A use may be read as something else, as that of `pi` is.
        let instead = placeholder(name);
        self.unread.insert(instead.to_string());
        instead
    }

    pub(super) fn was_refused(&self, name: &Ident) -> bool {
        self.refused.contains(&name.to_string())
    }

    pub(super) fn give_up(&mut self, tree: &TokenTree) {
        // The tokens given up may be nested deeper than a stack of calls can be.
        let mut trees = vec![tree.clone()];
        while let Some(tree) = trees.pop() {
            match tree {
                TokenTree::Ident(word) => {
                    self.unread.insert(word.to_string());
                }
                TokenTree::Group(group) => trees.extend(group.stream()),
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
        }
    }
}

/// The name in the place of one that cannot be given.
pub(super) fn placeholder(name: &Ident) -> Ident {
    let word = name.to_string();
    let plain = word.trim_start_matches("r#");
    match words::is_rust_keyword(plain) {
        true => Ident::new(&format!("{plain}_"), name.span()),
        false => Ident::new(plain, name.span()),
    }
}
