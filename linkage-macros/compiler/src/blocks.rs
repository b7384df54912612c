//! The declarations in a program.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Finds the declarations in the tokens of a Rust program: what stands in the braces of each `mechanism! { … }`, at
/// any depth and in the order of the source. One that another macro fills in, with a `$`, is none.
///
/// ```
/// let source = "mod arm { mechanism! { struct Arm { input t: angle; } } }";
/// let found = linkage_compiler::declarations(source.parse().expect("these are tokens"));
/// assert_eq!(found.len(), 1);
/// assert!(found[0].to_string().starts_with("struct Arm"));
/// ```
pub fn declarations(source: TokenStream) -> Vec<TokenStream> {
    let mut found = Vec::new();
    add(source, &mut found);
    found
}

fn add(stream: TokenStream, found: &mut Vec<TokenStream>) {
    let mut before = [String::new(), String::new()];
    for tree in stream {
        if let TokenTree::Group(group) = &tree {
            let is_declaration =
                before == ["mechanism", "!"] && group.delimiter() != Delimiter::None;
            match is_declaration && !has_dollar(group.stream()) {
                true => found.push(group.stream()),
                false => add(group.stream(), found),
            }
        }
        let [_, last] = before;
        // Brackets are no name, and need no text of all that is in them.
        let is_bracketed =
            matches!(&tree, TokenTree::Group(group) if group.delimiter() != Delimiter::None);
        before = [last, if is_bracketed { String::new() } else { tree.to_string() }];
    }
}

fn has_dollar(stream: TokenStream) -> bool {
    stream.into_iter().any(|tree| match tree {
        TokenTree::Group(group) => has_dollar(group.stream()),
        TokenTree::Punct(punct) => punct.as_char() == '$',
        _ => false,
    })
}
