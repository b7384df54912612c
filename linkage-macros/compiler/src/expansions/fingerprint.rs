//! Hashes of tokens that mean the same on every machine and under every compiler.

use std::collections::HashMap;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The hash of the tokens as they are.
pub(super) fn exact(stream: TokenStream) -> String {
    hash(&texts(stream))
}

/// The hash of the tokens after the generated locals of each function are numbered in the order of their
/// bindings. Generated locals are names that a `let` binds and that end in an underscore.
pub(super) fn numbered_anew(stream: TokenStream) -> String {
    let mut texts = texts(stream);
    let mut numbers: HashMap<String, usize> = HashMap::new();
    let mut is_bound_here = false;
    for text in &mut texts {
        match &text[..] {
            "fn" => numbers.clear(),
            "let" => is_bound_here = true,
            "=" => is_bound_here = false,
            name if name.ends_with('_') && name != "_" => {
                let next = numbers.len();
                if is_bound_here {
                    numbers.entry(name.to_string()).or_insert(next);
                }
                if let Some(number) = numbers.get(name) {
                    *text = format!("local {number}");
                }
            }
            _ => {}
        }
    }
    hash(&texts)
}

/// The tokens one by one, groups with their delimiters.
fn texts(stream: TokenStream) -> Vec<String> {
    let mut list = Vec::new();
    push(stream, &mut list);
    list
}

fn push(stream: TokenStream, list: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("<none>", "</none>"),
                };
                list.push(open.to_string());
                push(group.stream(), list);
                list.push(close.to_string());
            }
            TokenTree::Punct(punct) => list.push(match punct.spacing() {
                Spacing::Alone => punct.to_string(),
                Spacing::Joint => format!("{punct} joint"),
            }),
            tree => list.push(tree.to_string()),
        }
    }
}

/// FNV-1a in 64 bits: the standard library's hash may change from one version to the next.
pub(super) fn hash(texts: &[String]) -> String {
    let mut state = 0xcbf2_9ce4_8422_2325_u64;
    // No token holds a zero byte.
    for byte in texts.iter().flat_map(|text| text.bytes().chain([0])) {
        state = (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{state:016x}")
}

#[test]
fn the_hash_is_that_of_its_authors() {
    // FNV-1a of "foobar" is 85944171f73967e8; one more step takes the zero byte in.
    let expected = 0x8594_4171_f739_67e8_u64.wrapping_mul(0x0100_0000_01b3);
    assert_eq!(hash(&["foobar".to_string()]), format!("{expected:016x}"));
}
