//! Texts as doc attributes, in lines of readable length.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Attribute;

/// The user's comments, then a paragraph of our own.
pub(in crate::codegen) fn after(own: &[Attribute], paragraph: &str) -> TokenStream {
    let gap = (!own.is_empty()).then(|| quote!(#[doc = ""]));
    let lines = lines(paragraph);
    quote!(#(#own)* #gap #lines)
}

/// One doc attribute of many lines: a token costs the compiler as much as a line does.
pub(in crate::codegen) fn lines(paragraph: &str) -> TokenStream {
    let mut text = String::with_capacity(paragraph.len() + paragraph.len() / 16 + 64);
    for (nth, line) in paragraph.lines().enumerate() {
        if nth > 0 {
            text.push('\n');
        }
        wrap(line, &mut text);
    }
    quote!(#[doc = #text])
}

/// The longest line of a doc comment.
pub const WIDTH: usize = 92;

/// Adds the line in lines of readable length, each behind a space; those that continue a list's item
/// are indented.
pub fn wrap(line: &str, text: &mut String) {
    if line.is_empty() {
        return;
    }
    text.push(' ');
    if line.len() <= WIDTH {
        return text.push_str(line);
    }
    let indent = if line.starts_with("- ") { "  " } else { "" };
    // The characters of the line that is being filled, and whether any of them is none of a space.
    let (mut filled, mut has_words) = (0, false);
    for word in line.split(' ') {
        let length = word.chars().count();
        if has_words && filled + length >= WIDTH {
            text.push_str("\n ");
            text.push_str(indent);
            filled = indent.len();
            has_words = false;
        } else if filled > 0 {
            text.push(' ');
            filled += 1;
        }
        text.push_str(word);
        filled += length;
        has_words |= length > 0;
    }
}
