//! Comments begin with a noun or a verb: *What*, *Whether*, *Of* and *How* make a reader wait for the
//! subject.

use std::path::Path;

use super::sources::visit;

/// Comments that still begin so, most of them documentation of declared mechanisms. The number only gets
/// lower.
const LEFT: usize = 34;

const OPENINGS: [&str; 4] = ["What", "Whether", "Of", "How"];

/// The text behind the slashes of a line that is a comment.
fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let text = ["///", "//!", "//"].iter().find_map(|slashes| line.strip_prefix(slashes))?;
    Some(text.trim())
}

/// The first lines of the comments in a source that begin with one of the openings.
fn found(source: &str) -> impl Iterator<Item = &str> {
    let lines = source.lines().map(comment);
    let before = std::iter::once(None).chain(lines.clone());
    lines.zip(before).filter_map(|(line, before)| {
        let is_first = before.is_none_or(str::is_empty);
        let word = line?.split(|sign: char| !sign.is_alphanumeric()).next()?;
        (is_first && OPENINGS.contains(&word)).then_some(line?)
    })
}

#[test]
fn comments_begin_with_a_noun_or_a_verb() {
    let mut all = Vec::new();
    let root = Path::new(&std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("..");
    visit(&root, &["rs"], &mut |path, source| {
        all.extend(found(source).map(|line| format!("{}: {line}", path.display())));
    });
    assert!(all.len() <= LEFT, "{} comments, {LEFT} before:\n{}", all.len(), all.join("\n"));
}

#[test]
fn openings_are_found_at_the_beginning_of_a_comment_alone() {
    let source = "/// What it is.\n/// How it is.\nfn f() {}\n// Often.\n\n//! Of it.\n/// The sum.\n///\n/// Whether.";
    assert_eq!(found(source).collect::<Vec<_>>(), ["What it is.", "Of it.", "Whether."]);
}
