//! The contents of a page, and work that it does not do twice.

use std::process::Command;

use linkage_core::sketch::{Paged, shortened};
use proc_macro2::{TokenStream, TokenTree};

use super::hard;
use super::numbers::{has_node, script};

/// The page of a solver is what the compiler's texts make without Rust.
pub(super) fn is_printed_by_the_compiler_alone<S: Paged>(solver: &S) {
    let (declared, values) = (S::PAGE, solver.params());
    let call: TokenStream = declared.text.parse().expect("these are tokens");
    let Some(TokenTree::Group(group)) = call.into_iter().last() else {
        panic!("a call ends with its brackets")
    };
    let parts = linkage_compiler::page(group.stream()).expect("there is no mistake");
    let printed =
        [&parts.plan, &parts.script, &parts.inputs, &parts.params, &parts.loads, &parts.outputs];
    let expanded = [
        declared.plan,
        declared.script,
        declared.inputs,
        declared.params,
        declared.loads,
        declared.outputs,
    ];
    assert_eq!(printed, expanded, "{}", S::PLAN.name);
    assert_eq!(
        (&parts.name[..], &parts.docs[..], parts.values.len()),
        (S::PLAN.name, S::PLAN.docs, values.len())
    );
}

/// Only a page of a machine with friction solves for it, and one with an equation searches.
#[test]
fn a_page_holds_what_its_machine_needs() {
    let pages = gallery::live::pages().unwrap();
    let computes = |name: &str| script(&pages.iter().find(|(own, _)| *own == name).unwrap().1);
    for (name, rubs, searches) in [
        ("flying_shear::FlyingShear", false, false),
        ("press_friction::CutPress", true, false),
        ("set_point::Press", false, true),
    ] {
        assert_eq!(computes(name).contains(&shortened("amountsOf=(")), rubs, "{name}");
        assert_eq!(computes(name).contains(&shortened("rootOf=(")), searches, "{name}");
    }
}

/// Guides, springs, forces, motion without a drive, parameters, words to choose, and ends of sliders that the page finds
/// come with the machines that have them.
#[test]
fn a_page_shows_with_what_its_machine_has() {
    let pages = gallery::live::pages().unwrap();
    let parts = ["carriedBy", "zigzag", "drawForces", "later", "tolerate", "choice", "travelOf"];
    for (name, own) in [
        ("four_bar::FourBar", &[][..]),
        ("electronic_cam::FlyingShear", &[]),
        ("whitworth::Whitworth", &["carriedBy", "tolerate"]),
        (
            "vibration::Oscillator",
            &["carriedBy", "zigzag", "drawForces", "later", "tolerate", "travelOf"],
        ),
        ("counterweight::FourBar", &["drawForces", "later", "tolerate", "travelOf"]),
        ("six_bar_reactions::SixBar", &["carriedBy", "drawForces", "later"]),
        ("dead_point::ByLeft", &["drawForces", "later", "tolerate", "choice"]),
    ] {
        let (_, html) = pages.iter().find(|(page, _)| *page == name).unwrap();
        let found = parts
            .map(|part| html.contains(&shortened(&format!("{part}=("))))
            .into_iter()
            .zip(parts);
        let found: Vec<_> = found.filter_map(|(is_there, part)| is_there.then_some(part)).collect();
        assert_eq!(found, own, "{name}");
    }
}

/// Beside its formulas, and the arithmetic that decides limits and searches, a page of the gallery weighs 60 kB on average.
#[test]
fn pages_are_light() {
    let pages = gallery::live::pages().unwrap();
    let weights = pages.iter().map(|(name, html)| {
        // What reads the answers begins here.
        let computes = script(html).split_once("{abs,floor,max,min,round,PI}=Math");
        html.len() - computes.unwrap_or_else(|| panic!("{name} begins otherwise")).0.len()
    });
    let weights: Vec<usize> = weights.collect();
    let mean = weights.iter().sum::<usize>() / weights.len();
    let light = weights.iter().filter(|&&weight| weight <= 60_000).count();
    println!("{mean} bytes, {light} of {} pages at most 60 kB", weights.len());
    assert!(
        mean <= 60_000 && 2 * light > weights.len(),
        "{mean} bytes, {light} pages: {weights:?}"
    );
}

/// A search that fails is made once: what stands is found by its answer.
#[test]
fn a_failed_search_is_made_once() {
    if !has_node() {
        return;
    }
    const COUNT: &str = r#"
const finders = Object.keys(MACHINE).filter((name) => String(MACHINE[name]).match(/\b(FINDERS)\(/));
let calls = 0;
for (const name of finders) {
  const find = MACHINE[name];
  MACHINE[name] = (...given) => (calls++, find(...given));
}
const { error, numbers } = MACHINE.place(state.p, [9]);
console.log(finders.length > 0, calls, error.kind, numbers.some(Number.isNaN));
"#;
    let html = hard::Rippled::new().page().range("x", -1.0..=1.0).to_html().unwrap();
    let file = std::env::temp_dir().join(format!("page_{}_once.cjs", std::process::id()));
    let finders = ["rootOf", "rootWithinATurn"].map(|word| shortened(word).trim_end().to_string());
    let count = shortened(COUNT).replace("FINDERS", &finders.join("|"));
    std::fs::write(&file, format!("{}{count}", script(&html))).unwrap();
    let output = Command::new("node").arg(&file).output().expect("node runs");
    drop(std::fs::remove_file(&file));
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "true 1 NoSolution true");
}

/// A page without its script is not cut short by its texts: it has two scripts and ends.
#[test]
fn no_text_ends_a_script() {
    let html = hard::Function::new().page().title("</script><!--").to_html().unwrap();
    assert_eq!(html.matches("</script>").count(), 2, "as many as there are scripts");
    assert_eq!(html.matches("<script>").count(), 2 + inner(&html));
    assert!(!html.contains("<!--") && html.ends_with("</html>\n"));
    assert!(html.contains("&lt;/script&gt;&lt;!--"), "the title stands in the text");
}

/// `<script>` inside a string of a script opens nothing.
fn inner(html: &str) -> usize {
    script(html).matches("<script>").count()
}
