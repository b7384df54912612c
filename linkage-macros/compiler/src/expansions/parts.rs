//! Parts of an expansion that are compared by themselves.

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
pub(super) fn header(stream: TokenStream) -> Option<String> {
    let mut trees = stream.into_iter();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                if let Some(found) = header(group.stream()) {
                    return Some(found);
                }
            }
            TokenTree::Ident(name) if name == "C_HEADER" => {
                return trees.find_map(|tree| match tree {
                    TokenTree::Literal(text) => Some(text.to_string()),
                    _ => None,
                });
            }
            _ => {}
        }
    }
    None
}

/// The tokens without documentation.
pub(super) fn without_docs(stream: TokenStream) -> TokenStream {
    let mut kept = Vec::<TokenTree>::new();
    for tree in stream {
        let TokenTree::Group(group) = tree else {
            kept.push(tree);
            continue;
        };
        let first = group.stream().into_iter().next();
        let is_doc = matches!(first, Some(TokenTree::Ident(word)) if word == "doc");
        let is_attribute = group.delimiter() == Delimiter::Bracket
            && matches!(kept.last(), Some(TokenTree::Punct(sign)) if sign.as_char() == '#');
        if is_doc && is_attribute {
            kept.pop();
        } else {
            kept.push(Group::new(group.delimiter(), without_docs(group.stream())).into());
        }
    }
    kept.into_iter().collect()
}

/// The lines of documentation, in order.
pub(super) fn docs(stream: TokenStream) -> Vec<String> {
    let (mut lines, mut last) = (Vec::new(), [String::new(), String::new()]);
    for tree in stream {
        match &tree {
            TokenTree::Group(group) => lines.extend(docs(group.stream())),
            TokenTree::Literal(text) if last == ["doc", "="] => lines.push(text.to_string()),
            _ => {}
        }
        let [_, before] = last;
        last = [before, tree.to_string()];
    }
    lines
}

/// Splits the expansion of a declaration that can be drawn: the code without the drawing, and the drawing.
pub(super) fn taken_apart(stream: TokenStream) -> (TokenStream, TokenStream) {
    let (mut solver, mut drawing) = (Vec::<TokenTree>::new(), TokenStream::new());
    for tree in stream {
        let TokenTree::Group(group) = tree else {
            solver.push(tree);
            continue;
        };
        // `private::with_sketch! { … }` is five tokens and a group.
        let called =
            solver.iter().rev().nth(1).is_some_and(
                |tree| matches!(tree, TokenTree::Ident(name) if name == "with_sketch"),
            );
        if called {
            solver.truncate(solver.len() - 5);
            drawing.extend(group.stream());
            continue;
        }
        let (inner, drawn) = taken_apart(group.stream());
        solver.push(Group::new(group.delimiter(), inner).into());
        drawing.extend(drawn);
    }
    (solver.into_iter().collect(), drawing)
}
