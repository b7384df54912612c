//! No circle of imports: of the modules beside one another, each with all it contains, none uses
//! another that uses it, by however many steps.
//!
//! A module and those it contains are one room: between them imports go both ways, because methods of
//! one type stand in several files. A name that is passed on is followed to where it is defined.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{Visit, visit_item_mod};
use syn::{ItemUse, UseTree, Visibility};

use super::sources::{Crate, crates};

type Module = Vec<String>;

/// A name that a `use` brings into a module.
#[derive(Clone)]
struct Import {
    into: Module,
    /// The path from the crate's root.
    path: Vec<String>,
    /// The name it has from then on; none for all names of a module.
    name: Option<String>,
    is_passed_on: bool,
}

/// The modules of some files, and what they import.
#[derive(Default)]
pub(crate) struct Imports {
    module: Module,
    modules: BTreeSet<Module>,
    found: Vec<Import>,
}

impl Imports {
    /// Those of the file of a module.
    pub(crate) fn of(module: &[String], file: &syn::File) -> Self {
        let module = module.to_vec();
        let modules = BTreeSet::from([module.clone()]);
        let mut imports = Self { module, modules, found: Vec::new() };
        imports.visit_file(file);
        imports
    }

    fn add(&mut self, before: &[String], tree: &UseTree, is_passed_on: bool) {
        let mut import = |path: Vec<String>, name: Option<String>| {
            let into = self.module.clone();
            self.found.push(Import { into, path, name, is_passed_on });
        };
        match tree {
            UseTree::Path(path) => {
                let path_so_far = [before, &[path.ident.to_string()]].concat();
                self.add(&path_so_far, &path.tree, is_passed_on);
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.add(before, tree, is_passed_on);
                }
            }
            UseTree::Name(name) if name.ident == "self" => {
                import(before.to_vec(), before.last().cloned());
            }
            UseTree::Name(name) => {
                let name = name.ident.to_string();
                import([before, std::slice::from_ref(&name)].concat(), Some(name));
            }
            UseTree::Rename(rename) => {
                let path = [before, &[rename.ident.to_string()]].concat();
                import(path, Some(rename.rename.to_string()));
            }
            UseTree::Glob(_) => import(before.to_vec(), None),
        }
    }

    /// The path from the crate's root; none where it leads into another crate.
    fn absolute(&self, into: &[String], path: &[String]) -> Option<Vec<String>> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some(rest.to_vec()),
            "self" => Some([into, rest].concat()),
            "super" => {
                let (mut above, mut rest) = (into.len() - 1, rest);
                while rest.first().is_some_and(|name| name == "super") {
                    (above, rest) = (above - 1, &rest[1..]);
                }
                Some([&into[..above], rest].concat())
            }
            name => {
                let below = [into, &[name.to_string()]].concat();
                self.modules.contains(&below).then(|| [below.as_slice(), rest].concat())
            }
        }
    }

    /// The module in which the last name of a path is defined.
    fn defined_in(&self, path: &[String], depth: usize) -> Module {
        let mut module = Vec::new();
        for (index, name) in path.iter().enumerate() {
            let below = [module.as_slice(), std::slice::from_ref(name)].concat();
            if self.modules.contains(&below) {
                module = below;
                continue;
            }
            let passed_on = self.found.iter().find(|import| {
                import.is_passed_on && import.into == module && import.name.as_ref() == Some(name)
            });
            let Some(import) = passed_on.filter(|_| depth < 8) else { break };
            let Some(start) = self.absolute(&import.into, &import.path) else { break };
            return self.defined_in(&[&start, &path[index + 1..]].concat(), depth + 1);
        }
        module
    }
}

impl<'ast> Visit<'ast> for Imports {
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let is_passed_on = !matches!(item.vis, Visibility::Inherited);
        self.add(&[], &item.tree, is_passed_on);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if item.content.is_some() {
            self.module.push(item.ident.to_string());
            self.modules.insert(self.module.clone());
            visit_item_mod(self, item);
            self.module.pop();
        }
    }
}

/// Who uses whom among the modules beside one another, by the module that contains them, with the
/// modules that do.
type Uses = BTreeMap<Module, BTreeMap<String, BTreeMap<String, BTreeSet<String>>>>;

fn uses(of: &Crate) -> Uses {
    let mut imports = Imports::default();
    for source in &of.sources {
        imports.modules.extend(source.imports.modules.iter().cloned());
        imports.found.extend(source.imports.found.iter().cloned());
    }
    let mut uses = Uses::new();
    for Import { into, path, .. } in &imports.found {
        let Some(path) = imports.absolute(into, path) else { continue };
        let used = imports.defined_in(&path, 0);
        let shared = into.iter().zip(&used).take_while(|(a, b)| a == b).count();
        if let (Some(user), Some(maker)) = (into.get(shared), used.get(shared)) {
            let beside = uses.entry(into[..shared].to_vec()).or_default();
            let by = beside.entry(user.clone()).or_default().entry(maker.clone()).or_default();
            by.insert(format!("{} uses {}", into.join("::"), used.join("::")));
        }
    }
    uses
}

/// Every module that can be reached.
fn reached<T>(from: &str, uses: &BTreeMap<String, BTreeMap<String, T>>) -> BTreeSet<String> {
    let (mut open, mut reached) = (vec![from.to_string()], BTreeSet::new());
    while let Some(module) = open.pop() {
        for next in uses.get(&module).into_iter().flat_map(BTreeMap::keys) {
            if reached.insert(next.clone()) {
                open.push(next.clone());
            }
        }
    }
    reached
}

/// Modules of a circle beside one another.
type Circle = BTreeSet<String>;

/// The circles among modules beside one another.
fn circles<T>(uses: &BTreeMap<String, BTreeMap<String, T>>) -> BTreeSet<Circle> {
    let of = |module: &String| -> Circle {
        let behind = reached(module, uses);
        behind.into_iter().filter(|other| reached(other, uses).contains(module)).collect()
    };
    uses.keys().map(of).filter(|circle| !circle.is_empty()).collect()
}

#[test]
fn imports_make_no_circle() {
    let mut left = Vec::new();
    for of in crates() {
        let uses = uses(of);
        let count: usize = uses.values().flat_map(|uses| uses.values().map(BTreeMap::len)).sum();
        assert!(of.sources.len() < 40 || count > 100, "{}: {count} imports were found", of.name);
        for (inside, uses) in &uses {
            for circle in &circles(uses) {
                left.push(format!("{} {}: {circle:?}", of.name, inside.join("::")));
                for user in circle {
                    let in_circle = uses[user].iter().filter(|(used, _)| circle.contains(*used));
                    left.extend(in_circle.flat_map(|(_, by)| by).map(|line| format!("    {line}")));
                }
            }
        }
    }
    assert!(left.is_empty(), "circles of imports:\n{}", left.join("\n"));
}
