//! The page of a mechanism whose joints rub.

use crate::pipeline::{Options, compile};

/// The generated code with its drawing, of a block on a slope with this statement.
fn code(statement: &str) -> String {
    let source = format!(
        "pub struct Block {{ input s: length; guide slope through (0, 0) along 20deg;
         slider block(slope) -> P {{ slide: s }} mass 5kg on block at (0, 0); {statement} }}"
    );
    let output = compile(source.parse().expect("these are tokens"), &Options::PAGE);
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    output.tokens.to_string()
}

/// Its script solves for friction, and has the drives between which friction holds the block.
#[test]
fn a_page_shows_forces_where_something_rubs() {
    let [free, rubbing] = ["", "friction 0.3 on block;"].map(code);
    assert!(free.contains("forces: (p, q") && free.contains("motion: (p, q"));
    assert!(!free.contains("amountsOf(c, [") && !free.contains("holding: (p, q"));
    assert!(rubbing.contains("forces: (p, q") && rubbing.contains("holding: (p, q"));
}

/// Amounts that depend on each other: each row has a share, a reaction and its changes, and the joints are named
/// in turn. A guide is a bit of the number between.
#[test]
fn a_script_lists_the_equations_of_friction() {
    let source = "pub struct Press { input theta: angle; ground A(0, 0); guide bed through A along 0deg;
         crank AB(A) -> B { length: 60mm, angle: theta } rrp BC(B), ram(bed) -> C { length: 240mm, mode: ahead }
         mass 6kg on ram at (0, 0); friction 0.1 at B radius 45mm; friction 0.2 on ram; output theta.drive; }";
    let output = compile(source.parse().expect("these are tokens"), &Options::PAGE);
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    let code = output.tokens.to_string();
    let (calls, of_both) = ("amountsOf(c, [", "]], 2, [\\\"BC.B\\\", \\\"ram\\\"], [");
    let asked = "forces, both ends of holding, and a motion by itself under either sign of friction at rest";
    assert_eq!(code.matches(calls).count(), 6, "{asked}");
    assert_eq!(code.matches(of_both).count(), 6);
}
