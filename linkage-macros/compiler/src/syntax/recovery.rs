//! Going on after a mistake: where a statement in error ends, and which tokens are given up.

use proc_macro2::{Delimiter, Ident};

use super::openings::{is_called, opening};
use super::tokens::Parser;
use super::words;

impl Parser<'_> {
    /// Remembers that the tokens from `first` up to here were given up.
    pub(super) fn give_up_since(&mut self, first: usize) {
        let read = self.next.min(self.trees.len());
        self.trees[first..read].iter().for_each(|tree| self.aftermath.give_up(tree));
    }

    /// Goes to the end of this sequence and gives all of it up.
    pub(super) fn give_up(&mut self) {
        self.next = self.trees.len();
        self.give_up_since(0);
    }

    /// Goes to the next `,` of this sequence.
    pub(super) fn skip_to_comma(&mut self) {
        while !self.at_end() && !self.is_punct(0, ',') {
            self.next += 1;
        }
    }

    /// Gives up the statement in hand and goes to its end: in front of the next `;` or of what is
    /// certainly another statement, or behind braces.
    pub(super) fn skip_statement(&mut self) {
        if self.skipped {
            return;
        }
        while !self.at_end() && !self.is_punct(0, ';') && !self.statement_begins() {
            let braces = self.is_group(0, Delimiter::Brace);
            self.next += 1;
            if braces {
                break;
            }
        }
        self.give_up_since(self.start);
        self.skipped = true;
    }

    /// Returns and clears the mark that the statement in hand was given up.
    pub(super) fn take_skipped(&mut self) -> bool {
        std::mem::take(&mut self.skipped)
    }

    pub(super) fn is_skipped(&self) -> bool {
        self.skipped
    }

    /// True if a statement certainly begins here: words that may be names are not enough.
    pub(super) fn statement_begins(&self) -> bool {
        if self.is_punct(0, '#') {
            return self.is_group(1, Delimiter::Bracket);
        }
        let Some(word) = self.peek_ident(0).map(Ident::to_string) else { return false };
        match opening(&word) {
            Some(opening) => (opening.begins)(self),
            None => words::GROUPS.contains(&word.as_str()) && is_called(self),
        }
    }
}
