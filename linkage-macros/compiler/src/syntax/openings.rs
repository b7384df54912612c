//! The words that begin a statement, a row each: how it is read, how it ends, and what certainly begins with it.
//!
//! The groups, which are read alike, stand in `anatomy`.

use proc_macro2::{Delimiter, Ident, TokenTree};

use super::tokens::{Parse, Parser};
use super::tree::StatementKind;

/// A word that begins a statement.
pub struct Opening {
    pub word: &'static str,
    /// Reads what stands behind the word, which is given.
    pub(super) parse: fn(&mut Parser<'_>, &Ident) -> Parse<StatementKind>,
    /// True where such a statement certainly begins at the word: it may be a name, too.
    pub(super) begins: fn(&Parser<'_>) -> bool,
    pub(super) ends: Ending,
    /// True if something has mass or acts by it.
    pub acts: bool,
}

impl Opening {
    /// True if the machine moves by such a statement: it is not about forces or results.
    pub(super) fn moves(&self) -> bool {
        const OTHERS: [&str; 7] =
            ["output", "numerics", "crate", "export", "gravity", "load", "friction"];
        !self.acts && !OTHERS.contains(&self.word)
    }
}

/// The end of a statement.
pub(super) enum Ending {
    Semicolon,
    /// Braces, with the fields that a message proposes.
    Braces(&'static str),
    /// Braces where it has some.
    Either,
}

/// The opening of a statement that ends with `;`.
const fn plain(
    word: &'static str,
    parse: fn(&mut Parser<'_>, &Ident) -> Parse<StatementKind>,
    begins: fn(&Parser<'_>) -> bool,
) -> Opening {
    Opening { word, parse, begins, ends: Ending::Semicolon, acts: false }
}

/// The opening of a statement by which something has mass or acts.
const fn acting(
    word: &'static str,
    parse: fn(&mut Parser<'_>, &Ident) -> Parse<StatementKind>,
    begins: fn(&Parser<'_>) -> bool,
) -> Opening {
    Opening { acts: true, ..plain(word, parse, begins) }
}

/// All of them; the first seven stand in every machine.
pub const OPENINGS: [Opening; 24] = [
    Opening {
        ends: Ending::Either,
        ..plain(
            "input",
            |parser, _| parser.input(),
            |parser| is_typed(parser) || is_named(parser) && parser.is_group(2, Delimiter::Brace),
        )
    },
    plain("param", |parser, _| parser.param(), is_typed),
    plain("let", |parser, _| parser.named_value(), is_named),
    plain("ground", |parser, _| parser.ground("ground"), is_called),
    plain("guide", |parser, _| parser.guide(), has_two_words),
    plain("point", |parser, _| parser.point(), has_two_words),
    plain("output", |parser, _| parser.output(), is_named),
    plain("numerics", |parser, _| parser.numerics(), is_named),
    plain("crate", |parser, _| parser.crate_path(), |parser| parser.is_punct(1, '=')),
    plain("export", |parser, _| parser.export(), is_named),
    plain(
        "gravity",
        |parser, word| parser.gravity(word.span()),
        |parser| parser.is_group(1, Delimiter::Parenthesis),
    ),
    plain(
        "load",
        |parser, _| parser.load(),
        |parser| is_named(parser) && [':', ','].iter().any(|&sign| parser.is_punct(2, sign)),
    ),
    acting("mass", |parser, _| parser.mass(), has_a_value),
    // It also stands inside a mass.
    acting("inertia", |parser, _| parser.inertia(), |_| false),
    // A load is of this kind.
    acting("force", |parser, _| parser.force(), has_a_value),
    acting("torque", |parser, _| parser.torque(), has_a_value),
    Opening {
        ends: Ending::Braces("{ stiffness: …, free_length: … }"),
        ..acting("spring", |parser, word| parser.spring(word), is_named)
    },
    // A load may have this name, as in `torque friction on AB`.
    plain(
        "friction",
        |parser, word| parser.friction(word.span()),
        |parser| {
            has_a_value(parser)
                && !["on", "at", "between"].iter().any(|word| parser.is_word(1, word))
        },
    ),
    Opening {
        ends: Ending::Braces("{ stiffness: …, damping: … }"),
        ..acting("stop", |parser, word| parser.stop(word), is_named)
    },
    plain(
        "unknown",
        |parser, _| parser.unknown(),
        |parser| is_named(parser) && parser.is_punct(2, ':'),
    ),
    Opening {
        ends: Ending::Braces("{ … }"),
        ..plain(
            "solve",
            |parser, _| parser.solve(),
            |parser| is_named(parser) && parser.is_group(2, Delimiter::Brace),
        )
    },
    plain("pin", |parser, _| parser.pins(), is_called),
    Opening { ends: Ending::Either, ..plain("link", |parser, word| parser.links(word), is_called) },
    plain(
        "drive",
        |parser, _| parser.drive(),
        |parser| is_named(parser) && (parser.is_punct(2, '.') || parser.is_word(2, "by")),
    ),
];

/// The row of a word.
pub(super) fn opening(word: &str) -> Option<&'static Opening> {
    OPENINGS.iter().find(|opening| opening.word == word)
}

/// The words.
pub(super) fn words() -> impl Iterator<Item = &'static str> {
    OPENINGS.iter().map(|opening| opening.word)
}

/// `let half …`
fn is_named(parser: &Parser<'_>) -> bool {
    parser.peek_ident(1).is_some()
}

/// `input theta:`
fn is_typed(parser: &Parser<'_>) -> bool {
    is_named(parser) && [':', ',', '='].iter().any(|&sign| parser.is_punct(2, sign))
}

/// `pin B(…)`, and the groups.
pub(super) fn is_called(parser: &Parser<'_>) -> bool {
    is_named(parser) && parser.is_group(2, Delimiter::Parenthesis)
}

/// `point P on …`
fn has_two_words(parser: &Parser<'_>) -> bool {
    is_named(parser) && parser.peek_ident(2).is_some()
}

/// `mass 2kg …`
fn has_a_value(parser: &Parser<'_>) -> bool {
    !matches!(parser.peek(1), Some(TokenTree::Punct(_)) | None)
}
