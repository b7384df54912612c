//! Short names in place of those that are written in the page's files.
//!
//! A word has one short name in all files, whatever it names: a constant, a parameter, a field. Thus no scope has to be
//! known, and `{ pose }` still is a field of its variable's name. Words of the language and of the browser stay, and so do
//! keys that texts name: other keys that texts name stand in quotes. Short names are the shorter the more often their words are
//! written, and are alike on all pages.

use std::collections::{BTreeMap, BTreeSet};
use std::string::{String, ToString};
use std::sync::OnceLock;
use std::vec::Vec;

use super::page_files::every_file;
use super::squeeze::{Names, squeezed};

/// Words that stay, under a comment of what they are.
const KEPT: &str = include_str!("kept_words.txt");

/// Files of JavaScript, one behind the other, with the short names of a page.
pub(super) fn script(files: &[&str]) -> String {
    squeezed(files, of_pages(), &mut |_| ())
}

/// A script that runs on a page beside the page's own, with the names that everything has there.
#[must_use]
pub fn shortened(file: &str) -> String {
    script(&[file])
}

/// The short names of all pages.
fn of_pages() -> &'static Names {
    static NAMES: OnceLock<Names> = OnceLock::new();
    NAMES.get_or_init(|| {
        let mut counts = BTreeMap::<String, usize>::new();
        let mut count = |word: &str| *counts.entry(word.to_string()).or_default() += 1;
        squeezed(&every_file(), &Names::default(), &mut count);
        let kept: BTreeSet<&str> = kept().collect();
        let is_own = |(word, _): &(String, usize)| !kept.contains(&word[..]);
        let mut words: Vec<_> = counts.into_iter().filter(is_own).collect();
        words.sort_by(|(a, first), (b, second)| second.cmp(first).then_with(|| a.cmp(b)));
        let written: BTreeSet<&str> = words.iter().map(|(word, _)| &word[..]).collect();
        let shorts: Vec<String> = shorts(&written).take(words.len()).collect();
        Names(words.into_iter().map(|(word, _)| word).zip(shorts).collect())
    })
}

/// Words that stay.
fn kept() -> impl Iterator<Item = &'static str> {
    KEPT.lines().filter(|line| !line.starts_with('#')).flat_map(str::split_whitespace)
}

/// Names of one letter, a small one only where the files have it as a word, then of a letter with a capital or a digit: what
/// others write beside a page is none of them.
fn shorts(written: &BTreeSet<&str>) -> impl Iterator<Item = String> {
    let kept: BTreeSet<&str> = kept().collect();
    let small = ('a'..='z').map(String::from).filter(|letter| written.contains(&letter[..]));
    let letters = || ('a'..='z').chain('A'..='Z');
    let pairs = letters().flat_map(|first| {
        ('A'..='Z').chain('0'..='9').map(move |second| String::from_iter([first, second]))
    });
    let all = small.chain(('A'..='Z').map(String::from)).chain(pairs);
    all.filter(move |name| !kept.contains(&name[..]))
}

#[cfg(test)]
mod tests {
    use std::format;

    use super::*;

    #[test]
    fn a_word_has_one_short_name_wherever_it_stands() {
        let names = of_pages();
        assert!(names.0.len() > 800, "{}", names.0.len());
        let shorts: BTreeSet<&String> = names.0.values().collect();
        assert_eq!(shorts.len(), names.0.len());
        assert!(
            kept().all(|word| names.short(word) == word && !shorts.contains(&word.to_string()))
        );
        // Others beside a page write small letters, and words of small letters.
        let is_small = |short: &&&String| !short.contains(|c: char| !c.is_ascii_lowercase());
        assert!(shorts.iter().filter(is_small).all(|short| names.0.contains_key(*short)));
        let (pose, seen) = (names.short("pose"), names.short("seenFrom"));
        let found =
            script(&["const { pose } = seenFrom(`pose ${pose.x}`, \"pose\", 1e5, /pose/g);"]);
        assert_eq!(
            found,
            format!("let{{{pose}}}={seen}(`pose ${{{pose}.x}}`,\"pose\",1e5,/pose/g);")
        );
    }

    /// A word that is kept in vain would stay long, and so would one whose last use is gone.
    #[test]
    fn every_kept_word_is_written() {
        let mut written = BTreeSet::new();
        squeezed(&every_file(), &Names::default(), &mut |word| {
            written.insert(word.to_string());
        });
        let vain: Vec<_> = kept().filter(|&word| !written.contains(word)).collect();
        assert!(vain.is_empty(), "{vain:?}");
    }

    /// A function or a field of the browser's that has no place among the kept words is asked for, and made nowhere. A key
    /// that texts name is read nowhere.
    #[test]
    fn every_short_name_is_one_of_the_files_own() {
        let files = squeezed(&every_file(), &Names::default(), &mut |_| ());
        let words = || of_pages().0.keys();
        let foreign: Vec<_> = words().filter(|word| !is_made(word, &files)).collect();
        // A machine's constants are printed.
        assert_eq!(foreign, ["MACHINE", "PLAN", "SETS", "curves", "outputs"]);
        let is_key = |word: &&String| uses(word, &files).all(|(_, behind)| behind.starts_with(':'));
        let keys: Vec<_> = words().filter(is_key).collect();
        assert!(keys.is_empty(), "in quotes they would stay: {keys:?}");
        assert!(!is_made("closest", "a.closest(b);closest(c)") && is_made("b", "let{a,b}=c"));
        assert!(is_made("a", "class A{a(b){c}}") && is_made("a", "c.a=b"));
        assert!(!is_made("a", "c.a==b") && !is_made("a", "x={\"a\":1}"));
    }

    /// Where a word stands: what is before it, and behind it.
    fn uses<'a>(word: &'a str, text: &'a str) -> impl Iterator<Item = (&'a str, &'a str)> {
        let is_letter = |letter: char| letter.is_alphanumeric() || "_$\"".contains(letter);
        let uses = text.match_indices(word).map(|(at, _)| (&text[..at], &text[at + word.len()..]));
        uses.filter(move |(before, behind)| {
            !before.ends_with(is_letter) && !behind.starts_with(is_letter)
        })
    }

    /// True where a word is declared, is a parameter or is a field that is set.
    fn is_made(word: &str, text: &str) -> bool {
        uses(word, text).any(|(before, behind)| {
            let is_set = behind.starts_with('=') && !behind.starts_with("==");
            let is_member = before.ends_with('.') && !before.ends_with("...");
            let is_named =
                behind.starts_with([',', ':', ')', '}', ']']) || behind.starts_with(" of ");
            let is_method = behind.split_once(')').is_some_and(|(given, body)| {
                let begins = before.ends_with(['}', '{', '\n', '#', ' ']);
                begins && given.starts_with('(') && body.starts_with('{')
            });
            is_set || (!is_member && (is_named || is_method || before.ends_with("class ")))
        })
    }
}
