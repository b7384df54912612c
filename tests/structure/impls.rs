//! The files that `impl` blocks of one type stand in: whoever reads what a type does, reads few of them.

use std::collections::{BTreeMap, BTreeSet};

use syn::{File, Item, Type};

use super::sources::crates;

/// The most files, in the model.
const MOST: usize = 5;

/// The names of the types that a file has `impl` blocks of, without those of traits.
pub(crate) fn impls(file: &File) -> BTreeSet<String> {
    let own = file.items.iter().filter_map(|item| match item {
        Item::Impl(item) if item.trait_.is_none() => match &*item.self_ty {
            Type::Path(path) => Some(path.path.segments.last()?.ident.to_string()),
            _ => None,
        },
        _ => None,
    });
    own.collect()
}

#[test]
fn the_impls_of_a_type_stand_in_few_files_of_the_model() {
    let files = crates().iter().flat_map(|of| &of.sources);
    let mut places: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for source in files.filter(|source| source.path.contains("compiler/src/model/")) {
        for name in &source.impls {
            places.entry(name).or_default().push(&source.path);
        }
    }
    assert!(places.len() > 50, "few types: {}", places.len());
    places.retain(|_, places| places.len() > MOST);
    assert!(places.is_empty(), "types with many files: {places:#?}");
}
