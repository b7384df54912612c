//! `examples/four_bar_expanded.rs` is what the declaration in `examples/four_bar.rs` expands to.
//!
//! They are compared token by token, so that the file may be laid out as the others are.
//! `LINKAGE_EXPAND=1 cargo test -p linkage-compiler expanded && cargo fmt` writes it anew.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

use crate::pipeline::{self, Options};

/// The lines around the expansion in the file: a head in front, and a program behind.
const START: &str = "// What `mechanism!` makes of the declaration.\n";
const END: &str = "// The program.\n";

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

fn read(name: &str) -> String {
    fs::read_to_string(example(name)).expect("the example is there")
}

/// The expansion of the declaration in `four_bar.rs`.
fn expansion() -> TokenStream {
    let source = read("four_bar.rs");
    let tokens: TokenStream = source.parse().expect("the example is made of tokens");
    let mut trees = tokens.into_iter();
    trees.find(|tree| matches!(tree, TokenTree::Ident(word) if word == "mechanism"));
    let body = trees.find_map(|tree| match tree {
        TokenTree::Group(group) => Some(group.stream()),
        _ => None,
    });
    super::line_by_line(
        pipeline::compile(body.expect("the macro has an argument"), &Options::NONE).tokens,
    )
}

/// The items as text, with an empty line between any two and without the tokens that formatting
/// leaves alone because they are a macro's.
fn text(stream: TokenStream) -> String {
    let mut file = syn::parse2(stream).expect("the expansion is a list of items");
    let hidden = take_macro_body(&mut file);
    let shown = prettyplease::unparse(&file);
    let hidden = prettyplease::unparse(&syn::parse2(hidden).expect("a macro of items"));
    let hidden: String = hidden.lines().map(|line| format!("            {line}\n")).collect();
    spaced(&shown.replace("with_ad! {}", &format!("with_ad! {{\n{hidden}        }}")))
}

/// Takes what `with_ad!` is given out of the unnamed constant in the module.
fn take_macro_body(file: &mut syn::File) -> TokenStream {
    let modules = file.items.iter_mut().filter_map(|item| match item {
        syn::Item::Mod(module) => module.content.as_mut(),
        _ => None,
    });
    for item in modules.flat_map(|(_, items)| items) {
        let syn::Item::Const(item) = item else { continue };
        let syn::Expr::Block(block) = &mut *item.expr else { continue };
        for statement in &mut block.block.stmts {
            match statement {
                syn::Stmt::Macro(call) => return std::mem::take(&mut call.mac.tokens),
                syn::Stmt::Item(syn::Item::Macro(call)) => {
                    return std::mem::take(&mut call.mac.tokens);
                }
                _ => {}
            }
        }
    }
    TokenStream::new()
}

/// The text with an empty line between items that span lines.
fn spaced(text: &str) -> String {
    let mut lines: Vec<&str> = Vec::new();
    let indent = |line: &str| line.len() - line.trim_start().len();
    for line in text.lines() {
        let begins = ["///", "#[", "impl", "const ", "fn ", "pub "];
        let begins = begins.iter().any(|word| line.trim_start().starts_with(word));
        let ends = |last: &str| ["}", "};", "];"].iter().any(|end| last.ends_with(end));
        if lines.last().is_some_and(|last| begins && ends(last) && indent(last) == indent(line)) {
            lines.push("");
        }
        lines.push(line);
    }
    lines.join("\n") + "\n"
}

#[test]
fn the_expanded_four_bar_is_what_the_macro_makes() {
    let source = read("four_bar_expanded.rs");
    let (head, rest) = source.split_once(START).expect("a line says where the expansion starts");
    let (held, program) = rest.split_once(END).expect("a line says where the expansion ends");
    let made = expansion();
    if std::env::var_os("LINKAGE_EXPAND").is_some() {
        let text = format!("{head}{START}\n{}\n{END}{program}", text(made));
        return fs::write(example("four_bar_expanded.rs"), text)
            .expect("the example can be written");
    }
    let made = text(made);
    let (made, held) = (made.trim().lines(), held.trim().lines());
    for (nth, (made, held)) in made.clone().zip(held.clone()).enumerate() {
        assert_eq!(made, held, "line {nth} of the expansion: run again with LINKAGE_EXPAND=1");
    }
    assert_eq!(made.count(), held.count(), "run again with LINKAGE_EXPAND=1");
}
