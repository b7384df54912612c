//! The expansions of every declaration of the workspace, compared with the hashes kept beside this file.
//!
//! A change of the compiler that should change no generated code shows here that it changed none. One that
//! should shows which declarations it touched. The file holds six hashes of each declaration: of the exact
//! tokens; of the tokens without documentation and with the generated locals numbered anew, which tells
//! renamed locals from other code; of the documentation; of the code that draws it; of the header for C; and
//! of the stub that replaces a declaration with mistakes. Behind them stand hashes of the messages about
//! declarations with slips. After an intended change
//! `LINKAGE_RENEW=1 cargo test -p linkage-compiler expansions` writes the file anew, in a commit that
//! says why.

pub(crate) mod declarations;
mod drawn;
mod fingerprint;
mod parts;
mod scripts;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use proc_macro2::{TokenStream, TokenTree};

use crate::diagnostics::Diagnostics;
use crate::pipeline::Options;
use crate::{fuzz, model, pipeline, syntax};
use declarations::Declaration;
use fingerprint::{exact, hash, numbered_anew};
use parts::taken_apart;

/// A declaration's own tokens tell equal names apart, wherever they stand.
type Key = (String, String);

/// The hashes of one expansion.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Hashes {
    exact: String,
    renumbered: String,
    docs: String,
    drawing: String,
    header: String,
    stub: String,
}

/// The differences between an expansion and the one that is kept.
const NEW: &str = "declared anew or otherwise";
const GONE: &str = "declared no more, or otherwise";
const RENAMED: &str = "expands to the same under other names of locals";
const DOCS: &str = "has another documentation";
const DRAWING: &str = "is drawn by other code";
const HEADER: &str = "has another header";
const STUB: &str = "has another stub";
const CHANGED: &str = "expands to other code";

fn kept_in() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/expansions/hashes.txt")
}

/// Everything that the tests look at, of one declaration.
struct Expansion {
    hashes: Hashes,
    /// The script of its page.
    script: Option<String>,
}

/// Expansions of every declaration. Tests run beside each other, and the first makes them for all.
static ALL: LazyLock<BTreeMap<Key, Expansion>> = LazyLock::new(all);

impl Expansion {
    fn of(declaration: &Declaration) -> Self {
        let expansion = pipeline::compile(declaration.tokens.clone(), &Options::NONE).tokens;
        let messages = fuzz::messages(expansion.clone());
        assert!(messages.is_empty(), "{}: {messages:?}", declaration.name);
        let exported =
            pipeline::compile(parts::exported(&declaration.tokens), &Options::PAGE).tokens;
        let header = parts::header(exported.clone());
        let script = scripts::of(exported.clone());
        let hashes = Hashes {
            exact: exact(expansion.clone()),
            docs: hash(&parts::docs(expansion.clone())),
            renumbered: numbered_anew(parts::without_docs(expansion)),
            drawing: exact(taken_apart(exported).1),
            header: hash(&[header.expect("C is asked for")]),
            stub: exact(stub(declaration.tokens.clone())),
        };
        Self { hashes, script }
    }
}

impl Hashes {
    fn of_list(list: [String; 6]) -> Self {
        let [exact, renumbered, docs, drawing, header, stub] = list;
        Self { exact, renumbered, docs, drawing, header, stub }
    }

    fn list(&self) -> [&str; 6] {
        let Self { exact, renumbered, docs, drawing, header, stub } = self;
        [exact, renumbered, docs, drawing, header, stub]
    }

    /// The most important difference. The exact tokens include documentation and names of locals, so they are
    /// compared after these.
    fn difference(&self, kept: &Self) -> Option<&'static str> {
        match () {
            () if self == kept => None,
            () if self.renumbered != kept.renumbered => Some(CHANGED),
            () if self.docs != kept.docs => Some(DOCS),
            () if self.exact != kept.exact => Some(RENAMED),
            () if self.drawing != kept.drawing => Some(DRAWING),
            () if self.header != kept.header => Some(HEADER),
            () => Some(STUB),
        }
    }
}

/// The stub that the declaration would have if it had mistakes.
fn stub(tokens: TokenStream) -> TokenStream {
    let mut diagnostics = Diagnostics::new();
    let tree = syntax::parse(tokens, &mut diagnostics);
    assert!(diagnostics.into_mistakes().is_empty());
    let tree = tree.expect("it expands");
    pipeline::stub(&tree, &model::stub(&tree), &Options::NONE)
}

fn all() -> BTreeMap<Key, Expansion> {
    let mut all = BTreeMap::new();
    for declaration in declarations::all() {
        let key = (declaration.name.clone(), exact(declaration.tokens.clone()));
        all.entry(key).or_insert_with(|| Expansion::of(&declaration));
    }
    all
}

fn to_text(all: &BTreeMap<Key, Hashes>, messages: &[String]) -> String {
    let line = |((name, source), hashes): (&Key, &Hashes)| {
        format!("{name}: {source} {}\n", hashes.list().join(" "))
    };
    let of_slips = messages.iter().map(|hash| format!("{MESSAGES}: {hash}\n"));
    all.iter().map(line).chain(of_slips).collect()
}

fn from_text(text: &str) -> (BTreeMap<Key, Hashes>, Vec<String>) {
    let (mut all, mut messages) = (BTreeMap::new(), Vec::new());
    for line in text.lines() {
        let (name, hashes) = line.rsplit_once(": ").expect("a line is a name and hashes");
        if name == MESSAGES {
            messages.push(hashes.to_string());
            continue;
        }
        let (source, hashes) = hashes.split_once(' ').expect("the declaration's hash comes first");
        let hashes: Vec<_> = hashes.split(' ').map(str::to_string).collect();
        let hashes = hashes.try_into().expect("six hashes follow");
        all.insert((name.to_string(), source.to_string()), Hashes::of_list(hashes));
    }
    (all, messages)
}

/// A line of messages.
const MESSAGES: &str = "messages of slips";

/// The messages of declarations with slips, so many a hash.
fn messages_of_slips() -> Vec<String> {
    const LINES: usize = 20;
    const EACH: usize = 150;
    let mut mistaken = fuzz::mistaken();
    let mut line = || hash(&mistaken.by_ref().take(EACH).flatten().collect::<Vec<_>>());
    (0..LINES).map(|_| line()).collect()
}

/// The names of all declarations that differ, by the kind of difference.
fn differences(
    made: &BTreeMap<Key, Hashes>,
    kept: &BTreeMap<Key, Hashes>,
) -> BTreeMap<&'static str, Vec<String>> {
    let mut found: BTreeMap<_, Vec<String>> = BTreeMap::new();
    for (key, hashes) in made {
        let difference = kept.get(key).map_or(Some(NEW), |kept| hashes.difference(kept));
        if let Some(difference) = difference {
            found.entry(difference).or_default().push(key.0.clone());
        }
    }
    let gone = kept.keys().filter(|key| !made.contains_key(key));
    for (name, _) in gone {
        found.entry(GONE).or_default().push(name.clone());
    }
    found
}

#[test]
fn no_declaration_expands_to_other_code_than_before() {
    let made = ALL.iter().map(|(key, expansion)| (key.clone(), expansion.hashes.clone())).collect();
    let messages = messages_of_slips();
    if std::env::var_os("LINKAGE_RENEW").is_some() {
        let text = to_text(&made, &messages);
        return fs::write(kept_in(), text).expect("the hashes can be written");
    }
    let text = fs::read_to_string(kept_in()).expect("the hashes are there");
    let (kept, kept_messages) = from_text(&text);
    let mut differences = differences(&made, &kept);
    if messages != kept_messages {
        differences.insert("other messages", vec!["declarations with slips".to_string()]);
    }
    let lines = differences.iter().map(|(how, names)| format!("{how}: {}\n", names.join(", ")));
    assert!(
        differences.is_empty(),
        "\n{}If that is meant, LINKAGE_RENEW=1 writes the hashes anew, in a commit that says why.",
        lines.collect::<String>()
    );
}

#[test]
fn documentation_is_told_from_code() {
    let parts = |source: &str| {
        let tokens: TokenStream = source.parse().expect("these are tokens");
        (parts::docs(tokens.clone()), parts::without_docs(tokens).to_string())
    };
    let (docs, code) =
        parts("/// One.\n pub fn a() { #[doc = \"Two.\"] struct B; g(doc) } #[inline] fn c() {}");
    assert_eq!(docs, ["\" One.\"", "\"Two.\""]);
    assert_eq!(code, parts("pub fn a() { struct B; g(doc) } #[inline] fn c() {}").1);
}

#[test]
fn declarations_are_found_in_every_kind_of_place() {
    let names: Vec<_> = declarations::all().map(|declaration| declaration.name).collect();
    // An example, a test's, one inside a function, a variant of a group.
    for name in ["FlyingShear", "JansenLeg", "Whitworth", "variant: crank"] {
        assert!(names.iter().any(|known| known == name), "{name} is not among {names:?}");
    }
    assert!(names.len() > 150, "{}", names.len());
}

#[test]
fn other_code_and_other_names_are_told_apart() {
    let hashes = |source: &str| {
        let tokens: TokenStream = source.parse().expect("these are tokens");
        let (exact, renumbered) = (exact(tokens.clone()), numbered_anew(tokens));
        Hashes { exact, renumbered, ..Hashes::default() }
    };
    let before = hashes("fn a() { let (v1_, x_) = f(q); g(v1_) } fn b() { let v9_ = 1; v9_ }");
    for (source, difference) in [
        ("fn a() { let (u_, v_) = f(q); g(u_) } fn b() { let u_ = 1; u_ }", Some(RENAMED)),
        ("fn a() { let (v1_, x_) = f(q); g(x_) } fn b() { let v9_ = 1; v9_ }", Some(CHANGED)),
        ("fn a() { let (v1_, x_) = f(q); g(v1_) } fn b() { let v9_ = 2; v9_ }", Some(CHANGED)),
        ("fn a() { let (v1_, x_) = h(q); g(v1_) } fn b() { let v9_ = 1; v9_ }", Some(CHANGED)),
        ("fn a() { let (v1_, x_) = f(q); g(v1_) } fn b() { let v9_ = 1; v9_ }", None),
    ] {
        assert_eq!(hashes(source).difference(&before), difference, "{source}");
    }
}

fn count(stream: TokenStream) -> usize {
    stream
        .into_iter()
        .map(|tree| match tree {
            TokenTree::Group(group) => 2 + count(group.stream()),
            _ => 1,
        })
        .sum()
}

#[test]
fn a_drawing_changes_nothing_of_the_solver_and_is_a_third_of_it_at_most() {
    let names =
        ["FlyingShear", "JansenLeg", "Excavator", "SixBar", "Whitworth", "CrankYoke", "ByTheWheel"];
    let mut seen = std::collections::BTreeSet::new();
    let chosen = |declaration: &Declaration| {
        declaration.name.starts_with("variant: ") || names.contains(&&declaration.name[..])
    };
    for declaration in declarations::all().filter(chosen) {
        if !seen.insert(declaration.name.clone()) {
            continue;
        }
        let plain = pipeline::compile(declaration.tokens.clone(), &Options::NONE).tokens;
        let drawn = pipeline::compile(declaration.tokens.clone(), &Options::PAGE).tokens;
        let (solver, drawing) = taken_apart(drawn);
        assert_eq!(exact(solver.clone()), exact(plain), "{}", declaration.name);
        let (solver, drawing) = (count(solver), count(drawing));
        println!(
            "{}: {:.1} % of {solver}",
            declaration.name,
            100.0 * drawing as f64 / solver as f64
        );
        assert!(
            drawing > 0 && 3 * drawing <= solver,
            "{}: {drawing} of {solver}",
            declaration.name
        );
    }
    assert!(seen.len() > 30, "{}", seen.len());
}
