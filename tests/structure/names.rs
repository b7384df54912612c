//! One name, one thing: in a crate no type name is defined twice, and no two modules have the same
//! name. Types that belong to a trait's implementation have the trait's name for them.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;
use syn::visit::{Visit, visit_item_enum, visit_item_struct, visit_item_trait, visit_item_type};
use syn::{ItemEnum, ItemStruct, ItemTrait, ItemType};

use crate::sources::crates;

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

/// Type names that are still defined twice. The list only gets shorter.
const KNOWN_TYPES: [&str; 10] =
    ["Expr", "Field", "Given", "Group", "Output", "Part", "Place", "Quantity", "Row", "Statement"];

#[test]
fn no_type_name_is_defined_twice() {
    let (mut left, mut known) = (Vec::new(), BTreeSet::from(KNOWN_TYPES));
    for of in crates() {
        let mut types = Types::default();
        for source in &of.sources {
            types.path.clone_from(&source.path);
            types.visit_file(&source.file);
        }
        assert!(of.sources.len() < 20 || types.found.len() > 100, "{}: few types", of.name);
        types.found.retain(|name, places| {
            known.retain(|known| known != name || places.len() == 1);
            places.len() > 1 && !KNOWN_TYPES.contains(&name.as_str())
        });
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
    assert!(known.is_empty(), "take these off the list, they are defined once: {known:?}");
}

/// Names of modules that are still those of two. The list only gets shorter.
const KNOWN_MODULES: [&str; 10] = [
    "chain", "dynamics", "forces", "groups", "limits", "literal", "searches", "springs", "steps",
    "triangle",
];

#[test]
fn no_module_name_stands_in_two_rooms() {
    let (mut left, mut known) = (Vec::new(), BTreeSet::from(KNOWN_MODULES));
    for of in crates() {
        let mut rooms: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for source in &of.sources {
            if let Some(name) = source.module.last() {
                rooms.entry(name).or_default().push(&source.path);
            }
        }
        rooms.retain(|name, paths| {
            known.retain(|known| known != name || paths.len() == 1);
            paths.len() > 1 && !KNOWN_MODULES.contains(name)
        });
        left.extend(
            rooms.iter().map(|(name, paths)| format!("{} {name}: {}", of.name, paths.join(", "))),
        );
    }
    assert!(left.is_empty(), "{} names of several modules:\n{}", left.len(), left.join("\n"));
    assert!(known.is_empty(), "take these off the list, they stand in one room: {known:?}");
}
