//! Texts as doc attributes, in lines of readable length.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Attribute;

/// The user's comments, then a paragraph of our own.
pub(super) fn after(own: &[Attribute], paragraph: &str) -> TokenStream {
    let gap = (!own.is_empty()).then(|| quote!(#[doc = ""]));
    let lines = lines(paragraph);
    quote!(#(#own)* #gap #lines)
}

/// One doc attribute of many lines: a token costs the compiler as much as a line does.
pub(super) fn lines(paragraph: &str) -> TokenStream {
    let spaced = |line: String| if line.is_empty() { line } else { format!(" {line}") };
    let text: Vec<String> = paragraph.lines().flat_map(wrapped).map(spaced).collect();
    let text = text.join("\n");
    quote!(#[doc = #text])
}

/// The longest line of a doc comment.
const WIDTH: usize = 92;

/// The line in lines of readable length; those that continue a list's item are indented.
fn wrapped(line: &str) -> Vec<String> {
    if line.len() <= WIDTH {
        return vec![line.to_string()];
    }
    let indent = if line.starts_with("- ") { "  " } else { "" };
    let mut lines = vec![String::new()];
    for word in line.split(' ') {
        let current = lines.last_mut().expect("there is a line from the start");
        if !current.trim().is_empty() && current.chars().count() + word.chars().count() >= WIDTH {
            lines.push(format!("{indent}{word}"));
        } else {
            if !current.is_empty() {
                current.push(' ');
            }
            current.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_wrapped_and_their_words_kept() {
        let words = vec!["word"; 40].join(" ");
        let lines = wrapped(&format!("- {words}"));
        assert!(lines.iter().all(|line| line.len() <= WIDTH), "{lines:?}");
        assert!(lines[1].starts_with("  word") && lines.len() == 3, "{lines:?}");
        let text: Vec<&str> = lines.iter().flat_map(|line| line.split_whitespace()).collect();
        assert_eq!(text.join(" "), format!("- {words}"));
        assert_eq!(wrapped("short"), ["short"]);
        assert_eq!(wrapped(""), [""]);
    }
}
