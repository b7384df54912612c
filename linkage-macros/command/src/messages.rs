//! Mistakes and notes as rustc shows them: message, place, the line with its tokens underlined, and what is to be said
//! of it below.

use linkage_compiler::{Diagnostic, Level};
use proc_macro2::LineColumn;

use crate::style::{Part, Style};

/// The mark of a line that is cut.
const CUT: &str = "...";
/// The least room for a line of the source, however narrow the terminal is.
const LEAST: usize = 20;

/// Tokens in the text of a source.
pub(crate) struct Place<'s> {
    /// The name of the source.
    pub name: String,
    pub text: &'s str,
    pub from: LineColumn,
    pub to: LineColumn,
}

/// The first line of some tokens, cut where it is long, and what underlines them.
struct Shown {
    line: String,
    blanks: String,
    marks: String,
}

/// The word of a level.
pub(crate) fn word(level: Level) -> &'static str {
    match level {
        Level::Mistake => "error",
        Level::Note => "note",
    }
}

/// A message at its place.
pub(crate) fn text(diagnostic: &Diagnostic, place: &Place<'_>, style: Style) -> String {
    let (word, colour) = (word(diagnostic.level), Part::Level(diagnostic.level));
    let number = place.from.line.to_string();
    let margin = " ".repeat(number.len());
    let shown = shown(place, style.width.saturating_sub(number.len() + 3).max(LEAST));
    let frame = |sign| style.paint(Part::Frame, sign);
    let (bar, marks) = (frame("|"), style.paint(colour, &shown.marks));
    let message = style.paint(Part::Message, &format!(": {}", diagnostic.message));
    let mut lines = vec![
        format!("{}{message}", style.paint(colour, word)),
        format!("{margin}{} {}:{number}:{}", frame("-->"), place.name, place.from.column + 1),
        format!("{margin} {bar}"),
        format!("{} {bar} {}", frame(&number), shown.line),
        format!("{margin} {bar} {}{marks}", shown.blanks),
    ];
    let mut note = diagnostic.note.iter().flat_map(|note| note.lines());
    if let Some(first) = note.next() {
        let head = style.paint(Part::Message, "help");
        lines.push(format!("{margin} {bar}"));
        lines.push(format!("{margin} {} {head}: {first}", frame("=")));
        lines.extend(note.map(|line| format!("{margin}         {line}")));
    }
    lines.join("\n") + "\n"
}

/// The line in so many characters: where it is longer, as much is left in front of the tokens as behind them.
fn shown(place: &Place<'_>, width: usize) -> Shown {
    let line = place.text.lines().nth(place.from.line.saturating_sub(1)).unwrap_or_default();
    let line: Vec<char> = line.trim_end().chars().collect();
    let from = place.from.column.min(line.len());
    // Tokens of several lines are underlined to the end of the first, and what is missing behind a line by one mark.
    let to = if place.to.line == place.from.line { place.to.column } else { line.len() };
    let to = to.max(from + 1);
    let (start, end) = match line.len().checked_sub(width.saturating_sub(2 * CUT.len())) {
        Some(surplus) if line.len() > width => {
            let room = line.len() - surplus;
            let start = from.saturating_sub(room.saturating_sub(to - from) / 2).min(surplus);
            (start, start + room)
        }
        _ => (0, line.len()),
    };
    let cut = |is_cut: bool| if is_cut { CUT } else { "" };
    let [front, back] = [cut(start > 0), cut(end < line.len())];
    let blank = |&letter: &char| if letter == '\t' { '\t' } else { ' ' };
    let blanks: String = line[start..from].iter().map(blank).collect();
    Shown {
        line: format!("{front}{}{back}", String::from_iter(&line[start..end])),
        blanks: " ".repeat(front.len()) + &blanks,
        marks: "^".repeat(to.min(end.max(from + 1)) - from),
    }
}
