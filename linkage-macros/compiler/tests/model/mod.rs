//! The rules on tiny declarations: what they resolve to, and every mistake with its token.

pub(crate) mod actions;
pub(crate) mod class_three;
pub(crate) mod constants;
pub(crate) mod dimension;
pub(crate) mod drawn;
pub(crate) mod drawn_numbers;
pub(crate) mod driving;
pub(crate) mod expressions;
pub(crate) mod fields;
pub(crate) mod folding;
pub(crate) mod formulas;
pub(crate) mod friction;
pub(crate) mod geared;
pub(crate) mod groups;
pub(crate) mod half_turns;
pub(crate) mod held_equations;
pub(crate) mod incidence;
pub(crate) mod kinds;
pub(crate) mod laws;
pub(crate) mod names;
pub(crate) mod numbers;
pub(crate) mod outputs;
pub(crate) mod places;
pub(crate) mod quantities;
pub(crate) mod ratios;
pub(crate) mod resolved;
pub(crate) mod rigid;
pub(crate) mod slips;
pub(crate) mod springs;
pub(crate) mod stops;
pub(crate) mod stub;
pub(crate) mod text;
pub(crate) mod together;
pub(crate) mod units;
pub(crate) mod unknowns;
pub(crate) mod wheels;

use self::mechanism::Mechanism;
use crate::diagnostics::{Diagnostics, told};
use crate::mistakes::proposals_are_read;
use crate::syntax::parse;
pub(crate) use linkage_compiler::model::*;

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
