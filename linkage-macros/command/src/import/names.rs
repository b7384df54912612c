//! Names of the declaration: what came from elsewhere as identifiers, each for one thing.

use std::collections::HashMap;

/// Words that are no identifiers in Rust.
const RESERVED: &[&str] = &[
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

/// The kinds of things that have names of their own where a machine comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Kind {
    Pin,
    Link,
    Guide,
    Input,
    Force,
}

/// The names that are taken.
#[derive(Default)]
pub(crate) struct Names {
    of: HashMap<(Kind, String), String>,
}

impl Names {
    /// The name of a thing: its own as an identifier, with a number where another thing has that.
    pub(crate) fn of(&mut self, kind: Kind, id: &str) -> String {
        if let Some(name) = self.of.get(&(kind, id.to_string())) {
            return name.clone();
        }
        let wanted = identifier(id);
        let is_taken = |name: &String| self.of.values().any(|taken| taken == name);
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut names = std::iter::once(wanted.clone()).chain(numbered);
        let name = names.find(|name| !is_taken(name)).unwrap_or(wanted.clone());
        self.of.insert((kind, id.to_string()), name.clone());
        name
    }
}

/// The identifier that is nearest to a text.
fn identifier(text: &str) -> String {
    let mut name: String =
        text.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if name.chars().next().is_none_or(|first| first.is_ascii_digit()) {
        name.insert(0, 'n');
    }
    if RESERVED.contains(&&name[..]) {
        name.push('_');
    }
    name
}

/// The name of a solver: words that begin with a capital, without anything between.
pub(crate) fn of_solver(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let capital = |word: &str| {
        let (first, rest) = word.split_at(1);
        first.to_ascii_uppercase() + rest
    };
    match words.map(capital).collect::<String>() {
        name if name.is_empty() => "Machine".to_string(),
        name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("Machine{name}"),
        name => identifier(&name),
    }
}
