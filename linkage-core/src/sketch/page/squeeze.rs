//! Scripts and styles without what only their authors read: comments, indents, and spaces beside signs.
//!
//! Lines that a sign ends are joined with the next one; elsewhere the end of a line may end a statement. Texts
//! and regular expressions stay as they are; a slash begins one of these behind a sign
//! or at the start of a line, and divides elsewhere.

use std::string::String;

/// Files of JavaScript, one behind the other.
pub(super) fn script(files: &[&str]) -> String {
    let mut squeezed = String::new();
    for line in files.iter().flat_map(|file| file.lines().map(str::trim)) {
        if !line.is_empty() && !line.starts_with("//") {
            if line.starts_with('}') && squeezed.ends_with(';') {
                squeezed.pop();
            }
            squeeze(line, &mut squeezed);
            if !line.ends_with(['{', '(', '[', ',', ';']) {
                squeezed.push('\n');
            }
        }
    }
    squeezed
}

fn squeeze(line: &str, to: &mut String) {
    let start = to.len();
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        let before = to[start..].chars().next_back();
        match letter {
            '"' | '\'' | '`' => text(letter, &mut letters, to),
            '/' if before.is_none_or(|before| "(,=:[!&|?{};>".contains(before)) => {
                text('/', &mut letters, to);
            }
            ' ' => {
                let after = letters.peek().copied();
                // Two signs of one kind would be another operator.
                let is_needed = before.zip(after).is_some_and(|(a, b)| {
                    (is_word(a) && is_word(b)) || (a == b && "+-".contains(a))
                });
                if is_needed {
                    to.push(' ');
                }
            }
            letter => to.push(letter),
        }
    }
}

/// Copies a text up to its end; a backslash takes the letter behind it along, and so does a class of letters
/// of a regular expression.
fn text(quote: char, letters: &mut impl Iterator<Item = char>, to: &mut String) {
    to.push(quote);
    let mut is_in_class = false;
    while let Some(letter) = letters.next() {
        to.push(letter);
        match letter {
            '\\' => to.extend(letters.next()),
            '[' if quote == '/' => is_in_class = true,
            ']' => is_in_class = false,
            letter if letter == quote && !is_in_class => return,
            _ => {}
        }
    }
}

fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || "_$#\"'`".contains(letter)
}

/// A style.
pub(super) fn style(text: &str) -> String {
    let mut squeezed: String = text.lines().map(str::trim).collect();
    for (spaced, tight) in
        [(": ", ":"), (", ", ","), (" {", "{"), ("{ ", "{"), ("; ", ";"), (";}", "}")]
    {
        squeezed = squeezed.replace(spaced, tight);
    }
    squeezed
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    #[test]
    fn spaces_go_where_they_say_nothing() {
        for (written, squeezed) in [
            ("const a = b + c;", "const a=b+c;"),
            ("  x - -y + +z", "x- -y+ +z\n"),
            ("return [a, \"b,  c\"];", "return[a,\"b,  c\"];"),
            ("`a ${b + c} d` + 'x \\' y' ", "`a ${b + c} d`+'x \\' y'\n"),
            ("a / b / c", "a/b/c\n"),
            ("s.replace(/a b[/ ]\" c/g, x)", "s.replace(/a b[/ ]\" c/g,x)\n"),
            ("// all of it", ""),
            ("a = {\n  b: [\n    1,\n  ],\n};\nc", "a={b:[1,],};c\n"),
            (
                "const f = () => {\n  g();\n};\nclass A {\n  b = 1;\n}\nf(\n  a\n    + b)",
                "const f=()=>{g()};class A{b=1}\nf(a\n+b)\n",
            ),
            ("case \"x\" in y", "case \"x\" in y\n"),
        ] {
            assert_eq!(script(&[written]), squeezed, "{written}");
        }
        assert_eq!(style("a b { c: d, e;\n  f: g; }\n"), "a b{c:d,e;f:g}");
    }

    /// The lines on which a template begins within another one's expression: its end would be taken for the outer one's.
    fn nested_templates(text: &str) -> Vec<usize> {
        let (mut found, mut open, mut line) = (Vec::new(), Vec::new(), 1);
        let mut letters = text.chars().peekable();
        while let Some(letter) = letters.next() {
            line += usize::from(letter == '\n');
            match (open.last(), letter) {
                (Some('`' | '"' | '\''), '\\') => drop(letters.next()),
                (Some(&quote @ ('`' | '"' | '\'')), letter) if letter == quote => drop(open.pop()),
                (Some('`'), '$') if letters.next_if_eq(&'{').is_some() => open.push('{'),
                (Some('`' | '"' | '\''), _) => {}
                (_, '/') if letters.peek() == Some(&'/') => {
                    while letters.next_if(|&letter| letter != '\n').is_some() {}
                }
                (_, '`') => {
                    if open.contains(&'`') {
                        found.push(line);
                    }
                    open.push('`');
                }
                (_, '{' | '"' | '\'') => open.push(letter),
                (Some('{'), '}') => drop(open.pop()),
                _ => {}
            }
        }
        found
    }

    #[test]
    fn no_template_stands_within_a_template() {
        assert_eq!(nested_templates("`a ${b.map((c) => `${c}`)}`"), [1]);
        assert_eq!(nested_templates("`a ${\"`\"}` + `b` // `${`\n"), [0; 0]);
        use crate::sketch::page::assembled::{ARITHMETIC, FRICTION, READS, SEARCH, SHOWS};
        for file in [&ARITHMETIC[..], &SEARCH, &FRICTION, &READS, &SHOWS].concat() {
            let head = file.lines().next().unwrap_or_default();
            assert_eq!(nested_templates(file), [0; 0], "{head}");
        }
    }
}
