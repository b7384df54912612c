//! Mistakes in other words, and those of several readings of one declaration.

use super::{Diagnostic, Diagnostics, Extent, Level, place};

impl Diagnostic {
    /// True if it says the same as another at the same place.
    pub(crate) fn is(&self, other: &Self) -> bool {
        place(self.first) == place(other.first) && self.text() == other.text()
    }

    /// True if another set of inputs, which is read earlier, has said it: a mistake at the same tokens, or a note in the same
    /// words.
    #[must_use]
    pub fn is_told_by(&self, earlier: &Self) -> bool {
        match (self.level, earlier.level) {
            (Level::Mistake, Level::Mistake) => self.is_at(earlier),
            (Level::Note, Level::Note) => self.is_at(earlier) && self.is(earlier),
            (Level::Mistake, Level::Note) | (Level::Note, Level::Mistake) => false,
        }
    }

    /// True if it is about the same tokens as another.
    pub(crate) fn is_at(&self, other: &Self) -> bool {
        [(self.first, other.first), (self.last, other.last)]
            .iter()
            .all(|(a, b)| place(*a) == place(*b))
    }

    /// True if it begins among these tokens.
    pub(crate) fn is_within(&self, tokens: Extent) -> bool {
        (place(tokens.first)..=place(tokens.last)).contains(&place(self.first))
    }
}

impl Diagnostics {
    /// Takes the mistakes behind the first so many.
    pub(crate) fn take_since(&mut self, count: usize) -> Vec<Diagnostic> {
        self.mistakes.split_off(count)
    }

    /// Adds what was found in one of several readings of a declaration, but for what another reading has found as well.
    pub(crate) fn add_new(&mut self, found: Vec<Diagnostic>) {
        for mistake in found {
            if !self.mistakes.iter().any(|other| other.is(&mistake)) {
                self.mistakes.push(mistake);
            }
        }
    }

    /// Tells words of the messages so far in other words, the first of each pair by the second.
    pub(crate) fn tell(&mut self, words: &[[String; 2]]) {
        for diagnostic in self.mistakes.iter_mut().chain(&mut self.notes) {
            for [from, to] in words {
                diagnostic.message = in_place_of(&diagnostic.message, from, to);
                diagnostic.note = diagnostic.note.as_ref().map(|note| in_place_of(note, from, to));
            }
        }
    }
}

/// The text with words replaced, where no letter goes on on either side.
fn in_place_of(text: &str, from: &str, to: &str) -> String {
    let goes_on = |letter: Option<char>| letter.is_some_and(|it| it.is_alphanumeric() || it == '_');
    let (mut told, mut rest) = (String::new(), text);
    while let Some(at) = rest.find(from) {
        let behind = at + from.len();
        let before = told.chars().chain(rest[..at].chars()).next_back();
        let is_word = !goes_on(before) && !goes_on(rest[behind..].chars().next());
        told += &rest[..at];
        told += if is_word { to } else { from };
        rest = &rest[behind..];
    }
    told + rest
}
