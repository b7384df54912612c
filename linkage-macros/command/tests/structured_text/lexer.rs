//! The words, numbers, texts and signs of structured text.

/// Words in capitals, numbers, texts and signs.
pub(crate) fn tokens(text: &str) -> Vec<String> {
    let (mut found, mut rest) = (Vec::new(), text.trim_start());
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '(' if rest.starts_with("(*") => {
                let end = rest.find("*)").expect("a comment ends");
                rest = rest[end + 2..].trim_start();
                continue;
            }
            '\'' => rest[1..].find('\'').expect("a text ends") + 2,
            'A'..='Z' | 'a'..='z' => {
                rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap()
            }
            '0'..='9' => number(rest),
            _ => [":=", "<=", ">=", "<>", ".."]
                .iter()
                .find(|s| rest.starts_with(**s))
                .map_or(1, |s| s.len()),
        };
        let (token, behind) = rest.split_at(length);
        assert!(token.is_ascii(), "`{token}` is no sign of the language");
        found.push(if first == '\'' { token.to_string() } else { token.to_uppercase() });
        rest = behind.trim_start();
    }
    found
}

/// The length of a number; that of a range ends in front of its points.
fn number(text: &str) -> usize {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let mut length = digits(text);
    if text[length..].starts_with('.') && !text[length..].starts_with("..") {
        length += 1 + digits(&text[length + 1..]);
        if text[length..].starts_with('E') {
            length += 1 + usize::from(text[length + 1..].starts_with(['-', '+']));
            length += digits(&text[length..]);
        }
    }
    length
}
