//! `pub struct Name { statements }`, and going on after a statement in error.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::Parser as _;
use syn::{Attribute, Visibility};

use super::openings::opening;
use super::tokens::{Parse, Parser, Reported};
use super::tree::{Declaration, Statement, StatementKind, Unread, Unwritten};
use super::words;

const FORM: &str = "declare a mechanism: `pub struct Name { … }`";

impl Parser<'_> {
    /// The whole declaration; `None` where its name could not be found.
    pub(super) fn declaration(&mut self) -> Option<Declaration> {
        if self.at_end() {
            self.diagnostics.error(self.here(), FORM);
            return None;
        }
        let docs = self.docs();
        let visibility = self.visibility();
        let name = self.struct_name().ok();
        let statements = match (self.body(), &name) {
            (Some(body), _) => self.inside(&body).statements(),
            (None, Some(_)) => {
                let _ = self.expected::<()>("the statements of the mechanism in `{ }`");
                let (statements, unread) = (Vec::new(), Unread::Everything);
                return name.map(|name| Declaration {
                    docs,
                    visibility,
                    name,
                    statements,
                    unread,
                    is_damaged: true,
                    unwritten: Unwritten::default(),
                });
            }
            (None, None) => return None,
        };
        if !self.at_end() {
            let _ = self.refuse_because::<()>(
                "end the declaration here",
                "a second mechanism has a `mechanism!` of its own",
            );
        }
        let unread = Unread::Words(std::mem::take(&mut self.aftermath.unread));
        let is_damaged = self.aftermath.is_damaged;
        let unwritten = Unwritten::default();
        name.map(|name| Declaration {
            docs,
            visibility,
            name,
            statements,
            unread,
            is_damaged,
            unwritten,
        })
    }

    /// Doc comments. Other attributes are refused: what they would apply to is generated.
    fn docs(&mut self) -> Vec<Attribute> {
        let mut docs = Vec::new();
        while self.is_punct(0, '#') {
            let hash = self.here();
            let mut tokens: TokenStream = self.take().into_iter().collect();
            if self.take_punct('!') {
                let _ = self.take_group(Delimiter::Bracket);
                self.diagnostics.error(hash, "write `///` in front of what is documented");
                continue;
            }
            let Some(content) = self.take_group(Delimiter::Bracket) else {
                self.diagnostics.error(hash, "write `//` in front of a comment");
                self.skip_statement();
                self.take_skipped();
                continue;
            };
            tokens.extend([TokenTree::Group(content)]);
            match Attribute::parse_outer.parse2(tokens) {
                Ok(attributes) if attributes.iter().all(|a| a.path().is_ident("doc")) => {
                    docs.extend(attributes);
                }
                Ok(attributes) => {
                    let path = attributes.iter().map(|a| a.path().to_token_stream().to_string());
                    let path: String = path.collect();
                    self.diagnostics.error_because(
                        hash,
                        format!("leave out `#[{path}]`"),
                        "only doc comments are passed on to the generated code",
                    );
                }
                Err(error) => self.diagnostics.adopt(error),
            }
        }
        docs
    }

    fn visibility(&mut self) -> Visibility {
        let first = self.here();
        let mut tokens = TokenStream::new();
        if let Some(fragment) = self.take_group(Delimiter::None) {
            tokens = fragment.stream();
        } else if self.is_word(0, "pub") {
            tokens.extend(self.take());
            tokens.extend(self.take_group(Delimiter::Parenthesis).map(TokenTree::Group));
        }
        syn::parse2(tokens).unwrap_or_else(|_| {
            self.diagnostics.error(first, "write `pub`, `pub(crate)` or no visibility");
            Visibility::Inherited
        })
    }

    /// `struct Name`.
    fn struct_name(&mut self) -> Parse<Ident> {
        if !self.take_word("struct") {
            let found = self.found();
            let words = (self.peek_ident(0).is_some(), self.peek_ident(1).is_some());
            if words == (true, true) && self.is_group(2, Delimiter::Brace) {
                let _ = self.refuse::<()>(&format!("write `struct` instead of {found}"));
                self.take();
            } else if words == (true, false) && self.is_group(1, Delimiter::Brace) {
                let _ = self.refuse::<()>(&format!("write `struct` in front of {found}"));
            } else {
                return self.expected_because("`struct`", FORM);
            }
        }
        let Some(name) = self.peek_ident(0).cloned() else {
            return self.expected("the name of the mechanism");
        };
        let word = name.to_string();
        if words::is_rust_keyword(&word) || word.starts_with("r#") {
            let _ = self.new_name("the mechanism");
            return Err(Reported);
        }
        self.take();
        Ok(name)
    }

    /// The braces of the declaration; what stands in front of them is reported.
    fn body(&mut self) -> Option<proc_macro2::Group> {
        if self.is_punct(0, '<') {
            let _ = self.refuse_because::<()>(
                "leave out the generic parameters",
                "the scalar type is added to every mechanism",
            );
            while !self.at_end() && !self.is_group(0, Delimiter::Brace) {
                self.take();
            }
        }
        self.take_group(Delimiter::Brace)
    }

    fn statements(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        while !self.at_end() {
            let docs = self.docs();
            if self.at_end() && !docs.is_empty() {
                let _ = self.refuse::<()>("write a statement behind this doc comment, or drop it");
            }
            // A `;` behind braces is legal.
            if self.at_end() || self.take_punct(';') {
                continue;
            }
            self.start = self.next;
            self.asks = self.is_word(0, "output");
            self.aftermath.reads_a_reaction = false;
            let (reported, moves) = (self.diagnostics.count(), self.moves());
            let statement = self.statement();
            self.aftermath.is_damaged |= moves && self.diagnostics.count() > reported;
            match statement {
                Ok(kind) => statements.push(Statement { docs, kind }),
                Err(Reported) => {
                    self.skip_statement();
                    self.semicolon();
                }
            }
        }
        statements
    }

    /// True if the statement that begins here may be one by which the machine moves.
    fn moves(&self) -> bool {
        let word = self.peek_ident(0).map(ToString::to_string);
        let opening = word.and_then(|word| opening(&word));
        opening.is_none_or(|opening| opening.moves())
    }

    fn statement(&mut self) -> Parse<StatementKind> {
        let Some(keyword) = self.peek_ident(0).cloned() else {
            let found = match self.is_punct(0, ',') {
                true => self.refuse_because(
                    "leave out this `,`",
                    "a group ends with its braces, every other statement with `;`",
                ),
                false => self.expected("a statement"),
            };
            self.take();
            return found;
        };
        let word = keyword.to_string();
        if words::is_reserved(&word) && opening(&word).is_none() {
            let message = format!("`{word}` is reserved for a later statement");
            let instead = match word.as_str() {
                "damper" => self.spring_for_a_damper(),
                _ => words::built_by(&word).map(str::to_string),
            };
            let _ = match instead {
                Some(instead) => self.refuse_because::<()>(&message, &instead),
                None => self.refuse(&message),
            };
            self.take();
            return Err(Reported);
        }
        self.take();
        if let Some(parsed) = self.plain_statement(&keyword) {
            return parsed;
        }
        if self.is_group_keyword(&word) {
            return Ok(StatementKind::Group(self.group(keyword)));
        }
        let reason = self.reason_of_unknown(&word);
        let message = format!("no statement begins with `{word}`");
        self.diagnostics.error_because(keyword.span(), message, reason);
        Err(Reported)
    }
}
