//! A cursor over token trees, and what every part of the parser does with it: expect, report,
//! skip. Nothing here knows a statement.

use proc_macro2::{Delimiter, Group, Ident, Spacing, Span, TokenStream, TokenTree};

use super::aftermath::{Aftermath, placeholder};
use super::words;
use crate::diagnostics::{Diagnostics, Extent};

/// A part could not be parsed and its mistake was reported.
pub struct Reported;

pub(super) type Parse<T> = Result<T, Reported>;

/// Reads one delimited sequence of tokens.
pub struct Parser<'d> {
    pub trees: Vec<TokenTree>,
    pub next: usize,
    /// The closing delimiter.
    end: Span,
    closing: &'static str,
    /// The number of delimiters and signs around the expression in hand.
    pub depth: usize,
    /// Where the last expression ended.
    expression_end: usize,
    /// The statement in hand has lost its end: a mistake in it was reported and its tokens were
    /// skipped, so nothing more is to be said about it.
    pub skipped: bool,
    pub diagnostics: &'d mut Diagnostics,
    pub aftermath: &'d mut Aftermath,
    /// Where the statement in hand begins.
    pub start: usize,
    /// True if the statement in hand asks for results, so that a reaction may be meant.
    pub asks: bool,
}

impl<'d> Parser<'d> {
    pub fn new(
        source: TokenStream,
        diagnostics: &'d mut Diagnostics,
        aftermath: &'d mut Aftermath,
    ) -> Self {
        Self {
            trees: visible(source),
            next: 0,
            end: Span::call_site(),
            closing: "the end",
            depth: 0,
            expression_end: usize::MAX,
            skipped: false,
            diagnostics,
            aftermath,
            start: 0,
            asks: false,
        }
    }

    /// A parser for the content of a group.
    pub(super) fn inside(&mut self, group: &Group) -> Parser<'_> {
        Parser {
            trees: visible(group.stream()),
            next: 0,
            end: group.span_close(),
            closing: match group.delimiter() {
                Delimiter::Parenthesis => "`)`",
                Delimiter::Brace => "`}`",
                Delimiter::Bracket => "`]`",
                Delimiter::None => "the end",
            },
            depth: self.depth + 1,
            expression_end: usize::MAX,
            skipped: false,
            diagnostics: &mut *self.diagnostics,
            aftermath: &mut *self.aftermath,
            start: 0,
            asks: self.asks,
        }
    }

    pub(super) fn peek(&self, ahead: usize) -> Option<&TokenTree> {
        self.trees.get(self.next + ahead)
    }

    pub(super) fn at_end(&self) -> bool {
        self.next >= self.trees.len()
    }

    pub(super) fn take(&mut self) -> Option<TokenTree> {
        let tree = self.trees.get(self.next).cloned();
        self.next += usize::from(tree.is_some());
        tree
    }

    pub(super) fn peek_ident(&self, ahead: usize) -> Option<&Ident> {
        match self.peek(ahead) {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    pub(super) fn is_word(&self, ahead: usize, word: &str) -> bool {
        self.peek_ident(ahead).is_some_and(|ident| ident == word)
    }

    pub(super) fn is_punct(&self, ahead: usize, sign: char) -> bool {
        matches!(self.peek(ahead), Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
    }

    pub(super) fn is_group(&self, ahead: usize, delimiter: Delimiter) -> bool {
        matches!(self.peek(ahead), Some(TokenTree::Group(group)) if group.delimiter() == delimiter)
    }

    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_word(0, word);
        self.next += usize::from(found);
        found
    }

    pub(super) fn take_punct(&mut self, sign: char) -> bool {
        let found = self.is_punct(0, sign);
        self.next += usize::from(found);
        found
    }

    /// A sign of two characters, such as `->`.
    pub(super) fn take_sign(&mut self, signs: [char; 2]) -> bool {
        let found = self.is_sign(signs);
        self.next += if found { 2 } else { 0 };
        found
    }

    pub(super) fn is_sign(&self, signs: [char; 2]) -> bool {
        let joint = matches!(
            self.peek(0),
            Some(TokenTree::Punct(punct)) if punct.spacing() == Spacing::Joint
        );
        joint && self.is_punct(0, signs[0]) && self.is_punct(1, signs[1])
    }

    pub(super) fn take_group(&mut self, delimiter: Delimiter) -> Option<Group> {
        match self.peek(0) {
            Some(TokenTree::Group(group)) if group.delimiter() == delimiter => {
                let group = group.clone();
                self.next += 1;
                Some(group)
            }
            _ => None,
        }
    }

    /// Where the next token begins, or the closing delimiter.
    pub(super) fn here(&self) -> Span {
        match self.peek(0) {
            Some(TokenTree::Group(group)) => group.span_open(),
            Some(tree) => tree.span(),
            None => self.end,
        }
    }

    pub(super) fn end(&self) -> Span {
        self.end
    }

    pub(super) fn previous(&self) -> Option<&TokenTree> {
        self.next.checked_sub(1).and_then(|last| self.trees.get(last))
    }

    /// Remembers that an expression ends here.
    pub(super) fn mark_expression(&mut self) {
        self.expression_end = self.next;
    }

    /// From `first` to the token just taken.
    pub(super) fn since(&self, first: Span) -> Extent {
        Extent::between(first, self.previous().map_or(first, TokenTree::span))
    }

    /// The next token as it is quoted in messages.
    pub fn found(&self) -> String {
        const SIGNS: [&str; 16] = [
            "->", "=>", "::", "==", "!=", "<=", ">=", "&&", "||", "..", "+=", "-=", "*=", "/=",
            "**", ":=",
        ];
        match (self.peek(0), self.peek(1)) {
            (None, _) => self.closing.to_string(),
            (Some(TokenTree::Punct(first)), Some(TokenTree::Punct(second))) => {
                let both: String = [first.as_char(), second.as_char()].iter().collect();
                match SIGNS.contains(&both.as_str()) && first.spacing() == Spacing::Joint {
                    true => format!("`{both}`"),
                    false => format!("`{}`", first.as_char()),
                }
            }
            (Some(tree), _) => format!("`{}`", opening(tree)),
        }
    }

    /// Reports that the next token is not `what`.
    pub(super) fn expected<T>(&mut self, what: &str) -> Parse<T> {
        if self.is_punct(0, '#') {
            return self.refuse("move the doc comment in front of its statement");
        }
        let found = self.found();
        let message = format!("expected {what}, found {found}");
        match self.reason() {
            Some(reason) => self.diagnostics.error_because(self.here(), message, reason),
            None => self.diagnostics.error(self.here(), message),
        }
        Err(Reported)
    }

    pub(super) fn expected_because<T>(&mut self, what: &str, reason: &str) -> Parse<T> {
        let message = format!("expected {what}, found {}", self.found());
        self.refuse_because(&message, reason)
    }

    /// Reports a mistake at the next token.
    pub(super) fn refuse<T>(&mut self, message: &str) -> Parse<T> {
        self.diagnostics.error(self.here(), message);
        Err(Reported)
    }

    pub(super) fn refuse_because<T>(&mut self, message: &str, reason: &str) -> Parse<T> {
        self.diagnostics.error_because(self.here(), message, reason);
        Err(Reported)
    }

    /// The habit from elsewhere that may have put the next token here, as a hint.
    pub(super) fn reason(&self) -> Option<&'static str> {
        if self.is_punct(0, '^') || self.is_sign(['*', '*']) {
            return Some("a power is a product or a call: `x * x`, `pow(x, 2)`");
        }
        let another = match self.peek(0)? {
            TokenTree::Literal(_) => true,
            TokenTree::Ident(ident) if !words::is_reserved(&ident.to_string()) => true,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => true,
            TokenTree::Ident(_) | TokenTree::Group(_) => return None,
            TokenTree::Punct(punct) if ";,:#=".contains(punct.as_char()) => return None,
            TokenTree::Punct(_) => false,
        };
        let reason = match another {
            true => "a product is written with `*`",
            false => "the operators are `+`, `-`, `*` and `/`",
        };
        (self.next == self.expression_end).then_some(reason)
    }

    /// The name that a declaration gives; one that cannot be given is reported and replaced by
    /// one that can, so that the statement keeps its place in the tree.
    pub(super) fn new_name(&mut self, what: &str) -> Parse<Ident> {
        let Some(ident) = self.peek_ident(0).cloned() else {
            return self.expected(&format!("the name of {what}"));
        };
        self.next += 1;
        let word = ident.to_string();
        let Some(refusal) = words::refusal(&word) else { return Ok(self.hyphenated(ident)) };
        let (message, reason) = refusal;
        self.diagnostics.error_because(ident.span(), format!("`{word}` {message}"), reason);
        Ok(self.aftermath.refuse(&ident))
    }

    /// A name that was given elsewhere.
    pub(super) fn name_of(&mut self, what: &str) -> Parse<Ident> {
        match self.peek_ident(0).cloned() {
            Some(ident) if can_be_referred_to(&ident.to_string()) => {
                self.next += 1;
                Ok(self.hyphenated(ident))
            }
            Some(ident) if self.aftermath.was_refused(&ident) => {
                self.next += 1;
                Ok(placeholder(&ident))
            }
            _ => self.expected(&format!("the name of {what}")),
        }
    }

    /// Any word, whose meaning is decided later.
    pub(super) fn word(&mut self, what: &str) -> Parse<Ident> {
        match self.peek_ident(0).cloned() {
            Some(ident) => {
                self.next += 1;
                Ok(ident)
            }
            None => self.expected(what),
        }
    }

    /// Ends a statement without braces.
    pub(super) fn semicolon(&mut self) {
        if self.take_skipped() || self.is_punct(0, ';') {
            self.take_punct(';');
            return;
        }
        if self.at_end() || self.statement_begins() {
            let (text, span) = match self.previous() {
                Some(TokenTree::Group(group)) => (closing(group), group.span_close()),
                Some(tree) => (tree.to_string(), tree.span()),
                None => ("{".to_string(), self.here()),
            };
            self.diagnostics.error(span, format!("write `;` after `{text}`"));
            return;
        }
        let _ = match self.is_punct(0, ',') {
            true => self.expected_because::<()>("`;`", "this statement declares one name"),
            false => self.expected("`;`"),
        };
        self.skip_statement();
        self.take_skipped();
        self.take_punct(';');
    }
}

/// Prepositions and keywords cannot have been given to anything.
fn can_be_referred_to(word: &str) -> bool {
    !words::is_rust_keyword(word) && !words::is_reserved(word) && !word.starts_with("r#")
}

/// The trees a reader sees: a fragment that another macro passed on comes in invisible
/// delimiters, which matter only around several tokens.
fn visible(source: TokenStream) -> Vec<TokenTree> {
    let mut trees = Vec::new();
    for tree in source {
        match tree {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                let mut content = visible(group.stream());
                match content.len() {
                    0 | 1 => trees.append(&mut content),
                    _ => trees.push(TokenTree::Group(group)),
                }
            }
            tree => trees.push(tree),
        }
    }
    trees
}

fn opening(tree: &TokenTree) -> String {
    match tree {
        TokenTree::Group(group) => match group.delimiter() {
            Delimiter::Parenthesis => "(".to_string(),
            Delimiter::Brace => "{".to_string(),
            Delimiter::Bracket => "[".to_string(),
            Delimiter::None => group.to_string(),
        },
        tree => tree.to_string(),
    }
}

fn closing(group: &Group) -> String {
    match group.delimiter() {
        Delimiter::Parenthesis => ")".to_string(),
        Delimiter::Brace => "}".to_string(),
        Delimiter::Bracket => "]".to_string(),
        Delimiter::None => group.to_string(),
    }
}
