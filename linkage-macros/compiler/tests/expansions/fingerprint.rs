//! Hashes of tokens that mean the same on every machine and under every compiler.

use std::collections::HashMap;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The hash of the tokens as they are.
pub(super) fn exact(stream: TokenStream) -> String {
    hash(&texts(stream))
}

/// The hash of the tokens after the generated locals of each function are numbered in the order of their
/// bindings. Generated locals are names that a `let` binds and that end in an underscore.
pub(super) fn numbered_anew(texts: &[&str]) -> String {
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    let mut is_bound_here = false;
    let mut state = Fnv::new();
    for text in texts {
        match *text {
            "fn" => numbers.clear(),
            "let" => is_bound_here = true,
            "=" => is_bound_here = false,
            name if name.ends_with('_') && name != "_" => {
                let next = numbers.len();
                if is_bound_here {
                    numbers.entry(name).or_insert(next);
                }
                if let Some(number) = numbers.get(name) {
                    state.add(&format!("local {number}"));
                    continue;
                }
            }
            _ => {}
        }
        state.add(text);
    }
    state.text()
}

/// The tokens one by one, groups with their delimiters.
pub(super) fn texts(stream: TokenStream) -> Vec<String> {
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
                let inner = group.stream();
                // Tokens that nothing else holds are taken apart without being copied.
                drop(group);
                list.push(open.to_string());
                push(inner, list);
                list.push(close.to_string());
            }
            TokenTree::Punct(punct) => {
                let mut text = String::from(punct.as_char());
                if punct.spacing() == Spacing::Joint {
                    text.push_str(" joint");
                }
                list.push(text);
            }
            tree => list.push(tree.to_string()),
        }
    }
}

/// FNV-1a in 64 bits: the standard library's hash may change from one version to the next.
struct Fnv(u64);

impl Fnv {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn add(&mut self, text: &str) {
        let step = |state: u64, byte: u8| (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let mut state = self.0;
        for &byte in text.as_bytes() {
            state = step(state, byte);
        }
        // No token holds a zero byte.
        self.0 = step(state, 0);
    }

    fn text(&self) -> String {
        format!("{:016x}", self.0)
    }
}

pub(super) fn hash<T: AsRef<str>>(texts: &[T]) -> String {
    let mut state = Fnv::new();
    for text in texts {
        state.add(text.as_ref());
    }
    state.text()
}

#[test]
fn the_hash_is_that_of_its_authors() {
    // FNV-1a of "foobar" is 85944171f73967e8; one more step takes the zero byte in.
    let expected = 0x8594_4171_f739_67e8_u64.wrapping_mul(0x0100_0000_01b3);
    assert_eq!(hash(&["foobar"]), format!("{expected:016x}"));
}
