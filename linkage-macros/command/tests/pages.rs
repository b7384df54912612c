//! Parts of declarations in README and the page of statements, which stand there without the rest of their
//! mechanism: each compiles inside one. Whole declarations are examples of the documentation's own.

use std::fs;
use std::path::Path;

use linkage_compiler::{Diagnostic, Options, compile};

/// A page of the repository.
fn page(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    fs::read_to_string(path).expect("the page is there")
}

/// The blocks of a page that are marked as plain text.
fn blocks(page: &str) -> Vec<&str> {
    let blocks = page.split("```text\n").skip(1);
    blocks.map(|rest| rest.split("```").next().expect("a block ends")).collect()
}

fn diagnostics(statements: &str) -> Vec<Diagnostic> {
    let source = format!("pub struct Part {{ {statements} }}");
    compile(source.parse().expect("these are tokens"), &Options::default()).diagnostics
}

/// Statements in front of most blocks.
const FOUR_BAR: &str = "
    input theta: angle;
    ground A(0, 0), D(665.7mm, 0);
    crank AB(A) -> B { length: 80mm, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
";

/// A mechanism around a block.
struct Around {
    /// The block's beginning.
    begins: &'static str,
    before: [&'static str; 2],
    behind: &'static str,
}

const fn around(begins: &'static str, before: [&'static str; 2], behind: &'static str) -> Around {
    Around { begins, before, behind }
}

const GROUND: &str = "ground A(0, 0), D(665.7mm, 0);";

const AROUND: [Around; 6] = [
    around(
        "input theta: angle;\ninput s",
        [GROUND, ""],
        "crank AB(A) -> B { length: s + x + 1m, angle: theta }",
    ),
    around(
        "param l = 632mm;",
        ["input theta: angle;", GROUND],
        "crank AB(A) -> B { length: 80mm, angle: theta + tilt }
         rrr BC(B), DC(D) -> C { lengths: (l, 374mm), mode: elbow }",
    ),
    around("guide rail through", [FOUR_BAR, "point P on BC at (100mm, 0);"], ""),
    around(
        "point blade on BC",
        [FOUR_BAR, "input s, x: length; crank b(D) -> H { length: 80cm, angle: 2 * theta }"],
        "",
    ),
    around("crank AB(A) -> B", ["input theta: angle;", GROUND], ""),
    around(
        "output blade, DC",
        [
            FOUR_BAR,
            "guide bed through (0, -1m) along 0deg;
             rrp CE(C), ram(bed) -> E { length: 2m, mode: ahead }
             point blade on BC at (500mm, -60mm);",
        ],
        "",
    ),
];

const FIVE_BAR: &str = "ground A(-50mm, 0), E(50mm, 0);
    pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
    link AB(A, B), ED(E, D), BC(B, tool), CD(D, tool);";

/// The lines of the block that shows quantities as inputs, and a machine for each.
const QUANTITIES: [(&str, &str); 4] = [
    ("input a = AB.angle, b = ED.angle;", FIVE_BAR),
    ("input x = tool.x, y = tool.y;", FIVE_BAR),
    (
        "input lift = distance(F, G);",
        "ground A(1m, 0), F(0, 0); pin G(800mm, 700mm); link arm(A, G);",
    ),
    (
        "input opening = 2 * tip.y, knee = shank.angle + 90deg;",
        "ground H(0, 0); pin K(50mm, -400mm), tip(250mm, -430mm); link shank(H, K), foot(K, tip);",
    ),
];

#[test]
fn quantities_of_the_page_drive_a_machine() {
    let lines: Vec<&str> = QUANTITIES.iter().map(|(line, _)| *line).collect();
    let block = format!("```text\n{}\n```", lines.join("\n"));
    assert!(page("linkage-core/docs/statements.md").contains(&block), "{block}");
    for (line, machine) in QUANTITIES {
        let mistakes = diagnostics(&format!("{machine} {line}"));
        assert!(mistakes.is_empty(), "{line}: {mistakes:?}");
    }
}

#[test]
fn parts_of_declarations_compile() {
    let mut seen = 0;
    for path in ["README.md", "linkage-core/docs/statements.md"] {
        let page = page(path);
        for block in blocks(&page) {
            let is_formula = block.starts_with("B = K + yoke.slide");
            if is_formula
                || block.starts_with("error: ")
                || block.starts_with("cargo ")
                || block.starts_with("mechanism! {")
                || block.starts_with(QUANTITIES[0].0)
            {
                continue;
            }
            let around = AROUND.iter().find(|around| block.starts_with(around.begins));
            let around = around.unwrap_or_else(|| panic!("{path} has\n{block}"));
            let [first, second] = around.before;
            let mistakes = diagnostics(&format!("{first}{second}\n{block}\n{}", around.behind));
            assert!(mistakes.is_empty(), "{path}\n{block}{mistakes:?}");
            seen += 1;
        }
    }
    assert_eq!(seen, AROUND.len(), "each of these is a block of a page");
}

/// README shows a mistake: its line, and what is told of it.
#[test]
fn the_message_in_the_readme_is_told() {
    let page = page("README.md");
    let shown = blocks(&page).into_iter().find(|block| block.starts_with("error: "));
    let lines: Vec<&str> = shown.expect("there is one").lines().map(str::trim).collect();
    let (number, statement) = lines[4].split_once(" | ").expect("a line of the source");
    let mistakes = diagnostics(&format!(
        "input theta: angle; ground A(0, 0), D(300m, 0);
         crank AB(A) -> B {{ length: 100mm, angle: theta }} {statement}"
    ));
    let [mistake] = &mistakes[..] else { panic!("{mistakes:?}") };
    assert_eq!(lines[0], format!("error: {}", mistake.message));
    assert_eq!(Some(lines[1]), mistake.note.as_deref());
    assert!(lines[2].contains(&format!(":{number}:")));
    let marked: String = statement.trim().chars().take(lines[5].matches('^').count()).collect();
    assert_eq!(marked, "rrr");
    assert_eq!(mistake.first.source_text().as_deref(), Some("rrr"));
}
