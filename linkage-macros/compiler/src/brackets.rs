//! Which bracket of a text is at fault, where the text is no sequence of tokens.

use std::ops::Range;

/// The first bracket that is not closed or that closes nothing: its bytes, and what is wrong with it. Brackets in comments
/// and in quotes do not count. Nothing where all of them are in pairs.
///
/// ```
/// let (at, why) = linkage_compiler::unbalanced("ground A(0, 0;\n}").expect("it is not closed");
/// assert_eq!((at, &why[..]), (8..9, "`(` is not closed"));
/// ```
#[must_use]
pub fn unbalanced(text: &str) -> Option<(Range<usize>, String)> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        let here = at;
        at += skipped(&text[here..]).max(letter.len_utf8());
        let opening = match letter {
            '(' | '[' | '{' => {
                open.push((here, letter));
                continue;
            }
            ')' => '(',
            ']' => '[',
            '}' => '{',
            _ => continue,
        };
        match open.pop() {
            Some((_, last)) if last == opening => {}
            Some((from, last)) => return Some(fault(from, last, "is not closed")),
            None => return Some(fault(here, letter, "closes nothing")),
        }
    }
    open.pop().map(|(from, last)| fault(from, last, "is not closed"))
}

fn fault(at: usize, bracket: char, what: &str) -> (Range<usize>, String) {
    (at..at + bracket.len_utf8(), format!("`{bracket}` {what}"))
}

/// The bytes of the comment, the quoted text or the name that this text begins with; zero where it begins with none.
fn skipped(text: &str) -> usize {
    let until = |end: &str, from: usize| text[from..].find(end).map(|at| from + at + end.len());
    let whole = text.len();
    match text.as_bytes() {
        [b'/', b'/', ..] => until("\n", 2).unwrap_or(whole),
        [b'/', b'*', ..] => nested_comment(text),
        [b'"', ..] => quoted(text, '"'),
        [b'\'', b'\\', ..] => quoted(text, '\''),
        // One letter in quotes; anything else is a lifetime, or the mark of a name.
        [b'\'', ..] => {
            let mut letters = text.char_indices().skip(2);
            letters.next().filter(|(_, end)| *end == '\'').map_or(0, |(at, _)| at + 1)
        }
        _ => {
            let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
            let name = text.find(|letter| !is_part(letter)).unwrap_or(whole);
            let marks = text[name..].bytes().take_while(|byte| *byte == b'#').count();
            let is_raw =
                matches!(&text[..name], "r" | "br" | "cr") && text[name + marks..].starts_with('"');
            if !is_raw {
                return name;
            }
            until(&format!("\"{}", "#".repeat(marks)), name + marks + 1).unwrap_or(whole)
        }
    }
}

/// The bytes of a text in quotes, a backslash taking the letter behind it along.
fn quoted(text: &str, quote: char) -> usize {
    let mut is_taken = true;
    for (at, letter) in text.char_indices() {
        match letter {
            _ if is_taken => is_taken = false,
            '\\' => is_taken = true,
            _ if letter == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}

fn nested_comment(text: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        let step = match text.as_bytes()[at..] {
            [b'/', b'*', ..] => 1,
            [b'*', b'/', ..] => -1,
            _ => 0,
        };
        depth += step;
        at += if step == 0 { 1 } else { 2 };
        if depth == 0 {
            return at;
        }
    }
    text.len()
}
