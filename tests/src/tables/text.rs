//! The reader of the tables' files. They are texts so that no compiler has to read the numbers.
//!
//! A table is a line `table NAME` and all lines up to the next one's. What follows a `#` is a
//! comment. Whoever reads a table panics where its text is anything but a table.

/// The lines of a table, without comments.
pub fn lines_of(text: &'static str, name: &str) -> impl Iterator<Item = &'static str> {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim());
    let mut lines = lines.filter(|line| !line.is_empty());
    let found = lines.any(|line| line.strip_prefix("table ") == Some(name));
    assert!(found, "no table {name}");
    lines.take_while(|line| !line.starts_with("table "))
}

/// The rest of the line behind its first word, which has to be this one.
pub fn after<'t>(word: &str, line: Option<&'t str>) -> &'t str {
    let line = line.unwrap_or_else(|| panic!("no line `{word} …`"));
    line.strip_prefix(word).unwrap_or_else(|| panic!("no `{word} …`: {line}")).trim()
}

/// The parts of a line.
pub fn parts(line: &str) -> impl Iterator<Item = &str> {
    line.split('|').map(str::trim)
}

/// The numbers of a part.
pub fn numbers(part: &str) -> Vec<f64> {
    let number = |word: &str| word.parse().unwrap_or_else(|_| panic!("no number: {word}"));
    part.split_whitespace().map(number).collect()
}

/// Exactly so many of something.
pub fn all_of<T, const N: usize>(found: impl IntoIterator<Item = T>) -> [T; N] {
    let found: Vec<T> = found.into_iter().collect();
    let count = found.len();
    found.try_into().unwrap_or_else(|_| panic!("{count} in place of {N}"))
}
