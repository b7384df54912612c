//! Parts of an expansion that are compared by themselves. But for the declaration, all are of the texts of its
//! tokens, in which the delimiters of a group are tokens.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

/// The declaration with `export c;`.
pub(super) fn exported(declaration: &TokenStream) -> TokenStream {
    let mut trees: Vec<_> = declaration.clone().into_iter().collect();
    let Some(TokenTree::Group(body)) = trees.pop() else {
        panic!("a declaration ends with its body")
    };
    let statements = body.stream();
    let is_word = |tree: TokenTree| matches!(&tree, TokenTree::Ident(word) if word == "export");
    let asked =
        if statements.clone().into_iter().any(is_word) { quote!() } else { quote!(export c;) };
    let body = Group::new(Delimiter::Brace, quote!(#statements #asked));
    trees.into_iter().chain([body.into()]).collect()
}

/// The text of `C_HEADER`.
pub(super) fn header(texts: &[String]) -> Option<&str> {
    let at = texts.iter().position(|text| text == "C_HEADER")?;
    texts[at..].iter().map(String::as_str).find(|text| is_string(text))
}

fn is_string(text: &str) -> bool {
    text.starts_with(['"', 'r']) && text.ends_with(['"', '#']) && text.len() > 1
}

/// The place behind the group that is opened here.
fn end_of_group(texts: &[String], open: usize) -> usize {
    let mut depth = 0;
    let end = texts[open..].iter().position(|text| {
        match &text[..] {
            "(" | "{" | "[" | "<none>" => depth += 1,
            ")" | "}" | "]" | "</none>" => depth -= 1,
            _ => {}
        }
        depth == 0
    });
    open + 1 + end.expect("every group ends")
}

/// The tokens without documentation.
pub(super) fn without_docs(texts: &[String]) -> Vec<&str> {
    let (mut kept, mut at) = (Vec::new(), 0);
    while let Some(text) = texts.get(at) {
        let is_doc = text.starts_with('#')
            && texts[at + 1..].starts_with(&["[".to_string(), "doc".to_string()]);
        if is_doc {
            at = end_of_group(texts, at + 1);
        } else {
            kept.push(&text[..]);
            at += 1;
        }
    }
    kept
}

/// The lines of documentation, in order.
pub(super) fn docs(texts: &[String]) -> Vec<&str> {
    let lines = texts.windows(3).filter(|three| {
        let [word, sign, line] = three else { return false };
        word == "doc" && sign == "=" && is_string(line)
    });
    lines.map(|three| &three[2][..]).collect()
}

/// Splits the expansion of a declaration that can be drawn: the code without the drawing, and the drawing.
pub(super) fn taken_apart(texts: &[String]) -> [Vec<&str>; 2] {
    let (mut solver, mut drawing) = (Vec::new(), Vec::new());
    let mut at = 0;
    while let Some(text) = texts.get(at) {
        // `private::with_sketch! { … }` is five tokens and a group.
        let is_drawing = text == "with_sketch" && texts.get(at + 1).is_some_and(|sign| sign == "!");
        if is_drawing {
            solver.truncate(solver.len() - 3);
            let end = end_of_group(texts, at + 2);
            drawing.extend(texts[at + 3..end - 1].iter().map(String::as_str));
            at = end;
        } else {
            solver.push(&text[..]);
            at += 1;
        }
    }
    [solver, drawing]
}
