//! The expansions of every declaration of the workspace, compared with the hashes kept beside this file.
//!
//! A change of the compiler that should change no generated code shows here that it changed none. One that
//! should shows which declarations it touched. The file holds six hashes of each declaration: of the exact
//! tokens; of the tokens without documentation and with the generated locals numbered anew, which tells
//! renamed locals from other code; of the documentation; of the code that draws it; of the header for C; and
//! of the stub that replaces a declaration with mistakes. Behind them stand hashes of the messages about
//! declarations with slips. After an intended change
//! `LINKAGE_RENEW=1 cargo test -p linkage-compiler-tests expansions` writes the file anew, in a commit that
//! says why.

pub(crate) mod compiled;
pub(crate) mod declarations;
pub(crate) mod drawn;
pub(crate) mod driven_quantities;
pub(crate) mod fingerprint;
pub(crate) mod parts;
pub(crate) mod scripts;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use crate::pipeline::Options;
use crate::{fuzz, pipeline};
use declarations::Declaration;
use fingerprint::{exact, hash, numbered_anew, texts};

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
    Path::new(env!("CARGO_MANIFEST_DIR")).join("expansions/hashes.txt")
}

/// Everything that the tests look at, of one declaration.
struct Expansion {
    hashes: Hashes,
    /// The script of its page.
    script: Option<String>,
}

/// Tests run beside each other, and the first makes the expansions for all.
static SAMPLE: LazyLock<BTreeMap<Key, Option<Expansion>>> =
    LazyLock::new(|| Share::Sample.expanded());

impl Expansion {
    fn of(declaration: &Declaration) -> Self {
        let [stub, expansion, exported] = compiled::all(&declaration.tokens).map(texts);
        let header = parts::header(&exported).expect("C is asked for");
        let [_, drawing] = parts::taken_apart(&exported);
        let hashes = Hashes {
            exact: hash(&expansion),
            docs: hash(&parts::docs(&expansion)),
            renumbered: numbered_anew(&parts::without_docs(&expansion)),
            drawing: hash(&drawing),
            header: hash(&[header]),
            stub: hash(&stub),
        };
        Self { hashes, script: scripts::of(&exported) }
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

/// The declarations of which everything is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Share {
    /// Every variant, and of the others an eighth, by their own tokens.
    Sample,
    Whole,
}

impl Share {
    fn includes(self, (name, source): &Key) -> bool {
        let number = || u64::from_str_radix(source, 16).expect("a hash is a number");
        self == Self::Whole || name.starts_with("variant: ") || number() % 8 == 0
    }

    /// The expansions of all declarations, none of those that are not included.
    fn expanded(self) -> BTreeMap<Key, Option<Expansion>> {
        let mut all = BTreeMap::new();
        for declaration in declarations::all() {
            let key = (declaration.name.clone(), exact(declaration.tokens.clone()));
            let is_included = self.includes(&key);
            all.entry(key).or_insert_with(|| is_included.then(|| Expansion::of(&declaration)));
        }
        all
    }
}

fn to_text(all: &BTreeMap<Key, Option<Expansion>>, messages: &[String]) -> String {
    let line = |((name, source), expansion): (&Key, &Option<Expansion>)| {
        let hashes = &expansion.as_ref().expect("all are made").hashes;
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
    made: &BTreeMap<Key, Option<Expansion>>,
    kept: &BTreeMap<Key, Hashes>,
) -> BTreeMap<&'static str, Vec<String>> {
    let mut found: BTreeMap<_, Vec<String>> = BTreeMap::new();
    for (key, expansion) in made {
        let of_hashes = |kept: &Hashes| expansion.as_ref()?.hashes.difference(kept);
        let difference = kept.get(key).map_or(Some(NEW), of_hashes);
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

/// Every variant and an eighth of the other declarations; `.ci/run` asks all of them.
#[test]
fn no_declaration_expands_to_other_code_than_before() {
    let messages = messages_of_slips();
    if std::env::var_os("LINKAGE_RENEW").is_some() {
        let text = to_text(&Share::Whole.expanded(), &messages);
        return fs::write(kept_in(), text).expect("the hashes can be written");
    }
    assert_kept(&SAMPLE, &messages);
}

#[test]
#[ignore = "half a minute: `.ci/run` takes it"]
fn no_declaration_at_all_expands_to_other_code_than_before() {
    let all = Share::Whole.expanded();
    assert_kept(&all, &messages_of_slips());
    scripts::assert_whole(&all);
}

fn assert_kept(made: &BTreeMap<Key, Option<Expansion>>, messages: &[String]) {
    let text = fs::read_to_string(kept_in()).expect("the hashes are there");
    let (kept, kept_messages) = from_text(&text);
    let mut differences = differences(made, &kept);
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
        let texts = texts(source.parse().expect("these are tokens"));
        let owned = |texts: Vec<&str>| texts.iter().map(ToString::to_string).collect::<Vec<_>>();
        (owned(parts::docs(&texts)), owned(parts::without_docs(&texts)))
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
        let texts = texts(source.parse().expect("these are tokens"));
        let renumbered = numbered_anew(&parts::without_docs(&texts));
        let exact = hash(&texts);
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

#[test]
fn a_drawing_changes_nothing_of_the_solver_and_is_a_third_of_it_at_most() {
    let names =
        ["FlyingShear", "JansenLeg", "Excavator", "SixBar", "Whitworth", "CrankYoke", "ByTheWheel"];
    let mut seen = std::collections::BTreeSet::new();
    // Every third variant: the stored hashes are of solvers with and without a drawing.
    let mut variants = 0;
    let chosen = |declaration: &Declaration| {
        let is_variant = declaration.name.starts_with("variant: ");
        variants += usize::from(is_variant);
        is_variant && variants % 3 == 0 || names.contains(&&declaration.name[..])
    };
    for declaration in declarations::all().filter(chosen) {
        if !seen.insert(declaration.name.clone()) {
            continue;
        }
        let [plain, drawn] = [&Options::NONE, &Options::PAGE]
            .map(|options| texts(pipeline::compile(declaration.tokens.clone(), options).tokens));
        let [solver, drawing] = parts::taken_apart(&drawn);
        assert!(plain == solver, "{}", declaration.name);
        let [solver, drawing] = [solver, drawing].map(|texts| texts.len());
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
    assert!(seen.len() > 15, "{}", seen.len());
}
