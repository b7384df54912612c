//! Names in structured text: those of printed C wherever the language allows it.
//!
//! Upper and lower case are one, an underscore stands alone between letters or digits, and what the language or one of
//! two large vendors has for itself is no name.

use std::collections::HashSet;
use std::sync::LazyLock;

use crate::codegen::c::c_identifiers::ascii;

static RESERVED: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let lines = include_str!("reserved/words.txt").lines();
    lines.filter(|line| !line.starts_with('#')).flat_map(str::split_whitespace).collect()
});

/// True if nothing can have the name: a keyword, a type or a function of the language or of a vendor, or a name of the
/// run-time's.
fn is_reserved(name: &str) -> bool {
    let capitals = name.to_ascii_uppercase();
    let is_a_conversion = match (capitals.strip_prefix("TO_"), capitals.split_once("_TO_")) {
        (Some(to), _) => RESERVED.contains(to),
        (None, Some((from, to))) => RESERVED.contains(from) && RESERVED.contains(to),
        (None, None) => false,
    };
    is_a_conversion || RESERVED.contains(&capitals[..]) || capitals.starts_with("LINKAGE")
}

/// The names of one scope.
#[derive(Clone, Default)]
pub struct BlockNames {
    /// In capitals.
    taken: HashSet<String>,
}

impl BlockNames {
    /// A name of its own for this one, and the nearest to it.
    pub fn name(&mut self, wanted: &str) -> String {
        let mut name = plain(wanted);
        while is_reserved(&name) || self.taken.contains(&name.to_ascii_uppercase()) {
            name = format!("v_{name}");
        }
        self.taken.insert(name.to_ascii_uppercase());
        name
    }

    /// The names of a list, in its order.
    pub fn names<S: AsRef<str>>(&mut self, wanted: impl IntoIterator<Item = S>) -> Vec<String> {
        wanted.into_iter().map(|name| self.name(name.as_ref())).collect()
    }
}

/// The name without underscores that stand in front, behind, or side by side. The words of a function of the language
/// are written out.
fn plain(name: &str) -> String {
    match name {
        "cos" => return "cosine".to_string(),
        "sin" => return "sine".to_string(),
        _ => {}
    }
    let name = ascii(name);
    let words: Vec<&str> = name.split('_').filter(|word| !word.is_empty()).collect();
    let joined = words.join("_");
    if joined.starts_with(|first: char| first.is_ascii_alphabetic()) {
        joined
    } else {
        format!("v_{joined}")
    }
}

/// A text in quotation marks, of letters that a string of bytes holds.
pub fn quoted(text: &str) -> String {
    let letter = |letter: char| match letter {
        '\'' | '$' => ' ',
        ' '..='~' => letter,
        _ => '?',
    };
    // A string has room for 80 letters where nothing else is said.
    format!("'{}'", text.chars().map(letter).take(80).collect::<String>())
}
