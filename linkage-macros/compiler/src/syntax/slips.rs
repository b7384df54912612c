//! Habits from elsewhere: what other languages and notations write where this one writes something
//! else. Each is told what is written here, once.

use proc_macro2::{Delimiter, Ident, Span, TokenTree};

use super::anatomy::GroupSpec;
use super::openings;
use super::tokens::{Parse, Parser};
use super::words;
use crate::diagnostics::nearest;

impl Parser<'_> {
    /// The likely meaning of a word that begins no statement. The word is consumed already.
    pub(super) fn reason_of_unknown(&self, word: &str) -> String {
        if word == "pub" {
            return "leave it out: parameters and results are public".to_string();
        }
        if word == "use" {
            return "names of the crate are not known in here; `pi` is, and other numbers are \
                    declared: `param l = …`"
                .to_string();
        }
        if word == "compensated" {
            return "what is meant may be `numerics compensated;`".to_string();
        }
        if self.is_punct(0, '!') {
            return "macros are not expanded in here; let a `macro_rules!` write all of `mechanism!`"
                .to_string();
        }
        if self.is_of_a_drawing()
            && let Some(meant) = self.meant_in_a_drawing(word)
        {
            return meant;
        }
        if let Some(meant) = words::meant_by(word) {
            return format!("what is meant may be `{meant}`");
        }
        if let Some(instead) = words::built_by(word) {
            return instead.to_string();
        }
        let known = openings::words().chain(words::GROUPS);
        if let Some(near) = nearest(word, known) {
            return format!("a statement with a similar name exists: `{near}`");
        }
        let is_point = self.is_group(0, Delimiter::Parenthesis) && self.is_punct(1, ';');
        if is_point {
            return "ground points stand in one statement, with commas: `ground A(0, 0), D(1m, 0);`"
                .to_string();
        }
        if self.is_group(0, Delimiter::Parenthesis) {
            let example = GroupSpec::dyad_in_short();
            return format!("a group begins with its keyword: `{example}`");
        }
        format!(
            "statements are {} and the groups {}; others are about drawings, unknowns and forces",
            quoted(&openings::words().take(7).collect::<Vec<_>>()),
            quoted(&words::GROUPS)
        )
    }

    /// `ground A(0, 0), crank …`: a `,` that was taken where the statement should have ended.
    pub(super) fn comma_ends_the_statement(&mut self) -> bool {
        let Some(TokenTree::Punct(comma)) = self.previous().cloned() else { return false };
        let ends = comma.as_char() == ',' && self.statement_begins();
        if ends {
            self.diagnostics.error(comma.span(), "write `;` in place of this `,`");
            self.skipped = true;
        }
        ends
    }

    /// `let mut x`
    pub(super) fn leave_out_mut(&mut self) {
        if self.is_word(0, "mut") && self.peek_ident(1).is_some() {
            let _ = self.refuse_because::<()>(
                "leave out `mut`",
                "what is declared does not change; a `param` can be set at run time",
            );
            self.take();
        }
    }

    /// `upper-blade`, behind its first part: the name that can be given in its place.
    pub(super) fn hyphenated(&mut self, first: Ident) -> Ident {
        let mut word = first.to_string();
        while self.is_punct(0, '-') && !self.is_sign(['-', '>']) {
            let Some(part) = self.peek_ident(1) else { break };
            word = format!("{word}_{part}");
            self.take();
            self.take();
        }
        if first == word {
            return first;
        }
        let message = format!("write `{word}`");
        let at = self.since(first.span());
        self.diagnostics.error_because(at, message, "a `-` in a name would be a difference");
        Ident::new(&word, first.span())
    }

    /// `.08m`
    pub(super) fn bare_decimal(&mut self) -> Option<Parse<()>> {
        let Some(TokenTree::Literal(digits)) = self.peek(1) else { return None };
        let message = format!("write `0.{digits}`");
        Some(self.refuse_because(&message, "a digit stands in front of the decimal point"))
    }

    /// `0,08m` as the value of a field, in front of its comma.
    pub(super) fn decimal_comma(&mut self) -> bool {
        let (Some(TokenTree::Literal(whole)), true, Some(TokenTree::Literal(part))) =
            (self.previous(), self.is_punct(0, ','), self.peek(1))
        else {
            return false;
        };
        let is_whole = whole.to_string().bytes().all(|digit| digit.is_ascii_digit());
        if is_whole {
            let message = format!("write `{whole}.{part}`");
            let at: Span = whole.span();
            self.diagnostics.error_because(at, message, "decimals stand behind a point");
        }
        is_whole
    }

    /// `1m, 2m` as the value of `lengths` or `offsets`, in front of its comma.
    pub(super) fn bare_pair(&mut self, name: &Ident) -> bool {
        let is_pair = ["lengths", "offsets"].iter().any(|pair| name == pair);
        let goes_on = matches!(self.peek(1), Some(TokenTree::Literal(_))) && !self.is_punct(2, ':');
        let is_bare = is_pair && self.is_punct(0, ',') && goes_on;
        if is_bare {
            let message = format!("write `{name}: (…, …)`");
            let reason = "two values of a field stand in parentheses";
            self.diagnostics.error_because(name.span(), message, reason);
        }
        is_bare
    }
}

fn quoted(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    quoted.join(", ")
}
