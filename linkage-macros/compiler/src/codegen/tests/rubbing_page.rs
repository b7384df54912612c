//! The page of a mechanism whose joints rub.

use crate::pipeline::{Options, compile};

/// The generated code with its drawing, of a block on a slope with this statement.
fn code(statement: &str) -> String {
    let source = format!(
        "pub struct Block {{ input s: length; guide slope through (0, 0) along 20deg;
         slider block(slope) -> P {{ slide: s }} mass 5kg on block at (0, 0); {statement} }}"
    );
    let output = compile(source.parse().expect("these are tokens"), &Options::SKETCH);
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    output.tokens.to_string()
}

/// Its run-time does not solve the equations of friction: rather than without them, forces are not shown.
#[test]
fn a_page_shows_no_forces_where_something_rubs() {
    let [free, rubbing] = ["", "friction 0.3 on block;"].map(code);
    assert!(free.contains("forces: (p, q") && free.contains("motion: (p, q"));
    assert!(!rubbing.contains("forces: (p, q") && rubbing.contains("motion: (p, q"));
}
