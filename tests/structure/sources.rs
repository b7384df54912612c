//! Production files, read as the compiler reads them: from each crate's root along its modules,
//! without what is compiled for tests alone. They are parsed once for all tests.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use syn::{Attribute, File, ImplItem, Item, Meta, TraitItem};

use super::impls::impls;
use super::imports::Imports;
use super::lengths::long_functions;
use super::names::types;
use super::spread::{Said, said};

/// The module behind a file, and the facts that tests look at: other threads cannot read the tree that they are
/// found in.
pub(crate) struct Source {
    /// Names from the crate's root, which has none.
    pub module: Vec<String>,
    /// The file's place in the repository.
    pub path: String,
    pub imports: Imports,
    pub long_functions: Vec<String>,
    pub types: Vec<String>,
    pub impls: BTreeSet<String>,
    pub said: Said,
}

impl Source {
    fn new(module: &[String], path: String, file: &File) -> Self {
        Self {
            module: module.to_vec(),
            path,
            imports: Imports::of(module, file),
            long_functions: long_functions(file),
            types: types(file),
            impls: impls(file),
            said: said(file),
        }
    }
}

/// A crate of the repository.
pub(crate) struct Crate {
    pub name: &'static str,
    pub sources: Vec<Source>,
}

const FOLDERS: [(&str, &str); 5] = [
    ("linkage-core", "linkage-core/src"),
    ("linkage-assemblies", "linkage-core/assemblies/src"),
    ("linkage-design", "linkage-core/design/src"),
    ("linkage-compiler", "linkage-macros/src"),
    ("linkage-compiler", "linkage-macros/compiler/src"),
];

/// Every published crate.
pub(crate) fn crates() -> &'static [Crate] {
    static CRATES: OnceLock<Vec<Crate>> = OnceLock::new();
    CRATES.get_or_init(all_crates)
}

fn all_crates() -> Vec<Crate> {
    let repository =
        Path::new(&std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("..");
    let folders = FOLDERS.iter().filter(|(_, folder)| repository.join(folder).exists());
    let crates: Vec<Crate> = folders
        .map(|&(name, folder)| {
            let root = repository.join(folder).join("lib.rs");
            let mut sources = Vec::new();
            read(&repository, &root, &repository.join(folder), &[], &mut sources);
            Crate { name, sources }
        })
        .collect();
    let files: usize = crates.iter().map(|known| known.sources.len()).sum();
    assert!(files > 200, "only {files} files were found");
    crates
}

/// A module and those below it. `folder` is where its submodules are.
fn read(repository: &Path, path: &Path, folder: &Path, module: &[String], to: &mut Vec<Source>) {
    let text = fs::read_to_string(path).expect("the file is there");
    let mut file = syn::parse_file(&text).expect("the file is Rust");
    keep_production(&mut file.items);
    for item in &file.items {
        let Item::Mod(below) = item else { continue };
        if below.content.is_some() {
            continue;
        }
        let name = below.ident.to_string();
        let inner = folder.join(&name);
        let beside: PathBuf = folder.join(format!("{name}.rs"));
        let path = if beside.exists() { beside } else { inner.join("mod.rs") };
        read(repository, &path, &inner, &[module, &[name]].concat(), to);
    }
    let path = path.strip_prefix(repository).expect("the file is in the repository");
    let path = path.display().to_string();
    to.push(Source::new(module, path, &file));
}

/// Drops what is compiled for tests alone.
fn keep_production(items: &mut Vec<Item>) {
    items.retain(|item| !attributes(item).iter().any(is_for_tests));
    for item in items {
        match item {
            Item::Mod(module) => {
                if let Some((_, items)) = &mut module.content {
                    keep_production(items);
                }
            }
            Item::Impl(block) => block.items.retain(|item| match item {
                ImplItem::Fn(function) => !function.attrs.iter().any(is_for_tests),
                ImplItem::Const(constant) => !constant.attrs.iter().any(is_for_tests),
                _ => true,
            }),
            Item::Trait(block) => block.items.retain(|item| match item {
                TraitItem::Fn(function) => !function.attrs.iter().any(is_for_tests),
                _ => true,
            }),
            _ => {}
        }
    }
}

fn is_for_tests(attribute: &Attribute) -> bool {
    let Meta::List(list) = &attribute.meta else { return false };
    list.path.is_ident("cfg") && ["test", "doctest"].contains(&list.tokens.to_string().as_str())
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// The files below a folder that end in one of these.
pub(crate) fn visit(folder: &Path, endings: &[&str], look: &mut impl FnMut(&Path, &str)) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !name.starts_with('.') && name != "target" {
            visit(&path, endings, look);
        } else if endings.iter().any(|ending| path.extension().is_some_and(|own| own == *ending)) {
            look(&path, &fs::read_to_string(&path).expect("the source can be read"));
        }
    }
}
