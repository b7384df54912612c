//! One name, one thing: in a crate no type name is defined twice, and no two modules have the same
//! name. Types that belong to a trait's implementation have the trait's name for them.

use std::collections::BTreeMap;

use proc_macro2::Ident;
use syn::visit::{Visit, visit_item_enum, visit_item_struct, visit_item_trait, visit_item_type};
use syn::{File, ItemEnum, ItemStruct, ItemTrait, ItemType};

use super::sources::crates;

/// Names of types, one entry a definition.
#[derive(Default)]
struct Types {
    found: Vec<String>,
}

impl Types {
    fn add(&mut self, name: &Ident) {
        self.found.push(name.to_string());
    }
}

impl<'ast> Visit<'ast> for Types {
    fn visit_item_enum(&mut self, item: &'ast ItemEnum) {
        self.add(&item.ident);
        visit_item_enum(self, item);
    }

    fn visit_item_struct(&mut self, item: &'ast ItemStruct) {
        self.add(&item.ident);
        visit_item_struct(self, item);
    }

    fn visit_item_trait(&mut self, item: &'ast ItemTrait) {
        self.add(&item.ident);
        visit_item_trait(self, item);
    }

    fn visit_item_type(&mut self, item: &'ast ItemType) {
        self.add(&item.ident);
        visit_item_type(self, item);
    }
}

/// The names of the types that a file defines.
pub(crate) fn types(file: &File) -> Vec<String> {
    let mut types = Types::default();
    types.visit_file(file);
    types.found
}

#[test]
fn no_type_name_is_defined_twice() {
    let mut left = Vec::new();
    for of in crates() {
        let mut types: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for source in &of.sources {
            for name in &source.types {
                types.entry(name).or_default().push(&source.path);
            }
        }
        assert!(of.sources.len() < 40 || types.len() > 100, "{}: few types", of.name);
        types.retain(|_, places| places.len() > 1);
        left.extend(
            types.iter().map(|(name, places)| format!("{} {name}: {}", of.name, places.join(", "))),
        );
    }
    assert!(
        left.is_empty(),
        "{} type names with several definitions:\n{}",
        left.len(),
        left.join("\n")
    );
}

#[test]
fn no_module_name_stands_in_two_rooms() {
    let mut left = Vec::new();
    for of in crates() {
        let mut rooms: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for source in &of.sources {
            if let Some(name) = source.module.last() {
                rooms.entry(name).or_default().push(&source.path);
            }
        }
        rooms.retain(|_, paths| paths.len() > 1);
        left.extend(
            rooms.iter().map(|(name, paths)| format!("{} {name}: {}", of.name, paths.join(", "))),
        );
    }
    assert!(left.is_empty(), "{} names of several modules:\n{}", left.len(), left.join("\n"));
}
