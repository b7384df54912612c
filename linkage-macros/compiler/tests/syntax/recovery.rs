//! Going on after a mistake: everything else is parsed, and reported where it is wrong too.

use super::aftermath::Aftermath;
use super::tokens::Parser;
use super::{body, parsed};
use crate::diagnostics::Diagnostics;

#[test]
fn every_mistake_of_a_declaration_is_reported() {
    let (tree, mistakes) = body(
        "input theta angle;
         ground A(0, 0;), D(1m 0);
         ground type(0, 0)
         crank AB(A) => B { length: 80 mm, angle theta, relative_to: ground }
         triad BC { at: (0, 0) }
         rrr BC(B), DC() -> C { lengths: (632mm, 0x10), mode: left }
         point blade on BC (1, 2)
         output blade DC.angle(), fold = 2 pi",
    );
    assert_eq!(
        mistakes,
        "angle#1: say what `theta` is: `input theta: angle;` or `input theta: length;` / its kind \
         tells radians from metres
;#2: expected `)` after two values, found `;` / write `(x, y)`
0#3: expected `,` and a second value, found `0` / write `(x, y)`
type: `type` is a Rust keyword; choose another name / names become fields and arguments of the \
         generated code
)#3: write `;` after `)`
=#1: write `->` / it points to the pin that is made
mm: drop the space: `80mm` / a unit stands directly behind its number
theta#2: write `:` after `angle`
triad: `triad` is reserved for a later statement
)#7: expected the name of a point or a guide, found `)` / points are declared by `ground` or made \
         by groups, guides by `guide`
0x10: write `0x10` in decimal / a number is decimal, with its unit directly behind it: `632mm`, \
         `1e-3m`
(#9: expected `at`, found `(` / a place is `at (x, y)`, `at polar (r, angle)` or `at distances \
         (r1, r2) left`
DC#2: write `,` in front of `DC`
angle#3: write `DC.angle` without parentheses / expressions have functions and members, but no \
         methods
pi: expected `;`, found `pi` / a product is written with `*`"
    );
    // Named things keep their places.
    assert_eq!(
        tree,
        "input theta: ?
ground A(?, ?), D(?, ?)
ground type_(0, 0)
crank AB(A) -> B { length: 80mm, angle: ?, relative_to: ground }
rrr BC(B), DC(?) -> C { lengths: (?, ?), mode: left }
point blade on BC at ?
output blade, fold = 2"
    );
}

#[test]
fn a_statement_in_error_ends_where_another_certainly_begins() {
    for next in [
        "input x: angle;",
        "param p = 1;",
        "let y = 2;",
        "ground A(0, 0);",
        "guide g through A along 0;",
        "point P at (0, 0);",
        "crank AB(A) { angle: 0 }",
        "output x;",
        "crate = a;",
        "/// let z = 3;",
    ] {
        let source = match next.strip_prefix("/// ") {
            Some(documented) => format!("let x = !\n/// z\n{documented}"),
            None => format!("let x = ! {next}"),
        };
        let (tree, mistakes) = body(&source);
        assert_eq!(mistakes, "!: expected a number or a name, found `!`", "{source}");
        let expected = format!("let x = ?\n{}", next.trim_end_matches(';'));
        assert_eq!(tree, expected, "{source}");
    }
}

#[test]
fn a_keyword_used_as_a_name_does_not_end_a_statement() {
    let (tree, mistakes) = body("guide rail through point P along 0; let x = 1;");
    assert_eq!(
        mistakes,
        "P: expected `along` or `towards`, found `P` / a guide is a point and a direction: \
         `through (x, y) along 0deg` or `through A towards D`"
    );
    assert_eq!(tree, "guide rail through ? ?\nlet x = 1");
}

#[test]
fn deep_nesting_is_refused_once() {
    for (open, close) in [("(", ")"), ("-", ""), ("sqrt(", ")"), ("-(", ")")] {
        let nested = format!("let x = {}1{};", open.repeat(120), close.repeat(120));
        let (_, mistakes) = body(&nested);
        assert!(
            mistakes.ends_with(
                "name a part of this expression with `let` / it is nested more than 100 deep"
            ) && !mistakes.contains('\n'),
            "{mistakes}"
        );
        let flat = format!("let x = {}1{};", open.repeat(40), close.repeat(40));
        assert_eq!(body(&flat).1, "");
    }
}

/// Words for the test below; the last have spaces of their own.
fn words() -> Vec<&'static str> {
    const WORDS: &str = "
        input param let ground guide point output numerics crate export crank rrr prr mass on at
        through along towards polar distances type r#a _ A B x left angle pi 1 2mm 0x1 's' 'c' 1e9
        , ; : :: = + - * / -> => . # ! ^ 'a (A) ( ) { } [ ]";
    WORDS.split_whitespace().chain(["/// d\n", "(0, 0)", "{ x: 1 }", "\"s\""]).collect()
}

/// The parser ends on any sequence of tokens, never panics, and says nothing only about a
/// declaration that can be read back: its text parses into the same text.
#[test]
fn any_tokens_are_parsed_or_reported() {
    // A 64-bit linear congruential generator (Knuth's MMIX constants); the high bits are good.
    let mut state = 1_u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below
    };
    let (words, mut silent) = (words(), 0);
    for _ in 0..20_000 {
        let length = 1 + draw(14);
        let drawn: Vec<&str> = (0..length).map(|_| words[draw(words.len())]).collect();
        let source = format!("struct M {{ {} }}", drawn.join(" "));
        if source.parse::<proc_macro2::TokenStream>().is_err() {
            continue;
        }
        let (tree, mistakes) = parsed(&source);
        let tree = tree.unwrap_or_else(|| panic!("no tree: {source}"));
        if mistakes.is_empty() && !tree.contains("///") {
            silent += 1;
            let again: String = tree
                .replacen("M\n", "struct M {", 1)
                .lines()
                .map(|line| if line.ends_with('}') { line.into() } else { format!("{line};") })
                .collect();
            let again = if tree == "M" { "struct M {".to_string() } else { again };
            assert_eq!(parsed(&format!("{again} }}")), (Some(tree), String::new()), "{source}");
        }
        proc_macro2::extra::invalidate_current_thread_spans();
    }
    assert!(silent > 10, "only {silent} declarations without a mistake");
}

#[test]
fn an_expression_is_left_where_it_ends() {
    let mut diagnostics = Diagnostics::new();
    let tokens = "a + b c".parse().expect("tokens");
    let mut aftermath = Aftermath::default();
    let mut parser = Parser::new(tokens, &mut diagnostics, &mut aftermath);
    assert!(parser.expression().is_ok());
    assert_eq!(parser.found(), "`c`");
    assert!(diagnostics.into_mistakes().is_empty());
}
