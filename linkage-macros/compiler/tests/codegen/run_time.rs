//! Names and codes that generated code and the run-time crate have to agree on. Neither crate may include
//! a file of the other's, as both are published: here one is read beside the other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::codegen::c::header::{JAMS, NO_SOLUTION, NOT_CERTIFIED, SHARED};
use crate::codegen::rust::paths::IMPORTED;
use syn::{Item, UseTree};

/// The items of a file of the run-time crate.
fn items(file: &str) -> Vec<Item> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../linkage-core/src").join(file);
    let text = fs::read_to_string(path).expect("the file can be read");
    syn::parse_file(&text).expect("the file is code").items
}

/// The constants of a file and their values, digits without separators.
fn constants(file: &str) -> BTreeMap<String, String> {
    let items = items(file).into_iter().filter_map(|item| match item {
        Item::Const(item) => {
            let value = item.expr;
            Some((item.ident.to_string(), quote::quote!(#value).to_string().replace('_', "")))
        }
        _ => None,
    });
    items.collect()
}

fn leaves(tree: &UseTree, names: &mut Vec<String>) {
    match tree {
        UseTree::Path(path) => leaves(&path.tree, names),
        UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, names)),
        UseTree::Name(name) => names.push(name.ident.to_string()),
        UseTree::Rename(_) | UseTree::Glob(_) => panic!("names are given one by one"),
    }
}

#[test]
fn what_is_imported_is_what_there_is() {
    let mut names = Vec::new();
    for item in items("private.rs") {
        let Item::Mod(module) = item else { continue };
        for item in module.content.into_iter().filter(|_| module.ident == "names").flat_map(|c| c.1)
        {
            let Item::Use(list) = item else { panic!("`names` holds imports alone") };
            leaves(&list.tree, &mut names);
        }
    }
    let expected = IMPORTED.map(str::to_string);
    assert_eq!(BTreeSet::from_iter(names), BTreeSet::from(expected));
}

#[test]
fn the_header_has_the_codes_of_the_run_time_crate() {
    let words = |line: &str| line.split([' ', '=', ',']).map(str::to_string).collect::<Vec<_>>();
    let codes = [SHARED, NO_SOLUTION, JAMS, NOT_CERTIFIED]
        .into_iter()
        .flat_map(str::lines)
        .filter_map(|line| {
            let words: Vec<String> =
                words(line).into_iter().filter(|word| !word.is_empty()).collect();
            let at = words.iter().position(|word| word.starts_with("LINKAGE_"))?;
            let code = words.get(at + 1)?.parse::<i32>().ok()?;
            Some((words[at].trim_start_matches("LINKAGE_").to_string(), code.to_string()))
        });
    let mut codes: BTreeMap<String, String> = codes.collect();
    // The modes are numbers of their own.
    for (mode, number) in [("LEFT", "1"), ("RIGHT", "-1"), ("AHEAD", "1"), ("BEHIND", "-1")] {
        assert_eq!(codes.remove(mode).as_deref(), Some(number), "{mode}");
    }
    assert_eq!(codes.remove("OK").as_deref(), Some("0"));
    assert_eq!(codes, constants("c_interface.rs"));
}
