//! One name, one thing: in a crate no type name is defined twice, and no two modules have the same
//! name. Types that belong to a trait's implementation have the trait's name for them.

use std::collections::BTreeMap;

use proc_macro2::Ident;
use syn::visit::{Visit, visit_item_enum, visit_item_struct, visit_item_trait, visit_item_type};
use syn::{ItemEnum, ItemStruct, ItemTrait, ItemType};

use super::sources::crates;

/// Names of types and the files that define them, one entry a definition.
#[derive(Default)]
struct Types {
    path: String,
    found: BTreeMap<String, Vec<String>>,
}

impl Types {
    fn add(&mut self, name: &Ident) {
        self.found.entry(name.to_string()).or_default().push(self.path.clone());
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

#[test]
fn no_type_name_is_defined_twice() {
    let mut left = Vec::new();
    for of in crates() {
        let mut types = Types::default();
        for source in &of.sources {
            types.path.clone_from(&source.path);
            types.visit_file(&source.file);
        }
        assert!(of.sources.len() < 20 || types.found.len() > 100, "{}: few types", of.name);
        types.found.retain(|_, places| places.len() > 1);
        left.extend(
            types
                .found
                .iter()
                .map(|(name, places)| format!("{} {name}: {}", of.name, places.join(", "))),
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
