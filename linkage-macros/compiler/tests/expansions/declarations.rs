//! The declarations of the workspace: in sources and Markdown wherever they stand, so that files
//! may be moved, and every variant of every group.

use std::fs;
use std::path::{Path, PathBuf};

use crate::blocks;
use crate::equations::declarations::{UNKNOWNS, VARIANTS};
use crate::equations::parallelograms::PARALLELOGRAMS;
use proc_macro2::{TokenStream, TokenTree};

pub(crate) struct Declaration {
    /// The mechanism's; for a variant of a group, the variant's.
    pub name: String,
    pub tokens: TokenStream,
}

pub(crate) fn all() -> impl Iterator<Item = Declaration> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let mut files = Vec::new();
    add_files(&root, &mut files);
    let of_file = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("the file can be read");
        let mut found = Vec::new();
        if path.extension().is_some_and(|extension| extension == "md") {
            let blocks = text.split("```").skip(1).step_by(2);
            let rust = blocks.filter_map(|block| block.strip_prefix("rust")?.split_once('\n'));
            rust.for_each(|(_, code)| add_declarations(tokens(code), &mut found));
        } else {
            add_declarations(tokens(&text), &mut found);
        }
        found
    };
    let variants = VARIANTS.iter().chain(UNKNOWNS).chain(PARALLELOGRAMS).map(|variant| {
        Declaration { name: format!("variant: {}", variant.name), tokens: tokens(variant.source) }
    });
    files.into_iter().flat_map(of_file).chain(variants)
}

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("the file is made of tokens")
}

/// Sources and Markdown below a folder. What is in `ui` has mistakes, what is in `target` is made
/// by the compiler, and the compiler's own sources hold no declaration.
fn add_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_elsewhere =
            name.starts_with('.') || ["target", "ui", "compiler"].contains(&&name[..]);
        let is_text = [".rs", ".md"].iter().any(|ending| name.ends_with(ending));
        match () {
            () if is_elsewhere => {}
            () if path.is_dir() => add_files(&path, files),
            () if is_text => files.push(path),
            () => {}
        }
    }
}

/// The declarations among the tokens.
fn add_declarations(stream: TokenStream, found: &mut Vec<Declaration>) {
    let declarations = blocks::declarations(stream).into_iter();
    let named = declarations
        .filter_map(|tokens| name(tokens.clone()).map(|name| Declaration { name, tokens }));
    found.extend(named);
}

/// The name behind `struct`.
fn name(stream: TokenStream) -> Option<String> {
    let mut trees = stream.into_iter();
    trees.find(|tree| matches!(tree, TokenTree::Ident(word) if word == "struct"))?;
    trees.next().map(|tree| tree.to_string())
}
