//! The compiler called from outside a macro, by its public interface alone.

use linkage_compiler::{Diagnostic, Options, compile};

const SHEAR: &str = "
pub struct Shear {
    input theta: angle;
    ground A(0, 0), D(665.7mm, 0);
    crank AB(A) -> B { length: 80mm, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
    point blade on BC at (500mm, -60mm);
}";

fn diagnostics(source: &str) -> Vec<Diagnostic> {
    let tokens = source.parse().expect("the declaration is made of tokens");
    compile(tokens, &Options::default()).diagnostics
}

/// Line and column (from 1) of the first token, line and column behind the last, and the message.
fn placed(mistake: &Diagnostic) -> (usize, usize, usize, usize, &str) {
    let (first, last) = (mistake.first.start(), mistake.last.end());
    (first.line, first.column + 1, last.line, last.column + 1, &mistake.message)
}

#[test]
fn a_right_declaration_becomes_a_solver() {
    let tokens = SHEAR.parse().expect("the declaration is made of tokens");
    let output = compile(tokens, &Options::default());
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    let is_rust = syn::parse2::<syn::File>(output.tokens.clone()).is_ok();
    assert!(is_rust && output.tokens.to_string().contains("pub struct Shear"));
}

#[test]
fn three_mistakes_have_lines_and_columns_in_the_order_of_the_source() {
    let source = SHEAR
        .replace("0), D(665.7mm", "0), D(665.7kg")
        .replace("rrr BC(B)", "rrr BC(BB)")
        .replace("on BC at", "upon BC at");
    let mistakes = diagnostics(&source);
    assert_eq!(
        mistakes.iter().map(placed).collect::<Vec<_>>(),
        [
            (4, 23, 4, 30, "a mass where a length belongs"),
            (6, 12, 6, 14, "no point named `BB`; a point with a similar name exists: `B`"),
            (7, 17, 7, 21, "expected `on` or `at`, found `upon`"),
        ]
    );
}

/// A mistake that reaches over several tokens has the place of both ends, and its second line is a
/// note.
#[test]
fn a_mistake_has_its_last_token_and_its_note() {
    let source = SHEAR.replace("(632mm, 374mm)", "(10mm, 2 * 10mm)");
    let [mistake] = &diagnostics(&source)[..] else { panic!("there is one mistake") };
    let (line, from, _, to, message) = placed(mistake);
    assert!(message.contains("cannot be assembled"), "{message}");
    assert_eq!((line, from, to), (6, 5, 8));
    assert!(mistake.note.as_deref().is_some_and(|note| note.starts_with("|BD| runs from")));
}

/// A link that could not be read may go through any pin of its words.
#[test]
fn a_link_that_is_not_read_brings_one_message() {
    for (links, message) in [
        ("links AB(A, B), BC(B, C), DC(D, C);", "no statement begins with `links`"),
        ("link AB(A, B) { length: 1m }, BC(B, C), DC(D, C);", "leave out this `,`"),
        ("link AB(A, B) BC(B, C), DC(D, C);", "expected `;`, found `BC`"),
    ] {
        let mistakes = diagnostics(&format!(
            "struct M {{ input t: angle; ground A(0, 0), D(4, 0); pin B(0, 1), C(3, 2); {links}
             drive AB.angle = t; }}"
        ));
        assert_eq!(mistakes.iter().map(|found| &found.message).collect::<Vec<_>>(), [message]);
    }
}

/// Each option adds code and takes none away.
#[test]
fn options_add_to_the_solver() {
    let length = |sketch: bool, page: bool, serde: bool| {
        let mut options = Options::default();
        (options.sketch, options.page, options.serde) = (sketch, page, serde);
        compile(SHEAR.parse().expect("tokens"), &options).tokens.to_string().len()
    };
    let plain = length(false, false, false);
    let drawn = length(true, false, false);
    assert!(plain < drawn && drawn < length(true, true, false));
    assert!(plain < length(false, false, true));
    assert_eq!(plain, length(false, true, false), "a page is made of what is drawn");
}

/// What the documentation of `compile`, `declarations` and `c` shows.
#[test]
fn examples_of_the_documentation_hold() {
    let source = "mod arm { mechanism! { struct Arm { input t: angle; } } }";
    let found = linkage_compiler::declarations(source.parse().expect("tokens"));
    assert_eq!(found.len(), 1);
    assert!(found[0].to_string().starts_with("struct Arm"));

    let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
    let files = linkage_compiler::c(source.parse().expect("tokens"), &["position"], None)
        .expect("no mistake");
    assert_eq!(files[1].name, "crank.c");
    assert!(files[1].text.contains("LinkageStatus crank_position("));
}
