//! Mistakes as rustc shows them: message, place, and the line with the mistake underlined.

use std::path::Path;

use linkage_compiler::Diagnostic;

/// The message of a mistake in the text of a file.
pub(crate) fn text(mistake: &Diagnostic, path: &Path, source: &str) -> String {
    let (start, end) = (mistake.first.start(), mistake.last.end());
    let number = start.line.to_string();
    let margin = " ".repeat(number.len());
    let line = source.lines().nth(start.line.saturating_sub(1)).unwrap_or_default();
    let length = line.chars().count();
    // A mistake of several lines is underlined to the end of its first.
    let last = if end.line == start.line { end.column } else { length };
    let marks = "^".repeat(last.saturating_sub(start.column).max(1));
    let before: String = line.chars().take(start.column).map(blank).collect();
    let note = mistake.note.iter().flat_map(|note| note.lines());
    let note: String = note.map(|line| format!("\n       {line}")).collect();
    format!(
        "error: {}{note}\n{margin}--> {}:{number}:{}\n{margin} |\n{number} | {line}\n{margin} | {before}{marks}\n",
        mistake.message,
        path.display(),
        start.column + 1,
    )
}

/// A blank as wide as the letter above.
fn blank(letter: char) -> char {
    if letter == '\t' { '\t' } else { ' ' }
}
