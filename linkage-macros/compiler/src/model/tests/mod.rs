//! The rules on tiny declarations: what they resolve to, and every mistake with its token.

mod actions;
mod class_three;
mod constants;
mod drawn;
mod drawn_numbers;
mod driving;
mod expressions;
mod fields;
mod formulas;
mod friction;
mod geared;
mod groups;
mod half_turns;
mod held_equations;
mod incidence;
mod kinds;
mod laws;
mod names;
mod numbers;
mod outputs;
mod places;
mod quantities;
mod ratios;
mod resolved;
mod rigid;
mod slips;
mod springs;
mod stops;
mod text;
mod together;
mod unknowns;

use super::mechanism::Mechanism;
use super::resolve;
use crate::diagnostics::{Diagnostics, told};
use crate::mistakes::proposals_are_read;
use crate::syntax::parse;

// Statements that a row may build on.
const NOTHING: &str = "";
const INPUT: &str = "input t: angle;";
const CRANK: &str = "input t: angle; ground A(0, 0), D(4m, 0); \
                     crank AB(A) -> B { length: 1m, angle: t }";
const GUIDE: &str = "input t: angle; ground A(0, 0), D(4m, 0); \
                     guide rail through D along 0deg; \
                     crank AB(A) -> B { length: 1m, angle: t }";
const SIX_BAR: &str = "input t: angle; ground A(0, 0), D(4m, 0); \
                       guide rail through D along 0deg; \
                       crank AB(A) -> B { length: 1m, angle: t } \
                       rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: left } \
                       rrp CE(C), block(rail) -> E { length: 5m, mode: ahead }";

/// The mechanism with these statements, and its mistakes as `told` writes them.
fn resolved(statements: &str) -> (Option<Mechanism>, String) {
    resolved_on(statements, NOTHING)
}

/// The same where statements build on others. The row is the statements, or the others where there
/// are none.
fn resolved_on(base: &str, statements: &str) -> (Option<Mechanism>, String) {
    let mut diagnostics = Diagnostics::new();
    let source = format!("pub struct M {{ {base} {statements} }}");
    let end = source.len() - " }".len();
    let tokens = source.parse().expect("the source is made of Rust's tokens");
    let tree = parse(tokens, &mut diagnostics).expect("the declaration has a name");
    assert_eq!(diagnostics.count(), 0, "the parser has nothing against `{statements}`");
    let mechanism = resolve(&tree, &mut diagnostics).ok();
    let row = match statements {
        NOTHING => source.len() - base.len() - "  }".len()..end,
        _ => end - statements.len()..end,
    };
    (mechanism, told(&diagnostics.into_mistakes(), &source, row))
}

/// Compares the mistakes of each row: what its statements build on, the statements, and the
/// mistakes, none where the row is legal.
fn check(rows: &[(&str, &str, &str)]) {
    let mut other = String::new();
    for (base, statements, expected) in rows {
        let (mechanism, found) = resolved_on(base, statements);
        proposals_are_read(&found);
        if found != *expected {
            other += &format!("{statements}\nexpected:\n{expected}\nfound:\n{found}\n\n");
            continue;
        }
        assert_eq!(mechanism.is_some(), expected.is_empty(), "{statements}");
    }
    assert!(other.is_empty(), "{other}");
}
