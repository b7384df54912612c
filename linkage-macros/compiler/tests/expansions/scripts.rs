//! Every script calls what the page's run-time defines, and nothing else.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::{Expansion, Key, SAMPLE};

/// The script among the texts of a solver's tokens: the string that begins as an object does.
pub(super) fn of(texts: &[String]) -> Option<String> {
    let literal = texts.iter().find(|text| text.starts_with(r#""{\nplace: "#))?;
    Some(syn::parse_str::<syn::LitStr>(literal).expect("a string").value())
}

/// The names that are called, those of conditions with `c.` in front.
fn called(script: &str) -> impl Iterator<Item = &str> {
    script.match_indices('(').filter_map(|(end, _)| {
        let is_name = |c: char| c.is_alphanumeric() || "_$.".contains(c);
        let start = script[..end].rfind(|c| !is_name(c)).map_or(0, |at| at + 1);
        let name = &script[start..end];
        name.starts_with(char::is_alphabetic).then_some(name)
    })
}

/// The names that the files of the run-time define.
fn defined() -> BTreeSet<String> {
    let folder =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../linkage-core/src/sketch/page");
    let text = |file: &str| std::fs::read_to_string(folder.join(file)).expect("the file is there");
    let mut names = BTreeSet::new();
    let files = ["kernels.js", "roots.js", "friction.js", "checks.js"].map(text);
    for line in files.iter().flat_map(|text| text.lines()) {
        let constant = line.strip_prefix("const ").and_then(|rest| rest.split_once(" = "));
        names.extend(constant.into_iter().flat_map(|(name, _)| {
            name.trim_matches(['{', '}', ' ']).split(", ").map(str::to_string)
        }));
        let method = line.strip_prefix("  ").and_then(|rest| rest.split_once('('));
        let method = method.filter(|_| line.ends_with(" {"));
        names.extend(method.map(|(name, _)| format!("c.{name}")));
    }
    names
}

/// The count of scripts, each of which calls what is defined, and all that they call.
fn all_call_what_is_defined(all: &BTreeMap<Key, Option<Expansion>>) -> (usize, BTreeSet<String>) {
    let (defined, mut scripts, mut seen) = (defined(), 0, BTreeSet::new());
    for ((declaration, _), expansion) in all {
        let script = expansion.as_ref().and_then(|expansion| expansion.script.as_ref());
        let Some(script) = script else { continue };
        scripts += 1;
        for name in called(script) {
            assert!(defined.contains(name), "{declaration}: `{name}` is defined nowhere");
            seen.insert(name.to_string());
        }
        // Searches and lists of names are the script's own.
        for own in script.split("MACHINE.").skip(1) {
            let own = own.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or("");
            let is_there = script.contains(&format!("\n{own}: "));
            assert!(is_there, "{declaration}: `{own}` is defined nowhere");
        }
    }
    (scripts, seen)
}

/// Every variant and an eighth of the other declarations; `.ci/nightly` asks all of them.
#[test]
fn a_script_calls_what_its_page_defines() {
    let (scripts, _) = all_call_what_is_defined(&SAMPLE);
    assert!(scripts > 45, "{scripts}");
}

/// Also that what is defined is called by some of them.
pub(super) fn assert_whole(all: &BTreeMap<Key, Option<Expansion>>) {
    let (scripts, seen) = all_call_what_is_defined(all);
    assert!(scripts > 300, "{scripts}");
    assert!(seen.len() > 20, "{seen:?}");
    for name in [
        "rootOf",
        "rootWithinATurn",
        "c.root",
        "c.Closed",
        "c.Moving",
        "c.length",
        "c.sinCos",
        "amountsOf",
    ] {
        assert!(seen.contains(name), "no declaration calls {name}");
    }
}
